"""Reading grasps and certificates from files, names or mappings; see
`arrangement.library.files.json_files`.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from arrangement.errors import InputError, OutOfReachError
from arrangement.library.files.content import content_kind
from arrangement.library.files.json_files import (
    Source,
    check_document,
    parse_json,
    read_document,
    read_text,
)
from arrangement.numbers import budget
from arrangement.numbers.exact import to_text
from arrangement.planes.proved import ask_proved
from equilibrium.certificate.checker import check
from equilibrium.certificate.document import Certificate
from equilibrium.certificate.reading import SCHEMA_VERSION
from equilibrium.certificate.report import Question, Report
from equilibrium.grasps.npz_file import refuse_npz
from equilibrium.model.errors import CertificateError, GraspError
from equilibrium.model.grasp import Grasp

if TYPE_CHECKING:
    from arrangement import Arrangement
    from equilibrium.decide.verdict import Verdict


#: What takes floats, said where one is refused.
_OF_FLOATS = (
    "Measured contacts are converted by `equilibrium make floats`, from a table (.csv), from "
    "contacts, or from lists of points and normals"
)
_SCENE = re.compile(r'\s*\{\s*"schema_version":\s*1,\s*"law":')
#: Keys of a grasp with its load.
_QUESTION = {"schema_version", "grasp", "wrench"}
_READ = (
    "Expected a grasp: a .csv file of lines such as x,y,nx,ny,friction and 1,0,-1,0,0.5, or JSON "
    'such as {"contacts": [{"point": [1, 0], "normal": [-1, 0], "friction": "1/2"}]}'
)


class DecimalText(str):
    """A decimal of a JSON file, exactly and without an exponent."""


def decimal_text(text: str) -> DecimalText:
    """Return a decimal of a JSON file as exact text, which a table has too.

    Raises:
        OutOfReachError: without its exponent it would be very long.
    """
    digits, _, exponent = text.lower().partition("e")
    budget.check_size(len(digits) + abs(int(exponent or 0)), "characters of a number")
    return DecimalText(to_text(Fraction(text)))


def has_decimals(value: Any) -> bool:
    """Return whether a JSON value has a number that was written as a decimal."""
    if isinstance(value, Mapping):
        return any(map(has_decimals, value.values()))
    if isinstance(value, list):
        return any(map(has_decimals, value))
    return isinstance(value, DecimalText)


def read_contacts(
    source: Source, *kinds: str, floats: Callable[[str], Any] | None = None
) -> dict[str, Any]:
    """Read a document that has the key ``contacts``, or one of the kinds; a bare list is one, too.

    The version of the schema may be omitted where there are contacts.

    Args:
        floats: reads a decimal, for data whose conversion is the purpose; None refuses it.

    Raises:
        InputError: anything else, with what it seems to be, and what is read.
    """
    expected = ("contacts", *kinds)
    if isinstance(source, Mapping):
        return read_document(source, expected)
    refuse_npz(source)
    try:
        text, name = read_text(source)
    except InputError as error:
        if not isinstance(source, (str, os.PathLike)) or not Path(source).is_file():
            raise
        raise GraspError(f"{error}. {_READ}") from None
    if text.lstrip()[:1] not in {*'{["'}:
        if source == "-":
            raise GraspError(
                "standard input is not JSON; tables are read from files whose names end in .csv"
            )
        raise GraspError(f"{name} is {content_kind(text)}. {_READ}")
    if _SCENE.match(text):
        raise GraspError(
            f"{name} is a scene of `equilibrium draw --model scene`; the value of its key "
            '"grasp" is a grasp document'
        )
    document = parse_json(text, name, floats=floats, of_floats=_OF_FLOATS)
    if isinstance(document, list) and all(isinstance(entry, dict) for entry in document):
        document = {"contacts": document}
    is_question = isinstance(document, dict) and {"grasp"} <= document.keys() <= _QUESTION
    if is_question and isinstance(document["grasp"], dict):
        document |= document.pop("grasp")
    if isinstance(document, dict) and "contacts" in document:
        document.setdefault("schema_version", 1)  # there is no other
    keys = {"normals", "points", *kinds} & set(document if isinstance(document, dict) else ())
    if keys == {"normals"}:
        raise GraspError(
            f"{name} gives normals of bodies; expected a grasp with contacts. Of bodies there are "
            "contact modes: equilibrium info FILE --modes"
        )
    if keys == {"normals", "points"} and not kinds:
        raise GraspError(
            f"{name} has lists of points and normals; equilibrium make floats FILE -o GRASP.json "
            "converts them"
        )
    return check_document(document, expected, name)


def tangential_arrangement(document: Mapping[str, Any]) -> Arrangement:
    """Return the tangential planes of a grasp document: what a grasp means as an arrangement."""
    return Grasp.from_dict(document).tangential_arrangement()


def read_certificate(source: Source) -> dict[str, Any]:
    """Return the document of a certificate, strictly read but not yet checked."""
    # Of old versions the checker says what they are.
    versions = range(1, SCHEMA_VERSION + 1)
    kind = "bytes of a certificate"
    try:
        return read_document(source, ("certificate",), kind=kind, versions=versions)
    except OutOfReachError:
        raise
    except InputError as error:
        raise CertificateError(
            f"{error}. `equilibrium solve GRASP --wrench F_X F_Y TAU --certificate CERT.json` "
            "writes a certificate"
        ) from None


def verify(
    source: Source | Certificate | Verdict,
    question: Question | None = None,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
) -> Report:
    """Check a certificate from a path, ``"-"`` (stdin) or a mapping; no solver is involved.

    Args:
        source: or a `Certificate`; or a verdict, whose certificate is compared with its question.
        question, pyramid, max_displacement: what it has to be about; see
            `equilibrium.certificate.checker.check`.

    Raises:
        InputError: the document has no readable form.
        UndecidedError: an undecided verdict, which has no certificate.
    """
    proof: Any = source
    if isinstance(source, Certificate):
        proof = source.to_dict()
    elif hasattr(source, "verify"):
        if question is None:
            report: Report = source.verify()
            return report
        proof = proof.proof
    return check(read_certificate(proof), question, pyramid, max_displacement)


def verify_proved(path: str | os.PathLike[str]) -> tuple[bool, str]:
    """Check a certificate with the verified checker.

    Args:
        path: of a file, or ``"-"`` (stdin).

    Returns:
        Whether it is valid, and its kind: "resisted" or "not resisted".

    Raises:
        CertificateError: the program is not built, or what it says of a file that it cannot read.
    """
    name = os.fspath(path)
    named = name if name == "-" or not name.startswith("-") else f"./{name}"
    answer, kind = ask_proved(named, error=CertificateError)
    if kind not in ("resisted", "not resisted"):
        raise CertificateError(f"it is a certificate of {kind}, not of a grasp")
    return answer == "accepted", kind
