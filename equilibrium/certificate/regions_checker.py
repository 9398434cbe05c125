"""The checker of certificates, which shares no code with the solver.

Stable: a motion and forces; the four conditions of equilibrium are evaluated.

Unstable: all regions of the motion arrangement (the planes ``T . d = 0``, then those with
``stiffness N . d = preload``), each as its signs and a point inside, complete by Zaslavsky's
theorem. The point is written as integers X, Y, Z, W and means ``(X, Y, Z) / W``. And for each
choice of contact states that these regions make necessary (`coverage`) the reason why it admits
no equilibrium. States are one letter for each contact: ``d`` detached, ``+`` and ``-`` slip, ``0``
stick. A reason is one of two.

* a name: the equalities have exactly one solution, and the named condition fails there
  (`determinants`). ``normal i``: a touching contact pulls, or a detached one is
  pressed. ``slip i``: a slipping contact moves the other way. ``friction- i``, ``friction+ i``: on
  the tangential plane of the sticking contact i, the friction limits of all contacts that stick
  there, less or plus the sum of their forces along its tangent.
* multipliers that combine the conditions to ``0 = -1``, in the unknowns d and one tangential force
  for each sticking contact. ``equalities``: balance of force x, force y, torque; then ``T . d = 0``
  for each sticking contact. ``inequalities`` (``>= 0``), contact by contact: detached:
  ``stiffness N . d - preload``. Otherwise the normal force ``c_n = preload - stiffness N . d``, and
  then for slip ``T . d`` or ``-T . d``, for stick ``friction c_n - c_t``, ``friction c_n + c_t``.

A SHA-256 digest of the canonical content guards what mathematics alone would let pass, such as
another point in the same region.
"""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from arrangement.completeness import regions_problem
from arrangement.exact import RationalVector, rational_vector
from arrangement.io.files import check_keys, check_list
from arrangement.planes import Planes
from arrangement.progress import watched
from equilibrium.model.errors import CertificateError
from equilibrium.model.grasp import Grasp, read_wrench

from .conditions import Conditions, conditions_of, motion_planes, violation_problem
from .coverage import DETACHED, Rows, due_states, sorted_rows
from .determinants import KINDS, proven_violations

SCHEMA_VERSION = 1
_COMMON = ("schema_version", "certificate", "grasp", "wrench", "digest")
_KEYS = {"stable": ("motion", "forces"), "unstable": ("regions", "branches")}
_CODES = {"+": 1, "0": 0, "-": -1, "d": DETACHED}
_NAMES = {"+": "slip+", "0": "stick", "-": "slip-", "d": "detached"}
#: The letters of states that a kind of condition can be about.
_FITTING = {"normal": "+-0d", "slip": "+-", "friction-": "0", "friction+": "0"}


#: Why a choice of states admits no equilibrium: the name of a condition, or the multipliers of the
#: inequalities and of the equalities.
Reason: TypeAlias = str | tuple[RationalVector, RationalVector]
Point: TypeAlias = Sequence[int]


@dataclass(frozen=True)
class Line:
    """One checked line: its name, whether it holds, and what is wrong if not."""

    name: str
    holds: bool
    problem: str = ""


@dataclass(frozen=True)
class Report:
    """What a check found; it is true exactly when every line holds."""

    kind: str
    lines: tuple[Line, ...]

    @property
    def valid(self) -> bool:
        """Whether every line holds, and there is at least one."""
        return bool(self.lines) and all(line.holds for line in self.lines)

    def __bool__(self) -> bool:
        return self.valid

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        failed = next((line for line in self.lines if not line.holds), None)
        return {
            "valid": self.valid,
            "certificate": self.kind,
            "failed": None if failed is None else {"line": failed.name, "problem": failed.problem},
            "lines": [{"line": line.name, "holds": line.holds} for line in self.lines],
        }


