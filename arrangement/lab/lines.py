"""The arrangement lab: one page in which lines and great circles are dragged and counted at once.

The page counts by itself, in integers: it shares nothing with the enumerators and the counts here
but the form of files. Of the census it knows representatives; it tells types apart by a canonical
form of its own.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.draw.html_page import Template
from arrangement.formats.table import read_arrangement
from arrangement.library.census import census

from .lines_exercises import line_exercises
from .lines_input import MAX_PLANES, as_shown
from .page import LINEAR, RATIONAL, lab

#: Planes up to which types have names.
NAMED_PLANES = 6
#: Five lines of a pentagram, all but regular.
_FIRST = ((0, 1, -1), (-19, 6, -20), (-3, -4, -5), (3, -4, -5), (19, 6, -20))
_EXAMPLES = (
    ("Four generic planes", "four-generic-planes"),
    ("Five generic planes", "five-generic-planes"),
    ("Near-pencil", "near-pencil"),
    ("Braid arrangement A₃", "braid-a3"),
    ("Mirrors of the cube B₃", "reflection-b3"),
    ("Coincident planes", "coincident-planes"),
    ("Generic lines", "generic-lines-affine"),
    ("Shi arrangement of A₂", "shi-a2-affine"),
)
_OWN = "arrangement.lab"
#: What counts: it knows nothing of pages.
_COUNTS = ("circles", "counts", "types", "document")
_DRAWS = ("words", "charts", "state", "plane_view", "ball_view", "numbers")
_MOVES = ("moves", "drags", "planes", "goals", "page")
SCRIPTS: tuple[Template, ...] = (
    RATIONAL,
    LINEAR,
    ("arrangement.draw", "ball.js"),
    *((_OWN, f"lines/{name}.js") for name in (*_COUNTS, *_DRAWS, *_MOVES)),
)


def lab_page(
    arrangement: Arrangement | None = None,
    *,
    title: str | None = None,
    exercises: str | Path | None = None,
) -> str:
    """Return one HTML page, complete in itself: lines and great circles to drag, counted exactly.

    Args:
        arrangement: at first; central of rank at most 3, or lines of R^2, up to `MAX_PLANES`. In
            other spaces the essentialisation is meant. If omitted, five lines.
        title: a heading.
        exercises: a JSON file with exercises; if omitted, those that come with the lab.

    Raises:
        InputError: too many planes or digits, another space, or no exercises in the file.
    """
    first = Arrangement(_FIRST) if arrangement is None else as_shown(arrangement)
    data: dict[str, Any] = {
        "title": "The arrangement lab" if title is None else title,
        "summary": "Drag lines and great circles; every number is exact.",
        "most": MAX_PLANES,
        "arrangement": first.to_dict(),
        "examples": [
            {"name": name, "arrangement": read_arrangement(source).to_dict()}
            for name, source in _EXAMPLES
        ],
        "census": {
            str(m): [one.to_dict()["planes"] for one in census(m)]
            for m in range(3, NAMED_PLANES + 1)
        },
        "exercises": line_exercises(exercises),
    }
    styles: list[Template] = [(_OWN, "lines/page.css")]
    return lab(data["title"], (_OWN, "lines/page.html"), styles, SCRIPTS, data)
