"""The plumbing that all commands share."""

import argparse
import json
import signal
import subprocess
import sys
from fractions import Fraction
from typing import Any

import pytest

from arrangement import InputError, MissingExtraError
from arrangement.console import terminal
from arrangement.console.entry import entry
from arrangement.numbers import budget


def parser_for(function: Any) -> terminal.Parser:
    parser = terminal.command_parser("demo", "A demonstration.")
    commands = parser.add_subparsers(required=True)
    go = commands.add_parser("go")
    go.add_argument("--wrench", nargs=3, type=terminal.rational_argument)
    go.add_argument("where", nargs="?")
    terminal.add_common_options(go)
    go.set_defaults(command=function)
    return parser


def parsed(*arguments: str) -> argparse.Namespace:
    return parser_for(None).parse_args(["go", *arguments])


@pytest.mark.parametrize(
    ("words", "numbers"),
    [
        (("-1/2", "-0.25", "-.5"), (Fraction(-1, 2), Fraction(-1, 4), Fraction(-1, 2))),
        (("0", "-1", "+7/3"), (Fraction(0), Fraction(-1), Fraction(7, 3))),
    ],
)
def test_negative_rationals_are_values(words, numbers):
    assert parsed("--wrench", *words).wrench == list(numbers)
    assert parsed("here", "--wrench", *words, "--json").wrench == list(numbers)
    assert parsed("--wrench", *words, "here").where == "here"


@pytest.mark.parametrize("word", ["-1e", "1e999999999", "-1/0", "nan", "-inf", "0x1", "", "1_2"])
def test_other_numbers_are_refused_with_the_reason(word, capsys):
    with pytest.raises(SystemExit) as caught:
        parsed("--wrench", "0", "0", word)
    assert caught.value.code == 2
    error = capsys.readouterr().err.splitlines()[-1]
    assert error.startswith("error: ")


@pytest.mark.parametrize(
    ("error", "code", "lines"),
    [
        (InputError("broken\x1b[1m\nrule"), 2, 1),
        (MissingExtraError("extra"), 2, 1),
        (KeyboardInterrupt(), 130, 0),
        (BrokenPipeError(), 141, 0),
    ],
)
def test_errors_on_purpose_are_one_line_and_interruptions_are_quiet(error, code, lines, capsys):
    def fails(_):
        raise error

    assert terminal.run(parser_for(fails), ["go"]) == code
    out, err = capsys.readouterr()
    assert (out, err.count("\n"), "\x1b" in err) == ("", lines, False)
    assert err.startswith("error: " * lines)


@pytest.mark.parametrize("error", [ZeroDivisionError("x" * 999), RecursionError()])
def test_a_fault_of_the_program_is_no_answer(error, capsys):
    def fails(_):
        raise error

    assert terminal.run(parser_for(fails), ["go"]) == 70
    line = capsys.readouterr().err
    assert line.startswith(f"error: a fault of the program, no answer: {type(error).__name__}: ")
    assert line.count("\n") == 1
    assert len(line) < 300
    assert terminal.run(parser_for(fails), ["go", "--traceback"]) == 70
    assert "Traceback (most recent call last)" in capsys.readouterr().err


def test_what_memory_does_not_hold_is_refused(capsys):
    def fails(_):
        print("half an answer")
        return len(bytearray(1 << 62))

    assert terminal.run(parser_for(fails), ["go"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: there is not enough memory")
    assert said.count("\n") == 1


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="the system has no such clock")
def test_a_command_that_is_watched_ends_when_its_time_is_over(capsys):
    def never_ends(_):
        budget.watch(0.1)
        while True:
            try:
                for _ in range(10**6):
                    pass
            except Exception:
                pass  # what takes errors for bad input does not go on

    assert terminal.run(parser_for(never_ends), ["go", "--limit", "2"]) == 2
    said = capsys.readouterr().err
    assert said == "error: it has taken 0.2 seconds of the processor; --limit 4 allows more\n"
    assert signal.getitimer(signal.ITIMER_VIRTUAL) == (0, 0)


def test_json_is_one_line_with_rationals_as_strings(capsys):
    terminal.print_json({"x": [Fraction(-7, 3), Fraction(2)], "text": "ß\n", "n": 3, "none": None})
    out = capsys.readouterr().out
    assert out.count("\n") == 1
    assert out.isascii()
    assert json.loads(out) == {"x": ["-7/3", "2"], "text": "ß\n", "n": 3, "none": None}


@pytest.mark.parametrize(("value", "error"), [(float("nan"), ValueError), (object(), TypeError)])
def test_json_takes_nothing_that_json_cannot_say(value, error):
    with pytest.raises(error):
        terminal.print_json({"x": value})


@pytest.mark.parametrize(
    "words",
    [["--x", "1,-2"], ["--x", "1,", "-2"], ["--x", "1 -2"], ["--x=1,-2"], ["--x", "1", "-2"]],
)
def test_several_numbers_may_be_written_in_any_usual_way(words):
    parser = terminal.command_parser("program", "Take two numbers.")
    parser.add_argument("--x", nargs=2, type=terminal.rational_argument)
    parser.add_argument("--y", action="store_true")
    assert parser.parse_args([*words, "--y"]).x == [1, -2]


def test_a_fault_at_import_is_no_answer(tmp_path, monkeypatch, capsys):
    (tmp_path / "broken_program.py").write_text("import no_such_library\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    assert entry("broken_program")([]) == 70
    assert "the module no_such_library is missing" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("missing", "module", "words"),
    [
        ("numpy", "arrangement.console.entry", "count pencil"),
        ("numpy", "equilibrium.cli", "limit ladder --direction 0 1 0"),
        ("lazy_loader", "equilibrium.cli", "limit ladder --direction 0 1 0"),
        ("lazy_loader", "proofs_check.cli", "run euler"),
    ],
)
def test_a_missing_dependency_is_no_answer(missing, module, words):
    program = f"""
import sys
sys.modules[{missing!r}] = None
from {module} import main
sys.exit(main({words.split()!r}))
"""
    run = [sys.executable, "-c", program]
    ended = subprocess.run(run, capture_output=True, text=True, timeout=60, check=False)
    assert ended.returncode == 70
    assert ended.stderr == (
        f"error: no answer: the module {missing} is missing; install slipstates again\n"
    )
