"""The space and the coordinates in which planes are drawn.

*Space.* Planes of rank r in R^d are those of an arrangement in R^r, times a linear space. Most
views are made for one space, R^2, R^3 or R^4; planes are brought there, and a caption says so.

*Coordinates.* A linear map makes symmetric arrangements look it and opens nearly parallel ones.
It changes no sign vector and no incidence. It is found in floats, rounded to rationals and applied
exactly.

*Symmetric.* The group of an arrangement is that of the linear maps that permute its planes, up to
sign and scale of the normals. The inner product of the given coordinates, averaged over the group,
is one that all of these maps keep: in its orthonormal coordinates they are rotations and mirrors.
The group itself is read off the angles in a position that depends on the planes alone: the one in
which unit normals, each weighted by the share of bases that it is in, have the same sum of squares
in every direction. It exists and is unique, up to the scales of independent parts [Barthe1998]:
the weights are a mean of all bases, so they lie inside the polytope of bases.
"""

from __future__ import annotations

import functools
import inspect
import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Annotated, Any, Concatenate, ParamSpec, TypeAlias

import numpy as np
import numpy.typing as npt

from arrangement.arrangement import Arrangement
from arrangement.console.options.signature import Syntax
from arrangement.console.progress import note
from arrangement.counts.configuration import pivot_columns
from arrangement.drawing.scene import Floats, Scene
from arrangement.drawing.solids.sight import unit, unit_vectors
from arrangement.drawing.views import DrawingView, Vector, picture
from arrangement.errors import InputError, refusal
from arrangement.library.families.classical import positive_roots
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, dot, primitive, shown
from arrangement.numbers.linear.rank import cross, rank
from arrangement.numbers.symbolic import real_vector
from arrangement.pictures.looks import (
    ColoursOption,
    NamesOption,
    give_looks,
    read_looks,
    read_names,
)
from arrangement.pictures.names import items_of
from arrangement.planes.planes import Planes

P = ParamSpec("P")

#: Names of axes, or True for those that suit.
AxisNames: TypeAlias = Annotated[str | bool, Syntax(metavar="NAMES", words="?", bare=True)]

RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
#: A linear map is rounded to multiples of 1 over this, or of a fraction of it.
_SCALE = 1 << 12
CHOICES = ("given", "symmetric", "even")
#: More than the roundings of a determinant of three unit vectors.
_SURE = 1e-12
#: Mean squares of unit normals below this, in some direction, make slivers.
NARROW = 0.08
_EVEN_ROUNDS, _ROUNDS = 12, 3000
_PULL = 0.1
#: Root systems by rank; others have the same roots up to order.
_TYPES = {2: ("A2", "B2", "C2", "G2"), 3: ("A3", "B3", "C3")}
#: The fewest maps of a group that is shown.
_LEAST = 3
#: Angles that differ by less are taken for equal.
_CLOSE = 1e-6
#: Below this, sums of squares are singular in floats.
_FLAT = 1e-12


@dataclass(frozen=True)
class Ranks:
    """Which planes a view shows: those of ranks from `least` to `most`, or only central ones."""

    most: float = math.inf
    central: bool = False
    least: int = 0

    def __call__(self, planes: Planes) -> bool:
        """Return whether it shows planes."""
        in_range = self.least <= planes.rank <= self.most
        return in_range and (planes.is_central or not self.central)


_CENTRAL, _ALL = Ranks(3, central=True), Ranks()
#: Which planes each view shows.
RANKS = {
    "sphere": _CENTRAL,
    "planes": Ranks(3),
    "cells": Ranks(3),
    "lines": Ranks(2),
    "stereographic": _CENTRAL,
    "gnomonic": _CENTRAL,
    "dual": _CENTRAL,
    "section": Ranks(4, central=True, least=4),
    "graph": _ALL,
    "poset": _ALL,
    "lattice": _ALL,
}
DUAL_MODEL = Ranks(4, central=True)


