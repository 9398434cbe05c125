"""Time limits in seconds that the user asked for; no other limit looks at a clock."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from arrangement.errors import InputError

from .budget import spend

#: The clock of every time limit, in seconds; tests replace it.
clock: Callable[[], float] = time.monotonic


#: The time limit of the work that is done now, for loops far below it.
_kept: ContextVar[Deadline | None] = ContextVar("_kept", default=None)


class Deadline:
    """The moment at which a time limit is over.

    Args:
        seconds: the time limit, positive; None for no limit.

    Raises:
        InputError: the limit is not a positive number.

    >>> Deadline(None).passed, Deadline(60).passed
    (False, False)
    """

    def __init__(self, seconds: float | None = None) -> None:
        if seconds is not None and not seconds > 0:
            raise InputError(f"time_limit is {seconds!r}; expected a positive number of seconds")
        self.seconds = seconds
        self._end = math.inf if seconds is None else clock() + seconds

    @property
    def passed(self) -> bool:
        """Whether the time limit is over."""
        return self._end < math.inf and clock() > self._end

    @property
    def remaining(self) -> float:
        """Seconds that are left, infinite without a limit."""
        return self._end - clock() if self._end < math.inf else math.inf

    def check(self, work: float = 1) -> None:
        """Count work (`budget.spend`); raise `TimeoutError` when the time limit is over.

        Args:
            work: the steps from this look to the next one.
        """
        spend(work)
        if self.passed:
            raise TimeoutError(str(self))

    @contextmanager
    def enforce(self) -> Iterator[None]:
        """Let `check_time` inside raise `TimeoutError` when the time limit is over."""
        token = _kept.set(self)
        try:
            yield
        finally:
            _kept.reset(token)

    def __str__(self) -> str:
        return "no time limit" if self.seconds is None else f"time limit of {self.seconds:g} s"


def check_time() -> None:
    """Raise `TimeoutError` when the time limit of the work that is done now is over."""
    deadline = _kept.get()
    if deadline is not None and deadline.passed:
        raise TimeoutError(str(deadline))
