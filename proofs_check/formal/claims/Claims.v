(** Claims of the registry that hold for every number of planes, and counterexamples of those that
    do not. Words are defined in Planes.v; proofs stand in other files. *)

Require Import Reals ZArith List Lia Permutation.
Require Import Planes Sides Rank Recursion Counting Bounds General Sphere Dual Graph Attained Position.
Require Import Crossed Contacts Counterexamples Refuted.
Require Model.
Import ListNotations.
Open Scope Z_scope.

(** * Great circles *)

Theorem great_circle_regions : forall planes n, great_circles planes ->
  number (region planes) n ->
  n <= size planes * size planes - size planes + 2.
Proof. intros planes n C. exact (circle_regions C (n := n)). Qed.

Theorem great_circle_regions_attained : forall planes, great_circles planes ->
  general 3 planes -> 1 <= size planes ->
  number (region planes) (size planes * size planes - size planes + 2).
Proof. exact general_circle_regions. Qed.

(** No other planes attain it: where two coincide, or three share a line, there are fewer. *)
Theorem great_circle_regions_only_general : forall planes, great_circles planes ->
  1 <= size planes ->
  number (region planes) (size planes * size planes - size planes + 2) ->
  general 3 planes.
Proof.
  intros planes [S C] M N. apply (only_general_regions S C). unfold size in *.
  destruct (length planes) as [|k]; [cbn in M; lia|]. now rewrite circles_3.
Qed.

(** General position of planes that are planes (no form is 0 everywhere): no two of them coincide,
    no three have a common point but the origin. *)
Theorem general_position_of_great_circles : forall planes, great_circles planes ->
  (forall f, In f planes -> exists x, (value f x <> 0)%R) ->
  (general 3 planes <-> different planes /\
    forall f g h rest x, Permutation planes (f :: g :: h :: rest) ->
      value f x = 0%R -> value g x = 0%R -> value h x = 0%R ->
      x 0%nat = 0%R /\ x 1%nat = 0%R /\ x 2%nat = 0%R).
Proof. exact general_great_circles. Qed.

Theorem state_formula : forall planes, great_circles planes ->
  general 3 planes -> 3 <= size planes ->
  let m := size planes in
  number (face_of_codimension 3 planes) 1 /\
  number (face_of_codimension 2 planes) (m * (m - 1)) /\
  number (face_of_codimension 1 planes) (2 * m * (m - 1)) /\
  number (face_of_codimension 0 planes) (m * m - m + 2).
Proof. exact general_circles. Qed.

(** All sign vectors: at most this number of slip states, in general position exactly. *)
Theorem slip_states_at_most : forall planes n, great_circles planes ->
  number (face planes) n ->
  n <= 4 * size planes * size planes - 4 * size planes + 3.
Proof. intros planes n C. exact (slip_states_bound (n := n) C). Qed.

Theorem slip_states_attained : forall planes, great_circles planes ->
  general 3 planes -> 3 <= size planes ->
  number (face planes) (4 * size planes * size planes - 4 * size planes + 3).
Proof. exact general_slip_states. Qed.

Theorem slip_states_only_general : forall planes, great_circles planes -> 2 <= size planes ->
  number (face planes) (4 * size planes * size planes - 4 * size planes + 3) ->
  general 3 planes.
Proof. intros planes C M N. exact (only_general_states C M N (Z.le_refl _)). Qed.

(** As many facets, or as many rays, as in general position have no others. *)
Theorem facets_only_general : forall planes, great_circles planes -> 2 <= size planes ->
  number (face_of_codimension 1 planes) (2 * size planes * (size planes - 1)) ->
  general 3 planes.
Proof. intros planes C M N. exact (only_general_facets C M N (Z.le_refl _)). Qed.

Theorem rays_only_general : forall planes, great_circles planes -> rank planes 3 ->
  2 <= size planes ->
  number (face_of_codimension 2 planes) (size planes * (size planes - 1)) ->
  general 3 planes.
