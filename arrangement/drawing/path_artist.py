"""Scenes as artists and figures of matplotlib, which is imported with this module.

A patch is what a path looks like. In axes of the user each path has one; in a figure of ours the
paths of one style take turns, since making thousands of patches takes most of the time of a
picture.
"""

from __future__ import annotations

import operator
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fnmatch import fnmatchcase
from itertools import groupby
from typing import Any, ClassVar, TypeAlias

import numpy as np

from arrangement import synonyms
from arrangement.console.writing import write_bytes_atomically, write_text_atomically
from arrangement.drawing.layout import lay_out
from arrangement.drawing.output import (
    LEGENDS,
    PICTURES,
    THEMES,
    TIKZ,
    check_choice,
    ending,
    own_settings,
    picture_bytes,
)
from arrangement.drawing.scene import (
    DPI,
    LIGHT,
    SHADES,
    Ball,
    Item,
    Label,
    Mark,
    NarrowError,
    Path,
    Scene,
    require_matplotlib,
)
from arrangement.drawing.themes import apply_theme
from arrangement.errors import InputError, refusal
from arrangement.hints import HintsMixin
from arrangement.numbers.exact import shown, sign_text

try:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.colors import is_color_like, to_rgba
    from matplotlib.figure import Figure, FigureBase, SubFigure
    from matplotlib.patches import Circle, PathPatch, Rectangle
    from matplotlib.path import Path as Outline
    from matplotlib.patheffects import Normal, Stroke
    from matplotlib.transforms import Affine2D, Transform
except ImportError:
    require_matplotlib()  # says which extra brings it
    raise

#: What can be drawn into.
Room: TypeAlias = Axes | Figure | SubFigure

_HATCH_WIDTH = 0.35
#: In millimetres: in narrower axes letters and lines are smaller.
_NARROW = 70.0
#: Size of the image of a ball.
_PIXELS = 256


class Paths(Artist):
    """Paths, painted in their order; each is a group with its name, as a patch would be.

    Attributes:
        items: the paths.
        page: from points of the sheet to the display.
    """

    def __init__(self, items: Iterable[Path], page: Transform) -> None:
        super().__init__()
        self.items, self.page = tuple(items), page

    def draw(self, renderer: Any) -> None:
        """Draw all paths, each cut to its clip, or to the sheet."""
        assert self.axes is not None
        patches: dict[tuple[str, ...], PathPatch] = {}
        for item in self.items:
            # Thousands of paths have few styles.
            style = str(item.kind == "line"), repr(item.style), repr(item.clip)
            if style not in patches:
                patches[style] = patch(item, self.axes, self.page)
            shared = patches[style]
            shared.set_path(_outline(item))
            shared.set_gid(item.name or None)
            shared.draw(renderer)


def _outline(item: Path) -> Outline:
    points = item.points
    if item.kind == "circle":
        x, y = points.tolist()
        return Outline.circle((x, y), item.radius)
    if item.kind == "polygon":
        return Outline(np.concatenate([points, points[:1]]), closed=True)
    if item.kind == "line":
        return Outline(points)
    return Outline(points, [Outline.MOVETO] + [Outline.CURVE4] * (len(points) - 1))


def patch(item: Path, axes: Any, page: Transform) -> PathPatch:
    """Return a path as an artist, cut to its clip or to the axes."""
    style = dict(item.style)
    filled = item.kind != "line" and style.pop("fill", True)
    style.setdefault("ec", "none" if filled else "black")
    made = PathPatch(_outline(item), fill=filled, gid=item.name or None, **style)
    made.set_transform(page)
    made.set_hatch_linewidth(_HATCH_WIDTH)
    made.set_figure(axes.figure)
    if item.clip is None:
        made.set_clip_box(axes.bbox)
    elif len(item.clip) == 2:
        (x, y), radius = item.clip
        made.set_clip_path(Circle((x, y), radius, transform=page))
    else:
        left, low, right, high = item.clip
        box = Rectangle((left, low), right - left, high - low, transform=page)
        made.set_clip_path(box)
    return made


