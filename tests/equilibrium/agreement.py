"""One question, answered by the solver and by brute force: what they disagree on."""

from equilibrium import Verdict, solve

from . import oracle
from .degenerate import Question


def disagreements(asked: Question, verdict: Verdict | None = None) -> list[str]:
    """Return every difference in words; empty when all agree.

    Every solution of brute force has to satisfy the definition and to lie in a reported piece;
    every reported piece has to satisfy the definition; and the certificate has to be valid.
    """
    grasp, wrench = asked.grasp, asked.wrench
    verdict = solve(grasp, wrench) if verdict is None else verdict
    pieces = verdict.equilibria
    found = list(oracle.solutions(grasp, wrench))
    problems = []
    if verdict.stable != bool(found):
        problems.append(f"solver: {verdict.stable}, brute force: {bool(found)}")
    for solution in found:
        if not oracle.satisfies(grasp, wrench, solution.motion, solution.forces):
            problems.append(f"brute force is wrong for {solution.states}")
        if not any(piece.contains(solution.motion, solution.forces) for piece in pieces):
            problems.append(f"no piece contains the solution for {solution.states}")
    for piece in pieces:
        if not oracle.satisfies(grasp, wrench, piece.motion, piece.forces):
            problems.append(f"the piece {piece.states} is not an equilibrium")
    if not verdict.verify():
        problems.append("the certificate is refused")
    return problems
