"""The arrangement lab: lines and great circles that are dragged and counted at once.

The page counts by itself, in integers: it shares nothing with the enumerators and the counts here
but the form of files. Of the census it knows representatives; it distinguishes types by a canonical
form of its own.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.counts import essentialization
from arrangement.drawing.pages import Template
from arrangement.errors import InputError
from arrangement.library.census import census
from arrangement.library.families import simplicial, simplicial_entries
from arrangement.library.files.table import read_arrangement
from arrangement.numbers import budget
from arrangement.numbers.exact import rational, shown, to_text

from .page import RATIONAL, VECTORS, lab, read_exercises
from .widget import lab_widget


def as_shown(arrangement: Arrangement) -> Arrangement:
    """Return planes as the page has them: lines of R^2, or central planes of R^3.

    Raises:
        InputError: there is no such form, or it is too large.
    """
    shown_planes = arrangement
    if arrangement.field is not None:
        raise InputError(
            f"the planes have entries in {arrangement.field!r}, and the lab counts in integers; "
            "`arrangement draw FILE -o page.html` shows central ones, exactly"
        )
    if arrangement.dimension not in (2, 3) or (
        arrangement.dimension == 3 and not arrangement.is_central
    ):
        flat = not arrangement.is_central
        if arrangement.rank > (2 if flat else 3):
            kind = "affine" if flat else "central"
            raise InputError(
                f"{kind} planes of rank {arrangement.rank} in R^{arrangement.dimension}; the lab "
                "takes central planes of rank at most 3 and affine ones of rank at most 2"
            )
        least, dimension = essentialization(arrangement), 2 if flat else 3
        rows = [(*n, *[0] * (dimension - least.dimension)) for n in least.normals]
        shown_planes = Arrangement(rows, least.offsets, dimension=dimension)
    budget.check_size(len(shown_planes), "planes in the lab")
    numbers = (abs(x) for plane in shown_planes.integer_planes for x in plane)
    longest = to_text(max(numbers, default=0))
    budget.check_size(len(longest), "digits of a number on a page")
    return shown_planes


def read_start(text: str) -> Arrangement:
    """Return the planes of a link of the page, as it is after ``#``: ``1|3|1,0,0;0,1,0``.

    Raises:
        InputError: no such link.
    """
    version, *parts = text.split("|")
    if version != "1" or len(parts) != 2 or parts[0] not in ("2", "3"):
        raise InputError(
            f"{shown(text)} is not what a link of the lab has after #: 1|dimension|planes"
        )
    rows = [row.split(",") for row in parts[1].split(";") if row]
    for row in rows:
        if len(row) != 3:
            raise InputError(f"plane {shown(','.join(row))} needs three numbers")
    dimension = int(parts[0])
    offsets = [rational(row[2]) for row in rows] if dimension == 2 else None
    return as_shown(Arrangement([row[:dimension] for row in rows], offsets, dimension=dimension))


#: What `lab.count` returns, and goals may ask for.
COUNTS = (
    *("planes", "distinct_planes", "dimension", "rank", "f_vector", "regions", "bounded_regions"),
    *("characteristic_polynomial", "t_vector", "p_vector", "simple", "simplicial", "triangles"),
    "type",
)
#: Planes that may have to stay, by number.
FIXED = tuple(str(k) for k in range(1, budget.MAX_SIZES["planes in the lab"] + 1))


def line_exercises(path: str | Path | None = None) -> list[dict[str, Any]]:
    """Return the exercises of a file, or those that come with the lab.

    A goal is ``{"counts": {...}}`` with values of `lab.count`; ``{"meet": [[1, 2, 3]]}`` with lists
    of lines that go through one point each; or ``{"closes": {"meet": [...], "then": [...]}}``,
    whose last list of lines is found to meet by itself.

    Raises:
        InputError: the file holds no exercises; the message says which, and why.
    """
    own = files(__package__).joinpath("lines_exercises.json")
    return read_exercises(own if path is None else path, GOALS, FIXED, read_start)


def _check_counts(value: Any) -> None:
    unknown = sorted(set(value) - set(COUNTS)) if isinstance(value, dict) else ["no object"]
    if unknown or not value:
        raise InputError(f"has {shown(unknown)}; give values of: {', '.join(COUNTS)}")


def _check_meet(value: Any) -> None:
    lists = value if isinstance(value, list) else [None]
    if not value or not all(_is_list_of_planes(lines) for lines in lists):
        raise InputError(f"is {shown(value)}; give lists of three plane numbers or more")


def _check_closes(value: Any) -> None:
    if not isinstance(value, dict) or set(value) != {"meet", "then"}:
        raise InputError(f'is {shown(value)}; give "meet", lists of planes, and "then", one list')
    _check_meet(value["meet"])
    _check_meet([value["then"]])


def _is_list_of_planes(numbers: Any) -> bool:
    return (
        isinstance(numbers, list)
        and all(type(k) is int and 1 <= k <= budget.max_size("planes in the lab") for k in numbers)
        and len(set(numbers)) == len(numbers) >= 3
    )


def _with_names(most: int) -> Iterator[tuple[str, Arrangement]]:
    """Yield a member of each type that has a name: all up to six planes, then simplicial ones."""
    for m in range(3, NAMED_PLANES + 1):
        yield from ((f"{m}.{k}", arrangement) for k, arrangement in enumerate(census(m), 1))
    for m, k in simplicial_entries(rational=True):
        if NAMED_PLANES < m <= most:
            yield f"A({m},{k})", simplicial(m, k)


GOALS = {"counts": _check_counts, "meet": _check_meet, "closes": _check_closes}


#: Planes up to which all types have names.
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
_OWN = "arrangement.pictures.lab"
#: What counts: it knows nothing of pages.
_COUNTS = ("circles", "counts", "types", "document")
_SHOWS = ("cells", "words", "ball_view")
_LAB = ("charts", "state", "plane_view", "numbers", "moves", "drags", "planes", "goals", "page")
SCRIPTS: tuple[Template, ...] = (
    RATIONAL,
    VECTORS,
    *(("arrangement.drawing", f"{name}.js") for name in ("dual", "ball")),
    *((_OWN, f"{name}.js") for name in (*_COUNTS, *_SHOWS, *_LAB)),
)


def lab_page(
    arrangement: Arrangement | None = None,
    *,
    title: str | None = None,
    exercises: str | Path | None = None,
) -> str:
    """Build a self-contained HTML page: lines and great circles to drag, counted exactly.

    Args:
        arrangement: at first; central of rank at most 3, or lines of R^2, up to 20 planes. In
            other spaces the essentialisation is meant. If omitted, five lines.
        title: a heading.
        exercises: a JSON file with exercises; if omitted, those that come with the lab.

    Raises:
        InputError: too many planes or digits, another space, or no exercises in the file.
    """
    first = Arrangement(_FIRST) if arrangement is None else as_shown(arrangement)
    most = budget.max_size("planes in the lab")
    data: dict[str, Any] = {
        "title": "The arrangement lab" if title is None else title,
        "summary": "Drag lines and great circles; every number is exact.",
        "most": most,
        "arrangement": first.to_dict(),
        "examples": [
            {"name": name, "arrangement": read_arrangement(source).to_dict()}
            for name, source in _EXAMPLES
        ],
        "named": [
            [len(member), name, member.to_dict()["planes"]] for name, member in _with_names(most)
        ],
        "exercises": line_exercises(exercises),
        "own": exercises is not None,
    }
    styles: list[Template] = [(_OWN, "cells.css"), (_OWN, "page.css")]
    return lab(data["title"], (_OWN, "page.html"), styles, SCRIPTS, data)


def lab_in_notebook(arrangement: Arrangement) -> Any:
    """Return the page as `Arrangement.lab` does."""

    def planes(state: str) -> Arrangement:
        return read_start(state) if state else arrangement

    return lab_widget(lab_page(arrangement), {"arrangement": planes})
