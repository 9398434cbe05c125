"""Brute force for round cones: all states of contacts, slips in ever narrower sectors, in floats.

Shares no code with the package: contacts are numbers, and conic programs have their own rows. Each
choice of states (apart, stuck, slipping in a sector) is relaxed: the friction of a slip lies on the
inner side of the chord of its sector. The least force that is left over, over all choices, is
bounded from below by these programs and tends to the truth as sectors narrow. Choices that leave
something over are dropped, the others are cut in two.
"""

import itertools
import math

import clarabel
import numpy as np
from scipy.sparse import csc_matrix

#: Sectors at first, and the number of times that each is cut in two.
SECTORS, CUTS = 3, 9
#: Forces of this share of the load and preloads are none.
NOTHING = 1e-6


class Contact:
    """A contact in floats: rows of normal and slip over motions, friction, stiffness, preload."""

    def __init__(self, point, normal, tangent, friction, stiffness, preload):
        r, n, t = (np.array([float(x) for x in v]) for v in (point, normal, tangent))
        axes = (n, t, np.cross(n, t))
        self.normal, *slip = (np.concatenate([axis, np.cross(r, axis)]) for axis in axes)
        self.slip = np.array(slip)
        self.friction, self.stiffness, self.preload = map(float, (friction, stiffness, preload))


def least_left_over(contacts, load, states):
    """Return the least sum of forces and torques that states leave over."""
    m = len(contacts)
    size = 6 + 3 * m + 6
    equal, plus, cones = [], [], []

    def row(motion=None, i=0, force=(0, 0, 0), constant=0.0):
        found = np.zeros(size + 1)
        if motion is not None:
            found[:6] = motion
        found[6 + 3 * i : 9 + 3 * i], found[-1] = force, constant
        return found

    balance = np.zeros((6, size + 1))
    for i, (contact, state) in enumerate(zip(contacts, states, strict=True)):
        balance[:, 6 + 3 * i : 9 + 3 * i] = np.array([contact.normal, *contact.slip]).T
        spring = -contact.stiffness * contact.normal
        if state == "apart":
            plus.append(row(-spring, constant=-contact.preload))
            equal += [row(i=i, force=force) for force in np.eye(3)]
            continue
        equal.append(row(-spring, i, (1, 0, 0), -contact.preload))
        # (mu c_n, c_t) in the round cone.
        cones.append([row(i=i, force=f) for f in ((contact.friction, 0, 0), *np.eye(3)[1:])])
        if state == "stuck":
            equal += [row(slip) for slip in contact.slip]
        elif state != "any":
            start, end = state
            for angle, side in ((start, 1), (end, -1)):
                left = side * np.array([-math.sin(angle), math.cos(angle)])
                plus.append(row(left @ contact.slip))
            middle = np.array([math.cos((start + end) / 2), math.sin((start + end) / 2)])
            chord = contact.friction * math.cos((end - start) / 2)
            plus.append(row(i=i, force=(-chord, *-middle)))
    balance[:, -1] = load
    # What is left over is between -rest and rest.
    rest = np.zeros((6, size + 1))
    rest[:, -7:-1] = np.eye(6)
    plus += [*(rest - balance), *(rest + balance)]
    blocks = [*equal, *plus, *itertools.chain(*cones)]
    matrix = np.array(blocks)
    kinds = [clarabel.ZeroConeT(len(equal))] if equal else []
    kinds.append(clarabel.NonnegativeConeT(len(plus)))
    kinds += [clarabel.SecondOrderConeT(3)] * len(cones)
    cost = np.zeros(size)
    cost[-6:] = 1.0
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    program = csc_matrix((size, size)), cost, csc_matrix(-matrix[:, :-1]), matrix[:, -1]
    found = clarabel.DefaultSolver(*program, kinds, settings).solve()
    return found.obj_val if "Solved" in str(found.status) else 0.0


def resisted(grasp, load):
    """Return whether narrow sectors leave nothing over."""
    values = ("point", "normal", "tangent", "friction", "stiffness", "preload")
    contacts = [Contact(*(getattr(c, name) for name in values)) for c in grasp]
    load = np.array([float(w) for w in load])
    size = np.abs(load).max() + sum(contact.preload for contact in contacts)
    turn = 2 * math.pi / SECTORS
    sectors = [(k * turn, (k + 1) * turn) for k in range(SECTORS)]
    waiting = []
    for states in itertools.product(("apart", "stuck", *sectors), repeat=len(contacts)):
        waiting.append((0, states))
    while waiting:
        cuts, states = waiting.pop()
        if least_left_over(contacts, load, states) > NOTHING * size:
            continue
        slips = [state for state in states if isinstance(state, tuple)]
        if cuts == CUTS or not slips:
            return True
        halves = [
            [(s[0], (s[0] + s[1]) / 2), ((s[0] + s[1]) / 2, s[1])] if isinstance(s, tuple) else [s]
            for s in states
        ]
        waiting += [(cuts + 1, parts) for parts in itertools.product(*halves)]
    return False
