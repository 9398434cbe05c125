"""Random small grasps, and an oracle for resisted magnitudes: all 4^m states, full systems."""

from fractions import Fraction
from itertools import product

from hypothesis import strategies as st

from arrangement import linprog
from equilibrium.model.grasp import Contact, Grasp

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


def brute_intervals(grasp, direction, base=(0, 0, 0)):
    """The magnitudes each of the 4^m choices of states allows; by the equations, unreduced.

    Variables: d (3), then c_n and c_t of each contact, then t.
    """
    found = []
    for states in product(("detached", "slip+", "slip-", "stick"), repeat=len(grasp)):
        interval = _extent(*_rows(grasp, states, direction, base), 4 + 2 * len(grasp))
        if interval is not None:
            found.append(interval)
    return found


def _rows(grasp, states, direction, base):
    n = 4 + 2 * len(grasp)

    def row(entries, constant=0):
        out = [Fraction(0)] * n + [Fraction(constant)]
        for column, x in entries:
            out[column] += x
        return out

    equalities = []
    for axis in range(3):
        entries = [(n - 1, direction[axis])]
        for i, c in enumerate(grasp):
            entries += [(3 + 2 * i, c.normal_wrench[axis]), (4 + 2 * i, c.tangential_wrench[axis])]
        equalities.append(row(entries, base[axis]))
    inequalities = [row([(n - 1, 1)])]
    for i, (c, state) in enumerate(zip(grasp, states, strict=True)):
        c_n, c_t = 3 + 2 * i, 4 + 2 * i
        spring = [(j, c.stiffness * x) for j, x in enumerate(c.normal_wrench)]
        slip = list(enumerate(c.tangential_wrench))
        if state == "detached":
            equalities += [row([(c_n, 1)]), row([(c_t, 1)])]
            inequalities.append(row(spring, -c.preload))
            continue
        equalities.append(row([*spring, (c_n, 1)], -c.preload))
        inequalities.append(row([(c_n, 1)]))
        if state == "stick":
            equalities.append(row(slip))
            inequalities += [row([(c_n, c.friction), (c_t, s)]) for s in (1, -1)]
        else:
            s = 1 if state == "slip+" else -1
            inequalities.append(row([(j, s * x) for j, x in slip]))
            equalities.append(row([(c_t, 1), (c_n, s * c.friction)]))
    return inequalities, equalities


def _extent(inequalities, equalities, n):
    objective = [0] * (n - 1) + [1]
    least = linprog.minimize(objective, inequalities, equalities)
    if isinstance(least, linprog.Infeasible):
        return None
    largest = linprog.minimize([-x for x in objective], inequalities, equalities)
    return least.value, None if isinstance(largest, linprog.Unbounded) else -largest.value


def merged(intervals):
    """The union of closed intervals [a, b] with a given; b None means no end."""
    out = []
    for low, high in sorted(intervals, key=lambda part: part[0]):
        if out and (out[-1][1] is None or low <= out[-1][1]):
            if out[-1][1] is not None and (high is None or high > out[-1][1]):
                out[-1] = (out[-1][0], high)
        else:
            out.append((low, high))
    return tuple(out)


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
