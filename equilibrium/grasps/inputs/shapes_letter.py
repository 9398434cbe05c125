"""Shapes whose numbers have one letter: contacts as expressions in it.

`touches` runs with functions of the letter in place of numbers (`arrangement.numbers.functions`):
so the contacts are found, as functions, for all values at which its comparisons have the same
answers. What is left of the range is treated in the same way, until the whole range is covered; the
contacts have to be the same functions everywhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from arrangement.errors import InputError
from arrangement.library.files.json_files import Source
from arrangement.numbers.exact import simplest_between, to_text
from arrangement.numbers.expressions import read_expression
from arrangement.numbers.functions import Domain, Function
from arrangement.numbers.linear.rank import difference
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle
from equilibrium.model.parameter import ParametricQuestion, deep, interval

from .parameter import read_range
from .shapes import PairValues, listed_shapes, read_shapes, shapes_document
from .touching import Touch, into_body, touches

#: Keys whose values have no numbers.
WORDS = ("name", "shapes", "body_a", "body_b", "description", "units", "schema_version")
#: How near to irrational values at which a comparison changes contacts are found (length 1).
_WIDTH = Fraction(1, 10**12)
#: Intervals and single values into which the range is cut at most.
_MOST_CELLS = 200
#: Contacts: the names of the shapes; bodies, point and normal in texts.
_Contacts = list[tuple[tuple[str, str], dict[str, Any]]]


def shapes_with_letter(
    source: Source, parameter: str, friction: Any = None, gap: Any = None
) -> tuple[dict[str, Any], list[str]]:
    """Return the document of an assembly whose numbers are expressions in one letter, and remarks.

    `resisted --parameter` reads the document. The contacts are proved to be those of the shapes for
    all values of the range; remarks name values of which this is not proved.

    Args:
        source: of ``bodies``, see `read_shapes`; all numbers may have the letter, not as an angle.
        parameter: the letter and its range, as ``t=6/5..2``. Shapes have to touch exactly for all
            its values.
        friction: in place of that of the document.
        gap: none.

    Raises:
        InputError: for anything else, or where contacts are not those of the formulas.
    """
    letter, *ends = read_range(parameter)
    span = interval(*ends)
    document = shapes_document(source) | ({} if friction is None else {"friction": friction})
    if "bodies" not in document or document.get("wrench") or gap or document.get("gap"):
        raise GraspError("shapes with a letter have bodies, and neither wrench nor gap")
    known: tuple[Fraction, _Contacts] | None = None
    open_spans, remarks = [span], list[str]()
    for _ in range(_MOST_CELLS):
        if not open_spans:
            break
        rest = open_spans.pop()
        third = (rest.high - rest.low) / 3
        value = simplest_between(rest.low + third, rest.high - third)
        domain = Domain(rest, value, _WIDTH, letter)
        try:
            # First with the value, whose numbers messages have.
            if known is None:
                read_shapes(_at(document, letter, value))  # all keys, and threads
            else:
                list(touches(listed_shapes(_at(document, letter, value))[0], Fraction(0)))
            numbers = _at(document, letter, Function.letter(domain))
            contacts = list(map(_contact, touches(listed_shapes(numbers)[0], Fraction(0))))
        except ZeroDivisionError:
            raise GraspError(f"for {letter} = {to_text(value)} a number divides by 0") from None
        except InputError as error:
            raise GraspError(f"for {letter} = {to_text(value)}: {error}") from None
        known = known or (value, contacts)
        if contacts != known[1]:
            raise GraspError(
                f"for {letter} = {to_text(value)} contacts are others than for "
                f"{letter} = {to_text(known[0])}; expected shapes that touch in the same way for "
                "all values. Choose a shorter range"
            )
        for part in rest.around(domain.span):
            if 0 < part.high - part.low <= 2 * _WIDTH:
                remarks.append(f"contacts are not proved for {letter} in {part}")
            else:
                open_spans.append(part)
    else:
        raise GraspError(
            f"the contacts have to be found in more than {_MOST_CELLS} parts of {span}; choose a "
            "shorter range"
        )
    assert known  # for one value at least
    made = _written(document, known[1])
    ParametricQuestion(made, letter).check(span)
    return made, remarks


def _at(document: Mapping[str, Any], letter: str, value: Any) -> dict[str, Any]:
    """Return a document with numbers, or functions, for its expressions in the letter."""

    def number(x: Any, name: str) -> Any:
        expression = read_expression(x, letter, name.removeprefix("."))
        if expression.has_turn:
            raise GraspError(f"{x} has an angle; write (1-t^2)/(1+t^2) for cos and so on")
        return value * 0 + expression.value(value)

    made: dict[str, Any] = deep(document, number, plain=WORDS)
    return made


def _contact(touch: Touch) -> tuple[tuple[str, str], dict[str, Any]]:
    point, form = touch.point, touch.first.form
    if point is None:
        assert isinstance(form, Circle)  # else there is a point
        other = touch.second.form
        share = form.radius / (form.radius + (other.radius if isinstance(other, Circle) else 0))
        point = difference(form.centre, tuple(share * x for x in touch.way))
    first, second, normal = into_body(touch.first, touch.second, touch.way)
    texts = {"point": [x.text() for x in point], "normal": [x.text() for x in normal]}  # type: ignore[attr-defined]
    return (touch.first.name, touch.second.name), {"body_a": first, "body_b": second, **texts}


def _written(document: Mapping[str, Any], listed: _Contacts) -> dict[str, Any]:
    """Return the assembly with these contacts, and with threads as contacts."""
    rows = [*document["bodies"], *document.get("ground", [])]
    values = PairValues(document, {row.get("name", "ground") for row in rows})
    contacts = [entry | values(*shapes) for shapes, entry in listed]
    for thread in document.get("threads", []):
        law = {"friction": 0, "preload": thread.get("tension", 0)}
        law |= {"stiffness": thread["stiffness"]} if "stiffness" in thread else {}
        ends = zip(thread["to"], thread["point"], strict=True)
        place = {"point": thread["point"], "normal": [f"({x})-({y})" for x, y in ends]}
        contacts.append({key: thread[key] for key in ("body_a", "body_b")} | place | law)
    units = {"units": document["units"]} if "units" in document else {}
    return {
        "schema_version": 1,
        **units,
        "bodies": [_body(row) for row in document["bodies"]],
        "contacts": contacts,
    }


def _body(row: Mapping[str, Any]) -> dict[str, Any]:
    if {"force", "density"} & row.keys():
        raise GraspError(f"{row['name']} has a force or density; with a letter give its weight")
    body = {key: row[key] for key in ("name", "weight", "centre") if key in row}
    if "circle" in row:
        return {"centre": row["circle"]["centre"], **body, "outline": row["circle"]}
    walls = {"segments": row["segments"]} if "segments" in row else None
    return {**body, "outline": walls or row["polygon"]}
