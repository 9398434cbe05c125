"""A bound of Grünbaum on simple arrangements of lines, and a wish that is too good.

m lines of the projective plane are m great circles, and a triangle of lines is two of them, one
opposite the other. B. Grünbaum, Arrangements and Spreads, 1972: m >= 4 lines in general position
have at most m(m-1)/3 triangles, for no two triangles share a side. J.-P. Roudneff, Discrete
Mathematics 60, 1986, on when this is reached: it is by 4, 6, 10 lines and by others.

Run time: about 2 seconds.
"""

from itertools import combinations, product

from arrangement import Arrangement
from arrangement.duals.zonohedron import dual_polyhedron
from arrangement.numbers.exact import dot
from arrangement.numbers.linear.rank import cross
from proofs_check import claim


def by_dual(planes: Arrangement) -> int:
    """Triangles are vertices of degree 3 of the dual polyhedron."""
    return sum(degree == 3 for _, degree in dual_polyhedron(planes).graph().degree)


def by_determinants(planes: Arrangement) -> int:
    """Octants of three planes that no other plane cuts, by signs of determinants."""
    rows = [plane[:3] for plane in planes.integer_planes]
    count = 0
    for chosen in combinations(range(len(rows)), 3):
        a, b, c = (rows[i] for i in chosen)
        others = [row for i, row in enumerate(rows) if i not in chosen]
        corners = (cross(b, c), cross(c, a), cross(a, b))
        for signs in product((1, -1), repeat=3):
            sides = [
                {s * dot(row, v) > 0 for s, v in zip(signs, corners, strict=True)} for row in others
            ]
            count += all(len(side) == 1 for side in sides)
    return count


@claim(
    "m >= 4 lines of the projective plane in general position have at most m(m-1)/3 triangles.",
    formula=r"p_3 \le \frac{m(m-1)}{3}",
    of="simple",
    when=lambda planes: len(planes) >= 4,
    hypotheses=["m >= 4", "general position"],
    routes=[by_dual, by_determinants],
    classes=7,
    planes=(4, 8),
    samples=40,
    locator="Grünbaum 1972",
)
def most_triangles(planes: Arrangement, triangles: int) -> bool:
    """Each triangle of lines is two of great circles."""
    m = len(planes)
    return 3 * triangles <= 2 * m * (m - 1)


@claim(
    "The bound is reached by every arrangement of six lines in general position.",
    of="simple",
    when=lambda planes: len(planes) == 6,
    hypotheses=["m = 6", "general position"],
    routes=[by_dual, by_determinants],
    samples=0,
    locator="a conjecture",
    expected="refuted",
)
def always_reached(planes: Arrangement, triangles: int) -> bool:
    """Only one of the four isomorphism classes of six lines has ten triangles."""
    return triangles == 20
