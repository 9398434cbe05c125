"""The commands on claims: list, show, and run, for the paper's and for those in files."""

from __future__ import annotations

import argparse
import json
import shlex
import shutil
import textwrap
from collections.abc import Iterator
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

from arrangement import terminal
from arrangement.io.writing import write_text_atomically
from arrangement.progress import Bar, shown
from proofs_check import claim_file, claims, user_claim
from proofs_check.errors import OwnClaimError
from proofs_check.evidence import Result, evaluate
from proofs_check.reports import forms, report, text
from proofs_check.statement import Claim, Kind


def list_claims(arguments: argparse.Namespace) -> int:
    """List the claims of the paper."""
    known = list(claims.registry())
    if arguments.json:
        terminal.print_json({"claims": [report.claim_record(claim) for claim in known]})
    else:
        rows = [(claim.id, claim.locator, claim.statement) for claim in known]
        print("\n".join(text.table(rows, _width())))
    return terminal.YES


def show_claim(arguments: argparse.Namespace) -> int:
    """Say what one claim states and how it is checked."""
    claim = claims.registry()[arguments.id]
    if arguments.json:
        terminal.print_json(report.claim_record(claim))
    else:
        print(_described(claim, _width()))
    return terminal.YES


def _described(claim: Claim, width: int) -> str:
    entries = [
        ("id", claim.id),
        ("locator", claim.locator),
        ("statement", claim.statement),
        *(("hypothesis", entry) for entry in claim.hypotheses),
        ("quantity", claim.quantity),
        *((f"route {i}", route.name) for i, route in enumerate(claim.routes, 1)),
        *(("evidence", f"{source.kind.value}: {source.over}") for source in claim.sources),
        ("expected", claim.expected.value),
        ("holds when", claim.hypothesis.text if claim.hypothesis else ""),
        ("meaning", claim.meaning),
    ]
    lines = []
    for name, entry in entries:
        if entry:
            lines += textwrap.wrap(f"{name:<12}{entry}", width, subsequent_indent=" " * 12)
    return "\n".join(lines)


def run_claims(arguments: argparse.Namespace) -> int:
    """Check claims: those of the paper with the given ids, or all claims of the given files."""
    names = list(dict.fromkeys(arguments.ids))
    make = forms.form(Path(arguments.report).suffix) if arguments.report else None
    from_files = any(name.endswith(".py") for name in names)
    if from_files:
        chosen = list(_own_claims(names, arguments))
    else:
        known = claims.registry()
        chosen = [known[id] for id in names] or [claim for claim in known if not claim.large]
    widths = text.columns(map(report.claim_record, chosen))
    results: list[Result] = []
    for result in _evaluated(chosen, arguments.seed, piped=arguments.json):
        saved = _save(result, arguments.save) if from_files else ""
        if not arguments.json:
            found = report.result_record(result)
            entry = text.entry(found, widths, _width())
            if from_files:
                entry = "\n" * bool(results) + text.details(found, _width(), saved=saved)
            print(entry, flush=True)
        results.append(result)
    record = report.json_record(results, arguments.seed, **_about(names, arguments))
    if make:
        write_text_atomically(arguments.report, make(record))
    if arguments.json:
        terminal.print_json(record)
    elif not from_files:
        print(f"\n{text.summary(record['results'])}")
    return terminal.YES if record["as_expected"] else terminal.NO


def file_record(name: str, arguments: argparse.Namespace) -> dict[str, Any]:
    """Check the claims of one file and return the record."""
    chosen = list(_own_claims([name], arguments))
    results = list(_evaluated(chosen, arguments.seed, piped=True))
    return report.json_record(results, arguments.seed, **_about([name], arguments))


