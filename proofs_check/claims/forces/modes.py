"""Claims of others: contact modes of boxes at walls, counted by two routes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random

from arrangement.numbers.exact import RationalVector, primitive
from equilibrium.grasps.files import read_grasp
from equilibrium.modes import ContactModes
from proofs_check.routes.contact_modes import mode_counts
from proofs_check.statements.statement import Case, Claim, Route, exhaustive

_SOURCE = "our count of [HuangChengMason2020]"
#: Walls at a box -> contacting-separating modes.
_BY_WALLS = {1: 10, 2: 46, 3: 136, 4: 10, 5: 2, 6: 1}


@dataclass(frozen=True)
class _Touching:
    """Rigid contacts, and how many modes are said to be."""

    modes: ContactModes
    said: int


def _wrenches_turned(
    pair: tuple[RationalVector, ...], x: int, y: int
) -> tuple[RationalVector, ...]:
    """Return tangents turned by the angle of (x, y), of another length."""
    first, second = pair
    return (
        tuple(x * a + y * b for a, b in zip(first, second, strict=True)),
        tuple(x * b - y * a for a, b in zip(first, second, strict=True)),
    )


def _turned(turns: Callable[[int], tuple[int, int]]) -> ContactModes:
    box = read_grasp("box-1-wall")
    rows = [_wrenches_turned(c.tangential_wrenches, *turns(i)) for i, c in enumerate(box)]
    straight = ContactModes.of_grasp(box)
    turned = tuple(tuple(primitive(row) for row in pair) for pair in rows)
    return ContactModes(straight.normals, turned, straight.n)


def _document(modes: ContactModes) -> dict[str, object]:
    return {"normals": modes.normals, "tangents": modes.tangents}


def _walls(rng: Random) -> Iterator[Case]:
    for walls, said in _BY_WALLS.items():
        modes = ContactModes.of_grasp(read_grasp(f"box-{walls}-wall{'s' * (walls > 1)}"))
        yield Case(f"{walls} wall{'s' * (walls > 1)}", _Touching(modes, said), _document(modes))


def _tangents(rng: Random) -> Iterator[Case]:
    apart = ((5, 2), (7, 1), (3, 1), (13, 8))
    for text, said, turns in (
        ("along the edges", 196, lambda i: (1, 0)),
        ("turned by 45 degrees", 340, lambda i: (1, 1)),
        ("turned by the angle of 3-4-5", 404, lambda i: (4, 3)),
        ("turned differently at each contact", 468, lambda i: apart[i]),
    ):
        modes = _turned(turns)
        yield Case(text, _Touching(modes, said), _document(modes))


def _counted(place: int) -> Callable[[_Touching], int]:
    return lambda t: mode_counts(t.modes.normals, t.modes.tangents, t.modes.n)[place]


CLAIMS = (
    Claim(
        id="contacting-modes-of-a-box",
        locator=_SOURCE,
        statement="A box with four contacts at each of 1, 2, 3, 4, 5, 6 walls has 10, 46, 136, 10, "
        "2, 1 contacting-separating modes.",
        quantity="number of contacting-separating modes",
        routes=(
            Route(
                "faces of the cone N d >= 0, listed", lambda t: len(t.modes.contacting_separating)
            ),
            Route("sets of generators of that cone", _counted(0)),
        ),
        judge=lambda t, number: number == t.said,
        sources=exhaustive("the six numbers of walls", _walls),
        meaning="The source lists modes in floats; here they are listed and counted exactly.",
        rows=True,
    ),
    Claim(
        id="sliding-modes-depend-on-tangents",
        locator=_SOURCE,
        statement="A box on a wall has 196 sliding-sticking modes with tangents along its edges, "
        "340 with these turned by 45 degrees, 404 turned by the angle of 3-4-5, and 468 turned "
        "differently at each contact.",
        quantity="number of sliding-sticking modes",
        routes=(
            Route("faces inside the cone, listed", lambda t: t.modes.sliding_sticking_count),
            Route("Zaslavsky's theorem on the flats that meet the cone", _counted(1)),
        ),
        judge=lambda t, number: number == t.said,
        sources=exhaustive("four choices of tangents", _tangents),
        meaning="The number is no property of the contacts alone: it belongs to the tangents too.",
        rows=True,
    ),
)
