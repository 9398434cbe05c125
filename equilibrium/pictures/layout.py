"""What a picture of a grasp shows, in paper coordinates: exact until the last division."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.drawing.scene.curves import flattened
from arrangement.drawing.scene.items import Floats
from arrangement.numbers.exact import RationalVector
from equilibrium.decide.verdict import Verdict
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Polygon
from equilibrium.model.solution import Solution
from equilibrium.plane.states.contact_states import states_at
from equilibrium.plane.states.equilibrium import Equilibrium
from equilibrium.plane.states.state_system import States

from .body import body, frame_of, free_lengths, stated_body
from .style import nearest_float, nice_near

#: Lengths on paper, where the contacts fill [-1, 1]: cones, the largest force, its torque arc.
CONE, FORCE, ARC = 0.42, 0.65, 0.2
#: The largest displacement that is drawn.
MOVED = 0.22
#: Points on the rim of a cone.
_RIM = 17
#: The least length of a force that is not zero.
_LEAST = 1e-9


class Layout:
    """What a picture of a grasp shows, in paper coordinates (see `draw_grasp` for the arguments).

    Attributes:
        found: the equilibrium that is drawn, if there is one; or `of_method`, the motion and the
            forces of another method, which have no contact states.
        by_model: whether it is an equilibrium of the full model.
        moved: whether the wrench is drawn about the middle of the contacts, as the origin is far.
        cones: the rim of each friction cone (see `_cone_rim`).
        states: at the motion that is drawn, often on the boundary of the set of solutions, where
            a contact that may slip does not.
        step: the exact factor that the motion is drawn with, or None when nothing moves.
        reference: the largest force component; arrows of forces are `FORCE` for `longest` of it.
        arms: for each contact the contact force on paper, or None; `load` that of the wrench.
    """

    def __init__(
        self,
        grasp: Grasp,
        verdict: Verdict | None = None,
        outline: Iterable[Iterable[Any]] | None = None,
        equilibrium: int = 1,
        of_method: Solution | None = None,
    ) -> None:
        shape = grasp.outline if outline is None else Polygon(outline)
        self.grasp, self.verdict, self.given = grasp, verdict, shape is not None
        self.frame = frame_of(grasp, shape)
        self.curve = body(grasp, self.frame) if shape is None else stated_body(shape, self.frame)
        self.applied = None if verdict is None else verdict.wrench
        self.moved = any(abs(x) > Fraction(3, 2) * self.frame.half for x in self.frame.centre)
        place = self.frame.centre if self.moved else (Fraction(0), Fraction(0))
        self.origin = self.frame.paper(place)
        if self.applied is not None:
            x, y, torque = self.applied
            self.applied = (x, y, torque - (place[0] * y - place[1] * x))
        self.places = [self.frame.paper(c.point) for c in grasp]
        self.normals = [np.array([float(x) for x in c.normal]) for c in grasp]
        self.cones = [
            _cone_rim(self.curve, place, normal, contact.friction)
            for contact, place, normal in zip(grasp, self.places, self.normals, strict=True)
        ]
        self.by_model = of_method is None
        self.found = _chosen(verdict, equilibrium) if of_method is None else of_method
        self._scale_forces()
        self.states: States = ()
        self.step: Fraction | None = None
        if self.found is not None:
            self.states = states_at(grasp, self.found.motion) if self.by_model else ()
            # A round factor with which no contact moves further than `MOVED` on paper.
            shifts = [abs(x) for c in grasp for x in shift_at(self.found.motion, c.point)]
            if any(shifts):
                self.step = nice_near(Fraction(MOVED) * self.frame.half / max(shifts))

    def _scale_forces(self) -> None:
        """Turn all forces into arrows of one scale; exact until the largest one is known."""
        forces: list[RationalVector | None] = [None] * len(self.grasp)
        if self.found is not None:
            pairs = zip(self.grasp, self.found.forces, strict=True)
            forces = [contact.total_force(shares) for contact, shares in pairs]
        forces.append(None if self.applied is None else self.applied[:2])
        every = [f for f in forces if f is not None]
        preloads = [c.preload for c in self.grasp]
        self.reference = max((abs(x) for f in [*every, preloads] for x in f), default=Fraction(0))
        unit = self.reference or Fraction(1)
        lengths = [float(np.linalg.norm([float(x / unit) for x in f])) for f in every]
        longest = max([*lengths, *(float(q / unit) for q in preloads)], default=1.0)
        self.longest = longest or 1.0
        factor = FORCE / self.longest
        arms = [None if f is None or not any(f) else _arm(f, unit, factor) for f in forces]
        *self.arms, self.load = arms
        self.preloads = [max(factor * float(q / unit), _LEAST) if q else 0.0 for q in preloads]


def _chosen(verdict: Verdict | None, number: int) -> Equilibrium | Solution | None:
    """Return an equilibrium by its number; of many contacts the one that was found is the first."""
    if verdict is None or (number == 1 and not (verdict.stable and verdict.lists_all())):
        return None if verdict is None else verdict.solution
    if not 1 <= number <= len(verdict.equilibria):
        raise GraspError(
            f"the equilibrium is number {number}; their number is {len(verdict.equilibria)}"
        )
    return verdict.equilibria[number - 1]


def _cone_rim(curve: Floats | None, place: Floats, normal: Floats, friction: Fraction) -> Floats:
    """Return points on the rim of a friction cone from edge to edge; their number is odd.

    It stays inside the outline, if there is one, and is shorter on all sides where that helps.
    """
    half = math.atan(nearest_float(friction))
    angles: Floats = math.atan2(normal[1], normal[0]) + np.linspace(-half, half, _RIM)
    ways: Floats = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    if curve is None:
        return place + CONE * ways
    free = free_lengths(flattened(curve), place, angles)
    reach = np.minimum(free, max(min(CONE, 0.92 * float(free.min())), CONE / 2))
    return place + reach[:, None] * ways


def _arm(force: RationalVector, unit: Fraction, factor: float) -> Floats:
    """Return a force on paper; one too small for a float keeps its direction."""
    own = max(map(abs, force))
    direction = np.array([float(x / own) for x in force])
    length = float(np.linalg.norm(direction))
    arm: Floats = direction / length * max(factor * float(own / unit) * length, _LEAST)
    return arm


def shift_at(motion: RationalVector, point: RationalVector) -> RationalVector:
    """Return the displacement of a point, to first order."""
    return (motion[0] - motion[2] * point[1], motion[1] + motion[2] * point[0])


def displaced(layout: Layout, places: Floats) -> Floats:
    """Return paper points after the motion, to first order."""
    assert layout.found is not None
    assert layout.step is not None
    x, y = shift_at(layout.found.motion, layout.frame.centre)
    shift = np.array([float(layout.step * v / layout.frame.half) for v in (x, y)])
    turn = float(layout.step * layout.found.motion[2])
    moved: Floats = places + shift + turn * np.stack([-places[:, 1], places[:, 0]], axis=1)
    return moved
