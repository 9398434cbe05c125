"""The report for the terminal, made from the JSON record of a run and only that."""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from arrangement.console.number_form import counted, number
from arrangement.console.safe_text import one_line
from arrangement.numbers.exact import rational
from proofs_check.statements.evidence import strength_from
from proofs_check.statements.statement import ClaimVerdict, Kind, Strength

Record = Mapping[str, Any]
_FRACTION = re.compile(r"-?[0-9]+/[1-9][0-9]*", re.ASCII)


def strength(result: Record) -> Strength | None:
    """Return what the verdict of a result is worth; None without a verdict that is known.

    It follows from the verdict and the kind of evidence, in records of earlier releases too.
    """
    try:
        kind = Kind(result.get("evidence_kind", Kind.SAMPLED.value))
        return strength_from(ClaimVerdict(result["verdict"]), kind)
    except ValueError:
        return None


def added_hypotheses(result: Record) -> list[str]:
    """Return what had to be added to a statement before it was confirmed."""
    if result["verdict"] != ClaimVerdict.HOLDS_UNDER_HYPOTHESIS.value:
        return []
    if "added_hypotheses" in result:
        return list(result["added_hypotheses"])
    assumptions = sorted({case["assumption"] for case in result["records"]} - {""})
    return [*filter(None, [result.get("saving_hypothesis")]), *assumptions]


def conclusion(result: Record) -> str:
    """Return the verdict in words that are as strong as its evidence.

    With the number of cases where there are others, the hypotheses that were added, and the
    verdict that was expected if it is another one.
    """
    worth = strength(result)
    text = worth.value if worth else result["verdict"] or "no verdict"
    if worth is Strength.SAMPLED:
        true = sum(case["holds"] and case["covered"] for case in result["records"])
        text += f" ({result.get('tried', true)} tried)"
    if added := added_hypotheses(result):
        text += f" under the hypothesis {' and '.join(added)}"
    return f"{text} (expected: {result['expected']})" if is_unexpected(result) else text


def also_tried(result: Record) -> list[str]:
    """Return what is true of the statement on other domains, one in a line."""
    return [f"{other['domain']}: {other['text']}" for other in result.get("also_tried", [])]


def is_unexpected(result: Record) -> bool:
    """Return whether somebody stated a verdict that is not the one of the result."""
    return not result["as_expected"] and result.get("expectation_stated", True)


def badge_text(badge: Mapping[str, Any]) -> str:
    """Return a badge of a claim in one line."""
    return f"{', '.join(badge['names'])}: {badge['meaning']}"


def value_text(value: Any, limit: int = 0) -> str:
    """Return a value of a record as text: sequences in parentheses, errors in their words.

    Long fractions are written as the command that runs writes numbers.
    """
    text = "none" if value is None else str(value)
    if isinstance(value, str) and _FRACTION.fullmatch(value):
        text = number(rational(value))
    elif isinstance(value, list):
        text = f"({', '.join(value_text(item) for item in value)})"
    elif isinstance(value, Mapping) and value.keys() & {"error", "unanswered"}:
        (text,) = value.values()
    return text if not limit or len(text) <= limit else f"{text[: limit - 3]}..."


def table(rows: Sequence[Sequence[str]], width: int, indent: str = "") -> list[str]:
    """Align columns with two spaces between; the last column wraps to the width.

    When the last column would be left with less than 24 characters, it goes to lines of its own.
    """
    if not rows:
        return []
    columns = len(rows[0])
    rows = [[one_line(cell) for cell in row] for row in rows]
    widths = [max(len(row[j]) for row in rows) for j in range(columns - 1)]
    start = len(indent) + sum(widths) + 2 * (columns - 1)
    beside = width - start >= 24
    lines = []
    for row in rows:
        left = indent + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=False))
        hang = " " * (start if beside else len(indent) + 4)
        wrapped = textwrap.wrap(row[-1], max(width - len(hang), 24), break_on_hyphens=False)
        if beside:
            lines.append(f"{left}  {wrapped[0] if wrapped else ''}".rstrip())
            lines += [hang + text for text in wrapped[1:]]
        else:
            lines.append(left.rstrip())
            lines += [hang + text for text in wrapped]
    return lines


def overview(record: Record) -> str:
    """Return one verdict a claim, with the tables of the paper row by row, and a summary."""
    results = record["results"]
    entries = [entry(result, columns(results), 100) for result in results]
    return "\n".join([*entries, "", *left_out(record), summary(results)])


def left_out(record: Record) -> list[str]:
    """Return a line with the claims that take minutes, if they were left out."""
    claims = record.get("left_out", ())
    return [f"left out, as --large is not given: {', '.join(claims)}"] if claims else []


