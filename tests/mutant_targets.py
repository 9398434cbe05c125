"""What mutation testing changes, with the tests that are to notice it (see `mutants`)."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Target(NamedTuple):
    """A module, the tests that cover it, fast ones first, and how many mutants to run (0: all)."""

    module: str
    tests: tuple[str, ...]
    sample: int = 0

    @property
    def path(self) -> Path:
        """The file of the module."""
        return ROOT / Path(*self.module.split(".")).with_suffix(".py")


CHECKER = ("tests/equilibrium/test_checker.py",)
GRASP = "tests/equilibrium/test_grasp.py::TestValues"
PLANES = "tests/equilibrium/test_space.py::TestPlanes"
PYRAMIDS = "tests/equilibrium/test_space.py::TestPyramids"
SOLVER = ("tests/equilibrium/test_verdict.py",)
STATES = ("tests/equilibrium/test_contact_states.py", *SOLVER)
PROGRAMS = "tests/arrangement/test_linprog.py"
SEARCH = ("tests/equilibrium/test_leaves.py", "tests/equilibrium/test_resistance.py")
SPACE = (
    "tests/equilibrium/test_space_checker.py",
    "tests/equilibrium/test_space.py::TestChecker",
)
ASSEMBLIES = (
    "tests/equilibrium/test_assembly_checker.py",
    "tests/equilibrium/test_assemblies.py::TestForged::test_question_of_a_certificate_is_compared",
    "tests/equilibrium/test_assemblies.py::TestCommand::test_verified_checker_takes_an_assembly",
)
TOUCHING = tuple(
    f"tests/equilibrium/test_assembly_inputs.py::Test{name}" for name in ("Polygons", "Weight")
)
MODES = "tests/equilibrium/test_modes.py"
FIELD = "tests/arrangement/test_number_field.py"
SPACE_SEARCH = (
    *(
        f"tests/equilibrium/test_space.py::Test{name}"
        for name in ("KnownLeaves", "Borders", "Planes")
    ),
    *(
        f"tests/equilibrium/test_space.py::test_{name}"
        for name in (
            "bound_of_friction_is_the_largest_product_in_a_sector",
            "changed_multiples_of_columns_cancel",
            "conditions_of_pyramids_hold_on_their_sides_and_corners_alone",
            "exact_program_of_bounded_displacements_has_a_proof",
            "leaves_count_loads_and_preloads_in_the_same_unit",
            "reach_of_a_load_twice_too_large_is_its_half",
            "frictionless_load_resisted_by_normals_alone",
            "what_floats_leave_open_is_decided",
            "a_load_on_the_border_is_given_up_early",
        )
    ),
    PYRAMIDS,
)
CIRCLES = ("tests/arrangement/test_great_circles_exactness.py", FIELD)
LOADS = tuple(
    f"tests/equilibrium/test_space.py::Test{name}" for name in ("KnownLoads", "Brackets", "Borders")
)
ROBUST = ("tests/equilibrium/test_robust_checker.py",)
FINAL = tuple(
    f"tests/arrangement/test_identify.py::test_{name}"
    for name in (
        "pappus_realizable_and_non_pappus_not",
        "a_changed_proof_is_refused",
        "forged_proofs_are_refused_though_their_products_cancel",
        "no_type_with_coordinates_has_a_proof_that_it_has_none",
        "three_sign_comparisons_prove_nonrealizable",
        "comparisons_are_those_that_signs_of_vectors_force",
        "verified_program_gets_signs_and_proof",
    )
)
COUNTS, LATTICE, OPERATIONS, SYMMETRIC, IN_PARTS = (
    f"tests/arrangement/test_counts{name}.py"
    for name in ("", "_lattice", "_operations", "_symmetric", "_in_parts")
)
#: What is counted without its flats, or is not begun.
FORECASTS = tuple(
    f"tests/arrangement/test_budget.py::test_{name}"
    for name in (
        "planes_of_independent_parts_are_counted_part_by_part",
        "a_basis_of_many_rows_is_found_where_they_span_little",
        "one_plane_off_the_others_is_a_factor_of_its_own",
        "factors_that_only_a_prime_shows_are_none",
        "generic_planes_counted_without_flats",
        "flats_are_refused_as_soon_as_their_second_rank_is_known",
        "flats_of_a_high_rank_are_refused_before_any_is_made",
    )
)
#: What is listed or refused.
LISTS = tuple(
    f"tests/arrangement/test_budget.py::test_{name}"
    for name in (
        "the_bound_is_attained_in_general_position",
        "list_refused_by_size_unless_limit_allows",
        "larger_limit_lists_what_a_smaller_one_lists",
        "refusals_name_what_allows_it_in_python_and_in_commands",
        "a_tuple_of_faces_asks_for_all_their_signs",
        "what_cannot_be_counted_is_not_to_be_counted_instead",
        "very_long_entries_counted_as_short_ones",
    )
)
#: What is counted by symmetries, or until a time is over.
GIVEN = tuple(
    f"{SYMMETRIC}::test_{name}"
    for name in (
        "given_symmetries_are_checked",
        "a_time_limit_leaves_what_is_known",
        "few_symmetries_leave_flats_to_the_lattice",
    )
)
ENGINES = "tests/arrangement/test_engines.py"
INSCRIBED = "tests/arrangement/test_inscribed.py"
SHAPES = "tests/equilibrium/test_shapes.py"
TARGETS = {
    "checker": Target("equilibrium.certificate.checker", (*CHECKER, PLANES, PYRAMIDS)),
    "report": Target("equilibrium.certificate.report", (*CHECKER, *ASSEMBLIES)),
    "leaf rule": Target(
        "equilibrium.certificate.leaf_rule",
        (*CHECKER, PLANES, PYRAMIDS, *ASSEMBLIES, *SPACE, "tests/equilibrium/test_proof_view.py"),
    ),
    "contact rule": Target("equilibrium.certificate.contact_rule", (*CHECKER, *ASSEMBLIES, *SPACE)),
    "tree walk": Target("equilibrium.certificate.tree", (*CHECKER, *ASSEMBLIES, *SPACE)),
    "law": Target(
        "equilibrium.certificate.law",
        (*CHECKER, SPACE[0], "tests/equilibrium/test_displacement.py"),
    ),
    "reading": Target(
        "equilibrium.certificate.reading",
        (*CHECKER, *SPACE, PLANES, "tests/equilibrium/test_assembly_checker.py"),
    ),
    "assemblies": Target("equilibrium.certificate.assemblies", ASSEMBLIES),
    "touching": Target("equilibrium.grasps.inputs.touching", (*TOUCHING, SHAPES)),
    "shapes": Target("equilibrium.grasps.inputs.shapes", (SHAPES,)),
    "letter": Target("equilibrium.grasps.inputs.shapes_letter", (SHAPES,)),
    "enclosure": Target("equilibrium.certificate.enclosure", SPACE),
    "uncertain": Target("equilibrium.certificate.uncertain", ROBUST),
    "robust": Target("equilibrium.certificate.robust", ROBUST),
    "plane": Target("equilibrium.model.grasp", (GRASP, PLANES)),
    "loads": Target("equilibrium.wrench_sets.along_in_space", LOADS),
    "known": Target("equilibrium.decide.known_loads", LOADS),
    "final": Target("arrangement.library.census.final_polynomials", FINAL),
    "proofs": Target("tests.census.proofs", FINAL),
    "inscribed": Target("arrangement.duals.inscribed.certificates", (INSCRIBED,)),
    "modular": Target("arrangement.counts.modular", (SYMMETRIC, FIELD)),
    "lowrank": Target("arrangement.counts.low_rank", (COUNTS,)),
    "ratios": Target("arrangement.counts.ratio_groups", (COUNTS,)),
    "lattice": Target("arrangement.counts.lattice", (LATTICE, COUNTS, *FORECASTS)),
    "cone": Target("proofs_check.routes.contact_modes", ("tests/equilibrium/test_fan.py", MODES)),
    "operations": Target("arrangement.counts.operations", (OPERATIONS, *FORECASTS)),
    "whitney": Target("arrangement.counts.whitney", (COUNTS, *FORECASTS, *GIVEN)),
    "points": Target("arrangement.counts.points", (COUNTS,)),
    "configuration": Target("arrangement.counts.configuration", (OPERATIONS, *FORECASTS)),
    "matroid": Target("arrangement.counts.oriented_matroid", (LATTICE,)),
    "tutte": Target("arrangement.counts.tutte", (LATTICE,)),
    "complete": Target("arrangement.counts.completeness", (ENGINES,)),
    "classes": Target("arrangement.counts.orbits.symmetric", (SYMMETRIC, IN_PARTS)),
    "maps": Target("arrangement.counts.orbits.automorphisms", (SYMMETRIC,)),
    "parts": Target("arrangement.counts.orbits.in_parts", (IN_PARTS,)),
    "field": Target("arrangement.numbers.fields", (FIELD,)),
    "real": Target("arrangement.numbers.real", (FIELD,)),
    "circles": Target("arrangement.enumeration.great_circles.predicates", CIRCLES),
    "crossings": Target("arrangement.enumeration.great_circles.crossings", CIRCLES[:1]),
    "predicates": Target(
        "arrangement.enumeration.affine_space",
        ("tests/arrangement/test_affine_space.py",),
        24,
    ),
    "elimination": Target("arrangement.numbers.linear.rank", (PROGRAMS, *SOLVER), 12),
    "pieces": Target("equilibrium.plane.states.equilibrium", STATES, 12),
    "leaves": Target("equilibrium.plane.search.virtual_motions", SEARCH, 12),
    "guess": Target("equilibrium.plane.search.state_equilibrium", SEARCH, 12),
    "splits": Target(
        "equilibrium.plane.search.region_states",
        (*SEARCH, "tests/equilibrium/test_displacement.py"),
        12,
    ),
    "decide.assemblies.ends": Target(
        "equilibrium.decide.assemblies.ends", ("tests/equilibrium/test_ends.py",), 40
    ),
    "oracle": Target("proofs_check.routes.oracle", ("tests/proofs_check/test_oracle.py",), 12),
}

#: Mutants that are run of each module below.
SAMPLE = 12
#: The same for whole modules, each called by its path without the package: sampled.
SAMPLED: dict[tuple[str, ...], tuple[str, ...]] = {
    ("tests/arrangement/test_dual.py",): (
        "arrangement.duals.zonohedron",
        "arrangement.duals.zonotope",
    ),
    ("tests/arrangement/test_inscribed.py",): (
        "arrangement.duals.inscribed.hull",
        "arrangement.duals.inscribed.report",
    ),
    (
        "tests/arrangement/test_engines.py",
        "tests/arrangement/test_rank_four.py",
    ): (
        "arrangement.enumeration.any_dimension",
        "arrangement.enumeration.reduction",
    ),
    (
        "tests/arrangement/test_regions.py",
        "tests/arrangement/test_regions_alone.py",
        FIELD,
        ENGINES,
    ): ("arrangement.enumeration.sequence",),
    (*LISTS, "tests/arrangement/test_regions_alone.py", ENGINES): (
        "arrangement.enumeration.choose",
    ),
    ("tests/equilibrium/test_fan.py", MODES): ("equilibrium.modes",),
    ("tests/arrangement/test_regions_alone.py",): ("arrangement.enumeration.deletion_restriction",),
    ("tests/arrangement/test_paper_steps.py",): ("arrangement.enumeration.paper_steps",),
    ("tests/arrangement/test_regions.py",): ("arrangement.enumeration.regions",),
    ("tests/arrangement/test_pieces.py", "tests/arrangement/test_segments.py"): (
        "arrangement.enumeration.subdivision",
        "arrangement.planes.polygon",
    ),
    (
        "tests/arrangement/test_great_circles.py",
        "tests/arrangement/test_great_circles_exactness.py",
    ): (
        "arrangement.enumeration.great_circles.arrangement",
        "arrangement.enumeration.great_circles.incidence",
        "arrangement.enumeration.great_circles.validation",
    ),
    ("tests/arrangement/test_budget.py",): ("arrangement.numbers.budget",),
    ("tests/arrangement/test_number_field.py",): ("arrangement.numbers.coefficients",),
    ("tests/arrangement/test_exact.py",): ("arrangement.numbers.exact",),
    (
        "tests/arrangement/test_great_circles_exactness.py",
        "tests/arrangement/test_affine_space.py",
    ): ("arrangement.numbers.float_filter",),
    ("tests/arrangement/test_packing.py",): ("arrangement.numbers.packing",),
    ("tests/arrangement/test_intervals.py",): ("arrangement.numbers.linear.intervals",),
    ("tests/arrangement/test_cones.py",): ("arrangement.numbers.linear.cones",),
    ("tests/arrangement/test_symbolic.py", FIELD): ("arrangement.numbers.symbolic",),
    (
        "tests/arrangement/test_formats.py::test_lines_of_equations_are_recognized",
        "tests/arrangement/test_formats.py::test_equations_are_read_and_come_back",
        "tests/arrangement/test_formats.py::test_what_is_no_linear_equation_is_refused",
        "tests/arrangement/test_symbolic.py",
    ): ("arrangement.planes.equation_text",),
    ("tests/equilibrium/test_wrench_sets_space.py",): (
        "arrangement.numbers.linear.separation",
        "equilibrium.wrench_sets.polyhedra",
    ),
    ("tests/arrangement/test_linprog.py",): (
        "arrangement.numbers.linear.programs",
        "arrangement.numbers.linear.float_dictionary",
    ),
    ("tests/equilibrium/test_wrench_sets_plane.py",): (
        "equilibrium.wrench_sets.friction",
        "equilibrium.wrench_sets.outline",
        "equilibrium.wrench_sets.slice",
        "equilibrium.wrench_sets.search_map",
    ),
    (
        *(
            f"tests/equilibrium/test_resisted_set.py::test_preloads_of_{name}"
            for name in (
                "all_contacts_are_those_of_the_margin",
                "chosen_contacts_resist_every_load",
            )
        ),
        "tests/equilibrium/test_assembly_magnitudes.py::TestTextbook",
        "tests/equilibrium/test_wrench_sets_plane.py",
    ): ("equilibrium.wrench_sets.margin",),
    (
        "tests/arrangement/test_surface.py::test_facets_run_counter_clockwise_seen_from_outside",
        "tests/equilibrium/test_wrench_sets_plane.py",
        "tests/equilibrium/test_wrench_sets_space.py",
    ): ("arrangement.numbers.linear.polyhedron",),
    (
        "tests/arrangement/test_planes.py",
        "tests/arrangement/test_regions.py",
    ): (
        "arrangement.planes.faces",
        "arrangement.planes.planes",
    ),
    (
        "tests/equilibrium/test_checker.py",
        "tests/equilibrium/test_space_checker.py",
    ): ("equilibrium.certificate.document",),
    (
        "tests/equilibrium/test_proof_view.py",
        "tests/equilibrium/test_displacement.py",
    ): ("equilibrium.certificate.leaves",),
    (
        "tests/equilibrium/test_corners.py",
        "tests/equilibrium/test_robustness.py",
    ): ("equilibrium.decide.corners",),
    ("tests/equilibrium/test_robustness.py",): (
        "equilibrium.decide.nearby",
        "equilibrium.decide.proofs_for_all",
        "equilibrium.decide.robustness",
    ),
    ("tests/equilibrium/test_meeting.py",): ("equilibrium.decide.meeting",),
    (
        "tests/equilibrium/test_verdict.py",
        "tests/equilibrium/test_displacement.py",
    ): (
        "equilibrium.decide.solver",
        "equilibrium.decide.engines",
    ),
    (
        "tests/equilibrium/test_verdict.py",
        "tests/equilibrium/test_displacement.py",
        "tests/equilibrium/test_cli.py",
    ): ("equilibrium.decide.verdict",),
    (
        "tests/equilibrium/test_methods.py",
        "tests/equilibrium/test_methods_properties.py",
    ): (
        "equilibrium.methods.compare",
        "equilibrium.methods.cones",
        "equilibrium.methods.form_closure",
        "equilibrium.methods.grasp_robustness",
        "equilibrium.methods.grasp_wrench_space",
        "equilibrium.methods.method",
        "equilibrium.methods.springs",
    ),
    ("tests/equilibrium/test_force_closure.py", "tests/equilibrium/test_methods.py"): (
        "equilibrium.methods.closure_friction",
        "equilibrium.methods.force_closure",
        "equilibrium.methods.round_cones",
        "equilibrium.methods.closure_search",
    ),
    (
        "tests/equilibrium/test_methods.py",
        "tests/equilibrium/test_methods_properties.py",
        "tests/equilibrium/test_assemblies.py::TestRigid",
    ): ("equilibrium.methods.weak_strong",),
    (
        "tests/equilibrium/test_grasp.py",
        "tests/equilibrium/test_schema.py",
        "tests/equilibrium/test_space.py::TestModel",
        "tests/equilibrium/test_space.py::TestPyramids::test_edges_on_circle_in_order",
    ): ("equilibrium.model.contact",),
    ("tests/equilibrium/test_grasp.py",): ("equilibrium.decide.as_printed",),
    ("tests/equilibrium/test_resistance.py",): ("equilibrium.model.effort",),
    ("tests/equilibrium/test_displacement.py",): ("equilibrium.model.displacement",),
    (
        "tests/equilibrium/test_verdict.py",
        "tests/equilibrium/test_space_checker.py",
    ): ("equilibrium.model.solution",),
    ("tests/equilibrium/test_rows.py",): ("equilibrium.model.rows",),
    (
        "tests/equilibrium/test_meeting.py",
        "tests/equilibrium/test_corners.py",
    ): ("equilibrium.model.subject",),
    (
        "tests/equilibrium/test_contact_law.py",
        "tests/equilibrium/test_assembly_magnitudes.py",
        "tests/equilibrium/test_assemblies.py::TestEquilibria",
    ): (
        "equilibrium.core.contact_law",
        "equilibrium.core.contact_program",
        "equilibrium.decide.assemblies.magnitudes",
        "proofs_check.routes.bodies",
    ),
    ("tests/equilibrium/test_assemblies.py",): (
        "equilibrium.decide.assemblies.parts",
        "equilibrium.decide.assemblies.rigid",
        "equilibrium.decide.assemblies.engine",
    ),
    (
        "tests/equilibrium/test_assembly_inputs.py",
        "tests/equilibrium/test_assemblies.py",
    ): ("equilibrium.model.assembly",),
    (
        "tests/equilibrium/test_space.py::TestModel",
        "tests/equilibrium/test_grasp.py",
    ): ("equilibrium.model.unit_normal",),
    (
        "tests/equilibrium/test_contact_states.py",
        "tests/equilibrium/test_methods.py",
        "tests/equilibrium/test_wrench_sets_plane.py::test_friction_without_normal_force_is_none",
    ): ("equilibrium.core.contact_rows",),
    (
        "tests/equilibrium/test_leaves.py",
        "tests/equilibrium/test_verdict.py",
        "tests/equilibrium/test_contacts.py",
    ): ("equilibrium.core.contacts",),
    (
        "tests/equilibrium/test_leaves.py",
        "tests/equilibrium/test_resistance.py",
    ): (
        "equilibrium.plane.search.motion_regions",
        "equilibrium.plane.search.units",
    ),
    (
        "tests/equilibrium/test_smooth_law.py",
        "tests/equilibrium/test_leaves.py",
        "tests/equilibrium/test_resistance.py",
    ): ("equilibrium.core.continuation",),
    ("tests/equilibrium/test_many_grasps.py",): (
        "equilibrium.decide.many_grasps.arrays",
        "equilibrium.decide.many_grasps.check",
        "equilibrium.decide.many_grasps.equilibria",
        "equilibrium.decide.many_grasps.questions",
        "equilibrium.decide.many_grasps.refutations",
    ),
    (
        "tests/arrangement/test_budget.py::test_states_undecided_by_floats_refused_by_number",
        *STATES,
    ): ("equilibrium.decide.state_choices",),
    ("tests/equilibrium/test_many_grasps_files.py",): ("equilibrium.decide.many_grasps.tables",),
    ("tests/equilibrium/test_contact_states.py",): (
        "equilibrium.plane.states.contact_states",
        "equilibrium.plane.states.interval_filter",
        "equilibrium.plane.states.min_norm_point",
    ),
    SPACE_SEARCH: (
        "equilibrium.core.cones",
        "equilibrium.core.enclosures",
        "equilibrium.core.equilibria",
        "equilibrium.core.exact_parts",
        "equilibrium.core.leaves",
        "equilibrium.core.memory",
        "equilibrium.plane.coplanar",
        "equilibrium.core.reach",
        "equilibrium.core.relaxation",
        "equilibrium.core.states",
        "equilibrium.core.tree",
    ),
    ("tests/equilibrium/test_any_direction.py",): ("equilibrium.wrench_sets.any_direction",),
    ("tests/equilibrium/test_best_direction.py",): ("equilibrium.wrench_sets.best_direction",),
    ("tests/equilibrium/test_resisted_set.py",): ("equilibrium.wrench_sets.resisted_set",),
    ("tests/equilibrium/test_parameter.py",): (
        "arrangement.numbers.expressions",
        "arrangement.numbers.functions",
        "equilibrium.certificate.parameter",
        "equilibrium.model.parameter",
        "equilibrium.wrench_sets.parameter",
        "equilibrium.pictures.parameter",
        "equilibrium.wrench_sets.sufficient_friction",
    ),
    (
        "tests/equilibrium/test_contact_states.py",
        "tests/equilibrium/test_wrench_sets_plane.py",
    ): ("equilibrium.wrench_sets.line",),
    (
        "tests/equilibrium/test_wrench_sets_space.py",
        "tests/equilibrium/test_space.py::TestManyLoads",
        "tests/equilibrium/test_inputs.py",
    ): ("equilibrium.wrench_sets.loads",),
    ("tests/proofs_check/test_dual_graph.py",): ("proofs_check.routes.dual_graph",),
    ("tests/proofs_check/test_certificates.py",): ("proofs_check.routes.leaves",),
    ("tests/proofs_check/test_many_types.py",): ("proofs_check.routes.many_types",),
    ("tests/proofs_check/test_rigid_loads.py",): ("proofs_check.routes.rigid_loads",),
    ("tests/proofs_check/test_rivin.py",): ("proofs_check.routes.rivin",),
    (
        "tests/proofs_check/test_evidence.py",
        "tests/proofs_check/test_claim.py",
    ): (
        "proofs_check.statements.evidence",
        "proofs_check.statements.statement",
    ),
    (
        "tests/proofs_check/test_sweep_store.py",
        "tests/proofs_check/test_sweep.py",
    ): (
        "proofs_check.sweep.report",
        "proofs_check.sweep.store",
    ),
    (
        "tests/proofs_check/test_many_types.py",
        "tests/proofs_check/test_sweep_store.py",
        "tests/proofs_check/test_sweep.py",
    ): ("proofs_check.sweep.sweep",),
}
TARGETS |= {
    module.partition(".")[2]: Target(module, tests, SAMPLE)
    for tests, modules in SAMPLED.items()
    for module in modules
}

#: Packages whose modules decide an answer.
DECIDING = (
    "arrangement.counts",
    "arrangement.duals",
    "arrangement.enumeration",
    "arrangement.numbers",
    "arrangement.planes",
    "equilibrium.certificate",
    "equilibrium.core",
    "equilibrium.decide",
    "equilibrium.methods",
    "equilibrium.model",
    "equilibrium.plane",
    "equilibrium.wrench_sets",
    "proofs_check.routes",
    "proofs_check.statements",
    "proofs_check.sweep",
)
#: Modules of these that are not a target, and why.
EXCEPTIONS = {
    "arrangement.duals.cells": "shapes of pictures",
    "arrangement.duals.schlegel": "shapes of pictures",
    "arrangement.numbers.deadline": "a clock, which decides no answer but that the time is over",
    "arrangement.planes.drawable": "calls what draws",
    "arrangement.planes.identification": "values that the census computes, and a text",
    "arrangement.planes.proved": "runs the program proved in Coq, which is not built everywhere",
    "equilibrium.decide.short_leaves": "shorter numbers for proofs, if the checker accepts them",
    "proofs_check.routes.proved": "runs the program proved in Coq, which is not built everywhere",
    "equilibrium.decide.verdict_text": "text of verdicts",
    "equilibrium.methods.registry": "a table of names",
    "equilibrium.model.drawable": "calls what draws",
    "equilibrium.model.errors": "messages",
    "equilibrium.model.labels": "units and errors that results repeat",
    "equilibrium.model.outline": "shapes of pictures",
    "equilibrium.model.synonyms": "a table of names",
    "equilibrium.core.tresca": "proposes states, which exact programs decide",
    "equilibrium.wrench_sets.text": "text of resisted sets",
}
