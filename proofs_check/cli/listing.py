"""The commands list and new: claims and files of claims, without checking any."""

from __future__ import annotations

import argparse
import shlex
import shutil
import sys
import textwrap
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

from arrangement.console import terminal
from arrangement.console.writing import write_text_atomically
from proofs_check import claims
from proofs_check.errors import OwnClaimError
from proofs_check.reports import text

if TYPE_CHECKING:
    from proofs_check.statements.statement import Claim


def list_claims(arguments: argparse.Namespace) -> int:
    """List the claims of the paper or of a file, or describe one claim."""
    if arguments.source is None and not arguments.json:
        entries = claims.entries().items()
        words = ((id, entry["locator"], entry["statement"]) for id, (_, entry) in entries)
        rows: list[Sequence[str]] = [tuple(map(claims.plain, row)) for row in words]
        _print_table(rows)
        return terminal.YES
    # What loads the claims of the paper takes longer.
    from proofs_check.own_claims import claim_file
    from proofs_check.reports import report

    file, id = claim_file.split(arguments.source) if arguments.source else (None, "")
    if id:
        entry = claim_file.claims_named(arguments.source)[0] if file else claims.registry()[id]
        if arguments.json:
            terminal.print_json(report.claim_record(entry))
        else:
            print(_description(entry, width()))
        return terminal.YES
    known = list(claim_file.claims_named(arguments.source) if file else claims.registry())
    if arguments.json:
        terminal.print_json({"claims": [report.claim_record(claim) for claim in known]})
    else:
        rows = [(claim.id, claim.locator, claim.statement) for claim in known]
        _print_table(rows)
    return terminal.YES


def _print_table(rows: Sequence[Sequence[str]]) -> None:
    """Print claims, in a pipe a line each."""
    print("\n".join(text.table(rows, width() if sys.stdout.isatty() else sys.maxsize)))


def _description(claim: Claim, width: int) -> str:
    from proofs_check.reports import report

    entries = [
        ("id", claim.id),
        ("locator", claim.locator),
        ("statement", claim.statement),
        *(("hypothesis", entry) for entry in claim.hypotheses),
        ("quantity", claim.quantity),
        *((f"computed {i}", route.name) for i, route in enumerate(claim.routes, 1)),
        *(("evidence", f"{source.kind.value}: {source.over}") for source in claim.sources),
        ("expected", claim.expected.value),
        ("added", claim.hypothesis.text if claim.hypothesis else ""),
        ("meaning", claim.meaning),
        *(("proved", text.badge_text(badge)) for badge in report.badges(claim)),
        (
            "in prose",
            claim.prose or ("" if claim.theorems or not claim.proof else "the whole proof"),
        ),
    ]
    lines = []
    for name, entry in entries:
        if entry:
            lines += textwrap.wrap(f"{name:<12}{entry}", width, subsequent_indent=" " * 12)
    if claim.theorems:
        lines += ["in Coq (docs, Formal verification):", *map(report.theorem, claim.theorems)]
    return "\n".join(lines)


def new_file(arguments: argparse.Namespace) -> int:
    """Write a file with two claims to begin with, or an example; refuse to replace a file."""
    path = Path(arguments.name)
    if not path.name:
        raise OwnClaimError(f"{path} names no file; give a name such as mypaper")
    path = path if path.suffix == ".py" else path.with_name(f"{path.name}.py")
    if path.exists():
        raise OwnClaimError(f"{path} is there already; choose another name")
    example = files("proofs_check.examples").joinpath(f"{arguments.example}.py")
    begun = example.read_text(encoding="utf-8")
    write_text_atomically(path, begun.replace("FILE.py", str(path)))
    if arguments.json:
        terminal.print_json({"output": str(path)})
    else:
        print(
            f"{path} is written; check its claims with: proofs-check run {shlex.quote(str(path))}"
        )
    return terminal.YES


def width() -> int:
    """Return the width to write for: of the terminal, at least 60 characters, at most 160."""
    return min(max(shutil.get_terminal_size((110, 24)).columns, 60), 160)
