"""Claims of your own: a decorated function that gets an instance and returns True or a reason.

Write a Python file and run it with ``proofs-check run FILE.py``::

    from proofs_check.user_claim import claim

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
from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from arrangement.polyhedra.dual import dual_polyhedron

from .claim import Verdict
from .errors import OwnClaimError
from .instances.domains import Domain, domain

#: Where instances come from, and what a function gets.
SOURCES = ("census", "families", "sampled")
_NAME = re.compile(r"[a-z0-9]+(?:-[a-z0-9]+)*")


@dataclass(frozen=True)
class OwnClaim:
    """A statement and the function that checks it on one instance.

    Attributes:
        id: unique in its file, lower case words with hyphens.
        statement: in words.
        test: gets an instance, returns True or a reason.
        domain: the instances that the statement is about.
        as_dual: the function gets the dual polyhedron of the planes.
        planes: smallest and largest number of planes (or contacts) of random instances.
        samples: number of random instances.
        census: largest number of planes for the run over all types; 0 for none.
        use_families: whether named families are tried.
        when: the hypothesis; instances on which it is false are passed over.
        hypotheses: in words.
        locator: where the statement stands.
        expected: decides the exit code and nothing else.
    """

    id: str
    statement: str
    test: Callable[[Any], Any]
    domain: Domain
    as_dual: bool
    planes: tuple[int, int]
    samples: int
    census: int
    use_families: bool
    when: Callable[[Any], bool] | None
    hypotheses: tuple[str, ...]
    locator: str
    expected: Verdict

    def __call__(self, subject: Any) -> Any:
        """Call the function itself, as if it were not decorated."""
        return self.test(subject)

    def covers(self, subject: Any) -> bool:
        """Whether the statement speaks of this instance."""
        if len(subject) < self.domain.least or not self.domain.contains(subject):
            return False
        return self.when is None or bool(self.when(self._given(subject)))

    def reason(self, subject: Any) -> str:
        """Return "" when the statement is true of an instance, else why it is not.

        A failed ``assert`` in the function is a reason too.

        Raises:
            OwnClaimError: the function returned neither True nor a text.
        """
        try:
            answer = self.test(self._given(subject))
        except AssertionError as error:
            return str(error) or "an assertion failed"
        if type(answer).__name__ in ("bool", "bool_"):
            return "" if answer else "the function returned False"
        if isinstance(answer, str) and answer:
            return answer
        raise OwnClaimError(
            f"{self.id} returned {answer!r}; return True, or a text that says why not"
        )

    def _given(self, subject: Any) -> Any:
        return dual_polyhedron(subject) if self.as_dual else subject


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
) -> Callable[[Callable[[Any], Any]], OwnClaim]:
    """Make a claim of a function that gets an instance and returns True or a reason.

    Args:
        statement: in words.
        of: a domain of `instances.domains` ("distinct", "simple", "central", "affine", ...,
            "grasp"), or "dual" for the dual polyhedra of different planes of rank 3.
        id: name of the claim; left out, the name of the function.
        planes: smallest and largest number of planes or contacts of random instances; left out,
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

    def decorate(function: Callable[[Any], Any]) -> OwnClaim:
        name = id or function.__name__.strip("_").lower().replace("_", "-")
        if not _NAME.fullmatch(name):
            raise OwnClaimError(f"{name!r} is no id; use lower case words with hyphens")
        return OwnClaim(
            name,
            statement.strip(),
            function,
            chosen,
            as_dual,
            limits,
            samples,
            census if chosen.unit == "planes" else 0,
            families and chosen.unit == "planes",
            when,
            tuple(hypotheses),
            locator,
            Verdict(expected),
        )

    return decorate


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


def load(path: str) -> tuple[OwnClaim, ...]:
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
def _loaded(path: str, digest: str) -> tuple[OwnClaim, ...]:
    name = f"proofs_check_own_{digest[:16]}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise OwnClaimError(f"{path} is no Python file; claims stand in files that end with .py")
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
    found = [value for value in vars(module).values() if isinstance(value, OwnClaim)]
    claims = tuple({id(value): value for value in found}.values())
    return _checked(claims, path)


def _checked(claims: tuple[OwnClaim, ...], path: str) -> tuple[OwnClaim, ...]:
    if not claims:
        raise OwnClaimError(f"{path} has no claims; decorate a function with @claim(...)")
    ids = [entry.id for entry in claims]
    for name in ids:
        if ids.count(name) > 1:
            raise OwnClaimError(f"two claims of {path} have the id {name!r}; an id names one claim")
    return claims
