"""What a shell and a terminal get: completion, versions, colours."""

import io
import os
import shutil
import subprocess
import sys
from importlib import import_module
from importlib.metadata import version

import pytest

from arrangement.console.safe_text import safe_stdout
from equilibrium.cli.colours import print_verdict

PROGRAMS = ("arrangement", "equilibrium", "proofs-check")


def run(program, *words):
    main = import_module(f"{program.replace('-', '_')}.cli").main
    try:
        return main(words)
    except SystemExit as left:
        return left.code


@pytest.mark.parametrize("program", PROGRAMS)
def test_version_names_what_computes(program, capsys):
    assert run(program, "--version") == 0
    first = f"{program} {version('slipstates')} (Python 3."
    text = capsys.readouterr().out
    assert text.startswith(first)
    assert f"numpy {version('numpy')}, " in text
    assert f"python-flint {version('python-flint')})" in text


def completed(script, *words):
    """Return what bash would complete the last word with."""
    program = f"""
source {script}
COMP_WORDS=({" ".join(words)} "")
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 2))
complete -p {words[0]} | sed 's/.*-F \\([^ ]*\\).*/\\1/' > {script}.name
COMPREPLY=()
$(cat {script}.name)
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
    found = subprocess.run(
        ["bash", "-c", program], capture_output=True, text=True, check=True, cwd=script.parent
    )
    return found.stdout.split()


@pytest.mark.skipif(
    os.name == "nt" or shutil.which("bash") is None, reason="there is no bash, or one of Windows"
)
def test_bash_completes_commands_options_and_names(tmp_path, capsys):
    pytest.importorskip("shtab")
    for program in PROGRAMS:
        assert run(program, "--print-completion", "bash") == 0
        (tmp_path / program).write_text(capsys.readouterr().out)
    scripts = [tmp_path / program for program in PROGRAMS]
    (tmp_path / "braid-mine.json").touch()
    assert completed(scripts[0], "arrangement", "co") == ["count", "convert"]
    found = completed(scripts[0], "arrangement", "count", "braid-")
    assert {*found} == {"braid-a3", "braid-a3-in-r4", "braid-mine.json"}
    assert "--time-limit" in completed(scripts[0], "arrangement", "count", "--t")
    assert "sphere" in completed(scripts[0], "arrangement", "draw", "--view", "sp")
    assert completed(scripts[1], "equilibrium", "solve", "hanging") == ["hanging-picture"]
    assert completed(scripts[2], "proofs-check", "list", "regions-in-p") == ["regions-in-print"]


@pytest.mark.parametrize("shell", ["zsh", "fish"])
def test_other_shells_take_their_scripts(shell, tmp_path, capsys):
    pytest.importorskip("shtab")
    script = tmp_path / "script"
    assert run("proofs-check", "--print-completion", shell) == 0
    script.write_text(capsys.readouterr().out)
    assert "regions-in-print" in script.read_text()
    if shutil.which(shell):
        subprocess.run([shell, "-n", str(script)], check=True)


def test_completion_without_its_library_names_the_extra(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "shtab", None)
    assert run("equilibrium", "--print-completion", "bash") == 2
    error = "error: shtab is not installed (the extra completion): pip install shtab\n"
    assert capsys.readouterr().err == error


class Terminal(io.StringIO):
    def isatty(self):
        return True


def printed(monkeypatch, stream, *arguments):
    monkeypatch.setattr(sys, "stdout", stream)
    with safe_stdout():
        print_verdict(*arguments)
    return stream.getvalue()


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("resisted: 1 equilibrium",), "\x1b[32mresisted\x1b[0m: 1 equilibrium\n"),
        (("not resisted",), "\x1b[31mnot resisted\x1b[0m\n"),
        (("! no  weak",), "! \x1b[31mno\x1b[0m  weak\n"),
        (("resisted for t in [0, 1]",), "resisted for t in [0, 1]\n"),
        (("refuted-id  refuted\n    x", "refuted"), "refuted-id  \x1b[31mrefuted\x1b[0m\n    x\n"),
        (("a (b)\n  verdict  proved", "proved"), "a (b)\n  verdict  \x1b[32mproved\x1b[0m\n"),
        (
            ("a  no counterexample found (3 tried)", "no counterexample found"),
            "a  \x1b[33mno counterexample found\x1b[0m (3 tried)\n",
        ),
        (
            ("a  holds in all cases under the hypothesis b", "holds in all cases"),
            "a  \x1b[36mholds in all cases\x1b[0m under the hypothesis b\n",
        ),
        (("undecided \x1b[5m",), "\x1b[33mundecided\x1b[0m \\x1b[5m\n"),
    ],
)
def test_verdicts_have_colours_on_a_terminal(arguments, text, monkeypatch):
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("WT_SESSION", "1")
    assert printed(monkeypatch, Terminal(), *arguments) == text


@pytest.mark.parametrize(
    ("stream", "name", "value"),
    [(io.StringIO, "TERM", "xterm"), (Terminal, "NO_COLOR", "1"), (Terminal, "TERM", "dumb")],
)
def test_no_colours_elsewhere(stream, name, value, monkeypatch):
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv(name, value)
    assert printed(monkeypatch, stream(), "resisted: 1 equilibrium") == "resisted: 1 equilibrium\n"