#: The options of every view of planes, for its docstring and its signature.
_TEXT = """    names: names of single planes, by number from 1, ``"1=ell,2=m"`` or ``{1: "ell"}``;
        or of all planes, in their order; if omitted, those of the file. Methods such as
        `Arrangement.deletion` number them from 0.
    colours: colours of single planes, by number or name, with or without a dash after a colon,
        ``"ell=gold,2=#0af:dashed,3=:dotted"``; solid, dashed or dotted.
"""
_OPTIONS: dict[str, Any] = {"names": NamesOption | None, "colours": ColoursOption | None}


def planes_view(
    name: str,
) -> Callable[
    [Callable[Concatenate[Arrangement, P], Scene]], DrawingView[Concatenate[Arrangement, P]]
]:
    """Return a decorator: `picture` of a view `name` that draws planes of any space.

    They are brought to the space of the view, and a caption says so. The view has the options
    names and colours.

    Raises:
        InputError: the view cannot show the planes; others that can are named.
    """

    def decorate(
        view: Callable[Concatenate[Arrangement, P], Scene],
    ) -> DrawingView[Concatenate[Arrangement, P]]:
        @functools.wraps(view)
        def draw(arrangement: Arrangement, /, *args: Any, **options: Any) -> Scene:
            names, colours = options.pop("names", None), options.pop("colours", None)
            planes = arrangement if names is None else arrangement.named(read_names(names))
            looks = None if colours is None else read_looks(colours, planes)
            scene = view(in_view_space(planes, name), *args, **options)
            if text := caption(planes, _dimension(name, planes)):
                scene.legend.captions.append(text)
            if looks is not None:
                give_looks(scene, planes, looks)
            return scene

        made: Any = draw
        made.__doc__ = inspect.cleandoc(view.__doc__ or "").replace(
            "\nRaises:", f"{_TEXT}\nRaises:"
        )
        made.__annotations__ = {**view.__annotations__, **_OPTIONS}
        signature = inspect.signature(view)
        more = [
            inspect.Parameter(option, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind)
            for option, kind in _OPTIONS.items()
        ]
        made.__signature__ = signature.replace(parameters=[*signature.parameters.values(), *more])
        return picture()(made)

    return decorate


def in_view_space(arrangement: Arrangement, name: str, ranks: Ranks | None = None) -> Arrangement:
    """Return planes in the space in which a view, model or page draws them.

    Args:
        ranks: those that it shows, if it is not a view.

    Raises:
        InputError: it cannot show them.
    """
    budget.check_size(len(arrangement), "planes in a picture")
    shown = ranks or RANKS[name]
    if not shown(arrangement):
        kind = "central" if arrangement.is_central else "affine"
        others = [view for view, own in RANKS.items() if own(arrangement)]
        raise InputError(
            f"{name} shows {'central ' * shown.central}planes of rank "
            f"{'at most ' * (not shown.least)}{shown.most}; these are {kind}, of rank "
            f"{arrangement.rank} in R^{arrangement.dimension}: "
            f"for them there are {', '.join(others)}"
        )
    return in_space(arrangement, _dimension(name, arrangement))


def _dimension(name: str, planes: Planes) -> int:
    flat = name == "lines" or (name == "graph" and not planes.is_central)
    return max(2 if flat else 3, planes.rank)


@dataclass(frozen=True)
class Symmetry:
    """The linear maps that permute some lines, as matrices in a common orthonormal frame.

    Attributes:
        frame: normals n become ``frame n`` in it, points x ``frame^-T x``.
        group: (g, d, d) orthogonal matrices, one of each pair A, -A.
        shape: normals n become ``shape n`` in symmetric coordinates, the nearest to the given ones.
    """

    frame: Floats
    group: Floats
    shape: Floats

    def stabilizers(self, points: Floats) -> npt.NDArray[np.int64]:
        """Return for each line through a point how many maps of the group keep it."""
        framed = unit(points @ np.linalg.inv(self.frame))
        kept = np.abs(np.einsum("pi,gij,pj->pg", framed, self.group, framed)) > 1 - _CLOSE
        return np.asarray(kept.sum(axis=1))

    def turned(self) -> Floats:
        """Return two orthonormal vectors in the frame, of a plane that turns by the least angle."""
        values, vectors = np.linalg.eig(np.concatenate([self.group, -self.group]))
        angles = np.where(values.imag > _CLOSE, np.angle(values), 4.0)
        least = np.unravel_index(np.argmin(np.round(angles, 6)), angles.shape)
        vector = vectors[least[0], :, least[1]]
        return unit(np.array([vector.real, vector.imag]))


