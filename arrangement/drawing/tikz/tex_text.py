"""Labels as LaTeX: signs, numbers, vectors and Greek letters are maths, words are text."""

from __future__ import annotations

import re
from itertools import groupby
from unicodedata import normalize

_GREEK = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho"
#: Signs with the commands for them.
_COMMANDS = (
    "\u2248approx \u00d7times \u00b7cdot \u2264le \u2265ge \u2208in \u221einfty \u2192to \u00b1pm "
    "\u2260ne \u25cfbullet \u25cbcirc \u2205emptyset \u03a3Sigma \u0394Delta \u03a6Phi \u03c3sigma "
    "\u03c4tau \u03c5upsilon \u03c6varphi \u03c7chi \u03c8psi \u03c9omega"
)
#: Signs as mathematics.
SIGNS = {
    **{sign: sign for sign in "+=<>/"},
    "\u2212": "-",
    "\u00b0": r"^\circ ",
    "\u211d": r"\mathbb{R}",
    **{word[0]: f"\\{word[1:]} " for word in _COMMANDS.split()},
    **{chr(0x3B1 + k): f"\\{name} " for k, name in enumerate(_GREEK.split())},
}
_RAISED = {sign: str(k) for k, sign in enumerate("\u2070\u00b9\u00b2\u00b3")}
_RAISED |= {chr(0x2070 + k): str(k) for k in range(4, 10)} | {"\u207b": "-"}
_LOWERED = {chr(0x2080 + k): str(k) for k in range(10)}
_TEXT = {
    **{sign: f"\\{sign}" for sign in "{}#$%&_"},
    "\\": r"\textbackslash{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "\u2013": "--",
    "\u2014": "---",
    "\u2026": r"\dots{}",
    "\u2019": "'",
    "\u200a": r"\kern.06em ",
    "\u2007": r"\phantom{0}",
}
_ACCENTS = {
    **{chr(0x300 + k): f"\\{sign}" for k, sign in enumerate("`'^~=")},
    **{chr(0x306 + k): f"\\{sign}" for k, sign in enumerate(("u ", ".", '"'))},
    **{chr(0x30A + k): f"\\{sign} " for k, sign in enumerate("rHv")},
    "\u0327": r"\c ",
}
_SIGNS = {"+": "{+}", "\u2212": "{-}", "0": "{0}", "\u25cf": r"{\bullet}", "\u25cb": r"{\circ}"}

#: After these a minus is one of a number anyway.
_BEFORE_MINUS = set("(,=<>/+\u2248\u2264\u2265\u00d7\u00b7")
_TOKEN = re.compile(
    r"(?P<given>\$[^$]*\$)"
    r"|(?P<norm>\bL(?:\d|\u221e))"
    r"|(?P<indexed>(?<!\w)[A-Za-z]_[A-Za-z0-9](?!\w))"
    r"|(?P<power>\d+\^\d+|[\d.]+e[+-]?\d+)"
    r"|(?P<signs>[+\u22120\u25cf\u25cb](?:\u200a[+\u22120\u25cf\u25cb])+)"
    r"|(?P<number>\d+(?:\.\d+)?)"
    rf"|(?P<maths>[{re.escape(''.join(SIGNS))}]|[{''.join(_RAISED)}]+|[{''.join(_LOWERED)}]+)"
    r"|(?P<variable>(?<![\w(])[cfmnrtwxyz](?![A-Za-z0-9_)]))"
    r"|(?P<soft>[\s,()\u200a]|(?<!\w)[a-z](?!\w))"
    r"|(?P<word>[A-Za-z\u00c0-\u024f]+)"
    r"|(?P<other>.)",
    re.DOTALL,
)


def tex_text(text: str) -> str:
    r"""Return a label, of one or several lines, as LaTeX.

    >>> print(tex_text("w = (0, −1/2, x)"), tex_text("100 % of ℝ³"), tex_text("+\u200a−"))
    $w=(0,-1/2,x)$ 100 \% of $\mathbb{R}^{3}$ ${+}{-}$
    """
    return r" \\ ".join(map(_line, text.split("\n")))


