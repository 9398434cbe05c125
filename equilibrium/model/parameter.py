"""Questions with one letter: a grasp in the plane or an assembly whose numbers depend on it.

A document may have expressions in the letter (`arrangement.numbers.expressions`) in points,
normals, friction, stiffness, preload and adhesion of contacts, in wrenches, and in weights, centres
and outlines of bodies. A normal may have any length that is a rational function. Where the letter
is an angle in degrees (``angle: t``, ``cos(t)``), it stands nowhere else, and all numbers are
rational functions of ``u = tan(t / 2)``: ``cos(t) = (1 - u^2)/(1 + u^2)`` and ``sin(t) =
2 u/(1 + u^2)``. A *value* is one of the letter, or of u.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Container, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

from arrangement.errors import InputError
from arrangement.library.files.json_files import check_keys, check_list
from arrangement.numbers.exact import exact_root, rational, shown, to_text
from arrangement.numbers.expressions import Expression, read_expression
from arrangement.numbers.functions import Domain, Function, Span, Undecided, square_root

from .assembly import SIZE, Assembly, RigidBody, wrenches_of
from .contact import VALUES, groups_of
from .errors import GraspError
from .grasp import Grasp
from .unit_normal import of_half_tangent

#: A grasp and a wrench, or an assembly and the wrenches on its bodies.
AnyQuestion: TypeAlias = tuple[Grasp | Assembly, Any]
_LETTER = re.compile("[A-Za-z]")
#: What may have the letter, in the lists of a document.
_MAY_VARY = {
    "contacts": ("point", "normal", "angle", *VALUES),
    "bodies": ("weight", "centre", "outline"),
}
_DEFAULTS = {"friction": 0, "stiffness": 1, "preload": 0, "adhesion": 0}


class FunctionContact(NamedTuple):
    """A contact in the plane whose numbers are functions of the letter.

    Attributes:
        bodies: body_a and body_b in an assembly.
        share: see `Contact`.
    """

    point: tuple[Any, ...]
    normal: tuple[Any, ...]
    friction: Function
    stiffness: Function
    preload: Function
    adhesion: Function
    bodies: tuple[Any, Any]
    share: Fraction = Fraction(1)
    tangent: None = None
    dimension: int = 2


@dataclass(frozen=True, eq=False)
class ParametricQuestion:
    """A question for each value of a letter.

    Args:
        document: of a grasp in the plane, with the key "wrench", or of an assembly.
        letter: its name.

    Raises:
        InputError: no document of this kind, or an expression that cannot be read.
    """

    document: Mapping[str, Any]
    letter: str = "t"

    def __post_init__(self) -> None:
        if not isinstance(self.letter, str) or not _LETTER.fullmatch(self.letter):
            raise GraspError(
                f"the parameter is {shown(self.letter)}; expected one letter, as t=0..1"
            )
        for i, entry in enumerate(check_list(self.document.get("contacts"), "contacts")):
            place = f"contacts[{i}]"
            direction = "angle" if "angle" in check_keys(entry, (), entry, place) else "normal"
            if {"angle", "normal"} <= set(entry):
                raise GraspError(f"{place} has an angle and a normal; keep one")
            check_keys(entry, ("point", direction, "friction"), entry, place)
            if direction == "normal":
                check_list(entry["normal"], f"{place}.normal", 2)
        if not any(x.has_letter for x in self._expressions):
            raise GraspError(f"the letter {self.letter} stands nowhere in the question")

    @cached_property
    def _expressions(self) -> list[Expression]:
        listed: list[Expression] = []
        mapped(self._read, lambda expression, _: listed.append(expression))
        return listed

    @cached_property
    def _read(self) -> dict[str, Any]:
        """The document with an `Expression` in place of each number that may have the letter."""
        return mapped(self.document, lambda x, name: read_expression(x, self.letter, name))

    @cached_property
    def is_angle(self) -> bool:
        """Whether the letter is an angle, and values are those of u."""
        entries = (entry for entry in self._read["contacts"] if isinstance(entry, Mapping))
        angles = any(entry["angle"].has_letter for entry in entries if "angle" in entry)
        return angles or any(expression.has_turn for expression in self._expressions)

    @staticmethod
    def degrees(value: Fraction) -> float:
        """Return an angle in degrees from the tangent of its half."""
        return math.degrees(2 * math.atan(value))

    def check(self, span: Span) -> None:
        """Refuse an interval of values at some of which the numbers make no question.

        Raises:
            InputError: a number is out of range, or divides by 0.
        """
        self.at((span.low + span.high) / 2)
        domain = Domain(span, letter=self.letter)
        self.contacts(domain)
        self.load(domain)

    def value(self, letter: Fraction) -> Fraction:
        """Return the value where the letter is a number; of an angle nearly.

        Raises:
            GraspError: an angle that is not above -180 and below 180 degrees.
        """
        if not self.is_angle:
            return letter
        if not -180 < letter < 180:
            raise GraspError(f"the angle is {to_text(letter)}; expected one above -180, below 180")
        if letter % 90 == 0:
            return Fraction(int(letter) // 90)
        return Fraction(math.tan(math.radians(letter) / 2)).limit_denominator(10**12)

    def at(self, value: Fraction) -> AnyQuestion:
        """Return the question of one value.

        Raises:
            InputError: the numbers make no question there.
        """
        value = Fraction(value)

        def number(expression: Expression, name: str) -> str:
            is_angle = name.endswith(".angle")
            return "0" if is_angle else to_text(self._value(expression, value, name))

        changed = mapped(self._read, number)
        for i, (entry, read) in enumerate(
            zip(changed["contacts"], self._read["contacts"], strict=True)
        ):
            if isinstance(entry, dict) and {"angle", "normal"} & entry.keys():
                entry.pop("angle", None)
                entry["normal"] = list(map(to_text, self._normal(read, value, f"contacts[{i}]")))
        if "bodies" in changed:
            assembly = Assembly.from_dict(changed)
            return assembly, assembly.read_wrenches(wrenches_of(changed) or {})
        wrench = check_list(changed.pop("wrench", ["0"] * SIZE), "wrench", SIZE)
        grasp = Grasp.from_dict(changed)
        grasp.require_plane()
        return grasp, grasp.read_wrench(wrench)

    def contacts(self, domain: Domain) -> list[FunctionContact]:
        """Return the contacts of all values of an interval.

        Raises:
            InputError: a number is out of range at some of them.
        """
        letter, contacts = Function.letter(domain), []
        for i, entry in enumerate(self._read["contacts"]):
            name = f"contacts[{i}]"

            def read(key: str, entry: Any = entry, name: str = name) -> Any:
                zero = Expression("number", (Fraction(_DEFAULTS[key]),))
                value = letter * 0 + self._value(entry.get(key, zero), letter, f"{name}.{key}")
                if -1 in value.signs():
                    raise GraspError(
                        f"{name}: {key} is {value}, below 0 for some values in {domain.span}"
                    )
                return value

            point = tuple(self._value(x, letter, f"{name}.point") for x in entry["point"])
            friction, stiffness, preload, adhesion = map(read, VALUES)
            normal = self._normal(entry, letter, name)
            bodies = entry.get("body_a"), entry.get("body_b")
            values = friction, stiffness, preload, adhesion
            share = rational(entry.get("share", 1), f"{name}.share")
            contacts.append(FunctionContact(point, normal, *values, bodies, share))
        try:
            groups_of(contacts)
        except Undecided:
            raise GraspError(
                "points of a pad are not in one line along it for some value; choose another "
                "interval, or leave share out"
            ) from None
        return contacts

    @cached_property
    def names(self) -> tuple[str, ...] | None:
        """The names of the bodies of an assembly; None of a grasp."""
        if "bodies" not in self.document:
            return None
        return tuple(x["name"] if isinstance(x, Mapping) else x for x in self.document["bodies"])

    def load(self, domain: Domain) -> tuple[Any, ...]:
        """Return the wrench, of an assembly those on all bodies in a row, for an interval."""
        letter, zero = Function.letter(domain), Function.constant(0, domain)
        none = [Expression("number", (Fraction(0),))] * SIZE
        if self.names is None:
            rows = [self._read.get("wrench", none)]
        elif "wrench" in self._read:
            rows = [self._read["wrench"].get(name, none) for name in self.names]
        else:
            return tuple(x for body in self._read["bodies"] for x in self._weight(body, letter))
        return tuple(zero + self._value(x, letter, "wrench") for row in rows for x in row)

    def _weight(self, body: Any, letter: Function) -> tuple[Any, ...]:
        zero = letter * 0
        if not isinstance(body, Mapping) or "weight" not in body:
            return zero, zero, zero
        weight = self._value(body["weight"], letter, "weight")
        own = {key: x for key, x in body.items() if key != "weight"}
        read = mapped_one(own, lambda e, name: zero + self._value(e, letter, name))
        try:
            x, _ = RigidBody.from_dict(read).middle
        except Undecided:
            raise GraspError(
                f"the centre of {body['name']} is undefined for some value; choose another interval"
            ) from None
        return zero, zero - weight, zero - weight * x

    def _value(self, expression: Expression, value: Any, name: str) -> Any:
        if not isinstance(expression, Expression):
            raise GraspError(f'{name} is not a number or an expression; write such as "2*t"')
        try:
            return expression.value(value, of_half_tangent(value) if self.is_angle else None)
        except (ZeroDivisionError, Undecided):
            raise GraspError(
                f"{name} divides by 0 for some value; choose another interval"
            ) from None
        except InputError as error:
            raise GraspError(f"{name}: {error}") from None

    def _normal(self, entry: Mapping[str, Any], value: Any, name: str) -> tuple[Any, ...]:
        if "angle" in entry:
            angle = entry["angle"]
            if angle.has_letter:
                return tuple(angle.turned(of_half_tangent(value)))
            quarters = Fraction(angle.value(None)) / 90
            if quarters.denominator != 1:
                raise GraspError(
                    f"{name}: angle is {to_text(90 * quarters)}; without the letter it is a "
                    "multiple of 90. Give a normal"
                )
            return ((1, 0), (0, 1), (-1, 0), (0, -1))[int(quarters) % 4]
        x, y = (
            self._value(part, value, f"{name}.normal")
            for part in check_list(entry["normal"], f"{name}.normal", 2)
        )
        square = x * x + y * y
        length: Any = None
        try:
            if isinstance(square, Function):
                length = square_root(square)
            elif square:
                length = exact_root(square)
            else:
                raise ZeroDivisionError
        except (ZeroDivisionError, Undecided):
            raise GraspError(
                f"{name}: the normal is 0 for some value; choose another interval"
            ) from None
        if length is None:
            raise GraspError(
                f"{name}: the length of the normal is no rational function; expected one such as "
                "[2*t, 1 - t^2], or an angle"
            )
        return x / length, y / length


def interval(low: Any, high: Any) -> Span:
    """Return the interval between two numbers.

    Raises:
        InputError: the first is above the second.
    """
    ends = rational(low, "low"), rational(high, "high")
    if ends[0] > ends[1]:
        raise GraspError(f"low is {shown(low)} and high is {shown(high)}; expected low below high")
    return Span(*ends)


def mapped(document: Mapping[str, Any], change: Callable[[Any, str], Any]) -> dict[str, Any]:
    """Return a document with something in place of each number that may have a letter.

    Args:
        change: gets a number, or what stands in its place, and where it stands.
    """
    changed = dict(document)
    for kind, keys in _MAY_VARY.items():
        if kind in changed:
            listed = enumerate(check_list(changed[kind], kind))
            changed[kind] = [mapped_one(x, change, keys, f"{kind}[{i}]") for i, x in listed]
    if "wrench" in changed:
        changed["wrench"] = deep(changed["wrench"], change, "wrench")
    return changed


def mapped_one(
    entry: Any,
    change: Callable[[Any, str], Any],
    keys: tuple[str, ...] = _MAY_VARY["bodies"],
    name: str = "the body",
) -> Any:
    """Return one entry of a list of a document with numbers changed as by `mapped`."""
    if not isinstance(entry, Mapping):
        return entry
    pairs = entry.items()
    return {k: deep(x, change, f"{name}.{k}") if k in keys else x for k, x in pairs}


def deep(
    value: Any, change: Callable[[Any, str], Any], name: str = "", plain: Container[str] = ()
) -> Any:
    """Return a part of a document with something in place of each number.

    Args:
        change: see `mapped`.
        plain: keys whose values have no numbers.
    """
    if isinstance(value, Mapping):
        pairs = value.items()
        return {k: x if k in plain else deep(x, change, f"{name}.{k}", plain) for k, x in pairs}
    if isinstance(value, list):
        return [deep(x, change, f"{name}[{i}]", plain) for i, x in enumerate(value)]
    return change(value, name)