def in_coordinates(
    coordinates: str | None, arrangement: Arrangement, direction: Vector | None = None
) -> tuple[Arrangement, Vector | None, Callable[[Floats], Floats]]:
    """Return planes in the coordinates in which they are drawn, a direction, and a map of points.

    Args:
        coordinates: "given"; "symmetric", in which the maps that permute the planes are rotations
            and mirrors (where they are few, the given ones); "even", with normals spread evenly.
            None: given if they have a meaning (`Planes.axes`), else symmetric, or even for nearly
            parallel planes that have no other symmetric ones. Lines of R^2 and planes off the
            origin have symmetric ones if they are those of a root system (see `root_map`).
        arrangement: planes in R^3, lines in R^2, or central planes of full rank in any space; other
            ones are returned as they are.
        direction: of points, in given coordinates, from which the map of points is, too.

    >>> skew = Arrangement([[1, 0, 0], [1, 1, 0], [1, 1, 1]])
    >>> in_coordinates("symmetric", skew)[0].f_vector == skew.f_vector
    True
    """
    matrix = coordinate_map(coordinates, arrangement)
    if matrix is None:
        return arrangement, direction, lambda point: point
    rows, scale = rounded_map(matrix, 1 << 10)
    moved = apply_map(rows, scale, arrangement)
    if direction is not None and len(rows) == 3:
        view = real_vector(direction, "camera")
        if len(view) == 3:
            one, two, three = rows
            cofactors = (cross(two, three), cross(three, one), cross(one, two))
            direction = [dot(row, view) for row in cofactors]
    inverse: Floats = scale * np.linalg.inv(np.array(rows, float)).T
    return moved, direction, lambda point: np.asarray(inverse @ point)


def coordinate_map(coordinates: str | None, arrangement: Arrangement) -> Floats | None:
    """Return the matrix for normals of `in_coordinates`, None for none."""
    chosen = coordinates or ("given" if arrangement.axes else "symmetric")
    if chosen not in CHOICES:
        raise refusal(f"the coordinates are {shown(chosen)}", chosen, CHOICES)
    full = arrangement.rank == arrangement.dimension
    spatial = arrangement.dimension == 3 or (full and arrangement.dimension > 3)
    if not (arrangement.is_central and spatial):
        return None if chosen != "symmetric" else root_map(arrangement)
    normals = unit_vectors([plane[:-1] for plane in arrangement.distinct_planes])
    matrix = even_map(normals) if full and chosen == "even" else None
    if chosen == "symmetric":
        matrix = symmetric_map(arrangement)
    if matrix is None and coordinates is None and full and is_narrow(normals):
        matrix = even_map(normals)
        note(
            f"the {items_of(arrangement)} are nearly parallel: drawn with normals spread evenly "
            "(--coordinates given: as they are)"
        )
    return matrix


def apply_map(rows: Sequence[IntegerVector], scale: int, planes: Planes) -> Arrangement:
    """Return planes whose normals are multiplied by an integer matrix over a scale."""
    return Arrangement(
        [[dot(row, plane[:-1]) for row in rows] for plane in planes.integer_planes],
        [scale * offset for offset in planes.offsets],
        names=planes.names,
    )


def root_map(arrangement: Planes) -> Floats | None:
    """Return the matrix for normals after which roots have the angles of their system, or None.

    The planes are those of an irreducible root system of rank 2 or 3, all roots with the same
    offsets: Coxeter arrangements and the deformations of Shi,
    Catalan and Linial. Normals are coefficients of simple roots. The sum of the squares of all
    roots is the inner product of points that reflections keep.
    """
    size = arrangement.dimension
    if arrangement.field is not None or size not in _TYPES:
        return None
    offsets: dict[IntegerVector, set[Fraction]] = {}
    for plane in arrangement.integer_planes:
        root = primitive(plane[:-1])
        way = -1 if min(root) < 0 else 1
        factor = next(Fraction(x, y) for x, y in zip(plane, root, strict=False) if y)
        offset = plane[-1] * way / factor
        offsets.setdefault(tuple(way * x for x in root), set()).add(offset)
    known = any(offsets.keys() == set(positive_roots(name)) for name in _TYPES[size])
    if not known or len(set(map(frozenset, offsets.values()))) > 1:
        return None
    roots = np.array(list(offsets))
    return _unimodular(np.linalg.inv(np.linalg.cholesky((roots.T @ roots).astype(float))))


