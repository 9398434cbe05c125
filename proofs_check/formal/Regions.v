(** The children of a region cover it. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Checker Numbers.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Regions *)

Definition inside (r : region) (x : quad R) : Prop :=
  match r with HalfSpace => 0 <= q0 x | Cone _ _ _ _ => spans (generators r) x end.

Lemma shift_eq t g x y :
  t * IZR (q0 g) + q0 x = q0 y -> t * IZR (q1 g) + q1 x = q1 y ->
  t * IZR (q2 g) + q2 x = q2 y -> t * IZR (q3 g) + q3 x = q3 y -> shift t g x = y.
Proof. unfold shift. intros -> -> -> ->. now destruct y. Qed.

Lemma spans_shift t g gens x y :
  0 <= t -> spans gens y -> shift t g y = x -> spans (g :: gens) x.
Proof. intros Ht H <-. now constructor. Qed.

(** The sum of the four multiples of the generators of a simplicial cone. *)
Definition sum4 (t : corner -> R) (g0 g1 g2 g3 : quad Z) : quad R :=
  shift (t Corner0) g0 (shift (t Corner1) g1 (shift (t Corner2) g2 (shift (t Corner3) g3
    (Quad 0 0 0 0)))).

Lemma spans4 g0 g1 g2 g3 x :
  spans [g0; g1; g2; g3] x <-> exists t, (forall k, 0 <= t k) /\ x = sum4 t g0 g1 g2 g3.
Proof.
  split.
  - intros H. inversion H as [|t0 ? ? x0 T0 H0]; subst. inversion H0 as [|t1 ? ? x1 T1 H1]; subst.
    inversion H1 as [|t2 ? ? x2 T2 H2]; subst. inversion H2 as [|t3 ? ? x3 T3 H3]; subst.
    inversion H3; subst.
    exists (fun k => match k with Corner0 => t0 | Corner1 => t1 | Corner2 => t2 | Corner3 => t3 end).
    split; [now intros [] | reflexivity].
  - intros (t & Ht & ->). unfold sum4. repeat (apply spans_cons; [apply Ht|]). constructor.
Qed.

Lemma inside_spans r x : inside r x -> spans (generators r) x.
Proof.
  destruct r as [|g0 g1 g2 g3]; trivial. cbn [inside]. intros H.
  apply (@spans_shift _ _ _ _ (Quad 0 (q1 x) (q2 x) (q3 x)) H); [|apply shift_eq; cbn; ring].
  assert (forall a, exists p m, 0 <= p /\ 0 <= m /\ p - m = a) as Parts.
  { intros a. destruct (Rle_dec 0 a); [exists a, 0 | exists 0, (- a)]; lra. }
  destruct (Parts (q1 x)) as (p1 & m1 & P1 & M1 & E1).
  destruct (Parts (q2 x)) as (p2 & m2 & P2 & M2 & E2).
  destruct (Parts (q3 x)) as (p3 & m3 & P3 & M3 & E3).
  apply (@spans_shift _ _ _ _ (Quad 0 (- m1) (q2 x) (q3 x)) P1); [|apply shift_eq; cbn; lra].
  apply (@spans_shift _ _ _ _ (Quad 0 0 (q2 x) (q3 x)) M1); [|apply shift_eq; cbn; lra].
  apply (@spans_shift _ _ _ _ (Quad 0 0 (- m2) (q3 x)) P2); [|apply shift_eq; cbn; lra].
  apply (@spans_shift _ _ _ _ (Quad 0 0 0 (q3 x)) M2); [|apply shift_eq; cbn; lra].
  apply (@spans_shift _ _ _ _ (Quad 0 0 0 (- m3)) P3); [|apply shift_eq; cbn; lra].
  apply (@spans_shift _ _ _ _ (Quad 0 0 0 0) M3); [|apply shift_eq; cbn; lra].
  constructor.
Qed.

