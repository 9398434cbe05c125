"""The subcommand ``equilibrium modes``; `equilibrium.cli` adds it."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from arrangement.console.number_form import sign_text, vector
from arrangement.console.progress import shown

from .arguments import add_command, grasp_of, seconds, show

if TYPE_CHECKING:
    from equilibrium.modes import ContactModes, Slips


def add_commands(commands: Any) -> None:
    """Add modes."""
    text = "contact modes: what rigid contacts can do, from kinematics alone"
    modes = add_command(commands, "modes", _modes, text, preload=False)
    modes.add_argument("--count", action="store_true", help="say how many there are, list none")
    modes.add_argument(
        "--time-limit", metavar="SECONDS", type=seconds, help="give up then (exit 2)"
    )


def _modes(arguments: argparse.Namespace) -> int:
    from equilibrium.modes import ContactModes

    modes = ContactModes.of_grasp(grasp_of(arguments), time_limit=arguments.time_limit)
    with shown():
        return show(arguments, _document(modes, arguments), _lines(modes, arguments.count))


def _document(modes: ContactModes, arguments: argparse.Namespace) -> dict[str, Any]:
    if not arguments.json:
        return {}
    if arguments.count:
        return {
            "contacting_separating": len(modes.contacting_separating),
            "sliding_sticking": modes.sliding_sticking_count,
        }
    return {
        "contacting_separating": [mode.to_dict() for mode in modes.contacting_separating],
        "sliding_sticking": [mode.to_dict() for mode in modes.sliding_sticking()],
    }


def _lines(modes: ContactModes, count: bool) -> Iterator[str]:
    number = len(modes.contacting_separating)
    if count:
        yield f"contacting-separating  {number:>7}"
        yield f"sliding-sticking       {modes.sliding_sticking_count:>7}"
        return
    yield f"contacting-separating modes: {number} (c: stays in contact, s: separates)"
    for kept in modes.contacting_separating:
        signs = "".join("s" if sign else "c" for sign in kept.signs)
        yield f"  {signs}  dim {kept.dimension}  {vector(kept.motion)}"
    yield "sliding-sticking modes (0: no slip, + and -: slip along a tangent)"
    for slid in modes.sliding_sticking():
        yield f"  {_slips(slid.signs)}  dim {slid.dimension}  {vector(slid.motion)}"


def _slips(signs: Slips) -> str:
    return " ".join("s" if s is None else sign_text(s) for s in signs)
