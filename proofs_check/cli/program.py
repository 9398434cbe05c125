"""The ``proofs-check`` command: its arguments; what the commands do is imported when they run."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Sequence
from importlib import import_module

from arrangement.console import terminal


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

    def command(name: str, function: str, help: str, *answers: str) -> argparse.ArgumentParser:
        added: argparse.ArgumentParser = terminal.add_command(commands, name, help, *answers)
        added.set_defaults(command=_later(function), long=True)  # it tells how far it is
        terminal.add_common_options(added)
        if name in ("run", "try", "fit", "sweep", "report"):
            terminal.add_number_options(added)
        return added

    expected = ("every verdict is the expected one", "some verdict differs")
    listed = command("list", "run.list_claims", "list the claims")
    listed.add_argument("file", nargs="?", metavar="FILE.py", help="(default: those of the paper)")
    show = command("show", "run.show_claim", "say what one claim states and how it is checked")
    show.add_argument("id", metavar="ID", help="a claim of the paper, or FILE.py:ID")
    _add_run(command("run", "run.run_claims", "check claims and print the verdicts", *expected))
    _add_try(command("try", "run.try_claim", "check a claim in one line", "not refuted", "refuted"))
    fitted = command(
        "fit",
        "fit.run_fit",
        "say what polynomial a count of a family fits",
        "one fits",
        "none fits",
    )
    fitted.add_argument(
        "quantity", metavar="QUANTITY", help="such as regions or f_vector[1]; or FILE.py:ID"
    )
    fitted.add_argument("--of", metavar="FAMILY", help="such as 'generic(m=2..9)'")
    _add_sweep(
        command(
            "sweep",
            "sweep.run_sweep",
            "check one claim on very many instances; can be interrupted",
            *expected,
        )
    )
    status = command(
        "status",
        "sweep.run_status",
        "say how far a sweep is, also while it runs",
        "complete",
        "not yet",
    )
    status.add_argument("store", metavar="STORE")
    merge = command(
        "merge", "sweep.run_merge", "put the chunks of several stores of one sweep into one"
    )
    merge.add_argument("store", metavar="STORE", help="where to; made when missing")
    merge.add_argument("parts", nargs="+", metavar="PART", help="stores to read")
    report = command(
        "report",
        "sweep.run_report",
        "make a report of your claims, of a store or of a JSON record",
        *expected,
    )
    report.add_argument(
        "source", metavar="SOURCE", help="FILE.py, a store of a sweep, or FILE.json of run"
    )
    _add_report(report, "-o", "--output", remark="(default: Markdown on stdout)")
    report.add_argument(
        "--format",
        choices=("html", "json", "md", "pdf", "tex", "txt"),
        help="(default: what the ending of the output says)",
    )
    _add_seed(report)
    _add_own(report)
    grade = command(
        "grade", "grade.run_grade", "grade answers to exercises", "all are right", "one is wrong"
    )
    grade.add_argument("exercises", metavar="FILE.py", help="the exercises; it is run as a program")
    grade.add_argument(
        "answers",
        nargs="?",
        metavar="ANSWERS.json",
        help="or a folder with such a file for each student (default: list the questions)",
    )
    grade.add_argument("-o", "--output", metavar="POINTS.csv", help="the points of a folder")
    table = command(
        "table",
        "grade.run_table",
        "compare numbers in print with what is computed",
        "none differs",
        "some differ",
    )
    table.add_argument(
        "table", metavar="FILE.csv", help="columns arrangement, quantity, printed; - for stdin"
    )
    new = command("new", "run.new_file", "write a file with claims of your own to begin with")
    new.add_argument("name", metavar="NAME", help="of the file; .py is added")
    return parser


def _later(function: str) -> Callable[[argparse.Namespace], int]:
    """Return a command that imports what it does when it is called."""
    module, name = function.split(".")

    def command(arguments: argparse.Namespace) -> int:
        code: int = getattr(import_module(f"{__package__}.{module}"), name)(arguments)
        return code

    return command


def _add_run(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "ids", nargs="*", metavar="ID", help="claims to check (default: all), FILE.py or FILE.py:ID"
    )
    _add_seed(parser)
    _add_report(parser, "-o", "--report", remark="to write as well")
    terminal.add_jobs_option(parser)
    parser.add_argument("--large", action="store_true", help="the claims that take minutes, too")
    parser.add_argument(
        "--proved",
        action="store_true",
        help="count by the program that is proved in Coq, too (built by `make formal`)",
    )
    _add_save(_add_own(parser))


def _add_try(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "statement",
        metavar="STATEMENT",
        help='such as "p_vector.get(3, 0) >= m"; with regions, f_vector, t_vector, chi(t), ...',
    )
    parser.add_argument(
        "--of",
        default="distinct",
        metavar="DOMAIN",
        help="which planes; or a family, as 'catalan(n=2..6)'",
    )
    parser.add_argument("--when", metavar="STATEMENT", help="a hypothesis")
    _add_seed(parser)
    _add_report(parser, "-o", "--report", remark="to write as well")
    _add_numbers(parser)
    _add_save(parser)


def _add_own(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    group = parser.add_argument_group(
        "claims of your own (FILE.py)",
        "The file is run as a Python program, with all your rights.",
    )
    _add_numbers(group)
    return group


def _add_numbers(parser: argparse._ActionsContainer) -> None:
    parser.add_argument(
        "--samples",
        type=terminal.count_argument,
        metavar="N",
        help="random instances of each claim",
    )
    parser.add_argument(
        "--census", type=terminal.integer_argument, metavar="M", help="all types of up to M planes"
    )


def _add_save(parser: argparse._ActionsContainer) -> None:
    parser.add_argument(
        "--save",
        metavar="FOLDER",
        default="counterexamples",
        help="for the instances that refute a claim (default: counterexamples)",
    )


def _add_sweep(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("claim", metavar="ID", help="a claim, FILE.py, or FILE.py:ID")
    instances = parser.add_mutually_exclusive_group(required=True)
    instances.add_argument(
        "--planes",
        type=_range,
        metavar="LOW..HIGH",
        help="numbers of planes, or of contacts, of random instances",
    )
    instances.add_argument(
        "--types",
        type=_range,
        metavar="LOW..HIGH",
        help="numbers of planes, 3 to 9: every combinatorial type of rank 3, no random ones",
    )
    parser.add_argument(
        "--samples",
        type=terminal.integer_argument,
        metavar="N",
        help="random instances in all",
    )
    _add_seed(parser)
    parser.add_argument(
        "--store", required=True, metavar="FILE", help="keeps what is done; made when missing"
    )
    terminal.add_worker_options(parser)
    parser.add_argument(
        "--chunk",
        type=terminal.integer_argument,
        default=200,
        metavar="N",
        help="instances in a chunk (default: 200)",
    )


def _add_seed(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--seed",
        type=terminal.integer_argument,
        default=0,
        help="of the random instances (default: 0)",
    )


def _add_report(parser: argparse.ArgumentParser, *names: str, remark: str) -> None:
    endings = "FILE.json, FILE.md, FILE.html, FILE.tex, FILE.pdf or FILE.txt"
    parser.add_argument(*names, metavar="FILE", help=f"{endings} {remark}")


def _range(text: str) -> tuple[int, int]:
    """Read 3..12, or 5 for 5..5."""
    found = re.fullmatch(r"([0-9]{1,6})(?:\.\.([0-9]{1,6}))?", text, re.ASCII)
    if found is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a range; write 3..12")
    return int(found[1]), int(found[2] or found[1])
