(** The row of a contact is a lower bound of what the contact does. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Checker Numbers.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The law in integers *)

Definition motion (d : vector R) : quad R := Quad 1 (along_x d) (along_y d) (turn d).

(** The entries of an integer contact are what its definition says. *)
Record faithful (c : integer_contact) (r : contact R) : Prop := {
  unit_n_pos : 0 < IZR (unit_n c);
  unit_e_pos : 0 < IZR (unit_e c);
  unit_mu_pos : 0 < IZR (unit_mu c);
  normal_0 : q0 (normal c) = 0%Z;
  normal_1 : IZR (q1 (normal c)) = IZR (unit_n c) * along_x (N r);
  normal_2 : IZR (q2 (normal c)) = IZR (unit_n c) * along_y (N r);
  normal_3 : IZR (q3 (normal c)) = IZR (unit_n c) * turn (N r);
  tangent_0 : q0 (tangent c) = 0%Z;
  tangent_1 : IZR (q1 (tangent c)) = IZR (unit_n c) * along_x (T r);
  tangent_2 : IZR (q2 (tangent c)) = IZR (unit_n c) * along_y (T r);
  tangent_3 : IZR (q3 (tangent c)) = IZR (unit_n c) * turn (T r);
  spring_0 : IZR (q0 (spring c)) = IZR (unit_e c) * preload r;
  spring_1 : IZR (q1 (spring c)) = - IZR (unit_e c) * (stiffness r * along_x (N r));
  spring_2 : IZR (q2 (spring c)) = - IZR (unit_e c) * (stiffness r * along_y (N r));
  spring_3 : IZR (q3 (spring c)) = - IZR (unit_e c) * (stiffness r * turn (N r));
  slope_mu : IZR (slope c) = IZR (unit_mu c) * friction r
}.

Lemma integers_faithful c : faithful (integers c) (real_contact c).
Proof.
  unfold integers, real_contact, N, T, wrench.
  set (d := common [point_x c; point_y c]). set (u := common [normal_x c; normal_y c]).
  set (e := common [stiffness c; preload c]).
  assert (0 < IZR d) by apply IZR_lt, common_pos.
  assert (0 < IZR u) by apply IZR_lt, common_pos.
  assert (0 < IZR e) by apply IZR_lt, common_pos.
  assert (IZR (clear d (point_x c)) = IZR d * Q2R (point_x c)) as P1
    by (apply clear_common; cbn; auto).
  assert (IZR (clear d (point_y c)) = IZR d * Q2R (point_y c)) as P2
    by (apply clear_common; cbn; auto).
  assert (IZR (clear u (normal_x c)) = IZR u * Q2R (normal_x c)) as P3
    by (apply clear_common; cbn; auto).
  assert (IZR (clear u (normal_y c)) = IZR u * Q2R (normal_y c)) as P4
    by (apply clear_common; cbn; auto).
  assert (IZR (clear e (stiffness c)) = IZR e * Q2R (stiffness c)) as P5
    by (apply clear_common; cbn; auto).
  assert (IZR (clear e (preload c)) = IZR e * Q2R (preload c)) as P6
    by (apply clear_common; cbn; auto).
  assert (0 < IZR (Zpos (Qden (friction c)))) by now apply IZR_lt.
  assert (0 < IZR d * IZR u) by now apply Rmult_lt_0_compat.
  assert (0 < IZR e * (IZR d * IZR u)) by now apply Rmult_lt_0_compat.
  constructor; cbn -[IZR Z.mul common clear]; fold d u e; trivial; reals;
    rewrite ?P1, ?P2, ?P3, ?P4, ?P5, ?P6; trivial; try ring.
  unfold Q2R. field. lra.
Qed.

