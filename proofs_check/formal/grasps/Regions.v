(** Regions of the space of motions as cones of finitely many generators. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Rationals Checker Vectors.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** The sum of multiples of the values of a form on generators. *)
Fixpoint combination (f : list R) (ts : list R) (gens : list (list Q)) : R :=
  match ts, gens with
  | t :: ts, g :: gens => t * dot f (reals g) + combination f ts gens
  | _, _ => 0
  end.

(** [x] is in the cone: each linear form on it is the sum of the same multiples. *)
Definition spans (gens : list (list Q)) (x : list R) : Prop :=
  exists ts, length ts = length gens /\ Forall (Rle 0) ts /\
    forall f, dot f x = combination f ts gens.

(** * Linear forms *)

Lemma form_nonneg f gens x : spans gens x ->
  (forall g, In g gens -> 0 <= dot f (reals g)) -> 0 <= dot f x.
Proof.
  intros (ts & _ & T & E) H. rewrite E. clear E. revert gens H.
  induction T as [|t ts Ht T IH]; intros [|g gens] H; cbn; try lra.
  pose proof (H g (or_introl eq_refl)).
  assert (0 <= combination f ts gens) by (apply IH; intros; apply H; now right). nra.
Qed.

Lemma dot_opposite f x : dot (times (-1) f) x = - dot f x.
Proof. rewrite dot_times. ring. Qed.

Lemma form_nonpos f gens x : spans gens x ->
  (forall g, In g gens -> dot f (reals g) <= 0) -> dot f x <= 0.
Proof.
  intros S H. assert (0 <= dot (times (-1) f) x) as P.
  { apply (form_nonneg _ S). intros g I. rewrite dot_opposite. specialize (H g I). lra. }
  rewrite dot_opposite in P. lra.
Qed.

(** Forms that are positive on all generators are positive but at 0. *)
Lemma form_pos f gens x : spans gens x -> dot [1] x <> 0 ->
  (forall g, In g gens -> 0 < dot f (reals g)) -> 0 < dot f x.
Proof.
  intros (ts & _ & T & E) N H. rewrite E in *. clear E.
  enough (0 < combination f ts gens \/ (0 <= combination f ts gens /\ combination [1] ts gens = 0))
    by tauto. clear N. revert gens H.
  induction T as [|t ts Ht T IH]; intros [|g gens] H; cbn [combination]; try (right; lra).
  pose proof (H g (or_introl eq_refl)).
  destruct (IH gens) as [P|[P Z]]; [intros; apply H; now right | left; nra |].
  destruct (Rle_lt_or_eq_dec 0 t Ht) as [Lt | <-]; [left; nra | right]. rewrite Z. lra.
Qed.

Lemma form_neg f gens x : spans gens x -> dot [1] x <> 0 ->
  (forall g, In g gens -> dot f (reals g) < 0) -> dot f x < 0.
Proof.
  intros S N H. assert (0 < dot (times (-1) f) x) as P.
  { apply (form_pos _ S N). intros g I. rewrite dot_opposite. specialize (H g I). lra. }
  rewrite dot_opposite in P. lra.
Qed.

(** * All motions *)

Lemma dot_axis : forall before y f, dot f (reals (repeat 0%Q before ++ [y])) = nth before f 0 * Q2R y.
Proof.
  induction before as [|before IH]; intros y [|x f]; cbn; rewrite ?dot_nil; try ring.
  unfold reals in IH. rewrite IH, zero_real. ring.
Qed.

Lemma dot_skipn f y d before :
  dot (skipn before f) (y :: d) = nth before f 0 * y + dot (skipn (S before) f) d.
Proof.
  revert f. induction before as [|before IH]; intros [|x f]; cbn [skipn nth dot]; try ring.
  rewrite IH. now destruct f.
Qed.

Lemma half_space_all d : spans (half_space (length d)) (1 :: d).
Proof.
  assert (forall d before, exists ts, length ts = length (axes before (length d)) /\
    Forall (Rle 0) ts /\
    forall f, dot (skipn before f) d = combination f ts (axes before (length d))) as Axes.
  { induction d0 as [|y d0 IH]; intros before.
    - exists []. repeat split; [constructor|]. intros f. cbn. apply dot_nil.
    - destruct (IH (S before)) as (ts & L & T & E).
      exists (Rmax 0 y :: Rmax 0 (- y) :: ts). cbn [length axes]. repeat split; [lia| |].
      + constructor; [apply Rmax_l | constructor; [apply Rmax_l | trivial]].
      + intros f. cbn [combination]. rewrite <- E, dot_skipn, !dot_axis.
        replace (Q2R 1) with 1 by (unfold Q2R; cbn; field).
        replace (Q2R (-1)) with (-1) by (unfold Q2R; cbn; field).
        replace (nth before f 0 * y) with (nth before f 0 * (Rmax 0 y - Rmax 0 (- y))); [ring|].
        f_equal. unfold Rmax. destruct (Rle_dec 0 y), (Rle_dec 0 (- y)); lra. }
  destruct (Axes d 1%nat) as (ts & L & T & E). exists (1 :: ts). cbn [length half_space].
  repeat split; [lia | constructor; [lra | trivial] |].
  intros f. unfold half_space. cbn [combination]. rewrite <- E. destruct f as [|x f]; cbn.
  - ring.
  - replace (Q2R 1) with 1 by (unfold Q2R; cbn; field). rewrite dot_nil. ring.
