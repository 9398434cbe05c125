"""What the leaves of a proof say, in the plane and in space.

The rule is that of `equilibrium.certificate.plane`; this module reads trees that the checker has
accepted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, vector_text
from equilibrium.model.grasp import Grasp

from .checker import edges_of, placed_leaves
from .law import displacement_work, frame
from .plane import PlanarQuestion, has_no_force, least_work, work_factor
from .reading import Leaf, read_bound, read_plane, read_question
from .space import SlipFace, SpatialQuestion, State, slip_faces


class ClosedPart(NamedTuple):
    """A part of the motions, closed by a leaf.

    Attributes:
        region: generators of its cone: four, or the seven of the half space.
        states: those of the contacts that are decided there.
    """

    region: tuple[IntegerVector, ...]
    states: Mapping[int, Any]
    leaf: Leaf


class Works(NamedTuple):
    """What is done on the virtual motion of parts.

    Attributes:
        load: the work of the load.
        factors: for each contact its least work, as a factor of its normal force; None where it has
            no force.
        least: all contacts and bounded displacements work at least that much;
            ``load + least > 0``.
    """

    load: Fraction
    factors: list[Fraction | None]
    least: Fraction


def parts(document: Mapping[str, Any]) -> Iterator[ClosedPart]:
    """Yield the parts of a valid certificate "not resisted", in the order of the document."""
    _, grasp, wrench = read_question(document)
    for leaf, place in placed_leaves(document["tree"], PlanarQuestion(grasp, wrench)):
        yield ClosedPart(tuple(g.vector for g in place.region), place.states, leaf)


def works(
    grasp: Grasp,
    wrench: RationalVector,
    together: Sequence[ClosedPart],
    max_displacement: Fraction | None = None,
) -> Works:
    """Return the works on the virtual motion of one part, or of several that share it."""
    each = [_works(grasp, wrench, part, max_displacement) for part in together]
    factors = [
        min((factor for factor in some if factor is not None), default=None)
        for some in zip(*(done.factors for done in each), strict=True)
    ]
    return Works(each[0].load, factors, min(done.least for done in each))


def _works(
    grasp: Grasp, wrench: RationalVector, part: ClosedPart, max_displacement: Fraction | None
) -> Works:
    region, states, leaf = part
    load, factors = Fraction(dot(wrench, leaf.motion)), []
    _, taken = displacement_work(max_displacement, leaf.displacements)
    work = [(load - taken) * g[0] for g in region]
    for i, contact in enumerate(grasp):
        normal, tangent = frame(contact)
        e = [contact.preload * g[0] - contact.stiffness * dot(normal, g[1:]) for g in region]
        s = [dot(tangent, g[1:]) for g in region]
        state, idle = states.get(i), has_no_force(states.get(i), e)
        a, mu_b = dot(leaf.motion, normal), contact.friction * dot(leaf.motion, tangent)
        kappa = work_factor(a, mu_b, state, s)
        factors.append(None if idle else Fraction(kappa))
        for x, moved in zip(leaf.displacements.get(i, ()), (normal, tangent), strict=False):
            work = [w + x * dot(moved, g[1:]) for w, g in zip(work, region, strict=True)]
        if i in leaf.multipliers:
            alpha, h = leaf.multipliers[i]
            row = [alpha * x + h * y for x, y in zip(e, s, strict=True)]
        elif not idle:
            row = least_work(kappa, state, e)
        else:
            continue
        work = [w + x for w, x in zip(work, row, strict=True)]
    least = min(w / g[0] for w, g in zip(work, region, strict=True) if g[0]) - load
    return Works(load, factors, least)


class SpatialLeaf(NamedTuple):
    """A leaf of a tree.

    Attributes:
        states: by contact, counted from 0, what is assumed of it, in words.
        motion: the virtual motion.
        least: contacts do at least that much work on it, whatever they do; ``sum alpha q``, less
            what bounds of the range take. The tree refutes a load w if ``motion . w + least > 0``
            for all leaves.
    """

    states: Mapping[int, str]
    motion: RationalVector
    least: Fraction


def spatial_leaves(document: Mapping[str, Any]) -> Iterator[SpatialLeaf]:
    """Yield the leaves of a valid certificate in its order; none of a tree in the plane."""
    _, grasp, wrench = read_question(document)
    if read_plane(document["tree"]):
        return
    question = SpatialQuestion(grasp, wrench, edges_of(document), read_bound(document))
    for leaf, place in placed_leaves(document["tree"], question):
        works = (row[0] * grasp.contacts[i].preload for i, row in leaf.multipliers.items())
        _, taken = displacement_work(question.max_displacement, leaf.displacements)
        states = {i: _words(state, question.edges) for i, state in place.states.items()}
        yield SpatialLeaf(states, leaf.motion, sum(works, -taken))


def _words(state: State, edges: Sequence[RationalVector]) -> str:
    """Return the state of a contact in space in words."""
    if isinstance(state, SlipFace):
        return f"slips (part {slip_faces(edges).index(state) + 1})"
    if isinstance(state, tuple):
        return "slips between {} and {}".format(*map(vector_text, state))
    return "sticks" if state == "stick" else state
