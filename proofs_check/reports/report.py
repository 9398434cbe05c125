"""Reports of results: a table for the terminal, and the JSON record.

The JSON record is complete: every case with the values of both routes side by side. Markdown,
HTML and LaTeX are made from it in `pages`.
"""

from __future__ import annotations

import json
import os
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from arrangement.exact import to_text
from arrangement.io.writing import write_text_atomically
from proofs_check.claim import Claim, Evidence, Failure, Record, Result
from proofs_check.errors import ClaimError

from . import forms as pages
from .environment import environment

SCHEMA_VERSION = 1


def verdict_text(result: Result) -> str:
    """Return the verdict in words; results without one say so, unexpected ones say that."""
    text = result.verdict.value if result.verdict else "no verdict"
    return text if result.as_expected else f"{text} (expected: {result.claim.expected.value})"


def evidence_text(result: Result) -> str:
    """Return the evidence in one or two sentences."""
    evidence = result.evidence
    parts = [f"{evidence.kind.value}: {_number(len(evidence.records), 'case')}, {evidence.over}"]
    if evidence.kind.value == "sampled":
        parts[0] += f", seed {evidence.seed}"
    if not evidence.records:
        parts = ["no case was checked"]
    if result.verdict is None and evidence.disagreement is not None:
        record = evidence.disagreement
        first, second = (value_text(value, 60) for value in record.values)
        parts.append(f"the routes disagree on {record.label}: {first} and {second}")
        return "; ".join(parts)
    parts.extend(sorted({f"assuming {r.assumption}" for r in evidence.records if r.assumption}))
    if evidence.counterexample is not None:
        parts.append(_counterexample_text(result.claim, evidence, evidence.counterexample))
    return "; ".join(parts)


def _counterexample_text(claim: Claim, evidence: Evidence, record: Record) -> str:
    where = f"holds when {claim.hypothesis.text}; " if claim.hypothesis else ""
    if claim.hypothesis and record.covered:
        where = f"fails even when {claim.hypothesis.text}; "
    smallest = "smallest counterexample" if evidence.searched else "counterexample"
    return f"{where}{smallest}: {record.label}, {instance_text(record.document)}".rstrip(", ")


def instance_text(document: Mapping[str, Any] | None) -> str:
    """Return an instance in one line."""
    if document is None:
        return ""
    if "planes" in document:
        rows = " ".join(f"({','.join(row)})" for row in document["planes"])
        offsets = document.get("offsets")
        return f"planes {rows}" + (f" offsets ({','.join(offsets)})" if offsets else "")
    if "contacts" in document:
        contacts = "; ".join(_contact_text(contact) for contact in document["contacts"])
        wrench = document.get("wrench")
        return contacts + (f"; wrench ({','.join(wrench)})" if wrench else "")
    return json.dumps(document)


def _contact_text(contact: Mapping[str, Any]) -> str:
    point, normal = (f"({','.join(contact[key])})" for key in ("point", "normal"))
    rest = [f"mu={contact['friction']}"]
    if contact.get("preload", "0") != "0":
        rest.append(f"preload={contact['preload']}")
    if contact.get("stiffness", "1") != "1":
        rest.append(f"k={contact['stiffness']}")
    return f"contact at {point} normal {normal} {' '.join(rest)}"


def value_text(value: Any, limit: int = 0) -> str:
    """Return a value of a route as text: rationals in full, sequences in parentheses."""
    if isinstance(value, bool) or value is None or isinstance(value, str):
        text = str(value)
    elif isinstance(value, (int, Fraction)):
        text = to_text(value)
    elif isinstance(value, (tuple, list)):
        text = f"({', '.join(value_text(item) for item in value)})"
    elif isinstance(value, (set, frozenset)):
        text = f"{{{', '.join(sorted(value_text(item) for item in value))}}}"
    else:
        text = str(value)
    return text if not limit or len(text) <= limit else f"{text[: limit - 3]}..."


def rows_text(result: Result, width: int = 100) -> str:
    """Return every case of a result as a table: label, values of both routes, remark."""
    lines = [f"{result.claim.id} ({result.claim.locator}): {verdict_text(result)}"]
    names = [route.name for route in result.claim.routes]
    lines += textwrap.wrap(
        f"{result.claim.quantity}: by {names[0]} | by {names[1]}", width, initial_indent="  "
    )
    cells = [
        ("ok " if r.holds else "no ", r.label, *(value_text(v, 60) for v in r.values), _remark(r))
        for r in result.evidence.records
    ]
    lines += table(cells, width, indent="  ")
    return "\n".join(lines)


