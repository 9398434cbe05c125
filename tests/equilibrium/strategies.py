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


def grasps(max_contacts: int = 3) -> st.SearchStrategy[Grasp]:
    return st.builds(Grasp, st.lists(contacts, max_size=max_contacts))


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
