"""Names of other programs for what an arrangement A can do, and the names of this package.

`Arrangement` answers an unknown attribute with them; a page of the documentation shows them; a test
runs each. On the right are also the hyperplane number i (from 0), a point, a normal and its offset,
regions r and s, another arrangement B, and the path of a file.
"""

from __future__ import annotations

from collections.abc import Mapping


def by_word(table: str) -> dict[str, str]:
    """Return what to write for words, from lines as ``word other_word -> what to write``."""
    rows = [line.split(" -> ") for line in table.strip().splitlines()]
    return {word: use for words, use in rows for word in words.split()}


#: For each program, or kind of source, its names.
ARRANGEMENT: Mapping[str, Mapping[str, str]] = {
    "Sage": by_word("""
        add_hyperplane -> A.addition(normal, offset)
        automorphism_group -> A.identify().automorphisms
        base_ring -> A.field
        closed_faces -> [face.closure for face in A.faces()]
        defining_polynomial -> A.equations()
        derivation_module_basis fundamental_group is_formal is_free varchenko_matrix -> A.to_sage()
        distance_between_regions -> r.distance(s)
        doubly_indexed_whitney_number -> arrangement.counts.doubly_indexed_whitney_numbers(A)
        face_product -> r.compose(s)
        exponents -> A.characteristic_polynomial().factor_list()
        face_vector -> A.f_vector
        hyperplanes -> list(A)
        intersection_poset -> A.intersection_lattice()
        irreducible_components -> arrangement.counts.irreducible_factors(A)
        is_supersolvable -> arrangement.counts.supersolvable_exponents(A.cone())
        is_linear -> A.is_central
        is_separating_hyperplane -> r.separating(s)
        matroid -> arrangement.counts.bases(A)
        n_bounded_regions -> A.bounded_region_count(relative=True)
        n_hyperplanes -> len(A)
        n_regions -> A.region_count()
        orlik_solomon_algebra -> arrangement.counts.nbc_sets(A)
        plot -> A.draw()
        poincare_polynomial -> [abs(w) for w in A.whitney_numbers().first]
        region_containing_point -> A.region_at(point)
        unbounded_regions -> [r for r in A.regions() if not r.is_bounded]
        whitney_data -> A.whitney_numbers()
        whitney_number -> A.whitney_numbers().first
    """),
    "polymake": by_word("""
        AMBIENT_DIM -> A.dimension
        BASES -> arrangement.counts.bases(A)
        CELL_DECOMPOSITION -> A.faces()
        CHAMBER_GRAPH DUAL_GRAPH -> A.region_graph()
        BOUNDED_COMPLEX -> A.bounded_regions()
        CHAMBER_DECOMPOSITION -> A.regions()
        CHAMBER_SIGNATURES -> A.sign_vectors(A.dimension)
        CONNECTED_COMPONENTS -> arrangement.counts.irreducible_factors(A)
        HYPERPLANES -> list(A)
        LATTICE_OF_FLATS -> A.intersection_lattice()
        LINEALITY_DIM -> A.dimension - A.rank
        RAYS -> A.cocircuits()
        N_BASES -> len(arrangement.counts.bases(A))
        N_HYPERPLANES -> len(A)
        TUTTE_POLYNOMIAL -> arrangement.counts.tutte_polynomial(A)
        VISUAL -> A.draw()
        zonotope -> A.dual()
    """),
    "CGAL": by_word("""
        curves -> list(A)
        edges halfedges -> A.faces(1)
        insert -> A.addition(normal, offset)
        is_valid -> A.certify_complete()
        locate point_location -> A.face_at(point)
        number_of_edges -> A.f_vector[1]
        number_of_faces -> A.region_count()
        number_of_unbounded_faces -> A.region_count() - A.bounded_region_count()
        number_of_vertices -> A.f_vector[0]
        overlay -> A | B
        remove_curve -> A.deletion(i)
        unbounded_faces -> [r for r in A.regions() if not r.is_bounded]
        zone -> [r for r in A.regions() if i in r.walls]
    """),
    "matroids": by_word("""
        broken_circuits -> arrangement.counts.nbc_sets(A)
        closure -> A.intersection_lattice().closure([i])
        contract contraction -> A.restriction(i)
        corank -> len(A) - A.rank
        delete -> A.deletion(i)
        flats -> A.intersection_lattice().flats
        groundset -> range(len(A))
        is_uniform -> A.is_simple
        parallel_classes -> A.distinct
        signed_circuits -> A.circuits()
        simplification -> A.distinct_planes
        tope_graph -> A.region_graph()
    """),
    "elsewhere": by_word("""
        from_lines -> arrangement.Arrangement.from_equations(['x = 0', 'x + y = 1'])
        adjacency_graph dual_graph to_networkx -> A.region_graph()
        cells face_lattice face_poset -> A.faces()
        chi -> A.characteristic_polynomial()
        count count_regions number_of_regions zaslavsky -> A.region_count()
        crossings intersection_points points -> A.vertices()
        dim ambient_dimension -> A.dimension
        export to_csv -> A.save(path)
        from_file from_polymake from_sage from_csv from_json -> arrangement.read_arrangement(path)
        load read -> arrangement.read_arrangement(path)
        from_points -> arrangement.families.lines_through([(0, 0), (4, 0), (0, 4)])
        hasse_diagram plot_lattice -> A.draw('lattice')
        n -> len(A) or A.dimension
        m size n_planes -> len(A)
        from_arrays from_numpy -> arrangement.Arrangement([normal], [offset])
        intersections lattice -> A.intersection_lattice()
        is_generic is_in_general_position -> A.is_simple
        is_isomorphic -> A.identify().type == B.identify().type
        lines planes -> list(A)
        mobius moebius moebius_function -> arrangement.counts.moebius(A)
        n_edges -> A.f_vector[1]
        n_faces -> sum(A.f_vector)
        n_vertices -> A.f_vector[0]
        random -> arrangement.families.random_integer(5, 2, seed=1, affine=True)
        to_dataframe to_pandas -> pandas.DataFrame(A.sign_vectors())
        to_json -> json.dumps(A.to_dict())
        to_numpy -> A.sign_vectors()
        triangles -> A.bounded_p_vector
    """),
}

