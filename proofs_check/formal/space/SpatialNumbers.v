(** Rational numbers of the checker as the real numbers that they stand for. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra.
Require Import SpatialModel SpatialChecker Arcs.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Lemma lowest_real q : Q2R (lowest q) = Q2R q.
Proof.
  apply Qeq_eqR. unfold lowest, Qeq. cbn [Qnum Qden].
  set (d := Z.gcd (Qnum q) (Zpos (Qden q))).
  assert (0 < d)%Z as D.
  { pose proof (Z.gcd_nonneg (Qnum q) (Zpos (Qden q))).
    assert (d <> 0)%Z; [|unfold d in *; lia].
    unfold d. rewrite Z.gcd_eq_0. lia. }
  destruct (Z.gcd_divide_l (Qnum q) (Zpos (Qden q))) as [n N].
  destruct (Z.gcd_divide_r (Qnum q) (Zpos (Qden q))) as [m M]. fold d in N, M.
  assert (0 < m)%Z by nia. rewrite N, M, !Z.div_mul by lia. rewrite Z2Pos.id by trivial. ring.
Qed.

Lemma qplus_real a b : Q2R (qplus a b) = Q2R a + Q2R b.
Proof. unfold qplus. now rewrite lowest_real, Q2R_plus. Qed.

Lemma qtimes_real a b : Q2R (qtimes a b) = Q2R a * Q2R b.
Proof. unfold qtimes. now rewrite lowest_real, Q2R_mult. Qed.

Lemma qminus_real a b : Q2R (qminus a b) = Q2R a - Q2R b.
Proof. unfold qminus. now rewrite lowest_real, Q2R_minus. Qed.

Lemma zero_real : Q2R 0 = 0.
Proof. unfold Q2R. cbn. field. Qed.

Lemma inverse_pos q : 0 < / IZR (Zpos (Qden q)).
Proof. apply Rinv_0_lt_compat, IZR_lt. lia. Qed.

Lemma qzero_real a : qzero a = true <-> Q2R a = 0.
Proof.
  unfold qzero, Q2R. rewrite Z.eqb_eq. pose proof (inverse_pos a). split; intros E.
  - rewrite E. lra.
  - apply eq_IZR. nra.
Qed.

Lemma qnonneg_real a : qnonneg a = true <-> 0 <= Q2R a.
Proof.
  unfold qnonneg, Q2R. rewrite Z.leb_le. pose proof (inverse_pos a). split; intros E.
  - apply IZR_le in E. nra.
  - apply le_IZR. nra.
Qed.

Lemma qpositive_real a : qpositive a = true <-> 0 < Q2R a.
Proof.
  unfold qpositive, Q2R. rewrite Z.ltb_lt. pose proof (inverse_pos a). split; intros E.
  - apply IZR_lt in E. nra.
  - apply lt_IZR. nra.
Qed.

Lemma qleb_real a b : qleb a b = true <-> Q2R a <= Q2R b.
Proof.
  unfold qleb. rewrite Qle_bool_iff. split; [apply Qle_Rle | apply Rle_Qle].
Qed.

Lemma qeqb_real a b : Qeq_bool a b = true <-> Q2R a = Q2R b.
Proof. rewrite Qeq_bool_iff. split; [apply Qeq_eqR | apply eqR_Qeq]. Qed.

#[export] Hint Rewrite qplus_real qtimes_real qminus_real Q2R_opp zero_real : real.
Ltac real := autorewrite with real.

(** * Vectors and screws *)

Lemma qdot3_real a b : Q2R (qdot3 a b) = dot3 (real_vector3 a) (real_vector3 b).
Proof. unfold qdot3, dot3, real_vector3. cbn. now real. Qed.

Lemma qcross_real a b : real_vector3 (qcross a b) = cross (real_vector3 a) (real_vector3 b).
Proof. unfold qcross, cross, real_vector3. cbn. now real. Qed.

Lemma qwork_real w d : Q2R (qwork w d) = work (real_screw w) (real_screw d).
Proof. unfold qwork, work. rewrite qplus_real, !qdot3_real. trivial. Qed.

Lemma qsum_real v w : real_screw (qsum v w) = plus (real_screw v) (real_screw w).
Proof. unfold qsum, plus, real_screw, qadd3, add3, real_vector3. cbn. now real. Qed.

Lemma qscaled_real t w : real_screw (qscaled t w) = scaled (Q2R t) (real_screw w).
Proof. unfold qscaled, scaled, real_screw, qtimes3, times3, real_vector3. cbn. now real. Qed.

Lemma qnothing_real : real_screw qnothing = nothing.
Proof. unfold real_screw, nothing, real_vector3. cbn. now real. Qed.

Lemma qvanishes_real w : qvanishes w = true <-> real_screw w = nothing.
Proof.
  unfold qvanishes. rewrite !andb_true_iff, !qzero_real.
  unfold real_screw, real_vector3, nothing. split.
  - intros (((((A & B) & C) & D) & E) & F). now rewrite A, B, C, D, E, F.
  - intros E. injection E. tauto.
Qed.

Lemma work_comm v w : work v w = work w v.
Proof. unfold work, dot3. ring. Qed.

Lemma work_plus v w d : work (plus v w) d = work v d + work w d.
Proof. unfold work, plus, dot3. cbn. ring. Qed.

Lemma work_scaled t w d : work (scaled t w) d = t * work w d.
Proof. unfold work, scaled, dot3. cbn. ring. Qed.

Lemma work_nothing d : work nothing d = 0.
Proof. unfold work, nothing, dot3. cbn. ring. Qed.

#[export] Hint Rewrite work_plus work_scaled work_nothing : work.

(** The wrenches of a contact are those of the law. *)
Lemma n_real c : real_screw (n_wrench (body_of c)) = N (real_contact3 c).
Proof. unfold N, wrench3, real_screw. cbn. now rewrite qcross_real. Qed.

Lemma t_real c : real_screw (t_wrench (body_of c)) = T1 (real_contact3 c).
Proof. unfold T1, wrench3, real_screw. cbn. now rewrite qcross_real. Qed.

Lemma u_real c : real_screw (u_wrench (body_of c)) = T2 (real_contact3 c).
Proof. unfold T2, wrench3, real_screw. cbn. now rewrite !qcross_real. Qed.

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
