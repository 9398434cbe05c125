"""Random small grasps for the tests of resisted wrenches, and what keeps their answers."""

from fractions import Fraction

from hypothesis import strategies as st

from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

UNITS = [(1, 0), (0, 1), (-1, 0), (0, -1)] + [
    (Fraction(a, 5), Fraction(b, 5)) for a in (3, -3) for b in (4, -4)
]
small = st.integers(-2, 2)
preloads = st.integers(0, 2)
wrenches = st.tuples(small, small, small)
directions = wrenches.filter(any)
frictions = st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(1, 2), Fraction(1)])


def contacts(preload=preloads):
    return st.builds(
        Contact,
        st.tuples(small, small),
        st.sampled_from(UNITS),
        frictions,
        st.integers(1, 2),
        preload,
    )


def grasps(least=1, most=3, preload=preloads):
    return st.lists(contacts(preload), min_size=least, max_size=most).map(Grasp)


def rotated(grasp, cosine, sine):
    """The grasp in a frame turned by an angle."""

    def turn(v):
        return (cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1])

    return Grasp(
        Contact(turn(c.point), turn(c.normal), c.friction, c.stiffness, c.preload) for c in grasp
    )


def reloaded(grasp, factor):
    """The grasp with all preloads times a factor."""
    return Grasp(
        Contact(c.point, c.normal, c.friction, c.stiffness, factor * c.preload) for c in grasp
    )
