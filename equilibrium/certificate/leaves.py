"""What the leaves of a proof say, in the plane and in space.

The rule is that of `equilibrium.certificate.leaf_rule`; this module reads trees that the checker
has accepted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.numbers.exact import IntegerVector, RationalVector, dot, vector_text
from equilibrium.model.grasp import Grasp
from equilibrium.model.solution import Leaf

from .checker import edges_of
from .contact_rule import SlipFace, State
from .law import applied, displacement_work, law_rows, rows_of
from .leaf_rule import TreeQuestion
from .reading import read_case, read_plane
from .tree import placed_leaves, slip_faces


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
        load: the work of the load and of all adhesion.
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
    _, case = read_case(document)
    for leaf, place in placed_leaves(document["tree"], TreeQuestion.of(case.subject, case.load)):
        yield ClosedPart(tuple(g.vector for g in place.region), place.states, leaf)


def works(
    grasp: Grasp,
    wrench: RationalVector,
    together: Sequence[ClosedPart],
    max_displacement: Fraction | None = None,
) -> Works:
    """Return the works on the virtual motion of one part, or of several that share it."""
    question = TreeQuestion.of(grasp, wrench, max_displacement=max_displacement)
    load = applied(law_rows(grasp), wrench)
    each = [_works(question, Fraction(dot(load, part.leaf.motion)), part) for part in together]
    factors = [
        min((factor for factor in candidates if factor is not None), default=None)
        for candidates in zip(*(done.factors for done in each), strict=True)
    ]
    return Works(each[0].load, factors, min(done.least for done in each))


def _works(question: TreeQuestion, load: Fraction, part: ClosedPart) -> Works:
    region = [question.generator(vector) for vector in part.region]
    work = question.leaf_work(part.leaf, region, part.states)
    pairs = zip(work.total, part.region, strict=True)
    least = min(Fraction(total) / (work.unit * g[0]) for total, g in pairs if g[0])
    factors = [pair and Fraction(pair[0]) / pair[1] for pair in work.factors]
    return Works(load, factors, least - load)


class SpatialLeaf(NamedTuple):
    """A leaf of a tree.

    Attributes:
        states: by contact, counted from 0, what is assumed of it, in words.
        motion: the virtual motion.
        least: contacts do at least that much work on it, whatever they do; ``sum alpha q``, less
            what bounds of the range take, with the work of all adhesion. The tree refutes a load w
            if ``motion . w + least > 0`` for all leaves.
    """

    states: Mapping[int, str]
    motion: RationalVector
    least: Fraction


def spatial_leaves(document: Mapping[str, Any]) -> Iterator[SpatialLeaf]:
    """Yield the leaves of a valid certificate in its order; none of a tree in the plane."""
    _, case = read_case(document)
    if read_plane(document["tree"]):
        return
    rows, bound = rows_of(case.subject), case.max_displacement
    pull = applied(rows, (Fraction(0),) * len(case.load))
    question = TreeQuestion.of(case.subject, case.load, edges_of(case), bound)
    for leaf, place in placed_leaves(document["tree"], question):
        works = (row[0] * rows[i].preload for i, row in leaf.multipliers.items())
        _, taken = displacement_work(question.max_displacement, leaf.displacements)
        states = {i: _words(state, question.edges) for i, state in place.states.items()}
        least = sum(works, Fraction(dot(pull, leaf.motion)) - taken)
        yield SpatialLeaf(states, leaf.motion, least)


def _words(state: State, edges: Sequence[RationalVector]) -> str:
    """Return the state of a contact in space in words."""
    if isinstance(state, SlipFace):
        return f"slips (part {slip_faces(edges).index(state) + 1})"
    if isinstance(state, tuple):
        return "slips between {} and {}".format(*map(vector_text, state))
    return "sticks" if state == "stick" else state