Proof. intros planes C R M N. exact (only_general_rays C M R N (Z.le_refl _)). Qed.

Theorem euler : forall planes vertices edges faces, great_circles planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) vertices ->
  number (face_of_codimension 1 planes) edges ->
  number (face_of_codimension 0 planes) faces ->
  vertices - edges + faces = 2.
Proof. intros planes v e f [S C]. now apply sphere_euler. Qed.

(** The dual graph has the regions as vertices, the facets as edges, and a face for each ray. *)
Theorem dual_edge_and_face_bounds : forall planes k rays facets regions,
  great_circles planes -> rank planes k -> (2 <= k)%nat ->
  number (face_of_codimension 2 planes) rays ->
  number (face_of_codimension 1 planes) facets ->
  number (face_of_codimension 0 planes) regions ->
  facets <= 3 * regions - 6 /\ rays <= 2 * regions - 4.
Proof.
  intros planes k v e f C R K V E F. pose proof (dual_bounds C R K V E F). pose proof (number_nonneg V). lia.
Qed.

Theorem dual_bipartite_bounds : forall planes rays facets regions,
  great_circles planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) rays ->
  number (face_of_codimension 1 planes) facets ->
  number (face_of_codimension 0 planes) regions ->
  facets <= 2 * regions - 4 /\ rays <= regions - 2.
Proof. intros planes v e f C R V E F. pose proof (dual_faces C R V E F). lia. Qed.

Theorem dual_bipartite_bounds_attained : forall planes, great_circles planes ->
  general 3 planes -> 3 <= size planes ->
  exists regions, number (face_of_codimension 0 planes) regions /\
    number (face_of_codimension 1 planes) (2 * regions - 4) /\
    number (face_of_codimension 2 planes) (regions - 2).
Proof.
  intros planes C G M. destruct (general_circles C G M) as (_ & V & E & F).
  set (m := size planes) in *. exists (m * m - m + 2). split; [exact F|]. split.
  - now replace (2 * (m * m - m + 2) - 4) with (2 * m * (m - 1)) by ring.
  - now replace (m * m - m + 2 - 2) with (m * (m - 1)) by ring.
Qed.

(** Of different planes (none of the forms is 0 everywhere) no others attain one of the bounds. *)
Theorem dual_bipartite_bounds_only_general : forall planes regions, great_circles planes ->
  (forall f, In f planes -> exists x, (value f x <> 0)%R) -> different planes ->
  number (face_of_codimension 0 planes) regions ->
  number (face_of_codimension 1 planes) (2 * regions - 4) \/
    rank planes 3 /\ number (face_of_codimension 2 planes) (regions - 2) ->
  general 3 planes.
Proof.
  intros planes f C P D F [E|[R V]]; [exact (only_general_dual C P D E F (Z.le_refl _))|].
  pose proof (@euler planes _ _ f C R V (count_number 1 planes) F).
  apply (only_general_dual C P D (count_number 1 planes) F). lia.
Qed.

(** A plane that coincides with another one changes no number of faces. *)
Theorem coincident_planes : forall planes f g k n, In f planes -> same_plane f g ->
  (number (face_of_codimension k (g :: planes)) n <-> number (face_of_codimension k planes) n).
Proof. exact coincident_faces. Qed.

Theorem two_facets_for_each_ray : forall planes rays facets,
  great_circles planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) rays ->
  number (face_of_codimension 1 planes) facets ->
  2 * rays <= facets.
Proof. intros planes v e C R V E. exact (ray_facets C R V E). Qed.

Theorem step_1_square_bound : forall planes n, great_circles planes -> 2 <= size planes ->
  number (region planes) n ->
  n <= size planes * size planes.
Proof. intros planes n C M N. pose proof (circle_regions C N). lia. Qed.