def _remark(record: Record) -> str:
    return "; ".join(text for text in (record.note, record.assumption) if text)


def table(rows: Sequence[Sequence[str]], width: int, indent: str = "") -> list[str]:
    """Align columns with two spaces between; the last column wraps to the width.

    When the last column would be left with less than 24 characters, it goes to lines of its own.
    """
    if not rows:
        return []
    columns = len(rows[0])
    widths = [max(len(row[j]) for row in rows) for j in range(columns - 1)]
    start = len(indent) + sum(widths) + 2 * (columns - 1)
    beside = width - start >= 24
    lines = []
    for row in rows:
        left = indent + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=False))
        hang = " " * (start if beside else len(indent) + 4)
        wrapped = textwrap.wrap(row[-1], max(width - len(hang), 24), break_on_hyphens=False)
        if beside:
            lines.append(f"{left}  {wrapped[0] if wrapped else ''}".rstrip())
            lines += [hang + text for text in wrapped[1:]]
        else:
            lines.append(left.rstrip())
            lines += [hang + text for text in wrapped]
    return lines


def text_report(results: Sequence[Result], width: int = 100) -> str:
    """Return the report for the terminal: the tables row by row, then one verdict a claim."""
    blocks = [rows_text(result, width) for result in results if result.claim.rows]
    rows = [(r.claim.id, r.claim.locator, verdict_text(r), evidence_text(r)) for r in results]
    widest = max((sum(map(len, row[:3])) for row in rows), default=0)
    if widest + 6 + 24 > width:
        rows_short = [(f"{a}", f"{c}", f"[{b}] {d}") for a, b, c, d in rows]
        blocks.append("\n".join(table(rows_short, width)))
    else:
        blocks.append("\n".join(table(rows, width)))
    blocks.append(summary_text(results))
    return "\n\n".join(blocks)


def summary_text(results: Sequence[Result]) -> str:
    """Return how many verdicts there are of each kind, and which are not the expected ones."""
    counts: dict[str, int] = {}
    for result in results:
        name = result.verdict.value if result.verdict else "no verdict"
        counts[name] = counts.get(name, 0) + 1
    kinds = ", ".join(f"{number} {name}" for name, number in counts.items())
    different = [result.claim.id for result in results if not result.as_expected]
    end = f"not as expected: {', '.join(different)}" if different else "all as expected"
    return f"{_number(len(results), 'claim')}: {kinds}; {end}"


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
        "expected": claim.expected.value,
        "meaning": claim.meaning,
    }


def result_record(result: Result) -> dict[str, Any]:
    """Return a result for JSON, with the values of both routes for every case."""
    evidence = result.evidence
    smallest = evidence.counterexample
    return {
        **claim_record(result.claim),
        "verdict": result.verdict.value if result.verdict else None,
        "as_expected": result.as_expected,
        "evidence": evidence_text(result),
        "rows": result.claim.rows,
        "seed": evidence.seed,
        "milliseconds": result.milliseconds,
        "searched": evidence.searched,
        "records": [_record(record) for record in evidence.records],
        "counterexample": _record(smallest) if smallest else None,
    }


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
    if isinstance(value, (set, frozenset)):
        return sorted((plain(item) for item in value), key=json.dumps)
    if isinstance(value, (tuple, list)):
        return [plain(item) for item in value]
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    raise ClaimError(f"a route gave a {type(value).__name__}, which has no form in a report")


def json_record(results: Iterable[Result], seed: int) -> dict[str, Any]:
    """Return the complete record of a run."""
    return record_of([result_record(result) for result in results], seed, [environment()])


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


def write_report(path: str | os.PathLike[str], results: Sequence[Result], seed: int) -> None:
    """Write a report in the form that the ending of the name says: see `pages.FORMS`, else text.

    The file is written whole or not at all.
    """
    make = pages.FORMS.get(Path(path).suffix.lower())
    text = make(json_record(results, seed)) if make else text_report(results) + "\n"
    write_text_atomically(path, text)


def _number(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
