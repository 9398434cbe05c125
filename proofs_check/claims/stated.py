"""A claim of the paper: its words from `claims.toml`, with the functions that check it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING, Any

from proofs_check.instances.domains import domain
from proofs_check.statements.statement import (
    Case,
    Claim,
    ClaimVerdict,
    Hypothesis,
    Kind,
    ManyTypes,
    Route,
    Source,
    View,
)

from . import entries, plain

if TYPE_CHECKING:
    from arrangement.library.census.chirotopes import Signs
    from arrangement.numbers.float_filter import Booleans


def stated(
    id: str,
    *,
    cases: Callable[[Random], Iterable[Case]],
    judge: Callable[[Any, Any], bool],
    covers: Callable[[Any], bool] | None = None,
    many_types: Callable[[Signs, int], Booleans] | None = None,
    search: Callable[[], Iterable[Case]] | None = None,
    explain: Callable[[Any, Any], str] | None = None,
    **routes: Callable[[Any], Any],
) -> Claim:
    """Return the claim of that id, with the functions that check it.

    Args:
        id: under which ``claims.toml`` has its words.
        cases: of the source that is named there.
        judge, search, explain: as in `Claim`.
        covers, many_types: of the hypothesis and the way to decide many types that are named there.
        routes: the implementations, by the words under which they are named there.
    """
    _, words = entries()[id]
    fields = {key: _value(key, value) for key, value in words.items() if key != "topic"}
    names, kind, over = (fields.pop(key) for key in ("routes", "kind", "over"))
    if set(names) != set(routes):
        raise ValueError(f"{id} has routes {', '.join(routes)}; expected {', '.join(names)}")
    if covers is not None:
        fields["hypothesis"] = Hypothesis(fields["hypothesis"], covers)
    if many_types is not None:
        fields["many_types"] = ManyTypes(fields["many_types"], many_types)
    return Claim(
        id=id,
        routes=tuple(Route(plain(text), routes[word]) for word, text in names.items()),
        sources=(Source(kind, over, cases),),
        judge=judge,
        search=search,
        explain=explain,
        **fields,
    )


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
        from equilibrium.grasps.inputs.documents import read_grasp

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
