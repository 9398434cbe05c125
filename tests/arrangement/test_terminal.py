"""The plumbing that all commands share."""

import argparse
import io
import json
import math
import os
import re
import subprocess
import sys
from collections.abc import Iterable
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any, TypeAlias
from zipfile import ZipFile

import pytest

from arrangement import InputError, MissingExtraError
from arrangement.cli import main
from arrangement.console import progress, terminal
from arrangement.console.entry import entry
from arrangement.console.options import values
from arrangement.console.options.parser import Parser
from arrangement.console.options.signature import Syntax, options_of
from arrangement.console.progress import Bar, shown, watched
from arrangement.hints import summary
from arrangement.numbers import budget


def parser_for(function: Any) -> Parser:
    parser = terminal.command_parser("demo", "A demonstration.")
    commands = parser.add_subparsers(required=True)
    go = commands.add_parser("go")
    go.add_argument("--wrench", nargs=3, type=values.rational_argument)
    go.add_argument("where", nargs="?")
    terminal.add_common_options(go)
    go.set_defaults(command=function)
    return parser


def parsed(*arguments: str) -> argparse.Namespace:
    return parser_for(None).parse_args(["go", *arguments])


def answer(parser: Parser, words: Iterable[str], capsys: Any) -> list[str]:
    """Return the lines with which a parser refuses words."""
    with pytest.raises(SystemExit) as stopped:
        parser.parse_args(list(words))
    assert stopped.value.code == 2
    return capsys.readouterr().err.splitlines()


def demo() -> Parser:
    parser = terminal.command_parser("demo", "A demonstration.")
    parser.strays[".*=.*"] = "demo try {}"
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    go = terminal.add_command(commands, "go", "go there, or return", heading="common")
    go.usual = "--wrench 1"
    number = values.rational_argument
    go.add_argument("--wrench", metavar="W", type=number, help="the load")
    go.add_argument("file", metavar="FILE")
    go.names["file"] = lambda: ["ladder"]
    make = terminal.add_command(commands, "make", "make something", heading="common")
    kinds = make.add_subparsers(metavar="KIND")
    kinds.add_parser("arch", help="").add_argument("-o")
    draw = terminal.add_command(commands, "draw", "draw it", heading="common")
    draw.add_argument("file", metavar="FILE")
    draw.names["file"] = lambda: ["ladder"]
    draw.add_argument("--view", required=True, help="the picture")
    draw.add_argument("--at", nargs=2, metavar=("X", "Y"), type=number, help="a place")
    draw.words = {"--where": "--at"}
    draw.names["view"] = lambda: ["sphere"]
    terminal.add_common_options(draw)
    return parser


@pytest.mark.parametrize(
    ("words", "head", "first"),
    [
        ("ladder", "'ladder' is not a command; write demo go ladder --wrench 1 (see ", None),
        ("my.csv -x", "'my.csv' is not a command; write demo go my.csv --wrench 1 (see ", None),
        ("a=b", "'a=b' is not a command; write demo try a=b (see ", None),
        ("arch", "'arch' is a family; write 'demo make arch -o FILE.json', then 'demo go F", None),
        ("arch:3", "'arch:3' is a family; write 'demo make arch -o FILE.json', then ", None),
        ("walk", "there is no command 'walk'; expected one of ", "demo go FILE --wrench 1  go"),
        ("walk ladder", "there is no command 'walk'; ", "demo go ladder --wrench 1  go there"),
        ("walk ladder --wrench 2", "there is no command ", "demo go ladder --wrench 2  go there"),
        ("returns", "there is no command 'returns'; ", "demo go FILE --wrench 1  go there"),
        ("sphere", "there is no command ", "demo draw FILE --view sphere  the picture"),
        ("load ladder", "there is no command 'load'; ", "demo go ladder --wrench W  the load"),
        ("go ladder --load=3", "demo go has no option '--load'; ", "--wrench 3  the load"),
        ("go ladder --at 3", "demo go has no option ", "demo draw ladder --view VIEW --at X Y"),
        ("go --wrech 3 ladder", "demo go has no option '--wrech'; ", "--wrench W  the load"),
        ("go a b --wrench 1", "unexpected argument 'b'; demo go takes FILE (see ", None),
        ("go a wrench 1", "unexpected argument 'wrench'; write demo go a --wrench 1 (see ", None),
        ("draw a --view x --where 1 2", "demo draw has no option '--where'; ", "--at 1 2  a place"),
        (
            "draw a",
            "the following arguments are required: --view; write demo draw a --view VIEW, where:",
            "--view VIEW  the picture",
        ),
        (
            "--json draw a --view x",
            "--json follows the command; write demo draw a --json --view x ",
            None,
        ),
        ("draw a --at 1", "argument --at: expected 2 arguments:", "--at X Y  a place"),
        ("", "the following arguments are required: COMMAND; expected one of these:", "demo go FI"),
    ],
)
def test_unknown_words_are_answered_with_what_there_is(words, head, first, capsys):
    refused, *rows = answer(demo(), words.split(), capsys)
    assert refused.startswith(f"error: {head}")
    assert refused.endswith(":") is bool(rows)
    assert (first is None) is (not rows)
    assert not rows or re.sub("  +", "  ", rows[0]).startswith(f"  {first}")


