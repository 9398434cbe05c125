"""Two fingers with friction: Nguyen's criterion, and what force closure does not give.

V.-D. Nguyen, Constructing force-closure grasps, International Journal of Robotics Research 7(3),
1988: two contacts with friction hold an object in the plane in force closure exactly when the line
between them lies strictly inside both friction cones. Force closure says that forces which balance
any load exist. That they arise, when nobody controls the fingers, is another matter.

Run time: about 2 seconds.
"""

from collections.abc import Sequence
from fractions import Fraction

from arrangement.numbers.exact import dot
from equilibrium import Contact, Grasp, solve
from equilibrium.methods.form_closure import form_closure
from proofs_check import claim


def by_program(grasp: Grasp) -> bool:
    """Force closure by an exact linear program on the edges of the cones."""
    return bool(form_closure(grasp, friction=True))


def by_cones(grasp: Grasp) -> bool:
    """The line between the contacts lies strictly inside both cones."""
    first, second = grasp
    line = [b - a for a, b in zip(first.point, second.point, strict=True)]
    back = [-x for x in line]
    ways = ((line, back), (back, line))  # squeezed from outside, or spread from inside
    return any(_inside(first, u) and _inside(second, v) for u, v in ways)


def _inside(contact: Contact, way: Sequence[Fraction]) -> bool:
    along, across = dot(way, contact.normal), dot(way, contact.tangent)
    return bool(abs(across) < contact.friction * along)


@claim(
    "Two contacts are in force closure exactly when the line between them lies strictly inside "
    "both friction cones.",
    of="grasp",
    planes=(2, 2),
    when=lambda grasp: len(grasp) == 2,
    hypotheses=["two contacts"],
    routes=[by_program, by_cones],
    samples=400,
    locator="Nguyen 1988",
)
def nguyen(_grasp: Grasp, _closed: bool) -> bool:
    """Both routes decide the same: there is nothing more to judge."""
    return True


@claim(
    "What two fingers hold in force closure resists a pull of 1 by itself.",
    of="grasp",
    planes=(2, 2),
    when=lambda grasp: len(grasp) == 2 and by_cones(grasp),
    hypotheses=["two contacts", "force closure"],
    samples=400,
    locator="said of force closure",
    expected="refuted",
)
def resists_by_itself(grasp: Grasp) -> bool | str:
    """Without preload no force arises until something moves."""
    return bool(solve(grasp, (0, 1, 0))) or "a pull of 1 is not resisted"