def symmetric_map(arrangement: Arrangement) -> Floats | None:
    """Return the matrix for normals that makes planes symmetric; None where it changes nothing."""
    group = symmetry(arrangement)
    if group is None or np.allclose(group.shape, np.eye(arrangement.dimension), atol=1e-6):
        return None
    return group.shape


def symmetry(arrangement: Planes) -> Symmetry | None:
    """Return the group of central planes of full rank, or of rank 2 in R^3; None if it is small.

    Small: the identity and one more map at most, up to sign; one mirror alone says too little about
    good coordinates. In rank 2 the common line of the planes counts as one more normal.
    """
    size = arrangement.dimension
    firsts = [plane[:size] for plane in arrangement.distinct_planes]
    if arrangement.rank == 2 and size == 3:
        firsts.append(primitive(cross(firsts[0], firsts[1])))
    elif arrangement.rank < size:
        return None
    # As many bases as there are triples of planes in R^3.
    bases = math.comb(budget.max_size("planes whose symmetry is looked for"), 3)
    if math.comb(len(firsts), size) > bases:
        most = next(n for n in itertools.count(size) if math.comb(n + 1, size) > bases)
        note(f"no symmetry is looked for beyond {most} planes; given coordinates are drawn")
        return None
    normals = unit_vectors(firsts)
    frame = _balance(normals, _base_shares(firsts, normals))
    if frame is None:
        note("the symmetry of the planes was not found; given coordinates are drawn")
        return None
    group = _group(unit(normals @ frame.T))
    if len(group) < _LEAST:
        return None
    back = np.linalg.inv(frame)
    mean: Floats = np.einsum("gki,kl,glj->ij", group, back.T @ back, group) / len(group)
    sizes, axes = np.linalg.eigh(frame.T @ mean @ frame)
    return Symmetry(frame, group, _unimodular((axes * np.sqrt(sizes)) @ axes.T))


def orbits(arrangement: Planes, regions: Sequence[tuple[int, ...]]) -> list[int]:
    """Return for each region the number of its orbit, small orbits first.

    The group is that of `symmetry`, with the map to opposite points. Its maps are used as
    permutations of planes, which are checked to take regions to regions.

    Args:
        regions: the sign vectors of all of them.
    """
    import networkx as nx

    signs = np.array(regions, dtype=np.int8).reshape(len(regions), -1)[:, list(arrangement.firsts)]
    number = {row.tobytes(): k for k, row in enumerate(signs)}
    graph: Any = nx.empty_graph(len(regions))
    group = symmetry(arrangement)
    images = [-signs]
    normals = unit_vectors([plane[:-1] for plane in arrangement.distinct_planes])
    for matrix in () if group is None else group.group:
        units = unit(normals @ group.frame.T) if group else normals
        cosines = units @ matrix @ units.T
        to = np.abs(cosines).argmax(axis=0)
        image = np.zeros_like(signs)
        image[:, to] = signs * np.sign(cosines[to, np.arange(len(to))]).astype(np.int8)
        images.append(image)
    for image in images:
        taken = [number.get(row.tobytes()) for row in image]
        if None not in taken:
            graph.add_edges_from(enumerate(taken))
    parts = sorted(map(sorted, nx.connected_components(graph)), key=lambda part: (len(part), part))
    of = {region: k for k, part in enumerate(parts) for region in part}
    return [of[region] for region in range(len(regions))]