def figure(scene: Scene, made: Figure | None = None) -> Figure:
    """Return a scene as a figure with axes over the whole sheet, in which the picture is.

    They have the coordinates of the model where `PageMap` says that these are to scale, else points
    of the sheet. What is added to them is drawn on top.

    Args:
        made: an empty figure to be filled, instead of a new one; each further panel has axes, too.
    """
    panels = scene.maps[1:] if made is not None else []
    made = Figure() if made is None else made
    made.set_dpi(DPI)
    made.set_size_inches(scene.paper[0] / 25.4, scene.paper[1] / 25.4)
    axes: Any = made.add_axes((0.0, 0.0, 1.0, 1.0))
    for k, panel in enumerate([axes, *(made.add_axes((0.0, 0.0, 1.0, 1.0)) for _ in panels)]):
        _set_coordinates(panel, scene, k)
    _fill(axes, scene, lambda paths, page: [Paths(paths, page)])
    return made


def into(place: Room, make: Callable[[float], Scene]) -> Figure:
    """Draw into axes, or into new ones that fill a figure; every element is an artist of its own.

    Args:
        place: where to; what is there stays.
        make: returns the scene for a width in millimetres. It is asked for one as wide as the
            axes, or narrower where that one would be too high, but for none that is too narrow
            for its text: text and lines are made smaller then.

    Returns:
        The figure of the axes.
    """
    axes: Any = place.add_axes((0.0, 0.0, 1.0, 1.0)) if isinstance(place, FigureBase) else place
    owner = axes.figure
    while hasattr(owner, "_parent"):  # of a subfigure, whose size is its own
        owner = owner._parent
    box = axes.get_window_extent()
    room = [25.4 * length / owner.dpi for length in (box.width, box.height)]
    width, scene = max(room[0], _NARROW), None
    while scene is None:
        try:
            scene = make(width)
        except NarrowError:
            width *= 1.2
    for _ in range(3):
        if scene.paper[1] > room[1]:
            width = max(width * room[1] / scene.paper[1], _NARROW)
            with suppress(NarrowError):
                scene = make(width)
    scene = scene.enlarge(min(1.0, *map(operator.truediv, room, scene.paper)))
    _set_coordinates(axes, scene, 0)
    _fill(axes, scene, lambda paths, page: [patch(path, axes, page) for path in paths])
    axes.set_aspect("equal")  # an image has changed it
    return owner  # type: ignore[no-any-return]


def _set_coordinates(axes: Any, scene: Scene, panel: int) -> None:
    """Set limits of axes: coordinates of a panel where it is to scale, else points of the sheet."""
    ends: Any = (0.0, 0.0), (scene.width, scene.height)
    if scene.maps and scene.maps[panel].is_to_scale:
        ends = [scene.maps[panel].back(end) for end in ends]
    (left, low), (right, high) = ends
    axes.set(xlim=(left, right), ylim=(low, high))
    axes.set_axis_off()


def _fill(
    axes: Any, scene: Scene, artists: Callable[[list[Path], Transform], Iterable[Artist]]
) -> None:
    """Draw a scene into axes, its paths as the artists that are returned for them.

    Each takes points of the sheet, whatever coordinates the axes have; all are below what
    matplotlib draws.
    """
    page = Affine2D().scale(1 / scene.width, 1 / scene.height) + axes.transAxes
    runs = groupby(sorted(scene.items, key=lambda item: item.height), key=type)
    items_of_a_kind = [list(items) for _, items in runs]
    for k, items in enumerate(items_of_a_kind):
        order = k / len(items_of_a_kind)
        paths = [item for item in items if isinstance(item, Path)]
        for artist in artists(paths, page) if paths else ():
            axes.add_artist(artist).set_zorder(order)
        for item in () if paths else items:
            _draw(axes, page, item, {**item.style, "zorder": order})


def _draw(axes: Any, page: Transform, item: Item, style: dict[str, Any]) -> None:
    style = {**style, "transform": page}
    if item.name:
        style["gid"] = item.name
    if isinstance(item, Label):
        _write(axes, item, style)
    elif isinstance(item, Mark):
        axes.plot(
            *([x] for x in item.place), item.sign, ms=item.size, ls="none", clip_on=False, **style
        )
    elif isinstance(item, Ball):
        _shade(axes, page, item, style)


