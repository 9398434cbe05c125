"""Our own claims: on grasps in space, and on the size of proofs that nothing balances a load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import comb
from random import Random
from typing import TypeAlias

from arrangement.numbers.linear.programs import some_point
from equilibrium.decide.solver import solve
from equilibrium.decide.verdict import Verdict
from equilibrium.grasps.inputs.random import random_grasp
from proofs_check.routes.leaves import leaf_count

from .parts import *

#: The verdicts in the plane and in space.
_Pair: TypeAlias = tuple[bool, bool]
_LOADS = tuple(
    tuple(map(Fraction, w)) for w in (("0", "1", "0"), ("0", "9/8", "0"), ("1", "1/2", "1/4"))
)


def _in_space(question: Question, pyramid: int | None) -> bool:
    x, y, torque = question.wrench
    wrench = (x, y, 0, 0, 0, torque)
    return solve(grasp_of(question).in_space(), wrench, pyramid=pyramid).stable


def _cases(_: Random) -> Iterator[Case]:
    for contacts, preload, load in product(
        (printed.THREE_CONTACT_GRASP, printed.FOUR_CONTACT_GRASP), (0, 1), _LOADS
    ):
        question = paper_question(contacts, load, preload)
        label = f"{len(contacts)} contacts, P = {preload}, w = ({', '.join(map(str, load))})"
        yield grasp_case(question, label)


#: Bounds of the unknowns in a mixed-integer model of grasps in space: every coordinate of the
#: motion, every force, every torque of a force.
_MOTION, _FORCE, _TORQUE = 5, 200, 2500


@dataclass(frozen=True)
class _Finger:
    """One contact without friction or preload under a load along its normal."""

    contact: Contact
    force: Fraction

    @property
    def wrench(self) -> RationalVector:
        """The load."""
        return tuple(-self.force * x for x in self.contact.normal_wrench)


def _finger(reach: int, stiffness: str, force: int) -> _Finger:
    return _Finger(Contact([reach, 0, 0], [0, 0, 1], 0, stiffness), Fraction(force))


def _fingers(_: Random) -> Iterator[Case]:
    for text, finger in (
        ("motion", _finger(0, "1", 6)),
        ("force", _finger(0, "100", 201)),
        ("torque", _finger(100, "26", 26)),
    ):
        grasp = Grasp([finger.contact])
        yield Case(f"bound of the {text}", finger, grasp.to_dict())


def _boxed_by_programs(finger: _Finger) -> _Pair:
    """Return the verdict without bounds, and the linear programs of both states with them."""
    contact, wrench = finger.contact, finger.wrench
    normal, k = contact.normal_wrench, contact.stiffness
    unit = [[Fraction(int(i == j)) for j in range(6)] for i in range(6)]
    box = [[s * x for x in row] + [Fraction(_MOTION)] for row in unit for s in (1, -1)]
    spring = [-k * x for x in normal]
    found = False
    for touches in (True, False):
        sign = 1 if touches else -1
        rows = [*box, [sign * x for x in spring] + [Fraction(0)]]
        force = [*spring, Fraction(0)] if touches else [Fraction(0)] * 7
        rows.append([-x for x in force[:-1]] + [Fraction(_FORCE)])
        for lever in normal[3:]:
            rows += [[s * lever * x for x in force[:-1]] + [Fraction(_TORQUE)] for s in (1, -1)]
        balance = [
            [along * x for x in force[:-1]] + [load]
            for along, load in zip(normal, wrench, strict=True)
        ]
        found = found or some_point(6, rows, balance) is not None
    return solve(Grasp([contact]), wrench).stable, found


def _boxed_by_hand(finger: _Finger) -> _Pair:
    """The force is the load's; the least largest coordinate of d with N . d = s is |s|/|N|_1."""
    normal = finger.contact.normal_wrench
    motion = finger.force / finger.contact.stiffness / sum(map(abs, normal))
    torque = finger.force * max(map(abs, normal[3:]))
    return finger.force >= 0, motion <= _MOTION and finger.force <= _FORCE and torque <= _TORQUE


def _slip_planes(_: Random) -> Iterator[Case]:
    for m in range(1, 5):
        grasp = random_grasp(m, seed=1, dimension=3)
        yield Case(f"{m} random contacts", grasp, grasp.to_dict())
    for name in ("two-opposed-fingers", "box-on-a-table"):
        grasp = read_grasp(name)
        yield Case(name, grasp, grasp.to_dict())


def _general_faces(planes: int) -> int:
    """Return the faces of planes with normals on the moment curve, any six of them independent."""
    curve = [[Fraction(t) ** k for k in range(6)] for t in range(planes)]
    return sum(Arrangement(curve, dimension=6).f_vector)


def _slip_arrangement(grasp: Grasp) -> Arrangement:
    return Arrangement([row for c in grasp for row in c.tangential_wrenches], dimension=6)