Section One_contact.
  Variables (c : integer_contact) (r : contact R) (d : vector R).
  Hypothesis Hc : faithful c r.

  Let x := motion d.

  Lemma spring_value :
    evalR (spring c) x = IZR (unit_e c) * (preload r - stiffness r * dot (N r) d).
  Proof.
    unfold evalR, x, motion, dot; cbn [q0 q1 q2 q3].
    rewrite (spring_0 Hc), (spring_1 Hc), (spring_2 Hc), (spring_3 Hc). ring.
  Qed.

  Lemma tangent_value : evalR (tangent c) x = IZR (unit_n c) * dot (T r) d.
  Proof.
    unfold evalR, x, motion, dot; cbn [q0 q1 q2 q3].
    rewrite (tangent_0 Hc), (tangent_1 Hc), (tangent_2 Hc), (tangent_3 Hc). ring.
  Qed.
End One_contact.

(** Normal and tangential force in the units of the integer contact: C and F obey a law in which
    only the values of spring and slip occur. *)
Record scaled_law (mu e s C F : R) : Prop := {
  scaled_spring : C = Rmax 0 e;
  scaled_cone : Rabs F <= mu * C;
  scaled_plus : 0 < s -> F = - mu * C;
  scaled_minus : s < 0 -> F = mu * C
}.

Lemma Rmax_scale u a : 0 < u -> u * Rmax 0 a = Rmax 0 (u * a).
Proof.
  intros Hu. unfold Rmax. destruct (Rle_dec 0 a); destruct (Rle_dec 0 (u * a)); try ring; nra.
Qed.

Lemma law_scaled c r d c_n c_t :
  faithful c r -> law d r (c_n, c_t) ->
  scaled_law (IZR (slope c)) (evalR (spring c) (motion d)) (evalR (tangent c) (motion d))
    (IZR (unit_e c) * c_n) (IZR (unit_mu c) * IZR (unit_e c) * c_t).
Proof.
  intros Hc (Spring & Cone & Plus & Minus).
  rewrite (spring_value d Hc), (tangent_value d Hc), (slope_mu Hc).
  pose proof (unit_n_pos Hc) as Un. pose proof (unit_e_pos Hc) as Ue.
  pose proof (unit_mu_pos Hc) as Um.
  assert (0 < IZR (unit_mu c) * IZR (unit_e c)) as Ume by now apply Rmult_lt_0_compat.
  split.
  - rewrite Spring. now apply Rmax_scale.
  - rewrite Rabs_mult, (Rabs_right (_ * _)) by lra.
    replace (IZR (unit_mu c) * friction r * (IZR (unit_e c) * c_n))
      with (IZR (unit_mu c) * IZR (unit_e c) * (friction r * c_n)) by ring.
    apply Rmult_le_compat_l; lra.
  - intros S. rewrite Plus by nra. ring.
  - intros S. rewrite Minus by nra. ring.
Qed.

Definition holds (s : state) (e t : R) : Prop :=
  match s with
  | Undecided => True
  | Detached => e <= 0
  | Attached => 0 <= e
  | Stick => 0 <= e /\ t = 0
  | SlipPlus => 0 <= e /\ 0 < t
  | SlipMinus => 0 <= e /\ t < 0
  end.

(** * Rows *)

Definition row_value (c : integer_contact) (r : row) (x : quad R) : R :=
  match r with
  | Nothing => 0
  | Linear alpha h => IZR alpha * evalR (spring c) x + IZR h * evalR (tangent c) x
  | Pressed k => IZR k * Rmax 0 (evalR (spring c) x)
  end.

(** A row is at most what it is on the generators, added up: only [Pressed] with a negative factor
    is not linear, and it is concave. *)
Definition concave (r : row) : Prop := match r with Pressed k => (k <= 0)%Z | _ => True end.

Lemma Rmax_IZR a : IZR (Z.max 0 a) = Rmax 0 (IZR a).
Proof.
  unfold Rmax. destruct (Rle_dec 0 (IZR a)) as [H|H].
  - apply le_IZR in H. f_equal. lia.
  - apply Rnot_le_lt, lt_IZR in H. f_equal. lia.
Qed.