def check(
    document: Mapping[str, Any],
    question: tuple[Grasp, RationalVector] | None = None,
    *,
    rationals_only: bool = False,
) -> Report:
    """Check a certificate document line by line; stop at the first wrong line.

    Args:
        document: as `Certificate.to_dict` gives it, or as read from a file.
        question: if given, the grasp and wrench that the certificate has to be about.
        rationals_only: do every step in rationals. Otherwise the signs of determinants and of
            points are taken from floating point where a bound of its error proves them.

    Raises:
        InputError: the document has no readable form (unknown keys, wrong types, a float, a grasp
            out of range). A wrong digest is found before that and is a refusal, not an error.
    """
    kind = _kind(document)
    lines = [_digest_line(document)]
    if not lines[0].holds:
        return Report(kind, tuple(lines))
    optional = ("description", "units")
    check_keys(document["grasp"], ("contacts", "schema_version"), optional, "grasp")
    grasp, wrench = Grasp.from_dict(document["grasp"]), read_wrench(document["wrench"])
    if question is not None:
        same = question == (grasp, wrench)
        lines.append(Line("question", same, "" if same else "it is about another grasp or wrench"))
    if kind == "stable":
        lines += _stable_lines(grasp, wrench, document)
    else:
        lines += _unstable_lines(grasp, wrench, document, rationals_only)
    return Report(kind, tuple(lines))


def digest(document: Mapping[str, Any]) -> str:
    """Return the digest of a document: of its canonical JSON without the digest itself."""
    return digest_of(canonical({key: value for key, value in document.items() if key != "digest"}))


def canonical(value: Any) -> str:
    """Return JSON in the one form that digests are made of: sorted keys, no spaces, ASCII."""
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=True)


def digest_of(text: str) -> str:
    """Return the SHA-256 of a text."""
    return hashlib.sha256(text.encode("ascii")).hexdigest()


def _kind(document: Mapping[str, Any]) -> str:
    """Check version, kind and keys of a document; return the kind."""
    if not isinstance(document, Mapping):
        raise CertificateError("the certificate must be an object")
    version = document.get("schema_version")
    if type(version) is not int or version != SCHEMA_VERSION:
        raise CertificateError(
            f"schema_version is {version!r}; this version reads {SCHEMA_VERSION}"
        )
    kind = document.get("certificate")
    if not isinstance(kind, str) or kind not in _KEYS:
        raise CertificateError('certificate must be "stable" or "unstable"')
    check_keys(document, (*_COMMON, *_KEYS[kind]), (), "the certificate")
    return kind


def _digest_line(document: Mapping[str, Any]) -> Line:
    try:
        found = digest(document)
    except (TypeError, ValueError, RecursionError):
        raise CertificateError("the certificate is not plain JSON") from None
    stated = document["digest"]
    same = isinstance(stated, str) and hmac.compare_digest(stated.encode(), found.encode())
    return Line("digest", same, "" if same else "the content was changed after it was written")


def _stable_lines(grasp: Grasp, wrench: RationalVector, document: Mapping[str, Any]) -> list[Line]:
    """Evaluate the four conditions of equilibrium."""
    motion = rational_vector(check_list(document["motion"], "motion", 3), "motion")
    listed = check_list(document["forces"], "forces", len(grasp))
    forces = [
        rational_vector(check_list(pair, f"forces[{i}]", 2), f"forces[{i}]")
        for i, pair in enumerate(listed)
    ]
    problems = Conditions(grasp, wrench).problems(motion, forces)
    return [Line(name, not problem, problem) for name, problem in problems.items()]


def _unstable_lines(
    grasp: Grasp, wrench: RationalVector, document: Mapping[str, Any], rationals_only: bool
) -> Iterator[Line]:
    """Check that the regions are all regions, and that all states that are due are refuted."""
    planes = Planes(*motion_planes(grasp), dimension=3)
    signs, points = _regions(document["regions"], 2 * len(grasp))
    problem = regions_problem(planes, signs, points, rationals_only=rationals_only)
    yield Line("regions", not problem, problem)
    if problem:
        return
    branches = _branches(document["branches"])
    problem = _coverage_problem(planes, signs, list(branches), len(grasp))
    yield Line("states", not problem, problem)
    if problem:
        return
    proven = set() if rationals_only else _proven(grasp, wrench, branches)
    for states, reason in watched(branches.items(), "states"):
        problem = "" if states in proven else _problem(grasp, wrench, states, reason)
        if problem:
            yield Line(f"branch {states}", False, problem)
            return
    yield Line("branches", True)


def _regions(value: Any, planes: int) -> tuple[Rows, list[Point]]:
    """Return the signs and the points of the listed regions."""
    entries = check_list(value, "regions")
    if not (entries and all(type(entry) is list and len(entry) == 5 for entry in entries)):
        entries = [check_list(entry, f"regions[{i}]", 5) for i, entry in enumerate(entries)]
    texts = [entry[0] for entry in entries]
    for i, text in enumerate(texts):
        if not isinstance(text, str) or len(text) != planes or text.strip("+-"):
            raise CertificateError(f"regions[{i}]: the signs must be {planes} of + and -")
    points: list[Point] = [entry[1:] for entry in entries]
    if not {type(x) for point in points for x in point} <= {int}:
        points = [_integers(point, f"regions[{i}]") for i, point in enumerate(points)]
    letters = np.frombuffer("".join(texts).encode("ascii"), dtype=np.uint8)
    signs = np.where(letters == ord("+"), np.int8(1), np.int8(-1)).reshape(len(texts), planes)
    return signs, points


