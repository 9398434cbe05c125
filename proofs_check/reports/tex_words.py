r"""Words, code and prose with mathematics as LaTeX; nothing in a text is ever a command.

Claims are written in plain text: ``m >= 3 planes have m^2 - m + 2 regions``. `prose` finds what is
mathematics there (numbers, letters, operators and brackets that belong together) and sets it so.
Long words may break, so that no line of a narrow column runs over its margin.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from arrangement.drawing.tikz.tex_text import SIGNS, escaped
from arrangement.errors import InputError

from .formula import mathml


class Tex(str):
    """LaTeX that is set as it is; every other text of a record is escaped."""

    __slots__ = ()


_WORDS = re.compile(r"\S+")
#: A piece of a long word after which it may break: to a sign, or so many letters or digits.
_PIECES = re.compile(
    r"[(\[{]*(?:[A-Za-z]{1,20}(?![A-Za-z])[^\w\s(\[{]?|[A-Za-z]{1,8}|\d{1,10}[^\w\s(\[{]?|.)",
    re.DOTALL,
)
#: Letters and other signs of a word that need not break, and letters of one that is hyphenated.
_LONG, _LONGEST = 11, 20
_PLAIN = {
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    "-": "{-}",
    "`": r"{\char18}",
    '"': r"{\char125}",
}
_CODE = {c: c for c in "<>|"} | {c: rf"{{\char{ord(c)}}}" for c in '\\{}$&#%_^~"`'}
_CODE |= {"-": "{-}", "'": r"{\char13}"}


def words(text: str) -> Tex:
    r"""Return text as it is, in one paragraph.

    >>> print(words("50% of x_1 & \\input{y}"))
    50\% of x\_1 \& \textbackslash{}input\{y\}
    """
    return Tex(_WORDS.sub(lambda word: _breaking(word[0], _PLAIN), " ".join(text.split())))


def code(text: str) -> Tex:
    """Return a command or a name in the letters of a typewriter."""
    found = _WORDS.sub(lambda word: _breaking(word[0], _CODE), " ".join(text.split()))
    return Tex(rf"\texttt{{{found}}}")


def _breaking(word: str, signs: dict[str, str]) -> str:
    if len(word) <= _LONG or (word.isalpha() and len(word) <= _LONGEST):
        pieces = [word]
    else:
        pieces = _PIECES.findall(word)
    return r"\brk ".join("".join(_sign(c, signs) for c in piece) for piece in pieces)


def _sign(sign: str, signs: dict[str, str]) -> str:
    if sign in signs:
        return signs[sign]
    known = escaped(sign)
    if known.isascii() and known.isprintable():
        return known
    if sign in SIGNS:
        return rf"\ensuremath{{{SIGNS[sign]}}}"
    return rf"\brk [U+{ord(sign):04X}]"


_LETTERS = "chi|mu|tau|sigma|pi|lambda|log|max|min|sum"
_TOKEN = re.compile(
    r"(?P<given>\$[^$]+\$)"
    r"|(?P<space>\s+)"
    r"|(?P<op><=|>=|!=|==|\*\*|\+-|->|\.\.\.|[-+*/=<>^_])"
    r"|(?P<bar>\|)"
    r"|(?P<open>[(\[{])"
    r"|(?P<close>[)\]}])"
    r"|(?P<comma>,)"
    r"|(?P<number>\d+(?:\.\d+)?(?!\.?\d))"
    rf"|(?P<name>(?:{_LETTERS})(?![A-Za-z]))"
    r"|(?P<letter>[A-Za-z](?:_[A-Za-z0-9]{1,2}(?![A-Za-z0-9_]))?(?![A-Za-z]|_(?!\{)))"
    r"|(?P<word>[^\W\d_][\w']*|.)",
    re.DOTALL,
)
_OPERATORS = {
    "<=": r"\le ",
    ">=": r"\ge ",
    "!=": r"\ne ",
    "+-": r"\pm ",
    "->": r"\to ",
    "...": r"\ldots ",
    "*": r"\cdot ",
}
_MOST, _DIGITS = 120, 10  # tokens of one formula; digits of a number between which none breaks

_Token = tuple[str, str]


def prose(text: str) -> Tex:
    r"""Return prose with its mathematics set.

    >>> print(prose("Of R^3: m^2 - m + 2 regions (3-connected) for m >= 3."))
    Of $\mathbb{R}^{3}$: $m^{2}-m+2$ regions (3{-}\brk connected) for $m\ge 3$.
    """
    plain = " ".join(text.split())
    raw = [(str(found.lastgroup), found.group()) for found in _TOKEN.finditer(plain)]
    tokens = [(kind, {"==": "=", "**": "^"}.get(text, text)) for kind, text in raw]
    made, waiting, k = "", "", 0
    while k < len(tokens):
        stop = _reach(tokens, k) if waiting[-1:] not in set("'_^") else k
        if stop > k:
            made += _between(waiting) + f"${_formula(tokens[k:stop])}$"
            waiting, k = "", stop
        elif tokens[k][0] == "given" and is_formula(tokens[k][1][1:-1]):
            made += _between(waiting) + tokens[k][1]
            waiting, k = "", k + 1
        else:
            waiting += raw[k][1]
            k += 1
    return Tex(made + _between(waiting))


def _between(text: str) -> str:
    """Return words with the spaces at their ends."""
    inside = words(text)
    if not inside:
        return " " if text else ""
    return " " * (text[:1] == " ") + inside + " " * (text[-1:] == " ")


def is_formula(text: str) -> bool:
    """Return whether a text is a formula that can do nothing but print."""
    try:
        return bool(text and mathml(text))
    except InputError:
        return False


def _reach(tokens: Sequence[_Token], start: int) -> int:
    """Return where the mathematics ends that begins at a place; the place if it has none."""
    stop, bars, lowered = start, 0, -1
    depth: list[tuple[str, int]] = []  # what closes an open bracket, and where it is
    for k in range(start, min(len(tokens), start + _MOST)):
        kind, text = tokens[k]
        before = tokens[k - 1] if k > start else ("start", "")
        if kind in ("word", "given") or (kind == "comma" and not depth and not bars % 2):
            break
        if text in ("^", "_") and not (_has_script(tokens, k, start) or k - 1 == lowered):
            break
        if kind == "open":
            depth.append((")]}"["([{".index(text)], k))
        elif kind == "close":
            if not depth or depth[-1][0] != text:
                break
            begun = depth.pop()[1]
            lowered = k if begun > start and tokens[begun - 1][1] == "_" else lowered
        bars += kind == "bar"
        ends = kind in ("number", "letter", "close") or (kind == "name" and text in ("chi", "mu"))
        ends |= kind == "bar" and before[0] != "space"
        if kind == "letter" and text in "aAI" and before[0] == "space":
            ends = k >= 2 and tokens[k - 2][0] == "op"
        if ends and not depth and bars % 2 == 0 and not _joined(tokens, k + 1):
            stop = k + 1
    return stop if _is_maths(tokens[start:stop], tokens[start - 1][1] if start else "") else start


def _has_script(tokens: Sequence[_Token], k: int, start: int) -> bool:
    """Return whether a sign of a script has what it is on, what it is, and no other before."""
    if k == start or k + 1 == len(tokens) or (k - 2 >= start and tokens[k - 2][1] in ("^", "_")):
        return False
    on, (kind, text) = tokens[k - 1], tokens[k + 1]
    if on[0] not in ("number", "letter", "name") and on[1] not in (")", "]"):
        return False
    return text == "{" or (tokens[k][1] == "^" and (kind in ("number", "letter") or text == "("))


def _joined(tokens: Sequence[_Token], k: int) -> bool:
    """Return whether a word goes on at a place."""
    if k >= len(tokens):
        return False
    if tokens[k][1] == "-":
        return k + 1 < len(tokens) and tokens[k + 1][0] == "word"
    return tokens[k][0] == "word" and tokens[k][1][:1].isalnum()


def _is_maths(tokens: Sequence[_Token], before: str) -> bool:
    if not tokens or before[-1:].isalnum() or before == "-":
        return False
    kinds = [kind for kind, _ in tokens]
    if len(tokens) == 1:
        return kinds == ["letter"] and tokens[0][1] not in "aAI"
    if tokens[0][1] in ("a", "A", "I") and kinds[1] == "space" and kinds[2] != "op":
        return False
    if kinds[0] in ("op", "space", "close", "comma") and tokens[0][1] not in ("-", "+-"):
        return False
    if tokens[0][1] in ("-", "+-") and kinds[1] == "space":
        return False
    hard = {"<=", ">=", "!=", "=", "<", ">", "+", "*", "^", "_", "+-"}
    for k, (kind, text) in enumerate(tokens):
        if text in hard or kind == "name" or (kind == "letter" and "_" in text):
            return True
        if kind == "letter" and k and kinds[k - 1] in ("number", "close"):
            return True
        if text == "-" and (k == 0 or tokens[k - 1][1] in "([,| " or kinds[k - 1] == "letter"):
            return True
        if text == "/" and kinds[k - 1] == "close":
            return True
    return kinds == ["open", "letter", "close"] or "bar" in kinds


def _formula(tokens: Sequence[_Token]) -> str:
    found, k = "", 0
    while k < len(tokens):
        kind, text = tokens[k]
        stop = k + 1
        if text in ("^", "_"):
            stop += 1
            inside = tokens[k + 1 : stop]
            if inside[0][0] == "open":
                stop = _closing(tokens, k + 1) + 1
                inside = tokens[k + 2 : stop - 1]
            found += f"{text}{{{_formula(inside)}}}"
        elif (text, *(token[1] for token in tokens[stop : stop + 1])) == ("C", "("):
            close = _closing(tokens, stop)
            made = _binomial(tokens[stop + 1 : close])
            found, stop = (found + made, close + 1) if made else (f"{found}C", stop)
        elif kind == "open" and found.endswith(")"):
            found += rf"\allowbreak {text}"
        else:
            found += _part(tokens, k)
        k = stop
    return found.strip()


def _binomial(inside: Sequence[_Token]) -> str:
    """Return C(n, k) as a binomial coefficient, from what is between its brackets; or ""."""
    depths = _depths(inside)
    commas = [k for k, token in enumerate(inside) if token[0] == "comma" and not depths[k]]
    if len(commas) != 1:
        return ""
    upper, lower = inside[: commas[0]], inside[commas[0] + 1 :]
    return rf"\binom{{{_formula(upper)}}}{{{_formula(lower)}}}"


def _part(tokens: Sequence[_Token], k: int) -> str:
    """Return one token of a formula."""
    kind, text = tokens[k]
    match kind:
        case "letter" if "_" in text:
            base, _, index = text.partition("_")
            return f"{base}_{{{index}}}"
        case "letter" if text == "R" and k + 1 < len(tokens) and tokens[k + 1][1] == "^":
            return r"\mathbb{R}"
        case "name":
            return f"\\{text} "
        case "space" if 0 < k < len(tokens) - 1:
            ends = tokens[k - 1], tokens[k + 1]
            apart = all(end[0] in ("number", "letter", "close") for end in ends)
            wide = apart and ends[0][1] in (")", "]")
            return r"\;\allowbreak " if wide else r"\," if apart else ""
        case "space":
            return ""
        case "comma":
            return r", \allowbreak "
        case "number" if len(text) > _DIGITS:
            parts = (text[j : j + _DIGITS] for j in range(0, len(text), _DIGITS))
            return r"\allowbreak ".join(parts)
    return f"\\{text}" if text in "{}" else _OPERATORS.get(text, text)


def _depths(tokens: Sequence[_Token]) -> list[int]:
    depth, found = 0, []
    for kind, _ in tokens:
        depth += (kind == "open") - (kind == "close")
        found.append(depth)
    return found


def _closing(tokens: Sequence[_Token], start: int) -> int:
    """Return the place of the bracket that closes the one at a place."""
    return start + _depths(tokens[start:]).index(0)
