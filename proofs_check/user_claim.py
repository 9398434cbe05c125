"""Claims of your own: a decorated function that gets an instance and returns True or a reason.

Write a Python file and run it with ``proofs-check run FILE.py``::

    from proofs_check import claim

    @claim("Every arrangement in general position has twice as many facets as rays.", of="simple")
    def facets_and_rays(planes):
        _, rays, facets, _ = planes.f_vector
        return facets == 2 * rays or f"{facets} facets and {rays} rays"

The function runs on every combinatorial type up to a number of planes, on the named families and
on random instances; a failure is made as small as possible and saved. The file is a program: it
runs with all rights of the user who names it on the command line, as with ``python FILE.py``.
Nothing else that this package reads is ever executed.
"""

from __future__ import annotations

import importlib.util
import re
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.polyhedra.dual import dual_polyhedron

from .errors import OwnClaimError
from .instances.arrangements import census_cases
from .instances.domains import domain, known_families
from .shrink import smallest_case
from .statement import Claim, Domain, Registry, Route, Source, Verdict, exhaustive, sampled

_NAME = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*")


def claim(
    statement: str,
    *,
    of: str = "distinct",
    id: str | None = None,
    planes: Sequence[int] | None = None,
    samples: int = 200,
    census: int = 6,
    families: bool = True,
    when: Callable[[Any], bool] | None = None,
    hypotheses: Iterable[str] = (),
    locator: str = "",
    expected: str = "holds",
) -> Callable[[Callable[[Any], Any]], Claim]:
    """Make a claim of a function that gets an instance and returns True or a reason.

    Args:
        statement: in words.
        of: a domain of `instances.domains` ("distinct", "simple", "central", "affine", ...,
            "grasp"), or "dual" for the dual polyhedra of different planes of rank 3.
        id: name of the claim; if omitted, the name of the function.
        planes: smallest and largest number of planes or contacts of random instances; if omitted,
            from the domain's least (at least 3) to 8 planes, or 1 to 4 contacts.
        samples: number of random instances.
        census: run over every combinatorial type of up to so many planes (at most 8; 0 for none).
        families: run over the named families.
        when: a hypothesis; instances on which it is false are passed over.
        hypotheses: the same in words, for the report.
        locator: where the statement stands in your text.
        expected: "holds" or "refuted"; decides the exit code of the run and nothing else.

    Raises:
        OwnClaimError: an argument out of range.
    """
    as_dual = of == "dual"
    chosen = domain("distinct" if as_dual else of)
    limits = _limits(chosen, planes)
    if not isinstance(statement, str) or not statement.strip():
        raise OwnClaimError('a claim needs a statement in words: @claim("...")')
    if type(samples) is not int or samples < 0:
        raise OwnClaimError(f"samples is {samples!r}; give an integer, at least 0")
    if type(census) is not int or census not in (0, 3, 4, 5, 6, 7, 8):
        raise OwnClaimError(f"census is {census!r}; give 3 to 8 planes, or 0 for no census")
    if expected not in (Verdict.HOLDS.value, Verdict.REFUTED.value):
        raise OwnClaimError(f'expected is {expected!r}; give "holds" or "refuted"')

    def decorate(function: Callable[[Any], Any]) -> Claim:
        name = id or function.__name__.strip("_").lower().replace("_", "-")
        if not _NAME.fullmatch(name):
            raise OwnClaimError(f"{name!r} is not an id; use lower case words with hyphens")

        def given(subject: Any) -> Any:
            wanted = as_dual and isinstance(subject, Arrangement)
            return dual_polyhedron(subject) if wanted else subject

        def applies(subject: Any) -> bool:
            if len(subject) < chosen.least or not chosen.contains(subject):
                return False
            return when is None or bool(when(given(subject)))

        sources: tuple[Source, ...] = ()
        if chosen.unit == "planes":
            named = sampled("named families", lambda _: known_families(chosen))
            sources = census_sources(census) + (named if families else ())
        return Claim(
            id=name,
            locator=locator,
            statement=statement.strip(),
            quantity="whether the function of the file returns True",
            routes=(
                Route(
                    f"the function {function.__name__}",
                    lambda subject: _answer(name, function, given(subject)),
                ),
            ),
            judge=lambda _, answer: answer is True,
            sources=sources,
            expected=Verdict(expected),
            hypotheses=tuple(hypotheses),
            applies=applies,
            domain=chosen,
            sizes=limits,
            samples=samples,
            smaller=smallest_case,
            explain=_reason,
        )

    return decorate


def census_sources(most: int) -> tuple[Source, ...]:
    """Return the source with all types of 3 to so many planes; none for 0."""
    over = f"one arrangement of every combinatorial type of 3 to {most} planes"
    return exhaustive(over, lambda _: census_cases(range(3, most + 1))) if most else ()


def _answer(name: str, function: Callable[[Any], Any], subject: Any) -> bool | str:
    """Return what the function says; a failed ``assert`` in it is a reason too.

    Raises:
        OwnClaimError: the function returned neither True nor a text.
    """
    try:
        answer = function(subject)
    except AssertionError as error:
        return str(error) or "an assertion failed"
    if type(answer).__name__ in ("bool", "bool_"):
        return bool(answer)
    if isinstance(answer, str) and answer:
        return answer
    raise OwnClaimError(f"{name} returned {answer!r}; return True, or a text that says why not")


def _reason(_: Any, answer: bool | str) -> str:
    return answer if isinstance(answer, str) else "" if answer else "the function returned False"


def _limits(chosen: Domain, planes: Sequence[int] | None) -> tuple[int, int]:
    if planes is None:
        return (max(3, chosen.least), 8) if chosen.unit == "planes" else (1, 4)
    if len(planes) != 2 or not all(type(m) is int for m in planes):
        raise OwnClaimError(f"planes is {planes!r}; give a smallest and a largest number")
    low, high = planes
    if not chosen.least <= low <= high:
        raise OwnClaimError(
            f"planes is ({low}, {high}); {chosen.text} need at least {chosen.least}, and the "
            "smaller number stands first"
        )
    return (low, high)


def load(path: str) -> tuple[Claim, ...]:
    """Run a Python file and return the claims in it, in order of definition.

    Raises:
        OwnClaimError: the file cannot be read or run, has no claims, or two with one id.
    """
    return _loaded(str(Path(path).resolve()), file_digest(path))


def file_digest(path: str) -> str:
    """Return the SHA-256 of a file of claims, by which a sweep knows that it has not changed."""
    try:
        return sha256(Path(path).read_bytes()).hexdigest()
    except OSError as error:
        raise OwnClaimError(f"cannot read {path}: {error.strerror}") from None


@lru_cache(maxsize=16)
def _loaded(path: str, digest: str) -> tuple[Claim, ...]:
    name = f"proofs_check_own_{digest[:16]}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise OwnClaimError(f"{path} is not a Python file; claims stand in files that end with .py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    sys.path.insert(0, str(Path(path).parent))
    try:
        spec.loader.exec_module(module)
    except OwnClaimError:
        raise
    except Exception as error:
        raise OwnClaimError(f"{path} does not run: {type(error).__name__}: {error}") from error
    finally:
        sys.path.remove(str(Path(path).parent))
    named = {id(value): value for value in vars(module).values() if isinstance(value, Claim)}
    if not named:
        raise OwnClaimError(f"{path} has no claims; decorate a function with @claim(...)")
    locator = Path(path).name
    located = (replace(found, locator=found.locator or locator) for found in named.values())
    return tuple(Registry(located))
