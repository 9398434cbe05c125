(** A leaf that holds leaves no equilibrium in its region and states. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Checker Numbers Rows.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Sums over the contacts *)

Definition vector_of (l : quad Z) : vector R := Vector (IZR (q1 l)) (IZR (q2 l)) (IZR (q3 l)).

Record weighted (D : R) (c : integer_contact) (r : contact R) : Prop := {
  is_faithful : faithful c r;
  weight_pos : 0 < IZR (weight c);
  weight_units : IZR (weight c) * IZR (units c) = D
}.

Lemma normal_value c r l :
  faithful c r -> IZR (eval (normal c) l) = IZR (unit_n c) * dot (N r) (vector_of l).
Proof.
  intros H. unfold eval, dot, vector_of; cbn [along_x along_y turn]. rewrite (normal_0 H). reals.
  rewrite (normal_1 H), (normal_2 H), (normal_3 H). ring.
Qed.

Lemma tangent_at c r l :
  faithful c r -> IZR (eval (tangent c) l) = IZR (unit_n c) * dot (T r) (vector_of l).
Proof.
  intros H. unfold eval, dot, vector_of; cbn [along_x along_y turn]. rewrite (tangent_0 H). reals.
  rewrite (tangent_1 H), (tangent_2 H), (tangent_3 H). ring.
Qed.

(** The states of the contacts under a motion. *)
Definition in_state (d : vector R) (r : contact R) (s : state) : Prop :=
  holds s (preload r - stiffness r * dot (N r) d) (dot (T r) d).

Lemma in_state_scaled d c r s :
  faithful c r -> in_state d r s ->
  holds s (evalR (spring c) (motion d)) (evalR (tangent c) (motion d)).
Proof.
  intros Hc. rewrite (spring_value d Hc), (tangent_value d Hc). unfold in_state.
  pose proof (unit_e_pos Hc). pose proof (unit_n_pos Hc).
  destruct s; cbn; trivial; intros; try split; nra.
Qed.

Fixpoint rows_value (cs : list integer_contact) (rs : list row) (x : quad R) : R :=
  match cs, rs with
  | c :: cs, r :: rs => IZR (weight c) * row_value c r x + rows_value cs rs x
  | _, _ => 0
  end.

Lemma rows_work D d gens u l multipliers :
  spans gens (motion d) ->
  forall cs reals, Forall2 (weighted D) cs reals ->
  forall forces, Forall2 (law d) reals forces ->
  forall i states rs, Forall2 (in_state d) reals states ->
  rows i cs states gens u l multipliers = Some rs ->
  Forall concave rs /\ rows_value cs rs (motion d) <= D * dot (total reals forces) (vector_of l).
