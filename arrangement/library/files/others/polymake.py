"""polymake's data files (JSON, from release 4.0 on) of ``fan::HyperplaneArrangement<Rational>``.

Rows of HYPERPLANES are linear forms. An affine arrangement is its cone without infinity, cut by the
support ``x_0 >= 0``, with the constant first, as everywhere in polymake.

OSCAR's mrdi files have a matrix over QQ or ZZ whose rows are the normals: OSCAR has no type for
arrangements. Files of polymake are loaded there as objects of polymake.
"""

from __future__ import annotations

import json
import re
import uuid
from collections.abc import Mapping
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.documents import json_object, rational_planes
from arrangement.library.files.json_files import check_list, kind_of
from arrangement.numbers.exact import rational, shown

_TYPE = "fan::HyperplaneArrangement"
#: JSON with the namespace of a program, or a script of polymake.
OSCAR = re.compile(r'(?s)\s*\{(?=.*"_ns")(?=.*"Oscar")')
RECOGNISED = re.compile(
    r'(?s)\s*\{(?=.*"_ns")(?=.*"polymake")|(?!\s*\{).*\bnew\s+(?:fan::)?HyperplaneArrangement\b'
)
_NAMESPACE = {"polymake": ["https://polymake.org", "4.0"]}


def read(text: str) -> Arrangement:
    """Read an object of the type HyperplaneArrangement."""
    if not text.lstrip().startswith("{"):
        raise InputError(
            'a script is not run; write save($H, "FILE.hyar"); at its end, run it in polymake, and '
            "give FILE.hyar; or write the rows of HYPERPLANES into a file, one a line"
        )
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
    """Return whether the support is ``x_0 >= 0``, and not the whole space."""
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


_ADDRESS = "https://github.com/oscar-system/Oscar.jl"
_VERSION = "1.8.2"
_RINGS = ('"QQField"', '"ZZRing"')


def read_oscar(text: str) -> Arrangement:
    """Read a matrix of normals from an mrdi file of OSCAR."""
    data = json_object(text)
    kind = json.dumps([data.get("_type"), data.get("_refs")])
    if '"MatElem"' not in kind:
        raise InputError("the object is not a matrix; save the matrix of normals")
    if not any(ring in kind for ring in _RINGS):
        raise InputError("the matrix is not over QQ or ZZ")
    rows = [check_list(row, "a row") for row in check_list(data.get("data"), "data")]
    return Arrangement([[str(x).replace("//", "/") for x in row] for row in rows])


def write_oscar(arrangement: Arrangement) -> str:
    """Write the matrix of normals of a central arrangement as an mrdi file of OSCAR."""
    planes = rational_planes(arrangement)
    if not arrangement.is_central or not planes:
        raise InputError(
            "a matrix of normals has no offsets, and needs a row; write polymake, which OSCAR loads"
        )
    rows = [[str(x) for x in plane[:-1]] for plane in planes]
    space = str(uuid.uuid5(uuid.NAMESPACE_URL, f"{_ADDRESS}/{len(rows)}/{len(rows[0])}"))
    size = {"ncols": str(len(rows[0])), "nrows": str(len(rows))}
    data = {
        "_ns": {"Oscar": [_ADDRESS, _VERSION]},
        "_type": {"name": "MatElem", "params": space},
        "data": rows,
        "_refs": {
            space: {"_type": {"name": "MatSpace", "params": {"_type": "QQField"}}, "data": size}
        },
    }
    return json.dumps(data) + "\n"
