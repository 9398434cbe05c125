"""Self-grading exercises for lessons 1 to 9, and 14."""

from fractions import Fraction
from itertools import product

from arrangement import Arrangement, counts, read_arrangement
from equilibrium import ResistedSet, read_grasp, solve, verify
from equilibrium.grasps.textbook import stack
from proofs_check import exercise


@exercise("Lesson 1: the wrench of a force (0, -2) at the point (3, 1).", of="numbers")
def wrench(answer):
    return answer == (0, -2, -6)


@exercise("Lesson 1: a unit vector within 1/1000 of the direction (1, 1).", of="numbers", points=2)
def unit_vector(answer):
    if len(answer) != 2 or sum(x * x for x in answer) != 1:
        return "this is not a unit vector of the plane"
    x, y = answer
    return abs(x - y) * 1000 <= x + y or "it is too far from (1, 1)"


@exercise("Lesson 2: a motion, not 0, at which all of paper-four-contacts stick.", of="numbers")
def all_stick(motion):
    if len(motion) != 3 or not any(motion):
        return "a motion is three numbers, not all 0"
    slips = [
        sum(a * b for a, b in zip(contact.tangential_wrench, motion, strict=True))
        for contact in read_grasp("paper-four-contacts")
    ]
    return not any(slips) or f"contact {next(i for i, s in enumerate(slips, 1) if s)} slips"


@exercise(
    "Lesson 3: the vectors of + and - that no point has on the planes with normals (1,0,0), "
    "(0,1,0), (0,0,1), (1,1,1).",
    of="states",
    points=2,
)
def missing_signs(answer):
    planes = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    there = {tuple("0+-"[s] for s in face.signs) for face in planes.regions()}
    missing = set(product("+-", repeat=4)) - there
    found = len(answer & missing)
    return answer == missing or f"{found} of {len(missing)}, and {len(answer - missing)} that occur"


@exercise("Lesson 4: how many regions have the planes x_i = x_j in four dimensions?")
def orders(answer):
    return answer == counts.region_count(read_arrangement("braid-a3-in-r4"))


@exercise(
    "Lesson 5: five different planes through the origin, of rank 3, with as few regions as can be.",
    of="planes",
    points=2,
)
def few_regions(planes):
    if len(planes.distinct) != 5 or not planes.is_central or planes.dimension != 3:
        return "these are not five different planes through the origin of space"
    if planes.rank != 3:
        return "their normals have a rank below 3"
    vertices, _, _ = planes.dual().f_vector
    return vertices == 16 or f"they have {vertices} regions"


@exercise(
    "Lesson 8: a load of paper-three-contacts-preload-1 under which contact 2 lets go.",
    of="numbers",
    points=2,
)
def let_go(load):
    found = solve(read_grasp("paper-three-contacts-preload-1"), load).equilibria
    return any(one.states[1] == "detached" for one in found) or "no equilibrium has it detached"


@exercise(
    "Lesson 9: prove that paper-three-contacts-preload-1 does not resist (0, 2, 0).",
    of="certificate",
    points=3,
)
def too_much(document):
    return verify(document, (read_grasp("paper-three-contacts-preload-1"), (0, 2, 0)))


@exercise("Lesson 14: a push on the top of three blocks (make stack) that is just resisted.")
def top_push(answer):
    blocks, weights = stack(blocks=3)
    ends = ResistedSet(blocks).along({"block 3": (1, 0, Fraction(-5, 2))}, weights).intervals[0]
    return answer == ends[1]