def columns(claims: Iterable[Record]) -> tuple[int, int]:
    """Return how wide ids and locators are."""
    lengths = [(len(claim["id"]), len(claim["locator"])) for claim in claims]
    return max((n for n, _ in lengths), default=0), max((n for _, n in lengths), default=0)


def entry(result: Record, widths: tuple[int, int], width: int) -> str:
    """Return the verdict and the evidence of one claim, and its cases where it asks for them."""
    names = (one_line(result[key]) for key in ("id", "locator"))
    id, locator = (name.ljust(width) for name, width in zip(names, widths, strict=True))
    head, evidence = f"{id}  {locator}  {conclusion(result)}", result["evidence"]
    if len(head) > width:
        head, evidence = f"{id}  {conclusion(result)}", f"[{locator.rstrip()}] {evidence}"
    indent = " " * 4
    lines = textwrap.wrap(evidence, width, initial_indent=indent, subsequent_indent=indent)
    cases = ["", *_rows(result, width), ""] if result["rows"] else []
    return "\n".join([head, *lines, *cases])


#: Of what a result says, the names that the text of one claim has.
_IN_DETAIL = ("statement", "domain", "hypothesis", "verdict", "evidence", "also tried")


def facts(result: Record) -> list[tuple[str, str]]:
    """Return what a claim says and how it was checked, as names and texts, in every form."""
    time = result.get("milliseconds")
    entries = [
        ("statement", result["statement"]),
        ("locator", result["locator"]),
        ("domain", result.get("domain") or ""),
        *(("hypothesis", text) for text in result["hypotheses"]),
        ("verdict", conclusion(result)),
        *(("evidence", text) for text in result["evidence"].split("; ")),
        *(("also tried", text) for text in also_tried(result)),
        *(("proved", badge_text(badge)) for badge in result.get("badges", [])),
        *((f"computed {i}", name) for i, name in enumerate(result["routes"], 1)),
        ("added hypothesis", result.get("saving_hypothesis") or ""),
        ("meaning", result["meaning"]),
        ("time", "" if time is None else f"{time} ms"),
    ]
    return [(name, text) for name, text in entries if text]


def details(result: Record, width: int, **more: str) -> str:
    """Return one result with its statement and hypotheses, and what else there is to say."""
    rows = [row for row in facts(result) if row[0] in _IN_DETAIL]
    rows += [row for row in more.items() if row[1]]
    head = one_line(f"{result['id']} ({result['locator']})")
    return "\n".join([head, *table(rows, width, "  ")])


def _rows(result: Record, width: int) -> list[str]:
    """Return every case of a result as a table: label, values of the routes, remark."""
    names = " | ".join(f"by {name}" for name in result["routes"])
    text = f"{result['quantity']}: {names}"
    lines = textwrap.wrap(text, width, initial_indent="  ", subsequent_indent="  ")
    cases = (cells(case, ("ok ", "no "), 60) for case in result["records"])
    rows = [(holds, *values, remark) for *values, holds, remark in cases]
    return [*lines, *table(rows, width, indent="  ")]


def cells(case: Record, holds: tuple[str, str], limit: int = 0) -> list[str]:
    """Return a row of a table of cases: label, values, whether it holds, a remark.

    Args:
        holds: the words for yes and no.
        limit: of the length of a value, if there is one.
    """
    values = (value_text(value, limit) for value in case["values"])
    remark = "; ".join(text for text in (case["note"], case["assumption"]) if text)
    return [case["label"], *values, holds[0 if case["holds"] else 1], remark]


def summary(results: Sequence[Record]) -> str:
    """Return how many verdicts there are of each strength, and which are not the expected ones."""
    counts = ", ".join(f"{number} {words}" for number, words in counts_by_strength(results))
    different = [result["id"] for result in results if is_unexpected(result)]
    end = f"not as expected: {', '.join(different)}" if different else as_expected("all", results)
    return "; ".join(filter(None, [f"{counted(len(results), 'claim')}: {counts}", end]))


def as_expected(every: str, results: Sequence[Record]) -> str:
    """Return that no verdict is another one than was expected; "" where none was stated."""
    stated = [result.get("expectation_stated", True) for result in results]
    if not any(stated):
        return ""
    return f"{every} as expected" if all(stated) else "as expected wherever that was stated"


def counts_by_strength(results: Sequence[Record]) -> list[tuple[int, str]]:
    """Return how many results there are of each strength, the strongest first, with its words."""
    every, added = Counter(map(strength, results)), Counter[Strength | None]()
    added.update(strength(result) for result in results if added_hypotheses(result))
    counts = []
    for worth in (*Strength, None):
        if count := every[worth]:
            words = worth.value if worth else "no verdict"
            words = words if count == 1 else words.replace("holds", "hold")
            under = f" ({added[worth]} under a hypothesis)" if added[worth] else ""
            counts.append((count, words + under))
    return counts