def _base_shares(normals: Sequence[IntegerVector], units: Floats) -> Floats:
    """Return the share of the bases that have each normal; exact counts, their sum is d.

    Where the determinant of the unit vectors, in floats, is above all roundings, it is not 0.
    """
    size = units.shape[1]
    chosen = np.array(list(itertools.combinations(range(len(normals)), size))).reshape(-1, size)
    bases = np.abs(np.linalg.det(units[chosen])) > _SURE
    for n in np.flatnonzero(~bases).tolist():
        bases[n] = rank([normals[i] for i in chosen[n].tolist()]) == size
    counts = np.bincount(chosen[bases].ravel(), minlength=len(normals)).astype(float)
    shares: Floats = counts * (size / counts.sum())
    return shares


def _balance(normals: Floats, weights: Floats) -> Floats | None:
    """Return a matrix after which weighted unit normals have the identity as sum of squares."""
    frame = whole = np.eye(normals.shape[1])
    for _ in range(_ROUNDS):
        moved = unit(normals @ frame.T)
        squares = (moved.T * weights) @ moved
        if np.abs(squares - whole).max() < _CLOSE / 100:
            return frame
        if np.linalg.eigvalsh(squares)[0] < _FLAT:
            return None
        frame = inverse_root(squares) @ frame
        if np.linalg.cond(frame) > 1 / _FLAT:
            return None
        frame = _unimodular(frame)
    return None


def _group(units: Floats) -> Floats:
    """Return the orthogonal maps that permute lines, (g, d, d), one of each pair A, -A.

    A map is known by what it does to d independent lines; all that have the same angles are
    tried, with all signs.
    """
    size = units.shape[1]
    angles = np.abs(units @ units.T)
    base, images = [0], np.arange(len(units))[:, None]
    while len(base) < size:
        # The line farthest from those that are chosen.
        span = np.linalg.qr(units[base].T)[0]
        base.append(int(np.argmax(np.linalg.norm(units - units @ span @ span.T, axis=1))))
        alike = [
            np.abs(angles[images[:, k]] - angles[b, base[-1]]) < _CLOSE
            for k, b in enumerate(base[:-1])
        ]
        rows, added = np.nonzero(np.all(alike, axis=0))
        images = np.column_stack([images[rows], added])
    back = np.linalg.inv(units[base].T)
    group = []
    for signs in itertools.product((1, -1), repeat=size - 1):
        maps = (units[images] * np.array([1, *signs])[:, None]).transpose(0, 2, 1) @ back
        square = maps.transpose(0, 2, 1) @ maps
        maps = maps[np.abs(square - np.eye(size)).max(axis=(1, 2), initial=0) < 10 * _CLOSE]
        taken = np.abs(units @ maps @ units.T).max(axis=1, initial=0)
        group.append(maps[taken.min(axis=1, initial=1) > 1 - _CLOSE])
    return np.concatenate(group)


def even_map(normals: Floats) -> Floats:
    """Return a matrix W of determinant 1 such that the directions of ``W n`` are spread evenly.

    Normals n become ``W n`` and points x become ``W^-T x``. The rounds are those of Tyler's
    estimator of scatter, pulled towards the identity, so that they end for every input.

    Args:
        normals: (c, d) unit vectors of distinct planes, of rank d.
    """
    size = normals.shape[1]
    whole = np.eye(size)
    for _ in range(_EVEN_ROUNDS):
        moved = unit(normals @ whole.T)
        scatter = (1 - _PULL) * size * moved.T @ moved / len(moved) + _PULL * np.eye(size)
        whole = inverse_root(scatter) @ whole
    return _unimodular(whole)


def is_narrow(normals: Floats) -> bool:
    """Return whether unit normals leave some direction nearly empty."""
    return bool(np.linalg.eigvalsh(normals.T @ normals / len(normals))[0] < NARROW)


def _unimodular(matrix: Floats) -> Floats:
    normed: Floats = matrix / np.linalg.det(matrix) ** (1 / len(matrix))
    return normed


#: How far an axis reaches, in radii of the body.
REACH = 1.2


INK = "#333333"


