"""A conjecture that small cases suggest, and that is wrong.

Great circles in general position cut the sphere into regions. With four circles 8 of them are
triangles, with five circles 10, whatever the circles. So are there always twice as many triangles
as circles? Run::

    proofs-check run triangles.py

In the dual polyhedron the regions are the vertices, and a triangle is a vertex of degree 3.
"""

from arrangement.duals.zonohedron import DualPolyhedron
from proofs_check import claim


def triangles(dual: DualPolyhedron) -> int:
    """Return the number of regions with three sides."""
    return sum(degree == 3 for _, degree in dual.graph().degree)


@claim(
    "Four or more great circles in general position have twice as many triangles as circles.",
    of="dual",
    when=lambda dual: len(dual.arrangement) >= 4 and dual.arrangement.is_simple,
    hypotheses=["at least four planes", "general position"],
    classes=7,
    planes=(4, 7),
    samples=20,
    expected="refuted",
)
def twice_as_many_triangles(dual: DualPolyhedron) -> bool | str:
    """Compare the number of triangles with twice the number of circles."""
    m, count = len(dual.arrangement), triangles(dual)
    return count == 2 * m or f"{count} triangles, not {2 * m}"


@claim(
    "Great circles in general position have at least twice as many triangles as circles.",
    of="dual",
    when=lambda dual: dual.arrangement.is_simple,
    hypotheses=["general position"],
    classes=7,
    samples=20,
    locator="F. Levi, 1926",
)
def at_least_twice_as_many_triangles(dual: DualPolyhedron) -> bool | str:
    """Compare the number of triangles with twice the number of circles."""
    m, count = len(dual.arrangement), triangles(dual)
    return count >= 2 * m or f"{count} triangles, fewer than {2 * m}"
