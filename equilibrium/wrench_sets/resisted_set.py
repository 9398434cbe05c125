"""The set of wrenches that a grasp or an assembly resists: one object with a method for each query.

The other modules of this package compute; here they share one solver, and the polyhedra.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias

from arrangement.console.number_form import JsonMixin
from arrangement.numbers.exact import vector_text
from arrangement.synonyms import by_word
from equilibrium.decide.assemblies.ends import Giving, ends_of
from equilibrium.decide.solver import Solver
from equilibrium.decide.verdict import Verdict
from equilibrium.model.assembly import Assembly
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.grasp import Grasp
from equilibrium.model.synonyms import NAMES

from .any_direction import (
    BestDirection,
    SmallestUnresisted,
    best_direction,
    smallest_unresisted_wrench,
)
from .line import (
    Magnitudes,
    Margin,
    Preloads,
    RoundedEnds,
    chosen_preloads,
    ends_within_error,
    margin,
    resisted_magnitudes,
)
from .loads import CheckedLoads, check_loads
from .polyhedra import Piece, resisted_pieces
from .search_map import SearchMap, search_map
from .slice import FORCES, Region, resisted_region

if TYPE_CHECKING:
    from arrangement.drawing.path_artist import Drawing
    from equilibrium.wrench_sets.along_in_space import SpatialMagnitudes


#: A wrench; of an assembly one for each body.
Load: TypeAlias = Iterable[Any] | Mapping[str, Iterable[Any]]


class ResistedSet(JsonMixin):
    """The set of wrenches that a grasp resists.

    In the plane it is a finite union of convex polyhedra of wrenches ``(f_x, f_y, tau)``, and every
    answer is exact. It need be neither convex nor bounded, and along a direction it need not be one
    interval. In space, with wrenches ``(f_x, f_y, f_z, tau_x, tau_y, tau_z)``, `contains`, `solve`,
    `solve_many` and `along` answer; the other methods raise GraspError.

    Nothing is computed before a method is called, and what one call computes serves the next.

    Of an assembly of bodies, `contains`, `solve`, `along` and `margin` answer, exactly; a load is
    a wrench for each body then, by name.

    Args:
        grasp: contacts, or an assembly.
        max_displacement: only equilibria within it count; see `equilibrium.solve`.
        pyramid: in space, edges of the friction pyramids in place of round cones; see
            `equilibrium.solve`.

    >>> from equilibrium import ResistedSet, read_grasp
    >>> resisted = ResistedSet(read_grasp("paper-three-contacts-preload-1"))
    >>> [0, 1, 0] in resisted, [0, 2, 0] in resisted
    (True, False)
    >>> resisted.along([0, 1, 0]).intervals
    ((Fraction(0, 1), Fraction(1, 1)),)
    >>> resisted.margin([0, 2, 0]).preloads.least
    Fraction(2, 1)
    >>> resisted.smallest_outside().size_squared
    Fraction(4, 9)
    """

    repr_fields = ("grasp", "max_displacement", "pyramid")
    json_fields = ("polyhedra",)
    _synonyms: ClassVar[Mapping[str, str]] = {
        **{word: name.removeprefix("ResistedSet(G).") for word, name in NAMES.items()},
        **by_word("""
            limit largest max max_load maximum -> along(direction)
            epsilon -> smallest_outside().size, or GraspWrenchSpace(grasp).epsilon
            friction -> margin(wrench).friction()
            plot show -> draw()
            region -> slice(u, v)
            preload sufficient_preloads -> margin(wrench).preloads, or preloads(wrenches, contacts)
        """),
    }
    _main: ClassVar[Mapping[str, str]] = {
        "one wrench": "contains solve margin",
        "many": "along slice polyhedra smallest_outside check preloads",
        "show": "draw to_dict",
    }

    def __init__(
        self, grasp: Grasp | Assembly, *, max_displacement: Any = None, pyramid: int | None = None
    ) -> None:
        if isinstance(grasp, Assembly) and pyramid is not None:
            raise GraspError("an assembly takes no pyramid; leave it out")
        self._solver = Solver(grasp, max_displacement, pyramid)

    def _of_grasp(self) -> Solver:
        """Return the solver of a grasp.

        Raises:
            GraspError: this is about an assembly.
        """
        if isinstance(self._solver.grasp, Assembly):
            raise GraspError(
                f"{self._solver.grasp!r} has no list of resisted wrenches; use `along`, `margin`, "
                "`solve` or `contains`"
            )
        return self._solver

    @property
    def grasp(self) -> Any:
        """The contacts: a `Grasp` or an `Assembly`."""
        return self._solver.grasp

    @property
    def max_displacement(self) -> Fraction | None:
        """How far contact points may move for an equilibrium to count; None: any distance."""
        return self._solver.max_displacement

    @property
    def pyramid(self) -> int | None:
        """Edges of the friction pyramids; None: round cones, or in the plane."""
        return self._solver.pyramid

    @cached_property
    def polyhedra(self) -> tuple[Piece, ...]:
        """In the plane the whole set: polyhedra, each with its contact states.

        They may overlap and touch; none lies in another single one.

        Raises:
            OutOfReachError: too many choices of contact states.
        """
        return resisted_pieces(self._of_grasp())

    def contains(self, wrench: Load) -> bool:
        """Return whether a wrench is resisted; ``wrench in resisted`` is the same.

        Of converted data it is the answer for the data as rounded; `solve(wrench).answer` says
        whether that is proved for all data within the rounding error.

        Raises:
            UndecidedError: in space there is no proof of either answer; or the data were converted
                and the answer depends on the rounding.
        """
        verdict = self.solve(wrench)
        if verdict.decided and verdict.depends:
            raise UndecidedError(
                f"whether the load {vector_text(verdict.load)} is resisted {verdict.doubt}; "
                "`solve(wrench).stable` is the answer for the data as rounded"
            )
        return bool(verdict)

    def __contains__(self, wrench: Load) -> bool:
        """Return whether a wrench is resisted; see `contains`."""
        return self.contains(wrench)

    def solve(self, wrench: Load, **options: Any) -> Verdict:
        """Decide one wrench, with a certificate: see `Verdict`.

        Args:
            options: time_limit, nodes and, of a grasp, shorten; see `equilibrium.solve`.
        """
        return self._solver.solve(wrench, **options)

    def solve_many(
        self, wrenches: Iterable[Iterable[Any]], *, jobs: int = 1, dask: str | None = None
    ) -> Iterator[Verdict]:
        """Yield the verdict of each wrench, in order; see `equilibrium.solve_many`."""
        return self._of_grasp().solve_many(wrenches, jobs=jobs, dask=dask)

    def check(self, wrenches: Any) -> CheckedLoads:
        """Decide an array of wrenches by `polyhedra`: in floats where these decide, else exactly.

        Args:
            wrenches: (n, 3) floats ``(f_x, f_y, tau)``, taken for the binary fractions that they
                are. Other numbers are taken if floats hold them.

        Raises:
            GraspError: wrenches that are complex, masked, texts or not finite, or that floats
                round; contacts in space.
            OutOfReachError: too many choices of contact states.

        >>> import numpy as np
        >>> from equilibrium import inputs
        >>> normals = np.array([[1, 0], [0, 1], [-1, 0.0]])
        >>> grasp = inputs.from_float_data(-normals, normals, 0.5, preload=1).grasp
        >>> ResistedSet(grasp).check([[0, 0.5, 0], [0, 1, 0], [0, 1.5, 0]]).resisted.tolist()
        [True, True, False]
        """
        self._of_grasp().grasp.require_plane()
        return check_loads(self, wrenches)

    def along(self, direction: Load, base: Load | int = 0) -> Magnitudes | SpatialMagnitudes:
        """Return the magnitudes t >= 0 for which ``base + t direction`` is resisted.

        In the plane, and of an assembly, they are exact intervals. In space verdicts at sampled
        magnitudes are returned, and each change between neighbours in a bracket of two proofs.

        Args:
            direction: a wrench other than zero.
            base: a wrench that acts in any case; 0: none.

        Raises:
            GraspError: a zero direction, a wrench of wrong length or on what is no body, or
                friction pyramids.
            OutOfReachError: too many choices of contact states.
            UndecidedError: an assembly takes more nodes or steps than the limits allow.
        """
        start: Any = self._load(base)
        if isinstance(self._solver.grasp, Assembly) or self._solver.grasp.dimension == 2:
            return resisted_magnitudes(self._solver, direction, start)
        from .along_in_space import spatial_magnitudes

        if self.pyramid is not None:
            raise GraspError(
                f"pyramid is {self.pyramid}; magnitudes along a direction are computed for round "
                "cones only. Leave pyramid out, or `solve` one wrench after the other"
            )
        bound = self.max_displacement
        return spatial_magnitudes(self._solver.grasp, direction, start, max_displacement=bound)

    def within_error(self, magnitudes: Magnitudes) -> RoundedEnds | None:
        """Return the ends of magnitudes in the plane for others within the error of the data.

        None if the data are exact; in space `SpatialMagnitudes.within_error` answers.

        Args:
            magnitudes: what `along` returned.
        """
        return ends_within_error(self._solver, magnitudes)

    def what_gives(
        self, magnitudes: Magnitudes | Preloads
    ) -> tuple[tuple[Giving | None, ...], ...]:
        """Return which contacts slip or lift off at both ends of each interval of magnitudes.

        A contact is named if it is at its friction limit, or without force, in all equilibria at
        the end, and not in all just inside. Where a single magnitude is resisted, what holds in all
        equilibria there stands at its upper end. None stands where nothing is established, and
        where an interval starts at 0 or is unbounded.

        Args:
            magnitudes: what `along` returned, in the plane or of an assembly; in space
                `SpatialMagnitudes.what_gives` answers. Or preloads that resist one wrench, of a
                grasp without pads or of an assembly.

        >>> from equilibrium import ResistedSet, read_grasp
        >>> resisted = ResistedSet(read_grasp("paper-four-contacts-preload-1"))
        >>> [(start, end)] = resisted.what_gives(resisted.along([0, 1, 0]))
        >>> end.words
        'slips at contacts 1, 2, 3, 4'
        """
        bound = self.max_displacement
        if isinstance(magnitudes, Magnitudes):
            ends = magnitudes.base, magnitudes.direction, magnitudes.intervals
            return ends_of(self.grasp, *ends, bound)
        if len(magnitudes.wrenches) > 1 or getattr(self.grasp, "has_pads", False):
            return ((None, None),) * len(magnitudes.intervals)
        bare = self.grasp.with_preload(0, magnitudes.contacts)
        still, chosen = self._solver.no_wrench, self.grasp.points_of(magnitudes.contacts)
        question = bare, magnitudes.wrenches[0], still, magnitudes.intervals, bound
        return ends_of(*question, preload_slope=Fraction(1), chosen=chosen)

    def slice(
        self,
        u: Iterable[Any] = FORCES[0],
        v: Iterable[Any] = FORCES[1],
        origin: Iterable[Any] | int = 0,
    ) -> Region:
        """Return the resisted wrenches ``origin + a u + b v`` as exact polygons.

        By default the plane is that of the forces at zero torque about the origin.

        Raises:
            GraspError: u and v are parallel, or a wrench has the wrong length.
        """
        return resisted_region(self._of_grasp(), (u, v), self._load(origin))

    def margin(self, wrench: Load) -> Margin:
        """Return the exact factors by which a wrench may be scaled; of an assembly, all wrenches.

        Its `Margin.preloads` and `Margin.friction` are what would resist the wrench.

        Raises:
            OutOfReachError: too many choices of contact states, for preloads and friction, too.
        """
        return margin(self._solver, wrench)

    def preloads(self, wrenches: Iterable[Load], contacts: Iterable[int] | None = None) -> Preloads:
        """Return the preloads of chosen contacts with which every one of some wrenches is resisted.

        Args:
            wrenches: all are to be resisted, one at a time; of an assembly each is a wrench for
                each body.
            contacts: numbers, from 1, of those that get one preload p; the others keep their own.
                All contacts, if omitted.

        Raises:
            GraspError: no wrench, or no such contact.
            UndecidedError: too many contacts.

        >>> from equilibrium import ResistedSet, read_grasp
        >>> resisted = ResistedSet(read_grasp("paper-three-contacts"))
        >>> resisted.preloads([[0, 1, 0], [0, 3, 0]], contacts=[1, 3]).least
        Fraction(3, 1)
        """
        return chosen_preloads(self._solver, wrenches, contacts)

    def with_contact(self, candidates: Iterable[Contact]) -> tuple[ResistedSet, ...]:
        """Return for each candidate the set that the grasp resists with it as one more contact.

        Args:
            candidates: contacts, or a grasp with them, of which a pad is one.

        >>> from equilibrium import Contact, ResistedSet, read_grasp
        >>> thumb = Contact([0, 1], [0, -1], "1/2")
        >>> [more] = ResistedSet(read_grasp("paper-three-contacts")).with_contact([thumb])
        >>> [0, 1, 0] in more
        True
        """
        bound, pyramid, grasp = self.max_displacement, self.pyramid, self._of_grasp().grasp
        return tuple(
            ResistedSet(
                replace(grasp, contacts=(*grasp, *points)), max_displacement=bound, pyramid=pyramid
            )
            for points in Grasp(candidates).parts
        )

    def smallest_outside(
        self, base: Iterable[Any] | int = 0, torque_length: Any = 1
    ) -> SmallestUnresisted:
        """Return how small a wrench may be, in any direction, without being resisted; exact.

        Without preload and base the size is 0, or all wrenches are resisted.

        Args:
            base: a wrench that acts in any case; the smallest one is added to it. 0: none.
            torque_length: that torques are divided by, above 0, to compare them with forces.

        Raises:
            GraspError: a torque_length that is not above 0, or a base of wrong length.
            OutOfReachError: too many choices of contact states.
        """
        self._of_grasp()
        return smallest_unresisted_wrench(self, self._load(base), torque_length)

    def best_direction(
        self, base: Iterable[Any] | int = 0, point: Iterable[Any] = (0, 0)
    ) -> BestDirection:
        """Return the least force at a point at which resistance ends, over all directions; exact.

        Args:
            base: a wrench that acts in any case; 0: none.
            point: where the force acts.

        Raises:
            GraspError: a base or a point of wrong length, or a grasp in space.
            OutOfReachError: too many choices of contact states.
        """
        return best_direction(self, self._load(base), point)

    def search(
        self, rays: int = 72, tolerance: Any = Fraction(1, 1000), max_magnitude: Any = 1000
    ) -> SearchMap:
        """Return the paper's map of resisted forces by binary search, beside the exact set.

        Args:
            rays: how many evenly spaced directions of force, starting with the x axis.
            tolerance: the searches end when the answer is known to within this.
            max_magnitude: the largest magnitude tried.

        Raises:
            GraspError: an argument that is not above 0, or a tolerance that is too small a share of
                the magnitude.
        """
        return search_map(self._of_grasp(), rays, tolerance, max_magnitude)

    def draw(self, view: str = "wrench-set", **options: Any) -> Drawing:
        """Draw the set, or another view of the grasp; see `Grasp.draw`.

        Raises:
            GraspError: the displacements are bounded; no view draws such a set.
        """
        if self.max_displacement is not None:
            raise GraspError(
                "the set of wrenches with bounded displacements is not drawn; leave "
                "max_displacement out, or use `slice` and `polyhedra`"
            )
        drawing: Drawing = self._of_grasp().grasp.draw(view, **options)
        return drawing

    def _load(self, load: Load | int) -> Load:
        """Return a load that may be omitted: 0 is the zero wrench."""
        return self._solver.no_wrench if isinstance(load, int) and load == 0 else load  # type: ignore[return-value]
