"""What a compared method is: its names, its verdict on one wrench, its accepted wrenches."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from arrangement.errors import OutOfReachError
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.model.assembly import Assembly
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.slice import FORCES, Region, region_of

#: Whether a method accepts (None: it says nothing), and what the answer rests on.
Outcome: TypeAlias = tuple[bool | None, str]
#: Decides a grasp and a wrench, in space with the edges of friction pyramids (None for round cones)
#: besides; or an assembly and a wrench for each body.
Decide: TypeAlias = Callable[..., Outcome]
FindRegion: TypeAlias = Callable[[Grasp, Sequence[Iterable[Any]], Iterable[Any]], Region]
#: What a method may decide.
PLANE, SPACE, BODIES = "a grasp in the plane", "a grasp in space", "an assembly"


class Accepting:
    """A result that is true when the method accepts, and false when it refuses or says nothing."""

    accepts: bool | None

    def __bool__(self) -> bool:
        return bool(self.accepts)


@dataclass(frozen=True)
class Method:
    """One method.

    Attributes:
        key: its name in commands and JSON.
        title, label: what it is; the same in a few words, for pictures.
        decide: its verdict on one wrench; None if it has only a region.
        find_region: the accepted wrenches of a plane; None if it has only verdicts.
        kinds: what it decides, of `PLANE`, `SPACE` and `BODIES`.
    """

    key: str
    title: str
    label: str
    decide: Decide | None = None
    find_region: FindRegion | None = None
    kinds: Collection[str] = (PLANE,)

    def outcome(self, grasp: Grasp | Assembly, wrench: Any, pyramid: int | None = None) -> Outcome:
        """Return the verdict on one wrench, with what it rests on.

        Args:
            pyramid: in space, edges of friction pyramids in place of the round cones.
        """
        kind = kind_of(grasp)
        if self.decide is None or kind not in self.kinds:
            return None, "no verdict on one wrench" + " in space" * (kind == SPACE)
        try:
            return self.decide(grasp, wrench, *([pyramid] if kind == SPACE else []))
        except OutOfReachError as error:
            return None, f"not tried: {error}"

    def region(
        self,
        grasp: Grasp,
        spans: Sequence[Iterable[Any]] = FORCES,
        origin: Iterable[Any] = (0, 0, 0),
    ) -> Region:
        """Return the accepted wrenches ``origin + a spans[0] + b spans[1]``, exactly.

        Raises:
            GraspError: a method without region, or parallel spans.
            OutOfReachError: too many contacts for it.
        """
        if self.find_region is None:
            raise GraspError(f"the method {self.key} has verdicts on single wrenches, no region")
        return self.find_region(grasp, spans, origin)


def kind_of(subject: Grasp | Assembly) -> str:
    """Return what a subject is: `PLANE`, `SPACE` or `BODIES`."""
    if isinstance(subject, Assembly):
        return BODIES
    return PLANE if subject.dimension == 2 else SPACE


def cut(shapes: Callable[[Grasp], Iterable[Polyhedron | None]]) -> FindRegion:
    """Return how to find the region of a method that accepts a union of polyhedra of wrenches."""

    def region(grasp: Grasp, spans: Sequence[Iterable[Any]], origin: Iterable[Any]) -> Region:
        return region_of(lambda _: (((), shape) for shape in shapes(grasp)), spans, origin)

    return region
