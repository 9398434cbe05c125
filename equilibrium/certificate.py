"""Certificates of verdicts, and the checker, which shares no code with the solver.

Stable: a motion and forces; the four conditions of equilibrium are evaluated.

Unstable: every face of the motion arrangement (the planes ``T . d = 0``, then
``stiffness N . d = preload``) with sign vector, dimension and a witness point, complete by
Zaslavsky's theorem; and for each choice of contact states that these faces give, multipliers that
combine the conditions of those states to ``0 = -1``. A contact is detached where
``stiffness N . d >= preload``, else slip+, slip- or stick by the sign of ``T . d``. The conditions,
in the order of the multipliers, in the unknowns d and one tangential force for each sticking
contact:

* equalities: balance of force x, force y, torque; then ``T . d = 0`` for each sticking contact;
* inequalities (``>= 0``), contact by contact: detached: ``stiffness N . d - preload``. Otherwise
  the normal force ``c_n = preload - stiffness N . d``, and then for slip ``T . d`` or ``-T . d``,
  for stick ``friction c_n - c_t`` and ``friction c_n + c_t``.

A SHA-256 digest of the canonical content guards what mathematics alone would let pass, such as
another witness in the same face.
"""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from arrangement.certify import certify_complete
from arrangement.exact import RationalVector, rational_vector, to_text
from arrangement.files import check_keys, check_list
from arrangement.planes import Arrangement, Face

from .conditions import Conditions, conditions_of, label_of, motion_planes
from .errors import CertificateError
from .grasp import Grasp, read_wrench

#: One refuted choice: states, multipliers of the inequalities, multipliers of the equalities.
Branch: TypeAlias = tuple[tuple[str, ...], RationalVector, RationalVector]

SCHEMA_VERSION = 1
_COMMON = ("schema_version", "certificate", "grasp", "wrench", "digest")
_KEYS = {"stable": ("motion", "forces"), "unstable": ("faces", "branches")}
_SYMBOLS = {"+": 1, "0": 0, "-": -1}


@dataclass(frozen=True)
class Certificate:
    """A proof of a verdict, as a document. `to_dict` gives a fresh copy."""

    text: str

    @property
    def kind(self) -> str:
        """Either "stable" or "unstable"."""
        return str(json.loads(self.text)["certificate"])

    def to_dict(self) -> dict[str, Any]:
        """Return the JSON document."""
        document: dict[str, Any] = json.loads(self.text)
        return document

    def verify(self) -> Report:
        """Check the certificate; see `check`."""
        return check(self.to_dict())


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


def stable_certificate(
    grasp: Grasp,
    wrench: RationalVector,
    motion: RationalVector,
    forces: Iterable[tuple[Fraction, Fraction]],
) -> Certificate:
    """Return the certificate of an equilibrium."""
    content = {"motion": _texts(motion), "forces": [_texts(pair) for pair in forces]}
    return _certificate("stable", grasp, wrench, content)


def unstable_certificate(
    grasp: Grasp, wrench: RationalVector, faces: Iterable[Face], branches: Iterable[Branch]
) -> Certificate:
    """Return the certificate that no equilibrium exists."""
    symbol = {sign: text for text, sign in _SYMBOLS.items()}
    content = {
        "faces": [
            {
                "signs": "".join(symbol[s] for s in face.signs),
                "dimension": face.dimension,
                "witness": _texts(face.witness),
            }
            for face in faces
        ],
        "branches": [
            {"states": list(states), "inequalities": _texts(y), "equalities": _texts(x)}
            for states, y, x in branches
        ],
    }
    return _certificate("unstable", grasp, wrench, content)


def digest(document: Mapping[str, Any]) -> str:
    """Return the SHA-256 of a document without its digest, in canonical JSON."""
    content = {key: value for key, value in document.items() if key != "digest"}
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    return hashlib.sha256(text.encode("ascii")).hexdigest()