Lemma inside_orthant x s1 s2 s3 :
  0 <= q0 x -> 0 <= IZR s1 * q1 x -> 0 <= IZR s2 * q2 x -> 0 <= IZR s3 * q3 x ->
  (s1 * s1 = 1)%Z -> (s2 * s2 = 1)%Z -> (s3 * s3 = 1)%Z ->
  inside (orthant s1 s2 s3) x.
Proof.
  intros H0 H1 H2 H3 S1 S2 S3.
  assert (forall s a, (s * s = 1)%Z -> IZR s * a * IZR s = a) as Square.
  { intros s a S. replace (IZR s * a * IZR s) with (IZR s * IZR s * a) by ring.
    rewrite <- mult_IZR, S. ring. }
  unfold inside, orthant, generators. rewrite spans4.
  exists (fun k => match k with Corner0 => q0 x | Corner1 => IZR s1 * q1 x
    | Corner2 => IZR s2 * q2 x | Corner3 => IZR s3 * q3 x end).
  split; [now intros []|].
  destruct x as [x0 x1 x2 x3]. unfold sum4, shift, unit0, unit1, unit2, unit3; cbn [q0 q1 q2 q3].
  rewrite !Square by trivial. f_equal; ring.
Qed.

(** The orthants cover the half space. *)
Lemma orthants_cover x :
  inside HalfSpace x ->
  inside (orthant 1 1 1) x \/ inside (orthant 1 1 (-1)) x \/
  inside (orthant 1 (-1) 1) x \/ inside (orthant 1 (-1) (-1)) x \/
  inside (orthant (-1) 1 1) x \/ inside (orthant (-1) 1 (-1)) x \/
  inside (orthant (-1) (-1) 1) x \/ inside (orthant (-1) (-1) (-1)) x.
Proof.
  cbn [inside]. intros H0.
  destruct (Rle_dec 0 (q1 x)), (Rle_dec 0 (q2 x)), (Rle_dec 0 (q3 x));
    [left | right; left | do 2 right; left | do 3 right; left | do 4 right; left
      | do 5 right; left | do 6 right; left | do 7 right]; apply inside_orthant; trivial; lra.
Qed.

Lemma same_false j k : negb (same j k) = true -> j <> k.
Proof. now destruct j, k. Qed.

(** A positive multiple of the primitive generator is the generator. *)
Lemma primitive_multiple v :
  exists d, (0 < d)%Z /\
    (q0 v = d * q0 (primitive v) /\ q1 v = d * q1 (primitive v) /\
     q2 v = d * q2 (primitive v) /\ q3 v = d * q3 (primitive v))%Z.
Proof.
  unfold primitive.
  set (d := Z.gcd (q0 v) _). destruct (0 <? d)%Z eqn:E; bools; [|exists 1%Z; lia].
  exists d. cbn [q0 q1 q2 q3].
  assert (forall a, (d | a)%Z -> a = (d * (a / d))%Z) as Exact.
  { intros a [k ->]. rewrite Z.div_mul by lia. ring. }
  assert (d | Z.gcd (q1 v) (Z.gcd (q2 v) (q3 v)))%Z as D1 by apply Z.gcd_divide_r.
  assert (d | Z.gcd (q2 v) (q3 v))%Z as D2
    by (eapply Z.divide_trans; [exact D1 | apply Z.gcd_divide_r]).
  repeat split; trivial; apply Exact.
  - apply Z.gcd_divide_l.
  - eapply Z.divide_trans; [exact D1 | apply Z.gcd_divide_l].
  - eapply Z.divide_trans; [exact D2 | apply Z.gcd_divide_l].
  - eapply Z.divide_trans; [exact D2 | apply Z.gcd_divide_r].
Qed.

(** The children of an edge cover the cone. *)
Lemma edge_covers j k p q g0 g1 g2 g3 x :
  let v := primitive (combine p (at_corner j g0 g1 g2 g3) q (at_corner k g0 g1 g2 g3)) in
  j <> k -> (0 < p)%Z -> (0 < q)%Z -> spans [g0; g1; g2; g3] x ->
  inside (moved j v g0 g1 g2 g3) x \/ inside (moved k v g0 g1 g2 g3) x.
