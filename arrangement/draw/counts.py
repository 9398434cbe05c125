"""Exact numbers of faces against the published bounds, over the number of planes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from arrangement.arrangement import Arrangement
from arrangement.counts import f_vector, fukuda_bound
from arrangement.errors import InputError
from arrangement.exact import shown
from arrangement.library.families import braid, generic, near_pencil, pencil, type_b

from .measuring import checked_width
from .output import require_matplotlib

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What is counted of central planes in general position in R^3: name, formula, dimension of the
#: faces (None: all faces), colour, marker.
_SERIES: tuple[tuple[str, Callable[[int], int], int | None, str, str], ...] = (
    ("states  4m² − 4m + 3", lambda m: 4 * m * m - 4 * m + 3, None, "#332288", "D"),
    ("facets  2m(m − 1)", lambda m: 2 * m * (m - 1), 2, "#117733", "s"),
    ("regions  m² − m + 2", lambda m: m * m - m + 2, 3, "#cc6677", "o"),
    ("rays  m(m − 1)", lambda m: m * (m - 1), 1, "#882255", "^"),
)
#: Families: name, planes for m, least m, marker, filled.
_FAMILIES: tuple[tuple[str, Callable[[int], Arrangement], int, str, bool], ...] = (
    ("general position", generic, 1, "o", True),
    ("near-pencil", near_pencil, 3, "s", False),
    ("pencil", pencil, 1, "^", False),
)


def check_largest(largest: int) -> None:
    """Refuse a number of planes that is out of range."""
    if type(largest) is not int or not 4 <= largest <= 30:
        raise InputError(f"the largest m is {shown(largest)}; give an integer from 4 to 30")


def counts_table(largest: int) -> list[dict[str, int]]:
    """Return, for 1 to `largest` central planes in general position in R^3, counts and bounds.

    Rays, facets, regions and states (all faces) by Zaslavsky's theorem; the printed formulas of
    regions and states; the bound of Fukuda and others on the regions of as many planes in R^3.
    """
    return [
        {
            "m": m,
            **dict(zip(("rays", "facets", "regions"), f[1:], strict=True)),
            "states": sum(f),
            "printed_regions": m * m - m + 2,
            "printed_states": 4 * m * m - 4 * m + 3,
            "bound": fukuda_bound(m, 3, 3),
        }
        for m in range(1, largest + 1)
        for f in [f_vector(generic(m))]
    ]


def draw_counts(*, largest: int = 12, width: float = 180.0) -> Figure:
    """Draw numbers of faces over the number m of planes, with the bounds that the paper states.

    First panel: rays, facets, regions and all slip states of m central planes in general position
    in R^3, counted by Zaslavsky's theorem (marks), on the printed formulas (lines), and the bound
    of Fukuda and others on regions and on all faces of m planes in R^3, through the origin or not
    (dashed). The formulas hold from m = 3 on; for fewer planes the rank is smaller. Second panel:
    regions of named families against the bound m^2 - m + 2.

    Elements: the marks of each series and family have the names ``generic-states`` and
    ``family-pencil`` and so on.

    Args:
        largest: the largest m, from 4 to 30.
        width: of the figure, in millimetres; below 120 the panels stand one above the other.

    Raises:
        InputError: `largest` or `width` out of range.
        MissingExtraError: matplotlib is absent.
    """
    check_largest(largest)
    width = checked_width(width, 60.0)
    require_matplotlib()
    from matplotlib.figure import Figure

    beside = width >= 120
    height = 76.0 if beside else 148.0
    figure = Figure(figsize=(width / 25.4, height / 25.4), dpi=300)
    w, h = (width / 2, height) if beside else (width, height / 2)
    boxes = [(13.0, height - h + 9.5), (w + 13.0, 9.5) if beside else (13.0, 9.5)]
    panels = [
        figure.add_axes((x / width, y / height, (w - 16.0) / width, (h - 14.0) / height))
        for x, y in boxes
    ]
    _generic(panels[0], largest)
    _families(panels[1], largest)
    for axes, title in zip(panels, ("general position", "regions of families"), strict=True):
        axes.set_title(title, fontsize=7.5, loc="left", pad=3)
        axes.set_xlabel("number of planes m", fontsize=7, labelpad=2)
        axes.tick_params(labelsize=6.5, width=0.5, length=2.5, which="major")
        axes.set_xlim(0.5, largest + 0.5)
        axes.set_xticks(range(1, largest + 1, 1 if largest <= 15 else 2))
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(
            fontsize=6, frameon=False, loc="upper left", handlelength=2.2, labelspacing=0.35
        )
    return figure


def _generic(axes: Any, largest: int) -> None:
    numbers = range(1, largest + 1)
    vectors = [f_vector(generic(m)) for m in numbers]
    every = [sum(fukuda_bound(m, 3, k) for k in range(4)) for m in numbers]
    dashed = {"color": "0.35", "lw": 0.8}
    axes.plot(numbers, every, ls=(0, (5, 2)), label="bound on all faces, any planes", **dashed)
    for label, formula, k, colour, marker in _SERIES:
        found = [sum(v) if k is None else v[k] for v in vectors]
        printed = [formula(m) for m in numbers]
        axes.plot(numbers[2:], printed[2:], color=colour, lw=0.8)
        axes.plot(
            numbers, found, color=colour, marker=marker, ls="none", ms=3.4, mew=0.6, mec="black",
            label=label, gid=f"generic-{label.split()[0]}",
        )  # fmt: skip
    bound = [fukuda_bound(m, 3, 3) for m in numbers]
    axes.plot(numbers, bound, ls=(0, (1.5, 1.5)), label="bound on regions, any planes", **dashed)
    axes.set_yscale("symlog", linthresh=1, linscale=0.4)
    axes.set_ylim(-0.1, every[-1] * 30)
    axes.set_yticks([0, 1, 10, 100, 1000, 10000][: 2 + len(str(every[-1]))])
    axes.set_yticklabels([str(t) for t in axes.get_yticks().astype(int)])
    axes.minorticks_off()


def _families(axes: Any, largest: int) -> None:
    numbers = range(1, largest + 1)
    axes.plot(
        numbers, [m * m - m + 2 for m in numbers], color="#cc6677", lw=0.8, label="bound m² − m + 2"
    )
    for name, family, least, marker, filled in _FAMILIES:
        over = range(least, largest + 1)
        axes.plot(
            over, [f_vector(family(m))[3] for m in over], ls="none", marker=marker, ms=3.6, mew=0.7,
            mec="black", mfc="#cc6677" if filled else "white", label=name,
            gid=f"family-{name.replace(' ', '-')}",
        )  # fmt: skip
    mirrors = [planes for planes in (braid(4), type_b(3)) if len(planes) <= largest]
    axes.plot(
        [len(planes) for planes in mirrors], [f_vector(planes)[-1] for planes in mirrors],
        ls="none", marker="*", ms=6.5, mfc="#88ccee", mec="black", mew=0.6,
        label="mirrors of A₃ and B₃", gid="family-reflection",
    )  # fmt: skip
    if largest > 15:
        axes.set_yscale("log")
        axes.set_ylim(1, largest**3)
        axes.minorticks_off()
    else:
        axes.set_ylim(0, (largest * largest - largest + 2) * 1.05)
