(** Only planes in general position attain the bounds. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Sphere Merge Dual.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

Local Notation rho B := (regions look_real restrict_real (length B) B).
Local Notation onto' h B := (onto look_real (restrict_real h) B).

(** * Independence does not depend on the order *)

Lemma independent_permutation fs gs : Permutation fs gs -> independent fs -> independent gs.
Proof.
  intros P I values L.
  assert (exists values', length values' = length fs /\ forall v,
    map (fun f => linear (coefficients f) v) fs = values' ->
    map (fun f => linear (coefficients f) v) gs = values) as (values' & L' & Good).
  { clear I. revert values L. induction P as [|f fs gs P IH|f g fs|fs gs hs P IH Q IH2]; intros values L.
    - now exists values.
    - destruct values as [|a values]; [easy|]. injection L as L. destruct (IH values L) as (w & Lw & W).
      exists (a :: w). split; [cbn; now rewrite Lw|]. intros v V. injection V as V0 V. cbn. now rewrite V0, (W v V).
    - destruct values as [|a [|b values]]; try easy. exists (b :: a :: values). split; [exact L|].
      intros v V. injection V as V0 V1 V. cbn. now rewrite V0, V1, V.
    - destruct (IH2 values L) as (w & Lw & W). destruct (IH w Lw) as (u & Lu & U). exists u. split; trivial. auto. }
  destruct (I values' L') as (v & V). exists v. now apply Good.
Qed.

Lemma independent_restricted h fs : look_real h = Plane -> independent (map (restrict_real h) fs) ->
  independent (h :: fs).
Proof.
  intros K. apply (@below_independent h _ (@look_real_slope h K)).
  induction fs as [|f fs IH]; cbn; constructor; trivial. now apply restrict_real_below.
Qed.

Lemma general_extend d h B : look_real h = Plane -> general (S d) B ->
  general d (map (restrict_real h) B) -> general (S d) (h :: B).
Proof.
  intros K G R fs rest P L.
  assert (In h (fs ++ rest)) as [I|I]%in_app_iff by (apply (Permutation_in h P); now left).
  - apply in_split in I as (l1 & l2 & ->).
    assert (Permutation B ((l1 ++ l2) ++ rest)) as Q.
    { apply Permutation_cons_inv with h. rewrite P, <- !app_assoc. cbn. symmetry. apply Permutation_middle. }
    apply independent_permutation with (h :: l1 ++ l2); [apply Permutation_middle|].
    apply independent_restricted; trivial. apply R with (map (restrict_real h) rest).
    + rewrite <- map_app. now apply Permutation_map.
    + rewrite map_length. rewrite app_length in *. cbn in L. lia.
  - apply in_split in I as (r1 & r2 & ->). apply G with (r1 ++ r2); trivial.
    apply Permutation_cons_inv with h. rewrite P, !app_assoc. symmetry. rewrite <- app_assoc.
    rewrite app_assoc. apply Permutation_middle.
Qed.

(** * Regions *)

Lemma general_0 B : general 0 B.
Proof.
  intros [|f fs] rest _ L; [|cbn in L; lia]. intros [|] E; [|easy]. now exists origin.
Qed.

Lemma general_nil d : general d [].
Proof.
  intros [|f fs] rest P _; [|now apply Permutation_nil_cons in P].
  intros [|] E; [|easy]. now exists origin.
Qed.

Lemma central_positive m d : 0 < central_regions m (S d).
Proof. destruct m; cbn; [lia|]. pose proof (upto_positive m d). lia. Qed.

Lemma only_general : forall d n D B, (length B <= n)%nat -> (length D <= d)%nat ->
  Forall (within D) B -> Forall central B -> rho B = central_regions (length B) d -> general d B.
Proof.
  intros d n. revert d. induction n as [|n IH]; intros d D [|h B] L LD W C E; try (cbn in L; lia);
    try apply general_nil.
  destruct d as [|d]; [apply general_0|]. cbn in L.
  inversion W as [|? ? Wh WB]; subst. inversion C as [|? ? Ch CB]; subst.
  pose proof (central_positive (length (h :: B)) d) as Pos. rewrite <- E in Pos.
  assert (look_real h = Plane) as K.
  { destruct (look_real h) eqn:K; trivial; [cbn in Pos; rewrite K in Pos; lia|now destruct (@central_look h Ch)]. }
  rewrite (@rho_cons h B K) in E. cbn [length] in E. rewrite central_step in E.
  pose proof (@pivot_within D h K Wh) as Less.
  set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D) in *.
  pose proof (@central_regions_bound (length B) D B (le_n _) WB CB) as HB.
  assert (rho B <= central_regions (length B) (S d)) as HB'.
  { pose proof (@central_grows (length B) (length B) (length D) (S d) (le_n _) LD ltac:(lia)). lia. }
  destruct B as [|b B].
  { apply general_extend; trivial; apply general_nil. }
  set (A := b :: B) in *.
  assert (added h A <= central_regions (length A) d) as HA.
  { unfold added. destruct (onto' h A) as [B'|] eqn:O; [|apply central_nonneg].
    destruct (@onto_all (within D) (within D') (restrict_real h) A
      (fun g => @within_restrict D h g K Wh) WB B' O) as [W' _].
    destruct (@onto_all central central (restrict_real h) A (fun g => @central_restrict h g Ch) CB B' O)
      as [C' _].
    pose proof (@central_onto h A B' C O) as Len.
    pose proof (@central_regions_bound (length B') D' B' (le_n _) W' C').
    pose proof (@central_grows (length B') (length A) (length D') d ltac:(lia) ltac:(lia)
      ltac:(right; rewrite Len; cbn; lia)). lia. }
  apply general_extend; trivial; [apply IH with D; trivial; lia|].
  destruct d as [|d]; [apply general_0|].
  pose proof (central_positive (length A) d). unfold added in *.
  destruct (onto_planes C) as [(g & Ig & V)|P].
  { destruct (onto' h A) as [B'|] eqn:O; [|lia]. exfalso. clear - O Ig V. revert B' O.
    induction A as [|a A IH]; [easy|]. cbn. intros B' O. destruct Ig as [->|Ig].
    - now rewrite V in O.
    - destruct (look_real (restrict_real h a)); [easy|now apply (IH Ig B')|].
      destruct (onto' h A) eqn:O'; [|easy]. now apply (IH Ig l). }
  rewrite (onto_full _ P) in *. apply IH with D'.
  - rewrite map_length. lia.
  - lia.
  - now apply restricted_within.
  - now apply restricted_central.
  - rewrite map_length in E, HA |- *. lia.
Qed.

Lemma only_general_regions d planes : of_space d planes -> Forall central planes ->
  number (region planes) (central_regions (length planes) d) -> general d planes.
Proof.
  intros S C N. apply only_general with (length planes) (seq 0 d); trivial.
  - now rewrite seq_length.
  - now apply of_space_within.
  - apply (number_unique (regions_real_count planes) N).
Qed.

(** * Facets, rays and all sign vectors of great circles *)

Lemma only_general_faces planes n : great_circles planes -> 2 <= size planes ->
  number (face_of_codimension 0 planes) n -> size planes * size planes - size planes + 2 <= n ->
  general 3 planes.
Proof.
  intros [S C] M N Le. destruct (merge C) as (B & e & Mg & G & F & Len).
  apply (merged_number _ _ Mg F) in N. pose proof (proj1 Mg) as I.
  assert (great_circles B) as GB.
  { split; unfold of_space in *; rewrite Forall_forall in *; auto. }
  pose proof (circle_faces GB N) as Up. destruct Len as [L| ->].
  - exfalso. unfold size in *. nia.
  - assert (Forall (fun f => look_real f = Plane) planes) as P.
    { apply Forall_forall. intros f Hf. now apply (@general_plane 1 planes). }
    pose proof (number_unique N (faces_real_count planes 0)) as E. unfold faces_real in E.
    rewrite (faces_open [] (le_n _) P), app_nil_r, rho_rev in E.
    assert (number (region planes) n) as Rn by (rewrite E; apply regions_real_count).
    clear E. apply (only_general_regions S C). unfold size in *.
    destruct (length planes) as [|k]; [cbn in M; lia|]. rewrite circles_3.
    now replace (Z.of_nat (Datatypes.S k) * Z.of_nat (Datatypes.S k) - Z.of_nat (Datatypes.S k) + 2) with n by lia.
Qed.

Lemma one_facet planes n : great_circles planes -> rank planes 1 ->
  number (face_of_codimension 1 planes) n -> n <= 1.
Proof.
  intros [S C] R N. destruct (merge C) as (B & e & Mg & G & F & _).
  apply (merged_number _ _ Mg F) in N. apply (proj1 (merged_rank 1 Mg)) in R. pose proof (proj1 Mg) as I.
  assert (great_circles B) as [SB CB].
  { split; unfold of_space in *; rewrite Forall_forall in *; auto. }
  pose proof (@central_faces_at_most 3 B 1 n SB CB ltac:(lia) N) as H.
  destruct B as [|f [|g B]]; cbn in H; try lia. exfalso. destruct R as [_ U].
  enough (2 <= 1)%nat by lia. apply (U [f; g]).
  - intros h [<-|[<-|[]]]; cbn; auto.
  - apply G with B; [reflexivity|cbn; lia].
Qed.

Lemma circle_rank planes : great_circles planes -> exists k, rank planes k /\ (k <= 3)%nat.
Proof.
  intros [S C]. destruct (@rank_exists _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane _ planes (le_n _)) as [k R]. rewrite map_id in R.
  exists k. split; trivial. destruct (Nat.le_gt_cases k 3) as [|L]; trivial.
  pose proof (@origin_face planes k C R). pose proof (@deep_faces 3 planes k S C ltac:(lia)) as D.
  destruct (Nat.eqb_spec k 3); lia.
Qed.

Lemma through_incl planes s : incl (through planes s) planes.
Proof.
  intros g. revert s. induction planes as [|f l IH]; intros [|[] s] G; cbn in *; try easy;
  try (right; now apply IH with s). destruct G as [->|G]; [now left|right; now apply IH with s].
Qed.

Lemma rank_0_faces planes n : great_circles planes -> rank planes 0 ->
  number (face_of_codimension 1 planes) n -> n = 0.
Proof.
  intros [S C] [_ U] N. apply (@number_unique _ (face_of_codimension 1 planes)); trivial.
  apply number_none. intros s [_ [(gs & I & D & L) _]].
  pose proof (U gs) as H. rewrite L in H. enough (1 <= 0)%nat by lia. apply H; trivial.
  intros g G. exact (@through_incl planes s g (I g G)).
Qed.

Lemma only_general_facets planes n : great_circles planes -> 2 <= size planes ->
  number (face_of_codimension 1 planes) n -> 2 * size planes * (size planes - 1) <= n -> general 3 planes.
Proof.
  intros G M N Le. destruct (circle_rank G) as (k & R & K).
  destruct (Nat.le_gt_cases 2 k) as [K2|K2].
  - pose proof (@dual_edges planes k n _ G R K2 N (faces_real_count planes 0)) as E.
    apply (@only_general_faces planes _ G M (faces_real_count planes 0)). lia.
  - exfalso. destruct k as [|[|k]]; [|pose proof (one_facet G R N); nia|lia].
    pose proof (rank_0_faces G R N). nia.
Qed.

Lemma only_general_rays planes n : great_circles planes -> 2 <= size planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) n -> size planes * (size planes - 1) <= n -> general 3 planes.
Proof.
  intros G M R N Le.
  pose proof (dual_faces G R N (faces_real_count planes 1) (faces_real_count planes 0)) as (_ & _ & E & _).
  apply (@only_general_faces planes _ G M (faces_real_count planes 0)). lia.
Qed.

Lemma only_general_states planes n : great_circles planes -> 2 <= size planes ->
  number (face planes) n -> 4 * size planes * size planes - 4 * size planes + 3 <= n -> general 3 planes.
Proof.
  intros G M N Le. rewrite (number_unique N (slip_states_total planes)), (four_terms G) in Le.
  pose proof (circle_arcs G M (faces_real_count planes 1)) as F1.
  pose proof (circle_origins G (faces_real_count planes 3)).
  pose proof (circle_rays G (faces_real_count planes 2)).
  apply (@only_general_faces planes _ G M (faces_real_count planes 0)). lia.
Qed.
