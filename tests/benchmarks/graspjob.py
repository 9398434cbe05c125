"""Measurements on random grasps in one process: ``python graspjob.py JOB CONTACTS SEED...``.

Prints one JSON line for each seed as soon as it is known, so that whoever stops the process keeps
what is done. The clock counts CPU time. Modules are loaded and warm before it starts (a
smaller grasp goes first), but nothing is known of the grasp that is measured.

The instances. Odd seeds have preload. By the seed modulo 8: 0, 1, 4, 5 have contacts all around the
object, as `random_grasp` makes them; those resist nearly every wrench. The others have them on one
third of the way round only, so that many wrenches are not resisted: 2, 3 take any wrench, 6, 7 one
that pulls the object away from the contacts. So many contacts jam with any load when there are a
hundred; with 1000 added to the seed they form ten patches of equal contacts side by side instead,
which share spring and preload of one. With 2000 added the wrench lies just beyond the border: at
most 1/64 of the way from a push against the patches to the wrench of the seed. The entries of the
exact unit normals have denominators up to 2 * 10^7, and the planes in whole numbers entries of up
to 10 digits.
"""

import json
import re
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from equilibrium import Contact, Grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.decide.solver import Solver
from equilibrium.grasps.inputs.random import random_grasp, random_wrench

Wrench = tuple[Fraction, ...]
Found = dict[str, Any]
#: Added to seeds: contacts in so many patches; a wrench near the boundary as well.
PATCHES, BORDER, NUMBER = 1000, 2000, 10
HALVINGS = 6
#: A second wrench on the same grasp is the first one times this.
SECOND = Fraction(65, 64)
MILP_SECONDS = 60
VERDICTS = {True: "resisted", False: "not resisted"}


def instance(contacts: int, seed: int) -> tuple[Grasp, Wrench]:
    """Return the grasp and the wrench of a seed."""
    plain = seed % PATCHES
    number = NUMBER if seed >= PATCHES else contacts
    if plain % 4 < 2:
        listed = list(random_grasp(number, plain))
    else:
        listed = [c for c in random_grasp(8 * number, plain) if _on_one_side(c)]
    if len(listed) < number:
        raise ValueError(f"seed {seed} gives too few contacts on one side")
    grasp = Grasp(listed[:number])
    if number < contacts:
        grasp = Grasp(part for c in grasp for part in _patch(c, contacts // number))
    x, y, torque = random_wrench(plain)
    wrench = (-abs(x) if plain % 8 >= 6 else x, y, torque)
    return grasp, _beyond_the_border(grasp, wrench) if seed >= BORDER else wrench


def _patch(contact: Contact, number: int) -> Iterator[Contact]:
    """Yield contacts along the tangent, a quarter long, that together are like the one."""
    (x, y), (nx, ny) = contact.point, contact.normal
    for k in range(number):
        along = Fraction(2 * k + 1 - number, 8 * number)
        yield replace(
            contact,
            point=(x - along * ny, y + along * nx),
            stiffness=contact.stiffness / number,
            preload=contact.preload / number,
        )


def _beyond_the_border(grasp: Grasp, wrench: Wrench) -> Wrench:
    """Return a wrench just not resisted between a push and this one, or this one if it is."""
    solver, resisted = Solver(grasp), (Fraction(2), Fraction(0), Fraction(0))
    if solver.solve(wrench).stable or not solver.solve(resisted).stable:
        return wrench
    for _ in range(HALVINGS):
        middle = tuple((a + b) / 2 for a, b in zip(resisted, wrench, strict=True))
        if solver.solve(middle).stable:
            resisted = middle
        else:
            wrench = middle
    return wrench


def _on_one_side(contact: Contact) -> bool:
    """Whether the contact is within 60 degrees of the direction x."""
    x, y = contact.point
    return x > 0 and 3 * x * x > y * y


def ours(grasp: Grasp, wrench: Wrench) -> Found:
    """Verdict and proof; the check of the proof; a second wrench on the same grasp."""
    clock = time.process_time
    start = clock()
    solver = Solver(grasp)
    verdict = solver.solve(wrench)
    certificate = verdict.certificate
    written = clock()
    document = certificate.to_dict()
    begin = clock()
    report = check(document, question=(grasp, wrench))
    checked = clock()
    again = solver.solve([SECOND * w for w in wrench])
    same = again.stable == verdict.stable and bool(again.certificate)
    second = clock() - checked if same else None
    proof = {key: value for key, value in document.items() if key not in ("grasp", "wrench")}
    text = json.dumps(proof, separators=(",", ":"))
    return {
        "verdict": VERDICTS[verdict.stable],
        "seconds": written - start,
        "check": checked - begin,
        "valid": bool(report),
        "second": second,
        "bytes": len(text),
        "leaves": report.leaves,
        "digits": statistics.median(map(len, re.findall(r"\d+", text))),
    }


def pieces(grasp: Grasp, wrench: Wrench) -> Found:
    """The verdict with all equilibria."""
    start = time.process_time()
    found = solve(grasp, wrench).equilibria
    seconds = time.process_time() - start
    return {"verdict": VERDICTS[bool(found)], "seconds": seconds, "pieces": len(found)}


def milp(grasp: Grasp, wrench: Wrench) -> Found:
    """The mixed-integer program."""
    from milp import solve_milp

    answer = solve_milp(grasp, wrench, seconds=MILP_SECONDS)
    verdict = {"stable": VERDICTS[True], "unstable": VERDICTS[False]}.get(answer.verdict)
    return {"verdict": verdict or answer.verdict, "seconds": answer.seconds}


def brute(grasp: Grasp, wrench: Wrench) -> Found:
    """Exact brute force over all 4^m states."""
    from tests.equilibrium import oracle

    start = time.process_time()
    found = list(oracle.solutions(grasp, wrench))
    seconds = time.process_time() - start
    return {"verdict": VERDICTS[bool(found)], "seconds": seconds}


def contacts_in_floats(grasp: Grasp, wrench: Wrench) -> Found:
    """The question in floats, for a peer that reads JSON."""
    names = ("friction", "stiffness", "preload")
    listed = [
        {
            **{name: float(getattr(c, name)) for name in names},
            "normal_wrench": [float(x) for x in c.normal_wrench],
            "tangential_wrench": [float(x) for x in c.tangential_wrench],
        }
        for c in grasp
    ]
    return {"contacts": listed, "wrench": [float(w) for w in wrench]}


JOBS: dict[str, Callable[[Grasp, Wrench], Found]] = {
    job.__name__: job for job in (ours, pieces, milp, brute, contacts_in_floats)
}

if __name__ == "__main__":
    name, contacts, *seeds = sys.argv[1:]
    for warm in (0, 1, 2, 3):
        JOBS[name](*instance(4, 500 + warm))
    for seed in map(int, seeds):
        found = JOBS[name](*instance(int(contacts), seed))
        print(json.dumps({"contacts": int(contacts), "seed": seed, **found}), flush=True)
