"""What one question may cost, in faces, bytes and steps: the one room for limits of size.

Whoever is about to list, count, make or read something says here first what that will take. What is
out of reach is refused before it begins, with the forecast. What nobody can foresee counts its
steps as it goes (`spend`), and a command ends after a number of them (`metered`). No clock is read,
so that an answer is the same on every machine; a CPU of 2025 does some ten million steps a second.
`limit` raises the budget, the option ``--limit`` too.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from arrangement.errors import InputError, OutOfReachError

#: What a question may take.
FACES = 20_000_000
BYTES = 400 * 2**20
STEPS = 20_000_000
#: Steps of work that shows how far it is.
LONG_STEPS = 3_000_000_000
#: Steps after which a command ends that did not say before how many it takes.
COMMAND_STEPS = 300_000_000
#: Steps that such a command may foresee for work that shows how far it is.
COMMAND_LONG_STEPS = 60_000_000
#: What is read, shown or tried at most.
MOST = {
    "bytes of a file": 4 * 2**20,
    "bytes of a certificate": 64 * 2**20,
    "bytes of a mesh": 32 * 2**20,
    "bytes of a file of many arrangements": 64 * 2**20,
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
#: The factor of the limits.
_times: ContextVar[float] = ContextVar("_times", default=1.0)


@dataclass
class _Meter:
    """The steps that a command may take, and took."""

    allowed: float
    spent: float = 0


#: Of the command that runs; there is none in Python.
_meter: ContextVar[_Meter | None] = ContextVar("_meter", default=None)


@contextmanager
def limit(times: float) -> Iterator[None]:
    """Scale the limits on faces, bytes and steps inside by a factor; `math.inf`: no limits.

    >>> with limit(2):
    ...     check_cost("a list of all of them", faces=35_000_000)
    """
    if not times > 0:
        raise InputError(f"the limit is {times}; give a positive number of times the usual budget")
    token = _times.set(times)
    try:
        yield
    finally:
        _times.reset(token)


def times() -> float:
    """Return how many times the usual budget is allowed now."""
    return _times.get()


def most(kind: str) -> int:
    """Return how many are allowed now, of a kind of `MOST`."""
    return int(min(MOST[kind] * times(), 1e18))


def keep(number: int, kind: str, where: str = "") -> None:
    """Refuse more of a kind than `MOST` has.

    Args:
        where: they are.

    Raises:
        OutOfReachError: with what allows them.
    """
    if number > most(kind):
        raise OutOfReachError(
            f"{where}{': ' * bool(where)}{number:,} {kind}; at most {most(kind):,} are allowed, or "
            f"more with {_larger(math.ceil(number / MOST[kind]))}"
        )


def excess(*, faces: float = 0, bytes: float = 0, steps: float = 0, long_steps: float = 0) -> float:
    """Return how many times the budget that would take, the one that is most exceeded."""
    shares = ((faces, FACES), (bytes, BYTES), (steps, STEPS), (long_steps, _most_long()))
    # integers may be too long for floats
    return max(n / most if n < 1e300 else math.inf for n, most in shares) / _times.get()


def _most_long() -> float:
    meter = _meter.get()
    if meter is not None and meter.allowed <= COMMAND_STEPS:
        return COMMAND_LONG_STEPS
    return LONG_STEPS if meter is None else min(meter.allowed, LONG_STEPS)


def check_cost(
    what: str,
    instead: str = "",
    *,
    faces: float = 0,
    bytes: float = 0,
    steps: float = 0,
    long_steps: float = 0,
) -> None:
    """Refuse what is out of reach.

    Args:
        what: it is, such as "a list of 5 planes".
        instead: what to ask, without a full stop.
        steps: what is done without a word; they count as taken.
        long_steps: steps of work that shows how far it is.

    Raises:
        OutOfReachError: with the forecast.
    """
    over = excess(faces=faces, bytes=bytes, steps=steps, long_steps=long_steps)
    if over <= 1:
        spend(steps)
        return
    takes = (
        (faces, FACES, f"{about(faces)} faces"),
        (bytes, BYTES, f"{about(bytes / 2**20 if bytes < 1e300 else bytes)} MB"),
        (steps, STEPS, f"{about(steps)} steps"),
        (long_steps, _most_long(), f"{about(long_steps)} steps"),
    )
    forecast = " and ".join(text for n, most, text in takes if n > most * _times.get())
    times = over * _times.get()
    remedies = [instead] if instead else []
    if times < 1e6:
        remedies.append(f"{_larger(math.ceil(1.2 * times))} allows it")
    raise OutOfReachError(
        f"{what}: this would take about {forecast}; " + (", or ".join(remedies) or "ask for less")
    )


def _larger(times: int) -> str:
    """Return what raises the limit: an option of a command, a call in Python."""
    return f"with arrangement.limit({times})" if _meter.get() is None else f"--limit {times}"


class WorkOver(BaseException):
    """A command has done its work; no handler of errors on the way may take it for bad input."""


@contextmanager
def metered(steps: float = COMMAND_STEPS) -> Iterator[None]:
    """Count the steps of a command, which ends after a number of them, scaled by the limit."""
    token = _meter.set(_Meter(steps))
    try:
        yield
    finally:
        _meter.reset(token)


def allow(steps: float) -> None:
    """Let the command that runs, if any, take this many steps."""
    if (meter := _meter.get()) is not None:
        meter.allowed = steps


def spent() -> float:
    """Return the steps that the command took so far; 0 in Python."""
    meter = _meter.get()
    return 0 if meter is None else meter.spent


def spend(steps: float) -> None:
    """Count steps of work whose end nobody can foresee; outside `metered` they are free.

    >>> with metered(1000):
    ...     spend(600)
    ...     spent()
    600

    Raises:
        WorkOver: the command took more than it may.
    """
    meter = _meter.get()
    if meter is None:
        return
    meter.spent += steps
    if meter.spent > meter.allowed * _times.get():
        raise WorkOver(
            f"it has taken {about(meter.spent)} steps without an answer; ask for less, or "
            f"--limit {math.ceil(2 * times())} allows more"
        )


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
    """Return a binomial coefficient, infinity where it is far out of reach."""
    few = max(min(k, n - k), 0)
    return 0 if k > n else math.comb(n, few) if few * math.log2(max(n, 2)) < 900 else math.inf


def power(base: float, exponent: float) -> float:
    """Return a power, infinity where it is far out of reach."""
    return base**exponent if exponent * math.log2(max(base, 2)) < 900 else math.inf
