"""User-defined claims: a decorated function that gets an instance and returns True or a reason.

Write a Python file and run it with ``proofs-check run FILE.py``::

    from proofs_check import claim

    @claim("Every arrangement in general position has twice as many facets as rays.", of="simple")
    def facets_and_rays(planes):
        _, rays, facets, _ = planes.f_vector
        return facets == 2 * rays or f"{facets} facets and {rays} rays"

The function runs on every isomorphism class up to a number of planes, on the named families and
on random instances, or on a list of instances; a failure is made as small as possible and saved.
With ``routes`` a value is computed by several functions that must agree, and the function judges
it. The file is a program: it runs with all rights of the user who names it on the command line, as
with ``python FILE.py``. Nothing else that this package reads is ever executed.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from numbers import Integral
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.counts.whitney import why_none_is_bounded
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.hints import hints_on_arguments
from arrangement.library.census import MOST_LINES
from proofs_check.errors import OwnClaimError
from proofs_check.instances.arrangements import census_cases, line_cases
from proofs_check.instances.domains import domain, is_domain, known_families
from proofs_check.instances.families import Family, Member, is_family, read_family
from proofs_check.instances.pseudolines import type_sources as pseudoline_sources
from proofs_check.reports.formula import check_formula
from proofs_check.statements.statement import (
    Case,
    Claim,
    ClaimVerdict,
    Domain,
    Kind,
    Route,
    Source,
    range_text,
)

from .claim_file import id_of, line_of
from .false_comparison import FalseComparison
from .shrink import smallest_case

#: What a claim is about where nothing else is said.
DEFAULT_DOMAIN = "distinct"


@hints_on_arguments({})
def claim(
    statement: str = "",
    *,
    of: str | Family | Iterable[Any] = DEFAULT_DOMAIN,
    routes: Iterable[Callable[[Any], Any]] = (),
    id: str | None = None,
    planes: Sequence[int] | None = None,
    samples: int = 200,
    classes: int = 6,
    families: bool = True,
    when: Callable[[Any], bool] | None = None,
    hypotheses: Iterable[str] = (),
    locator: str = "",
    formula: str = "",
    expected: str | None = None,
) -> Callable[[Callable[..., Any]], Claim]:
    """Make a claim of a function that gets an instance and returns True or a reason.

    Args:
        statement: in words; a claim without one is refused.
        of: a domain of `instances.domains` ("distinct", "simple", "central", "affine(d=2)", ...,
            "grasp"), or "dual" for the dual polyhedra of different planes of rank 3; or a `family`
            or its text, such as "catalan(n=2..8)"; or a list of instances of any kind, or a mapping
            from labels to instances. The members of a family, or the instances, are then all.
        routes: functions that get an instance and return one value by different ways; they must
            agree, and the decorated function gets the instance and the value. Of a family each of
            the functions may take its parameters too, by their names.
        id: name of the claim; if omitted, the name of the function.
        planes: smallest and largest number of planes or contacts of random instances; if omitted,
            from the domain's least (at least 3) to 12 planes, or 1 to 4 contacts.
        samples: number of random instances.
        classes: run over every isomorphism class of 3 to this many planes (at most 8; of
            pseudolines 9; 0 for none).
        families: run over the named families.
        when: a hypothesis; instances on which it is false are skipped.
        hypotheses: the same in words, for the report.
        locator: where the statement stands in your text.
        formula: the statement in the part of TeX that `reports.formula` reads.
        expected: "holds" or "refuted", which decides the exit code of the run and nothing else; if
            omitted, a claim that is refuted gives exit code 1.

    Raises:
        OwnClaimError: an argument out of range.
    """
    if isinstance(of, str) and is_family(of) and not is_domain(of):
        of = read_family(of)
    _check(statement, samples, expected)
    if formula:
        check_formula(formula)
    as_dual = of == "dual"
    listed = None if isinstance(of, str) else _source_of(of)
    chosen = domain("distinct" if as_dual else of) if isinstance(of, str) else None
    types = () if chosen is None or classes == 0 else type_sources(chosen, 3, classes)
    limits = _limits(chosen, planes) if chosen else (0, 0)

    def given(subject: Any) -> Any:
        wanted = as_dual and isinstance(subject, Arrangement)
        return dual_polyhedron(subject) if wanted else subject

    def decorate(function: Callable[..., Any]) -> Claim:
        name = id_of(function, id)
        sources: tuple[Source, ...] = ()
        if listed is not None:
            sources = (listed,)
        elif chosen:
            named = (Source(Kind.SAMPLED, "named families", lambda _: known_families(chosen)),)
            sources = types + (named if families and chosen.has_named_instances else ())
        return Claim(
            id=name,
            locator=locator,
            statement=statement.strip(),
            sources=sources,
            expected=ClaimVerdict(expected or "holds"),
            expectation_stated=expected is not None,
            hypotheses=tuple(hypotheses),
            applies=partial(_applies, name, given, when),
            within=partial(_within, chosen) if chosen else None,
            domain=chosen,
            sizes=limits,
            samples=samples if chosen else 0,
            smaller=smallest_case if chosen else None,
            formula=formula,
            **_checks(name, function, tuple(routes), given),
        )

    return decorate


def _check(statement: str, samples: int, expected: str | None) -> None:
    if not isinstance(statement, str) or not statement.strip():
        raise OwnClaimError(
            'a claim needs a statement in words, as its first argument: @claim("...")'
        )
    if type(samples) is not int or samples < 0:
        raise OwnClaimError(f"samples is {samples!r}; give an integer, at least 0")
    if expected not in (None, ClaimVerdict.HOLDS.value, ClaimVerdict.REFUTED.value):
        raise OwnClaimError(f'expected is {expected!r}; give "holds" or "refuted"')


Given = Callable[[Any], Any]


def _within(chosen: Domain, subject: Any) -> bool:
    return len(subject) >= chosen.least and chosen.contains(subject)


def _applies(name: str, given: Given, when: Given | None, subject: Any) -> bool:
    """Return whether an instance satisfies the hypothesis."""
    try:
        return when is None or bool(_with_parameters(when, given(subject)))
    except Exception as error:
        text = f"{type(error).__name__}: {error}"
        raise OwnClaimError(f"the hypothesis `when` of {name} raised {text}") from error


def _checks(
    name: str, function: Callable[..., Any], ways: tuple[Given, ...], given: Given
) -> dict[str, Any]:
    """Return what a claim computes, by which routes, and what judges it."""
    if not ways:
        alone = Route(
            f"the function {function.__name__}",
            lambda subject: _answer(name, function, given(subject)),
        )
        return {
            "quantity": "whether the function of the file returns True",
            "routes": (alone,),
            "judge": lambda _, answer: answer is True,
            "explain": lambda _, answer: _reason(answer),
        }

    def judge(subject: Any, value: Any) -> bool | str:
        try:
            return _answer(name, function, given(subject), value)
        except OwnClaimError:
            raise
        except Exception as error:
            text = f"{type(error).__name__}: {error} ({'; '.join(error.__notes__)})"
            raise OwnClaimError(f"{name} raised {text} for the value {value!r}") from error

    def route(way: Given) -> Route:
        return Route(_route_name(way), lambda subject: _value(way, given(subject)))

    return {
        "quantity": "the value",
        "routes": tuple(map(route, ways)),
        "judge": lambda subject, value: judge(subject, value) is True,
        "explain": lambda subject, value: _reason(judge(subject, value)),
    }


def _source_of(instances: Family | Iterable[Any]) -> Source:
    """Return the members of a family, or listed instances, as the only source of a claim."""
    if isinstance(instances, Family):
        over = f"{instances}, {counted(len(instances), 'member')}"
        return Source(Kind.EXHAUSTIVE, over, lambda _: instances.cases())
    listed = _cases(instances)
    return Source(
        Kind.EXHAUSTIVE, f"the {counted(len(listed), 'given instance')}", lambda _: listed
    )


def _cases(instances: Iterable[Any]) -> list[Case]:
    """Return listed instances as cases, with labels and, where there is one, their file form."""
    pairs = (
        instances.items()
        if isinstance(instances, Mapping)
        else ((f"instance {k}", subject) for k, subject in enumerate(instances, 1))
    )
    cases = [
        Case(str(label), subject, subject.to_dict() if hasattr(subject, "to_dict") else None)
        for label, subject in pairs
    ]
    if not cases:
        raise OwnClaimError("the list of instances is empty; give at least one")
    return cases


def _route_name(way: Callable[[Any], Any]) -> str:
    """Return what a route is called: the first line of its docstring, or its name."""
    return (way.__doc__ or "").strip().partition("\n")[0].rstrip(".") or way.__name__


def _call(function: Callable[..., Any], *arguments: Any) -> Any:
    """Call a function of a file; its errors note the line in the file."""
    try:
        return _with_parameters(function, *arguments)
    except Exception as error:
        error.add_note(line_of(error, getattr(function, "__code__", _call.__code__).co_filename))
        raise


def _with_parameters(function: Callable[..., Any], subject: Any, *more: Any) -> Any:
    """Call a function with an instance; of a family, with the parameters that it names besides."""
    if not isinstance(subject, Member):
        return function(subject, *more)
    named = inspect.signature(function).parameters
    every = any(parameter.kind is parameter.VAR_KEYWORD for parameter in named.values())
    taken = list(named)[: 1 + len(more)]
    chosen = {
        key: value
        for key, value in subject.parameters.items()
        if key not in taken and (every or key in named)
    }
    return function(subject.planes, *more, **chosen)


def _value(way: Callable[[Any], Any], subject: Any) -> Any:
    """Return the value of a route; integers of any library as those of Python."""
    value = _call(way, subject)
    return int(value) if isinstance(value, Integral) and not isinstance(value, bool) else value


def type_sources(chosen: Domain, low: int, high: int) -> tuple[Source, ...]:
    """Return the sources with every isomorphism class of a given number of planes or pseudolines.

    Raises:
        OwnClaimError: the census has no such numbers.
    """
    smallest, largest = (1 if chosen.unit == "lines" else 3), chosen.most or MOST_LINES
    sizes = (low, high)
    if any(type(m) is not int for m in sizes) or not smallest <= low <= high <= largest:
        unit = "planes" if chosen.unit == "contacts" else chosen.unit
        raise OwnClaimError(
            f"classes is {low}..{high}; expected numbers of {unit} from {smallest} to {largest}"
        )
    if chosen.unit == "contacts":
        return ()
    if chosen.unit == "pseudolines":
        return pseudoline_sources(low, high)
    if chosen.unit == "lines":
        simple = chosen.name.startswith("simple")
        kind = " in general position" if simple else ""
        over = f"every isomorphism class of {range_text(low, high)} lines of the plane{kind}"
        cases = partial(line_cases, range(low, high + 1), simple=simple)
        return (Source(Kind.EXHAUSTIVE, over, lambda _: cases()),)
    over = f"one arrangement of every isomorphism class of {range_text(low, high)} planes"
    return (Source(Kind.EXHAUSTIVE, over, lambda _: census_cases(range(low, high + 1))),)


def _answer(name: str, function: Callable[..., Any], *arguments: Any) -> bool | str:
    """Return what the function says; a failed ``assert`` in it is a reason too.

    Raises:
        OwnClaimError: the function returned neither True nor a text.
    """
    try:
        answer = _call(function, *arguments)
    except AssertionError as error:
        return str(error) or f"an assertion failed ({'; '.join(error.__notes__)})"
    if type(answer).__name__ in ("bool", "bool_"):
        return bool(answer)
    if isinstance(answer, FalseComparison):
        return answer.text + _hint(answer.text, arguments[0])
    if isinstance(answer, str) and answer:
        return answer
    raise OwnClaimError(f"{name} returned {answer!r}; return True, or a text with the reason")


_BOUNDED = re.compile(r"(?<!relatively_)bounded_(?:regions|region_count|p_vector)\b")


def _hint(text: str, subject: Any) -> str:
    """Return what a comparison may have meant that counts bounded regions where none can be."""
    planes = subject.planes if isinstance(subject, Member) else subject
    if not isinstance(planes, Arrangement) or "relative=" in text or not _BOUNDED.search(text):
        return ""
    reason = why_none_is_bounded(planes)
    return reason and (
        f" ({reason}, and relatively_bounded_regions counts those bounded in that span, in Python "
        "bounded_regions(relative=True))"
    )


def _reason(answer: bool | str) -> str:
    return answer if isinstance(answer, str) else "" if answer else "the function returned False"


def _limits(chosen: Domain, planes: Sequence[int] | None) -> tuple[int, int]:
    if planes is None:
        return (1, 4) if chosen.unit == "contacts" else (max(3, chosen.least), chosen.most or 12)
    if len(planes) != 2 or not all(type(m) is int for m in planes):
        raise OwnClaimError(f"planes is {planes!r}; give a smallest and a largest number")
    low, high = planes
    if mistake := chosen.mistake(low, high):
        raise OwnClaimError(f"planes is ({low}, {high}); {mistake}")
    return (low, high)
