"""What regions are called in a picture, and the legend that says it."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import cached_property
from typing import Annotated, Any, TypeAlias

from arrangement.arrangement import Arrangement
from arrangement.console.number_form import counted
from arrangement.console.options.signature import Syntax
from arrangement.drawing.colours import GREY, Colouring, DrawnRegion
from arrangement.drawing.labels import sign_text
from arrangement.drawing.scene import POINTS, Legend, Scene, Symbol
from arrangement.errors import InputError, refusal
from arrangement.numbers import exact
from arrangement.numbers.exact import IntegerVector, shown, sum_text, to_text
from arrangement.planes.planes import Planes

#: Of regions: a word, or some regions, by sign vector or number, with or without texts.
Labels: TypeAlias = Annotated[str | Mapping[Any, str] | Iterable[Any], Syntax(metavar="NAME")]

LABELS = ("signs", "numbers", "none")
_PLANES = "texts at lines and planes are names, such as 1=a,2=b"
#: Planes up to which sign vectors are written of themselves.
SHORT = 4
#: Regions up to which they are numbered of themselves, and up to which a table explains numbers.
MOST, TABLED = 150, 24
#: A space as wide as a digit.
FIGURE = "\u2007"


class RegionLabels:
    """The names of regions, and the table that explains numbers.

    Numbers are 1, 2, ... in the order of `Arrangement.regions`.

    Attributes:
        arrangement: the planes, with their names.
        kind: "signs", "numbers" or "none".
        requested: whether labels were asked for; only then a note says which have no room.
        items: what the picture shows of the hyperplanes: "lines", "circles", "planes".
        left_out: how many regions were too small for a label.
        unseen: how many are narrower than a line.
        joined: whether lines nearer than their width are drawn as one.
    """

    def __init__(
        self,
        arrangement: Arrangement,
        labels: Labels | None,
        count: int | None = None,
        most: int = MOST,
        items: str = "",
    ) -> None:
        """Choose the names.

        Args:
            count: of the regions that are drawn, if not all are.
            most: regions that have labels of themselves; more have none.
        """
        self.items = items or items_of(arrangement)
        self.arrangement, self._own = arrangement, None
        if isinstance(labels, bool):
            labels = None if labels else "none"
        if labels is not None and labels not in LABELS:
            self._own = self._read(labels)
            own = set(self._own.values()) - {None}
            labels = ("signs" if len(arrangement) <= SHORT else "numbers") if not own else "own"
        self.kind = labels or ("signs" if len(arrangement) <= SHORT else "numbers")
        self.requested, self._tabled = labels is not None, math.inf if labels else TABLED
        if labels is None and self.kind == "numbers":
            count = len(arrangement.regions()) if count is None else count
            if count > most:
                self.kind = "none"
        self.left_out = self.unseen = 0
        self.joined = False

    def _read(self, labels: Labels) -> dict[tuple[int, ...], str | None]:
        """Return the texts of some regions, None for the usual one.

        Raises:
            InputError: no such region, or an unknown word.
        """
        pairs: Iterable[tuple[Any, str | None]]
        if isinstance(labels, Mapping):
            pairs = labels.items()
        elif isinstance(labels, str):
            parts = [part.partition("=") for part in labels.split(",")]
            pairs = [(key.strip(), text or None) for key, _, text in parts]
            if not all(set(key) <= {*"+-0123456789"} for key, _ in pairs):
                remedy = f"write a text for each region, such as +-+=A,3=B, {_PLANES}, or one of"
                raise refusal(f"the labels are {shown(labels)}", labels, LABELS, remedy)
        else:
            pairs = ((key, None) for key in labels)
        return {self.signs_of(key): text for key, text in pairs}

    def signs_of(self, key: Any) -> tuple[int, ...]:
        """Return the signs of a region that is named by its number, or by its signs.

        Raises:
            InputError: no such region.
        """
        signs: Any = key
        if isinstance(key, str) and not key.isdecimal():
            signs = ({"+": 1, "-": -1}.get(sign, 0) for sign in key)
        elif isinstance(key, (str, int)):
            signs = next((s for s, number in self._numbers.items() if number == int(key)), ())
        vector: tuple[int, ...] = tuple(signs)
        if vector not in self._numbers:
            raise InputError(f"there is no region {shown(key)}; give signs or a number; {_PLANES}")
        return vector

    @cached_property
    def _numbers(self) -> dict[tuple[int, ...], int]:
        return {face.signs: k + 1 for k, face in enumerate(self.arrangement.regions())}

    @property
    def numbers(self) -> dict[str, int]:
        """The number of each region, by its signs as text."""
        return {exact.sign_text(signs): k for signs, k in self._numbers.items()}

    def element(self, kind: str, signs: Sequence[int]) -> str:
        """Return the name of what stands for a region in a file: its number, as in ``region-3``."""
        return f"{kind}-{self._numbers[tuple(signs)]}"

    def forms(self, signs: Sequence[int]) -> list[str]:
        """Return the name of a region, four signs also in two rows; nothing if it has none."""
        if self._own is not None and (tuple(signs) not in self._own or self._own[tuple(signs)]):
            return [text] if (text := self._own.get(tuple(signs))) else []
        if self.kind in ("numbers", "own"):
            return [str(self._numbers[tuple(signs)])]
        if self.kind == "none" or not signs:
            return []
        square = [f"{sign_text(signs[:2])}\n{sign_text(signs[2:])}"] * (len(signs) == 4)
        return [sign_text(signs), *square]

    def explain(self, legend: Legend, drawn: Iterable[Sequence[int]]) -> None:
        """Add to a legend what the numbers of the regions drawn mean, and say what was left out."""
        listed = [tuple(signs) for signs in drawn]
        if self.kind == "numbers" and listed:
            legend.line(f"regions by number; numbers of {self.items} are italic")
        if self._own is not None:
            listed = [signs for signs in listed if signs in self._own]
        if self.kind == "numbers" and 0 < len(listed) <= self._tabled:
            named = sorted((self._numbers[signs], sign_text(signs)) for signs in listed)
            digits = len(str(named[-1][0]))
            legend.table += [f"{str(k).rjust(digits, FIGURE)} {text}" for k, text in named]
        if self.unseen:
            among = "region is" if self.unseen == 1 else "regions are"
            text = f"{self.unseen} {among} narrower than a line and cannot be seen"
            legend.line(text)
            legend.note(text)
        if self.left_out > self.unseen and self.requested:
            legend.note(f"{counted(self.left_out - self.unseen, 'region')} too small for a label")


#: Width and half the height of a symbol, in points.
WIDTH, HALF = 5.5 * POINTS, 1.2 * POINTS


def canvas() -> Scene:
    """Return a scene in which to draw a symbol about the left end of the horizontal axis."""
    return Scene(WIDTH / POINTS, 2 * HALF / POINTS)


def swatch(fill: str, **style: Any) -> Symbol:
    """Return a filled rectangle."""
    scene = canvas()
    corners = [(0, -HALF), (WIDTH, -HALF), (WIDTH, HALF), (0, HALF)]
    scene.polygon(corners, **{"fc": fill, "ec": GREY, "lw": 0.4, **style})
    return scene.items, WIDTH


def stroke(**style: Any) -> Symbol:
    """Return a line."""
    scene = canvas()
    scene.line([(0, 0), (WIDTH, 0)], **style)
    return scene.items, WIDTH


def vertex_symbol(shape: str, **style: Any) -> Symbol:
    """Return a vertex, "round" or "square"."""
    scene = canvas()
    scene.marker((WIDTH / 2, 0), 2.8, shape, **{"ec": "black", **style})
    return scene.items, WIDTH


def explain_regions(
    scene: Scene, colours: Colouring, names: RegionLabels, drawn: Collection[DrawnRegion]
) -> None:
    """Add to the legend of a scene the colours of the regions drawn, and their numbers."""
    scene.numbers = names.numbers
    for fill, text in colours.keys(drawn):
        scene.legend.key(swatch(fill, ec="black", lw=0.5), text)
    names.explain(scene.legend, [region.signs for region in drawn])


#: From this many circles on lines are thinner.
_MANY = 15


def thinner(count: int) -> float:
    """Return by what lines are multiplied where this many planes are drawn."""
    return min(1.0, math.sqrt(_MANY / max(1, count)))


def items_of(planes: Planes) -> str:
    """Return what hyperplanes are called in their space."""
    return {2: "lines", 3: "planes"}.get(planes.dimension, "hyperplanes")


def plane_names(planes: Planes, members: Sequence[int], count: int | None = None) -> str:
    """Return the names of planes, or else numbers from 1 on, runs of four and more as ``5-9``."""
    own = planes.names
    members = [k for k in members if count is None or k < count]
    parts = [own[k] for k in members if own[k : k + 1] > ("",)]
    numbers = [k + 1 for k in members if own[k : k + 1] <= ("",)]
    while numbers:
        run = 1
        while run < len(numbers) and numbers[run] == numbers[0] + run:
            run += 1
        if run >= 4:
            parts.append(f"{numbers[0]}\u2013{numbers[run - 1]}")
        else:
            parts += map(str, numbers[:run])
        numbers = numbers[run:]
    return ",".join(parts)


def names_on_paper(
    legend: Legend,
    names: RegionLabels,
    classes: Sequence[Sequence[int]],
    distance: Callable[[int, int], float],
    nearest: float,
    count: int | None = None,
) -> dict[int, str]:
    """Return the names of classes of planes, by the first one of those that look like one.

    Classes that are nearer than a line's width have a joint name, and the legend says so.

    Args:
        distance: between two classes on paper, by their numbers.
        nearest: the width of a line.
        count: of planes; later ones have no name.
    """
    groups: list[list[int]] = []
    for k in range(len(classes)):
        group = next((own for own in groups if distance(own[0], k) < nearest), None)
        if group is None:
            groups.append([k])
        else:
            group.append(k)
    texts = [
        plane_names(names.arrangement, sorted(i for k in own for i in classes[k]), count)
        for own in groups
    ]
    joint = [text for text, own in zip(texts, groups, strict=True) if text and len(own) > 1]
    names.joined = bool(joint)
    if joint:
        text = f"{names.items} {'; '.join(joint)}: nearer than a line's width, drawn as one"
        legend.line(text)
        legend.note(text)
    return {own[0]: text for own, text in zip(groups, texts, strict=True) if text}


_LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def equation(normal: IntegerVector, offset: int = 0) -> str:
    """Return the equation of a plane, such as ``x - 2y + z = 0`` or ``2x + (1 + a) y = 0``."""
    names = "xyz" if len(normal) <= 3 else [f"x{k + 1}".translate(_LOW) for k in range(len(normal))]
    return f"{sum_text(zip(normal, names, strict=False), '', _factor)} = {to_text(offset)}"


def _factor(entry: Any) -> str:
    text = to_text(entry)
    if isinstance(entry, int):
        return text
    text = text.replace("*", "")
    return f"({text}) " if " " in text else f"{text} "


def generator_text(arrangement: Arrangement) -> str:
    """Return what the letter a in the numbers of a page is; nothing for rational planes."""
    return "" if arrangement.field is None else f"numbers in {arrangement.field!r}"
