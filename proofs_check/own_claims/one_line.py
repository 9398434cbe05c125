"""Claims in one line: a comparison of counts of an arrangement, in a small language of its own.

``p_vector.get(3, 0) >= m`` is read by `language` and computed by this module, node by node: a text
has names and functions of `quantities`, integers, arithmetic (``^`` and ``**`` are powers, ``//``
rounds down), comparisons, ``in``, ``and``, ``or``, ``not`` and ``implies``, indices,
``.get(key, default)`` and the functions of `_FUNCTIONS`, and nothing else. Vectors are compared
entry by entry. It is never run as a program.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

from arrangement.errors import InputError
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError
from proofs_check.instances.domains import is_domain, known_families
from proofs_check.instances.families import Family, is_family, read_family
from proofs_check.reports.formula import check_formula
from proofs_check.statements.statement import Claim, Kind, Source

from .false_comparison import FalseComparison, compare_values
from .language import BITS, read_statement
from .quantities import FUNCTIONS, QUANTITIES, Planes
from .user_claim import DEFAULT_DOMAIN, claim

_COMPUTED = (int, Fraction)
_OF_ARRANGEMENT = {text.partition("(")[0]: function for text, function in FUNCTIONS.items()}
_ARITHMETIC: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: lambda a, b: Fraction(a) / b,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: lambda a, b: _power(a, b),
}
_FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "abs": abs,
    "binomial": lambda n, k: _combinations(n, k),
    "comb": lambda n, k: _combinations(n, k),
    "factorial": lambda n: _factorial(n),
    "len": len,
    "max": max,
    "min": min,
    "sum": sum,
}


def one_line_claim(
    text: str,
    *,
    of: str = DEFAULT_DOMAIN,
    when: str | None = None,
    nonzero: dict[str, bool] | None = None,
) -> Claim:
    """Make a claim of a comparison such as ``p_vector.get(3, 0) >= m``.

    Args:
        text: the statement (see the head of this module).
        of: a domain of planes or pseudolines, or a family such as ``catalan(n=2..8)``, whose
            integer parameters are names in the text.
        when: a hypothesis in the same language.
        nonzero: gets of each quantity of the statement whether it is not 0 for some arrangement
            that is tried, and as "affine" whether one is not central.

    Raises:
        OwnClaimError: what a text has is not in the language, or the domain has no planes.
    """
    if of in ("grasp", "question", "dual"):
        raise OwnClaimError(
            f"of is {of}; a claim in one line is about planes: name a domain of planes, or write "
            "a file of claims (proofs-check new)"
        )
    chosen = members(of)
    names = chosen.integers if chosen else ()
    statement = read_statement(text, names)
    hypothesis = read_statement(when, names) if when else None

    def holds(planes: Planes, **parameters: int) -> Any:
        if nonzero is not None:
            nonzero["affine"] = nonzero.get("affine", False) or not planes.is_central
        verdict = _Computed(planes, parameters, nonzero).verdict(statement)
        return FalseComparison("the statement is false") if verdict is False else verdict

    def applies(planes: Planes, **parameters: int) -> bool:
        return hypothesis is None or bool(_Computed(planes, parameters).value(hypothesis))

    make = claim(
        text,
        of=chosen or of,
        formula=formula_of(statement),
        id="try",
        locator="one line",
        when=applies,
        hypotheses=[when] if when else [],
    )
    made = make(holds)
    computed_here = replace(made.routes[0], name="evaluation of the statement")
    made = replace(made, quantity="whether the statement is true", routes=(computed_here,))
    domain = made.domain
    if domain is None or not domain.has_named_instances:
        return made
    if "points_off" in f"{text} {when}":  # it has no value modulo most primes
        return made
    cases = partial(known_families, domain, irrational=True)
    named = Source(Kind.SAMPLED, "named families over Q(sqrt 5)", lambda _: cases())
    return replace(made, sources=(*made.sources, named))


def members(of: str) -> Family | None:
    """Return the family that a text names; None if it is a domain."""
    return read_family(of) if is_family(of) and not is_domain(of) else None


def value_of(node: ast.expr, planes: Planes, parameters: Mapping[str, Any]) -> Any:
    """Return the value of a text on one arrangement.

    Raises:
        OwnClaimError: it has none.
    """
    return _Computed(planes, parameters).value(node)


class _Computed:
    """The values of the parts of a text, on one arrangement."""

    def __init__(
        self,
        planes: Planes,
        parameters: Mapping[str, Any],
        nonzero: dict[str, bool] | None = None,
    ) -> None:
        self.planes, self.parameters = planes, parameters
        self.nonzero = {} if nonzero is None else nonzero

    def verdict(self, node: ast.expr) -> Any:
        """Return True, or what is false: a comparison with its values."""
        if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.And):
            verdict = True
            for part in node.values:
                verdict = self.verdict(part)
                if verdict is not True:
                    return verdict
            return verdict
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            sides = self.value(node.left), self.value(node.comparators[0])
            return _compare(ast.unparse(node), node.ops[0], *map(_plain, sides))
        match node:
            case ast.Call(func=ast.Name(id="implies"), args=[hypothesis, conclusion]):
                return not self.value(hypothesis) or self.verdict(conclusion)
        return self.value(node)

    def value(self, node: ast.expr) -> Any:
        """Return the value of a part that `language` has read."""
        try:
            value = self._value(node)
        except OwnClaimError:
            raise
        except LookupError as error:
            remedy = "write .get(key, 0) where some have none"
            raise OwnClaimError(f"{ast.unparse(node)} has no value; {remedy}") from error
        except ZeroDivisionError as error:
            raise OwnClaimError(f"{ast.unparse(node)} divides by 0") from error
        except (ArithmeticError, AttributeError, TypeError, ValueError) as error:
            raise OwnClaimError(f"{ast.unparse(node)} has no value: {error}") from error
        if (
            isinstance(value, _COMPUTED)
            and max(map(int.bit_length, value.as_integer_ratio())) > BITS
        ):
            raise OwnClaimError(f"{ast.unparse(node)} has more than {BITS} bits")
        return value

    def _value(self, node: ast.expr) -> Any:
        match node:
            case ast.Name(id=name):
                if name in self.parameters:
                    return self.parameters[name]
                value = QUANTITIES[name](self.planes)
                self.nonzero[name] = self.nonzero.get(name, False) or bool(value)
                return value
            case ast.Constant(value=value):
                return value
            case ast.BinOp(left=left, op=op, right=right):
                return _ARITHMETIC[type(op)](*map(_number, map(self.value, (left, right))))
            case ast.UnaryOp(op=op, operand=inner):
                value = self.value(inner)
                return not value if isinstance(op, ast.Not) else -_number(value)
            case ast.BoolOp(op=op, values=parts):
                several = all if isinstance(op, ast.And) else any
                return several(bool(self.value(part)) for part in parts)
            case ast.Compare(left=left, ops=ops, comparators=others):
                values = [_plain(self.value(part)) for part in (left, *others)]
                return all(
                    bool(_compare("", op, a, b))
                    for op, a, b in zip(ops, values, values[1:], strict=False)
                )
            case ast.Subscript(value=inner, slice=index):
                return self.value(inner)[self.value(index)]
            case ast.Call(func=ast.Name(id="implies"), args=[hypothesis, conclusion]):
                return not self.value(hypothesis) or self.value(conclusion)
            case ast.Call(func=function, args=given):
                return self._call(function, list(map(self.value, given)))
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                return tuple(map(self.value, parts))
        raise AssertionError(ast.dump(node))

    def _call(self, function: ast.expr, arguments: list[Any]) -> Any:
        if isinstance(function, ast.Attribute):
            return getattr(self.value(function.value), function.attr)(*arguments)
        assert isinstance(function, ast.Name)
        if function.id in _FUNCTIONS:
            return _FUNCTIONS[function.id](*arguments)
        return _OF_ARRANGEMENT[function.id](self.planes, *map(_number, arguments))


def _number(value: Any) -> int | Fraction:
    """Return a number that arithmetic may take."""
    if not isinstance(value, _COMPUTED):
        raise TypeError(f"{shown(value)} is not a number")
    return value


def _power(base: int | Fraction, exponent: int | Fraction) -> int | Fraction:
    if not isinstance(exponent, int) or abs(exponent) > BITS:
        raise ValueError(f"the exponent {shown(exponent)} is not an integer up to {BITS}")
    if max(map(int.bit_length, base.as_integer_ratio())) * abs(exponent) > BITS:
        raise ValueError(f"the power has more than {BITS} bits")
    return Fraction(base) ** exponent if exponent < 0 else base**exponent


def _combinations(n: Any, k: Any) -> int:
    if not all(isinstance(x, int) and 0 <= x <= BITS for x in (n, k)):
        raise ValueError(f"comb takes integers from 0 to {BITS}")
    return math.comb(n, k)


def _factorial(n: Any) -> int:
    if not isinstance(n, int) or not 0 <= n <= BITS:
        raise ValueError(f"factorial takes an integer from 0 to {BITS}")
    return math.factorial(n)


def _compare(text: str, op: ast.cmpop, left: Any, right: Any) -> Any:
    """Compare two values, the order of vectors entry by entry; see `compare_values`."""
    kind = type(op).__name__
    if not isinstance(left, tuple) or isinstance(op, (ast.Eq, ast.NotEq)):
        return compare_values(text, kind, left, right)
    if len(left) != len(right):
        raise OwnClaimError(
            f"{text or 'a comparison'} is of the vectors {shown(left)} and {shown(right)}, with "
            f"{len(left)} and {len(right)} entries; expected equal numbers"
        )
    entries = (compare_values("", kind, a, b) for a, b in zip(left, right, strict=True))
    return all(entries) or FalseComparison(f"{text} is false: {shown(left)} and {shown(right)}")


def _plain(value: Any) -> Any:
    """Return a value as comparisons take it: views and mappings as what they hold."""
    if isinstance(value, Mapping):
        return dict(value)
    return tuple(value) if isinstance(value, (list, type({}.values()), type({}.keys()))) else value


_LETTERS = {"f_vector": "f", "p_vector": "p", "t_vector": "t"}
_SIGNS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Eq: "=",
    ast.NotEq: r"\ne",
    ast.Lt: r"\lt",
    ast.LtE: r"\le",
    ast.Gt: r"\gt",
    ast.GtE: r"\ge",
}
_WORDS: dict[type[ast.AST], str] = {
    ast.And: r"\; \text{and} \;",
    ast.Or: r"\; \text{or} \;",
    ast.Mod: r"\; \text{mod} \;",
}
#: How strongly parts hold together; what holds less stands in brackets.
_IMPLIES, _OR, _AND, _NOT, _COMPARED, _SUM, _PRODUCT, _POWER, _WHOLE = range(9)


def formula_of(node: ast.expr) -> str:
    r"""Return a claim in one line in the part of TeX that reports read; "" if it has no form there.

    >>> import ast
    >>> print(formula_of(ast.parse("p_vector.get(3, 0) >= comb(m, 2)", mode="eval").body))
    p_{3} \ge \binom{m}{2}
    """
    try:
        formula = _formula(node)[0]
        check_formula(formula)
    except (InputError, LookupError, RecursionError):
        return ""
    return formula


def _formula(node: ast.expr) -> tuple[str, int]:
    """Return a part and how strongly it holds together."""
    match node:
        case ast.Name(id=name):
            return (name if len(name) == 1 else rf"\text{{{name.replace('_', ' ')}}}"), _WHOLE
        case ast.Constant(value=value):
            return str(value), _WHOLE
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            return rf"\neg {_bound(inner, _WHOLE)}", _NOT
        case ast.UnaryOp(operand=inner):
            return f"-{_bound(inner, _PRODUCT)}", _SUM
        case ast.BoolOp(op=op, values=parts):
            strength = _AND if isinstance(op, ast.And) else _OR
            return _WORDS[type(op)].join(_bound(part, strength + 1) for part in parts), strength
        case ast.Compare(left=left, ops=ops, comparators=others):
            text = _bound(left, _SUM)
            for sign, other in zip(ops, others, strict=True):
                text += f" {_SIGNS[type(sign)]} {_bound(other, _SUM)}"
            return text, _COMPARED
        case ast.BinOp():
            return _operation(node)
        case ast.Subscript(value=ast.Name(id=name), slice=index):
            return f"{_LETTERS[name]}_{{{_formula(index)[0]}}}", _WHOLE
        case ast.Call(
            func=ast.Attribute(value=ast.Name(id=name), attr="get"),
            args=[index, ast.Constant(value=0)],
        ):
            return f"{_LETTERS[name]}_{{{_formula(index)[0]}}}", _WHOLE
        case ast.Call(func=ast.Name(id=name), args=given):
            return _call(name, given), _IMPLIES if name == "implies" else _WHOLE
    raise LookupError(ast.unparse(node))


def _bound(node: ast.expr, strength: int) -> str:
    text, own = _formula(node)
    return text if own >= strength else f"({text})"


def _operation(node: ast.BinOp) -> tuple[str, int]:
    left, op, right = node.left, node.op, node.right
    match op:
        case ast.Add() | ast.Sub():
            sign = _SIGNS[type(op)]
            return f"{_bound(left, _SUM)} {sign} {_bound(right, _PRODUCT)}", _SUM
        case ast.Mult():
            return rf"{_bound(left, _PRODUCT)} \cdot {_bound(right, _POWER)}", _PRODUCT
        case ast.Mod():
            return _bound(left, _POWER) + _WORDS[ast.Mod] + _bound(right, _POWER), _PRODUCT
        case ast.Div():
            return rf"\frac{{{_formula(left)[0]}}}{{{_formula(right)[0]}}}", _POWER
        case ast.Pow():
            return f"{_bound(left, _WHOLE)}^{{{_formula(right)[0]}}}", _POWER
        case ast.FloorDiv():
            inside = rf"\frac{{{_formula(left)[0]}}}{{{_formula(right)[0]}}}"
            return rf"\lfloor {inside} \rfloor", _WHOLE
    raise LookupError(ast.unparse(node))


def _call(name: str, arguments: Sequence[ast.expr]) -> str:
    if name == "implies":
        return r" \Rightarrow ".join(_bound(part, _OR) for part in arguments)
    inside = [_formula(part)[0] for part in arguments]
    match name, inside:
        case "chi", [point]:
            return rf"\chi({point})"
        case "tutte", [x, y]:
            return f"T({x}, {y})"
        case "comb" | "binomial", [upper, lower]:
            return rf"\binom{{{upper}}}{{{lower}}}"
        case "factorial", [value]:
            return f"({value})!"
        case "abs", [value]:
            return f"|{value}|"
        case "max" | "min", [_, _, *_]:
            return rf"\{name}({', '.join(inside)})"
    raise LookupError(name)
