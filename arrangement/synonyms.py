"""Names of other programs for what an arrangement A can do, and the names of this package.

`Arrangement` answers an unknown attribute with them; a page of the documentation shows them; a test
runs each. On the right are also the hyperplane number i (from 0), a point, a normal and its offset,
regions r and s, another arrangement B, and the path of a file.
"""

from __future__ import annotations

from collections.abc import Mapping

_UNBOUNDED = "[r for r in A.regions() if not r.is_bounded]"
_EDGES = "A.faces(1)"

#: For each program, or kind of source, its names.
ARRANGEMENT: Mapping[str, Mapping[str, str]] = {
    "Sage": {
        "add_hyperplane": "A.addition(normal, offset)",
        "automorphism_group": "A.identify().automorphisms",
        "base_ring": "A.field",
        "closed_faces": "[face.closure for face in A.faces()]",
        "defining_polynomial": "A.equations()",
        "derivation_module_basis": "A.to_sage()",
        "distance_between_regions": "r.distance(s)",
        "doubly_indexed_whitney_number": "arrangement.counts.doubly_indexed_whitney_numbers(A)",
        "face_product": "r.compose(s)",
        "exponents": "A.characteristic_polynomial().factor_list()",
        "face_vector": "A.f_vector",
        "fundamental_group": "A.to_sage()",
        "hyperplanes": "list(A)",
        "intersection_poset": "A.intersection_lattice()",
        "irreducible_components": "arrangement.counts.irreducible_factors(A)",
        "is_formal": "A.to_sage()",
        "is_free": "A.to_sage()",
        "is_supersolvable": "arrangement.counts.supersolvable_exponents(A.cone())",
        "is_linear": "A.is_central",
        "is_separating_hyperplane": "r.separating(s)",
        "matroid": "arrangement.counts.bases(A)",
        "n_bounded_regions": "A.bounded_region_count(relative=True)",
        "n_hyperplanes": "len(A)",
        "n_regions": "A.region_count()",
        "orlik_solomon_algebra": "arrangement.counts.nbc_sets(A)",
        "plot": "A.draw()",
        "poincare_polynomial": "[abs(w) for w in A.whitney_numbers().first]",
        "region_containing_point": "A.region_at(point)",
        "unbounded_regions": _UNBOUNDED,
        "varchenko_matrix": "A.to_sage()",
        "whitney_data": "A.whitney_numbers()",
        "whitney_number": "A.whitney_numbers().first",
    },
    "polymake": {
        "AMBIENT_DIM": "A.dimension",
        "BASES": "arrangement.counts.bases(A)",
        "CELL_DECOMPOSITION": "A.faces()",
        "CHAMBER_GRAPH": "A.region_graph()",
        "BOUNDED_COMPLEX": "A.bounded_regions()",
        "CHAMBER_DECOMPOSITION": "A.regions()",
        "CHAMBER_SIGNATURES": "A.sign_vectors(A.dimension)",
        "CONNECTED_COMPONENTS": "arrangement.counts.irreducible_factors(A)",
        "DUAL_GRAPH": "A.region_graph()",
        "HYPERPLANES": "list(A)",
        "LATTICE_OF_FLATS": "A.intersection_lattice()",
        "LINEALITY_DIM": "A.dimension - A.rank",
        "RAYS": "A.cocircuits()",
        "N_BASES": "len(arrangement.counts.bases(A))",
        "N_HYPERPLANES": "len(A)",
        "TUTTE_POLYNOMIAL": "arrangement.counts.tutte_polynomial(A)",
        "VISUAL": "A.draw()",
        "zonotope": "A.dual()",
    },
    "CGAL": {
        "curves": "list(A)",
        "edges": _EDGES,
        "halfedges": _EDGES,
        "insert": "A.addition(normal, offset)",
        "is_valid": "A.certify_complete()",
        "locate": "A.face_at(point)",
        "number_of_edges": "A.f_vector[1]",
        "number_of_faces": "A.region_count()",
        "number_of_unbounded_faces": "A.region_count() - A.bounded_region_count()",
        "number_of_vertices": "A.f_vector[0]",
        "overlay": "A | B",
        "point_location": "A.face_at(point)",
        "remove_curve": "A.deletion(i)",
        "unbounded_faces": _UNBOUNDED,
        "zone": "[r for r in A.regions() if i in r.walls]",
    },
    "matroids": {
        "broken_circuits": "arrangement.counts.nbc_sets(A)",
        "closure": "A.intersection_lattice().closure([i])",
        "contract": "A.restriction(i)",
        "contraction": "A.restriction(i)",
        "corank": "len(A) - A.rank",
        "delete": "A.deletion(i)",
        "flats": "A.intersection_lattice().flats",
        "groundset": "range(len(A))",
        "is_uniform": "A.is_simple",
        "parallel_classes": "A.distinct",
        "signed_circuits": "A.circuits()",
        "simplification": "A.distinct_planes",
        "tope_graph": "A.region_graph()",
    },
    "elsewhere": {
        "add": "A.addition(normal, offset)",
        "change_ring": "A.field",
        "essentialize": "A.essentialization()",
        "from_lines": "arrangement.Arrangement.from_equations(['x = 0', 'x + y = 1'])",
        "to_latex": "A.equations()",
        "adjacency_graph": "A.region_graph()",
        "bounded": "A.bounded_regions()",
        "bounded_faces": "A.bounded_regions()",
        "braid": "arrangement.families.braid(4)",
        "cells": "A.faces()",
        "chi": "A.characteristic_polynomial()",
        "count": "A.region_count()",
        "count_regions": "A.region_count()",
        "crossings": "A.vertices()",
        "dim": "A.dimension",
        "dual_graph": "A.region_graph()",
        "export": "A.save(path)",
        "face_lattice": "A.faces()",
        "face_poset": "A.faces()",
        "from_file": "arrangement.read_arrangement(path)",
        "from_points": "arrangement.families.lines_through([(0, 0), (4, 0), (0, 4)])",
        "from_polymake": "arrangement.read_arrangement(path)",
        "from_sage": "arrangement.read_arrangement(path)",
        "hasse_diagram": "A.draw('lattice')",
        "n": "len(A) or A.dimension",
        "m": "len(A)",
        "size": "len(A)",
        "ambient_dimension": "A.dimension",
        "from_arrays": "arrangement.Arrangement([normal], [offset])",
        "from_numpy": "arrangement.Arrangement([normal], [offset])",
        "from_csv": "arrangement.read_arrangement(path)",
        "from_json": "arrangement.read_arrangement(path)",
        "generic": "arrangement.families.generic(5, 2, affine=True)",
        "plot_lattice": "A.draw('lattice')",
        "inside": "A.regions(inside=r)",
        "intersection_points": "A.vertices()",
        "intersections": "A.intersection_lattice()",
        "is_generic": "A.is_simple",
        "is_in_general_position": "A.is_simple",
        "is_isomorphic": "A.identify().type == B.identify().type",
        "isomorphism_class": "A.identify()",
        "lattice": "A.intersection_lattice()",
        "lines": "list(A)",
        "load": "arrangement.read_arrangement(path)",
        "moebius": "arrangement.counts.moebius(A)",
        "n_edges": "A.f_vector[1]",
        "n_faces": "sum(A.f_vector)",
        "n_planes": "len(A)",
        "n_vertices": "A.f_vector[0]",
        "number_of_regions": "A.region_count()",
        "planes": "list(A)",
        "plot3d": "A.draw()",
        "points": "A.vertices()",
        "poset": "A.poset_of_regions(r)",
        "random": "arrangement.families.random_integer(5, 2)",
        "read": "arrangement.read_arrangement(path)",
        "remove": "A.deletion(i)",
        "symmetries": "A.identify().automorphisms",
        "to_csv": "A.save(path)",
        "to_dataframe": "pandas.DataFrame(A.sign_vectors())",
        "to_json": "json.dumps(A.to_dict())",
        "to_numpy": "A.sign_vectors()",
        "to_pandas": "pandas.DataFrame(A.sign_vectors())",
        "to_networkx": "A.region_graph()",
        "triangles": "A.bounded_p_vector",
        "zaslavsky": "A.region_count()",
    },
}

