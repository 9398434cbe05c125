"""What claims are made of: the names that the modules beside this one share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from random import Random
from typing import Any

from arrangement import counts as counts
from arrangement.arrangement import Arrangement as Arrangement
from arrangement.enumeration.paper_steps import published_enumeration as published_enumeration
from arrangement.library.census.chirotopes import Signs as Signs
from arrangement.numbers.exact import RationalVector as RationalVector
from arrangement.numbers.float_filter import Booleans as Booleans
from equilibrium.decide.solver import Solver as Solver
from equilibrium.grasps.files import read_grasp as read_grasp
from equilibrium.model.contact import Contact as Contact
from equilibrium.model.grasp import Grasp as Grasp
from proofs_check.instances import printed as printed
from proofs_check.instances.arrangements import (
    TYPES as TYPES,
    arrangement_case as arrangement_case,
    census_cases as census_cases,
    mixed_cases as mixed_cases,
    random_arrangement as random_arrangement,
    simple_arrangement as simple_arrangement,
    smallest_arrangements as smallest_arrangements,
    types_and_samples as types_and_samples,
)
from proofs_check.instances.domains import domain
from proofs_check.instances.grasps import (
    grasp_case as grasp_case,
    grasp_of as grasp_of,
    listed_states as listed_states,
    paper_question as paper_question,
    smallest_questions as smallest_questions,
)
from proofs_check.routes import oracle as oracle
from proofs_check.routes.dual_graph import (
    DualGraph as DualGraph,
    Edge as Edge,
    distances as distances,
    from_covectors as from_covectors,
    from_signs as from_signs,
    is_sphere as is_sphere,
    is_three_connected as is_three_connected,
    minimum_cycle_lengths as minimum_cycle_lengths,
)
from proofs_check.routes.many_types import f_vectors as f_vectors
from proofs_check.routes.oracle import Question as Question, Row as Row, project as project
from proofs_check.statements.statement import (
    Case as Case,
    Claim as Claim,
    ClaimVerdict,
    Hypothesis,
    Kind,
    ManyTypes,
    Route,
    Source,
    View,
)

from . import entries, plain


@cache
def words() -> Mapping[str, Mapping[str, Any]]:
    """Return what is said of each claim, by its id, in the order of the paper."""
    return {
        id: {**{key: _value(key, value) for key, value in said.items()}, "section": heading}
        for heading, id, said in entries()
    }


def _value(key: str, value: Any) -> Any:
    if key in _READ:
        return _READ[key](value)
    if isinstance(value, str):
        return plain(value)
    return tuple(map(plain, value)) if isinstance(value, list) else value


def _view(view: Mapping[str, Any]) -> View:
    """Return a view; the name of a built-in grasp in its instance stands for contacts."""
    instance = dict(view.get("instance", {}))
    if "grasp" in instance:
        instance = {**read_grasp(instance.pop("grasp")).to_dict(), **instance}
    return View(**{**view, "caption": plain(view["caption"]), "instance": instance or None})


_READ: dict[str, Callable[[Any], Any]] = {
    "domain": domain,
    "expected": ClaimVerdict,
    "kind": Kind,
    "views": lambda views: tuple(map(_view, views)),
}


def at_most(numbers: Sequence[int], bounds: Sequence[int]) -> bool:
    """Return whether each number is within its bound."""
    return all(number <= bound for number, bound in zip(numbers, bounds, strict=True))


def stated(
    id: str,
    *routes: Callable[[Any], Any],
    cases: Callable[[Random], Iterable[Case]],
    covers: Callable[[Any], bool] | None = None,
    many_types: Callable[[Signs, int], Booleans] | None = None,
    **checked: Any,
) -> Claim:
    """Return the claim of that id: its words stand in ``claims.toml``, how to check it is given.

    Args:
        routes, cases: of the routes and of the source that are named there.
        covers, many_types: of the hypothesis and the way to decide many types that are named there.
    """
    said = dict(words()[id])
    kind, over = said.pop("kind"), said.pop("over")
    if covers is not None:
        said["hypothesis"] = Hypothesis(said["hypothesis"], covers)
    if many_types is not None:
        said["many_types"] = ManyTypes(said["many_types"], many_types)
    said["routes"] = tuple(Route(*route) for route in zip(said["routes"], routes, strict=True))
    return Claim(id=id, sources=(Source(kind, over, cases),), **said, **checked)
