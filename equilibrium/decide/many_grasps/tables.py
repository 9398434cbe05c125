"""Files of many grasps, of their loads and of the answers: CSV tables, or NPZ arrays of NumPy.

A CSV file of grasps has a contact a line, with the columns of `csv_file` and the column ``grasp``,
a name; without it the contacts are one grasp. A file of loads has a wrench a line: ``f_x``,
``f_y``, ``tau``, in space ``f_x``, ``f_y``, ``f_z``, ``tau_x``, ``tau_y``, ``tau_z``; with the
column ``grasp`` those of each grasp, else the same for all. Tables are text, and read as `csv_file`
reads them: 0.3 is 3/10 and 1/3 is 1/3. An NPZ file of grasps has the arrays that `check_grasps`
takes, by their names; its floats are the binary fractions that they are.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from arrangement.console.writing import write_bytes_atomically
from arrangement.library.files.json_files import read_text
from arrangement.numbers.exact import RationalVector, from_floats, rational, shown
from equilibrium.grasps.inputs.csv_file import Table, check_header, read_rows
from equilibrium.grasps.npz_file import BYTES, REQUIRED, is_npz, read_npz
from equilibrium.model.contact import VALUES, WRENCH_SIZES
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import ask_contacts, read_wrench
from equilibrium.model.labels import AS_ROUNDED

from .arrays import near_float, read_arrays, read_wrenches
from .check import ANSWERS, CheckedGrasps, Source, exact_grasp

_GRASP = "grasp"
#: Columns, by the numbers of a wrench.
_WRENCHES = {3: ("f_x", "f_y", "tau"), 6: ("f_x", "f_y", "f_z", "tau_x", "tau_y", "tau_z")}
#: Remarks on grasps that are printed.
_MOST_REMARKS = 3
#: The lines of each grasp by its name, with the numbers of the lines.
_Groups: TypeAlias = dict[str, list[tuple[int, dict[str, str]]]]


class ManyGrasps(NamedTuple):
    """What a file of many grasps has.

    Attributes:
        names: of the grasps.
        source: the grasps, or of an NPZ file its arrays.
        loads: of each grasp; None: those of the arrays, if these have some.
        rounded: whether normals of some grasp had to be rounded.
        remarks: on the pads and the adhesion of grasps.
    """

    names: list[str]
    source: Source
    loads: list[list[RationalVector]] | None = None
    rounded: bool = False
    remarks: tuple[str, ...] = ()

    @property
    def dimension(self) -> int:
        """Two in the plane, three in space."""
        if isinstance(self.source, list):
            return self.source[0].dimension if self.source else 2
        return int(self.source[0].shape[2])

    @property
    def has_loads(self) -> bool:
        """Whether there is a load for each grasp, or there are no grasps."""
        if self.loads is not None or isinstance(self.source, list):
            return self.loads is not None
        return bool(self.source[-1].shape[1])

    def notes(self) -> Iterator[str]:
        """Yield what the answers are about: rounded data, pads and adhesion of the first grasps."""
        if self.rounded:
            yield f"normals were rounded; answers are {AS_ROUNDED}"
        yield from self.remarks[:_MOST_REMARKS]
        if len(self.remarks) > _MOST_REMARKS:
            yield f"... and {len(self.remarks) - _MOST_REMARKS} more on pads and adhesion"

    def load(self, i: int, j: int) -> RationalVector | list[float]:
        """Return load j of grasp i, both from 0."""
        if self.loads is not None or isinstance(self.source, list):
            return (self.loads or [])[i][j]
        row: list[float] = self.source[-1][i, j].tolist()
        return row

    def with_loads(self, loads: Iterable[Iterable[Any]]) -> ManyGrasps:
        """Return the same grasps with the same loads for all."""
        listed = [read_wrench(load, self.dimension) for load in loads]
        return self._replace(loads=[listed] * len(self.names))

    def with_loads_of(self, path: str) -> ManyGrasps:
        """Return the same grasps with the loads of a file.

        Raises:
            InputError: the file cannot be read, or does not have loads for all grasps.
        """
        if is_npz(path):
            array = read_npz(path, ("wrenches",), ("wrenches",))["wrenches"]
            wrenches = read_wrenches(array, len(self.names), self.dimension)
            if not isinstance(self.source, list):
                return self._replace(source=(*self.source[:-1], wrenches), loads=None)
            return self._replace(loads=[list(from_floats(x.tolist())) for x in wrenches])
        groups = _groups(path, _check_wrenches)
        axes = _WRENCHES[6 if any("f_z" in rows[0][1] for rows in groups.values()) else 3]
        tables = {
            name: [
                read_wrench([_number(line, row[x], x) for x in axes], self.dimension)
                for line, row in rows
            ]
            for name, rows in groups.items()
        }
        if list(tables) == [""]:
            return self._replace(loads=[tables[""]] * len(self.names))
        if missing := [name for name in self.names if name not in tables]:
            raise GraspError(
                f"{path} has no loads of the grasp {shown(missing[0])}; expected some of each"
            )
        if unknown := [name for name in tables if name not in {*self.names}]:
            raise GraspError(f"{path} has loads of {shown(unknown[0])}; expected names of grasps")
        return self._replace(loads=[tables[name] for name in self.names])

    def with_preload(self, preload: Fraction) -> ManyGrasps:
        """Return the same grasps with one preload at every contact, exactly."""
        listed = self.source
        if not isinstance(listed, list):
            places, ways, *values, wrenches = listed
            near = near_float(preload)
            if math.isfinite(near) and Fraction(near) == preload:
                missing = np.isnan(places[..., 0])
                values[VALUES.index("preload")] = np.where(missing, np.nan, near)
                return self._replace(source=(places, ways, *values, wrenches))
            listed = [exact_grasp(listed, i) for i in range(len(self.names))]
            if self.loads is None:
                self = self._replace(loads=[list(from_floats(x.tolist())) for x in wrenches])
        return self._replace(source=[grasp.with_preload(preload) for grasp in listed])


def read_grasps(path: str) -> ManyGrasps:
    """Return the grasps of a file.

    Raises:
        InputError: the file cannot be read, or is no such table.
    """
    if is_npz(path):
        columns = read_npz(path, (*REQUIRED, *VALUES[1:], "wrenches"), REQUIRED)
        size = WRENCH_SIZES.get((columns["points"].shape or (0,))[-1], 3)
        values = {name: columns.get(name, int(name == "stiffness")) for name in VALUES}
        wrenches = columns.get("wrenches", np.zeros((0, size)))
        arrays = read_arrays(columns["points"], columns["normals"], values, wrenches)
        return ManyGrasps([str(i + 1) for i in range(len(arrays[0]))], arrays)
    groups = _groups(path, lambda header: check_header(header, (_GRASP,)))
    for rows in groups.values():
        ask_contacts(len(rows))
    conversions = {name: read_rows(rows) for name, rows in groups.items()}
    remarks = ((name, x) for name, conversion in conversions.items() for x in conversion.remarks)
    return ManyGrasps(
        list(conversions),
        [conversion.grasp for conversion in conversions.values()],
        rounded=not all(conversion.exact for conversion in conversions.values()),
        remarks=tuple(f"{f'grasp {shown(name)}: ' * bool(name)}{x}" for name, x in remarks),
    )


def _number(line: int, text: str, name: str) -> Fraction:
    try:
        return rational(text, name)
    except ValueError as error:
        raise GraspError(f"line {line}: {error}") from None


def _check_wrenches(header: list[str]) -> None:
    columns = [name for name in header if name != _GRASP]
    if sorted(columns) not in map(sorted, _WRENCHES.values()):
        raise GraspError(
            f"the columns are {', '.join(header)[:80]}; expected {', '.join(_WRENCHES[3])}, or in "
            f"space {', '.join(_WRENCHES[6])}, and {_GRASP} if grasps have loads of their own"
        )


def _groups(path: str, check: Any) -> _Groups:
    """Return the lines of a CSV file by their grasps, with their numbers."""
    groups: _Groups = {}
    for line, row in Table(read_text(Path(path), BYTES)[0]).rows(check):
        groups.setdefault(row.pop(_GRASP, ""), []).append((line, row))
    return groups


def answers_csv(many: ManyGrasps, checked: CheckedGrasps) -> str:
    """Return a line for each question: the grasp, the load, the answer, and how it was decided."""
    axes = _WRENCHES[WRENCH_SIZES[many.dimension]]
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow([_GRASP, "load", "answer", "decided", *axes])
    for i, name in enumerate(many.names):
        for j in np.flatnonzero(checked.asked[i]).tolist():
            way = "screened" if checked.screened[i, j] else "exact" if checked.exact[i, j] else ""
            yes = checked.resisted[i, j]
            answer = "undecided" if not way else "resisted" if yes else "not resisted"
            table.writerow([name or i + 1, j + 1, answer, way, *many.load(i, j)])
    return text.getvalue()


def answers_lists(checked: CheckedGrasps) -> dict[str, list[list[bool]]]:
    """Return the answers by their names, for each grasp those to its loads."""
    return {
        name: [row[own].tolist() for row, own in zip(answers, checked.asked, strict=True)]
        for name, answers in ((name, getattr(checked, name)) for name in ANSWERS)
    }


def write_answers(path: str, many: ManyGrasps, checked: CheckedGrasps) -> None:
    """Write answers to a CSV or an NPZ file, by the ending of its name."""
    if is_npz(path):
        content = io.BytesIO()
        arrays = {name: getattr(checked, name) for name in ANSWERS}
        np.savez_compressed(content, grasp=np.array(many.names), **arrays)
        write_bytes_atomically(path, content.getvalue())
    else:
        write_bytes_atomically(path, answers_csv(many, checked).encode())
