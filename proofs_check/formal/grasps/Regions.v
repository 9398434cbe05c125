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

(** With v = (P g_j + Q g_k) / D in place of g_j, a sum of generators in which g_k has its share. *)
Lemma moved_inside j k v t s P Q D g0 g1 g2 g3 :
  let g_j := at_corner j g0 g1 g2 g3 in
  let g_k := at_corner k g0 g1 g2 g3 in
  j <> k -> (forall i, 0 <= t i) -> 0 <= s * D -> t j = s * P -> 0 <= t k - s * Q ->
  P * IZR (q0 g_j) + Q * IZR (q0 g_k) = D * IZR (q0 v) ->
  P * IZR (q1 g_j) + Q * IZR (q1 g_k) = D * IZR (q1 v) ->
  P * IZR (q2 g_j) + Q * IZR (q2 g_k) = D * IZR (q2 v) ->
  P * IZR (q3 g_j) + Q * IZR (q3 g_k) = D * IZR (q3 v) ->
  inside (moved j v g0 g1 g2 g3) (sum4 t g0 g1 g2 g3).
Proof.
  intros g_j g_k Different Ht Hs Tj Tk V0 V1 V2 V3.
  assert (forall a c, a = D * c -> s * D * c = s * a) as Scale by (intros; subst; ring).
  apply Scale in V0, V1, V2, V3. subst g_j g_k.
  set (w := fun i => if same i j then s * D else if same i k then t k - s * Q else t i).
  assert (forall i, 0 <= w i) as Hw by (intros i; unfold w; destruct (same i j), (same i k); auto).
  destruct j, k; try congruence; cbn [moved inside generators at_corner] in *; rewrite spans4;
    exists w; (split; [exact Hw|]); unfold w, sum4, shift; cbn [q0 q1 q2 q3 same];
    rewrite ?V0, ?V1, ?V2, ?V3, ?Tj; f_equal; ring.
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
  apply IZR_lt in Hp, Hq, Hd. pose proof (Ht j). pose proof (Ht k).
  assert (forall a b c e, 0 < b -> 0 <= a -> a * e <= c * b ->
    exists s, 0 <= s /\ a = s * b /\ 0 <= c - s * e) as Share.
  { intros a b c e Hb Ha Le. exists (a / b). assert (a = a / b * b) as E by (field; lra).
    assert (0 <= a / b) by (apply Rmult_le_reg_r with b; lra).
    repeat split; trivial. apply Rmult_le_reg_r with b; trivial.
    replace ((c - a / b * e) * b) with (c * b - a * e) by (field; lra). lra. }
  destruct (Rle_dec (t j * IZR q) (t k * IZR p)) as [Le | Le]; [left | right].
  - destruct (Share _ _ _ _ Hp (Ht j) Le) as (s & Hs & E & L).
    apply (@moved_inside j k v t s (IZR p) (IZR q) (IZR d)); trivial; nra.
  - destruct (Share (t k) (IZR q) (t j) (IZR p)) as (s & Hs & E & L); trivial; [lra|].
    apply (@moved_inside k j v t s (IZR q) (IZR p) (IZR d)); auto; nra.
Qed.
