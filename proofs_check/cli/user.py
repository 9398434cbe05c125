"""``proofs-check run FILE.py``: check the claims of a user's file and save what refutes them."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from arrangement import terminal
from arrangement.io.writing import write_text_atomically
from arrangement.progress import Bar
from proofs_check import user_claim as own, user_run as ownrun
from proofs_check.errors import OwnClaimError
from proofs_check.reports import forms as pages, report
from proofs_check.reports.environment import environment


def run_files(arguments: argparse.Namespace, width: int) -> int:
    """Check every claim of the given files."""
    files = list(dict.fromkeys(arguments.ids))
    if not all(name.endswith(".py") for name in files):
        raise OwnClaimError("ids and files are both given; run the claims of files on their own")
    make = pages.form(Path(arguments.report).suffix) if arguments.report else None
    results, saved = [], []
    for name in files:
        for claim in own.load(name):
            result = _run(_changed(claim, arguments), arguments.seed)
            results.append((name, result))
            saved.append(ownrun.save(result, arguments.save))
    listed = [own_record(name, result) for name, result in results]
    record = report.record_of(listed, arguments.seed, [environment()])
    if make:
        write_text_atomically(arguments.report, make(record))
    if arguments.json:
        terminal.print_json(record)
    else:
        print("\n\n".join(text(*pair, width) for pair in zip(listed, saved, strict=True)))
    return terminal.YES if record["as_expected"] else terminal.NO


def _changed(claim: own.OwnClaim, arguments: argparse.Namespace) -> own.OwnClaim:
    """Return a claim with the numbers that the command line names."""
    if arguments.samples is not None:
        if arguments.samples < 0:
            raise OwnClaimError(f"--samples is {arguments.samples}; it must be at least 0")
        claim = replace(claim, samples=arguments.samples)
    if arguments.census is not None:
        if arguments.census not in (0, *range(3, 9)):
            raise OwnClaimError(f"--census is {arguments.census}; give 3 to 8 planes, or 0")
        if claim.domain.unit == "planes":
            claim = replace(claim, census=arguments.census)
    return claim


def _run(claim: own.OwnClaim, seed: int) -> ownrun.OwnResult:
    bar = Bar(None, f"instances of {claim.id}")
    try:
        return ownrun.run(claim, seed, bar.update)
    finally:
        bar.close()


def own_record(file: str, result: ownrun.OwnResult) -> dict[str, Any]:
    """Return the result of an own claim for JSON, with the keys of every other result."""
    claim, smallest = result.claim, result.smallest
    exhaustive = any(part.kind == "exhaustive" for part in result.parts)
    return {
        "id": claim.id,
        "locator": claim.locator or Path(file).name,
        "statement": claim.statement,
        "hypotheses": list(claim.hypotheses),
        "saving_hypothesis": None,
        "quantity": "whether the function of the file returns True",
        "routes": [f"the function {claim.test.__name__}"],
        "evidence_kind": "exhaustive" if exhaustive and len(result.parts) == 1 else "sampled",
        "over": claim.domain.text,
        "expected": claim.expected.value,
        "meaning": "",
        "verdict": result.verdict.value if result.verdict else None,
        "as_expected": result.as_expected,
        "evidence": evidence(result),
        "rows": False,
        "seed": result.seed,
        "milliseconds": result.milliseconds,
        "searched": result.searched,
        "records": [],
        "table": _table(result),
        "counterexample": _counterexample(smallest) if smallest else None,
    }


def _counterexample(failure: ownrun.Failure) -> dict[str, Any]:
    return {
        "label": failure.label,
        "values": [failure.reason],
        "holds": False,
        "covered": True,
        "note": failure.reason,
        "assumption": "",
        "instance": failure.document,
    }


def _table(result: ownrun.OwnResult) -> dict[str, Any]:
    columns = ["kind", "over", "checked", "failures", "outside the hypotheses"]
    rows = [[p.kind, p.over, p.checked, p.failures, p.passed_over] for p in result.parts]
    return {"columns": columns, "rows": rows}


def evidence(result: ownrun.OwnResult) -> str:
    """Return the evidence in one or two sentences."""
    if not result.checked:
        return "no instance was checked; the hypotheses are true of none"
    parts = [f"{p.kind}: {p.checked} checked, {p.over}" for p in result.parts if p.checked]
    failure = result.smallest
    if failure is not None:
        kind = "the function fails" if failure.broken else "smallest counterexample found"
        instance = report.instance_text(failure.document)
        parts.append(f"{kind} ({result.searched} tried): {instance}: {failure.reason}")
    return "; ".join(parts)


def text(record: dict[str, Any], saved: Path | None, width: int) -> str:
    """Return the result of one claim for the terminal."""
    rows: Sequence[Sequence[str]] = [
        ("statement", record["statement"]),
        *(("hypothesis", entry) for entry in record["hypotheses"]),
        ("verdict", pages.verdict(record)),
        *(("evidence", entry) for entry in record["evidence"].split("; ")),
        *([("saved", str(saved))] if saved else []),
    ]
    return "\n".join([f"{record['id']} ({record['locator']})", *report.table(rows, width, "  ")])
