"""The language of claims in one line: what a text may have, and the type of each of its parts.

A text is read by Python's parser, and every part has a type: a truth value, a number, a vector or
a mapping. What has no one meaning is refused before anything is computed: a number beside ``or``,
an order of mappings, a name that is not known.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Mapping, Sequence
from difflib import get_close_matches
from itertools import accumulate
from typing import Final, NamedTuple

from arrangement.errors import refusal
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError

from .quantities import FUNCTIONS, MAPPINGS, QUANTITIES, TRUTH_VALUES, VECTORS

BITS: Final = 4096  # of a number on the way
_MAX_CHARACTERS = 500
#: Every part of a text takes some calls of Python, which allows about a thousand.
_MAX_DEPTH = 250
_TRUTH, _NUMBER, _VECTOR, _MAPPING = "a truth value", "a number", "a vector", "a mapping"
_OF_ARRANGEMENT: Mapping[str, tuple[str, ...]] = {
    text.partition("(")[0]: (_NUMBER,) * (1 + text.count(",")) for text in FUNCTIONS
}
#: Function -> the types of its arguments; `max` and `min` take several numbers too.
_FUNCTIONS: Mapping[str, tuple[str, ...]] = {
    "abs": (_NUMBER,),
    "binomial": (_NUMBER, _NUMBER),
    "comb": (_NUMBER, _NUMBER),
    "factorial": (_NUMBER,),
    "implies": (_TRUTH, _TRUTH),
    "len": (_VECTOR,),
    "max": (_VECTOR,),
    "min": (_VECTOR,),
    "sum": (_VECTOR,),
}
_ARGUMENTS = {**_FUNCTIONS, **_OF_ARRANGEMENT}
_OPERATIONS = (ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Mod, ast.Pow)
_EQUALITY = (ast.Eq, ast.NotEq)
_ORDER = (ast.Lt, ast.LtE, ast.Gt, ast.GtE)
_MEMBERSHIP = (ast.In, ast.NotIn)
#: Words of the field and of other languages, each with what to write here.
_SYNONYMS: Mapping[str, str] = {
    "binom": "binomial(n, k)",
    "choose": "binomial(n, k)",
    "nCr": "binomial(n, k)",
    "C": "binomial(n, k)",
    "fact": "factorial(k)",
    "chambers": "regions",
    "r": "regions",
    "b": "bounded_regions",
    "bounded": "bounded_regions",
    "unbounded_regions": "(regions - bounded_regions)",
    "unbounded": "(regions - bounded_regions)",
    **{f"f{k}": f"f_vector[{k}]" for k in range(5)},
    "faces": "F, or f_vector[k] for those of dimension k",
    "edges": "E",
    "vertices": "V",
    "points": "V",
    **dict.fromkeys(
        ("d", "dim", "dimension"),
        "rank, or the number: 2 with --of lines, 3 with --of 'affine(d=3)'",
    ),
    "lines": "m",
    "planes": "m",
    "hyperplanes": "m",
    "circles": "m",
    "triangles": "p_vector.get(3, 0)",
    "generic": "simple",
    "whitney": "polynomial",
    "product": "*",
    "even": "regions % 2 == 0",
    "odd": "regions % 2 == 1",
}
#: What the letters among the quantities are.
_LETTERS = {"m": "planes", "n": "planes", "V": "vertices", "E": "edges", "F": "faces"}
_TOKEN = re.compile(r"\w+|\s+|[<>=!]=|.", re.DOTALL)
#: Signs of mathematics, as Python has them.
_SIGNS = {"^": "**", "=": "==", "≤": "<=", "≥": ">=", "≠": "!="}
#: Of texts that cannot be read, what they may have, each with what to write.
_REMEDIES = {
    r"\b(?:number|count|regions|vertices|edges|faces|lines|planes) of\b": (
        "words for a quantity",
        "regions, V, E, F or m",
    ),
    r"\b(?:if|then|for|forall|when|whenever|where|with|unless|given|assuming)\b|=>|\u21d2": (
        "a condition",
        "m >= 4 implies regions <= m**2, or regions <= m**2 with --when 'm >= 4'",
    ),
    r"[\u00b9\u00b2\u00b3\u2070-\u209f]": ("a raised or lowered number", "m**2"),
    r"[\w)]\s*!(?!=)": ("a factorial", "factorial(m)"),
    r"\d\s*(?!implies|and|or|in|not)[A-Za-z(]|\)\s*\(": ("a product without its sign", "2*m"),
}
#: Comparisons in words.
_COMPARISONS = {
    r"(?:at least|no (?:fewer|less) than)": ">=",
    r"(?:at most|no more than)": "<=",
    r"(?:more|greater|larger) than|exceeds?": ">",
    r"(?:less|fewer|smaller) than": "<",
    r"equals?(?: to)?|exactly|is|are": "==",
}
_BEFORE_OPERANDS = {"and", "or", "not", "in", "implies", "if", "else"}


def read(text: str, names: Collection[str] = ()) -> ast.expr:
    """Return the syntax tree of a text, every part of which has a type.

    Args:
        text: see the head of `one_line`.
        names: of integers that it may have besides.

    Raises:
        OwnClaimError: it has something that is not in the language, or parts that do not fit.
    """
    return _read(text, names)[0]


def read_statement(text: str, names: Collection[str] = ()) -> ast.expr:
    """Return the syntax tree of a text that is true or false.

    Raises:
        OwnClaimError: as `read`, or it is neither.
    """
    tree, types = _read(text, names)
    if types.of(tree) != _TRUTH:
        raise OwnClaimError(
            f"{types.text(tree)} is {types.of(tree)}; expected a comparison, such as m >= 3"
        )
    return tree


def _read(text: str, names: Collection[str]) -> tuple[ast.expr, _PartTypes]:
    if len(text) > _MAX_CHARACTERS:
        raise OwnClaimError(
            f"the claim has {len(text)} characters; at most {_MAX_CHARACTERS} are read"
        )
    pieces = _as_python(text.strip())
    try:
        tree = ast.parse("".join(piece.python for piece in pieces), mode="eval").body
        depth = _depth(tree)
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        if use := _in_symbols(text):
            raise OwnClaimError(f"{shown(text)} has words for symbols; write {use!r}") from None
        uses = (
            f"has {what[0]}, {match[0]!r}, which is not read; write such as {what[1]}"
            for pattern, what in _REMEDIES.items()
            if (match := re.search(pattern, text))
        )
        default = "cannot be read; write a comparison such as regions <= m**2"
        raise OwnClaimError(f"{shown(text)} {next(uses, default)}") from None
    if depth > _MAX_DEPTH:
        raise OwnClaimError(
            f"the claim has {depth} operations inside each other; expected at most {_MAX_DEPTH}. "
            "Write it with fewer"
        )
    types = _PartTypes(text.strip(), pieces, names)
    words = [node.id for node in ast.walk(tree) if isinstance(node, ast.Name)]
    unknown = [word for word in dict.fromkeys(words) if word in _SYNONYMS and word not in names]
    if unknown[1:]:
        answers = (str(types._unknown_name(word, "a quantity")) for word in unknown)
        raise OwnClaimError("; ".join(answers))
    types.of(tree)
    return tree, types


def _in_symbols(text: str) -> str:
    """Return a claim in words as a comparison of a quantity with a bound, if it can be seen.

    >>> _in_symbols("every simple arrangement has at least m triangles")
    'simple implies p_vector.get(3, 0) >= m'
    """
    known = {**{word: word for word in QUANTITIES}, **_SYNONYMS}
    pattern = next((x for x in _COMPARISONS if re.search(rf"\b(?:{x})\b", text)), "")
    if not pattern:
        return ""
    before, after = re.split(rf"\b(?:(?:is|are) )?(?:{pattern})\b", text.rstrip(". "), maxsplit=1)
    left = [known[word] for word in re.findall(r"\w+", before) if word in known]
    *bound, noun = after.split() or [""]
    quantities = [word for word in left if word not in TRUTH_VALUES]
    hypotheses = [word for word in left if word in TRUTH_VALUES]
    if bound and noun in known and not quantities:
        quantities, after = [known[noun]], " ".join(bound)
    if not quantities:
        return ""
    use = f"{quantities[-1]} {_COMPARISONS[pattern]} {after.strip()}"
    use = " implies ".join([*hypotheses, use])
    try:
        ast.parse("".join(piece.python for piece in _as_python(use)), mode="eval")
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        return ""
    return use


def _depth(tree: ast.expr) -> int:
    """Return how many operations stand inside each other at most."""
    depth, layer = 0, [tree]
    while layer:
        depth += 1
        inner = (child for node in layer for child in ast.iter_child_nodes(node))
        layer = [child for child in inner if isinstance(child, ast.expr)]
    return depth


class _TypedPiece(NamedTuple):
    """A piece of text for Python, and where what it stands for is in the text as it was typed."""

    python: str
    start: int = 0
    stop: int = 0  # equal to the start where nothing was typed


def _as_python(text: str) -> list[_TypedPiece]:
    """Return a text with powers, equality and implications as Python reads them, in pieces.

    >>> text = "(simple implies regions = m^2 - m + 2) and m > 2"
    >>> "".join(piece.python for piece in _as_python(text))
    '(implies(simple , regions == m**2 - m + 2)) and m > 2'
    """
    # Each open bracket with its arguments, and each of them with the sides of its implications.
    groups: list[tuple[list[_TypedPiece], list[list[list[_TypedPiece]]]]] = [([], [[[]]])]
    previous = ""
    for match in _TOKEN.finditer(text):
        token, arguments = match[0], groups[-1][1]
        piece = _TypedPiece(_SIGNS.get(token, token), *match.span())
        if token in "([{":
            groups.append(([piece], [[[]]]))
        elif token in ")]}" and len(groups) > 1:
            opening, inner = groups.pop()
            groups[-1][1][-1][-1] += [*opening, *_join(inner), piece]
        elif token == ",":
            arguments.append([[]])
        elif token == "implies" and (previous.isalnum() or previous in (*")]", "_")):
            arguments[-1].append([])
        else:
            arguments[-1][-1].append(piece)
        if not token.isspace():
            previous = "" if token in _BEFORE_OPERANDS else token.replace("_", "")[-1:] or "_"
    return [_TypedPiece(text, 0, len(text))] if len(groups) > 1 else _join(groups[0][1])


def _join(arguments: Sequence[Sequence[list[_TypedPiece]]]) -> list[_TypedPiece]:
    """Return arguments in one; ``a implies b implies c`` is ``a implies (b implies c)``."""
    joined: list[_TypedPiece] = []
    for *hypotheses, conclusion in arguments:
        made = conclusion
        for hypothesis in reversed(hypotheses):
            made = [_TypedPiece("implies("), *hypothesis, _TypedPiece(","), *made, _TypedPiece(")")]
        joined += [_TypedPiece(","), *made] if joined else made
    return joined


class _PartTypes:
    """The types of the parts of a text; what has none is refused, with its part of the text."""

    def __init__(self, typed: str, pieces: Sequence[_TypedPiece], names: Collection[str]) -> None:
        self.typed, self.pieces, self.names = typed, pieces, names
        self._known: dict[ast.expr, str] = {}

    def text(self, node: ast.expr) -> str:
        """Return a part as it was typed, shortened."""
        lines = "".join(piece.python for piece in self.pieces).encode().splitlines(keepends=True)
        lengths = [0, *accumulate(map(len, lines))]
        first = lengths[node.lineno - 1] + node.col_offset
        last = lengths[(node.end_lineno or 1) - 1] + (node.end_col_offset or 0)
        ends = accumulate(len(piece.python.encode()) for piece in self.pieces)
        inside = [
            piece
            for piece, end in zip(self.pieces, ends, strict=True)
            if first < end <= last and piece.start < piece.stop
        ]
        part = self.typed[inside[0].start : inside[-1].stop] if inside else self.typed
        return shown(part.strip())

    def of(self, node: ast.expr) -> str:
        """Return the type of a part."""
        if node not in self._known:
            self._known[node] = self._of(node)
        return self._known[node]

    def _of(self, node: ast.expr) -> str:
        match node:
            case ast.Name(id=name):
                return self._of_name(name)
            case ast.Constant(value=int(number)) if (
                not isinstance(number, bool) and abs(number).bit_length() <= BITS
            ):
                return _NUMBER
            case ast.BinOp(left=left, op=op, right=right) if isinstance(op, _OPERATIONS):
                return self._all([left, right], _NUMBER, node)
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return self._all([inner], _NUMBER, node)
            case ast.UnaryOp(op=ast.Not(), operand=inner):
                self._logic([inner], node)
                return _TRUTH
            case ast.BoolOp(values=parts):
                self._logic(parts, node)
                return _TRUTH
            case ast.Compare():
                self._compare(node)
                return _TRUTH
            case ast.Tuple(elts=parts) | ast.List(elts=parts):
                self._all(parts, _NUMBER, node)
                return _VECTOR
            case ast.Subscript(value=value, slice=index) if not isinstance(index, ast.Slice):
                self._all([index], _NUMBER, node)
                if self.of(value) not in (_VECTOR, _MAPPING):
                    raise OwnClaimError(
                        f"{self.text(value)} is {self.of(value)}; it has no [index]"
                    )
                return _NUMBER
            case ast.Call(keywords=[]):
                return self._of_call(node)
        raise OwnClaimError(
            f"{self.text(node)} is not in the language of claims in one line; it has "
            f"{', '.join([*QUANTITIES, *FUNCTIONS])}, integers, + - * / // % ** ^, comparisons, "
            f"in, and, or, not, implies, [index], .get(key, default), {', '.join(_FUNCTIONS)}"
        )

    def _of_name(self, name: str) -> str:
        if name in self.names:
            return _NUMBER
        if name not in QUANTITIES:
            raise self._unknown_name(name, "a quantity")
        if name in TRUTH_VALUES:
            return _TRUTH
        return _VECTOR if name in VECTORS else _MAPPING if name in MAPPINGS else _NUMBER

    def _unknown_name(self, name: str, what: str) -> OwnClaimError:
        mistake = f"{shown(name)} is not {what}"
        plain = re.sub("^(?:n|nb|num|number_of|count)_|_count$", "", name)
        if name in _SYNONYMS or (plain != name and plain in QUANTITIES):
            return OwnClaimError(f"{mistake}; write {_SYNONYMS.get(name, plain)}")
        listed = [*QUANTITIES, *FUNCTIONS, *_FUNCTIONS, *sorted({*self.names} - {*QUANTITIES})]
        words = {word.partition("(")[0].lower(): word for word in [*_SYNONYMS, *listed]}
        near = [words[word] for word in get_close_matches(name.lower(), words, 1)]
        if near and near[0] in _SYNONYMS:
            return OwnClaimError(f"{mistake}; did you mean {near[0]}? Write {_SYNONYMS[near[0]]}")
        refused = str(refusal(mistake, words.get(name.lower(), name.lower()), listed))
        head, expected, known = refused.partition("expected one of ")
        for letter in _LETTERS.keys() - {*self.names}:
            known = re.sub(rf"\b{letter}(?=,)", f"{letter} ({_LETTERS[letter]})", known)
        return OwnClaimError(head + expected + known)

    def _of_call(self, node: ast.Call) -> str:
        match node:
            case ast.Call(func=ast.Attribute(value=value, attr="get"), args=[_, _] as given):
                self._mapping(value, node)
                return self._all(given, _NUMBER, node)
            case ast.Call(func=ast.Attribute(value=value, attr="values" | "keys"), args=[]):
                self._mapping(value, node)
                return _VECTOR
            case ast.Call(func=ast.Name(id=name), args=[_, *_] as given):
                if name in (*QUANTITIES, *self.names):
                    kind = self.of(node.func)
                    use = f"{name}*(...) or {name} alone" if kind == _NUMBER else f"{name}[index]"
                    raise OwnClaimError(f"{self.text(node)} calls {name}, {kind}; write {use}")
                if name not in _ARGUMENTS:
                    raise self._unknown_name(name, "a function")
                self._arguments(name, given, node)
                return _TRUTH if name == "implies" else _NUMBER
        function = self.text(node.func)
        raise OwnClaimError(
            f"{function}(...) is not in the language of claims in one line; its functions are "
            f"{', '.join([*FUNCTIONS, *_FUNCTIONS])}, .get(key, default), .keys() and .values()"
        )

    def _mapping(self, value: ast.expr, node: ast.expr) -> None:
        if (kind := self.of(value)) != _MAPPING:
            raise OwnClaimError(
                f"{self.text(node)} asks {kind} for keys; expected one of {', '.join(MAPPINGS)}"
            )

    def _arguments(self, name: str, arguments: Sequence[ast.expr], node: ast.expr) -> None:
        """Refuse arguments that a function does not have."""
        if name == "implies":
            if len(arguments) != 2:
                raise OwnClaimError(f"{self.text(node)} has {len(arguments)} sides; expected two")
            self._logic(arguments, node)
        elif name in ("max", "min") and len(arguments) > 1:
            self._all(arguments, _NUMBER, node)
        elif len(arguments) != len(_ARGUMENTS[name]):
            number = len(_ARGUMENTS[name])
            raise OwnClaimError(
                f"{self.text(node)} has {len(arguments)} arguments; expected {number}"
            )
        elif _ARGUMENTS[name] == (_VECTOR,):
            kind, inner = self.of(arguments[0]), self.text(arguments[0]).strip("'")
            if kind == _MAPPING and name != "len":
                raise OwnClaimError(
                    f"{self.text(node)} is of a mapping; write {name}({inner}.values()) or "
                    f"{name}({inner}.keys())"
                )
            if kind not in (_VECTOR, _MAPPING):
                raise OwnClaimError(f"{self.text(node)} is of {kind}; expected a vector")
        else:
            self._all(arguments, _NUMBER, node)

    def _all(self, parts: Sequence[ast.expr], wanted: str, node: ast.expr) -> str:
        """Return the type that all parts must have."""
        for part in parts:
            if (kind := self.of(part)) != wanted:
                raise OwnClaimError(
                    f"{self.text(part)} in {self.text(node)} is {kind}; expected {wanted}"
                )
        return wanted

    def _logic(self, parts: Sequence[ast.expr], node: ast.expr) -> None:
        """Refuse what is neither true nor false beside ``and``, ``or``, ``not``, ``implies``."""
        for part in parts:
            if (kind := self.of(part)) != _TRUTH:
                meant = self._meant(node)
                remedy = f"Did you mean {meant}?" if meant else "Compare it, as in m >= 3"
                raise OwnClaimError(
                    f"{self.text(part)} in {self.text(node)} is {kind}; expected a truth value on "
                    f"each side of and, or, not, implies. {remedy}"
                )

    def _meant(self, node: ast.expr) -> str:
        """Return what ``a == 1 or 2`` and ``a != 1 and 2`` were probably meant to be."""
        match node:
            case ast.BoolOp(
                op=op,
                values=[ast.Compare(left=left, ops=[compared], comparators=[first]), *others],
            ) if all(map(self._is_number, (first, *others))):
                values = ", ".join(map(ast.unparse, (first, *others)))
                if isinstance(op, ast.Or) and isinstance(compared, ast.Eq):
                    return f"{ast.unparse(left)} in ({values})"
                if isinstance(compared, ast.NotEq):
                    return f"{ast.unparse(left)} not in ({values})"
        return ""

    def _is_number(self, node: ast.expr) -> bool:
        return self.of(node) == _NUMBER

    def _compare(self, node: ast.Compare) -> None:
        """Refuse a comparison of parts that have no common order."""
        sides = [node.left, *node.comparators]
        for op, left, right in zip(node.ops, sides, sides[1:], strict=False):
            types = (self.of(left), self.of(right))
            if isinstance(op, _MEMBERSHIP):
                if types != (_NUMBER, _VECTOR):
                    raise OwnClaimError(
                        f"{self.text(node)} looks for {types[0]} in {types[1]}; expected a number "
                        "in a vector, as in regions in (14, 16)"
                    )
            elif not isinstance(op, (*_EQUALITY, *_ORDER)):
                raise OwnClaimError(
                    f"{self.text(node)} is not in the language of claims in one line; compare with "
                    "== != < <= > >= in"
                )
            elif types[0] != types[1]:
                raise OwnClaimError(
                    f"{self.text(node)} compares {types[0]} with {types[1]}; expected two of a kind"
                )
            elif isinstance(op, _ORDER) and types[0] not in (_NUMBER, _VECTOR):
                raise OwnClaimError(
                    f"{self.text(node)} orders {types[0].partition(' ')[2]}s; expected == or != "
                    "between them"
                )
