"""The ``proofs-check`` program: its arguments; commands are imported when they run."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Sequence
from importlib import import_module

from arrangement.console import terminal
from arrangement.console.options import values
from arrangement.console.options.parser import Parser

#: Files of `proofs_check.examples` for ``new``, kept here so that ``--help`` reads none.
EXAMPLES = (
    "template",
    "gaps",
    "most_triangles",
    "regions_of_families",
    "survey",
    "triangles",
    "two_fingers",
)


#: Commands that the help lists first.
_COMMON = ("run", "try", "list", "new", "report")


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code.

    Exit codes: 0 every verdict is the expected one, 1 some verdict differs, 2 bad input, 3 some
    claim has no verdict; with --strict also where one was tried on samples alone.
    """
    return terminal.run(_parser(), argv)


def _parser() -> Parser:
    parser = terminal.command_parser(
        "proofs-check",
        "Verify counting claims about arrangements and grasps by independent implementations.",
    )
    parser.strays[r".*[=<>≤≥≠].*|\S+\s+\S+\s.*"] = "proofs-check try {}"
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def command(name: str, function: str, help: str, *answers: str) -> Parser:
        heading = "common" if name in _COMMON else "more"
        added: Parser = terminal.add_command(commands, name, help, *answers, heading=heading)
        added.set_defaults(command=_later(function), long=True)  # it reports its progress
        if name != "report":
            added.names = dict.fromkeys(("ids", "source", "claim"), _claims)
        terminal.add_common_options(added)
        if name in ("run", "try", "fit", "sweep", "report"):
            terminal.add_number_options(added)
        if name in ("run", "try", "sweep", "report"):
            added.add_argument(
                "--strict",
                action="store_true",
                help="exit with 3 if no counterexample was found but not all cases were tried",
            )
        return added

    strict = "no verdict, or with --strict no counterexample found"
    expected = ("every verdict is the expected one", "some verdict differs", strict)
    _add_run(
        command(
            "run",
            "run.run_claims",
            "check (verify) claims and print the verdicts (proved, refuted, ...)",
            *expected,
        )
    )
    _add_try(
        command(
            "try",
            "run.try_claim",
            "check a claim stated in one line",
            "not refuted",
            "refuted",
            strict,
        )
    )
    listed = command(
        "list", "listing.list_claims", "list claims, or describe one (show its statement and proof)"
    )
    listed.add_argument(
        "source",
        nargs="?",
        metavar="ID|FILE.py",
        help="a claim to describe, or a file (default: the claims of the paper)",
    )
    new = command("new", "listing.new_file", "write a file of claims to start from")
    new.add_argument("name", metavar="NAME", help="name of the file, without .py")
    new.add_argument(
        "--example",
        metavar="EXAMPLE",
        choices=EXAMPLES,
        default="template",
        help=f"one of {', '.join(EXAMPLES[1:])} (default: two short claims)",
    )
    whole = command("paper", "paper.run_paper", "reproduce the paper's figures and tables")
    whole.add_argument(
        "-o",
        "--output",
        required=True,
        metavar="FOLDER",
        help="folder for index.html and each figure and table as SVG, PDF and TikZ",
    )
    whole.add_argument(
        "--measure",
        action="store_true",
        help="measure the times of Table II on this machine (default: the stored ones)",
    )
    report = command(
        "report",
        "sweep.run_report",
        "write a report of claims, of a sweep, or of a JSON record",
        *expected,
    )
    report.add_argument(
        "source",
        metavar="FILE",
        help="FILE.py, a store of a sweep, or FILE.json of run "
        "(the paper's claims: proofs-check run -o FILE.html)",
    )
    _add_output(report, remark="(default: Markdown on stdout)")
    report.add_argument(
        "--format",
        choices=("html", "json", "md", "txt"),
        help="(default: by the suffix of the output)",
    )
    _add_seed(report)
    _add_own(report)
    fitted = command(
        "fit",
        "fit.run_fit",
        "fit a quasi-polynomial to the counts of a family",
        "one fits",
        "none fits",
    )
    fitted.add_argument(
        "quantity", metavar="QUANTITY", help="a count such as regions or f_vector[1], or FILE.py:ID"
    )
    fitted.add_argument("--of", metavar="FAMILY", help="a family such as 'generic(m=2..9)'")
    _add_extreme(
        command(
            "extreme",
            "extreme.run_extreme",
            "print the largest or smallest value of a quantity, with an example of each",
            "values found",
            "no class satisfies the hypothesis",
        )
    )
    _add_sweep(
        command(
            "sweep",
            "sweep.run_sweep",
            "check one claim on very many instances, resumably",
            *expected,
        )
    )
    grade = command(
        "grade",
        "grade.run_grade",
        "grade answers to exercises",
        "all answers are right",
        "an answer is wrong",
    )
    text = "the exercises, run as a program; or those of a lab: slip-lab, arrangement-lab, "
    grade.add_argument("exercises", metavar="FILE.py", help=f"{text}or the .json of its editor")
    grade.add_argument(
        "answers",
        nargs="?",
        metavar="ANSWERS.json",
        help="the answers, or a folder with a file of each student (default: list the questions)",
    )
    grade.add_argument(
        "-o", "--output", metavar="POINTS.csv", help="write the points of all students here"
    )
    text = "the class list, in the order of the result; its first column has the names of files"
    grade.add_argument("--students", metavar="LIST.csv", help=text)
    return parser