def test_options_that_do_not_fit_into_a_list_are_named(capsys):
    parser = Parser(prog="try")
    for k in range(15):
        parser.add_argument(f"--option-{k}")
    _, *rows = answer(parser, ["--jobs"], capsys)
    assert len(rows) == 13
    assert rows[-1] == "  others: --option-12, --option-13, --option-14"


def test_help_lists_commands_under_their_headings():
    parser = terminal.command_parser("demo", "A demonstration.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    terminal.add_command(commands, "go", "go there", heading="common")
    terminal.add_command(commands, "return", "come back", heading="more")
    assert "common:\n  go      go there\n\nmore:\n  return  come back\n" in parser.format_help()


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
    for brackets in ("({})", "[{}]", "{}"):
        assert parsed("--wrench", brackets.format(",".join(words))).wrench == list(numbers)


@pytest.mark.parametrize("word", ["-1e", "1e999999999", "-1/0", "nan", "-inf", "0x1", "", "1_2"])
def test_other_numbers_are_refused_with_the_reason(word, capsys):
    with pytest.raises(SystemExit) as caught:
        parsed("--wrench", "0", "0", word)
    assert caught.value.code == 2
    assert capsys.readouterr().err.startswith("error: argument --wrench: ")


def test_time_limits_are_above_zero_and_of_any_size():
    assert values.seconds_argument("1/2") == 0.5
    assert values.seconds_argument("1e4000") == math.inf
    for text in ("0", "-1", "1e-400"):
        with pytest.raises(argparse.ArgumentTypeError, match="is not above 0; give a number of"):
            values.seconds_argument(text)


@pytest.mark.parametrize(
    ("error", "code", "lines"),
    [
        (InputError("broken\x1b[1m\nrule"), 2, 1),
        (MissingExtraError("extra"), 2, 1),
        (KeyboardInterrupt(), 130, 0),
        (BrokenPipeError(), 141, 0),
    ],
)
def test_expected_errors_are_one_line(error, code, lines, capsys):
    def fails(_):
        raise error

    assert terminal.run(parser_for(fails), ["go"]) == code
    out, err = capsys.readouterr()
    assert (out, err.count("\n"), "\x1b" in err) == ("", lines, False)
    assert err.startswith("error: " * lines)


def test_interrupted_cleanup_counts_as_interrupted(capsys):
    def fails(_):
        with ZipFile(io.BytesIO(), "w") as archive:
            part = archive.open("part", "w")  # NumPy is interrupted before it closes it
            part.write(b"half")
            raise KeyboardInterrupt

    def closes(_):
        try:
            raise KeyboardInterrupt
        finally:
            raise InputError("cannot be closed")

    for command in (fails, closes):
        assert terminal.run(parser_for(command), ["go"]) == 130
        assert capsys.readouterr().err == ""


#: Bad input of a kind that argparse finds, and of a kind that a command finds.
BAD = {
    "arrangement": ("count", "faces", "draw planes", "identify"),
    "equilibrium": ("solve", "resisted", "verify", "info"),
    "proofs_check": ("run", "sweep", "grade", "report"),
}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("package", BAD)
def test_exit_code_does_not_need_stderr(package, monkeypatch):
    main = import_module(f"{package}.cli").main
    for command in BAD[package]:
        for words in ([*command.split(), "absent.json"], [command, "--absent"]):
            with Path("/dev/full").open("w", buffering=1) as full:
                monkeypatch.setattr(sys, "stderr", full)
                try:
                    code = main(words)
                except SystemExit as left:
                    code = left.code
                assert code == 2, words


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
@pytest.mark.parametrize("words", [["--help"], ["--version"], ["count", "--help"], ["list"]])
def test_help_that_cannot_be_written_is_an_error(words, monkeypatch, capsys):
    with Path("/dev/full").open("w") as full:
        monkeypatch.setattr(sys, "stdout", full)
        assert main(words) == 2
    assert capsys.readouterr().err.startswith("error: cannot write the output")


@pytest.mark.parametrize("error", [ZeroDivisionError("x" * 999), RecursionError()])
def test_a_fault_of_the_program_is_no_answer(error, capsys):
    def fails(_):
        raise error

    assert terminal.run(parser_for(fails), ["go"]) == 70
    line = capsys.readouterr().err
    assert line.startswith(f"error: internal error, no answer: {type(error).__name__}: ")
    assert line.count("\n") == 1
    assert len(line) < 300
    assert terminal.run(parser_for(fails), ["go", "--traceback"]) == 70
    assert "Traceback (most recent call last)" in capsys.readouterr().err


@pytest.mark.parametrize("limit", ["1000000000000000", "1e308", "1e9999"])
def test_no_limit_on_files_needs_no_memory(limit, tmp_path, capsys):
    path = tmp_path / "two.json"
    path.write_text('{"schema_version": 1, "planes": [[1, 0], [0, 1]]}')
    assert main(["count", str(path), "--limit", limit]) == 0
    assert "regions          4" in capsys.readouterr().out


def test_what_memory_does_not_hold_is_refused(capsys):
    def fails(_):
        print("half an answer")
        return len(bytearray(1 << 62))

    assert terminal.run(parser_for(fails), ["go"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: there is not enough memory")
    assert said.count("\n") == 1


def test_command_ends_when_its_steps_are_spent(capsys):
    done = []

    def never_ends(_):
        budget.allow(1000)
        while True:
            try:
                budget.spend(300)
                done.append(300)
            except Exception:
                pass  # what takes errors for bad input does not go on

    assert terminal.run(parser_for(never_ends), ["go", "--limit", "2"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: it has taken 2,100 steps without an answer; ask for less")
    assert said.endswith("or --limit 4 allows more\n")
    assert len(done) == 6
    budget.spend(10**12)  # not a command


@pytest.mark.parametrize(
    ("options", "ends"), [([], True), (["--store", "x"], False), (["--time-limit", "1"], False)]
)
def test_command_takes_any_steps_only_where_asked_explicitly(options, ends, capsys):
    def long(_):
        budget.spend(2 * budget.COMMAND_STEPS)
        return terminal.YES

    parser = terminal.command_parser("program", "Go on.")
    parser.add_argument("--store")
    parser.add_argument("--time-limit", type=float)
    parser.set_defaults(command=long)
    assert terminal.run(parser, options) == 2 * ends


@pytest.mark.parametrize("words", [["-o=--"], ["--jobs=--"]])
def test_dashes_alone_are_no_value(words, capsys):
    assert "it is '--'; expected a value" in refused(words, capsys)


@pytest.mark.parametrize(
    "words",
    [["-o", "a", "--output", "b"], ["--jobs", "2", "--jobs=2"], ["--wrench", "1", "--wrench", "2"]],
)
def test_option_given_twice_is_refused(words, capsys):
    assert "it is given twice; give it once" in refused(words, capsys)


def test_options_that_add_up_may_be_repeated():
    words = ["--literal", "a", "--literal", "b", "--json", "--json", "-o", "x"]
    found = repeating().parse_args(words)
    assert (found.literal, found.json, found.output) == (["a", "b"], True, "x")
    assert repeating().parse_args(words) == found


def repeating() -> Parser:
    parser = Parser(prog="try")
    parser.add_argument("-o", "--output")
    parser.add_argument("--jobs", type=values.integer_argument)
    parser.add_argument("--wrench", nargs="+", type=values.rational_argument)
    parser.add_argument("--literal", nargs="+", action="extend")
    parser.add_argument("--json", action="store_true")
    return parser


def refused(words, capsys) -> str:
    """Return the one line of an error about words of the command line."""
    with pytest.raises(SystemExit) as caught:
        repeating().parse_args(words)
    assert caught.value.code == 2
    line, *_ = capsys.readouterr().err.splitlines()
    return str(line)


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
    parser.add_argument("--x", nargs=2, type=values.rational_argument)
    parser.add_argument("--y", action="store_true")
    assert parser.parse_args([*words, "--y"]).x == [1, -2]


def test_a_fault_at_import_is_no_answer(tmp_path, monkeypatch, capsys):
    (tmp_path / "broken_program.py").write_text("import no_such_library\n", encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    assert entry("broken_program")([]) == 70
    assert "the module no_such_library is missing" in capsys.readouterr().err


@pytest.mark.parametrize(("given", "used"), [({}, "1"), ({"OPENBLAS_NUM_THREADS": "3"}, "3")])
def test_programs_use_one_thread_unless_told(given, used, tmp_path):
    text = "import os, sys\ndef main(argv):\n    assert 'numpy' not in sys.modules\n"
    text += "    print(os.environ['OPENBLAS_NUM_THREADS'])\n    return 0\n"
    (tmp_path / "some_program.py").write_text(text, encoding="utf-8")
    run = "from arrangement.console.entry import entry; entry('some_program')()"
    paths = os.pathsep.join([str(tmp_path), *filter(None, sys.path)])
    environment = {**os.environ, "PYTHONPATH": paths, **given}
    if not given:
        environment.pop("OPENBLAS_NUM_THREADS", None)
    words = [sys.executable, "-c", run]
    assert subprocess.check_output(words, env=environment, text=True, timeout=60).strip() == used


@pytest.mark.parametrize(
    ("missing", "module", "words"),
    [
        ("numpy", "arrangement.console.entry", "count pencil"),
        ("numpy", "equilibrium.cli", "resisted ladder --wrench 0 1 0"),
        ("lazy_loader", "equilibrium.cli", "resisted ladder --wrench 0 1 0"),
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


def test_bar_shows_rate_and_remaining_time():
    now = [100.0]
    bar = Bar(None, "samples", clock=lambda: now[0])
    bar.begin(200, 1000)
    now[0] = 110.0
    bar.update(400)
    assert bar.text() == "[#########...............] 400/1000 samples, 20 samples/s, 0:30 left"
    bar.update(1000)
    assert "1000/1000" in bar.text()
    assert Bar(None, "cases", clock=lambda: now[0]).text().startswith("0 cases")


def test_the_bar_is_on_a_terminal_only(monkeypatch, capsys):
    Bar(10, "samples").update(5)
    assert capsys.readouterr() == ("", "")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    bar = Bar(10, "samples")
    bar.update(5)
    bar.close()
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "5/10 samples" in captured.err


def test_progress_in_a_pipe_gets_ever_fewer_lines(monkeypatch, capsys):
    monkeypatch.setattr(progress, "_FIRST", 2.0)
    now = [0.0]
    bar = Bar(100, "samples", clock=lambda: now[0])
    quiet = Bar(100, "claims", clock=lambda: now[0], piped=False)
    for done in range(1, 101):
        now[0] = 1.0 * done
        bar.update(done)
        quiet.update(done)
    bar.close()
    lines = capsys.readouterr().err.splitlines()
    assert "] 2/100 samples" in lines[0]
    assert 10 < len(lines) < 30
    assert not any("claims" in line or "\r" in line for line in lines)


@pytest.fixture
def on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take every stderr for a terminal, and let lines come at once."""
    monkeypatch.setattr(progress, "on_terminal", lambda: True)
    monkeypatch.setattr(progress, "_PATIENCE", 0.0)
    monkeypatch.setattr(progress, "_PAUSE", 0.0)


@pytest.mark.usefixtures("on_a_terminal")
def test_a_bar_waits_and_says_what_is_at_work(capsys):
    now = [0.0]
    bar = Bar(4, "claims", clock=lambda: now[0], patience=1.0)
    bar.update(1, "the first")
    bar.close()
    assert capsys.readouterr().err == ""
    now[0] = 1.5
    bar.update(2, "the second")
    assert capsys.readouterr().err.endswith("left: the second")


@pytest.mark.usefixtures("on_a_terminal")
def test_outermost_loop_reports_progress(capsys):
    with shown():
        assert list(watched([3, 1, 2], "things")) == [3, 1, 2]
        assert list(watched(iter("ab"), "letters", 2)) == ["a", "b"]
        for _ in watched(range(2), "outer"):
            assert list(watched(range(3), "inner")) == [0, 1, 2]
        loop = watched(range(5), "broken")
        assert next(iter(loop)) == 0
        del loop
        assert list(watched(range(2), "next")) == [0, 1]
    captured = capsys.readouterr()
    assert captured.out == ""
    for text in ("1/3 things", "3/3 things", "2/2 letters", "2/2 outer", "2/2 next"):
        assert text in captured.err
    assert "inner" not in captured.err
    assert captured.err.endswith("\r\x1b[K")


@pytest.mark.usefixtures("on_a_terminal")
def test_a_program_that_does_not_ask_sees_no_line(capsys):
    items = [1, 2]
    assert watched(items, "things") is items
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("nested", [False, True])
def test_loop_over_budget_refused_early(nested, capsys):
    done = []

    def command(arguments):
        budget.allow(60_000_000)
        for _ in watched(range(1 + nested), "outer"):
            for item in watched(range(100), "things"):
                budget.spend(1_000_000)
                done.append(item)
        return terminal.YES

    parser = terminal.command_parser("program", "Go on.")
    parser.add_argument("--limit", type=float, default=1)
    parser.set_defaults(command=command)
    assert terminal.run(parser, []) == 2
    said = capsys.readouterr().err
    assert "100 things, of which 20 are done: this would take about 100,000,000 steps; ask" in said
    assert len(done) == 20
    assert terminal.run(parser, ["--limit", "4"]) == 0


def test_a_loop_that_is_done_is_not_refused():
    with progress.shown(), budget.meter_steps(math.inf), budget.limit(1e-3):
        letters = [letter for letter in watched("ab", "letters") if not budget.spend(10**12)]
    assert letters == ["a", "b"]


@pytest.mark.usefixtures("on_a_terminal")
def test_every_command_shows_the_line_on_stderr_alone(capsys):
    def command(_):
        terminal.print_json(sum(watched([1, 2], "things")))
        return terminal.YES

    parser = terminal.command_parser("program", "Count.")
    parser.set_defaults(command=command)
    assert terminal.run(parser, []) == 0
    captured = capsys.readouterr()
    assert captured.out == "3\n"
    assert "2/2 things" in captured.err


@pytest.mark.usefixtures("on_a_terminal")
def test_a_loop_that_is_given_up_shows_no_line_of_others(capsys):
    with progress.shown():
        loop = iter(watched([1, 2], "broken"))
        assert next(loop) == 1
    del loop
    items = [1, 2]
    assert watched(items, "things") is items
    with progress.shown():
        assert list(watched(items, "things")) == items
    assert "2/2 things" in capsys.readouterr().err


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "cp850", "utf-8"])
def test_answers_are_complete_under_any_encoding(encoding, monkeypatch):
    stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    monkeypatch.setattr(sys, "stdout", stream)

    def answers(_):
        print("≈0.5 \u2212 λ m² \x1b[2J\u202e\udcff", end=" ")
        print("end")
        return terminal.YES

    assert terminal.run(parser_for(answers), ["go"]) == 0
    stream.flush()
    text = stream.buffer.getvalue().decode(encoding)
    assert text.endswith("end\n")
    assert r"\x1b[2J\u202e\udcff" in text
    assert ("≈0.5 − λ m²" in text) == (encoding == "utf-8")
    assert ("~0.5 - " in text) == (encoding in ("ascii", "cp1252", "cp850"))


#: A command of each kind, of each program, whose answers have signs beyond ASCII or may have them.
COMMANDS = [
    "arrangement count braid-a3",
    "arrangement count braid-a3 --forecast",
    "arrangement faces braid-a3 --dimension 1",
    "arrangement identify braid-a3",
    "arrangement list",
    "arrangement list --families",
    "arrangement --help",
    "equilibrium solve paper-three-contacts --wrench 0 -1 0 --digits 3",
    "equilibrium resisted paper-three-contacts --wrench 0 -1 1/7",
    "equilibrium list",
    "proofs-check list",
    "proofs-check list regions-in-print",
    "proofs-check try regions>0 --of generic(m=3..5)",
    "proofs-check fit regions --of generic(m=2..9)",
]


@pytest.mark.parametrize("line", COMMANDS)
def test_commands_answer_in_ascii(line, monkeypatch, capsys):
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr(sys, "stdout", stream)
    name, *words = line.split()
    main = import_module(f"{name.replace('-', '_')}.cli").main
    try:
        code = main(words)
    except SystemExit as left:  # after --help
        code = left.code
    stream.flush()
    assert (code, capsys.readouterr().err) == (0, "")
    assert stream.buffer.getvalue().endswith(b"\n")


@pytest.mark.parametrize(
    "words",
    [
        ["make", "shi", "--type", "9" * 5000],
        ["make", "separations", "--polytope", "cube", "--n", "x" * 5000],
        ["make", "separations", "--polytope", "cube", "--n", "x y " * 1250],
        ["show", "x" * 5000],
        ["x" * 5000],
        ["--" + "x" * 5000],
    ],
    ids=lambda words: " ".join(words)[:30],
)
def test_long_words_are_repeated_in_short(words, capsys):
    try:
        code = main(words)
    except SystemExit as ended:
        code = ended.code
    text, *_ = capsys.readouterr().err.splitlines()
    assert (code, text[:7]) == (2, "error: ")
    assert len(text) < 500


Points: TypeAlias = Annotated[Any, Syntax(values.rational_argument, ("X", "Y"), 2)]


def go_there(place: int, *, by: Iterable[Points] = (), fast: bool = False) -> None:
    """Go there, slowly
    by default.

    Args:
        place: a number.
        by: points
            on the way, 50% of them `known`.
        fast: run.

    Raises:
        ValueError: no way.
    """


def test_options_follow_from_signature_and_docstring():
    assert summary(go_there) == "Go there, slowly by default"
    options = {name: options_of(go_there)[name] for name in ("place", "by", "fast")}
    assert [option.required for option in options.values()] == [True, False, False]
    assert options["by"].several
    parser = Parser(prog="demo")
    for option in options.values():
        option.add_to(parser)
    found = parser.parse_args(["--place", "3", "--by", "1/2", "2", "--by", "3", "4"])
    assert (found.place, found.by[-1], found.fast) == (3, [3, 4], False)
    assert "points on the way, 50% of them known" in " ".join(parser.format_help().split())
