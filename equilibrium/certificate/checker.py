"""The checker of certificates: no solver, no floats; it sees the question and the document.

"resisted": a motion and forces that obey the law. "not resisted": a tree of regions and states, see
`equilibrium.certificate.reading`. A region is the cone of integer generators ``g = (g_0, d)`` with
``g_0 >= 0``, and has the motions ``d / g_0``; the conditions of states are closed. A leaf is a
virtual motion lambda on which the load does more work than all that contacts can do takes away.
With ``e = q g_0 - k N . d``, ``s = T . d``, ``a = lambda . N``, ``b = lambda . T`` a contact does
kappa times its normal force or more: kappa is ``a - mu b`` in slip+, and if all s > 0 while it is
undecided or attached; ``a + mu b`` in slip-, and if all s < 0; else ``a - mu |b|``. So its work at
each generator is at least ``alpha e + h s``, if the leaf gives these multipliers, with

* ``alpha >= 0`` where it is undecided or detached, ``alpha <= kappa`` unless it is detached;
* h = 0 but for ``h <= 0`` in slip+, ``h >= 0`` in slip-, any h in stick;

else kappa e, if it is decided and not detached, or if all ``e >= 0``; 0, if it is detached, or if
all ``e <= 0``, or if ``kappa >= 0``; ``kappa max(0, e)`` for the rest, as a convex function lies
below its interpolation. The leaf holds if ``lambda . w g_0`` and all these are together at least 0
at each generator, above 0 where ``g_0 > 0``: balance would make their sum over generators 0.

Where only displacements of contact points up to D count, a leaf may give numbers a, b of contacts:
the sum is smaller by ``(|a| D + |b| D) g_0 - a N . d - b T . d`` for each, see
`equilibrium.certificate.law.displacement_work`.

In space a tree has states alone, with sectors of slip directions; `equilibrium.certificate.space`
has its leaves, and `equilibrium.certificate.enclosure` equilibria in intervals. Where contacts and
load lie in one plane, and cones are round, a planar tree will do: out of the plane forces do no
work together, and friction none or less at each contact, so no loaded contact slips that way, and
what the motion and the forces are in the plane would be an equilibrium there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import product
from typing import Any, NamedTuple, TypeAlias

from arrangement.console.number_form import ReprMixin
from arrangement.console.plugins import named
from arrangement.numbers.exact import IntegerVector, RationalVector, to_text, vector_text
from equilibrium.model.contact import VALUES, pyramid_edges
from equilibrium.model.displacement import along_tangents, displacement_entry
from equilibrium.model.errors import CertificateError, GraspError
from equilibrium.model.grasp import Grasp, in_plane, read_wrench

from .enclosure import enclosure_problem
from .law import displacement_problem, displacement_work, frame, law_problem, short
from .reading import (
    STATES,
    Leaf,
    Split,
    read_bound,
    read_enclosure,
    read_equilibrium,
    read_node,
    read_plane,
    read_question,
)
from .robust import read_bounds, robust_problem
from .space import SpatialQuestion, State, spatial_leaf_problem, split_states
from .uncertain import Bounds

#: A grasp and a wrench.
Question: TypeAlias = tuple[Grasp, RationalVector]
#: Splits in a row; readers of JSON stop at some 1000 objects inside one another.
MAX_DEPTH = 300


@dataclass(frozen=True, repr=False)
class Report(ReprMixin):
    """What a check found; it is true exactly when the proof holds.

    Attributes:
        kind: "resisted" or "not resisted".
        problem: the first inequality that fails and its place, or where the question is another
            one than that asked; empty when all hold.
        leaves: of the tree.
        pyramid: edges of the friction pyramids that it is about; None for cones.
        compared: whether the question that it is about was compared with one asked.
        grasp, wrench: that question.
        max_displacement: how far contact points may move for an equilibrium to count, if bounded.
        bounds: of the grasps for all of which it holds; None: it is about one.
    """

    kind: str
    problem: str
    leaves: int = 0
    pyramid: int | None = None
    compared: bool = False
    grasp: Grasp = field(default_factory=Grasp)
    wrench: RationalVector = ()
    max_displacement: Fraction | None = None
    bounds: Bounds | None = None
    repr_fields = ("kind", "problem", "leaves", "pyramid", "compared")

    def __bool__(self) -> bool:
        return not self.problem

    def asked(
        self,
        question: Question | None,
        pyramid: int | None = None,
        max_displacement: Fraction | None = None,
    ) -> Report:
        """Return what this says of a question: nothing, if the certificate is about another one."""
        if question is None:
            return self
        problem = _difference(question, (self.grasp, self.wrench))
        if not problem and pyramid != self.pyramid:
            problem = "it is about other cones of friction"
        if not problem and max_displacement != self.max_displacement:
            problem = "it is about other displacements of contacts"
        return replace(self, problem=problem or self.problem, compared=True)

    @property
    def to_compare(self) -> str:
        """How the command compares what it is about with a question."""
        return "not compared with a grasp and wrench: give --grasp FILE --wrench W"

    @property
    def question(self) -> list[str]:
        """What it is about, in lines: the wrench and each contact."""
        contacts = [f"contact {i} {c.words}" for i, c in enumerate(self.grasp, 1)]
        return [f"wrench {vector_text(self.wrench)}", *contacts]

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        found: dict[str, Any] = {"problem": self.problem} if self.problem else {}
        if self.pyramid is not None:
            found["pyramid"] = self.pyramid
        found |= displacement_entry(self.max_displacement)
        if self.bounds is not None:
            found["bounds"] = self.bounds.to_dict()
        about = {"wrench": list(map(to_text, self.wrench)), "grasp": self.grasp.to_dict()}
        return {
            "valid": bool(self),
            "certificate": self.kind,
            "leaves": self.leaves,
            **found,
            **about,
            "compared": self.compared,
        }


def _difference(asked: Question, found: Question) -> str:
    """Return the first difference of a certificate from what is expected, or nothing."""
    (wanted, load), (own, wrench) = asked, found
    if (own.dimension, len(own)) != (wanted.dimension, len(wanted)):
        sizes = (f"{len(g)} contacts in {g.dimension} dimensions" for g in (own, wanted))
        return "it is about another grasp: {}; expected one with {}".format(*sizes)
    rows = [
        (f"grasp: {name} of contact {i}", getattr(one, name), getattr(other, name))
        for i, (one, other) in enumerate(zip(own, wanted, strict=True), 1)
        for name in ("point", "normal", *VALUES, "tangent")
    ]
    for name, one, other in [*rows, ("wrench: it", wrench, read_wrench(load, own.dimension))]:
        if one != other:
            pair = [x if isinstance(x, tuple) else (x,) for x in (one, other)]
            texts = [vector_text(x) if len(x) > 1 else short(*x) for x in pair]
            apart = [abs(a - b) for a, b in zip(*pair, strict=True)]
            unlike = f" ({short(max(apart))} apart)" if "≈" in "".join(texts) else ""
            return f"it is about another {name} is {texts[0]}; expected {texts[1]}{unlike}"
    return ""


def check(
    document: Mapping[str, Any],
    question: Question | None = None,
    pyramid: int | None = None,
    max_displacement: Fraction | None = None,
) -> Report:
    """Check a certificate, given as `Certificate.to_dict` or `read_certificate` returns it.

    Args:
        question: the grasp and wrench that the certificate has to be about; if omitted, the report
            says what it is about, and that this was compared with nothing.
        pyramid: with a question, the edges of the friction pyramids it has to be about; None for
            cones, in space round ones.
        max_displacement: with a question, the largest displacement it has to be about.

    Raises:
        InputError: this is not a certificate, whatever its numbers are: wrong keys or types,
            floats, a split that does not fit its region. A wrong proof is a false report instead.

    Complexity: O(m) integer operations for each node of the tree.
    """
    if isinstance(document, Mapping) and "assembly" in document:
        report: Report = named("equilibrium.certificate.assemblies:check_assembly")(
            document, question
        )
        return report
    kind, grasp, wrench = read_question(document)
    bound = read_bound(document)
    if "bounds" in document:
        problem = robust_problem(document, grasp, wrench)
        report = Report(kind, problem, bounds=read_bounds(document))
    elif kind == "resisted":
        report = Report(kind, _equilibrium_problem(document, grasp, wrench, bound))
    elif grasp.dimension == 3:
        report = _spatial_report(document, grasp, wrench, bound)
    else:
        report = _walk(document["tree"], IntegerQuestion(grasp, wrench, bound))
    pyramid_of = document.get("pyramid")
    report = replace(report, pyramid=pyramid_of, max_displacement=bound, grasp=grasp, wrench=wrench)
    return report.asked(question, pyramid, max_displacement)


def _spatial_report(
    document: Mapping[str, Any],
    grasp: Grasp,
    wrench: RationalVector,
    max_displacement: Fraction | None,
) -> Report:
    """Check a tree in space, or one in the plane that has all contacts and the load."""
    tree, edges = document["tree"], edges_of(document)
    plane = read_plane(tree)
    if plane is None:
        return _walk(tree, SpatialQuestion(grasp, wrench, edges, max_displacement))
    if edges:
        raise CertificateError("tree.plane is for round cones")
    try:
        question = IntegerQuestion(*in_plane(grasp, wrench, plane.axes), max_displacement)
    except GraspError as error:
        return Report("not resisted", f"tree.plane: {error}")
    if max_displacement is not None and not along_tangents(grasp, plane.axes):
        problem = "displacements along tangents that are at an angle to the plane are bounded"
        return Report("not resisted", f"tree.plane: {problem}")
    return _walk(plane.tree, question)


def _equilibrium_problem(
    document: Mapping[str, Any],
    grasp: Grasp,
    wrench: RationalVector,
    max_displacement: Fraction | None,
) -> str:
    """Return what is wrong with the equilibrium of a certificate, or nothing."""
    if "enclosure" in document:
        box = read_enclosure(document["enclosure"], len(grasp))
        return enclosure_problem(grasp, wrench, box, max_displacement)
    found = read_equilibrium(document, len(grasp), grasp.dimension)
    return equilibrium_problem(grasp, wrench, *found, edges_of(document), max_displacement)


def equilibrium_problem(
    grasp: Grasp,
    wrench: RationalVector,
    motion: RationalVector,
    forces: Sequence[RationalVector],
    edges: Sequence[RationalVector] = (),
    max_displacement: Fraction | None = None,
) -> str:
    """Return what is wrong with a motion and forces, normal ones first; empty if they are proof."""
    if problem := displacement_problem(grasp, motion, max_displacement):
        return problem
    return law_problem(grasp, wrench, motion, forces, edges)


def edges_of(document: Mapping[str, Any]) -> tuple[RationalVector, ...]:
    """Return the edges of friction pyramids, none for round cones."""
    return pyramid_edges(document["pyramid"]) if "pyramid" in document else ()


class _IntegerContact(NamedTuple):
    """A contact in integers, for work in units of 1 / `IntegerQuestion.unit`.

    ``spring . g`` and ``slip . g`` are positive multiples of e and s. In that unit kappa e is
    ``lambda . (normal -+ rubbing) spring . g``, and ``alpha e + h s`` is
    ``alpha per_e spring . g + h per_s slip . g``.
    """

    spring: IntegerVector
    slip: IntegerVector
    normal: IntegerVector
    rubbing: IntegerVector
    per_e: int
    per_s: int


class Generator(NamedTuple):
    """A generator of a region, with ``spring . g`` and ``slip . g`` of each contact."""

    vector: IntegerVector
    springs: IntegerVector
    slips: IntegerVector


class IntegerQuestion:
    """Grasp and wrench in integers."""

    dimension = 2

    def __init__(
        self, grasp: Grasp, wrench: RationalVector, max_displacement: Fraction | None = None
    ) -> None:
        self.max_displacement = max_displacement
        laws: list[tuple[RationalVector, ...]] = []
        self.frames = [frame(contact) for contact in grasp]
        for contact, (normal, tangent) in zip(grasp, self.frames, strict=True):
            spring = (contact.preload, *(-contact.stiffness * x for x in normal))
            rubbing = tuple(contact.friction * x for x in tangent)
            laws.append((spring, (Fraction(0), *tangent), (*normal, *rubbing)))
        scales = [tuple(map(_denominator, law)) for law in laws]
        self.unit = math.lcm(_denominator(wrench), *(math.lcm(e * f, s) for e, s, f in scales))
        self.wrench = _times(wrench, self.unit)
        self.contacts = []
        for (spring, slip, force), (e, s, _) in zip(laws, scales, strict=True):
            forces, per_e, per_s = _times(force, self.unit // e), self.unit // e, self.unit // s
            rows = _times(spring, e), _times(slip, s), forces[:3], forces[3:]
            self.contacts.append(_IntegerContact(*rows, per_e, per_s))

    def unit_vector(self, axis: int, sign: int) -> Generator:
        """Return e_axis or its negative."""
        rows = [contact.spring for contact in self.contacts], [c.slip for c in self.contacts]
        springs, slips = (tuple(sign * row[axis] for row in one) for one in rows)
        return Generator(tuple(sign * (j == axis) for j in range(4)), springs, slips)


class Place(NamedTuple):
    """Where a node stands: its region, and the states of the contacts decided there."""

    path: str
    depth: int
    region: Sequence[Generator]
    states: Mapping[int, State]


def _walk(tree: Any, question: IntegerQuestion | SpatialQuestion) -> Report:
    """Check all leaves. After the first that fails the rest is read, as its form may be wrong."""
    leaves, problem = 0, ""
    for leaf, place in placed_leaves(tree, question):
        leaves += 1
        if problem:
            continue
        if isinstance(question, IntegerQuestion):
            problem = _leaf_problem(question, leaf, place)
        else:
            problem = spatial_leaf_problem(question, leaf, place.states, place.path)
    return Report("not resisted", problem, leaves)


def placed_leaves(
    tree: Any, question: IntegerQuestion | SpatialQuestion
) -> Iterator[tuple[Leaf, Place]]:
    """Yield the leaves of a tree with their places, in the order of the document.

    Raises:
        CertificateError: what stands in a place is not a node, or a split that does not fit there.
    """
    region: list[Generator] = []
    if isinstance(question, IntegerQuestion):
        axes = [(0, 1), *product((1, 2, 3), (1, -1))]
        region = [question.unit_vector(*axis) for axis in axes]
    waiting = [(tree, Place("tree", 0, region, {}))]
    while waiting:
        content, place = waiting.pop()
        node = read_node(content, place.path, len(question.contacts), question.dimension)
        if isinstance(node, Split):
            waiting += reversed(_parts(node, place, getattr(question, "edges", ())))
        else:
            yield node, place


def _parts(
    split: Split, place: Place, edges: Sequence[RationalVector] = ()
) -> list[tuple[Any, Place]]:
    """Return the children of a node with their places; refuse a split that does not cover."""
    path, depth, region, states = place
    if depth == MAX_DEPTH:
        raise CertificateError(f"{path[:60]}...: more than {MAX_DEPTH} splits in a row")
    parts: list[tuple[Sequence[Generator], Mapping[int, State]]]
    if split.kind in ("directions", "faces"):
        parts = [(region, now) for _, now in split_states(split, states, path, edges)]
    elif split.kind in STATES:
        contact, due = split.at[0], "attached" if split.kind == "slip" else "undecided"
        if states.get(contact, "undecided") != due:
            raise CertificateError(f"{path}: contact {contact + 1} is not {due} here")
        parts = [(region, {**states, contact: name}) for name in STATES[split.kind]]
    elif (split.kind == "edge") != (len(region) == 4):
        raise CertificateError(f"{path}: orthants cut the half space, an edge one of their cones")
    elif split.kind == "edge":
        j, k, p, q = split.at
        middle = _between(p, region[j], q, region[k])
        parts = [([*region[:old], middle, *region[old + 1 :]], states) for old in (j, k)]
    else:
        corners = product(region[1:3], region[3:5], region[5:7])
        parts = [([region[0], *corner], states) for corner in corners]
    named = zip(split.children, parts, strict=True)
    return [(child, Place(name, depth + 1, *part)) for (name, child), part in named]


def _between(p: int, one: Generator, q: int, other: Generator) -> Generator:
    """Return ``p one + q other``, divided by the gcd of its entries."""
    pairs = zip(one, other, strict=True)
    sums = [[p * x + q * y for x, y in zip(*pair, strict=True)] for pair in pairs]
    common = math.gcd(*sums[0])
    return Generator(*(tuple(x // common for x in row) for row in sums))


def _leaf_problem(question: IntegerQuestion, leaf: Leaf, place: Place) -> str:
    """Return the inequality of a leaf that fails, or nothing."""
    scale = _denominator(leaf.motion)
    x, y, r = _times(leaf.motion, scale)
    load = sum(f * v for f, v in zip(question.wrench, (x, y, r), strict=True))
    problem, taken = displacement_work(question.max_displacement, leaf.displacements)
    if problem:
        return f"{place.path}: {problem}"
    unit = scale * question.unit
    ends = [generator.vector for generator in place.region]
    work = _outer_work(question, leaf, load, unit, taken, ends)
    springs = zip(*(generator.springs for generator in place.region), strict=True)
    slips = zip(*(generator.slips for generator in place.region), strict=True)
    for i, (contact, e, s) in enumerate(zip(question.contacts, springs, slips, strict=True)):
        state, given = place.states.get(i), leaf.multipliers.get(i)
        if given is None and (state == "detached" or (state is None and max(e) <= 0)):
            continue
        (n0, n1, n2), (t0, t1, t2) = contact.normal, contact.rubbing
        rub = x * t0 + y * t1 + r * t2
        free = state in (None, "attached")
        if state == "slip+" or (free and min(s) > 0):
            rub = -rub
        elif not (state == "slip-" or (free and max(s) < 0)):
            rub = -abs(rub)
        kappa = x * n0 + y * n1 + r * n2 + rub
        if given is not None:
            alpha, h = given[0] * scale * contact.per_e, given[1] * scale * contact.per_s
            if broken := _broken_bound(state, alpha, h, kappa):
                largest = short(Fraction(kappa, scale * contact.per_e))
                named = f"alpha = {short(given[0])}, h = {short(given[1])}, kappa = {largest}"
                return f"{place.path}: contact {i + 1}, {state or 'undecided'}: {named}: {broken}"
            work = [w + alpha * u + h * v for w, u, v in zip(work, e, s, strict=True)]
        elif state or min(e) >= 0:
            work = [w + kappa * u for w, u in zip(work, e, strict=True)]
        elif kappa < 0:
            work = [w + kappa * max(0, u) for w, u in zip(work, e, strict=True)]
    for total, vector in zip(work, ends, strict=True):
        if total < 0 or (total == 0 and vector[0]):
            at, found = ", ".join(map(short, vector)), Fraction(total) / unit
            due = f"{short(found)}, and must be {'above' if vector[0] else 'at least'} 0"
            return f"{place.path}: at generator ({at}) the work of load and contacts is {due}"
    return ""


def _outer_work(
    question: IntegerQuestion,
    leaf: Leaf,
    load: int,
    unit: int,
    taken: Fraction,
    ends: Sequence[IntegerVector],
) -> list[Any]:
    """Return the work of the load at the generators, with what bounded displacements take, give."""
    work: list[Any] = [load * g[0] for g in ends]
    if not leaf.displacements:
        return work
    total = [Fraction(0)] * 3
    for i, numbers in leaf.displacements.items():
        for number, row in zip(numbers, question.frames[i], strict=True):
            total = [x + number * y for x, y in zip(total, row, strict=True)]
    rows = ((-taken * g[0], *(x * y for x, y in zip(total, g[1:], strict=True))) for g in ends)
    return [w + unit * sum(row) for w, row in zip(work, rows, strict=True)]


def _broken_bound(state: Any, alpha: Fraction, h: Fraction, kappa: Fraction | int) -> str:
    """Return which bound of the multipliers of a contact is broken, or nothing."""
    if alpha < 0 and state in (None, "detached"):
        return "alpha must be at least 0"
    if alpha > kappa and state != "detached":
        return "alpha must be at most kappa"
    if (h > 0 and state not in ("stick", "slip-")) or (h < 0 and state not in ("stick", "slip+")):
        return "h has the wrong sign"
    return ""


def _denominator(row: RationalVector) -> int:
    return math.lcm(*(x.denominator for x in row))


def _times(row: RationalVector, scale: int) -> IntegerVector:
    return tuple(x.numerator * (scale // x.denominator) for x in row)
