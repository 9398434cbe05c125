r"""Formulas in a small part of TeX, as MathML: no script and no font from outside is needed.

The part: letters and numbers, the signs ``+ - = ( ) [ ] , . ; : | / * !``, scripts ``^`` and ``_``,
groups in braces, ``\frac``, ``\binom``, ``\sqrt``, ``\text{...}``, and the names in `SIGNS`. What
is read can stand in a LaTeX document as it is: it can do nothing there but print.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import escape

from arrangement.errors import InputError
from arrangement.exact import shown

#: Names that stand for one sign, with the MathML element of the sign.
_OPERATORS = {
    "le": "≤", "ge": "≥", "lt": "<", "gt": ">", "ne": "≠", "in": "∈", "times": "×", "cdot": "⋅",
    "sum": "∑", "prod": "∏", "max": "max", "min": "min", "log": "log", "ldots": "…", "cdots": "⋯",
    "to": "→", "Rightarrow": "⇒", "iff": "⟺", "neg": "¬", "exists": "∃", "forall": "∀", "{": "{",
    "}": "}",
}  # fmt: skip
_LETTERS = {"chi": "χ", "mu": "μ", "sigma": "σ", "tau": "τ", "pi": "π", "infty": "∞", "ell": "ℓ"}
SIGNS = {f"\\{name}": ("mo", sign) for name, sign in _OPERATORS.items()}
SIGNS |= {f"\\{name}": ("mi", sign) for name, sign in _LETTERS.items()}
_SPACES = {"\\,": "0.17em", "\\;": "0.28em", "\\quad": "1em", "\\qquad": "2em"}
_LARGE = ("\\sum", "\\prod", "\\max", "\\min")
_TOKEN = re.compile(
    r"\\text\{[^{}\\$&#%_^~<>]*\}|\\[a-zA-Z]+|\\[{},;]|[0-9]+(?:\.[0-9]+)?|[a-zA-Z]"
    r"|[-+=()\[\],.;:|/*!'^_{}]"
)
MAX_LENGTH = 400


def mathml(text: str) -> str:
    """Return a formula as a MathML element.

    Raises:
        InputError: what is not in the part of TeX that is read, or longer than `MAX_LENGTH`.
    """
    if len(text) > MAX_LENGTH:
        raise InputError(f"a formula has {len(text)} characters; at most {MAX_LENGTH} are read")
    tokens = _TOKEN.findall(text)
    if "".join(tokens).replace(" ", "") != re.sub(r"\s", "", text):
        raise InputError(f"the formula {shown(text)} has signs that are not read")
    stream = iter(tokens)
    row = _row(stream, text, closing=None)
    return f'<math display="block">{row}</math>'


def _row(tokens: Iterator[str], text: str, closing: str | None) -> str:
    """Read up to the closing brace, or to the end."""
    parts: list[tuple[str, str]] = []  # (token, element)
    for token in tokens:
        if token == closing:
            return f"<mrow>{''.join(element for _, element in parts)}</mrow>"
        if token in "^_":
            if not parts:
                raise InputError(f"the formula {shown(text)} has a {token} with nothing before it")
            base, element = parts.pop()
            parts.append(
                (base, _script(token, base, element, _atom(next(tokens, ""), tokens, text)))
            )
        else:
            parts.append((token, _atom(token, tokens, text)))
    if closing is not None:
        raise InputError(f"the formula {shown(text)} has a brace that is not closed")
    return f"<mrow>{''.join(element for _, element in parts)}</mrow>"


def _script(sign: str, base: str, element: str, script: str) -> str:
    """Return an element with a script; one that has the other script gets both."""
    names = ("munder", "mover", "munderover") if base in _LARGE else ("msub", "msup", "msubsup")
    low, high, both = names
    if sign == "^" and element.startswith(f"<{low}>"):
        return f"<{both}>{element[len(low) + 2 : -len(low) - 3]}{script}</{both}>"
    name = low if sign == "_" else high
    return f"<{name}>{element}{script}</{name}>"


def _atom(token: str, tokens: Iterator[str], text: str) -> str:
    def argument() -> str:
        return _atom(next(tokens, ""), tokens, text)

    if token == "{":
        return _row(tokens, text, closing="}")
    if token in SIGNS:
        name, sign = SIGNS[token]
        fence = ' stretchy="false"' * (sign in "{}")
        return f"<{name}{fence}>{escape(sign)}</{name}>"
    if token in _SPACES:
        return f'<mspace width="{_SPACES[token]}"></mspace>'
    if token.startswith("\\text{"):
        return f"<mtext>{escape(token[6:-1]).replace(' ', chr(0xA0))}</mtext>"
    if token == "\\frac":
        return f"<mfrac>{argument()}{argument()}</mfrac>"
    if token == "\\sqrt":
        return f"<msqrt>{argument()}</msqrt>"
    if token == "\\binom":
        over = f'<mfrac linethickness="0">{argument()}{argument()}</mfrac>'
        return f"<mrow><mo>(</mo>{over}<mo>)</mo></mrow>"
    if token and token not in "}^_" and not token.startswith("\\"):
        name = "mn" if token[0].isdigit() else "mi" if token.isalpha() else "mo"
        fence = ' stretchy="false"' * (token in "()[]|")
        fence += ' lspace="0" rspace="0"' * (token == "|")
        return f"<{name}{fence}>{'−' if token == '-' else token}</{name}>"
    raise InputError(f"the formula {shown(text)} has {token or 'its end'} where a term is due")
