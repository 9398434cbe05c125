"""Printed numbers of a table, compared with computed ones."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict

from arrangement.console import terminal
from arrangement.errors import InputError
from proofs_check.course.printed_table import Row, check_table, value_text

_WORDS = {True: "agree", False: "differ", None: "not computed"}


def run_table(path: str, as_json: bool) -> int:
    """Print each row of a table with both values; exit 1 if two differ.

    Rows of one quantity that print different numbers are in conflict, computed or not.

    Args:
        path: of a CSV file, or "-" for standard input.

    Raises:
        InputError: some rows cannot be read; the others are printed before. Nothing is, if no row
            can be read.
    """
    total: Counter[str] = Counter()
    first: dict[tuple[str, str], Row] = {}
    unread: list[Row] = []  # of the beginning
    for row in check_table(path):
        if row.mistake and not first:
            unread.append(row)
            continue
        if not first:
            for one in unread:
                _print(one, "not read", as_json=as_json)
        verdict, other = "not read", row
        if not row.mistake:
            other = first.setdefault((row.arrangement, row.quantity), row)
            verdict = "conflict" if row.printed != other.printed else _WORDS[row.agrees]
        total[verdict] += 1
        note = f", line {other.line} prints {value_text(other.printed, row.quantity)}"
        _print(row, verdict, note if verdict == "conflict" else "", as_json=as_json)
    if unread and not first:
        raise InputError(f"line {unread[0].line} of {path}: {unread[0].mistake}")
    if unread:
        total["not read"] += len(unread)
    if not as_json:
        print(", ".join(f"{number} {verdict}" for verdict, number in total.items()))
    if total["not read"]:
        raise InputError(f"{total['not read']} of {total.total()} rows cannot be read")
    return terminal.NO if total["differ"] or total["conflict"] else terminal.YES


def _print(row: Row, verdict: str, note: str = "", *, as_json: bool) -> None:
    if as_json:
        terminal.print_json({**asdict(row), "verdict": verdict})
    else:
        print(f"{verdict:<12}  {_line(row)}{note}")


def _line(row: Row) -> str:
    if row.mistake:
        return f"line {row.line}: {row.mistake}"
    what = f"{row.arrangement}, {row.quantity}: printed {value_text(row.printed, row.quantity)}"
    if row.computed is None:
        return f"{what}, {row.reason}"
    hint = f" ({row.reason}; see relatively_bounded_regions)" if row.reason else ""
    return f"{what}, computed {value_text(row.computed, row.quantity)}{hint}"
