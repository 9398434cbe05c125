"""Claims on grasps in space."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import comb
from random import Random
from typing import TypeAlias

from arrangement import Arrangement
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.programs import Infeasible, feasible_point
from equilibrium.decide.spatial_verdict import solve_in_space
from equilibrium.decide.verdict import Solver
from equilibrium.grasps.files import read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from proofs_check.instances.grasps import grasp_case, grasp_of, paper_question
from proofs_check.instances.paper_tables import FOUR_CONTACT_GRASP, THREE_CONTACT_GRASP
from proofs_check.routes.oracle import Question, stable
from proofs_check.statements.statement import Case, Claim, Route, Verdict, exhaustive, sampled

#: The verdicts in the plane and in space.
_Pair: TypeAlias = tuple[bool, bool]
_LOADS = tuple(
    tuple(map(Fraction, w)) for w in (("0", "1", "0"), ("0", "9/8", "0"), ("1", "1/2", "1/4"))
)


def _in_space(question: Question, pyramid: int | None) -> bool:
    x, y, torque = question.wrench
    wrench = (x, y, 0, 0, 0, torque)
    return solve_in_space(grasp_of(question).in_space(), wrench, pyramid=pyramid).stable


@lru_cache(maxsize=64)
def _by_states(question: Question) -> _Pair:
    return stable(question), _in_space(question, None)


@lru_cache(maxsize=64)
def _by_solver(question: Question) -> _Pair:
    return Solver(grasp_of(question)).solve(question.wrench).stable, _in_space(question, 4)


def _cases(source: Random) -> Iterator[Case]:
    del source
    for contacts, preload, load in product(
        (THREE_CONTACT_GRASP, FOUR_CONTACT_GRASP), (0, 1), _LOADS
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


def _fingers(source: Random) -> Iterator[Case]:
    del source
    for text, finger in (
        ("motion", _finger(0, "1", 6)),
        ("force", _finger(0, "100", 201)),
        ("torque", _finger(100, "26", 26)),
    ):
        grasp = Grasp([finger.contact])
        yield Case(f"bound of the {text}", finger, grasp.to_dict())


def _boxed_by_programs(finger: _Finger) -> _Pair:
    """The verdict without bounds, and the linear programs of both states with them."""
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
        found = found or not isinstance(feasible_point(6, rows, balance), Infeasible)
    return solve_in_space(Grasp([contact]), wrench).stable, found


def _boxed_by_hand(finger: _Finger) -> _Pair:
    """The force is the load's; the least largest coordinate of d with N . d = s is |s|/|N|_1."""
    normal = finger.contact.normal_wrench
    motion = finger.force / finger.contact.stiffness / sum(map(abs, normal))
    torque = finger.force * max(map(abs, normal[3:]))
    return finger.force >= 0, motion <= _MOTION and finger.force <= _FORCE and torque <= _TORQUE


def _slip_planes(source: Random) -> Iterator[Case]:
    del source
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


def _zaslavsky_bound(planes: int, rank: int = 6) -> int:
    """Return the faces of so many planes in general position through the origin of R^rank.

    A flat of k < rank planes is one of ``comb(planes, k)``, and the others cut it into regions; all
    planes together leave the origin.
    """

    def regions(n: int, d: int) -> int:
        total: int = 2 * sum(comb(n - 1, i) for i in range(d))
        return total if n else 1

    if planes <= rank:
        return int(3**planes)
    return 1 + sum(comb(planes, k) * regions(planes - k, rank - k) for k in range(rank))


#: Two fingers and a load that pyramids of 4 edges hold, and finer ones and round cones do not.
_TWO_FINGERS = Grasp(
    [Contact([1, 1, 1], [0, -1, 0], 1), Contact([-1, 0, 0], [0, 0, -1], "1/2", preload=1)]
)
_LET_GO = (0, 1, 2, 0, 0, 1)
#: Edges; None is the round cone.
_FINER = (4, 8, None)


def _pyramids(source: Random) -> Iterator[Case]:
    del source
    yield Case("two fingers, w = (0, 1, 2, 0, 0, 1)", _TWO_FINGERS, _TWO_FINGERS.to_dict())


def _by_search(grasp: Grasp) -> tuple[bool, ...]:
    return tuple(solve_in_space(grasp, _LET_GO, pyramid=edges).stable for edges in _FINER)


