(** Vectors and contacts of the checker as the real ones that they stand for. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra.
Require Import Model Rationals Checker Arcs.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Vectors *)

Lemma qdot_real : forall v w, Q2R (qdot v w) = dot (reals v) (reals w).
Proof.
  induction v as [|x v IH]; intros [|y w]; cbn; try apply zero_real.
  real. now rewrite IH.
Qed.

Lemma qadd_real : forall v w, reals (qadd v w) = add (reals v) (reals w).
Proof.
  induction v as [|x v IH]; intros [|y w]; cbn; trivial. unfold reals in IH. real. now rewrite IH.
Qed.

Lemma qscaled_real t v : reals (qscaled t v) = times (Q2R t) (reals v).
Proof.
  unfold qscaled, reals, times. rewrite !map_map. apply map_ext. intros x. now real.
Qed.

Lemma qvanishes_real v : qvanishes v = true <-> Forall (fun x => x = 0) (reals v).
Proof.
  unfold qvanishes, reals. rewrite forallb_forall, Forall_map, Forall_forall.
  split; intros H x I; apply qzero_real; auto.
Qed.

Lemma dot_nil v : dot v [] = 0.
Proof. now destruct v. Qed.

Lemma dot_add : forall v w d, dot (add v w) d = dot v d + dot w d.
Proof.
  induction v as [|x v IH]; intros [|y w] [|z d]; cbn; rewrite ?IH, ?dot_nil; ring.
Qed.

Lemma dot_times t : forall v d, dot (times t v) d = t * dot v d.
Proof. unfold times. induction v as [|x v IH]; intros [|z d]; cbn; rewrite ?IH; ring. Qed.

Lemma dot_comm : forall v w, dot v w = dot w v.
Proof. induction v as [|x v IH]; intros [|y w]; cbn; rewrite ?IH; ring. Qed.

Lemma dot_vanishing v d : Forall (fun x => x = 0) v -> dot v d = 0.
Proof.
  intros H. revert d. induction H as [|x v -> H IH]; intros [|z d]; cbn; rewrite ?IH; ring.
Qed.

#[export] Hint Rewrite dot_add dot_times : dot.

(** * Contacts *)

Definition real_row (c : row Q) : row R :=
  Row (reals (normal c)) (reals (tangent1 c)) (reals (tangent2 c)) (real_values (values_of c)).

Lemma planar_row_real c : real_row (qplanar_row c) = planar_row (real_contact c).
Proof. unfold real_row, planar_row, wrench, reals. cbn. now real. Qed.

Lemma qcross_real a b : real_vector3 (qcross a b) = cross (real_vector3 a) (real_vector3 b).
Proof. unfold qcross, cross, real_vector3. cbn. now real. Qed.

Lemma spatial_row_real c : real_row (qspatial_row c) = spatial_row (real_contact3 c).
Proof. unfold real_row, spatial_row, wrench3, reals, cross. cbn. now real. Qed.

Lemma at_body_real i w : reals (qat_body i w) = at_body i (reals w).
Proof.
  unfold qat_body, at_body, reals. rewrite map_app. f_equal.
  induction (3 * i)%nat; cbn; rewrite ?zero_real; congruence.
Qed.

Lemma on_bodies_real j w : reals (qon_bodies j w) = on_bodies (real_joint j) (reals w).
Proof.
  unfold qon_bodies, on_bodies. cbn [body_a body_b real_joint].
  destruct (body_b j); rewrite ?qadd_real, ?qscaled_real, ?at_body_real; trivial.
  do 2 f_equal. unfold Q2R. cbn. field.
Qed.

Lemma joint_row_real j : real_row (qjoint_row j) = joint_row (real_joint j).
Proof.
  unfold joint_row. cbn [touch real_joint]. rewrite <- planar_row_real.
  unfold real_row at 1, qjoint_row. cbn [normal tangent1 tangent2 values_of real_row].
  now rewrite !on_bodies_real.
Qed.

Lemma rows_real g : map real_row (qrows_of g) = rows_of (real_question g).
Proof.
  destruct g; cbn; rewrite !map_map; apply map_ext; intros c;
    [apply planar_row_real | apply spatial_row_real | apply joint_row_real].
Qed.

Lemma load_real g : reals (load_of g) = load_of (real_question g).
Proof. now destruct g. Qed.

Lemma dimension_real g : dimension g = dimension (real_question g).
Proof. now destruct g. Qed.

(** * Directions *)

Definition real_pair (a : direction) : pair_R := (Q2R (fst a), Q2R (snd a)).

Lemma qturn_real a b : Q2R (qturn a b) = turn2 (real_pair a) (real_pair b).
Proof. unfold qturn, turn2. cbn. now real. Qed.

Lemma qdot2_real a b : Q2R (qdot2 a b) = dot2 (real_pair a) (real_pair b).
Proof. unfold qdot2, dot2. cbn. now real. Qed.

Lemma beyond_disc_right room mu b : beyond_disc room mu b = true ->
  beyond_disc_real (Q2R room) (Q2R mu) (real_pair b).
Proof.
  unfold beyond_disc, beyond_disc_real.
  rewrite andb_true_iff, qnonneg_real, qleb_real, !qtimes_real, qdot2_real. tauto.
Qed.

Lemma beyond_end_right room mu b e : beyond_end room mu b e = true ->
  beyond_end_real (Q2R room) (Q2R mu) (real_pair b) (real_pair e).
Proof.
  unfold beyond_end, beyond_end_real. destruct (qpositive (qdot2 e b)) eqn:P.
  - rewrite qpositive_real, qdot2_real in P. destruct (Rlt_dec _ _); [|lra].
    rewrite andb_true_iff, qnonneg_real, qleb_real, !qtimes_real, !qdot2_real. tauto.
  - destruct (Rlt_dec _ _) as [L|_].
    { rewrite <- qdot2_real, <- qpositive_real in L. congruence. }
    rewrite orb_true_iff, qnonneg_real, qleb_real, !qtimes_real, !qdot2_real. tauto.
Qed.
