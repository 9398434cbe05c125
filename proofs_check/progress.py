"""A line on stderr with what is done, the rate and the remaining time; only on a terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

_WIDTH = 24
_PAUSE = 0.2


class Bar:
    """Progress of a known or unknown total; nothing is written when stderr is no terminal.

    Args:
        total: what is to be done; None if unknown (see `begin`).
        unit: of what, in the plural.
        started_with: what was done before, so that the rate is of this run alone.
    """

    def __init__(
        self,
        total: int | None,
        unit: str,
        started_with: int = 0,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.total, self.unit, self.first, self.done = total, unit, started_with, started_with
        self._clock = clock
        self._start = clock()
        self._drawn = -1.0
        self.visible = sys.stderr.isatty()

    def begin(self, done: int, total: int) -> None:
        """Say what was done before, and the total, once both are known."""
        self.first, self.total, self._start = done, total, self._clock()

    def update(self, done: int) -> None:
        """Say how much is done now."""
        self.done = done
        now = self._clock()
        if self.visible and (now - self._drawn >= _PAUSE or done == self.total):
            self._drawn = now
            print(f"\r\x1b[K{self.text()}", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Take the line away."""
        if self.visible:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)

    def text(self) -> str:
        """Return the line: a bar, numbers, the rate, the remaining time."""
        passed = self._clock() - self._start
        rate = (self.done - self.first) / passed if passed > 0 else 0.0
        speed = f"{rate:.3g} {self.unit}/s"
        if self.total is None:
            return f"{self.done} {self.unit}, {speed}"
        filled = _WIDTH * self.done // self.total if self.total else _WIDTH
        bar = f"[{'#' * filled}{'.' * (_WIDTH - filled)}]"
        left = duration((self.total - self.done) / rate) if rate > 0 else "?"
        return f"{bar} {self.done}/{self.total} {self.unit}, {speed}, {left} left"


def duration(seconds: float) -> str:
    """Return a time in hours, minutes and seconds, rounded up.

    >>> duration(3725), duration(59.2)
    ('1:02:05', '1:00')
    """
    whole = int(-(-seconds // 1))
    minutes, rest = divmod(whole, 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
