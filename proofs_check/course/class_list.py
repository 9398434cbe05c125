"""A class as a CSV file: the students in its order, and their results as a gradebook takes them."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from arrangement.errors import InputError
from arrangement.library.files.json_files import read_text
from arrangement.numbers.exact import shown


@dataclass(frozen=True)
class ClassList:
    """The rows of a class.

    Attributes:
        columns: the first line.
        rows: of a student each, whose first entry is the name of the file of answers.
        delimiter: between entries, a comma or a semicolon.
    """

    columns: Sequence[str] = ("name",)
    rows: Sequence[Sequence[str]] = ()
    delimiter: str = ","

    @classmethod
    def of(cls, names: Iterable[str]) -> ClassList:
        """Return the class of all files of a folder."""
        return cls(rows=[[name] for name in names])

    @classmethod
    def read(cls, path: str, names: Iterable[str]) -> ClassList:
        """Return the class of a file.

        Args:
            names: of the files of answers, each of which is of a student.

        Raises:
            InputError: a row is not as long as the first, or a student stands there twice or not.
        """
        text, source = read_text(path)
        text = text.removeprefix("\ufeff")
        first = text.partition("\n")[0]
        delimiter = ";" if first.count(";") > first.count(",") else ","
        lines = csv.reader(io.StringIO(text), delimiter=delimiter)
        table = [[cell.strip() for cell in line] for line in lines if any(map(str.strip, line))]
        columns, *rows = table or [[]]
        if not rows:
            raise InputError(
                f"{source} has no rows; expected a first line with names, and students"
            )
        for number, row in enumerate(rows, 2):
            if len(row) != len(columns):
                raise InputError(
                    f"{source} line {number} has {len(row)} entries; expected {len(columns)}"
                )
        known = [row[0] for row in rows]
        if twice := [name for name in known if known.count(name) > 1]:
            raise InputError(f"{source} has {shown(twice[0])} twice; expected different names")
        if strange := sorted({*names} - {*known}):
            raise InputError(
                f"{strange[0]}.json is not of a student in {source}; expected one of its first "
                "column. Add a row, or rename the file"
            )
        return cls(columns, rows, delimiter)

    def table(self, columns: Sequence[str], results: Mapping[str, Sequence[str]]) -> str:
        """Return the rows with columns of results as CSV."""
        lines = io.StringIO()
        table = csv.writer(lines, delimiter=self.delimiter, lineterminator="\n")
        table.writerow([*self.columns, *columns])
        for row in self.rows:
            table.writerow([*map(_cell, row), *map(_cell, results[row[0]])])
        return lines.getvalue()


def _cell(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(("=", "+", "-", "@")) else text
