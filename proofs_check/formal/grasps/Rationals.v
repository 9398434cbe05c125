(** Rational numbers that are kept in lowest terms, and the real numbers that they stand for. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

Definition lowest (q : Q) : Q :=
  let d := Z.gcd (Qnum q) (Zpos (Qden q)) in Qmake (Qnum q / d) (Z.to_pos (Zpos (Qden q) / d)).

Definition qplus (a b : Q) := lowest (a + b).
Definition qtimes (a b : Q) := lowest (a * b).
Definition qminus (a b : Q) := lowest (a - b).
Definition qzero (a : Q) : bool := Qnum a =? 0.
Definition qnonneg (a : Q) : bool := 0 <=? Qnum a.
Definition qpositive (a : Q) : bool := 0 <? Qnum a.
Definition qleb (a b : Q) : bool := Qle_bool a b.

Open Scope R_scope.

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
