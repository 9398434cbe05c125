"""Errors of the package: each message says the value, the rule it broke, and the remedy."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import FrozenInstanceError
from functools import wraps
from typing import TYPE_CHECKING, Any, ClassVar, ParamSpec, TypeVar

P = ParamSpec("P")
Returned = TypeVar("Returned")


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


#: How alike a misspelt name is to the name that is meant: "zone" and "cone" are less so, and
#: "decone" and "cone".
_ALIKE = 0.81


#: What comes before a noun, or behind it, where its number is meant; and what says nothing.
_COUNTING = re.compile(r"(?:n|nb|num|number_of|count)_(.+)|(.+)_(?:count|number)")
_FILLING = re.compile(r"(?:all|calculate|compute|contact|find|get|list|set)_(.+)")
#: What says alone which method is meant, as ``plot_regions`` does.
_DRAWING = re.compile(r"(?:draw|plot|show|visuali[sz]e)_.+")


def _lower(synonyms: Mapping[str, str]) -> dict[str, str]:
    return {word.lower(): use for word, use in synonyms.items()}


def _meant(name: str, uses: Mapping[str, str]) -> str | None:
    """Return what to write for a name: that of a known word, of which it may be a variant.

    ``num_regions`` means ``n_regions`` or ``region_count``, ``get_rank`` ``rank``, and
    ``char_poly`` ``characteristic_polynomial``.

    Args:
        uses: known words in small letters, each with what to write.
    """
    words = [name]
    if counted := _COUNTING.fullmatch(name):
        noun = counted[1] or counted[2]
        words += [f"n_{noun}", f"number_of_{noun}", f"{noun.removesuffix('s')}_count", noun]
    if filled := _FILLING.fullmatch(name):
        words += [f"with_{filled[1]}", filled[1], f"{filled[1]}s"]
    if _DRAWING.fullmatch(name):
        words += ["plot"]
    parts = name.split("_")
    for word in uses if len(parts) > 1 else ():
        whole = word.split("_")
        if len(whole) == len(parts) and all(map(str.startswith, whole, parts)):
            words.append(word)
    return next((uses[word] for word in words if word in uses), None)


def missing_attribute(owner: object, name: str, synonyms: Mapping[str, str]) -> AttributeError:
    """Return the error for an attribute that an object or a module does not have.

    Args:
        synonyms: other names of the field, each with what to write here.
    """
    from difflib import get_close_matches
    from types import ModuleType

    what = f"{type(owner).__name__!r} object"
    if isinstance(owner, (ModuleType, type)):
        kind = "module" if isinstance(owner, ModuleType) else "class"
        what = f"{kind} {owner.__name__!r}"
    hint = ""
    if not name.startswith("_"):  # `copy` and `pickle` look for many of these
        names = [known for known in dir(owner) if known[0] != "_"]
        use = _meant(name.lower(), {known.lower(): known for known in names} | _lower(synonyms))
        if name == "to_json" and "to_dict" in names:
            value = (owner if isinstance(owner, type) else type(owner)).__name__.lower()
            use = use or f"json.dumps({value}.to_dict())"
        use = use or " or ".join(get_close_matches(name, names, 2, _ALIKE))
        hint = f"; use {use}" if use else _main_names(owner)
    return AttributeError(f"{what} has no attribute {name!r}{hint}", name=name)


def _main_names(owner: object) -> str:
    """Return what a class or a module says of itself where no name is near."""
    names = ", ".join(getattr(owner, "_main", ()))
    if isinstance(owner, InstanceHintsMixin):
        owner = type(owner)
    name = getattr(owner, "__name__", "")
    return f"; {name} has {names}, ...: see help({name})" if names else ""


def _unknown_argument(
    function: Callable[..., Any], name: str, options: Iterable[str], synonyms: Mapping[str, str]
) -> TypeError | None:
    """Return the error for an argument that a function does not have, if one is given."""
    from difflib import get_close_matches
    from inspect import Parameter, signature

    parameters = signature(function).parameters
    known = [word for word in parameters if word != "self"]
    if Parameter.VAR_KEYWORD in {parameter.kind for parameter in parameters.values()}:
        return None
    for word in options:
        if word not in known:
            near = " or ".join(get_close_matches(word, known, 2, _ALIKE))
            use = synonyms.get(word) or near or f"one of {', '.join(known)}"
            return TypeError(f"{name} has no argument {word}; use {use}")
    return None


def hints_on_arguments(
    synonyms: Mapping[str, str],
) -> Callable[[Callable[P, Returned]], Callable[P, Returned]]:
    """Let a function answer an argument that it does not have with the one to use.

    Args:
        synonyms: other names of the field, each with what to write here.
    """

    def decorate(function: Callable[P, Returned]) -> Callable[P, Returned]:
        @wraps(function)
        def call(*values: P.args, **options: P.kwargs) -> Returned:
            try:
                return function(*values, **options)
            except TypeError:
                error = _unknown_argument(function, function.__name__, options, synonyms)
                if error is None:
                    raise
            raise error

        return call

    return decorate


class _Hints(type):
    """A class that answers an attribute or an argument which it does not have as its values do."""

    _synonyms: ClassVar[Mapping[str, str]]

    if not TYPE_CHECKING:

        def __getattr__(cls, name: str) -> Any:
            raise missing_attribute(cls, name, cls._synonyms)

        def __call__(cls, *values: Any, **options: Any) -> Any:
            try:
                return super().__call__(*values, **options)
            except TypeError:
                known = {word: use for word, use in cls._synonyms.items() if use.isidentifier()}
                error = _unknown_argument(cls.__init__, cls.__name__, options, known)
                if error is None:
                    raise
            raise error


class InstanceHintsMixin:
    """A value that answers an attribute which it does not have with the name to use.

    Attributes:
        _synonyms: other names of the field, each with what to write here.
        _main: names that are shown where no synonym is near.
    """

    __slots__ = ()
    _synonyms: ClassVar[Mapping[str, str]] = {}
    _main: ClassVar[tuple[str, ...]] = ()

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if hasattr(type(self), name):  # an error inside a property is not a missing name
                return object.__getattribute__(self, name)
            raise missing_attribute(self, name, self._synonyms)


class HintsMixin(InstanceHintsMixin, metaclass=_Hints):
    """A value whose class answers so, too; it takes longer to make (0.6 microseconds)."""

    __slots__ = ()


Hinting = TypeVar("Hinting", bound=InstanceHintsMixin)


def hints_on_assignment(cls: type[Hinting]) -> type[Hinting]:
    """Let values of a frozen dataclass answer an assignment with what makes a changed copy."""

    def refuse(self: Hinting, name: str, value: object) -> None:
        known, this = cls._synonyms.get(name, name), cls.__name__.lower()
        use = f"; use dataclasses.replace({this}, {known}=...)" * (known in cls.__annotations__)
        if f"with_{known}" in dir(cls):
            use = f"; use {this}.with_{known}(...)"
        raise FrozenInstanceError(f"{cls.__name__} values are immutable, so {name} is not set{use}")

    cls.__setattr__ = refuse  # type: ignore[method-assign, assignment]
    return cls
