r"""Formulas in a small part of TeX, as MathML: no script and no font from outside is needed.

The part: letters and numbers, the signs ``+ - = ( ) [ ] , . ; : | / * !``, scripts ``^`` and ``_``,
groups in braces, ``\text{...}``, spaces, and the names in `NAMES`. What is read can stand in a
LaTeX document as it is: it can do nothing there but print.
"""

from __future__ import annotations

import re
from contextlib import suppress
from xml.etree import ElementTree as ET

from arrangement.errors import InputError, MissingExtraError, extra
from arrangement.numbers.exact import shown

NAMES = frozenset(
    (
        *("le", "ge", "lt", "gt", "ne", "in", "times", "cdot", "sum", "prod", "max", "min", "log"),
        *("ldots", "cdots", "to", "Rightarrow", "iff", "neg", "exists", "forall", "chi", "mu"),
        *(
            "sigma",
            "tau",
            "pi",
            "infty",
            "ell",
            "frac",
            "binom",
            "sqrt",
            "quad",
            "qquad",
            "lfloor",
            "rfloor",
        ),
    )
)
_TOKEN = re.compile(
    r"\\text\{[^{}\\$&#%_^~<>]*\}|\\[a-zA-Z]+|\\[{},;]|[0-9]+(?:\.[0-9]+)?|[a-zA-Z]"
    r"|[-+=()\[\],.;:|/*!'^_{}]"
)
#: How many parts an element of MathML has; those without an entry have text, or any number.
_PARTS = {"mfrac": 2, "msub": 2, "msup": 2, "munder": 2, "mover": 2, "msubsup": 3, "munderover": 3}
_OTHERS = {"math", "mrow", "mn", "mo", "mtext", "mspace", "msqrt"}
MAX_LENGTH = 400


def mathml(text: str) -> str:
    """Return a formula as a MathML element, made by latex2mathml.

    Raises:
        InputError: what is not in the part of TeX that is read, or longer than `MAX_LENGTH`.
        MissingExtraError: latex2mathml is not installed.
    """
    tokens = _tokens(text)
    with extra("report"):
        from latex2mathml.converter import convert

    try:
        made: str = convert(text, display="block")
        complete = all(map(_is_whole, ET.fromstring(made).iter()))
        complete &= tokens.count("{") == tokens.count("}")
    except Exception:  # the library's errors have no common name
        complete = False
    if not complete:
        raise InputError(f"the formula {shown(text)} is not complete where a term is due")
    return made.replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")


def _is_whole(element: ET.Element) -> bool:
    """Return whether an element is one of MathML with its parts; the library makes some without."""
    name = element.tag.rpartition("}")[2]
    if name == "mi":
        return bool(element.text and element.text not in "{}")
    return len(element) == _PARTS[name] if name in _PARTS else name in _OTHERS


def check_formula(text: str) -> None:
    """Refuse what `mathml` does; without latex2mathml a missing term is not found.

    Raises:
        InputError: see `mathml`.
    """
    _tokens(text)
    with suppress(MissingExtraError):
        mathml(text)


def is_formula(text: str) -> bool:
    """Return whether a text is a formula that can do nothing but print."""
    try:
        check_formula(text)
    except InputError:
        return False
    return bool(text)


def _tokens(text: str) -> list[str]:
    """Return the parts of a formula, all of which are read."""
    if len(text) > MAX_LENGTH:
        raise InputError(f"a formula has {len(text)} characters; at most {MAX_LENGTH} are read")
    tokens = _TOKEN.findall(text)
    if "".join(tokens).replace(" ", "") != re.sub(r"\s", "", text):
        raise InputError(f"the formula {shown(text)} has signs that are not read")
    for token in tokens:
        name = token.removeprefix("\\")
        if token != name and name.isalpha() and name not in NAMES:
            raise InputError(f"the formula {shown(text)} has {token}, which is not read")
    return tokens
