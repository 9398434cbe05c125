"""Claims in one line as formulas, for reports."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from arrangement.errors import InputError
from proofs_check.reports.formula import check_formula

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
        found = _formula(node)[0]
        check_formula(found)
    except (InputError, LookupError, RecursionError):
        return ""
    return found


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
            found = _bound(left, _SUM)
            for sign, other in zip(ops, others, strict=True):
                found += f" {_SIGNS[type(sign)]} {_bound(other, _SUM)}"
            return found, _COMPARED
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
            return _called(name, given), _IMPLIES if name == "implies" else _WHOLE
    raise LookupError(ast.unparse(node))


def _bound(node: ast.expr, strength: int) -> str:
    found, own = _formula(node)
    return found if own >= strength else f"({found})"


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


def _called(name: str, given: Sequence[ast.expr]) -> str:
    if name == "implies":
        return r" \Rightarrow ".join(_bound(part, _OR) for part in given)
    inside = [_formula(part)[0] for part in given]
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