def _by_proofs(grasp: Grasp) -> tuple[bool, ...]:
    """What the checker says that the certificates prove."""
    found = []
    for edges in _FINER:
        verdict = solve_in_space(grasp, _LET_GO, pyramid=edges)
        assert verdict.verify()
        assert verdict.certificate is not None
        found.append(verdict.certificate.kind == "resisted")
    return tuple(found)


CLAIMS = (
    Claim(
        id="more-edges-hold-no-less",
        locator="our claim, on grasps in space",
        statement="A wrench that is resisted with friction pyramids of 4 edges is resisted with "
        "pyramids of 8 that contain them, and with the round cones around both.",
        quantity="verdicts with 4 edges, with 8, with round cones",
        routes=(
            Route("the solver", _by_search),
            Route("certificates, read by the checker", _by_proofs),
        ),
        judge=lambda grasp, verdicts: list(verdicts) == sorted(verdicts),
        sources=sampled("two fingers, found by a random search", _pyramids),
        expected=Verdict.REFUTED,
        explain=lambda grasp, verdicts: " ".join("yes" if v else "no" for v in verdicts),
        meaning="Pyramids inside the cone let friction deviate from the slip; the round cone does "
        "not. So verdicts of pyramids are no lower bound. One contact alone is no counterexample: "
        "it need not slip.",
        rows=True,
    ),
    Claim(
        id="boxes-change-verdicts",
        locator="our claim, on grasps in space",
        statement="Bounds on the unknowns, every coordinate of the motion at most 5, every force "
        "at most 200 and every torque at most 2,500, change no verdict.",
        quantity="verdicts without the bounds and with them",
        routes=(
            Route("the solver; linear programs of both states", _boxed_by_programs),
            Route("the one force that balances, by hand", _boxed_by_hand),
        ),
        judge=lambda finger, verdicts: verdicts[0] == verdicts[1],
        sources=exhaustive("one instance for each of the three bounds", _fingers),
        expected=Verdict.REFUTED,
        explain=lambda finger, verdicts: f"resisted {verdicts[0]}, within the bounds {verdicts[1]}",
        meaning="One contact pressed along its normal has one force and one depth. Each bound "
        "alone refuses what the contact holds.",
        rows=True,
    ),
    Claim(
        id="slip-states-in-space",
        locator="our claim, on grasps in space",
        statement="m contacts in space, each with two tangent planes, have no more slip states "
        "than 2m planes in general position through the origin of six dimensions have faces.",
        quantity="number of slip states, and of faces in general position",
        routes=(
            Route(
                "faces listed",
                lambda grasp: (
                    len({face.signs for face in _slip_arrangement(grasp).faces()}),
                    _zaslavsky_bound(2 * len(grasp)),
                ),
            ),
            Route(
                "Zaslavsky's theorem, for the grasp and for powers of the moment curve",
                lambda grasp: (
                    sum(_slip_arrangement(grasp).f_vector),
                    _general_faces(2 * len(grasp)),
                ),
            ),
        ),
        judge=lambda grasp, numbers: numbers[0] <= numbers[1],
        sources=sampled("1 to 4 random contacts, and two known grasps", _slip_planes),
        explain=lambda grasp, numbers: f"{numbers[0]} of at most {numbers[1]}",
        meaning="Up to three contacts every choice of signs can occur; from four on the number "
        "grows as the fifth power of m, no longer as 9^m.",
        rows=True,
    ),
    Claim(
        id="planar-verdicts-embed",
        formula=r"(f_x, f_y, \tau) \iff (f_x, f_y, 0, 0, 0, \tau)",
        locator="our claim, on grasps in space",
        statement="The contacts of a planar grasp, put into the plane z = 0 of space with round "
        "friction cones, resist a wrench of that plane exactly when the planar grasp does.",
        hypotheses=(),
        quantity="verdicts in the plane and in space",
        routes=(
            Route("all states in the plane; sectors and enclosures in space", _by_states),
            Route("the planar solver; linear programs with pyramids in space", _by_solver),
        ),
        judge=lambda question, verdicts: verdicts[0] == verdicts[1],
        sources=sampled("the paper's contacts, without preload and with preload 1", _cases),
        explain=lambda question, verdicts: f"in the plane {verdicts[0]}, in space {verdicts[1]}",
        meaning="Nothing leaves the plane: forces along z balance, and friction that works against "
        "a slip out of the plane would not. The page on proofs has the proof.",
    ),
)
