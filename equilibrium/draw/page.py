"""An interactive page: which forces a grasp resists, and what its contacts do under the pointer.

Motion, forces, wrench and preloads grow together. So the exact set for one preload serves for
every factor above 0: a condition ``a . w + d >= 0`` becomes ``a . w + d p >= 0``. The page decides
with exact numbers; floats place things on the screen.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from arrangement.draw.html_page import BASE_SCRIPT, BASE_STYLE, POLYGON, Template, one_page
from arrangement.draw.items import Floats
from arrangement.draw.labels import flattened
from arrangement.draw.registry import Wrench
from arrangement.errors import InputError
from arrangement.exact import IntegerVector, RationalVector, primitive, reduced, to_text
from arrangement.lab.page import RATIONAL
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.solver.contact_rows import DIRECTION
from equilibrium.solver.elimination import gauss_jordan
from equilibrium.solver.integer_contacts import IntegerContacts
from equilibrium.solver.state_system import States, each_force, state_system
from equilibrium.wrench_sets import Piece, resisted_set

from .body import Frame, body, frame_of, stated_body
from .layout import cone_rim

#: Contacts beyond which the pieces are too many for a page.
MAX_CONTACTS = 8
#: The length of friction cones, where the contacts fill [-1, 1].
_CONE = 0.55
_OWN = "equilibrium.draw"
_MODULES = ("resisted", "sketch", "plane", "graspview", "resist", "resist_controls")
SCRIPTS: tuple[Template, ...] = (
    BASE_SCRIPT,
    POLYGON,
    RATIONAL,
    *((_OWN, f"{name}.js") for name in _MODULES),
)


def resist_page(grasp: Grasp, *, wrench: Wrench | None = None, title: str | None = None) -> str:
    """Return one HTML page, complete in itself: the resisted forces of a grasp.

    The plane of forces shows every piece (one choice of contact states) at a torque and a preload
    that can be changed. For the force under the pointer the page tells whether it is resisted,
    with which states, and with which forces and motion where the states fix them.

    Args:
        grasp: up to `MAX_CONTACTS` contacts.
        wrench: chosen at first; if omitted, none is, and the torque is 0.
        title: a heading; if omitted, the number of contacts.

    Raises:
        InputError: too many contacts, or no wrench.
    """
    if len(grasp) > MAX_CONTACTS:
        raise InputError(f"{len(grasp)} contacts; a page shows at most {MAX_CONTACTS}")
    applied = None if wrench is None else read_wrench(wrench)
    number = f"{len(grasp)} contact{'' if len(grasp) == 1 else 's'}"
    heading = title if title is not None else f"Forces that {number} resist"
    shown = {grasp, *map(grasp.with_preload, (0, 1))}
    found = {loaded: resisted_set(loaded).pieces for loaded in shown}
    sets, picture = _sets(grasp, found), grasp_data(grasp)
    data = {"title": heading, "summary": _summary(grasp), **sets, **picture}
    data |= _window(grasp, applied, found[grasp])
    styles: list[Template] = [BASE_STYLE, (_OWN, "sketch.css"), (_OWN, "resist.css")]
    buttons = ["home", "theme", "print"]
    return one_page(heading, (_OWN, "resist.html"), styles, SCRIPTS, data, buttons)


def _summary(grasp: Grasp) -> str:
    frictions = sorted({contact.friction for contact in grasp})
    stated = f" friction {', '.join(map(to_text, frictions))};" if frictions else ""
    preloads = sorted({contact.preload for contact in grasp})
    loaded = f" preload {', '.join(map(to_text, preloads))}" if preloads else ""
    return f"{len(grasp)} contacts;{stated}{loaded}"


def _sets(grasp: Grasp, found: Mapping[Grasp, Sequence[Piece]]) -> dict[str, Any]:
    """Return the resisted wrenches without preload, with preload 1, and with the grasp's own."""
    preloads = {contact.preload for contact in grasp} or {Fraction(0)}
    chosen = {"none": grasp.with_preload(0), "uniform": grasp.with_preload(1)}
    if len(preloads) > 1:
        chosen["own"] = grasp
    uniform = next(iter(preloads))
    return {
        "sets": [
            {"name": name, "pieces": list(map(_Motions(loaded).piece, found[loaded]))}
            for name, loaded in chosen.items()
        ],
        "kind": "own" if "own" in chosen else "uniform",
        "factor": "1" if "own" in chosen else to_text(uniform),
        "preload_reach": 3.0 if "own" in chosen else _reach([uniform], 1.5, 3.0),
    }