def _line(line: str) -> str:
    bare = line.replace("\u200a", "")
    if bare and set(bare) <= set(_SIGNS) and bare != "0":
        return "$" + "".join(_SIGNS[sign] for sign in bare) + "$"
    tokens = [(str(found.lastgroup), found.group()) for found in _TOKEN.finditer(line)]
    wordless = all(kind != "word" for kind, _ in tokens)
    depth, kinds = 0, []
    for kind, text in tokens:
        depth += (text == "(") - (text == ")")
        apart = text == "," and not depth and not wordless
        kinds.append("other" if apart else kind)
    tokens = [(kind, text) for kind, (_, text) in zip(kinds, tokens, strict=True)]
    runs = groupby(tokens, key=lambda token: token[0] in ("word", "other", "given"))
    parts = [(is_text, list(run)) for is_text, run in runs]
    return "".join(_words(run) if is_text else _mixed(run, wordless) for is_text, run in parts)


def _mixed(tokens: list[tuple[str, str]], wordless: bool) -> str:
    """Return tokens without words: maths if one of them says so, but for what is around it."""
    hard = {"norm", "indexed", "power", "signs", "maths", "variable"} | (
        {"number"} if wordless else set()
    )
    if not any(kind in hard for kind, _ in tokens):
        return _words(tokens)
    start, stop = 0, len(tokens)
    while tokens[start][1].isspace() or tokens[start][1] in ",)":
        start += 1
    while tokens[stop - 1][1].isspace() or tokens[stop - 1][1] in ",(":
        stop -= 1
    inside = "".join(text for _, text in tokens[start:stop])
    if inside.count("(") != inside.count(")"):
        # A parenthesis of the sentence: maths begins or ends there.
        cut = inside.rfind("(") if inside.count("(") > inside.count(")") else inside.find(")")
        k = next(k for k in range(start, stop) if sum(len(t) for _, t in tokens[start:k]) == cut)
        return _mixed(tokens[:k], wordless) + tokens[k][1] + _mixed(tokens[k + 1 :], wordless)
    before, after = _words(tokens[:start]), _words(tokens[stop:])
    return f"{before}${_maths(tokens[start:stop])}${after}"


def _maths(tokens: list[tuple[str, str]]) -> str:
    found = ""
    for k, (kind, text) in enumerate(tokens):
        if kind == "norm":
            found += f"L_{SIGNS.get(text[1:], text[1:]).strip()}"
        elif kind == "power":
            base, mark, power = text.partition("^") if "^" in text else text.partition("e")
            found += (f"{base}\\cdot 10" if mark == "e" else base) + f"^{{{int(power)}}}"
        elif kind == "signs":
            found += "".join(_SIGNS.get(sign, "") for sign in text)
        elif text[0] in _RAISED:
            found += "^{" + "".join(_RAISED[x] for x in text) + "}"
        elif text[0] in _LOWERED:
            found += "_{" + "".join(_LOWERED[x] for x in text) + "}"
        elif text.isspace():
            ends = (tokens[k - 1], tokens[k + 1])
            apart = all(kind in ("number", "variable", "power", "signs") for kind, _ in ends)
            found += (r"\;" if ends[1][0] == "signs" else r"\,") if apart else ""
        elif text == "\u2212" and _begins_number(tokens, k):
            found += r"\;{-}"
        elif text == "," and k + 1 < len(tokens) and not tokens[k + 1][1].isspace():
            found += "{,}"
        else:
            found += SIGNS.get(text, text)
    return found.strip()


def _begins_number(tokens: list[tuple[str, str]], k: int) -> bool:
    """Return whether a minus after a space and a non-operator belongs to the number after."""
    if k < 2 or k + 1 == len(tokens) or not tokens[k - 1][1].isspace():
        return False
    return tokens[k + 1][0] == "number" and tokens[k - 2][1] not in _BEFORE_MINUS


def _words(tokens: list[tuple[str, str]]) -> str:
    return "".join(text if kind == "given" else escaped(text) for kind, text in tokens)


def escaped(text: str) -> str:
    r"""Return text that LaTeX prints as it is.

    >>> print(escaped("Möbius_1"))
    M\"{o}bius\_1
    """
    found = ""
    for sign in text:
        letters = normalize("NFD", sign)
        if len(letters) == 2 and letters[1] in _ACCENTS:
            found += f"{_ACCENTS[letters[1]]}{{{letters[0]}}}"
        else:
            found += _TEXT.get(sign, sign)
    return found
