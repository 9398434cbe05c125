"""The facade: hyperplanes together with their faces, counts, duals and pictures."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from . import counts, synonyms
from .console.plugins import method_code
from .counts import completeness
from .counts.operations import flat_chart
from .counts.whitney import f_vector, region_count
from .enumeration import regions
from .enumeration.choose import (
    enumerate_faces,
    enumerate_faces_inside,
    enumerate_regions,
    enumerate_regions_inside,
)
from .enumeration.great_circles import SphereArrangement, sphere_arrangement
from .enumeration.sequence import FaceSequence
from .enumeration.subdivision import Cut, cut
from .errors import InputError
from .numbers.exact import shown, vector_text
from .planes.drawable import DrawableArrangement
from .planes.faces import Face
from .planes.identification import Identification
from .planes.planes import Hyperplane, Planes
from .planes.polygon import Inside, bounding_planes

if TYPE_CHECKING:
    import networkx as nx
    import sympy

    from .duals.zonotope import Zonotope


class Arrangement(DrawableArrangement, Planes):
    """A hyperplane arrangement: finitely many hyperplanes in R^d, and its faces.

    The planes are ``n_i . x = b_i``. Each keeps its own orientation and its place in the input. It
    is stored as the positive multiple with coprime integer entries, so that equal planes compare
    equal: ``[2, 0, 0]`` and ``[1, 0, 0]`` give equal arrangements, ``[-1, 0, 0]`` does not (its
    sides are exchanged).

    Args:
        normals: m vectors of length d, exact numbers: integers, fractions, texts such as "7/3"
            (`from_equations` takes equations).
        offsets: m exact numbers; if omitted, all planes pass through the origin.
        dimension: d; needed only when there are no planes.
        axes, names: of the coordinates where these mean something, and of planes; see `Planes`.

    Raises:
        InputError: a float, a zero normal (named by its number, from 1), or lengths that differ.

    >>> three = Arrangement([[1, 0, 0], [0, 1, 0], ["1/2", "1/3", 1]])
    >>> three.f_vector
    (1, 6, 12, 8)
    """

    _synonyms: ClassVar[Mapping[str, str]] = {
        **synonyms.PICTURES,
        **synonyms.PAGES,
        **{word: name for words in synonyms.ARRANGEMENT.values() for word, name in words.items()},
    }
    _main: ClassVar[Mapping[str, str]] = {
        "describe": "dimension rank normals offsets is_central is_simple is_essential equations",
        "count": "f_vector region_count bounded_region_count characteristic_polynomial "
        "whitney_numbers",
        "list": "regions bounded_regions faces vertices sign_vectors circuits region_graph "
        "intersection_lattice",
        "find": "region_at face_at signs_at identify",
        "derive": "addition deletion restriction localization cone essentialization dual",
        "show and save": "draw lab save to_dict from_equations",
    }

    def iter_faces(self, dimension: int | None = None) -> Iterator[Face]:
        """Yield every face (of one dimension, if given) with an exact witness, as `faces` does."""
        return iter(self.faces(dimension))

    def faces(
        self,
        dimension: int | None = None,
        *,
        engine: str | None = None,
        inside: Inside | None = None,
    ) -> FaceSequence:
        """Return every face, or those of one dimension, lowest dimension first.

        Args:
            dimension: 0 to d.
            engine: one of `arrangement.enumeration.choose.ENGINES`, which says what each can do;
                if omitted, the best one for these planes.
            inside: as for `regions`: only the faces that meet the interior of the polyhedron.

        Raises:
            InputError: no such dimension or engine, or an engine that cannot do these planes.
            OutOfReachError: the list takes more than the budget (`arrangement.numbers.budget`).
        """
        if engine is None and type(dimension) is int and dimension == self.dimension:
            return self.regions(inside)
        if inside is not None:
            faces = enumerate_faces_inside(self, bounding_planes(inside), engine)
        else:
            faces = self._faces if engine is None else enumerate_faces(self, engine, f_vector)
        return faces if dimension is None else faces.of_dimension(dimension)

    @cached_property
    def _faces(self) -> FaceSequence:
        return enumerate_faces(self, count=f_vector)

    def regions(self, inside: Inside | None = None) -> FaceSequence:
        """Return the faces of full dimension: the cells that no plane meets.

        Many of them, from rank 5 on (4 for affine planes), are listed without the other faces.

        Args:
            inside: planes that bound a polyhedron, which is on the positive side of each, or a
                region of other planes, or the corners of a convex polygon in their order: only the
                regions that meet its interior are listed, each with a witness in it.

        Raises:
            OutOfReachError: the list takes more than the budget (`arrangement.numbers.budget`).

        >>> box = Arrangement([[1, 0], [0, 1], [-1, 0], [0, -1]], [0, 0, -1, -1])
        >>> len(Arrangement([[1, 1], [1, 1], [1, 1]], [0, 1, 5]).regions(inside=box))
        2
        """
        if inside is None:
            return self._regions
        return enumerate_regions_inside(self, bounding_planes(inside))

    @cached_property
    def _regions(self) -> FaceSequence:
        alone = enumerate_regions(self, region_count)
        return self._faces.of_dimension(self.dimension) if alone is None else alone

    def bounded_regions(self, *, relative: bool = False) -> FaceSequence:
        """Return the regions that are bounded in every direction.

        There are none unless the normals span R^d: otherwise every region contains a line.

        Args:
            relative: return those that are bounded in the span of the normals instead.

        >>> lines = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
        >>> [region.signs for region in lines.bounded_regions()]
        [(1, 1, -1)]
        >>> strips = Arrangement([[1, 0], [1, 0]], [0, 1])
        >>> len(strips.bounded_regions()), len(strips.bounded_regions(relative=True))
        (0, 1)
        """
        return regions.bounded_regions(self, self.regions(), relative=relative)

    def pieces(self, inside: Inside) -> Cut:
        """Count the pieces of lines of R^2 inside and outside of a convex polygon.

        The sides of the polygon are drawn: they bound its cells, and those around it.

        Args:
            inside: as for `regions`.

        Raises:
            InputError: planes of another space, or no such polygon.

        >>> cut = Arrangement([[1, 1], [1, -1]]).pieces([(1, 1), (-1, 1), (-1, -1), (1, -1)])
        >>> cut.inside.vertices, cut.inside.edges, cut.inside.cells, cut.outside.cells
        (1, 4, 4, 4)
        """
        return cut(self, bounding_planes(inside))

    def face_at(self, point: Iterable[Any]) -> Face:
        """Return the face that contains a point of R^d."""
        return Face.at(self, point)

    def region_at(self, point: Iterable[Any]) -> Face:
        """Return the region that contains a point of R^d.

        Raises:
            InputError: if a plane goes through the point; `face_at` has no such rule.
        """
        face = self.face_at(point)
        if not all(face.signs):
            where = [i for i, sign in enumerate(face.signs) if not sign]
            raise InputError(
                f"the point {vector_text(face.witness)} lies on the planes {shown(where)}, so in "
                "no region; move it, or use face_at"
            )
        return face

    def sign_vector(self, point: Iterable[Any]) -> tuple[int, ...]:
        """Return the side of each hyperplane on which a point lies, or 0 on it; see `signs_at`."""
        return self.signs_at(point)

    def center(self) -> Face | None:
        """Return the face on all hyperplanes, as a point of it and its signs, 0; None without one.

        >>> Arrangement([[1, 0], [0, 1], [1, 1]], [1, 2, 3]).center().dimension
        0
        >>> Arrangement([[1, 0], [1, 0]], [0, 1]).center()
        """
        if not self.has_common_point:
            return None
        return self.face_at(flat_chart(self, range(len(self))).origin)

    def region_graph(self) -> nx.Graph[Face]:
        """Return the graph of regions: two are joined when they have a facet in common.

        Nodes are the regions as `Face`; the attribute ``planes`` of an edge has the input planes
        between the two. In any dimension, central or not.

        >>> graph = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]).region_graph()
        >>> sorted(degree for _, degree in graph.degree)
        [2, 2, 2, 3, 3, 3, 3]
        """
        return regions.region_graph(self, self.faces())

    def poset_of_regions(self, base: Face) -> nx.DiGraph[Face]:
        """Return the poset of regions as its Hasse diagram, with the base at the bottom.

        A region is below another one when all planes that separate it from the base separate the
        other one too. Edges go upwards; the attribute ``rank`` of a node is its distance.

        Source: P. Edelman, A partial order on the regions of R^n dissected by hyperplanes,
        Trans. AMS 283 (1984).

        >>> square = Arrangement([[1, 0], [0, 1]])
        >>> poset = square.poset_of_regions(square.region_at([1, 1]))
        >>> sorted(rank for _, rank in poset.nodes(data="rank"))
        [0, 1, 1, 2]
        """
        return regions.poset_of_regions(self, self.faces(), base)

    def distance_enumerator(self, base: Face) -> sympy.Poly:
        """Return the sum of t^k over all regions, k the number of planes between it and the base.

        Coincident planes count once. These are also the distances in `region_graph`.

        >>> planes = Arrangement([[1, -1, 0], [1, 0, -1], [0, 1, -1]])
        >>> planes.distance_enumerator(planes.region_at([3, 2, 1]))
        Poly(t**3 + 2*t**2 + 2*t + 1, t, domain='ZZ')
        """
        return regions.distance_enumerator(self, self.regions(), base)

    def chambers(self) -> FaceSequence:
        """Return the regions, which are also called chambers; see `regions`."""
        return self.regions()

    def vertices(self) -> FaceSequence:
        """Return the faces of dimension 0: the points in which hyperplanes meet."""
        return self.faces(0)

    def sign_vectors(self, dimension: int | None = None) -> npt.NDArray[np.int8]:
        """Return the sign vectors (covectors) of the faces as rows of an array of -1, 0 and 1.

        Args:
            dimension: of the faces, 0 to d; if omitted, those of every dimension.

        >>> Arrangement([[1, 0], [0, 1]]).sign_vectors(0)
        array([[0, 0]], dtype=int8)
        """
        rows = [face.signs for face in self.faces(dimension)]
        return np.array(rows, np.int8).reshape(len(rows), len(self))

    def region_count(self) -> int:
        """Return the number of regions by Zaslavsky's theorem, enumerating none.

        >>> Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]).region_count()
        7
        """
        return counts.region_count(self)

    def bounded_region_count(self, *, relative: bool = False) -> int:
        """Return the number of bounded regions by Zaslavsky's theorem, enumerating none.

        Args:
            relative: count the relatively bounded ones (in the span of the normals).
        """
        return counts.bounded_region_count(self, relative=relative)

    def characteristic_polynomial(self, *, time_limit: float | None = None) -> sympy.Poly:
        """Return the characteristic polynomial chi(t); see `counts.characteristic_polynomial`.

        >>> Arrangement([[1, 0], [0, 1], [1, 1]]).characteristic_polynomial()
        Poly(t**2 - 3*t + 2, t, domain='ZZ')
        """
        return counts.characteristic_polynomial(self, time_limit=time_limit)

    def whitney_numbers(self) -> counts.WhitneyNumbers:
        """Return the Whitney numbers of both kinds; see `counts.whitney_numbers`."""
        return counts.whitney_numbers(self)

    def intersection_lattice(self) -> counts.IntersectionLattice:
        """Return the flats, ordered by reverse inclusion; see `counts.intersection_lattice`."""
        return counts.intersection_lattice(self)

    def t_vector(self) -> Mapping[int, int]:
        """Return how many flats of rank 2 lie on k hyperplanes, by k; see `counts.t_vector`."""
        return counts.t_vector(self)

    def covectors(self) -> frozenset[tuple[int, ...]]:
        """Return the covectors of the oriented matroid, as `counts.covectors` does.

        Of affine hyperplanes it is that of the cone: each covector has a sign more, the last one,
        of the hyperplane at infinity. So has all else of the oriented matroid. `sign_vectors` has
        the faces of the affine hyperplanes themselves.

        >>> lines = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])
        >>> {row[:-1] for row in lines.covectors() if row[-1] > 0} == {
        ...     face.signs for face in lines.faces()
        ... }
        True
        """
        return counts.covectors(self)

    def topes(self) -> frozenset[tuple[int, ...]]:
        """Return the covectors without zeros; see `covectors` and `counts.topes`."""
        return counts.topes(self)

    def circuits(self) -> frozenset[tuple[int, ...]]:
        """Return the signed minimal dependencies of the normals; see `counts.circuits`."""
        return counts.circuits(self)

    def cocircuits(self) -> frozenset[tuple[int, ...]]:
        """Return the covectors of the rays; see `counts.cocircuits`."""
        return counts.cocircuits(self)

    def chirotope(self) -> Mapping[tuple[int, ...], int]:
        """Return the signs of the maximal minors, by bases; see `counts.chirotope`."""
        return counts.chirotope(self)

    def identify(self) -> Identification:
        """Return the isomorphism class of the oriented matroid, and facts about it.

        >>> Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).identify().planes
        3
        """
        identification: Identification = method_code("Arrangement.identify")(self)
        return identification

    def addition(self, normal: Iterable[Any], offset: Any = 0) -> Arrangement:
        """Return the arrangement with one more hyperplane, the last; see `counts.addition`."""
        return counts.addition(self, normal, offset)

    def union(self, other: Planes) -> Arrangement:
        """Return the hyperplanes of both, those of both once; see `counts.union`. Also ``A | B``.

        >>> str((Arrangement([[1, 0]]) | Arrangement([[0, 1], [-1, 0]]))[1])
        'y = 0'
        """
        return counts.union(self, other)

    def __or__(self, other: object) -> Arrangement:
        return counts.union(self, other) if isinstance(other, Planes) else NotImplemented

    def deletion(self, *planes: int | Hyperplane) -> Arrangement:
        """Return the arrangement without hyperplanes, or numbers of them; see `counts.deletion`.

        Numbers begin with 0, the line that pictures label 1.
        """
        return counts.deletion(self, planes)

    def restriction(self, *planes: int | Hyperplane) -> Arrangement:
        """Return the arrangement that the others cut on a flat; see `counts.restriction`.

        The flat is where these hyperplanes meet; their numbers begin with 0, as in `deletion`.
        """
        return counts.restriction(self, planes)

    def localization(self, *planes: int | Hyperplane) -> Arrangement:
        """Return the hyperplanes that contain a flat; see `counts.localization`."""
        return counts.localization(self, planes)

    def essentialization(self) -> Arrangement:
        """Return the arrangement in the span of its normals; see `counts.essentialization`."""
        return counts.essentialization(self)

    def cone(self) -> Arrangement:
        """Return the central arrangement one dimension higher; see `counts.cone`."""
        return counts.cone(self)

    def dual(self, lengths: Iterable[Any] | None = None) -> Zonotope:
        """Return the dual zonotope of a central arrangement of rank 1 or more.

        Args:
            lengths: a positive exact factor for each normal, which is stored as coprime integers;
                1 if omitted. `duals.zonohedron.zonotope` keeps the lengths of vectors.

        Raises:
            InputError: an affine arrangement, or one without planes.

        >>> len(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).dual().vertices)
        8
        """
        from .duals.zonohedron import dual_zonotope

        return dual_zonotope(self, lengths)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file, whole or not at all, in the format of its ending.

        `read_arrangement` reads ``.json``, ``.sage``, ``.hyar`` (polymake), ``.txt`` and others.

        Raises:
            InputError: another ending, a format that cannot hold the arrangement, or a place that
                cannot be written.
        """
        method_code("Arrangement.save")(self, path)

    def to_sage(self) -> str:
        """Return source text of SageMath, to be pasted there; `save` writes it as ``.sage``.

        >>> Arrangement([[1, 0]]).to_sage()
        'H.<x,y> = HyperplaneArrangements(QQ)\\nA = H(\\n    x,\\n)\\n'
        """
        text: str = method_code("Arrangement.to_sage")(self)
        return text

    def to_polymake(self) -> str:
        """Return a document of polymake, for its ``load``; `save` writes it as ``.hyar``."""
        text: str = method_code("Arrangement.to_polymake")(self)
        return text

    @property
    def p_vector(self) -> dict[int, int]:
        """How many regions have k facets, by k: bounded and unbounded ones.

        Of central planes in R^3 there are half as many in the projective plane. Polygons between
        lines of the plane are counted by `bounded_p_vector`.

        >>> Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]).p_vector
        {3: 8, 4: 6}
        """
        return regions.numbers_of_facets(self, self.faces())

    @property
    def bounded_p_vector(self) -> dict[int, int]:
        """How many bounded regions have k facets, by k; of lines, triangles, quadrangles, ...

        Empty unless the normals span R^d, as no region is bounded then.

        >>> lines = Arrangement([[1, 0], [0, 1], [1, 1], [1, -1]], [0, 0, 2, 1])
        >>> lines.p_vector, lines.bounded_p_vector
        ({2: 3, 3: 6, 4: 2}, {3: 2, 4: 1})
        """
        return regions.numbers_of_facets(self, self.faces(), self.bounded_regions())

    @property
    def level_vector(self) -> dict[int, int]:
        """How many regions have level k, by k, by enumeration; see `Face.level`.

        Bounded regions have level 0, and relatively bounded ones the least level that there is.

        >>> Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1]).level_vector
        {0: 1, 2: 6}
        """
        levels = Counter(regions.levels(self, self.regions()).tolist())
        return dict(sorted(levels.items()))

    def simplicial_regions(self) -> FaceSequence:
        """Return the regions that are simplicial; see `Face.is_simplicial`.

        Of planes with a point in common these are the simplicial cones, of others the simplices,
        such as the triangles between lines. Both are taken modulo the lines that all regions
        contain.
        """
        return regions.simplicial_regions(self, self.faces())

    @property
    def is_simplicial(self) -> bool:
        """Whether every region is a simplicial cone.

        Never so unless the planes have a point in common, since some regions are unbounded. Lines
        of the projective plane are asked about by the planes of their cone.

        >>> Arrangement([[1, -1, 0], [1, 0, -1], [0, 1, -1]]).is_simplicial
        True
        """
        return len(self.simplicial_regions()) == self.f_vector[-1]

    @property
    def f_vector(self) -> tuple[int, ...]:
        """The number of faces of dimension 0, 1, ..., d.

        Those of `faces()` where these were enumerated before, else by Zaslavsky's theorem
        (`counts.f_vector`), which enumerates none. ``faces().f_vector`` is by enumeration always.
        """
        listed: FaceSequence | None = vars(self).get("_faces")
        return counts.f_vector(self) if listed is None else listed.f_vector

    def chirotope_string(self, order: str = "reverse-lexicographic") -> str:
        """Return the chirotope as a text of ``+``, ``-``, ``0``; see `counts.chirotope_string`.

        >>> Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]).chirotope_string()
        '++-+'
        """
        from .counts import chirotope_string

        return chirotope_string(self, order)

    def sphere(self) -> SphereArrangement:
        """Return the great circles of a central arrangement in R^3, with their full incidence."""
        return sphere_arrangement(self)

    def certify_complete(self, *, proved: bool = False) -> completeness.CompletenessEvidence:
        """Compare `faces` with Zaslavsky's theorem, face by face and in number.

        Args:
            proved: let the program that is proved in Coq count them and check the list.
        """
        return completeness.certify_complete(self, self.faces(), proved=proved)

    def lab(self) -> Any:
        """Return a page to drag these planes in a notebook; `arrangement lab` writes it to a file.

        Central planes of rank up to 3, or lines of R^2. With anywidget (the extra notebook) its
        attribute `arrangement` is what the page shows.

        Raises:
            InputError: other planes, or too many.
        """
        return method_code("Arrangement.lab")(self)

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: the picture of `draw`, where there is one."""
        text: str | None = method_code("Arrangement._repr_svg_")(self)
        return text

    def _repr_html_(self) -> str:
        """Return what a notebook shows: the picture, where there is one, and a table of counts."""
        text: str = method_code("Arrangement._repr_html_")(self)
        return text
