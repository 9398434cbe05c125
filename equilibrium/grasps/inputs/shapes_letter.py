"""Shapes whose numbers have one letter: contacts as expressions in it.

The contacts are found for one value of the letter. Each is written as a formula: between discs it
divides the line of their centres in the ratio of the radii, on an edge it is the foot of the
perpendicular, else a corner. The formulas are compared with the contacts of other values.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from arrangement.library.files.json_files import Source
from arrangement.numbers.exact import RationalVector, dot, rational, to_text
from arrangement.numbers.expressions import read_expression
from arrangement.numbers.linear.rank import cycle_edges, difference
from equilibrium.model.assembly import Assembly
from equilibrium.model.errors import GraspError
from equilibrium.model.outline import Circle
from equilibrium.model.parameter import ParametricQuestion

from .parameter import read_range
from .polygon import place_on_segment
from .shapes import PairValues, read_shapes, shapes_document
from .touching import Shape, Touch

#: Keys whose values have no numbers.
_WORDS = ("name", "shapes", "body_a", "body_b", "description", "units", "schema_version")
#: Values of the letter, as shares of its range; the contacts are found at the first.
_SHARES = tuple(Fraction(k, 7) for k in (3, 1, 2, 5, 6))
#: Expressions for the coordinates of a point or vector.
_Pair = list[str]


def shapes_with_letter(
    source: Source, parameter: str, friction: Any = None, gap: Any = None
) -> dict[str, Any]:
    """Return the document of an assembly whose numbers are expressions in one letter.

    `resisted --parameter` reads it.

    Args:
        source: of ``bodies``, see `read_shapes`; all numbers may have the letter, not as an angle.
        parameter: the letter and its range, as ``t=6/5..2``. Shapes have to touch exactly for all
            its values; what is compared is five of them.
        friction: in place of that of the document.
        gap: none.

    Raises:
        InputError: for anything else, or where contacts are not those of the formulas.
    """
    letter, *ends = read_range(parameter)
    low, high = (rational(end, "an end of the parameter") for end in ends)
    document = shapes_document(source) | ({} if friction is None else {"friction": friction})
    if "bodies" not in document or document.get("wrench") or gap or document.get("gap"):
        raise GraspError("shapes with a letter have bodies, and neither wrench nor gap")
    made: dict[str, Any] = {}
    for share in _SHARES:
        value = low + share * (high - low)

        def number(x: Any, value: Fraction = value) -> str:
            expression = read_expression(x, letter)
            if expression.has_turn:
                raise GraspError(f"{x} has an angle; write (1-t^2)/(1+t^2) for cos and so on")
            return to_text(Fraction(expression.value(value)))

        read = read_shapes(_mapped(document, number))
        assert isinstance(read.subject, Assembly)  # of bodies
        made = made or _written(document, read.found.touches, number)
        found, wrenches = ParametricQuestion(made, letter).at(value)
        due = read.subject.weights if read.wrenches is None else read.wrenches
        if read.remarks or found != read.subject or wrenches != due:
            raise GraspError(
                f"for {letter} = {to_text(value)} contacts are others than for "
                f"{letter} = {to_text(low + _SHARES[0] * (high - low))}, or need rounding; "
                "expected shapes that touch exactly for all values. Choose a shorter range"
            )
    return made


def _mapped(value: Any, number: Callable[[Any], str]) -> Any:
    """Return a document with something in place of each number."""
    if isinstance(value, Mapping):
        return {k: x if k in _WORDS else _mapped(x, number) for k, x in value.items()}
    return [_mapped(x, number) for x in value] if isinstance(value, list) else number(value)


def _written(
    document: Mapping[str, Any], touches: tuple[Touch, ...], number: Callable[[Any], str]
) -> dict[str, Any]:
    """Return the assembly with a formula for each contact.

    Args:
        number: the value of an expression where the contacts were found.
    """
    rows = [*document["bodies"], *document.get("ground", [])]
    names = [row.get("name", "ground") for row in rows]
    values = PairValues(document, set(names))
    contacts = []
    for touch in touches:
        shapes = touch.first, touch.second
        # Parts of the ground may share a name: their points together have those of the shape.
        texts = [
            [row for row, name in zip(rows, names, strict=True) if name == x.name] for x in shapes
        ]
        point, normal = _formula(touch, texts, number)
        first, second = (shape.name if shape.is_body else None for shape in shapes)
        if first is None:
            first, second, normal = second, first, [f"-({x})" for x in normal]
        law = values(*(shape.name for shape in shapes))
        contacts.append(
            {"body_a": first, "body_b": second, "point": point, "normal": normal, **law}
        )
    for thread in document.get("threads", []):
        law = {"friction": 0, "preload": thread.get("tension", 0)}
        law |= {"stiffness": thread["stiffness"]} if "stiffness" in thread else {}
        ends = {"point": thread["point"], "normal": _minus(thread["to"], thread["point"])}
        contacts.append({key: thread[key] for key in ("body_a", "body_b")} | ends | law)
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


def _formula(
    touch: Touch, rows: list[list[Mapping[str, Any]]], number: Callable[[Any], str]
) -> tuple[_Pair, _Pair]:
    """Return point and normal of a contact."""

    def at(pair: Any) -> RationalVector:
        return tuple(Fraction(number(x)) for x in pair)

    def disc_of(shape: Shape, listed: list[Mapping[str, Any]]) -> Any:
        discs = [row["circle"] for row in listed if "circle" in row]
        form = shape.form
        return next(
            (x for x in discs if isinstance(form, Circle) and at(x["centre"]) == form.centre), None
        )

    disc, other = (disc_of(*x) for x in zip((touch.first, touch.second), rows, strict=True))
    if disc and other:
        way = _minus(disc["centre"], other["centre"])
        share = f"({other['radius']})/(({disc['radius']})+({other['radius']}))"
        return [f"({x})+({y})*{share}" for x, y in zip(other["centre"], way, strict=True)], way
    place = touch.point or difference(at(disc["centre"]), touch.way)
    edges = [edge for row in (rows[1] if disc else rows[0] + rows[1]) for edge in _edges(row)]
    corner = next((x for edge in edges for x in edge if at(x) == place), None)
    if disc and corner:
        return corner, _minus(disc["centre"], corner)
    start, along = next(
        (a, _minus(b, a))
        for a, b in edges
        if place_on_segment(at(a), at(b), place) is not None
        and not dot(difference(at(b), at(a)), touch.way)
    )
    x, y = along
    left = dot(at([f"-({y})", x]), touch.way) > 0
    normal = [f"-({y})", x] if left else [y, f"-({x})"]
    if corner:
        return corner, normal
    away = _minus(disc["centre"], start)
    share = f"(({x})*({away[0]})+({y})*({away[1]}))/(({x})^2+({y})^2)"
    return [f"({a})+({u})*{share}" for a, u in zip(start, along, strict=True)], normal


def _edges(row: Mapping[str, Any]) -> list[tuple[_Pair, _Pair]]:
    if "segments" in row:
        return [(a, b) for a, b in row["segments"]]
    return list(cycle_edges(row.get("polygon", [])))


def _minus(one: Any, other: Any) -> _Pair:
    return [f"({x})-({y})" for x, y in zip(one, other, strict=True)]