Qed.

(** * The parts of an edge *)

Lemma combination_replaced f t : forall ts gens j new s g,
  nth_error ts j = Some s -> nth_error gens j = Some g ->
  combination f (replaced j (map (fun _ => t) new) ts) (replaced j new gens) =
  combination f ts gens - s * dot f (reals g) +
    fold_right (fun v sum => t * dot f (reals v) + sum) 0 new.
Proof.
  assert (forall new ts gens, combination f (map (fun _ => t) new ++ ts) (new ++ gens) =
    fold_right (fun v sum => t * dot f (reals v) + sum) 0 new + combination f ts gens) as App.
  { intros new ts gens. induction new as [|v new IH]; cbn; [ring|]. rewrite IH. ring. }
  induction ts as [|x ts IH]; intros [|h gens] [|j] new s g E F; try easy; cbn in E, F;
    cbn [replaced combination].
  - injection E as ->. injection F as ->. rewrite App. ring.
  - rewrite (IH _ _ _ _ _ E F). ring.
Qed.

Lemma replaced_length A B : forall (ts : list A) (gens : list B) j new new',
  length ts = length gens -> length new = length new' ->
  length (replaced j new ts) = length (replaced j new' gens).
Proof.
  induction ts as [|t ts IH]; intros [|g gens] [|j] new new' L N; try easy; cbn in *.
  - rewrite !app_length. lia.
  - f_equal. apply IH; lia.
Qed.

Lemma replaced_all A (P : A -> Prop) : forall l j new,
  Forall P l -> Forall P new -> Forall P (replaced j new l).
Proof.
  induction l as [|x l IH]; intros [|j] new H N; cbn; trivial; inversion H; subst.
  - now apply Forall_app.
  - constructor; auto.
Qed.

Lemma nth_replaced A : forall (l : list A) j k x y, j <> k -> nth_error l k = Some y ->
  nth_error (replaced j [x] l) k = Some y.
Proof.
  induction l as [|z l IH]; intros [|j] [|k] x y N E; try easy; cbn in *. apply IH; trivial. lia.
Qed.

(** A multiple of g_j is exchanged for the new point, and less of g_k. *)
Lemma part_spans gens x ts j k g h new P Q s t c :
  length ts = length gens -> Forall (Rle 0) ts -> (forall f, dot f x = combination f ts gens) ->
  j <> k -> nth_error gens j = Some g -> nth_error gens k = Some h ->
  nth_error ts j = Some s -> nth_error ts k = Some t ->
  0 < P -> 0 <= s * Q -> s * Q <= t * P -> 0 < c ->
  (forall f, P * dot f (reals g) + Q * dot f (reals h) =
    c * fold_right (fun v sum => dot f (reals v) + sum) 0 new) ->
  spans (replaced j new gens) x.
Proof.
  intros L T E N G H S U HP SQ Le C V.
  assert (0 <= s) as S0 by (rewrite Forall_forall in T; apply T; eapply nth_error_In; eassumption).
  assert (s / P * Q <= t) as Rest.
  { apply Rmult_le_reg_r with P; trivial. replace (s / P * Q * P) with (s * Q) by (field; lra). lra. }
  assert (0 <= s / P) as SP by (apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]).
  set (less := replaced k [t - s / P * Q] ts).
  exists (replaced j (map (fun _ => s / P * c) new) less). split; [|split].
  - apply replaced_length; [|now rewrite map_length]. unfold less. rewrite <- L.
    clear - U. revert k U. induction ts as [|y ts IH]; intros [|k] U; try easy. cbn in *.
    f_equal. now apply IH.
  - apply replaced_all.
    + apply replaced_all; trivial. constructor; [lra | constructor].
    + apply Forall_map, Forall_forall. intros. apply Rmult_le_pos; lra.
  - intros f. assert (combination f less gens = combination f ts gens - s / P * Q * dot f (reals h))
      as Less.
    { pose proof (@combination_replaced f (t - s / P * Q) ts gens k [h] t h U H) as R.
      cbn [map fold_right] in R. fold less in R.
      replace (replaced k [h] gens) with gens in R; [rewrite R; ring|].
      clear - H. revert k H. induction gens as [|y gens IH]; intros [|k] H; try easy; cbn in *.
      - now injection H as ->.
      - f_equal. now apply IH. }
    assert (nth_error less j = Some s) as S' by (apply nth_replaced; auto).
    rewrite (@combination_replaced f (s / P * c) less gens j new s g S' G), Less, <- E.
    assert (fold_right (fun v sum => s / P * c * dot f (reals v) + sum) 0 new =
      s / P * (c * fold_right (fun v sum => dot f (reals v) + sum) 0 new)) as ->.
    { clear. induction new as [|v new IH]; cbn; [|rewrite IH]; ring. }
    rewrite <- V. field. lra.
Qed.

(** A positive multiple of the primitive vector is the vector. *)
Lemma primitive_multiple v :
  exists c, 0 < c /\ forall f, dot f (reals v) = c * dot f (reals (primitive v)).
Proof.
  unfold primitive. set (d := fold_right _ _ _).
  destruct (0 <? d)%Z eqn:E; [|exists 1; split; [lra | intros; ring]].
  apply Z.ltb_lt in E. exists (IZR d). split; [now apply IZR_lt|].
  assert (forall q, In q v -> (d | Qnum q)%Z) as D.
  { subst d. clear E. induction v as [|x v IH]; cbn; [easy|]. intros q [->|I].
    - apply Z.gcd_divide_l.
    - eapply Z.divide_trans; [apply Z.gcd_divide_r | auto]. }
  clearbody d. induction v as [|x v IH]; intros [|y f]; cbn; try ring.
  unfold reals in IH. rewrite IH by (intros; apply D; now right).
  destruct (D x (or_introl eq_refl)) as [m M].
  replace (Q2R x) with (IZR d * Q2R (Qnum x / d # Qden x)); [ring|].
  unfold Q2R. cbn [Qnum Qden]. rewrite M, Z.div_mul by lia. rewrite mult_IZR. ring.
Qed.

Lemma edge_covers gens x j k p q g h :
  let v := primitive (qadd (qscaled p g) (qscaled q h)) in
  let new := if qvanishes v then [] else [v] in
  nth_error gens j = Some g -> nth_error gens k = Some h -> j <> k ->
  qpositive p = true -> qpositive q = true -> spans gens x ->
  spans (replaced j new gens) x \/ spans (replaced k new gens) x.
Proof.
  intros v new G H N HP HQ (ts & L & T & E). apply qpositive_real in HP, HQ.
  destruct (primitive_multiple (qadd (qscaled p g) (qscaled q h))) as (c & C & M). fold v in M.
  assert (forall f, Q2R p * dot f (reals g) + Q2R q * dot f (reals h) =
    c * fold_right (fun v sum => dot f (reals v) + sum) 0 new) as V.
  { intros f. transitivity (dot f (reals (qadd (qscaled p g) (qscaled q h)))).
    - rewrite qadd_real, !qscaled_real, (dot_comm f (add _ _)), dot_add, !dot_times.
      now rewrite (dot_comm (reals g)), (dot_comm (reals h)).
    - rewrite M. f_equal. unfold new. destruct (qvanishes v) eqn:Z; cbn [fold_right]; [|ring].
      rewrite dot_comm. apply dot_vanishing. now apply qvanishes_real. }
  assert (forall i y, nth_error gens i = Some y -> exists s, nth_error ts i = Some s /\ 0 <= s)
    as Has.
  { intros i y I. destruct (nth_error ts i) as [s|] eqn:F.
    - exists s. split; trivial. rewrite Forall_forall in T. apply T. eapply nth_error_In, F.
    - apply nth_error_None in F. assert (i < length gens)%nat; [|lia].
      apply nth_error_Some. congruence. }
  destruct (Has _ _ G) as (s & S & S0). destruct (Has _ _ H) as (t & U & U0).
  destruct (Rle_lt_dec (s * Q2R q) (t * Q2R p)) as [Le|Le]; [left | right].
  - apply (@part_spans gens x ts j k g h new (Q2R p) (Q2R q) s t c); trivial. nra.
  - apply (@part_spans gens x ts k j h g new (Q2R q) (Q2R p) t s c); trivial; auto; try nra.
    intros f. rewrite <- V. ring.
Qed.
