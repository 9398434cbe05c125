"""The command ``equilibrium``: solve a grasp, verify a certificate."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from arrangement import terminal
from arrangement.exact import to_text

from . import (
    draw,
    inputs,
    methods,
    wrench_sets,
)

if TYPE_CHECKING:
    from equilibrium.solver.equilibrium import Equilibrium

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
        "equilibrium", "Exact passive equilibrium of planar grasps with friction, with proofs."
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    _add_solve(commands)
    _add_verify(commands)
    wrench_sets.add_commands(commands)
    methods.add_commands(commands)
    inputs.add_commands(commands)
    draw.add_commands(commands)
    return parser


def _add_solve(commands: Any) -> None:
    solve = commands.add_parser(
        "solve", help="decide whether a grasp holds a wrench (exit 0 stable, 1 not)"
    )
    solve.add_argument("grasp", metavar="GRASP", help="a path, - for stdin, or a built-in name")
    solve.add_argument(
        "--wrench",
        nargs=3,
        required=True,
        metavar=("X", "Y", "R"),
        type=terminal.rational_argument,
        help="applied force x, force y, torque about the origin",
    )
    solve.add_argument(
        "--preload",
        metavar="P",
        type=terminal.rational_argument,
        help="use this preload at every contact instead of the grasp's own",
    )
    solve.add_argument("--certificate", metavar="OUT.json", help="write the certificate here")
    solve.add_argument(
        "--literal",
        nargs="+",
        action="extend",
        default=[],
        choices=LITERAL,
        metavar="OPTION",
        help="follow the printed text in these points: " + ", ".join(LITERAL),
    )
    terminal.add_json_option(solve)
    solve.set_defaults(command=_solve)


def _add_verify(commands: Any) -> None:
    verify = commands.add_parser(
        "verify", help="check a certificate without the solver (exit 0 valid, 1 not)"
    )
    verify.add_argument("certificate", metavar="CERT.json", help="a path, or - for stdin")
    verify.add_argument(
        "--rationals-only",
        action="store_true",
        help="take every sign from rationals, none from floating point with a proven bound; slow",
    )
    verify.add_argument(
        "--proved",
        action="store_true",
        help="ask the checker that is proved in Coq (built by `make formal`)",
    )
    terminal.add_json_option(verify)
    verify.set_defaults(command=_verify)


def _solve(arguments: argparse.Namespace) -> int:
    from equilibrium.io.files import read_grasp, write_certificate
    from equilibrium.methods.printed_model import solve_literal
    from equilibrium.model.errors import GraspError
    from equilibrium.verdict import solve

    if arguments.literal and arguments.certificate:
        raise GraspError("a literal reading has no certificate; leave out one of the two options")
    grasp = read_grasp(arguments.grasp)
    if arguments.preload is not None:
        grasp = grasp.with_preload(arguments.preload)
    if arguments.literal:
        literal = solve_literal(grasp, arguments.wrench, arguments.literal)
        document, pieces = literal.to_dict(), literal.equilibria
    else:
        verdict = solve(grasp, arguments.wrench)
        document, pieces = verdict.to_dict(), verdict.equilibria
        if arguments.certificate:
            write_certificate(arguments.certificate, verdict.certificate)
    if arguments.json:
        terminal.print_json(document)
    else:
        if grasp.units:
            print(grasp.units)
        _print_verdict(pieces)
    return terminal.YES if pieces else terminal.NO


def _print_verdict(pieces: Sequence[Equilibrium]) -> None:
    if not pieces:
        print("not stable: no contact state admits an equilibrium")
        return
    print(f"stable: {len(pieces)} " + ("equilibrium" if len(pieces) == 1 else "equilibria"))
    for piece in pieces:
        print(f"  motion ({', '.join(map(to_text, piece.motion))})" + _freedom(piece))
        for i, (state, (normal, tangential)) in enumerate(
            zip(piece.states, piece.forces, strict=True)
        ):
            print(f"    contact {i}  {state:<8}  force ({to_text(normal)}, {to_text(tangential)})")


def _freedom(piece: Equilibrium) -> str:
    if piece.unique:
        return ""
    if piece.forces_determined:
        return "  (of least norm; the forces are determined, the motion is not)"
    return "  (of least norm; neither motion nor forces need be determined)"


def _verify_proved(arguments: argparse.Namespace) -> int:
    from equilibrium.io.proved_checker import verify_proved

    valid, kind = verify_proved(arguments.certificate)
    if arguments.json:
        terminal.print_json({"valid": valid, "certificate": kind, "checker": "proved"})
    elif valid:
        print(f"valid: the verdict is {kind} (by the proved checker)")
    else:
        print(f"not valid: this does not prove {kind} (by the proved checker)")
    return terminal.YES if valid else terminal.NO


def _verify(arguments: argparse.Namespace) -> int:
    from equilibrium.io.files import verify

    if arguments.proved:
        return _verify_proved(arguments)
    report = verify(arguments.certificate, rationals_only=arguments.rationals_only)
    if arguments.json:
        terminal.print_json(report.to_dict())
    elif report.valid:
        print(f"valid: the verdict is {report.kind} ({len(report.lines)} lines checked)")
    else:
        failed = next(line for line in report.lines if not line.holds)
        print(f"not valid: line {failed.name!r} fails: {terminal.printable(failed.problem)}")
    return terminal.YES if report.valid else terminal.NO


if __name__ == "__main__":
    raise SystemExit(main())
