"""What one search may take: work, which is counted, and the seconds that a user asked for."""

from __future__ import annotations

import math

from arrangement.numbers import budget
from arrangement.numbers.deadline import Deadline

#: Steps of one question in the plane and in space, see `Effort`: about 20 and 60 seconds.
STEPS = {2: 200_000_000, 3: 600_000_000}


class Effort(Deadline):
    """The steps that are left to a search, and its time limit.

    Steps are those of `arrangement.numbers.budget`, about ten million a second. Which of them a
    question takes depends on no clock, so a limit ends it at the same place on every machine.

    Args:
        steps: that may be taken.
        seconds: the time limit, positive; None for no limit.

    Raises:
        InputError: the limit is not a positive number.

    >>> effort = Effort(1000)
    >>> effort.check(600)
    >>> effort.check(600)
    Traceback (most recent call last):
        ...
    TimeoutError: limit of 1,000 steps
    """

    def __init__(self, steps: float = math.inf, seconds: float | None = None) -> None:
        super().__init__(seconds)
        self.steps, self.spent = steps, 0.0

    @classmethod
    def usual(cls, steps: float) -> Effort:
        """Return steps for one question, scaled; no more than the command that runs has left."""
        return cls(min(steps * budget.times(), budget.steps_left()))

    @property
    def passed(self) -> bool:
        """Whether one of the two limits is over."""
        return self.spent > self.steps or super().passed

    def check(self, work: float = 1) -> None:
        """Count steps, and raise `TimeoutError` when a limit is over."""
        self.spent += work
        if self.spent > self.steps:
            raise TimeoutError(str(self))
        super().check(work)

    def __str__(self) -> str:
        return f"limit of {self.steps:,.0f} steps" if self.spent > self.steps else super().__str__()
