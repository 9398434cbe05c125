"""Errors of the package: each message says the value, the rule it broke, and the remedy."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager


class ArrangementError(ValueError):
    """Base class of every error that this package raises on purpose."""


class InputError(ArrangementError):
    """A value from outside breaks a rule; the command line turns it into exit code 2."""


class MissingExtraError(ArrangementError, ImportError):
    """An optional library is absent; the message names the extra that installs it."""


#: What each extra installs, as pyproject.toml has it.
EXTRAS = {
    "completion": ("shtab",),
    "dask": ("dask", "distributed", "joblib"),
    "figures": ("matplotlib", "scipy", "shapely"),
    "mesh": ("scipy", "trimesh"),
    "notebook": ("anywidget",),
    "report": ("jinja2", "latex2mathml"),
    "search": ("scipy",),
    "space": ("clarabel", "scipy"),
}


@contextmanager
def extra(name: str) -> Iterator[None]:
    """Import libraries of an extra inside.

    Raises:
        MissingExtraError: one is not installed.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        library = (error.name or "a library").partition(".")[0]
        raise MissingExtraError(
            f"{library} is not installed (the extra {name}): pip install {' '.join(EXTRAS[name])}"
        ) from None


class WorkerError(InputError):
    """Processes or machines that were to work, and cannot."""


class OutOfReachError(InputError):
    """More faces, bytes or steps than the budget has (`arrangement.numbers.budget`).

    Attributes:
        f_vector: the numbers of faces that were to be listed, where they are known.
    """

    f_vector: tuple[int, ...] | None = None


class UnfinishedError(InputError):
    """A count that is not at its end.

    Attributes:
        known: the first Whitney numbers of the first kind, which are final.
    """

    def __init__(self, message: str, known: tuple[int, ...]) -> None:
        super().__init__(message)
        self.known = known


class WaitingError(UnfinishedError):
    """A shard of a count that has done what it can, and waits for parts of the others."""


class OutOfTimeError(UnfinishedError):
    """The time that was given is over."""


def refusal(
    mistake: str, value: object, known: Iterable[str], remedy: str = "expected one of"
) -> InputError:
    """Return the error for a name that does not exist, with the nearest ones that do."""
    from difflib import get_close_matches

    names = list(known)
    near = get_close_matches(str(value), names, 3)
    meant = f"did you mean {' or '.join(near)}? " if near else ""
    return InputError(f"{mistake}; {meant}{remedy} {', '.join(names) or 'none'}")


def missing_item(noun: str, index: object, count: int) -> Exception:
    """Return the error for an item that a sequence does not have, of the type that lists raise."""
    if hasattr(index, "__index__"):
        return IndexError(f"{noun} {index} does not exist; there are {count}, numbered from 0")
    return TypeError(f"{noun}s are numbered from 0; {index!r:.40} is not such a number")
