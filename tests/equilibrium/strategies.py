"""Random grasps on a coarse grid, so that coincident planes and boundary wrenches are common."""

from __future__ import annotations

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
