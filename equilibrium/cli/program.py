"""The command ``equilibrium``: solve a grasp, verify a certificate."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING, Any

from arrangement import budget, terminal
from arrangement.exact import dot
from arrangement.number_form import vector
from equilibrium.model.pyramid import pyramid_words

from . import draw, inputs, lab, methods, modes, wrench_sets
from .arguments import add_applied, add_command, add_cone, applied, grasp_of, seconds, show
from .proof_words import proof_lines
from .spatial_words import spatial_lines

if TYPE_CHECKING:
    from equilibrium.model.grasp import Grasp
    from equilibrium.solver.equilibrium import Equilibrium
    from equilibrium.solver.state_equilibrium import Solution
    from equilibrium.solver.state_system import States
    from equilibrium.verdict import Verdict

#: The names of `printed_model.OPTIONS`, kept here so that ``--help`` loads no solver.
LITERAL = (
    "detachment",
    "preload",
    "signs",
    "cell-check",
    "all-stick",
    "coincident-planes",
    "single-solution",
)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command; return its exit code."""
    return terminal.run(_parser(), argv)


def _parser() -> terminal.Parser:
    parser = terminal.command_parser(
        "equilibrium", "Exact passive equilibrium of grasps with friction, with proofs."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve = add_command(
        commands,
        "solve",
        _solve,
        "decide whether a grasp resists a wrench (exit 0 yes, 1 no, 3 undecided)",
    )
    add_applied(solve)
    solve.add_argument("--certificate", metavar="OUT.json", help="write the certificate here")
    solve.add_argument(
        "--time-limit", metavar="SECONDS", type=seconds, help="give up then (exit 2; in space 3)"
    )
    add_cone(solve)
    solve.add_argument(
        "--shorten", action="store_true", help="look longer for a smaller proof of a no"
    )
    solve.add_argument(
        "--all", action="store_true", help="list all equilibria of more than 20 contacts, too"
    )
    solve.add_argument(
        "--literal",
        nargs="+",
        action="extend",
        default=[],
        choices=LITERAL,
        metavar="OPTION",
        help="follow the printed text in these points: " + ", ".join(LITERAL),
    )
    verify = add_command(
        commands,
        "verify",
        _verify,
        "check a certificate without the solver (exit 0 valid, 1 not)",
        grasp=False,
        numbers=False,
    )
    verify.add_argument("certificate", metavar="CERT.json", help="a path, or - for stdin")
    verify.add_argument(
        "--proved",
        action="store_true",
        help="ask the checker that is proved in Coq (built by `make formal`)",
    )
    add_command(commands, "list", _list, "list the built-in grasps", grasp=False)
    wrench_sets.add_commands(commands)
    methods.add_commands(commands)
    modes.add_commands(commands)
    inputs.add_commands(commands)
    draw.add_commands(commands)
    lab.add_commands(commands)
    return parser


def _list(arguments: argparse.Namespace) -> int:
    from arrangement.io.files import described

    return terminal.print_names(described("contacts"), arguments.json)


def _solve(arguments: argparse.Namespace) -> int:
    from equilibrium.io.files import write_certificate
    from equilibrium.methods.printed_model import solve_literal
    from equilibrium.model.errors import GraspError
    from equilibrium.model.pyramid import FLAT
    from equilibrium.spatial_verdict import SpatialVerdict, solve_in_space
    from equilibrium.verdict import solve

    if arguments.literal and arguments.certificate is not None:
        raise GraspError("a literal reading has no certificate; omit one of the two options")
    grasp = grasp_of(arguments)
    wrench = applied(arguments, grasp)
    if arguments.literal:
        literal = solve_literal(grasp, wrench, arguments.literal)
        lines = _verdict_lines(literal.equilibria, grasp)
        return show(arguments, literal.to_dict(), lines, literal.stable, grasp)
    usual = arguments.time_limit or budget.SECONDS * budget.times()
    limits = {"time_limit": usual, "shorten": arguments.shorten}
    if arguments.cone is None:
        found = solve(grasp, wrench, **limits)
    elif grasp.dimension == 2:
        raise GraspError(FLAT)
    else:
        limit = arguments.time_limit
        found = solve_in_space(grasp, wrench, time_limit=limit, pyramid=arguments.cone)
    if arguments.certificate is not None and found.certificate is not None:
        write_certificate(arguments.certificate, found.certificate)
    if isinstance(found, SpatialVerdict):
        yes = found.stable if found.decided else None
        return show(arguments, found.to_dict(), spatial_lines(found), yes, grasp)
    every = arguments.all or None
    lines = (
        _verdict_lines(found.equilibria, grasp) if found.lists_all(every) else _one_of_many(found)
    )
    if not found.stable:
        lines = chain(lines, proof_lines(found, arguments.certificate))
    return show(arguments, found.to_dict(every), lines, found.stable, grasp)


def _verdict_lines(pieces: Sequence[Equilibrium], grasp: Grasp) -> Iterator[str]:
    if not pieces:
        yield "not resisted: no contact state admits an equilibrium"
        return
    yield f"resisted: {len(pieces)} " + ("equilibrium" if len(pieces) == 1 else "equilibria")
    for piece in pieces:
        yield from _equilibrium_lines(grasp, piece, piece.states, _freedom(piece))


def _one_of_many(found: Verdict) -> Iterator[str]:
    yield "resisted: the equilibrium found is below; there may be others, and --all lists them"
    if found.solution is not None:
        yield from _equilibrium_lines(found.grasp, found.solution, found.states)


def _equilibrium_lines(
    grasp: Grasp, found: Equilibrium | Solution, states: States, freedom: str = ""
) -> Iterator[str]:
    yield f"  motion {vector(found.motion)}{freedom}"
    for i, (contact, state, force) in enumerate(zip(grasp, states, found.forces, strict=True), 1):
        still = state.startswith("slip") and dot(contact.tangential_wrench, found.motion) == 0
        why = "  (not slipping: at the edge of its cone)" if still else ""
        yield f"    contact {i}  {state:<8}  force {vector(force)}{why}"


def _freedom(piece: Equilibrium) -> str:
    if piece.unique:
        return ""
    if piece.forces_determined:
        return "  (of least norm; the forces are determined, the motion is not)"
    return "  (of least norm; neither motion nor forces need be determined)"


def _verify(arguments: argparse.Namespace) -> int:
    from equilibrium.io.files import verify
    from equilibrium.io.proved_checker import verify_proved

    if arguments.proved:
        valid, kind = verify_proved(arguments.certificate)
        document: dict[str, Any] = {"valid": valid, "certificate": kind}
        speaker, said = "proved", kind if valid else f"this does not prove {kind}"
    else:
        report = verify(arguments.certificate)
        valid, document, speaker = bool(report), report.to_dict(), "Python"
        proof = f"{report.kind}, {report.leaves} leaves" if report.leaves else report.kind
        proof += pyramid_words(report.pyramid, before=", with ")
        said = proof if valid else terminal.printable(report.problem)
    line = f"{'valid' if valid else 'not valid'}: {said} (by the {speaker} checker)"
    return show(arguments, {**document, "checker": speaker.lower()}, [line], valid)


if __name__ == "__main__":
    raise SystemExit(main())
