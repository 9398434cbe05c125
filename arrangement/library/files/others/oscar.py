"""OSCAR's mrdi files, with a matrix over QQ or ZZ whose rows are the normals.

OSCAR has no type for arrangements: `polymake` files are loaded there as objects of polymake.
"""

from __future__ import annotations

import json
import uuid

from arrangement.arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library.files.form import json_object, rational_planes
from arrangement.library.files.json_files import check_list

_ADDRESS = "https://github.com/oscar-system/Oscar.jl"
_VERSION = "1.8.2"
_RINGS = ('"QQField"', '"ZZRing"')


def read(text: str) -> Arrangement:
    """Read a matrix of normals."""
    data = json_object(text)
    kind = json.dumps([data.get("_type"), data.get("_refs")])
    if '"MatElem"' not in kind:
        raise InputError("the object is no matrix; save the matrix of normals")
    if not any(ring in kind for ring in _RINGS):
        raise InputError("the matrix is not over QQ or ZZ")
    rows = [check_list(row, "a row") for row in check_list(data.get("data"), "data")]
    return Arrangement([[str(x).replace("//", "/") for x in row] for row in rows])


def write(arrangement: Arrangement) -> str:
    """Write the matrix of normals of a central arrangement."""
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
