"""What is done, the rate and the remaining time: a line on stderr that changes on a terminal.

Elsewhere (a pipe, a log) what takes more than two seconds prints a line for an item that is
finished, at growing distances. Long loops of the packages run over `watched` items. They show
nothing by themselves; a command turns their line on with `shown`, and `note` too.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sized
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeVar

from arrangement.numbers import budget

from .safe_text import one_line, safe_lines

Item = TypeVar("Item")

_WIDTH = 24
_PAUSE = 0.2
#: Steps after which a loop of some items is asked how many it will take.
_MEASURED = 3_000_000
#: Loops that end sooner show no line.
_PATIENCE = 1.0
#: Seconds to the first line in a pipe, and the longest time between two.
_FIRST, _LONGEST = 2.0, 60.0


class _Watch:
    """The line of `shown`: whether loops are counted, none reports it now, notes are printed."""

    def __init__(self, wanted: bool, notes: bool = True) -> None:
        self.counted = self.free = wanted
        self.notes = notes


#: Where `watched` loops show their line. One that is given up may end after `shown`, and then
#: frees a line that nobody sees any more.
_QUIET = _Watch(wanted=False)
_line: ContextVar[_Watch] = ContextVar("_line", default=_QUIET)


def on_terminal() -> bool:
    """Return whether someone reads stderr on a terminal."""
    return sys.stderr.isatty()


@contextmanager
def shown(wanted: bool = True, notes: bool = True) -> Iterator[None]:
    """Show the lines of loops over `watched` items inside, or none of them.

    Args:
        notes: whether `note` prints as well.
    """
    token = _line.set(_Watch(wanted, notes))
    try:
        yield
    finally:
        _line.reset(token)


def note(text: str) -> None:
    """Report on stderr, inside `shown`, what was left out or replaced."""
    line = _line.get()
    if line.free and line.notes:
        print(safe_lines(text), file=sys.stderr)


def watched(items: Iterable[Item], unit: str, total: int | None = None) -> Iterable[Item]:
    """Return the items; inside `shown` a line shows how many are done, if it takes a while.

    Of nested loops the outermost reports. One that will not end within the budget, nested or not,
    is refused as soon as the steps of its first items are known.

    Args:
        unit: of what, in the plural.
        total: their number, if they have no length.
    """
    line = _line.get()
    if not line.counted:
        return items
    known = len(items) if isinstance(items, Sized) else total
    return _telling(items, Bar(known, unit, patience=_PATIENCE), line)


def _telling(items: Iterable[Item], bar: Bar, line: _Watch) -> Iterator[Item]:
    outermost, line.free = line.free, False
    began, asked = -1.0, False
    try:
        for done, item in enumerate(items, start=1):
            yield item
            if outermost:
                bar.update(done)
            # Without the first, which may find what others use.
            began = budget.steps_spent() if began < 0 else began
            if asked or not bar.total or not max(2, min(20, bar.total / 4)) <= done < bar.total:
                continue
            taken = budget.steps_spent() - began
            if taken > _MEASURED:
                asked = True
                text = f"{bar.total:,} {bar.unit}, of which {done:,} are done"
                budget.check_cost(text, "ask for less", long_steps=taken / (done - 1) * bar.total)
    finally:
        bar.close()
        line.free = line.free or outermost


class Bar:
    """Progress of a known or unknown total.

    Args:
        total: what is to be done; None if unknown (see `begin`).
        unit: of what, in the plural.
        patience: seconds before anything is written on a terminal.
        piped: whether anything is written when stderr is not a terminal.
    """

    def __init__(
        self,
        total: int | None,
        unit: str,
        clock: Callable[[], float] = time.monotonic,
        patience: float = 0.0,
        piped: bool = True,
    ) -> None:
        self.total, self.unit, self.first, self.done = total, unit, 0, 0
        self._clock = clock
        self._start = clock()
        self._drawn: float | None = None
        self._terminal = on_terminal()
        self._due = self._start + (patience if self._terminal else _FIRST)
        self.note = ""
        self.visible = self._terminal or piped

    def begin(self, done: int, total: int) -> None:
        """Report what was done before, and the total, once both are known."""
        self.first, self.total, self._start = done, total, self._clock()

    def update(self, done: int, note: str | None = None) -> None:
        """Report how much is done now, and what is at work."""
        self.done = done
        self.note = self.note if note is None else note
        now = self._clock()
        if not self.visible or now < self._due:
            return
        if self._terminal:
            self._drawn, self._due = now, now + _PAUSE
            print(f"\r\x1b[K{self.text()}", end="", file=sys.stderr, flush=True)
        else:
            self._due = now + min(max(_FIRST, (now - self._start) / 4), _LONGEST)
            print(self.text(), file=sys.stderr, flush=True)

    def close(self) -> None:
        """Erase the line."""
        if self._drawn is not None:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)

    def text(self) -> str:
        """Return the line: a bar, numbers, the rate, the remaining time, what is at work."""
        return f"{self._numbers()}: {one_line(self.note)}" if self.note else self._numbers()

    def _numbers(self) -> str:
        passed = self._clock() - self._start
        rate = (self.done - self.first) / passed if passed > 0 else 0.0
        speed = "" if self.unit == "seconds" else f", {rate:.3g} {self.unit}/s"
        if self.total is None:
            return f"{self.done} {self.unit}{speed}"
        filled = _WIDTH * self.done // self.total if self.total else _WIDTH
        bar = f"[{'#' * filled}{'.' * (_WIDTH - filled)}]"
        left = duration((self.total - self.done) / rate) if rate > 0 else "?"
        return f"{bar} {self.done}/{self.total} {self.unit}{speed}, {left} left"


def duration(seconds: float) -> str:
    """Return a time in hours, minutes and seconds, rounded up.

    >>> duration(3725), duration(59.2)
    ('1:02:05', '1:00')
    """
    whole = int(-(-seconds // 1))
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
