"""Random grasps on a coarse grid, so that coincident planes and boundary wrenches are common."""

from dataclasses import replace
from fractions import Fraction

from hypothesis import strategies as st

from equilibrium import Contact, Grasp

NORMALS = [(1, 0), (0, 1), (-1, 0), (0, -1), (Fraction(3, 5), Fraction(4, 5))]

contacts = st.builds(
    Contact,
    st.tuples(st.integers(-1, 1), st.integers(-1, 1)),
    st.sampled_from(NORMALS),
    st.sampled_from([0, Fraction(1, 2), 1]),
    st.sampled_from([1, 2]),
    st.sampled_from([0, 0, 1]),
)
wrenches = st.tuples(*[st.sampled_from([-2, -1, Fraction(-1, 2), 0, Fraction(1, 2), 1, 2])] * 3)


def grasps(max_contacts: int = 3, least: int = 0) -> st.SearchStrategy[Grasp]:
    return st.builds(Grasp, st.lists(contacts, min_size=least, max_size=max_contacts))


#: A wider grid: oblique normals, more sizes of friction, stiffness and preload.
OBLIQUE = [*NORMALS[:4], *((Fraction(a, 5), Fraction(b, 5)) for a in (3, -3) for b in (4, -4))]
OBLIQUE += [(Fraction(5, 13), Fraction(-12, 13))]
small = st.integers(-2, 2)
loads = st.tuples(small, small, small)
directions = loads.filter(any)
frictions = st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(1), Fraction(2)])
preloads = st.integers(0, 2)


def wide_grasps(least=1, most=3, friction=frictions, preload=preloads):
    one = st.builds(
        Contact,
        st.tuples(small, small),
        st.sampled_from(OBLIQUE),
        friction,
        st.sampled_from([1, 2, Fraction(1, 3)]),
        preload,
    )
    return st.lists(one, min_size=least, max_size=most).map(Grasp)


@st.composite
def resisted(draw, of=None):
    """Grasps, and wrenches for which a drawn motion and its contact forces obey the law."""
    grasp = draw(grasps(3, least=1) if of is None else of)
    motion = draw(st.tuples(*[st.fractions(-2, 2, max_denominator=2)] * 3))
    wrench = [Fraction(0)] * 3
    for c in grasp:
        closing, slip = (
            -sum(x * y for x, y in zip(w, motion, strict=True))
            for w in (c.normal_wrench, c.tangential_wrench)
        )
        n = max(Fraction(0), c.preload + c.stiffness * closing)
        share = (slip > 0) - (slip < 0) or draw(st.sampled_from([-1, 0, Fraction(1, 2)]))
        t = c.friction * n * share
        for k in range(3):
            wrench[k] -= n * c.normal_wrench[k] + t * c.tangential_wrench[k]
    return grasp, tuple(wrench)


ROTATIONS = [(1, 0), (0, 1), (Fraction(3, 5), Fraction(4, 5)), (Fraction(-5, 13), Fraction(12, 13))]


@st.composite
def form_closures(draw, friction=frictions, preload=preloads):
    """Grasps in form closure: four sides of a box, whose pairs turn it in opposite senses."""
    low, high = (st.tuples(st.integers(-2, 0), st.integers(-2, 0)), st.integers(1, 2))
    (a, b), c, d = draw(low), draw(high), draw(high)
    places = [((-2, a), (1, 0)), ((b, -2), (0, 1)), ((2, c), (-1, 0)), ((d, 2), (0, -1))]
    change, *_ = turned(*draw(st.sampled_from(ROTATIONS)), draw(small), draw(small))
    mirrored = draw(st.booleans())
    one = st.tuples(friction, st.sampled_from([1, 2, Fraction(1, 3)]), preload)
    return Grasp(
        change(Contact(*([(-x, y) for x, y in place] if mirrored else place), *draw(one)))
        for place in draw(st.permutations(places))
    )


@st.composite
def pinches(draw):
    """Grasps by two contacts that face each other: they balance each wrench, if they press."""
    change, *_ = turned(*draw(st.sampled_from(ROTATIONS)), draw(small), draw(small))
    frictions = st.sampled_from([Fraction(1, 3), Fraction(1, 2), Fraction(1)])
    pinch = [Contact((side, 0), (-side, 0), draw(frictions)) for side in (-1, 1)]
    return Grasp(change(c) for c in pinch)


def turned(cosine, sine, a=0, b=0):
    """Changes of contacts, wrenches, motions and forces when the frame is turned and moved."""

    def turn(v):
        return (cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1])

    def contact(c):
        x, y = turn(c.point)
        return replace(c, point=(x + a, y + b), normal=turn(c.normal))

    def wrench(w):
        x, y = turn(w[:2])
        return (x, y, w[2] + a * y - b * x)

    def motion(d):
        x, y = turn(d[:2])
        return (x + d[2] * b, y - d[2] * a, d[2])

    return contact, wrench, motion, tuple
