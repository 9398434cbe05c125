(** The checkers and the counts as an OCaml program, its integers those of zarith. *)

Require Import ZArith Extraction ExtrOcamlZBigInt.
Require Import Checker Soundness Adhesion Forest Counting Whitney Bounded Claims FinalPolynomials.
Require Import Rationals Inscribed Weights.

(** One line beyond the standard library's: without it, gcd counts down bits one by one. *)
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".

Extraction "checker.ml" check_pulled
  count_regions count_faces characteristic_polynomial code complete_regions complete_faces
  final contradicts satisfies.

(** What all theorems rest on, printed once: each printing goes through the proofs and the real numbers. *)

Definition theorems := (
  not_resisted, resisted, not_resisted_pulled, resisted_pulled, forest_by_bodies, regions_counted, faces_counted, all_faces_counted, zaslavsky,
  faces_alternating, regions_complete, faces_complete, whitney, bounded_counted, no_half_line,
  central_unbounded,

  great_circle_regions, great_circle_regions_attained, great_circle_regions_only_general,
  general_position_of_great_circles, state_formula, slip_states_at_most, slip_states_attained,
  slip_states_only_general, facets_only_general, rays_only_general, euler,
  dual_edge_and_face_bounds, dual_bipartite_bounds, dual_bipartite_bounds_attained,
  dual_bipartite_bounds_only_general, coincident_planes, two_facets_for_each_ray,
  step_1_square_bound, step_1_time, step_2_time, step_3_time, fukuda_bound, fukuda_bound_attained,
  bound_not_attained, hamming_edges, dual_distances, dual_bipartite, faces_linear_in_regions,
  model_linear_by_regions, model_faces_without_preload, model_faces_without_preload_attained,
  model_faces_with_preload, model_states, model_states_without_preload, model_states_with_preload,
  state_tree, step_1_square_bound_needs_two_planes, dual_bounds_need_two_planes,
  euler_needs_rank_3, different_slip_states, state_tree_closed, sphere_hull_edges,
  sphere_dual_weights, single_solution, printed_detachment, printed_preload,

  no_coordinates,

  no_weights, weights_hold).

Print Assumptions theorems.