Proof.
  intros Hx. induction 1 as [|c r cs reals Hc Hcs IH].
  - intros forces Hf i states rs Hs. inversion Hs; subst. cbn. intros [= <-].
    split; [constructor|]. destruct forces; unfold dot, zero; cbn; lra.
  - intros forces Hf i states rs Hs.
    inversion Hf as [|? [c_n c_t] ? forces' Law Hf']; subst.
    inversion Hs as [|? s ? states' State Hs']; subst.
    cbn [rows]. intros H.
    pose proof (is_faithful Hc) as Fc. pose proof (law_scaled Fc Law) as Scaled.
    apply (in_state_scaled d s Fc) in State.
    destruct (match given i multipliers with Some (_, _) => _ | None => _ end) as [row|] eqn:Er;
      [|discriminate].
    destruct (rows (i + 1) cs states' gens u l multipliers) as [rest|] eqn:Erest; [|discriminate].
    injection H as <-.
    destruct (IH _ Hf' _ _ _ Hs' Erest) as [Hrest Vrest].
    assert (q0 (motion d) <> 0) as Hx0 by (cbn; lra).
    assert (concave row /\ row_value c row (motion d) <=
      IZR (unit_mu c) * IZR (eval (normal c) l) * (IZR (unit_e c) * c_n) +
      IZR (unit_mu c) * IZR (unit_e c) * c_t * IZR (eval (tangent c) l)) as [Hrow Vrow].
    { destruct (given i multipliers) as [[alpha h]|].
      - eapply row_with_works; eassumption.
      - injection Er as <-. eapply row_without_works; eassumption. }
    split; [now constructor|].
    cbn [rows_value total].
    assert (IZR (weight c) * row_value c row (motion d) <=
      D * (c_n * dot (N r) (vector_of l) + c_t * dot (T r) (vector_of l))).
    { rewrite (normal_value l Fc), (tangent_at l Fc) in Vrow.
      rewrite <- (weight_units Hc). unfold units. rewrite !mult_IZR.
      apply Rmult_le_compat_l with (r := IZR (weight c)) in Vrow;
        [|apply Rlt_le, (weight_pos Hc)].
      eapply Rle_trans; [exact Vrow|]. apply Req_le. ring. }
    replace (D * dot (add _ _) _) with
      (D * (c_n * dot (N r) (vector_of l) + c_t * dot (T r) (vector_of l))
       + D * dot (total reals forces') (vector_of l))
      by (unfold dot, add, times; cbn [along_x along_y turn]; ring).
    lra.
Qed.

Lemma rows_at_cons c cs r rs g :
  rows_at (c :: cs) (r :: rs) g = (weight c * row_at c r g + rows_at cs rs g)%Z.
Proof. destruct r; cbn [rows_at row_at]; ring. Qed.

Lemma rows_superadditive D cs reals rs t g x :
  Forall2 (weighted D) cs reals -> Forall concave rs -> 0 <= t ->
  t * IZR (rows_at cs rs g) + rows_value cs rs x <= rows_value cs rs (shift t g x).
Proof.
  intros Hc Hr Ht. revert rs Hr.
  induction Hc as [|c r cs reals Hc Hcs IH]; intros rs Hr; [destruct rs; cbn; lra|].
  destruct Hr as [|row rs Hrow Hrs]; [cbn; lra|].
  rewrite rows_at_cons, plus_IZR, mult_IZR. cbn [rows_value].
  specialize (IH _ Hrs). pose proof (row_superadditive c row g x Hrow Ht).
  pose proof (weight_pos Hc). nra.
Qed.

Lemma rows_value_zero cs rs : rows_value cs rs (Quad 0 0 0 0) = 0.
Proof.
  revert rs. induction cs as [|c cs IH]; intros [|r rs]; trivial.
  cbn [rows_value]. rewrite IH.
  assert (row_value c r (Quad 0 0 0 0) = 0) as ->; [|ring].
  destruct r; cbn [row_value]; trivial; unfold evalR; cbn [q0 q1 q2 q3].
  - ring.
  - rewrite !Rmult_0_r, !Rplus_0_r, Rmax_left; lra.
Qed.

(** * Integer questions *)

Lemma units_pos c r : faithful c r -> (0 < units c)%Z.
Proof.
  intros H. apply lt_IZR. unfold units. rewrite !mult_IZR.
  pose proof (unit_n_pos H). pose proof (unit_e_pos H). pose proof (unit_mu_pos H).
  repeat apply Rmult_lt_0_compat; trivial.
Qed.

Definition denominator (g : question Q) : Z :=
  fold_right (fun c d => Z.lcm (units c) d) (common (entries (applied g)))
    (map integers (contacts g)).

Lemma units_divide u cs :
  (0 < u)%Z -> Forall (fun c => 0 < units c)%Z cs ->
  let D := fold_right (fun c d => Z.lcm (units c) d) u cs in
  (0 < D)%Z /\ (u | D)%Z /\ Forall (fun c => (units c | D)%Z) cs.
Proof.
  intros Hu. induction 1 as [|c cs Hc Hcs IH]; cbn; [split; [lia | split; [reflexivity | easy]]|].
  destruct IH as (Pos & U & IH). split; [|split].
  - set (D := fold_right _ _ _) in *. pose proof (Z.lcm_nonneg (units c) D).
    assert (Z.lcm (units c) D <> 0)%Z by (rewrite Z.lcm_eq_0; lia). lia.
  - eapply Z.divide_trans; [exact U | apply Z.divide_lcm_r].
  - constructor; [apply Z.divide_lcm_l|].
    eapply Forall_impl; [|exact IH]. intros c' H.
    eapply Z.divide_trans; [exact H | apply Z.divide_lcm_r].
Qed.

Lemma all_units_pos g : Forall (fun c => 0 < units c)%Z (map integers (contacts g)).
Proof.
  apply Forall_map, Forall_forall. intros c _. eapply units_pos, integers_faithful.
Qed.

Lemma weighted_faithful D c r :
  (0 < D)%Z -> (units c | D)%Z -> faithful c r -> weighted (IZR D) (with_weight D c) r.
Proof.
  intros HD [k ->] Hc. pose proof (units_pos Hc).
  split.
  - destruct Hc. constructor; assumption.
  - cbn -[IZR]. rewrite Z.div_mul by lia. apply IZR_lt. nia.
  - cbn -[IZR units]. rewrite Z.div_mul by lia. now rewrite <- mult_IZR.
Qed.

Lemma bodies_weighted g :
  Forall2 (weighted (IZR (denominator g))) (bodies (integer_form g)) (contacts (real_question g)).
Proof.
  destruct (units_divide (common_pos (entries (applied g))) (all_units_pos g)) as (Pos & _ & Div).
  cbn [bodies integer_form contacts real_question]. fold (denominator g) in *.
  revert Pos Div. generalize (denominator g). intros D Pos.
  induction (contacts g) as [|c cs IH]; cbn [map]; intros Div; constructor;
    inversion Div; subst; auto.
  apply weighted_faithful; trivial. apply integers_faithful.
Qed.

Lemma load_value g l :
  IZR (load_weight (integer_form g) * eval (load (integer_form g)) l) =
  IZR (denominator g) * dot (applied (real_question g)) (vector_of l).
Proof.
  cbn [load_weight load integer_form]. fold (denominator g).
  destruct (units_divide (common_pos (entries (applied g))) (all_units_pos g)) as (_ & Div & _).
  fold (denominator g) in Div. pose proof (common_pos (entries (applied g))) as Pos.
  set (u := common _) in *. destruct Div as [k ->]. rewrite Z.div_mul by lia.
  unfold eval, dot, clear_vector, real_question, real_vector, vector_of.
  cbn [q0 q1 q2 q3 along_x along_y turn applied]. reals.
  unfold u. rewrite !clear_common by (cbn; auto). ring.
Qed.

(** * Leaves *)

Section Leaf.
  Variables (g : question Q) (gens : list (quad Z)) (states : list state).
  Variables (d : vector R) (forces : list (R * R)).
  Hypothesis Hx : spans gens (motion d).
  Hypothesis Hstates : Forall2 (in_state d) (contacts (real_question g)) states.

  Lemma sum_positive cs reals D work rs gens' x :
    Forall2 (weighted D) cs reals -> Forall concave rs -> spans gens' x ->
    forallb
      (fun v =>
         let sum := (work * q0 v + rows_at cs rs v)%Z in
         if (0 <? q0 v)%Z then (0 <? sum)%Z else (0 <=? sum)%Z)
      gens' = true ->
    0 <= IZR work * q0 x + rows_value cs rs x /\
    (0 < q0 x -> 0 < IZR work * q0 x + rows_value cs rs x).
  Proof.
    intros Hc Hr. induction 1 as [|t v gens' x Ht Hx' IH]; cbn [forallb]; intros H.
    - rewrite rows_value_zero. cbn. lra.
    - apply andb_prop in H as [Test Rest]. destruct (IH Rest) as [Nonneg Pos].
      pose proof (rows_superadditive v x Hc Hr Ht) as Super.
      cbv zeta in Test. cbn [shift q0].
      assert (0 <= IZR (work * q0 v + rows_at cs rs v)) as S0.
      { apply IZR_le. destruct (0 <? q0 v)%Z; bools; lia. }
      assert (0 < IZR (q0 v) -> 0 < IZR (work * q0 v + rows_at cs rs v)) as S1.
      { intros V. apply lt_IZR in V. destruct (0 <? q0 v)%Z eqn:E; bools; [|lia].
        now apply IZR_lt. }
      rewrite plus_IZR, mult_IZR in S0, S1. split; [nra|]. intros P.
      destruct (Rlt_le_dec 0 (q0 x)) as [X|X]; [specialize (Pos X); nra|].
      assert (0 < t * IZR (q0 v)) as TV by lra.
      destruct Ht as [Ht | <-]; [|lra].
      assert (0 < IZR (q0 v)) as V by (apply Rmult_lt_reg_l with t; lra).
      specialize (S1 V). nra.
  Qed.

  Lemma leaf_sound l multipliers :
    leaf_holds (integer_form g) gens states l multipliers = true ->
    ~ equilibrium (real_question g) d forces.
  Proof.
    unfold leaf_holds. intros H [Law Balance].
    set (u := common _) in H. set (v := clear_vector u 0 l) in H.
    destruct (rows _ _ _ _ _ _ _) as [rs|] eqn:E; [|discriminate].
    destruct (@rows_work _ _ _ _ _ _ Hx _ _ (bodies_weighted g) _ Law _ _ _ Hstates E)
      as [Concave Work].
    destruct (sum_positive _ (bodies_weighted g) Concave Hx H) as [_ P].
    assert (0 < q0 (motion d)) as One by (cbn; lra). specialize (P One).
    rewrite load_value in P. cbn [q0 motion] in P.
    assert (IZR (denominator g) * dot (add (total (contacts (real_question g)) forces)
      (applied (real_question g))) (vector_of v) = 0) as Z.
    { rewrite Balance. unfold dot, zero; cbn. ring. }
    unfold dot, add in *. cbn [along_x along_y turn] in *. nra.
  Qed.
End Leaf.

