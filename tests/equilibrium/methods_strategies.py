"""Small random grasps for the tests of the other methods: few contacts, small numbers."""

from fractions import Fraction

from hypothesis import strategies as st

from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp

NORMALS = [(1, 0), (-1, 0), (0, 1), (0, -1), ("3/5", "4/5"), ("-4/5", "3/5"), ("5/13", "-12/13")]

small = st.integers(-2, 2)
preloads = st.integers(0, 2)
wrenches = st.tuples(small, small, small)
frictions = st.sampled_from([Fraction(0), Fraction(1, 2), Fraction(1), Fraction(2)])


def contacts(friction=frictions, preload=preloads):
    return st.builds(
        Contact,
        point=st.tuples(small, small),
        normal=st.sampled_from(NORMALS),
        friction=friction,
        stiffness=st.sampled_from([Fraction(1), Fraction(2), Fraction(1, 3)]),
        preload=preload,
    )


def grasps(most=4, **options):
    return st.lists(contacts(**options), min_size=1, max_size=most).map(Grasp)


def turned(grasp):
    """Return the grasp after a rigid motion with cosine 3/5, and the map of wrenches."""
    c, s, a, b = Fraction(3, 5), Fraction(4, 5), Fraction(2), Fraction(-1)

    def turn(v):
        return (c * v[0] - s * v[1], s * v[0] + c * v[1])

    moved = []
    for contact in grasp:
        x, y = turn(contact.point)
        moved.append(
            Contact(
                (x + a, y + b),
                turn(contact.normal),
                contact.friction,
                contact.stiffness,
                contact.preload,
            )
        )

    def wrench(w):
        x, y = turn(w[:2])
        return (x, y, w[2] + a * y - b * x)

    return Grasp(moved), wrench
