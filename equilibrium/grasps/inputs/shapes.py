"""Files of shapes, whose contacts follow: see `touching`.

A document has one ``body``, for a grasp, or ``bodies`` in the plane, for an assembly; maybe a
``ground``; and ``friction``. Each of them is an object with one of the keys of `_FORMS`::

    {"schema_version": 1, "friction": "1/2", "gap": "1/1000",
     "bodies": [{"name": "ball", "circle": {"centre": ["0", "1"], "radius": "1"}, "weight": "2"},
                {"name": "block", "polygon": [["1", "0"], ["3", "0"], ["3", "2"], ["1", "2"]]}],
     "ground": [{"name": "floor", "segments": [[["-5", "0"], ["5", "0"]]]}],
     "pairs": [{"shapes": ["ball", "floor"], "friction": "0"}],
     "threads": [{"body_a": "block", "point": ["3", "1"], "body_b": null, "to": ["5", "1"],
                  "tension": "1"}]}

A table has one of them a line: ``body`` (empty: the ground), ``x``, ``y``, in space ``z``, and
``radius`` for a disc or sphere, ``x2`` and ``y2`` for a thin wall, ``normal_x``, ``normal_y`` and
``normal_z`` for a plane in space; lines with neither are the corners of a polygon in order.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

from arrangement.library.files.json_files import (
    Source,
    check_keys,
    check_list,
    read_document,
    read_text,
)
from arrangement.numbers.exact import RationalVector, rational, shown
from arrangement.numbers.linear.rank import difference
from equilibrium.grasps.files import decimal_text
from equilibrium.model.assembly import Assembly, BodyContact, RigidBody, Wrenches
from equilibrium.model.contact import Contact
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, ask_contacts, wrench_of
from equilibrium.model.labels import Units
from equilibrium.model.outline import Circle, Polygon, coordinates, read_round, read_segments
from equilibrium.model.unit_normal import unit_normal

from .conversion import DEFAULT_TOLERANCE
from .csv_file import BODIES, GROUND, Table, is_table
from .touching import Form, Plane, Shape, TouchingShapes, area, counter_clockwise, touching

#: Which forms there are, and what a body and a part of the ground may have besides.
_FORMS = ("circle", "sphere", "polygon", "segments", "plane")
_OF_BODIES = ("name", "weight", "density", "centre", "force")
#: What a contact has, and all contacts may have in common.
_VALUES = ("friction", "stiffness", "preload")
_COMMON = ("schema_version", "description", "units", "ground", "pairs", "threads", "gap", *_VALUES)
_THREAD = ("stiffness", "tension")
_PLACES = ("x", "y", "z")
_END = ("x2", "y2")
_NORMAL = ("normal_x", "normal_y", "normal_z")
_COLUMNS = (BODIES[0], *_PLACES, "radius", *_END, *_NORMAL, "weight")


class ReadShapes(NamedTuple):
    """What a file of shapes means.

    Attributes:
        subject: an assembly, or the grasp of one body.
        wrenches: on each body of an assembly, where the file has forces; weights are in the bodies.
        found: the contacts of shapes, without threads, and what was rounded.
        remarks: what was rounded, in words.
    """

    subject: Assembly | Grasp
    wrenches: Wrenches | None
    found: TouchingShapes
    remarks: list[str]

    def to_dict(self) -> dict[str, Any]:
        """Return the document of the assembly or grasp."""
        if isinstance(self.subject, Assembly):
            return self.subject.to_dict(self.wrenches)
        return self.subject.to_dict()


def read_shapes(
    source: Source,
    *,
    friction: Any = None,
    gap: Any = None,
    angle_tolerance: Any = DEFAULT_TOLERANCE,
) -> ReadShapes:
    """Read shapes and find their contacts.

    Args:
        source: a path, ``"-"`` (stdin) or a mapping; a path that ends with ``.csv`` is a table.
        friction: of all contacts but those of `pairs`, in place of that of the document; a table
            has none.
        gap: discs this close to a shape touch it, see `touching`, in place of that of the document.
        angle_tolerance: of normals that have no exact unit form.

    Raises:
        InputError: for anything else.

    >>> ball = {"circle": {"centre": ["0", "0.6"], "radius": "1"}}
    >>> posts = [{"circle": {"centre": [x, "-1"], "radius": "1"}} for x in ("-1.2", "1.2")]
    >>> read = read_shapes({"schema_version": 1, "body": ball, "ground": posts, "friction": "1/2"})
    >>> [[str(x) for x in contact.normal] for contact in read.subject]
    [['3/5', '4/5'], ['-3/5', '4/5']]
    """
    document = shapes_document(source)
    shapes, rows, several = listed_shapes(document)
    names = {shape.name for shape in shapes if shape.is_body}
    if friction is not None:
        document["friction"] = friction
    values = PairValues(document, {shape.name for shape in shapes})
    touches = touching(
        shapes,
        values,
        gap=document.get("gap", 0) if gap is None else gap,
        angle_tolerance=angle_tolerance,
    )
    remarks = touches.remarks
    pulls = check_list(document.get("threads", []), "threads")
    threads = [
        _thread(row, i, names, several, angle_tolerance, remarks) for i, row in enumerate(pulls)
    ]
    units = Units.from_dict(document["units"]) if "units" in document else None
    if not several:
        contacts = [contact for *_, contact in (*touches.contacts, *threads)]
        form: Any = shapes[0].form
        outline = form if isinstance(form, Circle | Polygon) else None
        return ReadShapes(Grasp(contacts, units, outline), None, touches, remarks)
    bodies = [_body(row, shape) for row, shape in zip(rows, shapes, strict=False)]
    made = touches.assembly(bodies, [x.form for x in shapes if not x.is_body])
    pulled = [BodyContact(*entry) for entry in threads]
    assembly = replace(made, contacts=(*made.contacts, *pulled), units=units)
    return ReadShapes(assembly, _wrenches(assembly, rows, document), touches, remarks)


def listed_shapes(document: Mapping[str, Any]) -> tuple[list[Shape], list[Any], bool]:
    """Return the shapes of a document, the entries of its bodies, and whether there are several."""
    kind = "bodies" if "bodies" in document else "body"
    several = kind == "bodies"
    check_keys(document, (kind,), (*_COMMON, *(["wrench"] if several else [])), "the document")
    rows = check_list(document[kind], kind) if several else [document[kind]]
    ground = check_list(document.get("ground", []), "ground")
    ask_contacts(len(rows) + len(ground))
    keys = _OF_BODIES if several else ("name",)
    shapes = [
        _shape(row, f"bodies[{i}]" if several else "body", keys) for i, row in enumerate(rows)
    ]
    names = {shape.name for shape in shapes}
    for i, row in enumerate(ground):
        shape = _shape(row, f"ground[{i}]", ("name",), False)
        if shape.name in names:
            raise GraspError(f"ground[{i}] has the name {shown(shape.name)} of a body; change one")
        shapes.append(shape)
    forms = [shape.form for shape in shapes]
    dimensions = {3 if isinstance(form, Plane) else form.dimension for form in forms}
    if len(dimensions) > 1 or (several and 3 in dimensions):
        raise GraspError(
            "the shapes are in the plane and in space, or several bodies in space; expected all in "
            'the plane, or one "body" and a ground in space'
        )
    return shapes, rows, several


def shapes_document(source: Source) -> dict[str, Any]:
    """Return the document of a source, of a table too."""
    if isinstance(source, (str, os.PathLike)) and is_table(source):
        return _of_table(read_text(Path(source))[0])
    return read_document(source, ("bodies", "body"), floats=decimal_text)


class PairValues:
    """Friction, stiffness and preload of the contact of two shapes, by their names."""

    def __init__(self, document: Mapping[str, Any], names: set[str]) -> None:
        self.common = {key: document[key] for key in _VALUES if key in document}
        self.of_pairs = dict[frozenset[str], dict[str, Any]]()
        pairs = document.get("pairs", [])
        for i, entry in enumerate(check_list(pairs, "pairs")):
            check_keys(entry, ("shapes",), _VALUES, f"pairs[{i}]")
            pair = check_list(entry["shapes"], f"pairs[{i}].shapes", 2)
            for name in pair:
                if not isinstance(name, str) or name not in names:
                    known = ", ".join(sorted(names))
                    raise GraspError(
                        f"pairs[{i}] is of {shown(name)}; expected two of the shapes {known}"
                    )
            own = {key: x for key, x in entry.items() if key != "shapes"}
            self.of_pairs[frozenset(pair)] = self.of_pairs.get(frozenset(pair), {}) | own

    def __call__(self, first: str, second: str) -> dict[str, Any]:
        """Return the values by name, as they stand in the document."""
        values = {**self.common, **self.of_pairs.get(frozenset((first, second)), {})}
        if "friction" not in values:
            raise GraspError(
                f"there is no friction of {first} and {second}; give friction, of all or of pairs"
            )
        return values


def _shape(entry: Any, where: str, keys: tuple[str, ...], is_body: bool = True) -> Shape:
    own = [key for key in _OF_BODIES if isinstance(entry, Mapping) and key in entry]
    if is_body and (more := [key for key in own if key not in keys]):
        raise GraspError(
            f"{where} has {more[0]}; one body has its load in the question. Leave it out, or give "
            'several "bodies" in the plane'
        )
    check_keys(entry, (), (*_FORMS, *keys), where)
    kinds = [key for key in _FORMS if key in entry]
    if len(kinds) != 1:
        raise GraspError(f"{where} has {len(kinds)} forms; expected one of {', '.join(_FORMS)}")
    name = entry.get("name", ("body" if "weight" not in keys else None) if is_body else "ground")
    if not isinstance(name, str):
        raise GraspError(f"{where} has the name {shown(name)}; give each body a name")
    return Shape(name, _form(kinds[0], entry[kinds[0]], f"{where}.{kinds[0]}", is_body), is_body)


def _form(kind: str, data: Any, where: str, is_body: bool) -> Form:
    if kind == "polygon":
        return counter_clockwise([check_list(x, where, 2) for x in check_list(data, where)], where)
    if kind == "segments":
        return read_segments(data, where)
    if kind == "plane":
        check_keys(data, ("point", "normal"), (), where)
        if is_body:
            raise GraspError(f"{where}: a plane is of the ground; give a sphere")
        point, normal = (
            coordinates(check_list(data[key], f"{where}.{key}"), f"{where}.{key}", 3)
            for key in ("point", "normal")
        )
        if not any(normal):
            raise GraspError(f"{where}.normal is 0; give a direction away from the ground")
        return Plane(point, normal)
    check_keys(data, ("centre", "radius"), (), where)
    check_list(data["centre"], f"{where}.centre", 3 if kind == "sphere" else 2)
    return read_round(data, where)


def _body(entry: Mapping[str, Any], shape: Shape) -> RigidBody:
    form: Any = shape.form
    weight, density = (
        rational(entry.get(key, 0), f"the {key} of {shape.name}") for key in ("weight", "density")
    )
    if density and not area(form):
        raise GraspError(f"the density of {shape.name} is of no polygon; give a weight")
    centre: Any = entry.get("centre")
    if centre is not None:
        centre = check_list(centre, f"{shape.name}: centre", 2)
    return RigidBody(shape.name, form, weight + density * area(form), centre)


def _thread(
    entry: Any, index: int, names: set[str], several: bool, tolerance: Any, remarks: list[str]
) -> tuple[str, str | None, Contact]:
    """Return a thread as a smooth contact that pulls its point towards the other end.

    Args:
        remarks: to which the rounding of its direction is added.
    """
    where, bodies = f"threads[{index}]", ("body_a", "body_b") if several else ()
    check_keys(entry, ("point", "to", *bodies), _THREAD, where)
    point, end = (
        coordinates(check_list(entry[key], f"{where}.{key}"), f"{where}.{key}")
        for key in ("point", "to")
    )
    if len(point) != len(end) or point == end:
        raise GraspError(f"{where} has the ends {shown(point)} and {shown(end)}; give two points")
    for key in bodies:
        is_known = isinstance(entry[key], str) and entry[key] in names
        if not is_known and (key == "body_a" or entry[key] is not None):
            raise GraspError(
                f"{where}: {key} is {shown(entry[key])}; expected a body"
                + ("" if key == "body_a" else ", or null for the ground")
            )
    normal, error = unit_normal(difference(end, point), tolerance)
    if error:
        remarks.append(f"direction rounded, in radians: {where}, by {abs(float(error)):.2g}")
    law = entry.get("stiffness", 1), entry.get("tension", 0)
    contact = Contact(point, normal, 0, *law, thread=end)
    return entry.get("body_a", ""), entry.get("body_b"), contact


def _wrenches(assembly: Assembly, rows: list[Any], document: Mapping[str, Any]) -> Wrenches | None:
    """Return weights, forces in the centres and wrenches together; None where weights are all."""
    if not ("wrench" in document or any("force" in row for row in rows)):
        return None
    stated = check_keys(document.get("wrench", {}), (), assembly.names, "wrench")
    wrenches = assembly.read_wrenches({k: check_list(x, f"wrench.{k}") for k, x in stated.items()})
    total: Wrenches = {}
    for row, body in zip(rows, assembly.bodies, strict=True):
        parts: list[RationalVector] = [wrenches[body.name], body.weight_wrench]
        if "force" in row:
            where = f"the force on {body.name}"
            force = coordinates(check_list(row["force"], where), where, 2)
            parts.append(wrench_of(force, body.middle))
        total[body.name] = tuple(sum(column, Fraction(0)) for column in zip(*parts, strict=True))
    return total


def _of_table(text: str) -> dict[str, Any]:
    """Return the document of a table; one sphere is a body, else there are bodies."""

    def check(header: list[str]) -> None:
        for name in header:
            if name not in _COLUMNS or header.count(name) > 1:
                raise GraspError(
                    f"the column {shown(name)} is unknown or there twice; expected some of "
                    f"{', '.join(_COLUMNS)}"
                )
        if missing := [name for name in (BODIES[0], "x", "y") if name not in header]:
            raise GraspError(
                f"the first line has no column {'body' if missing[0] in BODIES else missing[0]}; "
                "expected body, x and y"
            )

    ask_contacts(text.count("\n"))
    shapes, last = list[dict[str, Any]](), None
    table = Table(text)
    for line, row in table.rows(check):
        entry = {key: x for key, x in row.items() if x}
        name, place = entry.pop(BODIES[0], ""), [entry.pop(x, "") for x in _PLACES if x in row]
        extra = {"weight": entry.pop("weight")} if "weight" in entry else {}
        kind, data = _form_of(entry, place, line)
        if last == (name, kind) and isinstance(data, list):
            shapes[-1][kind] += data
        else:
            shapes.append({"name": "ground" if name.lower() in GROUND else name, kind: data})
        shapes[-1] |= extra
        last = name, kind
    bodies = [shape for shape in shapes if shape["name"] != "ground"]
    document: dict[str, Any] = {"schema_version": 1}
    document["ground"] = [shape for shape in shapes if shape["name"] == "ground"]
    if table.units:
        document["units"] = table.units.to_dict()
    if len(bodies) == 1 and "sphere" in bodies[0]:
        return {**document, "body": bodies[0]}
    return {**document, "bodies": bodies}


def _form_of(entry: Mapping[str, str], place: list[str], line: int) -> tuple[str, Any]:
    """Return the kind and the data of the shape in a line; lists go on in the next line."""
    columns = entry.keys()
    if columns == {"radius"}:
        kind = "sphere" if len(place) == len(_PLACES) else "circle"
        return kind, {"centre": place, "radius": entry["radius"]}
    if columns == {*_END}:
        return "segments", [[place, [entry[x] for x in _END]]]
    if columns == {*_NORMAL}:
        return "plane", {"point": place, "normal": [entry[x] for x in _NORMAL]}
    if columns:
        raise GraspError(
            f"line {line} has the entries {', '.join(columns)}; expected radius, or "
            f"{', '.join(_END)}, or {', '.join(_NORMAL)}, or none of them"
        )
    return "polygon", [place]
