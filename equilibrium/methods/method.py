"""What a compared method is: its names, its verdict on one wrench, its accepted wrenches."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from arrangement.errors import OutOfReachError
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.polyhedron import Polyhedron
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.slice import FORCES, Region, region_of

#: Whether a method accepts (None: it says nothing), and what the answer rests on.
Outcome: TypeAlias = tuple[bool | None, str]
Decide: TypeAlias = Callable[[Grasp, RationalVector], Outcome]
#: The same in space, with edges of friction pyramids; None for round cones.
DecideInSpace: TypeAlias = Callable[[Grasp, RationalVector, int | None], Outcome]
#: The same for an assembly, with a wrench for each body.
DecideAssembly: TypeAlias = Callable[[Assembly, Wrenches], Outcome]
FindRegion: TypeAlias = Callable[[Grasp, Sequence[Iterable[Any]], Iterable[Any]], Region]


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
        decide_in_space: its verdict on a grasp in space; None if it knows the plane only.
        decide_assembly: its verdict on an assembly; None if it knows one body only.
    """

    key: str
    title: str
    label: str
    decide: Decide | None = None
    find_region: FindRegion | None = None
    decide_in_space: DecideInSpace | None = None
    decide_assembly: DecideAssembly | None = None

    def outcome(self, grasp: Grasp | Assembly, wrench: Any, pyramid: int | None = None) -> Outcome:
        """Return the verdict on one wrench, with what it rests on.

        Args:
            pyramid: in space, edges of friction pyramids in place of the round cones.
        """
        try:
            if isinstance(grasp, Assembly):
                assert self.decide_assembly is not None
                return self.decide_assembly(grasp, wrench)
            if grasp.dimension == 2 and self.decide:
                return self.decide(grasp, wrench)
            if grasp.dimension == 3 and self.decide_in_space:
                return self.decide_in_space(grasp, wrench, pyramid)
        except OutOfReachError as error:
            return None, f"not tried: {error}"
        return None, "no verdict on one wrench" + " in space" * (grasp.dimension == 3)

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


def cut(shapes: Callable[[Grasp], Iterable[Polyhedron | None]]) -> FindRegion:
    """Return how to find the region of a method that accepts a union of polyhedra of wrenches."""

    def region(grasp: Grasp, spans: Sequence[Iterable[Any]], origin: Iterable[Any]) -> Region:
        return region_of(lambda _: (((), shape) for shape in shapes(grasp)), spans, origin)

    return region