#: Of everything that has a method `draw`: what saves its picture.
PICTURES = by_word("""
    to_svg as_svg save_svg export_svg write_svg -> draw().write('picture.svg')
    savefig save_figure save_image save_picture to_image -> draw().write('picture.svg')
    export_figure -> draw().write('picture.svg')
    to_pdf as_pdf save_pdf export_pdf write_pdf -> draw().write('picture.pdf')
    to_png as_png save_png export_png write_png -> draw().write('picture.png')
    to_tikz as_tikz to_tex tikz -> draw().write('picture.tex')
    display figure picture plot render show visualize visualise -> draw()
""")
#: Of what has a method `lab`, too.
PAGES: Mapping[str, str] = by_word("""
    animate drag explore interact interactive simulate widget -> lab()
""")

#: Of the package.
PACKAGE: Mapping[str, str] = by_word("""
    Hyperplane Line -> Arrangement([normal], [offset])
    HyperplaneArrangement HyperplaneArrangements Lines -> Arrangement
    Polygon -> arrangement.families.polygon(corners)
    boolean -> arrangement.families.coordinate
    examples hyperplane_arrangements -> families
    Matroid OrientedMatroid -> arrangement.counts.bases(A)
    random random_arrangement -> arrangement.families.random_integer(5, 2, seed=1, affine=True)
    load open read read_csv -> arrangement.read_arrangement(path)
    plot -> A.draw()
""")

#: Of several faces or regions F.
SEQUENCES: Mapping[str, str] = by_word("""
    to_dataframe to_pandas -> pandas.DataFrame(F.signs)
    to_json -> json.dumps(F.signs.tolist())
    to_list tolist -> list(F)
    to_numpy -> F.signs
""")

#: Of a face or region r, of an arrangement A.
FACES: Mapping[str, str] = by_word("""
    adjacent neighbors neighbours -> A.region_graph()[r]
    area -> r.volume
    center centre centroid interior_point representative_point sample_point -> r.witness
    covector sign_vector -> r.signs
    is_unbounded unbounded -> not r.is_bounded
    draw plot -> A.draw()
    edges -> r.faces
    n_vertices -> len(r.vertices)
    polygon -> r.vertices
""")

#: Of segments S.
SEGMENTS: Mapping[str, str] = PICTURES | by_word("""
    arrangement -> S.lines
    bounded_regions -> S.pieces().bounded_cells
    cells count f_vector faces region_count regions -> S.pieces()
    edges -> S.pieces().edges
    vertices -> S.pieces().vertices
""")

#: Other words for the argument of what reads a file.
FILES: Mapping[str, str] = dict.fromkeys(("data", "file", "filename", "name", "path"), "source")
