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
