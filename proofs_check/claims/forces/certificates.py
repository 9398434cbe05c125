"""Claims on the size of proofs that nothing balances a load."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import product

from equilibrium.decide.verdict import Solver, Verdict
from proofs_check.instances.grasps import grasp_case, grasp_of
from proofs_check.instances.paper_tables import FRICTION
from proofs_check.routes.leaves import leaf_count
from proofs_check.routes.oracle import Question
from proofs_check.statements.statement import Case, Claim, Route, sampled

#: Loads beyond what two jaws hold, whatever the number of their contacts: 2 along the jaws.
_LOADS = (
    *(tuple(map(Fraction, x)) for x in (("0", "3", "0"), ("1/2", "3", "1"), ("1", "-5/2", "1"))),
    *((Fraction(0), 2 + Fraction(1, 10**power), Fraction(0)) for power in (3, 30)),
)
_COUNTS = (4, 6, 10, 20, 40, 80)


def _jaws(m: int, load: tuple[Fraction, ...]) -> Question:
    """Return m / 2 contacts at even distances on either jaw, of stiffness and preload 4 in all.

    For m = 4 this is the four-contact grasp of the paper with preload 1.
    """
    n, share = m // 2, Fraction(4, m)
    heights = [Fraction(2 * k - (n - 1), n - 1) for k in range(n)]
    rows = tuple(
        (Fraction(-side), height, Fraction(side), Fraction(0), FRICTION, share, share)
        for side, height in product((1, -1), heights)
    )
    return Question(rows, load)


@lru_cache(maxsize=64)
def _decided(question: Question) -> Verdict:
    return Solver(grasp_of(question)).solve(question.wrench)


def _checked(question: Question) -> int:
    report = _decided(question).verify()
    if not report or not report.leaves:
        raise ValueError(f"the certificate is no proof: {report}")
    return report.leaves


def _evaluated(question: Question) -> int:
    return leaf_count(question, _decided(question).certificate.to_dict()["tree"])


def _cases() -> Iterator[Case]:
    for load, m in product(_LOADS, _COUNTS):
        label = f"m = {m}, w = ({', '.join(map(str, load))})"
        yield grasp_case(_jaws(m, load), label)


CLAIMS = (
    Claim(
        id="leaves-do-not-grow",
        formula=r"\text{leaves}(m) \le \text{leaves}(4)",
        locator="our claim, on certificates",
        statement="For two jaws with m contacts at even distances, of total stiffness 4 and total "
        "preload 4, the proof that a load is not resisted has no more leaves than for the four "
        "contacts of the paper.",
        hypotheses=("friction 1/2", "the load is along the jaws or not near the border"),
        quantity="leaves of a valid proof",
        routes=(
            Route("the checker of certificates", _checked),
            Route("every leaf evaluated at the generators of its region", _evaluated),
        ),
        judge=lambda question, leaves: leaves <= _checked(_jaws(4, question.wrench)),
        sources=sampled("five loads for m = 4, 6, 10, 20, 40, 80", lambda _: _cases()),
        explain=lambda question, leaves: f"{leaves} leaves for {len(question.contacts)} contacts",
        meaning="A proof cuts the space of motions, three dimensions whatever the number of "
        "contacts. How many regions it needs depends on the load.",
    ),
)
