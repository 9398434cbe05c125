"""What one question may cost, in faces, bytes and seconds: the one room for limits of size.

Whoever is about to list, count, make or read something says here first what that will take. What is
out of reach is refused before it begins, with the forecast. Forecasts are of one processor of
2025; they may be wrong by a factor of three. `limit` raises the budget, the option ``--limit`` too.
"""

from __future__ import annotations

import math
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

from arrangement.errors import InputError, OutOfReachError

#: What a question may take; and the seconds of work for which more were asked, where it tells how
#: far it is.
FACES, BYTES, SECONDS, TOLD = 20_000_000, 400 * 2**20, 2, 300
#: Seconds after which a command ends whose time nobody foresaw: slow machines get there, too.
STOPPED = 10
#: What is read, shown or tried at most.
MOST = {
    "bytes of a file": 4 * 2**20,
    "bytes of a certificate": 64 * 2**20,
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
    "directions in a picture": 720,
    "wrenches in a picture": 24,
}
#: A pace is measured, also on slow and busy machines: so many times as long as what is foreseen.
_BUSY = 3
#: So many times.
_times: ContextVar[float] = ContextVar("_times", default=1.0)
#: The seconds of work that tells how far it is.
_told: ContextVar[float] = ContextVar("_told", default=TOLD)


@contextmanager
def limit(times: float) -> Iterator[None]:
    """Let what is inside take so many times the faces, bytes and seconds; `math.inf`: anything.

    >>> with limit(2):
    ...     ask("a list of all of them", faces=35_000_000)
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
            f"more with --limit {math.ceil(number / MOST[kind])}"
        )


def excess(*, faces: float = 0, bytes: float = 0, seconds: float = 0, told: float = 0) -> float:
    """Return how many times the budget that would take, the one that is most exceeded."""
    shares = ((faces, FACES), (bytes, BYTES), (seconds, SECONDS), (told, _told.get()))
    # integers may be too long for floats
    return max(n / most if n < 1e300 else math.inf for n, most in shares) / _times.get()


def ask(
    what: str,
    instead: str = "",
    *,
    faces: float = 0,
    bytes: float = 0,
    seconds: float = 0,
    told: float = 0,
) -> None:
    """Refuse what is out of reach.

    Args:
        what: it is, such as "a list of 5 planes".
        instead: what to ask, without a full stop.
        told: seconds of work that tells how far it is.

    Raises:
        OutOfReachError: with the forecast.
    """
    over = excess(faces=faces, bytes=bytes, seconds=seconds, told=told)
    if over <= 1:
        return
    takes = (
        (faces, FACES, f"{about(faces)} faces"),
        (bytes, BYTES, f"{about(bytes / 2**20 if bytes < 1e300 else bytes)} MB"),
        (seconds, SECONDS, f"{about(seconds)} seconds"),
        (told, _told.get(), f"{about(told)} seconds"),
    )
    forecast = " and ".join(text for n, most, text in takes if n > most * _times.get())
    times = over * _times.get()
    remedies = [instead] if instead else []
    if times < 1e6:
        remedies.append(f"--limit {math.ceil(1.2 * times)} allows it")
    raise OutOfReachError(
        f"{what}: this would take about {forecast}; " + (", or ".join(remedies) or "ask for less")
    )


class TimeOver(BaseException):
    """A command has taken its time; no handler of errors on the way may take it for bad input."""


def watch(seconds: float) -> None:
    """Raise `TimeOver` when the processor has worked so long, times the limit; 0: no more.

    For commands whose time nobody can foresee. Only in the main thread, and not on Windows.
    """
    most = min(seconds * times(), 1e9)
    # What takes longer than usual is to be asked for in so many words.
    _told.set(_BUSY * SECONDS if 0 < seconds <= STOPPED else min(seconds or TOLD, TOLD))

    def over(*_: Any) -> None:
        raise TimeOver(
            f"it has taken {about(most)} seconds of the processor, without an end; ask for less, "
            f"or --limit {math.ceil(2 * times())} allows more"
        )

    if hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGVTALRM, over)
        # Again every second: what is raised while an object is deleted is lost.
        signal.setitimer(signal.ITIMER_VIRTUAL, most, min(most, 1))


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
