"""The line of progress: what it says, and that only a terminal sees it."""

import sys

import pytest

from arrangement.console import progress, terminal
from arrangement.console.progress import Bar, shown, watched


def test_the_bar_gives_the_rate_of_this_run_and_the_remaining_time():
    now = [100.0]
    bar = Bar(1000, "samples", 200, clock=lambda: now[0])
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


def test_in_a_pipe_a_finished_item_gets_a_line_after_two_seconds_and_then_ever_fewer(
    monkeypatch, capsys
):
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
def test_watched_items_are_the_items_and_the_line_is_taken_away(capsys):
    with shown():
        assert list(watched([3, 1, 2], "things")) == [3, 1, 2]
        assert list(watched(iter("ab"), "letters", 2)) == ["a", "b"]
    captured = capsys.readouterr()
    assert captured.out == ""
    for text in ("1/3 things", "3/3 things", "2/2 letters"):
        assert text in captured.err
    assert captured.err.endswith("\r\x1b[K")


@pytest.mark.usefixtures("on_a_terminal")
def test_of_nested_loops_the_outermost_tells(capsys):
    with shown():
        for _ in watched(range(2), "outer"):
            assert list(watched(range(3), "inner")) == [0, 1, 2]
        assert list(watched(range(2), "next")) == [0, 1]
    err = capsys.readouterr().err
    assert "2/2 outer" in err
    assert "inner" not in err
    assert "2/2 next" in err


@pytest.mark.usefixtures("on_a_terminal")
def test_a_loop_that_breaks_off_leaves_the_next_one_its_line(capsys):
    with shown():
        loop = watched(range(5), "broken")
        for item in loop:
            if item == 2:
                break
        del loop
        assert list(watched(range(2), "next")) == [0, 1]
    assert "2/2 next" in capsys.readouterr().err


@pytest.mark.usefixtures("on_a_terminal")
def test_a_program_that_does_not_ask_sees_no_line(capsys):
    items = [1, 2]
    assert watched(items, "things") is items
    assert capsys.readouterr() == ("", "")


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
    assert not progress._wanted.get()