class _Motions:
    """What the states of the contacts of one grasp fix, as linear forms in the wrench and the load.

    A form has the numerators for f_x, f_y, tau and the preload factor, and their denominator.
    """

    def __init__(self, grasp: Grasp) -> None:
        contacts = IntegerContacts(grasp)
        normal, friction = contacts.balance
        pulls = {"stick": 0, **DIRECTION}
        self.grasp, self.unit, self.slips = grasp, contacts.common_unit, contacts.tangent
        self.columns = contacts.tangent * (self.unit // contacts.wrench_unit)[:, None]
        self.parts = {
            state: (normal + pull * friction)[:, :, None] * contacts.spring[:, None]
            for state, pull in pulls.items()
        }

    def piece(self, piece: Piece) -> dict[str, Any]:
        """Return a piece; where the motion is fixed, the page computes all but friction at rest."""
        shape, states = piece.polyhedron, piece.states
        known = self._unknowns(states)
        fixed, forces = None not in known[:3], []
        if not fixed:
            system = state_system(self.grasp, states, (Fraction(0),) * 3)
            forces = [_combined(known, row) for row in each_force(system)]
        return {
            "states": list(states),
            "inequalities": [list(map(to_text, row)) for row in shape.inequalities],
            "equalities": [list(map(to_text, row)) for row in shape.equalities],
            "motion": list(map(_texts, known[:3])),
            "resting": list(map(_texts, known[3:])),
            "forces": None if fixed else list(map(_texts, forces)),
        }

    def _unknowns(self, states: States) -> list[IntegerVector | None]:
        """Return the motion and the friction of sticking contacts; None what is not fixed."""
        sticking = [i for i, state in enumerate(states) if state == "stick"]
        n = 3 + len(sticking)
        total = np.zeros((3, 4), dtype=object)
        for i, state in enumerate(states):
            if state != "detached":
                total = total + self.parts[state][i]
        load = self.unit * np.eye(3, dtype=object)
        # Unknowns, then the columns of the wrench and of the preload: E z + w + f p = 0.
        matrix = [[*total[j, 1:], *self.columns[sticking, j], *load[j], total[j, 0]]
                  for j in range(3)]  # fmt: skip
        matrix += [[*self.slips[i], *[0] * (n - 3 + 4)] for i in sticking]
        rows, pivots, scale = gauss_jordan(matrix)
        forms: list[IntegerVector | None] = [None] * n
        side = -1 if scale > 0 else 1
        for row, pivot in zip(rows, pivots, strict=False):
            if pivot < n and not any(row[j] for j in range(n) if j != pivot):
                forms[pivot] = reduced((*(side * x for x in row[n:]), abs(scale)))
        return forms


def _texts(form: IntegerVector | None) -> list[str] | None:
    return None if form is None else list(map(to_text, form))


def _combined(forms: Sequence[IntegerVector | None], row: RationalVector) -> IntegerVector | None:
    """Return a row in the unknowns as a form in wrench and preload; None if it is not fixed."""
    total = [Fraction(0), Fraction(0), Fraction(0), row[-1]]
    for factor, form in zip(row[:-1], forms, strict=True):
        if factor:
            if form is None:
                return None
            total = [a + factor * b / form[-1] for a, b in zip(total, form, strict=False)]
    return primitive((*total, Fraction(1)))


def grasp_data(grasp: Grasp) -> dict[str, Any]:
    """Return the contacts and the outline in paper coordinates, for ``sketch.js``."""
    frame = frame_of(grasp, grasp.outline)
    curve = body(grasp, frame) if grasp.outline is None else stated_body(grasp.outline, frame)
    return {
        "contacts": [
            {
                "place": floats(frame.paper(contact.point)),
                "normal": [float(x) for x in contact.normal],
                "cone": _cone(curve, contact, frame),
                "preload": float(contact.preload),
                "exact": _exact(contact),
            }
            for contact in grasp
        ],
        "stated": grasp.outline is not None,
        "outline": None if curve is None else [floats(p) for p in flattened(curve, 16)],
        "origin": floats(np.clip(frame.paper((Fraction(0),) * 2), -1.5, 1.5)),
        **_frame(frame),
    }


def _cone(curve: Floats | None, contact: Contact, frame: Frame) -> list[list[float]]:
    """Return points of the rim of a friction cone, the fifth of nine in the middle."""
    place, normal = frame.paper(contact.point), np.array([float(x) for x in contact.normal])
    angles, lengths = cone_rim(curve, place, normal, contact.friction, _CONE)
    rim = place + lengths[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return [floats(point) for point in rim]


def _exact(contact: Contact) -> dict[str, Any]:
    """Return the law of a contact: from it the page computes forces from motions."""
    return {
        "wrench": [to_text(x) for x in contact.normal_wrench],
        "stiffness": to_text(contact.stiffness),
        "friction": to_text(contact.friction),
        "preload": to_text(contact.preload),
    }


def _frame(frame: Frame) -> dict[str, Any]:
    return {"centre": [float(x) for x in frame.centre], "size": float(frame.size)}


def _window(
    grasp: Grasp, applied: RationalVector | None, pieces: Sequence[Piece]
) -> dict[str, Any]:
    """Return how much of the plane is shown at first, and how far the torque can be moved.

    Few corners of pieces may be very far away; the first view need not hold these.
    """
    points = {point for piece in pieces for point in piece.polyhedron.points}
    forces = [_most(max(abs(x), abs(y)) for x, y, _ in points)]
    torques = [_most(abs(point[2]) for point in points)]
    if applied is not None:
        forces += applied[:2]
        torques.append(applied[2])
    names = ["f_x", "f_y"]
    units = grasp.units
    return {
        "half": _reach(forces, 1.4, 2.0),
        "torque": to_text(applied[2]) if applied else "0",
        "force": [to_text(x) for x in applied[:2]] if applied else None,
        "torque_reach": _reach(torques, 1.2, 1.0),
        "axes": [f"{name} ({units.force})" for name in names] if units else names,
    }


def _most(sizes: Iterable[Fraction]) -> Fraction:
    """Return what nine of ten sizes do not exceed."""
    ordered = sorted(size for size in sizes if size)
    return ordered[(9 * (len(ordered) - 1)) // 10] if ordered else Fraction(0)


def _reach(values: Iterable[Fraction], room: float, least: float) -> float:
    """Return the largest size of numbers with some room; `least` where there is none but 0."""
    largest = max((abs(x) for x in values), default=Fraction(0))
    return float(largest * Fraction(room)) if largest else least


def floats(point: Any) -> list[float]:
    """Return coordinates on paper, short."""
    return [round(float(x), 5) + 0.0 for x in point]