(** [f i] regions of the first i planes, each tested against the next one. *)
Theorem step_1_time : forall planes f, great_circles planes ->
  (forall i, (i < length planes)%nat -> number (region (firstn i planes)) (f i)) ->
  total f (length planes) <= size planes ^ 3.
Proof. exact tests_bound. Qed.

Theorem step_2_time : forall planes n, great_circles planes -> 1 <= size planes ->
  number (region planes) n ->
  n * (n - 1) / 2 <= size planes ^ 4.
Proof.
  intros planes n C M N. pose proof (circle_regions C N). pose proof (number_nonneg N).
  apply Z.div_le_upper_bound; [lia|]. set (m := size planes) in *.
  assert (0 <= m * m - m) by nia.
  assert (0 <= (m * m - m + 2 - n) * (m * m - m + 2 + n - 1)) by (apply Z.mul_nonneg_nonneg; lia).
  assert (n * (n - 1) <= (m * m - m + 2) * (m * m - m + 1)) by lia.
  enough ((m * m - m + 2) * (m * m - m + 1) <= 2 * m ^ 4) by lia.
  replace (m ^ 4) with (m * m * (m * m)) by ring.
  assert (m * m - m + 1 <= m * m) by nia. assert (m * m - m + 2 <= 2 * (m * m)) by nia. nia.
Qed.

Theorem step_3_time : forall planes regions edges, great_circles planes -> 1 <= size planes ->
  number (face_of_codimension 0 planes) regions ->
  number (face_of_codimension 1 planes) edges ->
  regions <= size planes * size planes - size planes + 2 /\ edges <= 2 * (size planes * size planes).
Proof.
  intros planes r e C M R E. split; [exact (circle_faces C R)|].
  pose proof (edges_at_most C E). lia.
Qed.

(** * Any dimension *)

Theorem fukuda_bound : forall d k planes n, of_space d planes -> (k <= d)%nat ->
  number (face_of_codimension (d - k) planes) n ->
  n <= choose (length planes) (d - k) * choose_upto (length planes - (d - k)) k.
Proof.
  intros d k planes n S K N. pose proof (@affine_faces_at_most d planes (d - k) n S ltac:(lia) N) as H.
  now replace (d - (d - k))%nat with k in H by lia.
Qed.

Theorem fukuda_bound_attained : forall d k planes, of_space d planes -> simple d planes ->
  (1 <= d)%nat -> (k <= d)%nat ->
  number (face_of_codimension (d - k) planes)
    (choose (length planes) (d - k) * choose_upto (length planes - (d - k)) k).
Proof.
  intros d k planes _ G D K. pose proof (@simple_faces d planes (d - k) D ltac:(lia) G) as H.
  now replace (d - (d - k))%nat with k in H by lia.
Qed.

(** [f k] faces of codimension k. *)
Theorem bound_not_attained : forall planes f, great_circles planes -> 4 <= size planes ->
  (forall k, number (face_of_codimension k planes) (f k)) ->
  f 0%nat + f 1%nat + f 2%nat + f 3%nat <
  choose_upto (length planes) 3 + choose (length planes) 1 * choose_upto (length planes - 1) 2 +
  choose (length planes) 2 * choose_upto (length planes - 2) 1 + choose (length planes) 3.
Proof. intros planes f C M N. now apply total_below. Qed.

(** * The dual graph *)

(** Regions are neighbours exactly where one plane lies between them. *)
Theorem hamming_edges : forall planes s t, different planes -> region planes s -> region planes t ->
  (share_facet planes s t <-> separating s t = 1%nat).
Proof. intros planes s t D Rs Rt. split; [now apply facet_one_sign|now apply facet_between]. Qed.

(** The distance of two regions is the number of planes between them; so the graph is connected. *)
Theorem dual_distances : forall planes s t, different planes -> region planes s -> region planes t ->
  walk planes s t (separating s t) /\
  forall n, walk planes s t n -> (separating s t <= n)%nat.
