"""The commands sweep and report (of files, stores and records)."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from arrangement.console import terminal
from arrangement.console.number_form import counted
from arrangement.console.progress import Bar, duration, shown
from arrangement.console.writing import write_text_atomically
from arrangement.errors import InputError
from arrangement.library.files.json_files import read_document
from proofs_check.errors import OwnClaimError, SweepError
from proofs_check.own_claims.claim_file import split
from proofs_check.reports import forms
from proofs_check.reports.report import check_record
from proofs_check.reports.text import conclusion
from proofs_check.sweep import report as sweepreport, store
from proofs_check.sweep.sweep import ShardWork, merge, plan_sweep, sweep

from .run import exit_code, file_record

_SQLITE = b"SQLite format 3\x00"


def run_sweep(arguments: argparse.Namespace) -> int:
    """Do what is left of a sweep and print what it found; or its status, or merge stores."""
    if arguments.status or arguments.merge:
        if arguments.claim or arguments.classes or arguments.elements or arguments.samples:
            raise SweepError(
                "--status and --merge take --store alone; omit the claim and instances"
            )
        return _status(arguments) if arguments.status else _merge(arguments)
    sizes = arguments.classes or arguments.elements
    if arguments.claim is None or sizes is None:
        raise SweepError(
            "name a claim with --elements LOW..HIGH --samples N or --classes LOW..HIGH"
        )
    if (arguments.classes is None) == (arguments.samples is None):
        raise SweepError(
            "give --samples N with --elements; with --classes every class is one instance"
        )
    plan = plan_sweep(arguments.claim, sizes, arguments.samples, arguments.seed, arguments.chunk)
    bar = Bar(None, "samples")

    def show(done: int, due: int) -> None:
        if bar.total is None:
            bar.begin(done, due)
        bar.update(done)

    try:
        with shown(False):  # the bar reports
            work = sweep(
                plan,
                arguments.store,
                jobs=arguments.jobs,
                shard=arguments.shard,
                dask=arguments.dask,
                progress=show,
            )
    finally:
        bar.close()
    with store.read(arguments.store) as opened:
        record = sweepreport.record(opened)
    if arguments.json:
        terminal.print_json(record)
    else:
        print("\n".join(_lines(work, arguments.shard, plan.chunks, record)))
    return exit_code(record, strict=arguments.strict) if work.due else terminal.YES


def _lines(
    work: ShardWork, shard: tuple[int, int], chunks: int, record: dict[str, Any]
) -> Iterator[str]:
    """Yield what was done and what the sweep found."""
    part, parts = shard
    if not work.due:
        yield f"shard {part}/{parts} has nothing to do: the sweep has {counted(chunks, 'chunk')}"
        return
    if not work.new:
        what = "the sweep" if parts == 1 else f"shard {part}/{parts}"
        yield f"{what} was finished already: {counted(work.due, 'chunk')} in the store, none new"
    (result,) = record["results"]
    yield f"{result['id']} ({result['locator']}): {conclusion(result)}"
    yield from (f"  {part}" for part in result["evidence"].split("; "))


def _status(arguments: argparse.Namespace) -> int:
    """Print how far a sweep is; exit code 0 when it is complete."""
    with store.read(arguments.store) as opened:
        status = sweepreport.status(opened)
    if arguments.json:
        terminal.print_json(status)
        return terminal.YES if status["complete"] else terminal.NO
    outcomes = ", ".join(f"{kind} {number}" for kind, number in status["outcomes"].items())
    print(f"claim    {status['claim']}")
    print(f"chunks   {status['chunks']} of {status['chunks_due']}")
    print(f"samples  {status['samples']} of {status['samples_due']}: {outcomes}")
    print(f"work     {duration(status['milliseconds'] / 1000)} of one process")
    return terminal.YES if status["complete"] else terminal.NO


def _merge(arguments: argparse.Namespace) -> int:
    """Put the chunks of several stores into one."""
    new = merge(arguments.store, arguments.merge)
    with store.read(arguments.store) as opened:
        status = sweepreport.status(opened)
    if arguments.json:
        terminal.print_json({"new": new, **status})
    else:
        print(f"{new} new chunks; {status['chunks']} of {status['chunks_due']} are there")
    return terminal.YES


def run_report(arguments: argparse.Namespace) -> int:
    """Make a report of a file of claims, of the store of a sweep, or of the record of a run."""
    ending = Path(arguments.output).suffix if arguments.output else ".md"
    make = forms.form(f".{arguments.format}" if arguments.format else ending)
    lost = ""
    if split(arguments.source)[0]:
        record, lost = file_record(arguments.source, arguments)
    else:
        record = _read(arguments.source)
    made = _form_of(make, record, arguments.source)
    if arguments.output:
        write_text_atomically(arguments.output, made)
    if arguments.json:
        terminal.print_json(record)
    elif not arguments.output:
        print(made, end="")
    if lost:
        raise OwnClaimError(lost)
    return exit_code(record, strict=arguments.strict)


def _read(source: str) -> dict[str, Any]:
    """Return the record of a store, or the one in a JSON file."""
    try:
        with Path(source).open("rb") as stream:
            is_store = stream.read(len(_SQLITE)) == _SQLITE
    except OSError:
        is_store = False
    if is_store:
        with store.read(source) as opened:
            return sweepreport.record(opened)
    return read_document(source, ("results",), kind="bytes of a record")


def _form_of(make: Any, record: dict[str, Any], source: str) -> str:
    try:
        check_record(record)
        text: str = make(record)
    except InputError:
        raise
    except (AttributeError, LookupError, TypeError, ValueError, RecursionError):
        raise InputError(
            f"{source} is not a complete record; proofs-check run -o FILE.json writes one"
        ) from None
    return text