def _shade(axes: Any, page: Transform, item: Ball, style: dict[str, Any]) -> None:
    """Add a ball as a small image under its disc; neighbouring pixels differ by one shade."""
    middle = (np.arange(_PIXELS) + 0.5) / _PIXELS * 2 - 1
    x, y = np.meshgrid(middle, middle)
    fx, fy = LIGHT
    # The circle of size t has its centre at (1 - t) focus: |p - (1 - t) f| = t.
    px, py, rest = x - fx, y - fy, 1 - fx * fx - fy * fy
    along = px * fx + py * fy
    size = (along + np.sqrt(along**2 + rest * (px**2 + py**2))) / rest
    sizes, shares = np.array(SHADES).T
    share = np.interp(size, sizes, shares)[..., None]
    near, far = (np.array(to_rgba(colour)) for colour in (item.near, item.far))
    (cx, cy), r = item.centre, item.radius
    image = axes.imshow(
        near + share * (far - near),
        extent=(cx - r, cx + r, cy - r, cy + r),
        origin="lower",
        aspect="auto",
        interpolation="none",
        **style,
    )
    image.set_clip_path(Circle(item.centre, r, transform=page))


def _write(axes: Any, item: Label, style: dict[str, Any]) -> None:
    halo, plate = style.pop("halo", None), style.pop("plate", None)
    if plate is not None:
        style["bbox"] = plate
    place = {"size": item.size, "ha": item.ha, "va": item.va, "rotation": item.rotation}
    effects: list[Any] = [] if halo is None else [Stroke(linewidth=halo[0], foreground=halo[1])]
    if effects and require_matplotlib().rcParams["svg.fonttype"] == "none":
        # What has an effect becomes outlines; the letters on it stay letters.
        axes.text(*item.place, item.text, **place, linespacing=1.0, path_effects=effects, **style)
        effects = []
    effects = [*effects, Normal()] if effects else effects
    axes.text(*item.place, item.text, **place, linespacing=1.0, path_effects=effects, **style)


def finish(made: Scene, legend: str, theme: str, scale: float = 1.0) -> Scene:
    """Return a picture with its legend at a place, enlarged, in a theme; refuse unknown ones."""
    check_choice("legend", legend, LEGENDS)
    check_choice("theme", theme, THEMES)
    return apply_theme(lay_out(made, legend).enlarge(scale), theme)


def write_scene(
    path: str | os.PathLike[str],
    make: Callable[[], Scene],
    *,
    letters: bool = False,
    font: str | None = None,
    fragment: bool = False,
    dpi: int | None = None,
    transparent: bool = False,
) -> None:
    """Write the scene that `make` returns, as it is, in the format of the suffix.

    Raises:
        InputError: the suffix is not one of a picture, or there is no place to write.
        MissingExtraError: matplotlib is absent.
    """
    suffix = ending(path, (*PICTURES, *TIKZ))
    if suffix in TIKZ:
        from arrangement.drawing.tikz import tikz

        with own_settings():
            write_text_atomically(path, tikz(make(), fragment=fragment))
    else:
        content = picture_bytes(suffix, lambda: figure(make()), letters, dpi, font, transparent)
        write_bytes_atomically(path, content)


#: What elements are called that stand for regions, before the number, and for circles.
_REGIONS = ("region", "vertex", "cell")
_CIRCLES = ("front-{}-*", "limb-{}-*", "back-{}", "arc-{}-*", "line-{}", "edge-{}-*")
_FACETS = "facet-*-plane-{}"


#: Styles that can be changed, by what matplotlib calls them, too.
_STYLES = {"facecolor": "fc", "edgecolor": "ec", "linewidth": "lw", "linestyle": "ls"}
_STYLES |= {name: name for name in ("fc", "ec", "lw", "ls", "alpha", "hatch", "color")}


class Elements:
    """Some elements of a drawing, to be styled.

    Raises:
        InputError: the picture has none of these.
    """

    def __init__(self, drawing: Drawing, what: str, names: Sequence[str]) -> None:
        items = drawing.scene.items
        self._drawing = drawing
        self._found = [
            k for k, item in enumerate(items) if any(fnmatchcase(item.name, name) for name in names)
        ]
        if not self._found:
            known = sorted({item.name for item in items} - {""})
            raise InputError(f"the picture has no {what}; it has {shown(', '.join(known))}")

    def set(self, **style: Any) -> None:
        """Change their style, as `Drawing.restyle` does.

        Raises:
            InputError: a style that is unknown, or a colour that is none.
        """
        for name, value in style.items():
            if name not in _STYLES:
                raise refusal(f"there is no style {shown(name)}", name, _STYLES)
            if _STYLES[name] in ("fc", "ec", "color") and not is_color_like(value):
                raise InputError(f'{name} is {shown(value)}; give a colour, "gold" or "#0072b2"')
        own, items = {_STYLES[name]: x for name, x in style.items()}, self._drawing.scene.items
        if "color" in own and any(isinstance(items[k], Path) for k in self._found):
            raise InputError("color is for text; a shape has fc inside, and ec for its line")
        for k in self._found:
            items[k] = replace(items[k], style={**items[k].style, **own})
        self._drawing.clear()
        figure(lay_out(self._drawing.scene), self._drawing)