def _integers(values: Sequence[Any], name: str) -> Point:
    numbers = rational_vector(values, name)
    if any(x.denominator != 1 for x in numbers):
        raise CertificateError(f"{name}: the point must be four integers")
    return [x.numerator for x in numbers]


def _branches(value: Any) -> dict[str, Reason]:
    """Return the reasons by the letters of the states."""
    if not isinstance(value, Mapping):
        raise CertificateError("branches must be an object from states to reasons")
    branches: dict[str, Reason] = {}
    for states, reason in value.items():
        if not isinstance(states, str) or states.strip("".join(_CODES)):
            raise CertificateError("branches: states must be texts of the letters d, +, - and 0")
        if isinstance(reason, str):
            branches[states] = reason
        else:
            name = f"branches: {states}"
            check_keys(reason, ("inequalities", "equalities"), (), name)
            y, x = (
                rational_vector(check_list(reason[k], f"{name}: {k}"), name)
                for k in ("inequalities", "equalities")
            )
            branches[states] = (y, x)
    return branches


def _coverage_problem(planes: Planes, signs: Rows, listed: list[str], contacts: int) -> str:
    """Return what is wrong when the branches are not the states that are due, each once."""
    if any(len(states) != contacts for states in listed):
        return "a branch has too few or too many states"
    given, due = sorted_rows(_codes(listed, contacts)), due_states(planes, signs)
    if np.array_equal(given, due):
        return ""
    here, there = set(map(tuple, given.tolist())), set(map(tuple, due.tolist()))
    if there - here:
        return f"the states {_text(min(there - here))} are not refuted"
    return f"the states {_text(min(here - there))} belong to no region"


def _codes(listed: Sequence[str], contacts: int) -> Rows:
    """Return texts of states as rows of numbers."""
    table = np.zeros(128, dtype=np.int8)
    for letter, code in _CODES.items():
        table[ord(letter)] = code
    letters = np.frombuffer("".join(listed).encode("ascii"), dtype=np.uint8)
    rows: Rows = table[letters].reshape(len(listed), contacts)
    return rows


def _text(row: Iterable[int]) -> str:
    letter = {code: letter for letter, code in _CODES.items()}
    return "".join(letter[code] for code in row)


def _proven(grasp: Grasp, wrench: RationalVector, branches: Mapping[str, Reason]) -> set[str]:
    """Return the states whose reason is a name that floating point proves."""
    named = {reason for reason in branches.values() if isinstance(reason, str)}
    known = {name: _named(name, len(grasp)) for name in named}
    chosen = [
        (states, *known[reason])
        for states, reason in branches.items()
        if isinstance(reason, str) and _fits(states, *known[reason])
    ]
    if not chosen:
        return set()
    listed, kinds, contacts = zip(*chosen, strict=True)
    numbers = np.array([KINDS.index(kind) for kind in kinds])
    states = _codes(listed, len(grasp))
    found = proven_violations(grasp, wrench, states, numbers, np.array(contacts))
    return {letters for letters, holds in zip(listed, found.tolist(), strict=True) if holds}


def _fits(states: str, kind: str, contact: int) -> bool:
    return contact >= 0 and states[contact] in _FITTING[kind]


def _named(name: str, contacts: int) -> tuple[str, int]:
    """Return the kind and the contact of a condition; the contact is -1 if there is none such."""
    kind, _, number = name.partition(" ")
    if kind in KINDS and number.isascii() and number.isdecimal() and len(number) < 10:
        contact = int(number)
        if contact < contacts and number == str(contact):
            return kind, contact
    return "", -1


def _problem(grasp: Grasp, wrench: RationalVector, letters: str, reason: Reason) -> str:
    """Return what is wrong with one reason, in rationals."""
    states = [_NAMES[letter] for letter in letters]
    if not isinstance(reason, str):
        return conditions_of(grasp, wrench, states).refutation_problem(*reason)
    kind, contact = _named(reason, len(grasp))
    if not _fits(letters, kind, contact):
        return f"there is no condition {reason} for these states"
    return violation_problem(grasp, wrench, states, kind, contact)