Proof.
  intros planes s t D Rs Rt. split; [now apply (walk_straight D (n := separating s t))|].
  intros n. now apply walk_long.
Qed.

(** Neighbours differ in the parity of their minus signs. *)
Theorem dual_bipartite : forall planes s t, different planes -> region planes s -> region planes t ->
  share_facet planes s t -> Nat.even (minus_signs s) <> Nat.even (minus_signs t).
Proof. exact two_classes. Qed.

(** * Contacts that may let go *)

(** Of any planes of R^d; without forms that are 0 everywhere, codimension 0 means regions. *)
Theorem faces_linear_in_regions : forall d planes k faces regions, of_space d planes ->
  number (face_of_codimension k planes) faces ->
  number (face_of_codimension 0 planes) regions ->
  faces <= choose d k * regions.
Proof. intros d planes k f r S F R. exact (faces_of_regions S F R). Qed.

Theorem model_linear_by_regions : forall contacts points lines facets regions,
  Forall planar contacts ->
  number (face_of_codimension 3 (contact_planes contacts)) points ->
  number (face_of_codimension 2 (contact_planes contacts)) lines ->
  number (face_of_codimension 1 (contact_planes contacts)) facets ->
  number (face_of_codimension 0 (contact_planes contacts)) regions ->
  points <= regions /\ lines <= 3 * regions /\ facets <= 3 * regions.
Proof.
  intros cs p l f r P Np Nl Nf Nr. destruct (planar_space P) as [S _].
  pose proof (faces_of_regions S Np Nr). pose proof (faces_of_regions S Nl Nr).
  pose proof (faces_of_regions S Nf Nr). cbn in *. lia.
Qed.

(** Without preload all planes pass through the origin. *)
Theorem model_faces_without_preload : forall contacts origins rays facets regions,
  Forall planar contacts -> Forall (fun c => central (gap c)) contacts -> 1 <= size contacts ->
  number (face_of_codimension 3 (contact_planes contacts)) origins ->
  number (face_of_codimension 2 (contact_planes contacts)) rays ->
  number (face_of_codimension 1 (contact_planes contacts)) facets ->
  number (face_of_codimension 0 (contact_planes contacts)) regions ->
  let m := size contacts in
  origins <= 1 /\ rays <= 2 * m * (2 * m - 1) /\ facets <= 4 * m * (2 * m - 1) /\
  regions <= 4 * m * m - 2 * m + 2.
Proof.
  intros cs o v e f P C M O V E F m. destruct (central_contacts P C) as [G S]. fold m in S, M.
  pose proof (circle_faces G F). pose proof (circle_arcs G ltac:(lia) E).
  pose proof (circle_origins G O). pose proof (circle_rays G V). rewrite S in *. nia.
Qed.

Theorem model_faces_without_preload_attained : forall contacts,
  Forall planar contacts -> Forall (fun c => central (gap c)) contacts -> 2 <= size contacts ->
  general 3 (contact_planes contacts) ->
  let m := size contacts in
  number (face_of_codimension 3 (contact_planes contacts)) 1 /\
  number (face_of_codimension 2 (contact_planes contacts)) (2 * m * (2 * m - 1)) /\
  number (face_of_codimension 1 (contact_planes contacts)) (4 * m * (2 * m - 1)) /\
  number (face_of_codimension 0 (contact_planes contacts)) (4 * m * m - 2 * m + 2).
Proof.
  intros cs P C M Ge m. destruct (central_contacts P C) as [G S]. fold m in S, M.
  pose proof (general_circles G Ge ltac:(lia)) as H. cbv zeta in H. rewrite S in H.
  replace (4 * m * (2 * m - 1)) with (2 * (2 * m) * (2 * m - 1)) by ring.
  replace (4 * m * m - 2 * m + 2) with (2 * m * (2 * m) - 2 * m + 2) by ring. exact H.
Qed.

