"""polymake's data files (JSON, from release 4.0 on) of ``fan::HyperplaneArrangement<Rational>``.

Rows of HYPERPLANES are linear forms. An affine arrangement is its cone without infinity, cut by the
support ``x_0 >= 0``, with the constant first, as everywhere in polymake.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.form import json_object, rational_planes
from arrangement.library.files.json_files import check_list, kind_of
from arrangement.numbers.exact import rational, shown

_TYPE = "fan::HyperplaneArrangement"
_NAMESPACE = {"polymake": ["https://polymake.org", "4.0"]}


def read(text: str) -> Arrangement:
    """Read an object of the type HyperplaneArrangement."""
    data = json_object(text)
    kind = str(data.get("_type"))
    if not kind.startswith(_TYPE):
        raise InputError(f"the object is a {shown(kind)}; a {_TYPE} is read")
    if kind.partition("<")[2] not in ("", "Rational>"):
        raise InputError(f"the object is a {shown(kind)}; entries in Rational are read")
    rows = _matrix(data, "HYPERPLANES")
    if not rows:
        size = data.get("HYPERPLANE_AMBIENT_DIM")
        if not isinstance(size, int):
            raise InputError("the object has no HYPERPLANES; save it with that property")
        return Arrangement([], dimension=size)
    if not _is_half_space(data.get("SUPPORT", {})):
        return Arrangement(rows)
    offsets = [-rational(row[0], "HYPERPLANES") for row in rows]
    return Arrangement([row[1:] for row in rows], offsets)


def _matrix(data: Mapping[str, Any], key: str) -> list[list[Any]]:
    """Return the rows of a dense or sparse matrix; the number of columns may stand last."""
    rows = check_list(data.get(key, []), key)
    ends = bool(rows) and isinstance(rows[-1], Mapping) and set(rows[-1]) == {"cols"}
    columns = rows.pop()["cols"] if ends else None
    dense = []
    for row in rows:
        if isinstance(row, Mapping):
            size = row.get("_dim", columns)
            places = range(size if isinstance(size, int) and size <= 10**4 else 0)
            if not set(row) <= {"_dim", *map(str, places)}:
                raise InputError(f"the row {shown(dict(row))} of {key} has no known length")
            dense.append([row.get(str(place), 0) for place in places])
        else:
            dense.append(check_list(row, f"a row of {key}"))
    if not all(dense):
        raise InputError(f"{key} has a row without entries")
    return dense


def _is_half_space(support: Any) -> bool:
    """Whether the support is ``x_0 >= 0``, and not the whole space."""
    if not isinstance(support, Mapping):
        raise InputError(f"SUPPORT is {kind_of(support)}; expected a cone")
    cuts = [row for key in ("INEQUALITIES", "FACETS") for row in _matrix(support, key)]
    equations = [row for key in ("EQUATIONS", "LINEAR_SPAN") for row in _matrix(support, key)]
    numbers = [[rational(x, "SUPPORT") for x in row] for row in cuts]
    is_told = not support or "INEQUALITIES" in support or "FACETS" in support
    if not is_told or equations or not all(row[0] > 0 and not any(row[1:]) for row in numbers):
        raise InputError(
            "SUPPORT is a cone that cuts the arrangement; the whole space and x_0 >= 0 are read"
        )
    return bool(cuts)


def write(arrangement: Arrangement) -> str:
    """Write an object of the type HyperplaneArrangement."""
    planes = rational_planes(arrangement)
    data: dict[str, Any] = {"_ns": _NAMESPACE, "_type": f"{_TYPE}<Rational>"}
    if arrangement.is_central:
        rows = [plane[:-1] for plane in planes]
    else:
        rows = [(-plane[-1], *plane[:-1]) for plane in planes]
        bound = ["1"] + ["0"] * arrangement.dimension
        data["SUPPORT"] = {"INEQUALITIES": [bound]}
    data["HYPERPLANE_AMBIENT_DIM"] = arrangement.dimension + (not arrangement.is_central)
    data["HYPERPLANES"] = [[str(x) for x in row] for row in rows]
    return json.dumps(data) + "\n"