def check(
    document: Mapping[str, Any], question: tuple[Grasp, RationalVector] | None = None
) -> Report:
    """Check a certificate document line by line, in rationals; stop at the first wrong line.

    Args:
        document: as `Certificate.to_dict` gives it, or as read from a file.
        question: if given, the grasp and wrench that the certificate has to be about.

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
    found = _stable_lines if kind == "stable" else _unstable_lines
    lines += found(grasp, wrench, document)
    return Report(kind, tuple(lines))


def _certificate(
    kind: str, grasp: Grasp, wrench: RationalVector, content: dict[str, Any]
) -> Certificate:
    document = {
        "schema_version": SCHEMA_VERSION,
        "certificate": kind,
        "grasp": grasp.to_dict(),
        "wrench": _texts(wrench),
        **content,
    }
    document["digest"] = digest(document)
    return Certificate(json.dumps(document))


def _texts(vector: Iterable[Fraction]) -> list[str]:
    return [to_text(x) for x in vector]


def _kind(document: Mapping[str, Any]) -> str:
    """Check version, kind and keys of a document; return the kind."""
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
    grasp: Grasp, wrench: RationalVector, document: Mapping[str, Any]
) -> list[Line]:
    """Check that the faces are all faces, and that each of their states is refuted."""
    faces = [
        _face(entry, f"faces[{i}]")
        for i, entry in enumerate(check_list(document["faces"], "faces"))
    ]
    evidence = certify_complete(_planes(grasp), faces)
    lines = [Line("faces", evidence.complete, "; ".join(evidence.problems[:1]))]
    if not evidence.complete:
        return lines
    due = {label_of(face.signs) for face in faces}
    branches = [_branch(e, i) for i, e in enumerate(check_list(document["branches"], "branches"))]
    listed = [states for states, _, _ in branches]
    lines.append(_coverage(due, listed))
    for i, (states, y, x) in enumerate(branches):
        if not lines[-1].holds:
            break
        problem = conditions_of(grasp, wrench, states).refutation_problem(y, x)
        lines.append(Line(f"branch {i} ({' '.join(states)})", not problem, problem))
    return lines


def _planes(grasp: Grasp) -> Arrangement:
    normals, offsets = motion_planes(grasp)
    return Arrangement(normals, offsets, dimension=3)


def _coverage(due: set[tuple[str, ...]], listed: Sequence[tuple[str, ...]]) -> Line:
    """Check that the branches are the states of the faces, each once."""
    missing, extra = sorted(due - set(listed)), sorted(set(listed) - due)
    if missing:
        return Line("states", False, f"the states {' '.join(missing[0])} are not refuted")
    if extra:
        return Line("states", False, f"the states {' '.join(extra[0])} belong to no face")
    return Line("states", len(listed) == len(due), "a branch is listed twice")


def _face(entry: Any, name: str) -> Face:
    check_keys(entry, ("signs", "dimension", "witness"), (), name)
    signs, dimension = entry["signs"], entry["dimension"]
    if not isinstance(signs, str) or set(signs) - _SYMBOLS.keys():
        raise CertificateError(f"{name}: signs must be a text of +, 0 and -")
    if type(dimension) is not int or not 0 <= dimension <= 3:
        raise CertificateError(f"{name}: dimension must be an integer from 0 to 3")
    witness = rational_vector(check_list(entry["witness"], f"{name}: witness", 3), name)
    return Face(tuple(_SYMBOLS[s] for s in signs), dimension, witness)


def _branch(entry: Any, index: int) -> Branch:
    name = f"branches[{index}]"
    check_keys(entry, ("states", "inequalities", "equalities"), (), name)
    states = check_list(entry["states"], f"{name}: states")
    if not all(isinstance(state, str) for state in states):
        raise CertificateError(f"{name}: states must be texts")
    vectors = (
        rational_vector(check_list(entry[k], f"{name}: {k}"), name)
        for k in ("inequalities", "equalities")
    )
    y, x = vectors
    return tuple(states), y, x