Theorem model_faces_with_preload : forall contacts points lines facets regions,
  Forall planar contacts -> 3 <= size contacts ->
  number (face_of_codimension 3 (contact_planes contacts)) points ->
  number (face_of_codimension 2 (contact_planes contacts)) lines ->
  number (face_of_codimension 1 (contact_planes contacts)) facets ->
  number (face_of_codimension 0 (contact_planes contacts)) regions ->
  let n := length contacts in let m := size contacts in
  points <= choose (2 * n) 3 - choose n 3 + 1 /\
  lines <= choose n 2 * (m + 2) + (choose (2 * n) 2 - choose n 2) * (2 * m - 1) /\
  facets <= m * (2 * m - 2 + total (fun i => 1 + (m - 1 + Z.of_nat i)) n) +
    m * (2 * m + choose (2 * n - 1) 2) /\
  regions <= m * m - m + 2 + total (fun i => 1 + (m + Z.of_nat i) + choose (n + i) 2) n.
Proof. exact preload_faces. Qed.

(** A state is the same all over a face. *)
Theorem model_states : forall contacts states faces,
  number (state contacts) states ->
  number (face (contact_planes contacts)) faces ->
  states <= faces.
Proof. intros cs s f S F. exact (states_of_faces F S). Qed.

Theorem model_states_without_preload : forall contacts states,
  Forall planar contacts -> Forall (fun c => central (gap c)) contacts ->
  number (state contacts) states ->
  states <= 16 * size contacts * size contacts - 8 * size contacts + 3.
Proof.
  intros cs s P C S. destruct (central_contacts P C) as [G E].
  pose proof (states_of_faces (slip_states_total (contact_planes cs)) S).
  pose proof (slip_states_bound G (slip_states_total (contact_planes cs))). rewrite E in *. lia.
Qed.

Theorem model_states_with_preload : forall contacts states,
  Forall planar contacts -> 3 <= size contacts ->
  number (state contacts) states ->
  let n := length contacts in let m := size contacts in
  states <= choose (2 * n) 3 - choose n 3 + 1 +
    (choose n 2 * (m + 2) + (choose (2 * n) 2 - choose n 2) * (2 * m - 1)) +
    (m * (2 * m - 2 + total (fun i => 1 + (m - 1 + Z.of_nat i)) n) +
      m * (2 * m + choose (2 * n - 1) 2)) +
    (m * m - m + 2 + total (fun i => 1 + (m + Z.of_nat i) + choose (n + i) 2) n).
Proof.
  intros cs s P M S n m. destruct (planar_space P) as [Sp _].
  pose proof (states_of_faces (faces_of_space Sp) S).
  pose proof (preload_faces P M (count_number 3 _) (count_number 2 _) (count_number 1 _) (count_number 0 _)) as H1.
  cbv zeta in H1. fold n m in H1. lia.
Qed.

Theorem state_tree : forall contacts nodes faces, contacts <> [] -> Forall planar contacts ->
  number (node contacts) nodes ->
  number (face (contact_planes contacts)) faces ->
  nodes <= 2 * size contacts * faces.
Proof. intros cs n f N P T F. exact (tree_of_faces N P F T). Qed.

(** * Counterexamples, computed *)

Definition one_plane := real_planes [Form 0 [1; 0; 0]].
Definition two_planes := real_planes [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]].

Theorem step_1_square_bound_needs_two_planes :
  great_circles one_plane /\ number (region one_plane) 2.
Proof.
  split; [split; repeat constructor|]. exact (regions_counted [Form 0 [1; 0; 0]]).
Qed.

Theorem dual_bounds_need_two_planes :
  number (face_of_codimension 1 one_plane) 1 /\ number (face_of_codimension 0 one_plane) 2.
Proof.
  split; [exact (faces_counted [Form 0 [1; 0; 0]] 1)|exact (faces_counted [Form 0 [1; 0; 0]] 0)].
Qed.

