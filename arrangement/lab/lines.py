"""The arrangement lab: one page in which lines and great circles are dragged and counted at once.

The page counts by itself, in integers: it shares nothing with the enumerators and the counts here
but the form of files. Of the census it knows representatives; it tells types apart by a canonical
form of its own.
"""

from __future__ import annotations

from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.counts import essentialization
from arrangement.draw.html_page import Template
from arrangement.errors import InputError
from arrangement.exact import rational, shown
from arrangement.io.arrangements import read_arrangement
from arrangement.library.census import census

from .exercises import read_exercises
from .page import lab

#: Planes beyond which dragging stutters.
MAX_PLANES = 20
#: Longest numbers that the page reads.
MAX_DIGITS = 1000
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
#: What the command line prints and `lab.count` returns, as far as goals may ask for it.
_COUNTS = frozenset(
    "planes distinct_planes dimension rank f_vector regions bounded_regions t_vector p_vector "
    "characteristic_polynomial simple simplicial triangles type".split()
)
_OWN = "arrangement.lab"
_COUNTS_SCRIPTS = ("circles", "counts", "types", "document")
_SHOWS = ("words", "charts", "state", "plane_view", "ball_view", "numbers", "moves", "drags")
_SCRIPTS: tuple[Template, ...] = (
    ("arrangement.draw", "ball.js"),
    *((_OWN, f"lines/{name}.js") for name in (*_COUNTS_SCRIPTS, *_SHOWS, "planes", "goals", "page")),
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
        exercises: a file of exercises that come after the built-in ones; see `read_exercises`. A
            goal is ``{"counts": {...}}`` with values of `lab.count`, ``{"meet": [[1, 2, 3]]}`` for
            lines that go through a point, or ``{"closes": {"meet": [...], "then": [...]}}``.

    Raises:
        InputError: too many planes or digits, another space, or no exercises.
    """
    first = Arrangement(_FIRST) if arrangement is None else _shown(arrangement)
    data: dict[str, Any] = {
        "title": "The arrangement lab" if title is None else title,
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
        "exercises": [*_built_in(), *([] if exercises is None else _read(exercises))],
    }
    styles: list[Template] = [(_OWN, "lines/page.css")]
    return lab(data["title"], (_OWN, "lines/page.html"), styles, _SCRIPTS, data)


def _shown(arrangement: Arrangement) -> Arrangement:
    """Return planes as the page has them: lines of R^2, or central planes of R^3.

    Raises:
        InputError: there is no such form, or it is too large.
    """
    shown_planes = arrangement
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
        shown_planes = _padded(essentialization(arrangement), 2 if flat else 3)
    if len(shown_planes) > MAX_PLANES:
        raise InputError(f"{len(shown_planes)} planes; the lab takes at most {MAX_PLANES}")
    longest = max((len(str(abs(x))) for plane in shown_planes.integer_planes for x in plane), default=1)
    if longest > MAX_DIGITS:
        raise InputError(f"a number has {longest} digits; the lab takes at most {MAX_DIGITS}")
    return shown_planes


def _padded(planes: Any, dimension: int) -> Arrangement:
    zeros = (0,) * (dimension - planes.dimension)
    rows = [(*normal, *zeros) for normal in planes.normals]
    return Arrangement(rows, planes.offsets, dimension=dimension)


def _built_in() -> list[dict[str, Any]]:
    with as_file(files(_OWN) / "templates" / "lines" / "exercises.json") as path:
        return _read(path)


def _read(path: str | Path) -> list[dict[str, Any]]:
    goals = {"counts": _check_counts, "meet": _check_meet, "closes": _check_closes}
    found = read_exercises(path, goals)
    for number, exercise in enumerate(found, 1):
        try:
            planes = _from_link(exercise["start"])
        except InputError as error:
            raise InputError(f"exercise {number}: start: {error}") from None
        for name in exercise["fixed"]:
            if name not in map(str, range(1, planes + 1)):
                raise InputError(f"exercise {number}: fixed has {shown(name)}; name a plane by its number")
    return found


def _from_link(text: str) -> int:
    """Return the number of planes of a link such as ``1|3|1,0,0;0,1,0``.

    Raises:
        InputError: it is no such link.
    """
    version, *parts = text.split("|")
    if version != "1" or len(parts) != 2 or parts[0] not in ("2", "3"):
        raise InputError(f"{shown(text)} is no link; copy one from the page, from behind the #")
    rows = [[rational(x) for x in row.split(",")] for row in parts[1].split(";") if row]
    if any(len(row) != 3 for row in rows):
        raise InputError(f"each plane of {shown(text)} needs three numbers")
    _shown(Arrangement([row[: int(parts[0])] for row in rows], dimension=int(parts[0])))
    return len(rows)


def _check_counts(value: Any) -> None:
    unknown = sorted(set(value) - _COUNTS) if isinstance(value, dict) else ["no object"]
    if unknown or not value:
        raise InputError(f"has {shown(unknown)}; give values of: {', '.join(sorted(_COUNTS))}")


def _check_meet(value: Any) -> None:
    lists = value if isinstance(value, list) else [None]
    if not value or not all(_is_list_of_planes(one) for one in lists):
        raise InputError(f"is {shown(value)}; give lists of three plane numbers or more")


def _check_closes(value: Any) -> None:
    if not isinstance(value, dict) or set(value) != {"meet", "then"}:
        raise InputError(f'is {shown(value)}; give "meet", lists of planes, and "then", one list')
    _check_meet(value["meet"])
    _check_meet([value["then"]])


def _is_list_of_planes(one: Any) -> bool:
    return (
        isinstance(one, list)
        and len(set(map(str, one))) == len(one) >= 3
        and all(type(k) is int and 1 <= k <= MAX_PLANES for k in one)
    )
