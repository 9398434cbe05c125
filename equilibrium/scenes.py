"""Scenes for physics engines: a grasp under a growing load, and the exact loads at which it slips.

The law of a grasp (`equilibrium.model.contact`) as bodies: the object carries a flat pad at each
contact; a finger is a small ball that touches the pad, slides along the normal alone, and is pushed
by a spring with the stiffness and the preload of the contact. Nothing has weight.

Stiffnesses multiplied by one number divide all motions by it and leave forces and verdicts as they
are. So a scene is stiffer than its grasp: the object moves by about `MOTION` of its size, and
small motions, on which the law rests, are what an engine sees. Masses and damping follow from
`FREQUENCY`; where the object rests they do not matter.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain, count, pairwise
from typing import Any, TypeAlias
from xml.etree import ElementTree as ET

import numpy as np

from arrangement.console.number_form import ReprMixin
from arrangement.numbers.exact import to_text
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp
from equilibrium.model.outline import Circle, Mesh, Polygon
from equilibrium.wrench_sets.along_in_space import spatial_magnitudes
from equilibrium.wrench_sets.line import resisted_magnitudes

#: How far the object moves under its usual forces, as a share of its size.
MOTION = 1e-3
#: Of the object on its springs, in radians a second.
FREQUENCY = 10.0
#: Verdicts are proved at each end of what is resisted, and this share of it below and above.
BESIDE = Fraction(1, 64)
#: The radius of a finger, half the width and half the thickness of a pad, as shares of the size.
_BALL, _PAD, _THICK = 0.05, 0.1, 0.02
#: Of the bracket of an end in space, as a share of it.
_WIDTH = Fraction(1, 1000)
#: No number of a scene is larger, and none of its lengths smaller than one over it.
_LARGEST = 10**9

_Vector: TypeAlias = np.ndarray[Any, np.dtype[np.float64]]


class EngineScene(ReprMixin):
    """A grasp and directions of loads, as bodies in floats.

    Args:
        grasp: in the plane or in space, with at least one contact.
        directions: of loads, wrenches about the origin, not zero; the axes if omitted.

    Attributes:
        size: the largest distance of a contact from their mean, the centre of mass; 1 if that is 0.
        stiffening: how many times stiffer the scene is than the grasp.
        mass, damping: of the object; of its turns times the square of the size. Damping is force
            per velocity, to the world.

    Raises:
        GraspError: no contact, a zero direction, or numbers that no engine takes.

    >>> scene = EngineScene(read_grasp("paper-three-contacts-preload-1"), [[0, 1, 0]])
    >>> scene.document()["loads"][0]["resisted"]
    [['0', '1']]
    """

    repr_fields = ("grasp", "directions")

    def __init__(self, grasp: Grasp, directions: Iterable[Iterable[Any]] | None = None) -> None:
        axes = np.eye(grasp.wrench_size, dtype=int).tolist()
        loads = axes if directions is None else directions
        self.grasp = grasp
        self.directions = tuple(grasp.read_wrench(x) for x in loads)
        if not all(map(any, self.directions)):
            raise GraspError("a direction is zero; give one that is not")
        if not all(c.stiffness for c in grasp):
            raise GraspError("a contact has stiffness 0; a scene has a spring at each contact")
        if any(c.adhesion for c in grasp):
            raise GraspError("a contact has adhesion; a scene has none, leave it out")
        if not len(grasp):
            raise GraspError("a grasp without contacts holds nothing; give one with contacts")
        numbers = chain.from_iterable(
            (*c.point, c.friction, c.stiffness, 1 / c.stiffness, c.preload) for c in grasp
        )
        sizes = [max(map(abs, direction)) for direction in self.directions]
        if max(*map(abs, numbers), *sizes, *(1 / size for size in sizes)) > _LARGEST:
            raise GraspError(
                "a number of the scene is larger than 10^9, or a stiffness or a load smaller than "
                "10^-9, which engines do not take; choose other units"
            )
        points = np.array([_in_space(c.point) for c in grasp])
        self.centre: _Vector = points.mean(axis=0)
        self.size = float(np.linalg.norm(points - self.centre, axis=1).max()) or 1.0
        half = grasp.dimension
        first = [*map(float, self.directions[0])]
        load = math.hypot(*first[:half]) or math.hypot(*first[half:]) / self.size
        self.force = float(max(c.preload for c in grasp)) or load
        stiffness = [float(c.stiffness) for c in grasp]
        self.stiffening = self.force / (MOTION * self.size * min(stiffness))
        self.mass = self.stiffening * max(stiffness) / FREQUENCY**2
        self.damping = self.mass * FREQUENCY

    @cached_property
    def fingers(self) -> list[dict[str, Any]]:
        """Of each contact: where its ball is, along which normal it slides, spring and friction."""
        most = max(c.stiffness for c in self.grasp)
        return [
            {
                "centre": self._inside(c, -_BALL),
                "radius": self.size * _BALL,
                "axis": list(_in_space(c.normal)),
                "stiffness": self.stiffening * float(c.stiffness),
                "preload": float(c.preload),
                "friction": float(c.friction),
                "mass": self.mass * float(c.stiffness) / float(most),
                "damping": self.damping * float(c.stiffness) / float(most),
            }
            for c in self.grasp
        ]

    @cached_property
    def pads(self) -> list[dict[str, Any]]:
        """Of each contact: a flat box on the object, which the finger touches."""
        halves = [self.size * x for x in (_PAD, _PAD, _THICK)]
        return [
            {"centre": self._inside(c, _THICK), "halves": halves, "axis": list(_in_space(c.normal))}
            for c in self.grasp
        ]

    def _inside(self, contact: Contact, share: float) -> list[float]:
        """Return the place on the normal of a contact so far inside, as a share of the size."""
        return list(_in_space(contact.point) + self.size * share * _in_space(contact.normal))

    def loads(self) -> Iterator[dict[str, Any]]:
        """Yield of each direction what is resisted, and verdicts at and beside each end, in JSON.

        In space an end is known by two neighbouring magnitudes, one resisted and one not; the
        latter stands for the point outside.
        """
        solver = Solver(self.grasp)
        for direction in self.directions:
            known: dict[str, Any] = {"direction": list(map(to_text, direction))}
            if self.grasp.dimension == 2:
                magnitudes = resisted_magnitudes(solver, direction)
                known["resisted"] = magnitudes.to_dict()["intervals"]
                ends = {end for interval in magnitudes.intervals for end in interval if end}
                tried = {end * (1 + side * BESIDE) for end in ends for side in (-1, 0, 1)}
            else:
                borders = spatial_magnitudes(self.grasp, direction, width=_WIDTH).borders
                known["borders"] = [border.to_dict() for border in borders]
                tried = {x for b in borders for x in (b.resisted, b.refused)}
                sides = [(b.resisted, 1 if b.resisted > b.refused else -1) for b in borders]
                tried |= {end * (1 + side * BESIDE) for end, side in sides}
            known["verdicts"] = []
            for t in sorted(tried) or [Fraction(1)]:
                verdict = solver.solve([t * x for x in direction])
                proof = verdict.certificate and verdict.certificate.to_dict()
                entry = {"magnitude": to_text(t), "verdict": verdict.verdict, "certificate": proof}
                known["verdicts"].append(entry)
            yield known

    def document(self) -> dict[str, Any]:
        """Return the scene for any engine: bodies, loads, exact slip loads with their proofs."""
        return {
            "schema_version": 1,
            "law": __doc__.split("\n\n")[1].replace("\n", " "),
            "object": {
                "centre": list(self.centre),
                "mass": self.mass,
                "inertia": self.mass * self.size**2,
                "damping": [self.damping, self.damping * self.size**2],
                "pads": self.pads,
            },
            "fingers": self.fingers,
            "stiffening": self.stiffening,
            "grasp": self.grasp.to_dict(),
            "loads": list(self.loads()),
        }

    def mjcf(self) -> str:
        """Return the scene in MJCF, the format of MuJoCo.

        The controls of the actuators "load 1", ... are the magnitudes of the loads. The object has
        slides and a hinge, in space a ball, so that it can be damped.
        """
        flat, around = self.grasp.dimension == 2, self.size**2
        root = ET.Element("mujoco", model="grasp")
        _add(root, "option", gravity="0 0 0", timestep="0.001", integrator="implicitfast")
        world = _add(root, "worldbody")
        body = _add(world, "body", name="object")
        for name, axis in zip("xyz"[: self.grasp.dimension], np.eye(3), strict=False):
            _add(body, "joint", name=name, type="slide", axis=axis, damping=self.damping)
        turn = {"name": "turn", "type": "hinge" if flat else "ball", "axis": "0 0 1"}
        _add(body, "joint", **turn, damping=self.damping * around)
        moments = [self.mass * around] * 3
        _add(body, "inertial", mass=self.mass, diaginertia=moments, pos=self.centre)
        _add(body, "site", name="load", size=self.size / 50)
        self._add_outline(root, body)
        pairs, actuators = ET.Element("contact"), ET.Element("actuator")
        for i, (pad, finger) in enumerate(zip(self.pads, self.fingers, strict=True), 1):
            name, axis, rubs = f"finger {i}", finger["axis"], finger["friction"]
            box = {"name": f"pad {i}", "type": "box", "rgba": "0.6 0.6 0.6 1"}
            _add(body, "geom", **box, size=pad["halves"], pos=pad["centre"], zaxis=axis)
            own = _add(world, "body", name=name, pos=finger["centre"])
            slide = {key: finger[key] for key in ("axis", "stiffness", "damping")}
            rest = finger["preload"] / finger["stiffness"]
            _add(own, "joint", name=name, type="slide", springref=rest, **slide)
            ball = {"name": name, "type": "sphere", "rgba": "0.2 0.4 0.8 1"}
            _add(own, "geom", **ball, size=finger["radius"], mass=finger["mass"])
            cone = {"condim": "3", "friction": (rubs, rubs, 0, 0, 0)} if rubs else {"condim": "1"}
            _add(pairs, "pair", geom1=name, geom2=f"pad {i}", **cone)
        for i, direction in enumerate(self.directions, 1):
            gear = (*direction[:2], 0, 0, 0, direction[2]) if flat else direction
            _add(actuators, "general", name=f"load {i}", site="load", gear=gear)
        root.extend((pairs, actuators))
        ET.indent(root)
        return ET.tostring(root, encoding="unicode") + "\n"

    def _add_outline(self, root: ET.Element, body: ET.Element) -> None:
        """Add the shape of the object, which is only seen: fingers touch the pads."""
        shape, thin = self.grasp.outline, self.size / 50
        seen = {"contype": "0", "conaffinity": "0", "mass": "0", "rgba": "0.8 0.7 0.5 0.4"}
        if isinstance(shape, Polygon):
            for ends in pairwise(map(_in_space, (*shape.corners, shape.corners[0]))):
                _add(body, "geom", **seen, type="capsule", size=thin, fromto=ends)
        elif isinstance(shape, Circle):
            size, place = (shape.radius, thin), _in_space(shape.centre)
            _add(body, "geom", **seen, type="cylinder", size=size, pos=place)
        elif isinstance(shape, Mesh):
            fans = [(face[0], a, b) for face in shape.faces for a, b in pairwise(face[1:])]
            # Of a surface without volume MuJoCo needs a flag that it is one.
            surface = {"name": "object", "inertia": "shell", "vertex": shape.vertices}
            _add(_add(root, "asset"), "mesh", **surface, face=fans)
            _add(body, "geom", **seen, type="mesh", mesh="object")


def _add(parent: ET.Element, tag: str, **values: Any) -> ET.Element:
    """Add an element; numbers and arrays of them are written as text."""
    texts = {
        key: x if isinstance(x, str) else " ".join(f"{float(n):.12g}" for n in np.ravel(x))
        for key, x in values.items()
    }
    return ET.SubElement(parent, tag, texts)


def _in_space(values: Iterable[Any]) -> _Vector:
    """Return a point or a normal in space; the plane is z = 0."""
    return np.array([*map(float, values), 0.0][:3])


def document_text(document: dict[str, Any]) -> str:
    """Return a scene as a file: compact, since its proofs are for programs."""
    return json.dumps(document, separators=(",", ":")) + "\n"


#: Built-in grasps of `benchmark` with preload, in the plane and in space.
_PLANAR = """
paper-three-contacts-preload-1 paper-four-contacts-preload-1 offset-three-contacts
all-contacts-stick coincident-contacts several-equilibria interrupted-push interrupted-resistance
"""
_SPATIAL = """
paper-three-contacts-in-space paper-four-contacts-in-space three-fingers-on-a-ball
two-opposed-fingers peg-in-a-hole box-held-by-four
"""


def benchmark() -> Iterator[tuple[str, EngineScene]]:
    """Yield sixty scenes and their names: forty in the plane, twenty in space, three loads each.

    The loads are a force along the last axis, a torque about it, and a random wrench. In the plane
    built-in grasps are followed by random ones with preload, of three to eight contacts, which
    resist a hundredth of each load; in space built-in grasps have three friction coefficients, and
    two random grasps of three contacts are planar.
    """
    flat, solid = ([(n, read_grasp(n)) for n in names.split()] for names in (_PLANAR, _SPATIAL))
    for seed in count():
        if len(flat) == 40:
            break
        grasp = random_grasp(3 + seed % 6, seed, preload=True)
        little = ([Fraction(x) / 100 for x in load] for load in _loads(2, len(flat)))
        if all(map(Solver(grasp).solve, little)):
            flat.append((f"random-{len(grasp)}-{seed}", grasp))
    three = [(n, g.in_space()) for n, g in flat if n.startswith("random-3-")][:2]
    rubbed = [(f"{n}-{mu}", g.with_friction(mu)) for n, g in solid for mu in ("0.25", "0.75")]
    for kind, named in (("plane", flat), ("space", [*solid, *rubbed, *three])):
        for k, (name, grasp) in enumerate(named):
            yield f"{kind}-{name}", EngineScene(grasp, _loads(grasp.dimension, k))


def _loads(dimension: int, seed: int) -> list[Sequence[Any]]:
    length = 3 * dimension - 3
    axes = np.eye(length, dtype=int)[[dimension - 1, length - 1]].tolist()
    return [*axes, random_wrench(seed, dimension=dimension)]
