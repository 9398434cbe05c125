"""The JSON record of a run: claims, evidence in words, cases, versions, and a digest of all.

Each form of a report is made from it alone: text in `text`, Markdown in `forms`, HTML in `page`.
"""

from __future__ import annotations

import json
import os
import platform
import re
import subprocess
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from fractions import Fraction
from functools import lru_cache
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from importlib.resources import files
from pathlib import Path
from typing import Any

from arrangement.console.number_form import counted
from arrangement.numbers.exact import rational, sum_of_powers, to_text
from proofs_check.errors import ClaimError
from proofs_check.routes.proved import COUNTS
from proofs_check.statements.evidence import Evidence, Failure, Part, Record, Result
from proofs_check.statements.statement import Claim, Kind, Strength

from .text import value_text

LIBRARIES = ("slipstates", "networkx", "numpy", "scipy", "sympy")


@lru_cache(maxsize=1)
def environment() -> dict[str, Any]:
    """Return the versions and the commit as a record for JSON."""
    return {
        "python": platform.python_version(),
        "versions": {name: _version(name) for name in LIBRARIES},
        "commit": commit(Path(__file__).resolve().parents[2]),
    }


def date() -> str:
    """Return the time in UTC, or that of SOURCE_DATE_EPOCH, for builds that repeat."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    seconds = int(epoch) if epoch.isdecimal() and len(epoch) < 12 else time.time()
    return datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


def commit(folder: Path) -> str | None:
    """Return the commit of a checkout, with "+changes" when files differ from it.

    None when `folder` is not the top of a git checkout (an installed package, even one that was
    installed inside some other project's checkout) or git cannot be run.
    """
    top = _git(folder, "rev-parse", "--show-toplevel")
    if top is None or Path(top).resolve() != folder.resolve():
        return None
    head = _git(folder, "rev-parse", "HEAD")
    changes = _git(folder, "status", "--porcelain", "--untracked-files=no")
    return f"{head}+changes" if head and changes else head


def _git(folder: Path, *arguments: str) -> str | None:
    try:
        done = subprocess.run(
            ["git", "-C", str(folder), *arguments],
            capture_output=True,
            text=True,
            timeout=10,
            check=True,
        )
    except (OSError, subprocess.SubprocessError):
        return None
    return done.stdout.strip()


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


SCHEMA_VERSION = 1


def evidence_text(result: Result) -> str:
    """Return the evidence in one or two sentences."""
    evidence = result.evidence
    parts = [_part_text(part, result) for part in evidence.parts if part.checked]
    if not evidence.records:
        parts = ["no case was checked"]
    if evidence.disagreement is not None:
        return "; ".join([*parts, _disagreement_text(evidence.disagreement)])
    parts.extend(sorted({f"assuming {r.assumption}" for r in evidence.records if r.assumption}))
    if evidence.counterexample is not None:
        parts.append(_counterexample_text(result, evidence.counterexample))
    return "; ".join(parts)


def theorem(name: str) -> str:
    """Return the statement of a theorem about every number of planes, as Coq has it.

    >>> print(theorem("step_1_square_bound"))
    Theorem step_1_square_bound : forall planes n, great_circles planes -> 2 <= size planes ->
      number (region planes) n ->
      n <= size planes * size planes.
    """
    return theorems()[name]


@lru_cache(maxsize=1)
def theorems() -> dict[str, str]:
    """Return the statements of all theorems for claims, by name.

    Of those alone whose axioms `make formal` prints and compares.
    """
    folder = files("proofs_check").joinpath("formal")
    source, printed = (
        folder.joinpath(*path).read_text(encoding="utf-8")
        for path in (("claims", "Claims.v"), ("Extract.v",))
    )
    stated = (f"Theorem {text}" for text in source.split("\nTheorem ")[1:])
    named = {text.split()[1]: text.partition("Proof.")[0].strip() for text in stated}
    known = set(re.findall(r"\w+", printed.partition("Definition theorems := (")[2]))
    return {name: text for name, text in named.items() if name in known}


def badges(claim: Claim, evidence: Evidence | None = None) -> list[dict[str, Any]]:
    """Return what of a claim is a theorem, and that the verified program took part, if it did.

    Nothing here can be set: theorems are looked up in the sources of the proofs, and the program's
    counts among the values that this evidence has.

    >>> from proofs_check import registry
    >>> [badge["names"] for badge in badges(registry()["step-1-square-bound"])]
    [['theorem step_1_square_bound'], ['theorem step_1_square_bound_needs_two_planes']]
    """
    known = theorems()
    stated = [] if claim.file else [name for name in claim.theorems if name in known]
    general = [
        name for name in stated if re.search(r"forall [\w ]*\b(planes|contacts)\b", known[name])
    ]
    others = [name for name in stated if name not in general]
    shown = [
        {"names": [f"theorem {name}" for name in names], "meaning": meaning}
        for names, meaning in (
            (general, "for every number of planes, checked by Coq"),
            (others, "a counterexample, computed inside a proof that Coq checked"),
        )
        if names
    ]
    ways = [route.compute for route in claim.routes]
    agreed = 0
    if evidence and (compute := COUNTS.get(claim.id)) in ways:
        place = ways.index(compute)
        agreed = sum(r.agree and r.values[place] is not NotImplemented for r in evidence.records)
    if evidence and agreed:
        number = f"{agreed} of {counted(len(evidence.records), 'case')}"
        meaning = f"the same value in {number}; that it counts right is a theorem in Coq"
        shown.append({"names": ["counted by the verified program"], "meaning": meaning})
    return shown


def _proof_text(claim: Claim) -> str:
    """Return where the proof of a claim is: in Coq, in prose, or in both."""
    prose = "in prose (docs, Proofs)"
    if not claim.theorems:
        return f"proof {prose}"
    return f"proof in Coq and {prose}: {claim.prose}" if claim.prose else "proof in Coq"


def _part_text(part: Part, result: Result) -> str:
    outside = {"outside the domain": part.foreign, "outside the hypotheses": part.passed_over}
    beyond = ", ".join(f"{n} more {where}" for where, n in outside.items() if n)
    beyond = f" ({beyond})" if beyond else ""
    cases = f"{counted(part.checked, 'case')}{beyond}"
    if part.kind is Kind.PROVED:
        return f"{_proof_text(result.claim)}; {cases}: {part.over}"
    if part.kind is Kind.EXHAUSTIVE:
        return f"{f'the one case{beyond}' if part.checked == 1 else f'all {cases}'}: {part.over}"
    return f"{counted(part.checked, 'sample')}{beyond}: {part.over}, seed {result.evidence.seed}"


def _disagreement_text(record: Record) -> str:
    if len(record.values) == 1:
        return f"the function fails on {instance_text(record.document)}: {record.note}"
    values = " and ".join(value_text(plain(value), 160) for value in record.values)
    case = ", ".join(filter(None, (record.label, instance_text(record.document))))
    return f"the implementations disagree on {case}: {values}"


def _counterexample_text(result: Result, record: Record) -> str:
    claim, evidence = result.claim, result.evidence
    if claim.smaller:
        tried = counted(evidence.searched, "smaller instance")
        head = f"smallest counterexample found ({tried} tried)"
        return f"{head}: {instance_text(record.document)}: {record.note}"
    true = "no counterexample found" if result.strength is Strength.SAMPLED else "holds"
    condition = f"{true} when {claim.hypothesis.text}; " if claim.hypothesis else ""
    if claim.hypothesis and record.covered:
        condition = f"fails even when {claim.hypothesis.text}; "
    shown = f"{record.label}, {instance_text(record.document)}".rstrip(", ")
    if evidence.searched:
        tried = f"try {evidence.searched} of a search from the smallest"
        return f"{condition}smallest counterexample: {shown} ({tried})"
    remark = f": {record.note}" if record.note and len(record.values) == 1 else ""
    return f"{condition}counterexample among these cases: {shown}{remark}"


def instance_text(document: Mapping[str, Any] | None) -> str:
    """Return an instance in one line."""
    if document is None:
        return ""
    if document.get("planes"):
        rows = " ".join(_row(row) for row in document["planes"])
        offsets = document.get("offsets")
        kind = "lines" if len(document["planes"][0]) == 2 else "planes"
        of = f", where {_field_text(document['field'])}" if "field" in document else ""
        return f"{kind} {rows}" + (f" offsets {_row(offsets)}" if offsets else "") + of
    if "pseudolines" in document:
        return f"{document['pseudolines']} pseudolines {value_text(document['chirotope'])}"
    if "contacts" in document:
        contacts = ", ".join(_contact_text(contact) for contact in document["contacts"])
        wrench = document.get("wrench")
        return contacts + (f", wrench {_row(wrench)}" if wrench else "")
    return ""


def _row(numbers: Iterable[Any]) -> str:
    entries = (_polynomial_text(x) if isinstance(x, list) else value_text(x) for x in numbers)
    return f"({','.join(entries)})"


def _polynomial_text(coefficients: Iterable[str]) -> str:
    """Return a polynomial in a: of numbers of a field by its root.

    >>> _polynomial_text(["-1", "1"]), _polynomial_text(["0", "-1", "3/2"])
    ('-1+a', '-a+3/2a^2')
    """
    terms = enumerate(map(rational, coefficients))
    return sum_of_powers(terms, times="", factor=lambda x: value_text(to_text(x))).replace(" ", "")


def _field_text(field: Mapping[str, Any]) -> str:
    low, high = map(value_text, field["interval"])
    return f"{_polynomial_text(field['minimal_polynomial'])} = 0 and {low} < a < {high}"


def _contact_text(contact: Mapping[str, Any]) -> str:
    point, normal = (_row(contact[key]) for key in ("point", "normal"))
    rest = [f"mu={value_text(contact['friction'])}"]
    if contact.get("preload", "0") != "0":
        rest.append(f"preload={value_text(contact['preload'])}")
    if contact.get("stiffness", "1") != "1":
        rest.append(f"k={value_text(contact['stiffness'])}")
    if contact.get("adhesion", "0") != "0":
        rest.append(f"adhesion={value_text(contact['adhesion'])}")
    return f"contact at {point} normal {normal} {' '.join(rest)}"


def claim_record(claim: Claim) -> dict[str, Any]:
    """Return what a claim says and how it is checked, for JSON."""
    return {
        "id": claim.id,
        "locator": claim.locator,
        "statement": claim.statement,
        "hypotheses": list(claim.hypotheses),
        "saving_hypothesis": claim.hypothesis.text if claim.hypothesis else None,
        "quantity": claim.quantity,
        "routes": [route.name for route in claim.routes],
        "evidence_kind": claim.kind.value,
        "over": claim.over,
        "domain": claim.domain_text,
        "expected": claim.expected.value,
        "expectation_stated": claim.expectation_stated,
        "meaning": claim.meaning,
        "formula": claim.formula,
        "section": claim.section,
        "proof": list(claim.proof) if claim.proof else None,
        "theorems": list(claim.theorems),
        "prose": claim.prose,
        "badges": badges(claim),
        "file": claim.file,
        "views": [plain(asdict(view)) for view in claim.views],
    }


def result_record(result: Result) -> dict[str, Any]:
    """Return a result for JSON, with the values of all routes for every case."""
    evidence = result.evidence
    smallest = evidence.counterexample
    return {
        **claim_record(result.claim),
        "badges": badges(result.claim, evidence),
        "verdict": result.verdict.value if result.verdict else None,
        **conclusion(result.strength, result.tried, result.added_hypotheses),
        "as_expected": result.as_expected,
        "evidence": evidence_text(result),
        "rows": result.claim.rows,
        "seed": evidence.seed,
        "milliseconds": result.milliseconds,
        "searched": evidence.searched,
        "records": [_record(record) for record in evidence.records],
        "counterexample": _record(smallest) if smallest else None,
        **_table(evidence.parts),
    }


def conclusion(
    strength: Strength | None, tried: int, added_hypotheses: Iterable[str]
) -> dict[str, Any]:
    """Return the word of an answer for JSON, with the numbers and hypotheses that belong to it."""
    return {
        "strength": strength.value if strength else None,
        "tried": tried,
        "added_hypotheses": list(added_hypotheses),
    }


def _table(parts: tuple[Part, ...]) -> dict[str, Any]:
    """Return the numbers of each source, where there are several."""
    if len(parts) < 2:
        return {}
    outside = ("outside the domain", "outside the hypotheses")
    columns = ["kind", "over", "checked", "failures", *outside]
    rows = [[p.kind.value, p.over, p.checked, p.failures, p.foreign, p.passed_over] for p in parts]
    return {"table": {"columns": columns, "rows": rows}}


def _record(record: Record) -> dict[str, Any]:
    return {
        "label": record.label,
        "values": [plain(value) for value in record.values],
        "holds": record.holds,
        "covered": record.covered,
        "note": record.note,
        "assumption": record.assumption,
        "instance": record.document,
    }


def plain(value: Any) -> Any:
    """Return a value of a route as JSON: rationals as text, sets in order."""
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, Fraction):
        return to_text(value)
    if isinstance(value, Failure):
        return {"error": value.text}
    if value is NotImplemented:
        return {"unanswered": "beyond this route"}
    if isinstance(value, (set, frozenset)):
        return sorted((plain(item) for item in value), key=json.dumps)
    if isinstance(value, (tuple, list)):
        return [plain(item) for item in value]
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    raise ClaimError(f"a route gave a {type(value).__name__}, which has no form in a report")


def digest(record: Mapping[str, Any]) -> str:
    """Return the SHA-256 of what a record found: the same command gives it again.

    It is over statements, cases, values and verdicts; times, dates, versions and the paths of files
    are left out.
    """
    results = [
        {k: v for k, v in result.items() if k not in ("file", "milliseconds")}
        for result in record["results"]
    ]
    return sha256(json.dumps(results, sort_keys=True).encode()).hexdigest()


def run_facts(record: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return date, seed, commit, versions and digest of a run, for each form of a report."""
    facts = [("date", record["date"])] if record.get("date") else []
    facts.append(("seed", str(record["seed"])))
    for entry in record["environments"]:
        facts.append(("commit", entry["commit"] or "unknown"))
        versions = ", ".join(f"{name} {number}" for name, number in entry["versions"].items())
        facts.append(("with", f"Python {entry['python']}, {versions}"))
    return [*facts, ("SHA-256", digest(record))]


def json_record(
    results: list[dict[str, Any]],
    seed: int,
    title: str = "",
    about: str = "",
    command: str = "",
    left_out: Sequence[str] = (),
) -> dict[str, Any]:
    """Return the complete record of a run.

    Args:
        results: their records, in order.
        seed: of the random instances.
        title, about: what was checked, and where it stands.
        command: that repeats the run.
        left_out: claims that take minutes, and were not asked for.
    """
    record = record_of(results, seed, [environment()])
    record |= {"title": title, "about": about, "command": command, "date": date()}
    return record | ({"left_out": list(left_out)} if left_out else {})


#: What every result of a record has, in each form of a report.
_OF_RESULT: Mapping[str, type | tuple[type, ...]] = {
    **dict.fromkeys(("id", "locator", "statement", "quantity", "expected", "evidence"), str),
    **dict.fromkeys(("hypotheses", "routes", "records"), list),
    "meaning": (str, type(None)),
    "verdict": (str, type(None)),
    "as_expected": bool,
    "rows": bool,
}


def check_record(record: Mapping[str, Any]) -> None:
    """Check that a record from a file has what every form of a report needs.

    Raises:
        LookupError, TypeError: it is not complete.
    """
    entries = [record[name] for name in ("results", "environments")]
    if not all(isinstance(entry, list) for entry in entries) or type(record["seed"]) is not int:
        raise TypeError("the results and environments are lists, and the seed is an integer")
    if type(record["as_expected"]) is not bool:
        raise TypeError("whether all is as expected is true or false")
    for result in record["results"]:
        for name, kind in _OF_RESULT.items():
            if not isinstance(result[name], kind):
                raise TypeError(f"{name} is a {type(result[name]).__name__}")


def record_of(
    results: list[dict[str, Any]], seed: int, environments: list[dict[str, Any]]
) -> dict[str, Any]:
    """Return a record with the results of any kind of run, and with what they were found."""
    return {
        "schema_version": SCHEMA_VERSION,
        "seed": seed,
        "environments": environments,
        "as_expected": all(result["as_expected"] for result in results),
        "results": results,
    }
