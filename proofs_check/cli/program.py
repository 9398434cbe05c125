"""The command ``proofs-check``: list the claims, show one, run some or all."""

from __future__ import annotations

import argparse
import shutil
import textwrap
from collections.abc import Iterator, Sequence
from itertools import count
from typing import TYPE_CHECKING

from arrangement import terminal
from arrangement.progress import Bar

from . import options

if TYPE_CHECKING:
    from proofs_check.claim import Claim, Record, Result


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code.

    Exit codes: 0 every verdict is the expected one, 1 some verdict differs, 2 bad input.
    """
    return terminal.run(_parser(), argv)


def _parser() -> terminal.Parser:
    parser = terminal.command_parser(
        "proofs-check", "Claims about slip states, each checked by two routes that share no code."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    listing = commands.add_parser("list", help="list the claims")
    listing.set_defaults(command=_list)

    show = commands.add_parser("show", help="say what one claim states and how it is checked")
    show.add_argument("id", metavar="ID")
    show.set_defaults(command=_show)

    run = commands.add_parser("run", help="check claims and print the verdicts")
    run.add_argument(
        "ids", nargs="*", metavar="ID", help="claims to check (default: all), or FILE.py"
    )
    run.add_argument("--seed", type=int, default=0, help="of the random instances (default: 0)")
    run.add_argument(
        "--report",
        metavar="FILE",
        help="also write a report: FILE.json, FILE.md, FILE.html, FILE.tex, else text",
    )
    options.add_run_options(run)
    run.set_defaults(command=_run)

    for command in (listing, show, run, *options.add_commands(commands)):
        terminal.add_json_option(command)
    return parser


def _list(arguments: argparse.Namespace) -> int:
    from proofs_check.claims import registry
    from proofs_check.reports import report

    claims = list(registry())
    if arguments.json:
        terminal.print_json({"claims": [report.claim_record(claim) for claim in claims]})
        return terminal.YES
    rows = [(claim.id, claim.locator, claim.statement) for claim in claims]
    print("\n".join(report.table(rows, _width())))
    return terminal.YES


def _show(arguments: argparse.Namespace) -> int:
    from proofs_check.claims import registry
    from proofs_check.reports import report

    claim = registry()[arguments.id]
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
        *(("hypothesis", text) for text in claim.hypotheses),
        ("quantity", claim.quantity),
        *((f"route {i}", route.name) for i, route in enumerate(claim.routes, 1)),
        ("evidence", f"{claim.kind.value}: {claim.over}"),
        ("expected", claim.expected.value),
    ]
    if claim.hypothesis is not None:
        entries.append(("holds when", claim.hypothesis.text))
    if claim.meaning:
        entries.append(("meaning", claim.meaning))
    lines = []
    for name, text in entries:
        lines += textwrap.wrap(f"{name:<12}{text}", width, subsequent_indent=" " * 12)
    return "\n".join(lines)


def _run(arguments: argparse.Namespace) -> int:
    if any(name.endswith(".py") for name in arguments.ids):
        return options.run_files(arguments, _width())
    from proofs_check.claim import evaluate
    from proofs_check.claims import registry
    from proofs_check.reports import report

    known = registry()
    chosen = [known[id] for id in dict.fromkeys(arguments.ids)] or list(known)
    bar = Bar(len(chosen), "claims")
    results: list[Result] = []
    try:
        for claim in chosen:
            cases = count(1)

            def tick(_: Record, claim: Claim = claim, cases: Iterator[int] = cases) -> None:
                bar.update(len(results), f"{claim.id}, {next(cases)} cases")

            bar.update(len(results), claim.id)
            results.append(evaluate(claim, arguments.seed, tick))
    finally:
        bar.close()
    if arguments.report:
        report.write_report(arguments.report, results, arguments.seed)
    if arguments.json:
        terminal.print_json(report.json_record(results, arguments.seed))
    else:
        print(report.text_report(results, _width()))
    return terminal.YES if all(result.as_expected for result in results) else terminal.NO


def _width() -> int:
    """Return the width to write for: of the terminal, at least 60 characters, at most 160."""
    return min(max(shutil.get_terminal_size((110, 24)).columns, 60), 160)


if __name__ == "__main__":
    raise SystemExit(main())