#: Of everything that has a method `draw`: what saves its picture.
PICTURES: Mapping[str, str] = {
    **{
        f"{verb}_{kind}": f"draw().write('picture.{kind}')"
        for verb in ("to", "as", "save", "export", "write")
        for kind in ("svg", "pdf", "png")
    },
    **dict.fromkeys(("to_tikz", "as_tikz", "to_tex", "tikz"), "draw().write('picture.tex')"),
    **dict.fromkeys(
        ("save_figure", "save_image", "save_picture", "savefig", "to_image", "export_figure"),
        "draw().write('picture.svg')",
    ),
    **dict.fromkeys(("display", "figure", "picture", "plot", "render", "show"), "draw()"),
    "visualize": "draw()",
    "visualise": "draw()",
}
#: Of what has a method `lab`, too.
PAGES: Mapping[str, str] = dict.fromkeys(
    ("animate", "drag", "explore", "interact", "interactive", "simulate", "widget"), "lab()"
)

_FAMILIES = """bigraphical bisectors braid catalan complete_bipartite coordinate coxeter diagonals
discriminantal generic graphical h3 h4 ish ish_b lines_through linial near_pencil pencil perles
polygon random_degenerate random_integer random_sphere regular resonance semiorder separations shi
signed_graphical simplicial threshold threshold_functions type_b type_d"""

