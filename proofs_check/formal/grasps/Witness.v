(** A motion and forces are confirmed exactly when they are an equilibrium. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Checker Numbers Rows Leaves.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Lemma Rcancel u a b : u <> 0 -> u * a = u * b <-> a = b.
Proof. intros Hu. split; [intros H; now apply Rmult_eq_reg_l with u | now intros ->]. Qed.

Lemma Rcancel_le u a b : 0 < u -> u * a <= u * b <-> a <= b.
Proof. intros Hu. split; intros; nra. Qed.

Lemma eqb_real a b : (a =? b)%Z = true <-> IZR a = IZR b.
Proof. rewrite Z.eqb_eq. split; [now intros -> | apply eq_IZR]. Qed.

Lemma leb_real a b : (a <=? b)%Z = true <-> IZR a <= IZR b.
Proof. rewrite Z.leb_le. split; [apply IZR_le | apply le_IZR]. Qed.

Lemma ltb_real a b : (a <? b)%Z = true <-> IZR a < IZR b.
Proof. rewrite Z.ltb_lt. split; [apply IZR_lt | apply lt_IZR]. Qed.

Lemma if_true (a b : bool) : (if a then b else true) = true <-> (a = true -> b = true).
Proof. destruct a; intuition discriminate. Qed.

Definition unit_x := Quad 0%Z 1%Z 0%Z 0%Z.
Definition unit_y := Quad 0%Z 0%Z 1%Z 0%Z.
Definition unit_r := Quad 0%Z 0%Z 0%Z 1%Z.

Section One_contact.
  Variables (c : integer_contact) (r : contact R) (motion : vector Q).
  Hypothesis Hc : faithful c r.
  Let D := common (entries motion).
  Let x := clear_vector D D motion.
  Let d := real_vector motion.

  Lemma D_pos : 0 < IZR D.
  Proof. apply IZR_lt, common_pos. Qed.

  Lemma motion_value f : IZR (eval f x) = IZR D * evalR f (Rows.motion d).
  Proof.
    unfold eval, evalR, x, clear_vector, Rows.motion, d, real_vector.
    cbn [q0 q1 q2 q3 along_x along_y turn]. reals.
    unfold D. rewrite !clear_common by (cbn; auto). ring.
  Qed.

  Lemma obeys_law u n t c_n c_t :
    (0 < u)%Z -> IZR n = IZR u * c_n -> IZR t = IZR u * c_t ->
    obeys c x u n t = true <-> law d r (c_n, c_t).
  Proof.
    intros Hu Hn Ht. apply IZR_lt in Hu. pose proof D_pos.
    pose proof (unit_n_pos Hc). pose proof (unit_e_pos Hc). pose proof (unit_mu_pos Hc).
    assert (0 < IZR u * IZR (unit_e c) * IZR D) as U1 by (repeat apply Rmult_lt_0_compat; trivial).
    assert (0 < IZR u * IZR (unit_mu c)) as U2 by (now apply Rmult_lt_0_compat).
    assert (IZR (eval (tangent c) x) = IZR D * IZR (unit_n c) * dot (T r) d) as Slip.
    { rewrite motion_value, (tangent_value d Hc). ring. }
    assert (IZR (unit_mu c * t) = IZR u * IZR (unit_mu c) * c_t) as Force.
    { rewrite mult_IZR, Ht. ring. }
    assert (IZR (slope c * n) = IZR u * IZR (unit_mu c) * (friction r * c_n)) as Limit.
    { rewrite mult_IZR, Hn, (slope_mu Hc). ring. }
    assert (0 < IZR D * IZR (unit_n c)) as Un by now apply Rmult_lt_0_compat.
    assert ((n * unit_e c * q0 x =? u * Z.max 0 (eval (spring c) x))%Z = true <->
      c_n = Rmax 0 (preload r - stiffness r * dot (N r) d)) as Spring.
    { rewrite eqb_real, !mult_IZR, Rmax_IZR, Hn, motion_value, (spring_value d Hc).
      rewrite <- !Rmax_scale by trivial. cbn [q0 x clear_vector].
      rewrite <- (Rcancel c_n _ (Rgt_not_eq _ _ U1)). split; intros; lra. }
    assert ((Z.abs (unit_mu c * t) <=? slope c * n)%Z = true <->
      Rabs c_t <= friction r * c_n) as Cone.
    { rewrite leb_real, abs_IZR, Force, Limit, Rabs_mult, (Rabs_right (_ * _)) by lra.
      now apply Rcancel_le. }
    assert ((unit_mu c * t =? - (slope c * n))%Z = true <-> c_t = - friction r * c_n) as Plus.
    { rewrite eqb_real, opp_IZR, Force, Limit.
      rewrite <- (Rcancel c_t _ (Rgt_not_eq _ _ U2)). split; intros ->; ring. }
    assert ((unit_mu c * t =? slope c * n)%Z = true <-> c_t = friction r * c_n) as Minus.
    { rewrite eqb_real, Force, Limit. apply Rcancel. lra. }
    assert ((0 <? eval (tangent c) x)%Z = true <-> dot (T r) d > 0) as Forward.
    { rewrite ltb_real, Slip. split; intros; nra. }
    assert ((eval (tangent c) x <? 0)%Z = true <-> dot (T r) d < 0) as Backward.
    { rewrite ltb_real, Slip. split; intros; nra. }
    unfold obeys, law. rewrite !andb_true_iff, !if_true. tauto.
  Qed.
End One_contact.

(** * Balance *)

Lemma total_value D u cs reals forces :
  Forall2 (weighted (IZR D)) cs reals ->
  (forall f, In f forces -> IZR (clear u (fst f)) = IZR u * Q2R (fst f) /\
                            IZR (clear u (snd f)) = IZR u * Q2R (snd f)) ->
  vector_of (integer_total cs u forces) = times (IZR D * IZR u) (total reals (real_forces forces)).
Proof.
  intros Hc. revert forces.
  induction Hc as [|c r cs reals Hc Hcs IH]; intros [|[n t] forces] Hf;
    try (unfold vector_of, times, zero; cbn; f_equal; ring).
  destruct (Hf (n, t)) as [Hn Ht]; [now left|]. cbn [fst snd] in Hn, Ht.
  assert (forall f, In f forces -> IZR (clear u (fst f)) = IZR u * Q2R (fst f) /\
    IZR (clear u (snd f)) = IZR u * Q2R (snd f)) as Hf' by (intros; apply Hf; now right).
  specialize (IH forces Hf'). unfold vector_of, times in IH. injection IH as I1 I2 I3.
  cbn [integer_total total real_forces map fst snd].
  fold (real_forces forces). unfold vector_of, combine, add, times.
  cbn [q1 q2 q3 along_x along_y turn]. reals. rewrite Hn, Ht, I1, I2, I3.
  rewrite <- (weight_units Hc). unfold units. reals. pose proof (is_faithful Hc) as Fc.
  rewrite (normal_1 Fc), (normal_2 Fc), (normal_3 Fc).
  rewrite (tangent_1 Fc), (tangent_2 Fc), (tangent_3 Fc). f_equal; ring.
Qed.

Lemma all_obey_law D g motion u forces :
  D = common (entries motion) -> (0 < u)%Z ->
  (forall f, In f forces -> IZR (clear u (fst f)) = IZR u * Q2R (fst f) /\
                            IZR (clear u (snd f)) = IZR u * Q2R (snd f)) ->
  forall cs reals, Forall2 (weighted g) cs reals ->
  all_obey cs (clear_vector D D motion) u forces = true <->
  Forall2 (law (real_vector motion)) reals (real_forces forces).
Proof.
  intros -> Hu Hf cs reals Hc. revert forces Hf.
  induction Hc as [|c r cs reals Hc Hcs IH]; intros [|[n t] forces] Hf; cbn [all_obey real_forces map].
  1: split; [constructor | trivial].
  1, 2: split; [discriminate | intros H; inversion H].
  destruct (Hf (n, t)) as [Hn Ht]; [now left|].
  rewrite andb_true_iff, (@obeys_law _ _ motion (is_faithful Hc) _ _ _ _ _ Hu Hn Ht), IH
    by (intros; apply Hf; now right).
  split; [intros []; now constructor | intros H; inversion H; now split].
Qed.

Theorem confirms_equilibrium g motion forces :
  confirms (integer_form g) motion forces = true <->
  equilibrium (real_question g) (real_vector motion) (real_forces forces).
Proof.
  unfold confirms, equilibrium.
  set (u := common (flat_map _ forces)).
  assert (0 < u)%Z as Hu by apply common_pos.
  assert (forall f, In f forces -> IZR (clear u (fst f)) = IZR u * Q2R (fst f) /\
                                   IZR (clear u (snd f)) = IZR u * Q2R (snd f)) as Hf.
  { intros f H. split; apply clear_common, in_flat_map; exists f; cbn; auto. }
  rewrite !andb_true_iff, (@all_obey_law _ _ _ _ _ eq_refl Hu Hf _ _ (bodies_weighted g)).
  pose proof (@total_value _ _ _ _ _ (bodies_weighted g) Hf) as Sum.
  pose proof (f_equal (@along_x R) Sum) as S1. pose proof (f_equal (@along_y R) Sum) as S2.
  pose proof (f_equal (@turn R) Sum) as S3. unfold vector_of, times in S1, S2, S3.
  cbn [along_x along_y turn] in S1, S2, S3. clear Sum.
  destruct (units_divide (common_pos (entries (applied g))) (all_units_pos g)) as (Pos & _ & _).
  fold (denominator g) in Pos.
  assert (0 < IZR (denominator g) * IZR u) as Scale by (apply Rmult_lt_0_compat; now apply IZR_lt).
  set (asked := integer_form g) in *.
  assert (IZR (load_weight asked * q1 (load asked)) =
    IZR (denominator g) * along_x (applied (real_question g))) as L1.
  { pose proof (load_value g unit_x) as L. unfold eval, dot, vector_of, unit_x in L.
    cbn [q0 q1 q2 q3 along_x along_y turn] in L. fold asked in L. revert L. reals. lra. }
  assert (IZR (load_weight asked * q2 (load asked)) =
    IZR (denominator g) * along_y (applied (real_question g))) as L2.
  { pose proof (load_value g unit_y) as L. unfold eval, dot, vector_of, unit_y in L.
    cbn [q0 q1 q2 q3 along_x along_y turn] in L. fold asked in L. revert L. reals. lra. }
  assert (IZR (load_weight asked * q3 (load asked)) =
    IZR (denominator g) * turn (applied (real_question g))) as L3.
  { pose proof (load_value g unit_r) as L. unfold eval, dot, vector_of, unit_r in L.
    cbn [q0 q1 q2 q3 along_x along_y turn] in L. fold asked in L. revert L. reals. lra. }
  set (whole := total _ _) in *. set (w := applied (real_question g)) in *.
  assert (forall a b (x y : R), IZR a = IZR (denominator g) * IZR u * x ->
    IZR b = IZR (denominator g) * y -> (1 * a + u * b =? 0)%Z = true <-> x + y = 0) as Entry.
  { intros a b x y Ha Hb. rewrite eqb_real. reals. rewrite Ha, Hb.
    rewrite <- (Rcancel (x + y) 0 (Rgt_not_eq _ _ Scale)). split; intros E.
    - etransitivity; [|etransitivity; [exact E|]]; ring.
    - etransitivity; [|etransitivity; [exact E|]]; ring. }
  unfold combine; cbn [q1 q2 q3].
  rewrite <- !Z.mul_assoc.
  rewrite (Entry _ _ _ _ S1 L1), (Entry _ _ _ _ S2 L2), (Entry _ _ _ _ S3 L3).
  unfold add, zero. split.
  - intros [[[Law X] Y] R]. split; trivial. now rewrite X, Y, R.
  - intros [Law B]. injection B as X Y R. tauto.
Qed.
