"""Our own claims: on grasps in space, on several bodies, and on the size of proofs of a "no"."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import comb
from operator import mul
from random import Random
from typing import TypeAlias

from arrangement import counts
from arrangement.arrangement import Arrangement
from arrangement.numbers.exact import RationalVector
from arrangement.numbers.linear.programs import some_point
from equilibrium.decide.solver import Solver, solve
from equilibrium.decide.verdict import Verdict
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.inputs.random import random_grasp
from equilibrium.model.assembly import Assembly, BodyContact
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from proofs_check.instances import printed
from proofs_check.instances.grasps import (
    BodiesQuestion,
    grasp_case,
    grasp_of,
    paper_question,
    textbook_questions,
)
from proofs_check.routes import oracle
from proofs_check.routes.bodies import resisted
from proofs_check.routes.leaves import leaf_count
from proofs_check.routes.oracle import Question
from proofs_check.statements.statement import Case

from .stated import stated

#: The verdicts in the plane and in space.
_Pair: TypeAlias = tuple[bool, bool]
_LOADS = tuple(
    tuple(map(Fraction, w)) for w in (("0", "1", "0"), ("0", "9/8", "0"), ("1", "1/2", "1/4"))
)


def _in_space(question: Question) -> tuple[Grasp, tuple[Fraction | int, ...]]:
    x, y, torque = question.wrench
    return grasp_of(question).in_space(), (x, y, 0, 0, 0, torque)


def _certified(grasp: Grasp, wrench: Sequence[Fraction | int], pyramid: int | None = None) -> bool:
    """Return what the checker says that the certificate of the solver proves."""
    verdict = solve(grasp, wrench, pyramid=pyramid)
    assert verdict.verify()
    return bool(verdict.proof["certificate"] == "resisted")


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
    solvable = False
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
        solvable = solvable or some_point(6, rows, balance) is not None
    return solve(Grasp([contact]), wrench).stable, solvable


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


def _general_faces(planes: int, d: int) -> int:
    """Return the faces of planes with normals on the moment curve, any d of them independent."""
    curve = [[Fraction(t) ** k for k in range(d)] for t in range(planes)]
    return sum(counts.f_vector(Arrangement(curve, dimension=d)))


def _slip_arrangement(rows: ContactRows) -> Arrangement:
    """Return the planes on which some contact does not slip along a tangent."""
    return Arrangement([t for row in rows for t in row.tangential_wrenches], dimension=rows.n)


def _slips_listed(rows: ContactRows) -> tuple[int, int]:
    planes = _slip_arrangement(rows)
    bound = _zaslavsky_bound(len(planes), rows.n)
    return len({face.signs for face in planes.faces()}), bound


def _slips_counted(rows: ContactRows) -> tuple[int, int]:
    planes = _slip_arrangement(rows)
    return sum(counts.f_vector(planes)), _general_faces(len(planes), rows.n)


def _zaslavsky_bound(planes: int, d: int) -> int:
    """Return the faces of this many planes in general position through the origin of R^d.

    A flat of k < d planes is one of ``comb(planes, k)``, and the others cut it into regions; all
    planes together leave the origin.
    """

    def regions(n: int, d: int) -> int:
        total: int = 2 * sum(comb(n - 1, i) for i in range(d))
        return total if n else 1

    if planes <= d:
        return int(3**planes)
    return 1 + sum(comb(planes, k) * regions(planes - k, d - k) for k in range(d))


#: For each contact of two bodies: the two that it joins; in a cycle with the ground, or in a stack.
_STACK: tuple[tuple[str, str | None], ...] = (("lower", None), ("upper", "lower"))
_CYCLE = (*_STACK, ("upper", None))


def _two_bodies(m: int, pairs: Sequence[tuple[str, str | None]]) -> Assembly:
    """Return two bodies with m random contacts, between each pair in turn."""
    contacts = enumerate(random_grasp(m, seed=m))
    joined = [BodyContact(*pairs[i % len(pairs)], contact) for i, contact in contacts]
    return Assembly(["lower", "upper"], joined)


def _slips_of_two(_: Random) -> Iterator[Case]:
    for m, (text, pairs) in product(range(4, 10), (("a cycle", _CYCLE), ("a stack", _STACK))):
        assembly = _two_bodies(m, pairs)
        label = f"{m} contacts of two bodies in {text}"
        yield Case(label, assembly.rows, assembly.to_dict())


#: An assembly that is a stack, and the grasps of its upper and its lower body alone.
_Stack: TypeAlias = tuple[Assembly, tuple[Grasp, Grasp]]


def _stacks(_: Random) -> Iterator[Case]:
    for m in range(2, 9):
        assembly = _two_bodies(m, _STACK)
        contacts = [c.contact for c in assembly.contacts]
        alone = Grasp(contacts[1::2]), Grasp(contacts[::2])
        yield Case(f"{m} contacts", (assembly, alone), assembly.to_dict())


def _product(count: Callable[[Arrangement], int]) -> Callable[[_Stack], tuple[int, int]]:
    """Return what counts the slip states of a stack, and multiplies those of its bodies."""

    def counted(stack: _Stack) -> tuple[int, int]:
        whole, parts = stack
        upper, lower = (count(_slip_arrangement(ContactRows.of_grasp(one))) for one in parts)
        return count(_slip_arrangement(whole.rows)), upper * lower

    return counted


def _loaded_stacks(rng: Random) -> Iterator[Case]:
    """Yield questions on stacks of two bodies, with 1 and 3 contacts, 2 and 2, or 3 and 1."""
    names = ("lower", "upper")
    for k in range(24):
        lower, contacts = 1 + k % 3, random_grasp(4, seed=k).contacts
        joined = [BodyContact(*_STACK[i >= lower], c) for i, c in enumerate(contacts)]
        assembly = Assembly(names, joined).with_preload(k % 4 and 1)
        document = {**assembly.to_dict(), "bodies": list(names)}
        loads = [Fraction(rng.randint(-2, 2)) for _ in range(6)]
        if k % 2:
            loads = _balancing_load(assembly.rows, loads)
        texts = list(map(str, loads))
        wrench = {"lower": texts[:3], "upper": texts[3:]}
        question = BodiesQuestion("", document, wrench, False, None)
        yield Case(f"stack {k}", question, {**document, "wrench": wrench})


def _balancing_load(rows: ContactRows, motion: Sequence[Fraction]) -> list[Fraction]:
    """Return a load that the contacts balance, at a motion."""
    load = [Fraction(0)] * rows.n
    for row in rows:
        slip = sum(map(mul, row.tangential_wrenches[0], motion))
        pressed = row.preload - row.stiffness * sum(map(mul, row.normal_wrench, motion))
        rub = -row.friction if slip > 0 else row.friction if slip < 0 else 0
        for j, (x, y) in enumerate(zip(row.normal_wrench, row.tangential_wrenches[0], strict=True)):
            load[j] -= max(pressed, Fraction(0)) * (x + rub * y)
    return load


def _apart(question: BodiesQuestion) -> list[Question]:
    """Return the question of each body of a stack: the lower one carries both loads."""
    upper = tuple(map(Fraction, question.wrench["upper"]))
    own = zip(map(Fraction, question.wrench["lower"]), upper, strict=True)
    loads = {None: tuple(x + y for x, y in own), "lower": upper}
    questions = []
    for below, load in loads.items():
        rows = [c for c in question.document["contacts"] if c["body_b"] == below]
        values = ("friction", "stiffness", "preload")
        defaults = {"stiffness": "1", "preload": "0"}
        numbers = [
            (*c["point"], *c["normal"], *(c.get(x, defaults.get(x)) for x in values)) for c in rows
        ]
        questions.append(Question(tuple(tuple(map(Fraction, row)) for row in numbers), load))
    return questions


def _bodies_solved(question: BodiesQuestion) -> bool:
    """Return the verdict of the solver, whose certificate the checker accepts."""
    verdict = solve(Assembly.from_dict(question.document), question.wrench)
    assert verdict.verify()
    return verdict.stable


def _bodies_by_force(question: BodiesQuestion) -> bool:
    return resisted(question.document, question.wrench)


#: With more contacts brute force takes minutes.
_MOST_CONTACTS = 8


def _textbook(_: Random) -> Iterator[Case]:
    for question in textbook_questions():
        if len(question.document["contacts"]) <= _MOST_CONTACTS:
            document = {**question.document, "wrench": question.wrench}
            yield Case(question.case, question, document)


#: Two fingers and a load that pyramids of 4 edges hold, and finer ones and round cones do not.
_TWO_FINGERS = Grasp(
    [Contact([1, 1, 1], [0, -1, 0], 1), Contact([-1, 0, 0], [0, 0, -1], "1/2", preload=1)]
)
_LET_GO = (0, 1, 2, 0, 0, 1)
#: Edges; None is the round cone.
_FINER = (4, 8, None)


def _by_proofs(grasp: Grasp) -> tuple[bool, ...]:
    """Return what the checker says that the certificates prove."""
    return tuple(_certified(grasp, _LET_GO, edges) for edges in _FINER)


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
def _verdict(question: Question) -> Verdict:
    return Solver(grasp_of(question)).solve(question.wrench)


def _accepted_leaves(question: Question) -> int:
    report = _verdict(question).verify()
    if not report or not report.leaves:
        raise ValueError(f"the certificate is not a proof: {report}")
    return report.leaves


CLAIMS = (
    stated(
        "more-edges-hold-no-less",
        solver=lambda grasp: tuple(solve(grasp, _LET_GO, pyramid=edges).stable for edges in _FINER),
        certificates=_by_proofs,
        judge=lambda grasp, verdicts: list(verdicts) == sorted(verdicts),
        cases=lambda _: [
            Case("two fingers, w = (0, 1, 2, 0, 0, 1)", _TWO_FINGERS, _TWO_FINGERS.to_dict())
        ],
        explain=lambda grasp, verdicts: " ".join("yes" if v else "no" for v in verdicts),
    ),
    stated(
        "boxes-change-verdicts",
        linear_programs=_boxed_by_programs,
        hand=_boxed_by_hand,
        judge=lambda finger, verdicts: verdicts[0] == verdicts[1],
        cases=_fingers,
        explain=lambda finger, verdicts: f"resisted {verdicts[0]}, within the bounds {verdicts[1]}",
    ),
    stated(
        "slip-states-in-space",
        faces=lambda grasp: _slips_listed(ContactRows.of_grasp(grasp)),
        theorem=lambda grasp: _slips_counted(ContactRows.of_grasp(grasp)),
        judge=lambda grasp, numbers: numbers[0] <= numbers[1],
        cases=_slip_planes,
        explain=lambda grasp, numbers: f"{numbers[0]} of at most {numbers[1]}",
    ),
    stated(
        "slip-states-of-two-bodies",
        faces=_slips_listed,
        theorem=_slips_counted,
        judge=lambda rows, numbers: numbers[0] <= numbers[1],
        cases=_slips_of_two,
        explain=lambda rows, numbers: f"{numbers[0]} of at most {numbers[1]}",
    ),
    stated(
        "slip-states-of-a-stack",
        faces=_product(lambda planes: len({face.signs for face in planes.faces()})),
        theorem=_product(lambda planes: sum(counts.f_vector(planes))),
        judge=lambda stack, numbers: numbers[0] == numbers[1],
        cases=_stacks,
        explain=lambda stack, numbers: f"{numbers[0]}, and the product is {numbers[1]}",
    ),
    stated(
        "stacks-are-decided-apart",
        brute_force=lambda question: (
            _bodies_by_force(question),
            all(map(oracle.stable, _apart(question))),
        ),
        solvers=lambda question: (
            _bodies_solved(question),
            all(_verdict(one).stable for one in _apart(question)),
        ),
        judge=lambda question, verdicts: verdicts[0] == verdicts[1],
        cases=_loaded_stacks,
        explain=lambda question, verdicts: f"together {verdicts[0]}, apart {verdicts[1]}",
    ),
    stated(
        "textbook-bodies",
        brute_force=_bodies_by_force,
        solver=_bodies_solved,
        judge=lambda question, verdict: verdict == question.resisted,
        cases=_textbook,
        explain=lambda question, verdict: "resisted" if verdict else "not resisted",
    ),
    stated(
        "planar-verdicts-embed",
        states=lambda question: (oracle.stable(question), solve(*_in_space(question)).stable),
        certificates=lambda question: (
            _certified(grasp_of(question), question.wrench),
            _certified(*_in_space(question), 4),
        ),
        judge=lambda question, verdicts: verdicts[0] == verdicts[1],
        cases=_cases,
        explain=lambda question, verdicts: f"in the plane {verdicts[0]}, in space {verdicts[1]}",
    ),
    stated(
        "leaves-do-not-grow",
        checker=_accepted_leaves,
        generators=lambda question: leaf_count(question, _verdict(question).proof["tree"]),
        judge=lambda question, leaves: leaves <= _accepted_leaves(_jaws(4, question.wrench)),
        cases=lambda _: (
            grasp_case(_jaws(m, load), f"m = {m}, w = ({', '.join(map(str, load))})")
            for load, m in product(_JAW_LOADS, _COUNTS)
        ),
        explain=lambda question, leaves: f"{leaves} leaves for {len(question.contacts)} contacts",
    ),
)