Proof.
  intros v Different Hp Hq. rewrite spans4. intros (t & Ht & ->).
  destruct (primitive_multiple (combine p (at_corner j g0 g1 g2 g3) q (at_corner k g0 g1 g2 g3)))
    as (d & Hd & V0 & V1 & V2 & V3).
  fold v in V0, V1, V2, V3. clearbody v. unfold combine in *. cbn [q0 q1 q2 q3] in *.
  apply (f_equal IZR) in V0, V1, V2, V3. rewrite !plus_IZR, !mult_IZR in V0, V1, V2, V3.
  apply IZR_lt in Hp, Hq, Hd.
  set (P := IZR p) in *. set (Q := IZR q) in *. set (D := IZR d) in *.
  assert (exists s, 0 <= s /\ (
    (t j = s * P /\ 0 <= t k - s * Q) \/ (t k = s * Q /\ 0 <= t j - s * P))) as (s & Hs & Cases).
  { pose proof (Ht j). pose proof (Ht k).
    destruct (Rle_dec (t j * Q) (t k * P)) as [L|L].
    - exists (t j / P). assert (t j = t j / P * P) as E by (field; lra).
      assert (0 <= t j / P) by (apply Rmult_le_reg_r with P; lra).
      split; trivial. left. split; trivial. apply Rmult_le_reg_r with P; trivial.
      rewrite Rmult_0_l, Rmult_minus_distr_r. nra.
    - exists (t k / Q). assert (t k = t k / Q * Q) as E by (field; lra).
      assert (0 <= t k / Q) by (apply Rmult_le_reg_r with Q; lra).
      split; trivial. right. split; trivial. apply Rmult_le_reg_r with Q; trivial.
      rewrite Rmult_0_l, Rmult_minus_distr_r. nra. }
  assert (forall a b c : R, a = D * c -> s * D * c = s * a) as Scale by (intros; subst; ring).
  pose proof (Scale _ 0 _ V0) as W0. pose proof (Scale _ 0 _ V1) as W1.
  pose proof (Scale _ 0 _ V2) as W2. pose proof (Scale _ 0 _ V3) as W3.
  assert (0 <= s * D) by nra.
  destruct Cases as [[E L]|[E L]]; [left | right].
  - assert (exists w, (forall i, 0 <= w i) /\ w j = s * D /\ w k = t k - s * Q /\
      forall i, i <> j -> i <> k -> w i = t i) as (w & Hw & Wj & Wk & W).
    { exists (fun i => if same i j then s * D else if same i k then t k - s * Q else t i).
      destruct j, k; try congruence; (split; [intros []; cbn; auto | repeat split; trivial]);
        intros []; congruence || reflexivity. }
    destruct j, k; try congruence; cbn [moved inside generators at_corner] in *; rewrite spans4;
      exists w; (split; [trivial|]); unfold sum4, shift; cbn [q0 q1 q2 q3];
      rewrite ?Wj, ?Wk, ?W, ?W0, ?W1, ?W2, ?W3, ?E by discriminate; f_equal; ring.
  - assert (exists w, (forall i, 0 <= w i) /\ w k = s * D /\ w j = t j - s * P /\
      forall i, i <> j -> i <> k -> w i = t i) as (w & Hw & Wk & Wj & W).
    { exists (fun i => if same i k then s * D else if same i j then t j - s * P else t i).
      destruct j, k; try congruence; (split; [intros []; cbn; auto | repeat split; trivial]);
        intros []; congruence || reflexivity. }
    destruct j, k; try congruence; cbn [moved inside generators at_corner] in *; rewrite spans4;
      exists w; (split; [trivial|]); unfold sum4, shift; cbn [q0 q1 q2 q3];
      rewrite ?Wj, ?Wk, ?W, ?W0, ?W1, ?W2, ?W3, ?E by discriminate; f_equal; ring.
Qed.