class Drawing(HintsMixin, Figure):
    """A picture with its legend: a figure of matplotlib that is written in every format.

    Attributes:
        scene: what is drawn, and the legend as data.
    """

    _synonyms: ClassVar[Mapping[str, str]] = {
        **{x: use.removeprefix("draw().") for x, use in synonyms.PICTURES.items() if "wr" in use},
        **synonyms.by_word("download export save save_as to_file write_file -> write(path)"),
    }
    _main: ClassVar[Mapping[str, str]] = {"picture": "write restyle region circle to_page axes"}

    def __init__(self, scene: Scene) -> None:
        super().__init__()
        self.scene = scene
        figure(lay_out(scene), self)

    def show(self, warn: bool = True) -> None:
        """Refuse to open a window, which figures without pyplot do not have."""
        raise AttributeError(
            "a Drawing has no window; a notebook shows it, and write('picture.svg') writes a file"
        )

    def to_page(self, point: Iterable[Any], panel: int = 1) -> tuple[float, float]:
        """Return where a point of the model is, in the coordinates of ``axes[panel - 1]``.

        In views that show a plane to scale, such as lines, grasp, resist and slice, the axes have
        the coordinates of the model, and this is the point itself. In space it has three
        coordinates: in views of a sphere they are a direction from the origin, cells are moved
        apart, and in the last panel of dual they are those of the polyhedron as it is drawn.

        Args:
            point: in the coordinates of the planes, of the grasp, or of the wrenches.
            panel: from 1, of a picture with several.

        Raises:
            InputError: points have no place in this picture, or this one has none.

        >>> from arrangement import Arrangement
        >>> drawn = Arrangement([[1, 0], [0, 1]], [2, 3]).draw("lines")
        >>> drawn.to_page((2, 3))
        (2.0, 3.0)
        """
        maps = lay_out(self.scene).maps
        if not maps:
            raise InputError("points of the model have no place in this picture")
        if not (isinstance(panel, int) and 0 < panel <= len(maps)):
            raise InputError(f"the panel is {shown(panel)}; expected 1 to {len(maps)}")
        chosen = maps[panel - 1]
        x, y = chosen.numbers(point) if chosen.is_to_scale else chosen.at(point)
        return float(x), float(y)

    def region(self, which: int | str | Sequence[int]) -> Elements:
        """Return what stands for a region, by its number, or its signs as numbers or ``"+-+"``."""
        text = str(which) if isinstance(which, (int, str)) else sign_text(which)
        number = self.scene.numbers.get(text, text)
        return Elements(self, f"region {shown(text)}", [f"{kind}-{number}" for kind in _REGIONS])

    def circle(self, number: int) -> Elements:
        """Return what stands for a plane: its circle or line, and the edges that cross it.

        Args:
            number: from 1; of coincident planes the first one.
        """
        return Elements(
            self, f"circle {number}", [name.format(number) for name in (*_CIRCLES, _FACETS)]
        )

    def restyle(self, name: str, **style: Any) -> None:
        """Change elements of the picture, in every format in which it is written afterwards.

        Args:
            name: of elements, such as ``region-2`` or ``front-*``.
            style: ``fc`` colour inside, ``ec`` of the line, ``lw`` its width in points, ``ls``,
                ``alpha``, ``hatch``; of text ``color``.

        Raises:
            InputError: the picture has no such element.
        """
        Elements(self, f"element {shown(name)}", [name]).set(**style)

    def write(
        self,
        path: str | os.PathLike[str],
        *,
        theme: str = THEMES[0],
        legend: str = LEGENDS[0],
        fragment: bool = False,
    ) -> None:
        """Write SVG, PDF, PNG or TikZ, the same bytes each time; see `Drawings.write`."""
        write_scene(path, lambda: finish(self.scene, legend, theme), fragment=fragment)