#: Of the package: the families, and other names for what it has.
PACKAGE: Mapping[str, str] = {
    **{name: f"arrangement.families.{name}" for name in _FAMILIES.split()},
    "Hyperplane": "Arrangement([normal], [offset])",
    "HyperplaneArrangement": "Arrangement",
    "HyperplaneArrangements": "Arrangement",
    "Line": "Arrangement([normal], [offset])",
    "Lines": "Arrangement",
    "Polygon": "arrangement.families.polygon",
    "boolean": "arrangement.families.coordinate",
    "draw": "A.draw()",
    "hyperplane_arrangements": "families",
    "load": "arrangement.read_arrangement(path)",
    "open": "arrangement.read_arrangement(path)",
    "plot": "A.draw()",
    "read": "arrangement.read_arrangement(path)",
    "read_csv": "arrangement.read_arrangement(path)",
    "region_count": "A.region_count()",
    "save": "A.save(path)",
}

#: Of several faces or regions F.
SEQUENCES: Mapping[str, str] = {
    "filter": "F.where(F.signs[:, 0] > 0)",
    "shape": "F.signs.shape",
    "to_dataframe": "pandas.DataFrame(F.signs)",
    "to_json": "json.dumps(F.signs.tolist())",
    "to_list": "list(F)",
    "to_numpy": "F.signs",
    "to_pandas": "pandas.DataFrame(F.signs)",
    "tolist": "list(F)",
    "witnesses": "[face.witness for face in F]",
}

#: Of a face or region r, of an arrangement A.
FACES: Mapping[str, str] = {
    "adjacent": "A.region_graph()[r]",
    "as_polyhedron": "r.closure",
    "area": "r.volume",
    "bounded": "r.is_bounded",
    "center": "r.witness",
    "centre": "r.witness",
    "centroid": "r.witness",
    "covector": "r.signs",
    "dim": "r.dimension",
    "draw": "A.draw()",
    "edges": "r.faces",
    "interior_point": "r.witness",
    "n_vertices": "len(r.vertices)",
    "neighbors": "A.region_graph()[r]",
    "neighbours": "A.region_graph()[r]",
    "plot": "A.draw()",
    "polygon": "r.vertices",
    "polyhedron": "r.closure",
    "representative_point": "r.witness",
    "sample_point": "r.witness",
    "sign_vector": "r.signs",
}

#: Of segments S.
SEGMENTS: Mapping[str, str] = {
    **PICTURES,
    "arrangement": "S.lines",
    "bounded_regions": "S.pieces().bounded_cells",
    "cells": "S.pieces().cells",
    "count": "S.pieces()",
    "edges": "S.pieces().edges",
    "f_vector": "S.pieces()",
    "faces": "S.pieces().cells",
    "region_count": "S.pieces().cells",
    "regions": "S.pieces().cells",
    "vertices": "S.pieces().vertices",
}

#: Other words for the argument of what reads a file.
FILES: Mapping[str, str] = dict.fromkeys(("data", "file", "filename", "name", "path"), "source")