Theorem euler_needs_rank_3 : great_circles two_planes /\
  number (face_of_codimension 2 two_planes) 1 /\
  number (face_of_codimension 1 two_planes) 4 /\
  number (face_of_codimension 0 two_planes) 4.
Proof.
  split; [split; repeat constructor|].
  repeat split; [exact (faces_counted [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]] 2)
    | exact (faces_counted [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]] 1)
    | exact (faces_counted [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]] 0)].
Qed.

(** Two planes, any of which are independent, have 9 slip states, not 10. *)
Theorem different_slip_states : great_circles two_planes /\ general 3 two_planes /\
  number (face two_planes) 9.
Proof.
  split; [split; repeat constructor|].
  split; [exact two_planes_general|exact (all_faces_counted [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]])].
Qed.

(** Three equal contacts: with closed conditions the tree has 106 nodes, above 2 * 3 * 9. *)
Definition equal_contacts :=
  repeat (Contact (real_form (Form 0 [1; 0; 0])) (real_form (Form 0 [0; 1; 0]))) 3.

Theorem state_tree_closed : Forall planar equal_contacts /\
  number (closed_node equal_contacts) 106 /\ number (face (contact_planes equal_contacts)) 9.
Proof.
  assert (planar (Contact (real_form (Form 0 [1; 0; 0])) (real_form (Form 0 [0; 1; 0])))) as P.
  { repeat split. exact (@two_planes_general two_planes [] (Permutation_refl two_planes) ltac:(cbn; lia)). }
  split; [do 3 (apply Forall_cons; [exact P|]); apply Forall_nil|]. split.
  - exact closed_nodes.
  - exact (all_faces_counted (repeat (Form 0 [1; 0; 0]) 3 ++ repeat (Form 0 [0; 1; 0]) 3)).
Qed.

(** Three perpendicular planes with these points: two that share no facet are joined by an edge. *)
Definition three_planes := real_planes [Form 0 [1; 0; 0]; Form 0 [0; 1; 0]; Form 0 [0; 0; 1]].

Theorem sphere_hull_edges : exists p s t, on_sphere three_planes p /\
  region three_planes s /\ region three_planes t /\
  hull_edge three_planes p s t /\ ~ share_facet three_planes s t.
Proof. exact skew_hull. Qed.

(** Planes normal to the diagonals of a cube: regions with an even number of minus signs are 8, others 6. *)
Definition diagonal_planes := real_planes
  [Form 0 [1; 1; 1]; Form 0 [1; 1; -1]; Form 0 [1; -1; 1]; Form 0 [-1; 1; 1]].

Theorem sphere_dual_weights : great_circles diagonal_planes /\ different diagonal_planes /\
  forall w, ~ weights_sum_to_one diagonal_planes w.
Proof. exact no_diagonal_weights. Qed.

(** * Grasps: the law is that of Model.v, the contacts are in Refuted.v *)

(** Two equilibria of one grasp under one wrench, with different normal forces. *)
Theorem single_solution : exists d forces d' forces',
  Model.balances (Model.real_question two_springs) d forces /\
  Model.balances (Model.real_question two_springs) d' forces' /\
  normal_forces forces <> normal_forces forces'.
Proof. exact two_solutions. Qed.

(** The spring equation as an equality leaves no forces that balance; the law does. *)
Theorem printed_detachment :
  (exists d forces, Model.balances (Model.real_question opposed) d forces) /\
  forall d forces, length d = 3%nat ->
    Forall2 (never_lets_go d) (Model.rows_of (Model.real_question opposed)) forces ->
    ~ balanced (Model.real_question opposed) forces.
Proof. exact opposed_lets_go. Qed.

(** Resisted with preload 1, and not without the term. *)
Theorem printed_preload :
  (exists d forces, Model.balances (Model.real_question (corner 1)) d forces) /\
  forall d forces, ~ Model.balances (Model.real_question (corner 0)) d forces.
Proof. exact corner_needs_preload. Qed.