def drawn_axes(
    planes: Planes, axes: AxisNames | None, coordinates: str | None
) -> tuple[tuple[str, ...], str | None]:
    """Return the names of the axes, or nothing, and the coordinates in which planes are drawn.

    Args:
        planes: whose coordinates have names where they have a meaning.
        axes: such as ``"x,y,z"``; True for those names, or else these; or "none"; if omitted, those
            names, if there are any.
        coordinates: see `coordinates.in_coordinates`. Axes are those of the given ones.

    Raises:
        InputError: not three names, or axes asked for in other coordinates.
    """
    names = planes.axes
    if axes is True:
        names = names or ("x", "y", "z")
    elif axes is not None:
        names = tuple(name.strip() for name in axes.split(",")) if isinstance(axes, str) else ()
        if names == ("none",):
            return (), coordinates
        if len(names) != 3 or not all(0 < len(name) <= 12 for name in names):
            raise InputError(f"the axes are {shown(axes)}; give three names such as x,y,z, or none")
        if coordinates not in (None, "given"):
            raise InputError("axes are those of the given coordinates; leave out one of the two")
    if not names or coordinates not in (None, "given"):
        return (), coordinates
    return names, "given"


def within_reach(axes: Floats, half: float, most: float) -> float:
    """Return the radius of a body such that its axes, with names, stay in a square.

    Args:
        axes: (3, 3); the unit vectors of the coordinates, in the picture.
        half: half of the side of the square, in points.
        most: the radius without axes.
    """
    return min(most, (half - 9.0) / (REACH * float(np.abs(axes[:, :2]).max())))


def caption(planes: Planes, dimension: int) -> str:
    """Return what is said below a picture of planes in R^dimension; nothing in their own space."""
    if planes.dimension == dimension:
        return ""
    essential = "essentialisation of an " * (planes.dimension > planes.rank)
    space = f"arrangement in R{str(planes.dimension).translate(RAISED)}"
    return (
        f"{essential}{space}"
        + ("", ", times a line", ", times a plane", ", times R³")[dimension - planes.rank]
    )


def in_space(arrangement: Arrangement, dimension: int) -> Arrangement:
    """Return planes of rank r in R^n, n >= r, with the same signs, faces and offsets.

    The first r coordinates are orthonormal ones of the span of the normals, rounded: angles stay
    what they were but for less than 10^-3. The map is invertible, and applied exactly.

    >>> braid = Arrangement([[1, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]])
    >>> in_space(braid, 3).rank
    3
    """
    if arrangement.dimension == dimension:
        return arrangement
    normals = [plane[:-1] for plane in arrangement.integer_planes]
    columns = pivot_columns(normals, arrangement.dimension)
    scale, rows = 1, list(map(tuple, np.eye(len(columns), dtype=int).tolist()))
    if len(columns) < arrangement.dimension and columns:
        rows, scale = rounded_map(_isometry(normals, columns), _SCALE // 8)
    zeros = (0,) * (dimension - len(columns))
    chosen = ([normal[j] for j in columns] for normal in normals)
    return Arrangement(
        [(*(dot(row, normal) for row in rows), *zeros) for normal in chosen],
        [offset * scale for offset in arrangement.offsets],
        dimension=dimension,
        names=arrangement.names,
    )


def _isometry(normals: Sequence[IntegerVector], columns: Sequence[int]) -> Floats:
    """Return the symmetric matrix that makes chosen coordinates of normals orthonormal ones."""
    largest = [max(map(abs, normal)) for normal in normals]
    scaled = [[x / most for x in n] for n, most in zip(normals, largest, strict=True)]
    span = np.linalg.svd(np.array(scaled), full_matrices=False)[2][: len(columns), columns]
    return inverse_root(span.T @ span)


def inverse_root(squares: Floats) -> Floats:
    """Return the inverse of the symmetric root of a matrix of sums of squares."""
    sizes, axes = np.linalg.eigh(squares)
    root: Floats = (axes / np.sqrt(np.maximum(sizes, 1e-12))) @ axes.T
    return root


def rounded_map(matrix: Floats, scale: int) -> tuple[list[IntegerVector], int]:
    """Return an invertible integer matrix that is nearly a float one times a scale, and the scale.

    Args:
        scale: times 8, or a higher power of 8 where rounding leaves no inverse.
    """
    rows: list[IntegerVector] = []
    while rank(rows) < len(matrix):
        scale *= 8
        rows = [tuple(round(x * scale) for x in row) for row in matrix.tolist()]
    return rows, scale
