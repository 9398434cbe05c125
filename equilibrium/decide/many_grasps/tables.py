"""Files of many grasps, of their loads and of the answers: CSV tables, or NPZ arrays of NumPy.

A CSV file of grasps has a contact a line, with the columns of `csv_file` and the column ``grasp``,
a name; without it the contacts are one grasp. A file of loads has a wrench a line: ``f_x``,
``f_y``, ``tau``, in space ``f_x``, ``f_y``, ``f_z``, ``tau_x``, ``tau_y``, ``tau_z``; with the
column ``grasp`` those of each grasp, as many of each, else the same for all. An NPZ file of grasps
has the arrays that `check_grasps` takes, by their names. Numbers are read as the nearest floats.
"""

from __future__ import annotations

import csv
import io
import os
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from arrangement.console.writing import write_bytes_atomically
from arrangement.library.files.json_files import read_bytes, read_text
from arrangement.numbers import budget
from arrangement.numbers.exact import rational, shown
from arrangement.numbers.float_filter import Floats
from equilibrium.grasps.inputs.csv_file import check_header, table_rows
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError

from .check import CheckedGrasps

_GRASP = "grasp"
_AXES = ("x", "y", "z")
_KIND = "bytes of many grasps"
#: Arrays of answers, by the names of `CheckedGrasps`.
ANSWERS = ("resisted", "screened", "exact", "undecided")
#: Columns, by the numbers of a wrench.
_WRENCHES = {
    3: ("f_x", "f_y", "tau"),
    6: (*(f"f_{x}" for x in _AXES), *(f"tau_{x}" for x in _AXES)),
}
_REQUIRED = ("points", "normals", VALUES[0])
#: The lines of each grasp, by its name.
_Groups: TypeAlias = dict[str, list[Mapping[str, str]]]


def is_npz(path: str | os.PathLike[str]) -> bool:
    """Return whether a path is that of an NPZ file."""
    return os.fspath(path).lower().endswith(".npz")


def read_grasps(path: str) -> tuple[list[str], dict[str, Any]]:
    """Return names of the grasps of a file, and arrays for `check_grasps`.

    Raises:
        InputError: the file cannot be read, or is no such table.
    """
    if is_npz(path):
        arrays = _read_arrays(path, (*_REQUIRED, *VALUES[1:], "wrenches"), _REQUIRED)
        points = arrays["points"]
        return [str(i) for i in range(1, 1 + (len(points) if points.ndim else 0))], arrays
    groups = _groups(path, lambda header: check_header(header, (_GRASP,)))
    first = next((rows[0] for rows in groups.values()), {})
    axes = _AXES[: 3 if "z" in first else 2]
    columns = {
        "points": axes,
        "normals": [f"normal_{x}" for x in axes],
        **{name: [name] for name in VALUES if name in first},
    }
    most = max(map(len, groups.values()), default=0)
    found = {k: np.full((len(groups), most, len(names)), np.nan) for k, names in columns.items()}
    for i, rows in enumerate(groups.values()):
        for key, names in columns.items():
            found[key][i, : len(rows)] = [[float(row[name]) for name in names] for row in rows]
    return list(groups), {k: x[..., 0] if k in VALUES else x for k, x in found.items()}


def read_loads(path: str, names: Sequence[str]) -> Floats:
    """Return the loads of a file: (w, k) for all grasps, or (G, w, k)."""
    if is_npz(path):
        loads: Floats = _read_arrays(path, ("wrenches",), ("wrenches",))["wrenches"]
        return loads
    groups = _groups(path, _check_wrenches)
    axes = _WRENCHES[6 if any("f_z" in rows[0] for rows in groups.values()) else 3]
    tables = {
        name: [[float(row[axis]) for axis in axes] for row in rows] for name, rows in groups.items()
    }
    if list(tables) == [""]:
        return np.array(tables[""])
    for name in names:
        if len(tables.get(name, ())) != len(tables.get(names[0], ())):
            raise GraspError(
                f"{path} has {len(tables.get(name, ()))} loads of the grasp {shown(name)}; "
                "expected as many of each grasp"
            )
    if unknown := [name for name in tables if name not in set(names)]:
        raise GraspError(f"{path} has loads of {shown(unknown[0])}; expected names of grasps")
    return np.array([tables[name] for name in names])


def _check_wrenches(header: list[str]) -> None:
    columns = [name for name in header if name != _GRASP]
    if sorted(columns) not in map(sorted, _WRENCHES.values()):
        raise GraspError(
            f"the columns are {', '.join(header)[:80]}; expected {', '.join(_WRENCHES[3])}, or in "
            f"space {', '.join(_WRENCHES[6])}, and {_GRASP} if grasps have loads of their own"
        )


def _groups(path: str, check: Any) -> _Groups:
    """Return the lines of a CSV file by their grasps, numbers as decimals of floats."""
    groups: _Groups = {}
    for line, row in table_rows(read_text(Path(path), _KIND)[0], check):
        name = row.pop(_GRASP, "")
        for key, entry in row.items():
            try:
                float(entry)
            except ValueError:
                # Fractions, such as 1/3; anything else is an error.
                try:
                    row[key] = repr(float(rational(entry, key)))
                except (ValueError, OverflowError) as error:
                    raise GraspError(f"line {line}: {error}") from None
        groups.setdefault(name, []).append(row)
    return groups


def _read_arrays(path: str, known: Sequence[str], required: Sequence[str]) -> dict[str, Any]:
    """Return the arrays of an NPZ file; nothing in it is run."""
    content = io.BytesIO(read_bytes(Path(path), shown(path), _KIND))
    try:
        with zipfile.ZipFile(content) as archive:
            budget.check_size(sum(x.file_size for x in archive.infolist()), _KIND, path)
        with np.load(content, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
    except (OverflowError, MemoryError):
        raise GraspError(f"{path} is damaged: an array claims more than is in the file") from None
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise GraspError(f"{path} is not an NPZ file of arrays: {error}") from None
    if missing := [name for name in required if name not in arrays]:
        raise GraspError(f"{path} has no array {missing[0]}; expected {', '.join(required)}")
    if unknown := [name for name in arrays if name not in known]:
        raise GraspError(f"{path} has the array {shown(unknown[0])}; expected {', '.join(known)}")
    return arrays


def answers_csv(names: Sequence[str], checked: CheckedGrasps) -> str:
    """Return a line for each question: the grasp, the load, the answer, and how it was decided."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow([_GRASP, "load", "answer", "decided"])
    for i, name in enumerate(names):
        for j, resisted in enumerate(checked.resisted[i].tolist()):
            way = "screened" if checked.screened[i, j] else "exact" if checked.exact[i, j] else ""
            answer = "undecided" if not way else "resisted" if resisted else "not resisted"
            table.writerow([name, j + 1, answer, way])
    return text.getvalue()


def write_answers(path: str, names: Sequence[str], checked: CheckedGrasps) -> None:
    """Write answers to a CSV or an NPZ file, by the ending of its name."""
    if is_npz(path):
        content = io.BytesIO()
        arrays = {name: getattr(checked, name) for name in ANSWERS}
        np.savez_compressed(content, grasp=np.array(names), **arrays)
        write_bytes_atomically(path, content.getvalue())
    else:
        write_bytes_atomically(path, answers_csv(names, checked).encode())