def _about(names: list[str], arguments: argparse.Namespace) -> dict[str, str]:
    """Return what a record says of its claims: title, source, and the command for the same run."""
    options = [
        word
        for option in ("seed", "samples", "census")
        if (number := getattr(arguments, option)) is not None and (number or option != "seed")
        for word in (f"--{option}", str(number))
    ]
    command = shlex.join(["proofs-check", "run", *names, *options])
    if names and names[0].endswith(".py"):
        title = claim_file.heading(names[0]).rstrip(".") or Path(names[0]).name
        return {"title": title, "about": ", ".join(names), "command": command}
    return {"title": claims.TITLE, "about": claims.SOURCE, "command": command}


def new_file(arguments: argparse.Namespace) -> int:
    """Write a file with two claims to begin with; one that is there is left alone."""
    path = Path(arguments.name)
    if not path.name:
        raise OwnClaimError(f"{path} names no file; give a name such as mypaper")
    path = path if path.suffix == ".py" else path.with_name(f"{path.name}.py")
    if path.exists():
        raise OwnClaimError(f"{path} is there already; choose another name")
    begun = files("proofs_check.examples").joinpath("template.py").read_text(encoding="utf-8")
    write_text_atomically(path, begun.replace("FILE.py", str(path)))
    if arguments.json:
        terminal.print_json({"output": str(path)})
    else:
        print(
            f"{path} is written; check its claims with: proofs-check run {shlex.quote(str(path))}"
        )
    return terminal.YES


def _evaluated(chosen: list[Claim], seed: int, *, piped: bool) -> Iterator[Result]:
    """Yield each result as soon as it is there, with the progress taken off the terminal.

    Args:
        piped: whether progress is told in a pipe too, where nothing is printed meanwhile.
    """
    bar = Bar(len(chosen), "claims", piped=piped)
    for done, claim in enumerate(chosen):

        def tick(cases: int, done: int = done, claim: Claim = claim) -> None:
            bar.update(done, f"{claim.id}, {cases} cases")

        bar.update(done, claim.id)
        try:
            with shown(False):  # the bar tells
                result = evaluate(claim, seed, tick)
        finally:
            bar.close()
        yield result


def _own_claims(names: list[str], arguments: argparse.Namespace) -> Iterator[Claim]:
    """Yield the claims of files, with the numbers that the command line names."""
    samples, census = arguments.samples, arguments.census
    if not all(name.endswith(".py") for name in names):
        raise OwnClaimError("ids and files are both given; run the claims of files on their own")
    if samples is not None and samples < 0:
        raise OwnClaimError(f"--samples is {samples}; it must be at least 0")
    if census is not None and census not in (0, *range(3, 9)):
        raise OwnClaimError(f"--census is {census}; give 3 to 8 planes, or 0")
    for claim in (claim for name in names for claim in claim_file.load(name)):
        sampled = samples is not None and claim.domain
        changed = replace(claim, samples=samples) if sampled else claim
        if census is not None and claim.domain and claim.domain.unit == "planes":
            others = [source for source in claim.sources if source.kind is not Kind.EXHAUSTIVE]
            types = user_claim.census_sources(census)
            changed = replace(changed, sources=(*types, *others))
        yield changed


def _save(result: Result, folder: str) -> str:
    """Write the smallest failure as an instance file; return its path, or "" without one.

    Commands that read arrangements or grasps read the file. An older one of that name is replaced.
    """
    failure = result.evidence.counterexample
    if failure is None or failure.document is None:
        return ""
    reason = f"smallest instance found on which {result.claim.id} fails: {failure.note}"
    content: dict[str, Any] = {**failure.document, "description": reason}
    target = Path(folder) / f"{result.claim.id}.json"
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OwnClaimError(f"cannot make the folder {folder}: {error.strerror}") from None
    write_text_atomically(target, json.dumps(content, indent=1) + "\n")
    return str(target)


def _width() -> int:
    """Return the width to write for: of the terminal, at least 60 characters, at most 160."""
    return min(max(shutil.get_terminal_size((110, 24)).columns, 60), 160)
