"""Measurements on random grasps in space in one process: ``spacejob.py JOB CONTACTS SEED...``.

Prints one JSON line for each seed. The clock counts CPU time; a smaller grasp goes first.

With the name of a kind of `tests/equilibrium/rare.py` in place of the number of contacts the
questions are those of that kind.

The instances. Seeds below 1000 are those of the page on accuracy: any wrench. With 1000 added the
wrench is what contact forces of random sizes inside their cones balance, times 1 to 2: near the
boundary on both sides. Odd seeds have preload.

The peers answer in floats and without proof:

* `boxed`: the mixed-integer program of GraspIt's later solver (`GraspSolver`) with eight friction
  edges, as published: coordinates of the motion within 5, force amplitudes within 200. Friction and
  opposite slip are combinations of the same two neighbouring edges, and a contact that slips has
  its friction on the side of the polygon between them. The bound of 2500 is one of joint torques,
  of which fixed fingers have none. `boxed_fine` has 32 edges; the paper refines edges where needed.
* `cones`: a program of second-order cones (Clarabel): forces inside the round cones balance the
  load; no springs, no dissipation.
"""

import json
import math
import sys
import time
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import clarabel
import numpy as np
from milp import Rows, solved
from scipy.sparse import csc_matrix

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from equilibrium import Grasp
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from tests.equilibrium import degenerate, rare

Wrench = tuple[Fraction, ...]
Found = dict[str, Any]
NEAR = 1000
MOTION, FORCE, EDGES, FINE = 5.0, 200.0, 8, 32
#: Seconds by the clock for one program, and for one verdict of ours.
PEER_SECONDS, SECONDS = 60, 60


def instance(contacts: int | str, seed: int) -> tuple[Grasp, Wrench]:
    """Return the grasp and the wrench of a seed."""
    if isinstance(contacts, str):
        return rare.question(contacts, seed)
    plain = seed % NEAR
    grasp = random_grasp(contacts, plain, dimension=3)
    if seed < NEAR:
        return grasp, random_wrench(plain, dimension=3, bound=1)
    source, total = Random(f"near {contacts} {plain}"), (Fraction(0),) * 6
    for contact in grasp:
        normal = Fraction(source.randint(0, 32), 16)
        limit = int(32 * contact.friction * normal)
        friction = (Fraction(source.randint(-limit, limit), 45) for _ in range(2))
        total = degenerate.less(total, contact, normal, *friction)
    size = Fraction(source.randint(64, 128), 64)
    return grasp, tuple(Fraction(round(64 * size * x), 64) for x in total)


def ours(grasp: Grasp, wrench: Wrench) -> Found:
    """Verdict and proof; the check of the proof."""
    start = time.process_time()
    verdict = solve(grasp, wrench, time_limit=SECONDS)
    written = time.process_time()
    found = {"verdict": verdict.verdict, "seconds": written - start}
    if not verdict.decided:
        return {**found, "reason": verdict.reason}
    begin = time.process_time()
    report = verdict.verify()
    found |= {"check": time.process_time() - begin, "valid": bool(report), "leaves": report.leaves}
    return {**found, "bytes": len(verdict.certificate.text)}


