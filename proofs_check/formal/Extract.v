(** The checkers and the counts as an OCaml program, its integers those of zarith. *)

Require Import ZArith Extraction ExtrOcamlZBigInt.
Require Import Checker Soundness Counting Whitney Bounded Claims FinalPolynomials.
Require Import SpatialChecker SpatialSoundness Inscribed Weights.

(** One line beyond the standard library's: without it, gcd counts down bits one by one. *)
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".

Extraction "checker.ml" check
  count_regions count_faces characteristic_polynomial code complete_regions complete_faces
  final check3 contradicts satisfies.

Print Assumptions not_resisted.
Print Assumptions resisted.
Print Assumptions regions_counted.
Print Assumptions faces_counted.
Print Assumptions all_faces_counted.
Print Assumptions zaslavsky.
Print Assumptions faces_alternating.
Print Assumptions regions_complete.
Print Assumptions faces_complete.
Print Assumptions whitney.
Print Assumptions bounded_counted.
Print Assumptions no_half_line.
Print Assumptions central_unbounded.

Print Assumptions great_circle_regions.
Print Assumptions great_circle_regions_attained.
Print Assumptions great_circle_regions_only_general.
Print Assumptions general_position_of_great_circles.
Print Assumptions state_formula.
Print Assumptions slip_states_at_most.
Print Assumptions slip_states_attained.
Print Assumptions slip_states_only_general.
Print Assumptions facets_only_general.
Print Assumptions rays_only_general.
Print Assumptions euler.
Print Assumptions dual_edge_and_face_bounds.
Print Assumptions dual_bipartite_bounds.
Print Assumptions dual_bipartite_bounds_attained.
Print Assumptions dual_bipartite_bounds_only_general.
Print Assumptions coincident_planes.
Print Assumptions two_facets_for_each_ray.
Print Assumptions step_1_square_bound.
Print Assumptions step_1_time.
Print Assumptions step_2_time.
Print Assumptions step_3_time.
Print Assumptions fukuda_bound.
Print Assumptions fukuda_bound_attained.
Print Assumptions bound_not_attained.
Print Assumptions hamming_edges.
Print Assumptions dual_distances.
Print Assumptions dual_bipartite.
Print Assumptions faces_linear_in_regions.
Print Assumptions model_linear_by_regions.
Print Assumptions model_faces_without_preload.
Print Assumptions model_faces_without_preload_attained.
Print Assumptions model_faces_with_preload.
Print Assumptions model_states.
Print Assumptions model_states_without_preload.
Print Assumptions model_states_with_preload.
Print Assumptions state_tree.
Print Assumptions step_1_square_bound_needs_two_planes.
Print Assumptions dual_bounds_need_two_planes.
Print Assumptions euler_needs_rank_3.
Print Assumptions different_slip_states.
Print Assumptions state_tree_closed.
Print Assumptions sphere_hull_edges.
Print Assumptions sphere_dual_weights.

Print Assumptions no_coordinates.

Print Assumptions not_resisted_in_space.
Print Assumptions resisted_in_space.

Print Assumptions no_weights.
Print Assumptions weights_hold.
