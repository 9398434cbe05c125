"""Settings for the whole suite."""

import functools
import gc
import json
import math
import os
import pickle
from collections.abc import Callable, Generator, Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from arrangement.console import progress, workers
from tests import assertions, latex as tex
from tests.browser import MISSING, Browser, left_out, programs, running
from tests.javascript.check import node

ROOT = Path(__file__).resolve().parent.parent
#: On Windows there is no fork, and no module resource.
collect_ignore = (
    []
    if hasattr(os, "fork")
    else [
        "arrangement/test_budget.py",
        "check_package.py",
        "check_versions.py",
        "mutants.py",
        "test_check_package.py",
        "test_clock.py",
        "test_layers.py",
    ]
)

# The same examples on every run and every machine; speed is not a verdict.
settings.register_profile(
    "ci",
    max_examples=25,
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=[HealthCheck.too_slow],
)
# A slow machine changes no output: lines of progress in a pipe are tested on a clock of their own.
progress._FIRST = math.inf
# For a search with fresh examples: pytest --hypothesis-profile=search
settings.register_profile("search", max_examples=1000, deadline=None, print_blob=True)
settings.load_profile("ci")


#: What takes longest comes first, so that at the end no worker is left alone with it.
LONGEST = {"test_pictures.py", "test_docs.py", "test_layers.py", "test_draw_views.py"}


def pytest_configure(config: pytest.Config) -> None:
    """Let tests fail that execute no assertion."""
    config.pluginmanager.register(assertions)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Let the garbage collector pass over the items collected, which stay, now and later.

    It runs after 50,000 new objects in place of 700, and rarely over older ones.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()
        gc.freeze()
        gc.set_threshold(50_000, 20, 50)


@functools.cache
def _uses_sympy(path: Path) -> bool:
    return path.suffix == ".py" and "sympy" in path.read_text(encoding="utf-8")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark what meets SymPy, so that it can run with each of SymPy's ground types.

    Tests that open pages or compile TikZ are deselected where they are not wanted or cannot run,
    and slow ones unless the marker expression names them (`-m slow`). All that open pages are slow.
    """
    for item in items:
        if _uses_sympy(item.path):
            item.add_marker(pytest.mark.ground_types)
        if "browser" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.slow)
    unwanted = set()
    if left_out():
        # Questions to the modules of a page run in node, too.
        pages = {"browser"} if node() else {"browser", "ask"}
        unwanted |= {item for item in items if pages & set(getattr(item, "fixturenames", ()))}
    if tex.not_compiled():
        unwanted |= {item for item in items if "latex" in getattr(item, "fixturenames", ())}
    if "slow" not in config.option.markexpr:
        unwanted |= {item for item in items if item.get_closest_marker("slow")}
    config.hook.pytest_deselected(items=[item for item in items if item in unwanted])
    items[:] = [item for item in items if item not in unwanted]
    items.sort(key=lambda item: item.path.name not in LONGEST)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say at the end of a run what it could not look at."""
    for reason in filter(None, (left_out(), tex.not_compiled())):
        terminalreporter.write_line(reason, yellow=True)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """Return a running headless Chromium; see `tests.browser` for where it must come from."""
    if programs() is None:
        pytest.fail(MISSING, pytrace=False)
    with running() as found:
        yield found


class Command:
    """A command of the project, run in this process."""

    def __init__(self, name: str, streams: pytest.CaptureFixture[str]) -> None:
        self.main = import_module(f"{name}.cli").main
        self.streams = streams
        self.out = self.err = ""  # of the last run

    def __call__(self, line: object, *words: object, code: int | None = 0) -> str:
        """Return what the command prints; it ends with the code: None stands for 0 and 1.

        The line is split at spaces. Each word takes the place of a `{}` or stands after the line;
        it may contain spaces.
        """
        self.streams.readouterr()
        rest = map(str, words)
        arguments = [next(rest) if part == "{}" else part for part in str(line).split()]
        try:
            ended = self.main([*arguments, *rest])
        except SystemExit as stop:
            ended = stop.code
        self.out, self.err = self.streams.readouterr()
        assert ended in ((0, 1) if code is None else (code,)), self.err
        return self.out

    def json(self, line: object, *words: object, code: int | None = 0) -> Any:
        """Return the document that the command prints with `--json`."""
        return json.loads(self(line, *words, "--json", code=code))

    def error(self, line: object, *words: object, code: int = 2) -> str:
        """Return the error of a command that is refused: one line, after notes, and its list."""
        self(line, *words, code=code)
        *notes, last = (row for row in self.err.splitlines() if not row.startswith("  "))
        assert all(note.startswith(("note: ", "rounded: ")) for note in notes)
        assert (self.out, last[:7]) == ("", "error: ")
        return self.err


@pytest.fixture
def run(request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]) -> Command:
    """Return the command of the package whose tests stand in this folder."""
    return Command(request.path.parent.name, capsys)


@pytest.fixture
def refused(run: Command) -> Callable[..., str]:
    """Return a function that returns the error of a command line."""
    return run.error


@pytest.fixture
def scrambled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Do here what other processes are to do, in another order; what they exchange is pickled.

    That processes start, die and end is tested with a few real ones.
    """

    def on_processes(
        function: Callable[[Any, Any], Any], plan: Any, numbers: Sequence[Any], jobs: int
    ) -> Iterator[Any]:
        function, plan = _pickled((function, plan))
        for number in reversed(numbers):
            yield _pickled(function(plan, _pickled(number)))

    monkeypatch.setattr(workers, "on_processes", on_processes)


def _pickled(value: Any) -> Any:
    return pickle.loads(pickle.dumps(value))


@pytest.fixture(scope="session")
def latex() -> None:
    """Demand pdflatex; see `tests.latex` for where it must come from."""
    if not tex.is_there():
        pytest.fail(tex.MISSING, pytrace=False)