def boxed(grasp: Grasp, wrench: Wrench, edges: int = EDGES) -> Found:
    """The mixed-integer program."""
    angles = 2 * math.pi * np.arange(edges) / edges
    along = np.array([np.cos(angles), np.sin(angles)])
    # A contact: normal force, friction and slip along edges, breaks, sticks, which two edges.
    part = 1 + 2 * edges + 2 + edges
    size = 6 + part * len(grasp)
    rows, low, high = Rows(), np.zeros(size), np.ones(size)
    low[:6], high[:6] = -MOTION, MOTION
    whole = np.zeros(size)
    balance: list[list[tuple[int, float]]] = [[] for _ in range(6)]
    for i, contact in enumerate(grasp):
        n = 6 + part * i
        force, slip = range(n + 1, n + 1 + edges), range(n + 1 + edges, n + 1 + 2 * edges)
        breaks, sticks, pair = n + 1 + 2 * edges, n + 2 + 2 * edges, n + 3 + 2 * edges
        high[n : n + 1 + edges] = FORCE
        high[n + 1 + edges : breaks] = math.inf
        whole[breaks : n + part] = 1
        normal = np.array([float(x) for x in contact.normal_wrench])
        tangents = np.array([[float(x) for x in row] for row in contact.tangential_wrenches])
        mu, q = float(contact.friction), float(contact.preload)
        gap = float(contact.stiffness) * normal
        furthest = MOTION * float(np.abs(tangents).sum())
        pulls = tangents.T @ along
        for axis in range(6):
            balance[axis].append((n, normal[axis]))
            balance[axis] += [(v, pulls[axis, j]) for j, v in enumerate(force)]
        spring = [*enumerate(gap), (n, 1.0)]
        rows.add(spring, low=q)
        rows.add([*spring, (breaks, -q - MOTION * float(np.abs(gap).sum()))], high=q)
        rows.add([(n, 1.0), (breaks, FORCE)], high=FORCE)
        # Slip is opposite to what the amplitudes add up to.
        for k in range(2):
            moved = [*enumerate(tangents[k]), *((v, along[k, j]) for j, v in enumerate(slip))]
            rows.add(moved, 0, 0)
        sums = [(v, 1.0) for v in force]
        rows.add([*sums, (n, -mu)], high=0)
        rows.add([*sums, (n, -mu), (sticks, mu * FORCE)], low=0)
        rows.add([*((v, 1.0) for v in slip), (sticks, 2 * furthest)], high=2 * furthest)
        rows.add([(pair + j, 1.0) for j in range(edges)], 1, 1)
        for j in range(edges):
            ends = [(pair + j, -1.0), (pair + (j - 1) % edges, -1.0)]
            for v, most in ((force[j], FORCE), (slip[j], 2 * furthest)):
                rows.add([(v, 1.0), *((place, x * most) for place, x in ends)], high=0)
    for terms, load in zip(balance, wrench, strict=True):
        rows.add(terms, -float(load), -float(load))
    found, seconds = solved(rows, low, high, whole, PEER_SECONDS)
    names = {0: "resisted", 1: "no answer in time", 2: "not resisted"}
    return {"verdict": names.get(found.status, str(found.message)), "seconds": seconds}


def boxed_fine(grasp: Grasp, wrench: Wrench) -> Found:
    """The same with more edges."""
    return boxed(grasp, wrench, FINE)


def cones(grasp: Grasp, wrench: Wrench) -> Found:
    """Forces inside the cones that balance, if there are any; no springs."""
    start = time.process_time()
    n = 3 * len(grasp)
    columns = [
        [float(x) for x in r] for c in grasp for r in (c.normal_wrench, *c.tangential_wrenches)
    ]
    scale = -np.array([x for c in grasp for x in (float(c.friction), 1.0, 1.0)])
    matrix = csc_matrix(np.concatenate([np.array(columns).T, np.diag(scale)]))
    right = np.array([*(-float(w) for w in wrench), *[0.0] * n])
    settings = clarabel.DefaultSettings()
    settings.verbose = False
    kinds = [clarabel.ZeroConeT(6), *[clarabel.SecondOrderConeT(3)] * len(grasp)]
    program = csc_matrix((n, n)), np.zeros(n), matrix, right, kinds, settings
    status = str(clarabel.DefaultSolver(*program).solve().status)
    names = {"Solved": "resisted", "PrimalInfeasible": "not resisted"}
    return {"verdict": names.get(status, status), "seconds": time.process_time() - start}


JOBS = {job.__name__: job for job in (ours, boxed, boxed_fine, cones)}

if __name__ == "__main__":
    name, given, *seeds = sys.argv[1:]
    contacts = int(given) if given.isdigit() else given
    for warm in (0, 1):
        JOBS[name](*instance(2, 500 + warm))
    for seed in map(int, seeds):
        found = JOBS[name](*instance(contacts, seed))
        print(json.dumps({"contacts": contacts, "seed": seed, **found}), flush=True)