def _zaslavsky_bound(planes: int) -> int:
    """Return the faces of this many planes in general position through the origin of R^6.

    A flat of k < 6 planes is one of ``comb(planes, k)``, and the others cut it into regions; all
    planes together leave the origin.
    """

    def regions(n: int, d: int) -> int:
        total: int = 2 * sum(comb(n - 1, i) for i in range(d))
        return total if n else 1

    if planes <= 6:
        return int(3**planes)
    return 1 + sum(comb(planes, k) * regions(planes - k, 6 - k) for k in range(6))


#: Two fingers and a load that pyramids of 4 edges hold, and finer ones and round cones do not.
_TWO_FINGERS = Grasp(
    [Contact([1, 1, 1], [0, -1, 0], 1), Contact([-1, 0, 0], [0, 0, -1], "1/2", preload=1)]
)
_LET_GO = (0, 1, 2, 0, 0, 1)
#: Edges; None is the round cone.
_FINER = (4, 8, None)


def _by_proofs(grasp: Grasp) -> tuple[bool, ...]:
    """Return what the checker says that the certificates prove."""
    found = []
    for edges in _FINER:
        verdict = solve(grasp, _LET_GO, pyramid=edges)
        assert verdict.verify()
        found.append(verdict.proof["certificate"] == "resisted")
    return tuple(found)


#: Loads beyond what two jaws hold, whatever the number of their contacts: 2 along the jaws.
_JAW_LOADS = (
    *(tuple(map(Fraction, x)) for x in (("0", "3", "0"), ("1/2", "3", "1"), ("1", "-5/2", "1"))),
    *((Fraction(0), 2 + Fraction(1, 10**power), Fraction(0)) for power in (3, 30)),
)
_COUNTS = (4, 6, 10, 20, 40, 80)


def _jaws(m: int, load: tuple[Fraction, ...]) -> Question:
    """Return m / 2 contacts at even distances on either jaw, of stiffness and preload 4 in all.

    For m = 4 this is the four-contact grasp of the paper with preload 1.
    """
    n, share = m // 2, Fraction(4, m)
    heights = [Fraction(2 * k - (n - 1), n - 1) for k in range(n)]
    rows = tuple(
        (Fraction(-side), height, Fraction(side), Fraction(0), printed.FRICTION, share, share)
        for side, height in product((1, -1), heights)
    )
    return Question(rows, load)


@lru_cache(maxsize=64)
def _decided(question: Question) -> Verdict:
    return Solver(grasp_of(question)).solve(question.wrench)


def _checked(question: Question) -> int:
    report = _decided(question).verify()
    if not report or not report.leaves:
        raise ValueError(f"the certificate is not a proof: {report}")
    return report.leaves


CLAIMS = (
    stated(
        "more-edges-hold-no-less",
        lambda grasp: tuple(solve(grasp, _LET_GO, pyramid=edges).stable for edges in _FINER),
        _by_proofs,
        judge=lambda grasp, verdicts: list(verdicts) == sorted(verdicts),
        cases=lambda _: [
            Case("two fingers, w = (0, 1, 2, 0, 0, 1)", _TWO_FINGERS, _TWO_FINGERS.to_dict())
        ],
        explain=lambda grasp, verdicts: " ".join("yes" if v else "no" for v in verdicts),
    ),
    stated(
        "boxes-change-verdicts",
        _boxed_by_programs,
        _boxed_by_hand,
        judge=lambda finger, verdicts: verdicts[0] == verdicts[1],
        cases=_fingers,
        explain=lambda finger, verdicts: f"resisted {verdicts[0]}, within the bounds {verdicts[1]}",
    ),
    stated(
        "slip-states-in-space",
        lambda grasp: (
            len({face.signs for face in _slip_arrangement(grasp).faces()}),
            _zaslavsky_bound(2 * len(grasp)),
        ),
        lambda grasp: (sum(_slip_arrangement(grasp).f_vector), _general_faces(2 * len(grasp))),
        judge=lambda grasp, numbers: numbers[0] <= numbers[1],
        cases=_slip_planes,
        explain=lambda grasp, numbers: f"{numbers[0]} of at most {numbers[1]}",
    ),
    stated(
        "planar-verdicts-embed",
        lambda question: (oracle.stable(question), _in_space(question, None)),
        lambda question: (_decided(question).stable, _in_space(question, 4)),
        judge=lambda question, verdicts: verdicts[0] == verdicts[1],
        cases=_cases,
        explain=lambda question, verdicts: f"in the plane {verdicts[0]}, in space {verdicts[1]}",
    ),
    stated(
        "leaves-do-not-grow",
        _checked,
        lambda question: leaf_count(question, _decided(question).proof["tree"]),
        judge=lambda question, leaves: leaves <= _checked(_jaws(4, question.wrench)),
        cases=lambda _: (
            grasp_case(_jaws(m, load), f"m = {m}, w = ({', '.join(map(str, load))})")
            for load, m in product(_JAW_LOADS, _COUNTS)
        ),
        explain=lambda question, leaves: f"{leaves} leaves for {len(question.contacts)} contacts",
    ),
)