def _claims() -> list[str]:
    """Return the ids of the claims of the paper."""
    from proofs_check.claims import entries

    return list(entries())


def _later(function: str) -> Callable[[argparse.Namespace], int]:
    """Return a command that imports what it does when it is called."""
    module, name = function.split(".")

    def command(arguments: argparse.Namespace) -> int:
        code: int = getattr(import_module(f"{__package__}.{module}"), name)(arguments)
        return code

    return command


def _add_run(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "ids",
        nargs="*",
        metavar="ID|FILE",
        help="claims to check (default: those of the paper), FILE.py, FILE.py:ID, or FILE.csv: "
        "printed numbers in columns arrangement, quantity, printed (- for stdin)",
    )
    _add_seed(parser)
    _add_output(parser, remark="(default: none)")
    terminal.add_jobs_option(parser)
    parser.add_argument(
        "--large", action="store_true", help="also check the claims that take minutes"
    )
    parser.add_argument(
        "--verified",
        action="store_true",
        help="also count with the formally verified program (built by `make formal`)",
    )
    _add_save(_add_own(parser))


def _add_try(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "statement",
        metavar="STATEMENT",
        help='such as "p_vector.get(3, 0) >= m"; its names are regions, f_vector, chi(t), ...',
    )
    parser.add_argument(
        "--of",
        metavar="DOMAIN",
        help="the planes, such as simple, lines or affine(d=2); or a family, as 'catalan(n=2..6)' "
        "(default: distinct; also lines if it is refuted)",
    )
    parser.add_argument("--when", metavar="STATEMENT", help="a hypothesis, such as simple")
    _add_seed(parser)
    _add_output(parser, remark="(default: none)")
    _add_numbers(parser)
    _add_save(parser)


def _add_own(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    group = parser.add_argument_group(
        "user-defined claims (FILE.py)",
        "The file is run as a Python program with all your permissions.",
    )
    _add_numbers(group)
    return group


def _add_numbers(parser: argparse._ActionsContainer) -> None:
    parser.add_argument(
        "--samples",
        type=values.count_argument,
        metavar="N",
        help="number of random instances of each claim",
    )
    parser.add_argument(
        "--classes",
        type=_range,
        metavar="LOW..HIGH",
        help="check every isomorphism class of rank 3 with LOW to HIGH planes",
    )


def _add_save(parser: argparse._ActionsContainer) -> None:
    parser.add_argument(
        "--save",
        metavar="FOLDER",
        help="write a counterexample to each claim that is refuted into this folder",
    )


def _add_extreme(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "quantity", metavar="QUANTITY", help="a count such as regions or t_vector.get(2, 0)"
    )
    parser.add_argument(
        "--of", required=True, metavar="DOMAIN", help="lines, simple-lines, rank-3, ..."
    )
    parser.add_argument(
        "--classes",
        type=_range,
        required=True,
        metavar="LOW..HIGH",
        help="every isomorphism class of LOW to HIGH lines or planes",
    )
    way = parser.add_mutually_exclusive_group()
    way.add_argument("--largest", action="store_true", help="print the largest value (default)")
    way.add_argument("--smallest", action="store_true", help="print the smallest value")
    parser.add_argument(
        "--when", metavar="CONDITION", help="only classes that satisfy this condition"
    )
    parser.add_argument("--save", metavar="FOLDER", help="write an example of each value here")


def _add_sweep(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("claim", nargs="?", metavar="ID", help="a claim, FILE.py, or FILE.py:ID")
    parser.add_argument(
        "--store", required=True, metavar="FILE", help="store the results here (created if missing)"
    )
    instead = parser.add_mutually_exclusive_group()
    instead.add_argument(
        "--status",
        action="store_true",
        help="print the progress of the sweep; exit code 0 if it is complete, else 1",
    )
    instead.add_argument(
        "--merge",
        nargs="+",
        metavar="PART",
        help="add the chunks of these stores of the same sweep",
    )
    instances = parser.add_mutually_exclusive_group()
    instances.add_argument(
        "--elements",
        type=_range,
        metavar="LOW..HIGH",
        help="numbers of planes or of contacts of random instances",
    )
    instances.add_argument(
        "--classes",
        type=_range,
        metavar="LOW..HIGH",
        help="every isomorphism class of rank 3 with LOW to HIGH planes, instead of random ones",
    )
    parser.add_argument(
        "--samples",
        type=values.integer_argument,
        metavar="N",
        help="total number of random instances",
    )
    _add_seed(parser)
    terminal.add_worker_options(parser)
    parser.add_argument(
        "--chunk",
        type=values.integer_argument,
        default=200,
        metavar="N",
        help="number of instances in a chunk (default: 200)",
    )


def _add_seed(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--seed",
        type=values.integer_argument,
        default=0,
        help="seed of the random instances (default: 0)",
    )


def _add_output(parser: argparse.ArgumentParser, *, remark: str) -> None:
    endings = "FILE.html, FILE.md, FILE.json or FILE.txt"
    parser.add_argument("-o", "--output", metavar="FILE", help=f"{endings} {remark}")


def _range(text: str) -> tuple[int, int]:
    """Read 3..12, or 5 for 5..5."""
    match = re.fullmatch(r"([0-9]{1,6})(?:\.\.([0-9]{1,6}))?", text, re.ASCII)
    if match is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a range; write 3..12")
    return int(match[1]), int(match[2] or match[1])
