"""The float arrays of many grasps and loads, strictly read."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np

from arrangement.numbers.exact import RationalVector, shown
from arrangement.numbers.float_filter import EXACT, Booleans, Floats
from equilibrium.model.contact import VALUES, WRENCH_SIZES
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp

#: Points, normals, the values of contacts, wrenches; see `check_grasps`.
Arrays: TypeAlias = tuple[Floats, ...]
#: Floats below this have fewer digits.
_SMALLEST = 2.0**-1000


def exact_floats(values: Any, name: str, form: str, remedy: str) -> Floats:
    """Return an array as floats that have its values exactly; NaN and infinities stay.

    Args:
        form: what it should be; remedy: what takes other numbers.
    """
    rows = values if isinstance(values, list | tuple) else [values]
    if any(map(np.ma.is_masked, rows)):
        raise GraspError(f"{name} has masked entries; leave these out, or fill them")
    try:
        array = np.asarray(values)
    except ValueError:
        raise GraspError(f"{name} has rows of different lengths; give {form}") from None
    if array.dtype.kind not in "iuf":
        raise GraspError(
            f"{name} is an array of {array.dtype}; give real numbers of numpy, or {remedy} about "
            "exact ones"
        )
    with np.errstate(over="ignore", invalid="ignore"):
        floats = array.astype(np.float64)
        kept = floats.astype(array.dtype) == array
    # Integers as large may turn back into themselves by overflow.
    if array.dtype.kind == "f":
        kept |= np.isnan(array)
    else:
        kept &= np.abs(floats) <= EXACT
    if not kept.all():
        first = array[~kept][0]
        raise GraspError(
            f"{name} has {shown(first.item())}, which floats round; give what they hold, or "
            f"{remedy}"
        )
    return floats


def read_arrays(points: Any, normals: Any, values: Mapping[str, Any], wrenches: Any) -> Arrays:
    """Return the arrays in full, all of floats; missing contacts have NaN in all.

    Args:
        values: of contacts, by the names `VALUES`.
    """
    remedy = "ask `equilibrium.solve`"
    places = exact_floats(points, "points", "(G, m, 2) or (G, m, 3) numbers", remedy)
    if places.ndim not in (2, 3) or places.shape[-1] not in WRENCH_SIZES:
        raise GraspError(
            f"points is an array {places.shape}; expected (G, m, 2) or (G, m, 3), of one grasp "
            "(m, 2) or (m, 3)"
        )
    ways = exact_floats(normals, "normals", f"numbers like points, {places.shape}", remedy)
    if ways.shape != places.shape:
        raise GraspError(f"normals is an array {ways.shape}; expected {places.shape}, as points is")
    places, ways = (x[None] if x.ndim == 2 else x for x in (places, ways))
    count, size = len(places), WRENCH_SIZES[places.shape[2]]
    loads = read_wrenches(wrenches, count, places.shape[2])
    missing: Booleans = np.all(np.isnan(places), axis=2)
    columns = [
        _column(
            values[name],
            name,
            missing,
            "above 0 in space" if name == "stiffness" and size == 6 else "at least 0",
        )
        for name in VALUES
    ]
    absent = missing[..., None]
    _all(
        absent | np.isfinite(places), "points", places, "a finite number, or NaN in all of a point"
    )
    _all(absent | np.isfinite(ways), "normals", ways, "a finite number")
    _all(missing | np.any(ways != 0, axis=2), "normals", ways, "a direction other than 0")
    return places, ways, *columns, loads


def read_wrenches(wrenches: Any, count: int, dimension: int) -> Floats:
    """Return the loads of grasps as an array (G, w, 3), in space (G, w, 6)."""
    size, remedy = WRENCH_SIZES[dimension], "ask `equilibrium.solve`"
    loads = exact_floats(wrenches, "wrenches", f"({count}, w, {size}) numbers", remedy)
    if loads.shape[-1:] != (size,) or loads.ndim == 1 or loads.shape[:-2] not in ((), (count,)):
        raise GraspError(
            f"wrenches is an array {loads.shape}; expected ({count}, w, {size}), or (w, {size}) "
            "for the same loads on all grasps"
        )
    loads = np.broadcast_to(loads, (count, *loads.shape[-2:]))
    _all(np.isfinite(loads), "wrenches", loads, "a finite number")
    return loads


def near_floats(
    grasps: Sequence[Grasp], loads: Sequence[Sequence[RationalVector]], dimension: int | None = None
) -> tuple[Arrays, bool]:
    """Return exact grasps and loads as the nearest floats, and whether any of them is another one.

    The loads have the wrench of the adhesion in them, and there is no adhesion then. What is
    missing is NaN, and infinite what floats do not have about as exactly as others.
    """
    if dimension is None:
        dimension = next((grasp.dimension for grasp in grasps if len(grasp)), 2)
    rounded = False

    def filled(rows: Iterable[Sequence[Sequence[Fraction]]], size: int) -> Floats:
        nonlocal rounded
        rows = list(rows)
        table = np.full((len(rows), max(map(len, rows), default=0), size), np.nan)
        for i, row in enumerate(rows):
            if i and row is rows[i - 1]:  # the same loads
                table[i] = table[i - 1]
                continue
            for j, numbers in enumerate(row):
                table[i, j] = near = list(map(near_float, numbers))
                pairs = zip(near, numbers, strict=True)
                rounded |= any(not math.isfinite(x) or Fraction(x) != y for x, y in pairs)
        return table

    contacts = filled(
        (
            [(*c.point, *c.normal, c.friction, c.stiffness, c.preload, Fraction(0)) for c in grasp]
            for grasp in grasps
        ),
        2 * dimension + len(VALUES),
    )
    wrenches = filled(
        (
            [grasp.total_load(load) for load in own] if any(c.adhesion for c in grasp) else own
            for grasp, own in zip(grasps, loads, strict=True)
        ),
        WRENCH_SIZES[dimension],
    )
    points, normals, values = np.split(contacts, [dimension, 2 * dimension], axis=2)
    points[np.isinf(normals).any(axis=2)] = np.inf
    return (points, normals, *np.moveaxis(values, 2, 0), wrenches), rounded


def near_float(value: Fraction) -> float:
    """Return the nearest float, which is off by half a unit of its last digit; else infinity."""
    try:
        rounded = float(value)
    except OverflowError:
        return math.inf
    return rounded if not value or abs(rounded) > _SMALLEST else math.inf


def _column(value: Any, name: str, missing: Booleans, least: str) -> Floats:
    floats = exact_floats(value, name, "one number, or (G, m)", "ask `equilibrium.solve`")
    try:
        column = np.where(missing, np.nan, np.broadcast_to(floats, missing.shape))
    except ValueError:
        raise GraspError(
            f"{name} is an array {floats.shape}; expected a number, or what NumPy broadcasts to "
            f"{missing.shape}: one for each contact"
        ) from None
    enough = column > 0 if least.startswith("above") else column >= 0
    _all(missing | (enough & np.isfinite(column)), name, column, f"a finite number {least}")
    return column


def _all(valid: Booleans, name: str, array: Floats, rule: str) -> None:
    """Raise the error of the first entry that is not valid."""
    if not valid.all():
        at = tuple(np.argwhere(~valid)[0].tolist())
        value = array[at].tolist()
        raise GraspError(f"{name}[{', '.join(map(str, at))}] is {value}; expected {rule}")
