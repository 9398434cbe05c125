"""Limits of size and work: what takes too much is refused, before it begins where that is possible.

1. `check_cost` refuses work whose forecast (in faces, bytes or steps) is above the budget.
2. `check_size` refuses more things of a kind than `MAX_SIZES` allows.
3. `spend` counts the steps of work that has no forecast; a command (`meter_steps`) ends after
   `COMMAND_STEPS`. In Python these steps are free.

A step is about 0.1 microseconds on a CPU of 2025. No clock is read, so that every machine gives the
same answer. `limit` scales all limits, as the option ``--limit`` does.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

from arrangement.errors import InputError, OutOfReachError

Remedy = TypeVar("Remedy")

#: Faces of one list.
FACES = 20_000_000
#: Memory of one piece of work.
BYTES = 400 * 2**20
#: Steps of one piece of work without progress output: about two seconds.
STEPS = 20_000_000
#: Steps of one piece of work with progress output: its user sees the end coming in five minutes.
LONG_STEPS = 3_000_000_000
#: Steps of a command, of all its work together: about half a minute.
COMMAND_STEPS = 300_000_000
#: Forecast of work with progress output in such a command, which else would run for minutes.
COMMAND_LONG_STEPS = 60_000_000
#: How many things of a kind are read, drawn or tried; docs/accuracy.rst has the same numbers.
MAX_SIZES = {
    "bytes of a file": 4 * 2**20,
    "bytes of a certificate": 64 * 2**20,
    "bytes of a mesh": 32 * 2**20,
    "bytes of a file of many arrangements": 64 * 2**20,
    "bytes of many grasps": 256 * 2**20,
    "bytes of a record": 256 * 2**20,
    "characters of a number": 100_000,
    "digits of a number on a page": 1000,
    "coordinates": 1000,
    "planes in the lab": 20,
    "contacts in the lab": 8,
    "planes whose symmetry is looked for": 60,
    "planes in a picture": 1000,
    "great circles in a picture": 60,
    "great circles on a page": 40,
    "planes in a body": 40,
    "cells in a picture": 400,
    "flats of one rank in a picture": 500,
    "regions in a picture": 1200,
    "contacts with a choice of three states": 12,
    "contacts in a picture": 200,
    "open ranges of friction coefficients": 2000,
    "rays in a picture": 720,
    "wrenches in a picture": 24,
}
#: From here on numbers may be too large for floats; only "far above every limit" matters of them.
_NEARLY_INFINITE = 1e300
#: Powers and binomial coefficients of more bits count as infinite.
_MAX_BITS = 900
#: A refusal suggests no larger factor of the limits: the work would not end.
_MAX_SUGGESTED_FACTOR = 1e6

#: The factor of all limits.
_factor: ContextVar[float] = ContextVar("_factor", default=1.0)
#: The steps of the command that runs; None in Python.
_meter: ContextVar[_Meter | None] = ContextVar("_meter", default=None)


@dataclass
class _Meter:
    """The steps that a command may take (before scaling), and has taken."""

    allowed: float
    spent: float = 0


@contextmanager
def limit(times: float) -> Iterator[None]:
    """Scale all limits inside by a factor; `math.inf`: no limits.

    >>> with limit(2):
    ...     check_cost("a list of all of them", faces=35_000_000)
    """
    if not times > 0:
        raise InputError(f"the limit is {times}; give a positive number of times the usual budget")
    token = _factor.set(times)
    try:
        yield
    finally:
        _factor.reset(token)


def times() -> float:
    """Return the factor by which all limits are scaled now."""
    return _factor.get()


def check_cost(
    what: str,
    instead: str = "",
    *,
    faces: float = 0,
    bytes: float = 0,
    steps: float = 0,
    long_steps: float = 0,
) -> None:
    """Refuse work whose forecast is above the budget; count its steps otherwise.

    Args:
        what: the work, such as "a list of 5 planes".
        instead: what to do instead, without a full stop.
        steps: of work without progress output.
        long_steps: of work with progress output, which counts them itself as it goes.

    Raises:
        OutOfReachError: with the forecast, and what allows it.
    """
    costs = _costs(faces, bytes, steps, long_steps)
    factor = _needed_factor(costs)
    if factor <= times():
        spend(steps)
        return
    forecast = " and ".join(c.text() for c in costs if c.amount > c.allowed * times())
    remedies = [instead] if instead else []
    if factor < _MAX_SUGGESTED_FACTOR:
        remedies.append(f"{raised_limit(math.ceil(1.2 * factor))} allows it")
    remedy = ", or ".join(remedies) or "ask for less"
    raise OutOfReachError(f"{what}: this would take about {forecast}; {remedy}")


def excess(*, faces: float = 0, bytes: float = 0, steps: float = 0, long_steps: float = 0) -> float:
    """Return how many times the budget the work would take; above 1 `check_cost` refuses it."""
    factor = _needed_factor(_costs(faces, bytes, steps, long_steps))
    return 0.0 if times() == math.inf else factor / times()


class _Cost(NamedTuple):
    """What some work takes of one resource, and what is allowed before scaling."""

    amount: float
    allowed: float
    unit: str

    def text(self) -> str:
        if self.unit == "MB" and self.amount < _NEARLY_INFINITE:
            return f"{about(self.amount / 2**20)} MB"
        return f"{about(self.amount)} {self.unit}"


def _costs(faces: float, bytes: float, steps: float, long_steps: float) -> tuple[_Cost, ...]:
    return (
        _Cost(faces, FACES, "faces"),
        _Cost(bytes, BYTES, "MB"),
        _Cost(steps, STEPS, "steps"),
        _Cost(long_steps, _allowed_long_steps(), "steps"),
    )


def _allowed_long_steps() -> float:
    meter = _meter.get()
    if meter is None:
        return LONG_STEPS
    if meter.allowed <= COMMAND_STEPS:
        return COMMAND_LONG_STEPS
    return min(meter.allowed, LONG_STEPS)


def _needed_factor(costs: tuple[_Cost, ...]) -> float:
    """Return the factor of the limits that allows all costs."""
    return max(c.amount / c.allowed if c.amount < _NEARLY_INFINITE else math.inf for c in costs)


def by_caller(in_python: Remedy, in_command: Remedy) -> Remedy:
    """Return the remedy of an error: a call in Python, an option of a command."""
    return in_python if _meter.get() is None else in_command


def raised_limit(factor: int) -> str:
    """Return how to scale the limits."""
    return by_caller(f"with arrangement.limit({factor})", f"--limit {factor}")


def max_size(kind: str) -> int:
    """Return how many things of a kind of `MAX_SIZES` are allowed now."""
    return int(min(MAX_SIZES[kind] * times(), 1e18))  # infinity is not an int


def check_size(number: int, kind: str, where: str = "") -> None:
    """Refuse more things of a kind than `MAX_SIZES` allows.

    Args:
        where: the things are; begins the message.

    Raises:
        OutOfReachError: with what allows them.
    """
    if number <= max_size(kind):
        return
    place = f"{where}: " if where else ""
    remedy = raised_limit(math.ceil(number / MAX_SIZES[kind])).removeprefix("with ")
    raise OutOfReachError(
        f"{place}{number:,} {kind}; at most {max_size(kind):,} are allowed, or more with {remedy}"
    )


class WorkOver(BaseException):
    """A command, or other work that is counted, has taken all its steps.

    Not an `Exception`, so that no handler on the way mistakes it for bad input.
    """


@contextmanager
def meter_steps(steps: float = COMMAND_STEPS) -> Iterator[None]:
    """Count the steps inside as those of a command, which ends after a number of them (scaled)."""
    token = _meter.set(_Meter(steps))
    try:
        yield
    finally:
        _meter.reset(token)


@contextmanager
def at_most(steps: float) -> Iterator[None]:
    """Count the steps inside, in Python as well, and end what takes more (scaled).

    For work that only helps to decide about other work.

    Raises:
        WorkOver: it takes more.
    """
    inside = _Meter(steps)
    token = _meter.set(inside)
    try:
        yield
    finally:
        _meter.reset(token)
        spend(inside.spent)


def allow(steps: float) -> None:
    """Change how many steps the command that runs may take; does nothing in Python."""
    meter = _meter.get()
    if meter is not None:
        meter.allowed = steps


def spend(steps: float) -> None:
    """Count steps of the command that runs; does nothing in Python.

    >>> with meter_steps(1000):
    ...     spend(600)
    ...     steps_spent()
    600

    Raises:
        WorkOver: the command has taken more steps than it may.
    """
    meter = _meter.get()
    if meter is None:
        return
    meter.spent += steps
    if meter.spent > meter.allowed * times():
        raise WorkOver(
            f"it has taken {about(meter.spent)} steps without an answer; ask for less, or "
            f"--limit {math.ceil(2 * times())} allows more"
        )


def steps_left() -> float:
    """Return the steps that the command may still take; infinity in Python.

    >>> with meter_steps(1000):
    ...     spend(600)
    ...     steps_left()
    400.0
    """
    meter = _meter.get()
    return math.inf if meter is None else meter.allowed * times() - meter.spent


def steps_spent() -> float:
    """Return the steps that the command has taken so far; 0 in Python."""
    meter = _meter.get()
    return 0 if meter is None else meter.spent


def chunks(total: int, size: int) -> Iterator[slice]:
    """Yield consecutive slices: temporary arrays stay small, whatever the input."""
    for start in range(0, total, size):
        yield slice(start, min(start + size, total))


def about(number: float) -> str:
    """Return a number rounded, however large it is.

    >>> about(1234567), about(10**400), about(0.25)
    ('1,230,000', '10^400', '0.25')
    """
    if number < 1e15:
        return f"{float(f'{number:.3g}'):,.15g}"
    if number == math.inf:
        return "more than 10^300"
    return f"10^{math.floor(math.log10(number))}"


def choose(n: int, k: int) -> float:
    """Return a binomial coefficient; infinity where it is far above every limit."""
    if k > n:
        return 0
    chosen = max(min(k, n - k), 0)
    return math.comb(n, chosen) if _is_short(n, chosen) else math.inf


def power(base: float, exponent: float) -> float:
    """Return a power; infinity where it is far above every limit."""
    return base**exponent if _is_short(base, exponent) else math.inf


def _is_short(base: float, exponent: float) -> bool:
    """Return whether base ** exponent, which bounds a binomial coefficient too, is short."""
    return exponent * math.log2(max(base, 2)) < _MAX_BITS
