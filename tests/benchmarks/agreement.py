"""The solver, brute force and the mixed-integer program on seeded degenerate problems.

    agreement.py                  2,000 questions of 2 to 5 contacts (about ten minutes)
    agreement.py --grasps 200     fewer

Every difference between solver and brute force is a mistake and is printed with its seed (exit
code 1). Every difference between solver and mixed-integer program is explained by an exact
calculation: brute force within the program's bound on the motion, or the amount by which the
program's own point violates the model.
"""

import argparse
import sys
from collections import Counter, defaultdict
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from milp import BOUND, Answer, solve_milp, violation

from equilibrium import Verdict, solve
from tests.equilibrium import oracle
from tests.equilibrium.agreement import disagreements
from tests.equilibrium.degenerate import Question, question

AGREED = "the same verdict"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--grasps", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0, help="seed of the first question")
    options = parser.parse_args()
    asked: Counter[tuple[int, bool]] = Counter()
    loads: Counter[tuple[str, bool]] = Counter()
    causes: defaultdict[str, list[tuple[Fraction, int]]] = defaultdict(list)
    wrong = 0
    for seed in range(options.first, options.first + options.grasps):
        one = question(seed)
        verdict = solve(one.grasp, one.wrench)
        for problem in disagreements(one, verdict):
            wrong += 1
            print(f"seed {seed}: {problem}", flush=True)
        asked[len(one.grasp), verdict.stable] += 1
        loads[one.load, verdict.stable] += 1
        answer = solve_milp(one.grasp, one.wrench)
        cause, size = explained(one, verdict, answer)
        causes[cause].append((size, seed))
        if sys.stderr.isatty():
            print(f"\r{sum(asked.values())} of {options.grasps}", end="", file=sys.stderr)
    report(asked, loads, causes)
    print(f"\ndifferences between solver and brute force: {wrong}")
    return 1 if wrong else 0


def explained(one: Question, verdict: Verdict, answer: Answer) -> tuple[str, Fraction]:
    """Return why the program differs, and a size: a violation of the model, or a motion."""
    mine = "stable" if verdict.stable else "unstable"
    zero = Fraction(0)
    if answer.verdict not in ("stable", "unstable"):
        return f"no verdict: {answer.verdict}", zero
    if answer.verdict == "stable":
        amount, _ = violation(one.grasp, one.wrench, answer)
        if mine == "stable":
            return AGREED if amount < Fraction(1, 10**6) else "the same, by a wrong point", amount
        side = "10^-30 outside the boundary" if one.load == "outside" else "no boundary known"
        return f"it says stable, exactly unstable: {side}; its point violates the model", amount
    if mine == "unstable":
        return AGREED, zero
    if oracle.is_stable(one.grasp, one.wrench, BOUND):
        again = solve_milp(one.grasp, one.wrench, presolve=False).verdict
        note = f"without its presolve it says {again}"
        return f"it says unstable, an equilibrium is within the bound; {note}", zero
    least = min(max(map(abs, piece.motion)) for piece in verdict.equilibria)
    return f"it says unstable, every equilibrium moves by more than {BOUND}", least


def report(
    asked: Counter[tuple[int, bool]],
    loads: Counter[tuple[str, bool]],
    causes: dict[str, list[tuple[Fraction, int]]],
) -> None:
    for title, table in (("contacts", asked), ("wrench", loads)):
        print(f"\n{title:<10}{'stable':>8}{'unstable':>10}")
        for name in sorted({name for name, _ in table}, key=str):
            print(f"{name:<10}{table[name, True]:>8}{table[name, False]:>10}")
        both = [sum(n for (_, s), n in table.items() if s is value) for value in (True, False)]
        print(f"{'all':<10}{both[0]:>8}{both[1]:>10}")
    print(
        "\nthe mixed-integer program beside the exact verdict (smallest and largest size, a seed)"
    )
    for cause, found in sorted(causes.items()):
        least, most = min(found), max(found)
        print(f"{len(found):>6}  {cause}")
        if most[0]:
            print(f"        from {float(least[0]):.2g} to {float(most[0]):.2g}; seed {most[1]}")
        elif cause != AGREED:
            print(f"        seeds {', '.join(str(seed) for _, seed in found[:8])}")


if __name__ == "__main__":
    sys.exit(main())