Lemma row_superadditive c r t g x :
  concave r -> 0 <= t ->
  t * IZR (row_at c r g) + row_value c r x <= row_value c r (shift t g x).
Proof.
  intros Hr Ht. destruct r as [|alpha h|k]; cbn [row_at row_value].
  - lra.
  - rewrite !eval_shift, plus_IZR, !mult_IZR. lra.
  - cbn in Hr. apply IZR_le in Hr.
    rewrite eval_shift, mult_IZR, Rmax_IZR.
    set (a := IZR (eval (spring c) g)). set (b := evalR (spring c) x).
    assert (Rmax 0 (t * a + b) <= t * Rmax 0 a + Rmax 0 b); [|nra].
    unfold Rmax. destruct (Rle_dec 0 (t * a + b)), (Rle_dec 0 a), (Rle_dec 0 b); nra.
Qed.

Section Row.
  Variables (c : integer_contact) (gens : list (quad Z)) (x : quad R) (l : quad Z) (s : state).
  Variables C F : R.
  Let e := evalR (spring c) x.
  Let t := evalR (tangent c) x.
  Let mu := IZR (slope c).
  Let A := IZR (unit_mu c) * IZR (eval (normal c) l).
  Let B := IZR (eval (tangent c) l).
  Hypothesis Hx : spans gens x.
  Hypothesis Hx0 : q0 x <> 0.
  Hypothesis Hlaw : scaled_law mu e t C F.
  Hypothesis Hs : holds s e t.

  Lemma forall_gens (P : quad Z -> bool) :
    forallb P gens = true -> forall g, In g gens -> P g = true.
  Proof. now rewrite forallb_forall. Qed.

  Lemma C_nonneg : 0 <= C.
  Proof. rewrite (scaled_spring Hlaw). apply Rmax_l. Qed.

  Lemma C_of_pressed : 0 <= e -> C = e.
  Proof. intros. rewrite (scaled_spring Hlaw). now apply Rmax_right. Qed.

  Lemma C_of_lifted : e <= 0 -> C = 0.
  Proof. intros. rewrite (scaled_spring Hlaw). now apply Rmax_left. Qed.

  Lemma F_of_lifted : C = 0 -> F = 0.
  Proof.
    intros HC. pose proof (scaled_cone Hlaw) as H. rewrite HC in H.
    pose proof (Rle_abs F). pose proof (Rle_abs (- F)). rewrite Rabs_Ropp in *. lra.
  Qed.

  (** The force of one contact on the virtual motion, in units. *)
  Let work := A * C + F * B.

  Lemma work_unknown : (A - mu * Rabs B) * C <= work.
  Proof.
    assert (- (mu * C * Rabs B) <= F * B); [|unfold work; nra].
    pose proof (scaled_cone Hlaw). pose proof (Rabs_pos B).
    assert (Rabs (F * B) <= mu * C * Rabs B) by (rewrite Rabs_mult; nra).
    pose proof (Rle_abs (- (F * B))) as L. rewrite Rabs_Ropp in L. lra.
  Qed.

  Lemma work_plus : 0 < t -> (A - mu * B) * C <= work.
  Proof. intros Ht. unfold work. rewrite (scaled_plus Hlaw Ht). lra. Qed.

  Lemma work_minus : t < 0 -> (A + mu * B) * C <= work.
  Proof. intros Ht. unfold work. rewrite (scaled_minus Hlaw Ht). lra. Qed.

  Lemma kappa_works : IZR (kappa c s gens l) * C <= work.
  Proof.
    assert (IZR (unit_mu c * eval (normal c) l - slope c * Z.abs (eval (tangent c) l)) * C <= work)
      as U.
    { rewrite minus_IZR, !mult_IZR, abs_IZR. apply work_unknown. }
    assert (0 < t ->
      IZR (unit_mu c * eval (normal c) l - slope c * eval (tangent c) l) * C <= work) as P.
    { intros. rewrite minus_IZR, !mult_IZR. now apply work_plus. }
    assert (t < 0 ->
      IZR (unit_mu c * eval (normal c) l + slope c * eval (tangent c) l) * C <= work) as M.
    { intros. rewrite plus_IZR, !mult_IZR. now apply work_minus. }
    assert (IZR (if forallb (fun g => (0 <? eval (tangent c) g)%Z) gens
      then unit_mu c * eval (normal c) l - slope c * eval (tangent c) l
      else if forallb (fun g => (eval (tangent c) g <? 0)%Z) gens
      then unit_mu c * eval (normal c) l + slope c * eval (tangent c) l
      else unit_mu c * eval (normal c) l - slope c * Z.abs (eval (tangent c) l)) * C <= work).
    { destruct (forallb _ gens) eqn:E1; [|destruct (forallb _ gens) eqn:E2 in |- *; trivial].
      - apply P. destruct (form_pos (tangent c) Hx) as [?|?]; trivial; [|contradiction].
        intros g Hg. now apply Z.ltb_lt, (forall_gens _ E1).
      - apply M. destruct (form_neg (tangent c) Hx) as [?|?]; trivial; [|contradiction].
        intros g Hg. now apply Z.ltb_lt, (forall_gens _ E2). }
    unfold kappa. destruct s; cbn in Hs; trivial; tauto.
  Qed.

  Lemma nothing_works : C = 0 -> 0 <= work.
  Proof. intros HC. unfold work. rewrite (F_of_lifted HC), HC. lra. Qed.

  Lemma row_without_works :
    concave (row_without c s gens l) /\ row_value c (row_without c s gens l) x <= work.
  Proof.
    pose proof kappa_works as K. pose proof C_nonneg.
    unfold row_without. destruct s eqn:Es; cbn in Hs;
      try (cbn [concave row_value]; split; trivial;
        rewrite Rmult_0_l, Rplus_0_r; fold e; rewrite <- C_of_pressed by tauto; assumption).
    - destruct (forallb _ gens) eqn:E1.
      { cbn. split; trivial. apply nothing_works, C_of_lifted, (form_nonpos _ Hx).
        intros g Hg. now apply Z.leb_le, (forall_gens _ E1). }
      destruct (forallb (fun g => (0 <=? _)%Z) gens) eqn:E2.
      { cbn [concave row_value]. split; trivial. rewrite Rmult_0_l, Rplus_0_r. fold e.
        rewrite <- C_of_pressed; trivial. apply (form_nonneg _ Hx).
        intros g Hg. now apply Z.leb_le, (forall_gens _ E2). }
      destruct (0 <=? kappa c Undecided gens l)%Z eqn:E3; bools; cbn [concave row_value].
      + split; trivial. apply IZR_le in E3. nra.
      + split; [lia|]. fold e. now rewrite <- (scaled_spring Hlaw).
    - cbn. split; trivial. now apply nothing_works, C_of_lifted.
  Qed.

  Lemma row_with_works alpha h r :
    row_with c s gens l alpha h = Some r -> concave r /\ row_value c r x <= work.
  Proof.
    pose proof kappa_works as K. pose proof C_nonneg as HC.
    pose proof (scaled_spring Hlaw) as Spring.
    assert (e <= C) as He by (rewrite Spring; apply Rmax_r).
    unfold row_with.
    set (alpha' := (alpha * _)%Z). set (h' := (h * _)%Z).
    set (test := match s with Undecided => _ | _ => _ end).
    destruct test eqn:E; intros Some_r; inversion Some_r; clear Some_r.
    split; [exact I|]. cbn [row_value]. fold e t. subst test.
    destruct s eqn:Es; cbn in Hs; bools;
      repeat match goal with
      | H : (_ <= _)%Z |- _ => apply IZR_le in H
      | H : h' = 0%Z |- _ => rewrite H; clear H
      end;
      try (rewrite (C_of_pressed ltac:(tauto)) in *); nra || idtac.
    - pose proof (nothing_works (C_of_lifted Hs)). nra.
  Qed.
End Row.

