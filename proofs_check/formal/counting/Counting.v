(** The program: the recursions over the integers, and the test of a complete list. *)

Require Import Reals ZArith List Bool Lia Lra.
Require Import Planes Sides Rank Recursion.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * The program *)

Fixpoint flat (a : list Z) : bool :=
  match a with [] => true | c :: a => (c =? 0) && flat a end.

Definition look (f : form Z) : kind :=
  if flat (coefficients f) then if constant f =? 0 then Vanishes else Constant else Plane.

(** The first coordinate whose coefficient is not 0. *)
Fixpoint pivot (a : list Z) : nat :=
  match a with [] => O | c :: a => if c =? 0 then S (pivot a) else O end.

(** a u - b v *)
Fixpoint mix (a b : Z) (u v : list Z) : list Z :=
  match u, v with
  | x :: u, y :: v => a * x - b * y :: mix a b u v
  | [], y :: v => - (b * y) :: mix a b [] v
  | u, [] => map (Z.mul a) u
  end.

(** A common divisor of [c] and all [a]: the greatest one. *)
Fixpoint content (c : Z) (a : list Z) : Z :=
  match a with [] => c | b :: a => if c =? 1 then 1 else content (Z.gcd c b) a end.

Definition primitive (f : form Z) : form Z :=
  let c := content (Z.abs (constant f)) (coefficients f) in
  if c <=? 1 then f else Form (constant f / c) (map (fun a => a / c) (coefficients f)).

Definition restrict (h : form Z) : form Z -> form Z :=
  let j := pivot (coefficients h) in
  let p := nth j (coefficients h) 0 in
  fun g =>
    let q := nth j (coefficients g) 0 in
    if q =? 0 then g
    else
      let c := Z.gcd p q in
      let a := Z.abs p / c in
      let b := Z.sgn p * (q / c) in
      primitive (Form (a * constant g - b * constant h)
        (mix a b (coefficients g) (coefficients h))).

Definition count_regions (planes : list (form Z)) : Z :=
  regions look restrict (length planes) planes.

Definition count_faces (planes : list (form Z)) : list Z :=
  faces look restrict (length planes) [] planes.

Definition characteristic_polynomial (planes : list (form Z)) : list Z :=
  polynomial look restrict (length planes) planes.

(** A rational point: numerators over one denominator. *)
Record witness := Witness { numerators : list Z; denominator : Z }.

Fixpoint product (a x : list Z) : Z :=
  match a, x with b :: a, y :: x => b * y + product a x | _, _ => 0 end.

Definition sign_at (w : witness) (f : form Z) : sign :=
  match constant f * denominator w + product (coefficients f) (numerators w) ?= 0 with
  | Lt => Minus | Eq => Zero | Gt => Plus
  end.

Definition same_sign (s t : sign) : bool :=
  match s, t with Minus, Minus | Zero, Zero | Plus, Plus => true | _, _ => false end.

(** The point has the signs; [open]: none of them may be 0. *)
Fixpoint shown (open : bool) (w : witness) (planes : list (form Z)) (s : list sign) : bool :=
  match planes, s with
  | [], [] => true
  | f :: planes, a :: s =>
      same_sign (sign_at w f) a && negb (open && same_sign a Zero) && shown open w planes s
  | _, _ => false
  end.

(** One number for a sign vector. *)
Fixpoint code (c : Z) (s : list sign) : Z :=
  match s with
  | [] => c
  | Minus :: s => code (3 * c) s
  | Zero :: s => code (3 * c + 1) s
  | Plus :: s => code (3 * c + 2) s
  end.

(** Sign vectors with witnesses: [left] of them, in growing order, none below [last]. *)
Fixpoint confirmed (open : bool) (planes : list (form Z)) (last left : Z)
    (list : list (list sign * witness)) : bool :=
  match list with
  | [] => left =? 0
  | (s, w) :: list =>
      let c := code 1 s in
      (last <? c) && (0 <? denominator w) && shown open w planes s &&
      confirmed open planes c (left - 1) list
  end.

Definition complete_regions planes list : bool :=
  confirmed true planes 0 (count_regions planes) list.

Definition complete_faces planes list : bool :=
  confirmed false planes 0 (fold_right Z.add 0 (count_faces planes)) list.

(** * Forms over the integers and over the real numbers *)

Open Scope R_scope.

Lemma flat_linear a : flat a = true -> forall x, linear (map IZR a) x = 0.
Proof.
  induction a as [|c a IH]; cbn; trivial. intros [C A]%andb_prop x.
  apply Z.eqb_eq in C. subst. rewrite IH by trivial. ring.
Qed.

Lemma pivot_spec a : flat a = false -> nth (pivot a) a 0%Z <> 0%Z.
Proof.
  induction a as [|c a IH]; cbn; [easy|]. destruct (Z.eqb_spec c 0); cbn; trivial.
Qed.

Lemma nth_real j a : nth j (map IZR a) 0 = IZR (nth j a 0%Z).
Proof. exact (map_nth IZR a 0%Z j). Qed.

Lemma slope_real f j : slope (real_form f) j = IZR (nth j (coefficients f) 0%Z).
Proof. apply nth_real. Qed.

Lemma linear_mix a b u : forall v x, linear (map IZR (mix a b u v)) x =
  IZR a * linear (map IZR u) x - IZR b * linear (map IZR v) x.
Proof.
  induction u as [|c u IH].
  - induction v as [|d v IH]; intros x; cbn; [ring|].
    rewrite IH. cbn. rewrite opp_IZR, mult_IZR. ring.
  - intros [|d v] x; cbn.
    + rewrite map_map. replace (linear (map (fun y => IZR (a * y)) u)) with
        (fun x => IZR a * linear (map IZR u) x); [rewrite mult_IZR; ring|].
      clear. apply FunctionalExtensionality.functional_extensionality.
      induction u as [|d u IH]; intros x; cbn; [ring|]. rewrite <- IH, mult_IZR. ring.
    + rewrite IH, minus_IZR, !mult_IZR. ring.
Qed.

Lemma content_divides a : forall c, (0 <= c)%Z ->
  (0 <= content c a)%Z /\ (content c a | c)%Z /\ forall b, In b a -> (content c a | b)%Z.
Proof.
  induction a as [|b a IH]; intros c C; cbn.
  - repeat split; trivial; [exists 1%Z; lia|easy].
  - destruct (Z.eqb_spec c 1).
    + repeat split; [lia|exists c; lia|]. intros d _. exists d. lia.
    + destruct (IH (Z.gcd c b) (Z.gcd_nonneg _ _)) as (P & D & E). repeat split; trivial.
      * apply Z.divide_trans with (1 := D). apply Z.gcd_divide_l.
      * intros d [<-|H]; auto. apply Z.divide_trans with (1 := D). apply Z.gcd_divide_r.
Qed.

Lemma divided c b : (1 < c)%Z -> (c | b)%Z -> IZR (b / c) = / IZR c * IZR b.
Proof.
  intros C [k ->]. rewrite Z.div_mul, mult_IZR by lia. field. apply not_0_IZR. lia.
Qed.

Lemma primitive_value f : exists p, 0 < p /\
  forall x, value (real_form (primitive f)) x = p * value (real_form f) x.
Proof.
  unfold primitive. set (c := content _ _). destruct (Z.leb_spec c 1) as [L|L].
  - exists 1. split; [lra|]. intros. ring.
  - destruct (content_divides (coefficients f) (Z.abs_nonneg (constant f))) as (_ & D & E).
    fold c in D, E. assert (0 < IZR c) by (apply IZR_lt; lia).
    exists (/ IZR c). split; [now apply Rinv_0_lt_compat|]. intros x.
    unfold value. cbn. rewrite divided by (trivial; now apply Z.divide_abs_r).
    replace (linear (map IZR (map (fun a => (a / c)%Z) (coefficients f))) x)
      with (/ IZR c * linear (map IZR (coefficients f)) x); [ring|].
    clear D. clearbody c. revert x. induction (coefficients f) as [|b a IH]; intros x; cbn; [ring|].
    rewrite <- IH, divided; trivial; [ring|apply E; now left|]. intros d H1. apply E. now right.
Qed.

Lemma restrict_below h g :
  let j := pivot (coefficients h) in
  slope (real_form h) j <> 0 -> below (real_form h) j (real_form g) (real_form (restrict h g)).
Proof.
  intros j S. unfold restrict. fold j.
  rewrite slope_real in S. set (p := nth j (coefficients h) 0%Z) in *.
  set (q := nth j (coefficients g) 0%Z). destruct (Z.eqb_spec q 0) as [Q|Q].
  - exists 1. split; [lra|]. intros x. rewrite value_foot, !slope_real. fold p q. rewrite Q.
    field. trivial.
  - assert (p <> 0)%Z as P by (intros E; apply S; now rewrite E).
    set (c := Z.gcd p q). set (a := (Z.abs p / c)%Z). set (b := (Z.sgn p * (q / c))%Z).
    assert (0 < c)%Z as C.
    { pose proof (Z.gcd_nonneg p q). assert (c <> 0)%Z; [|unfold c in *; lia].
      intros E. apply Z.gcd_eq_0_l in E. easy. }
    assert (a * c = Z.abs p)%Z as A.
    { destruct (Z.gcd_divide_l p q) as [k K]. fold c in K. unfold a. rewrite K.
      rewrite Z.abs_mul, (Z.abs_eq c), Z.div_mul by lia. reflexivity. }
    assert (b * c = Z.sgn p * q)%Z as B.
    { destruct (Z.gcd_divide_r p q) as [k K]. fold c in K. unfold b.
      rewrite <- Z.mul_assoc. f_equal. rewrite K, Z.div_mul by lia. reflexivity. }
    assert (a * q = b * p)%Z as AB.
    { apply Z.mul_reg_r with c; [lia|].
      replace (a * q * c)%Z with (a * c * q)%Z by ring.
      replace (b * p * c)%Z with (b * c * p)%Z by ring. rewrite A, B.
      assert (forall p, Z.abs p = Z.sgn p * p)%Z as -> by (intros []; cbn; lia). ring. }
    assert (0 < a)%Z as A0 by nia.
    match goal with |- below _ _ _ (real_form (primitive ?f)) => 
      destruct (primitive_value f) as (r & R0 & R1) end.
    exists (r * IZR a). split; [apply Rmult_lt_0_compat; trivial; apply IZR_lt; lia|].
    intros x. rewrite R1, value_foot, !slope_real. fold p q.
    unfold value; cbn. rewrite linear_mix, minus_IZR, !mult_IZR.
    assert (IZR b = IZR a * (IZR q / IZR p)) as ->; [|ring].
    apply (f_equal IZR) in AB. rewrite !mult_IZR in AB. field_simplify_eq; trivial. lra.
Qed.

Lemma look_vanishes f : look f = Vanishes -> forall x, value (real_form f) x = 0.
Proof.
  unfold look. destruct (flat _) eqn:E; [|easy]. destruct (Z.eqb_spec (constant f) 0); [|easy].
  intros _ x. unfold value. cbn. rewrite flat_linear, e by trivial. ring.
Qed.

Lemma look_constant f : look f = Constant ->
  exists c, c <> 0 /\ forall x, value (real_form f) x = c.
Proof.
  unfold look. destruct (flat _) eqn:E; [|easy]. destruct (Z.eqb_spec (constant f) 0); [easy|].
  intros _. exists (IZR (constant f)). split; [now apply not_0_IZR|].
  intros x. unfold value. cbn. rewrite flat_linear by trivial. ring.
Qed.

Lemma look_plane h : look h = Plane -> exists j, slope (real_form h) j <> 0 /\
  forall g, below (real_form h) j (real_form g) (real_form (restrict h g)).
Proof.
  unfold look. destruct (flat _) eqn:E; [now destruct (constant h =? 0)%Z|]. intros _.
  exists (pivot (coefficients h)).
  assert (slope (real_form h) (pivot (coefficients h)) <> 0).
  { rewrite slope_real. now apply not_0_IZR, pivot_spec. }
  split; trivial. intros g. now apply restrict_below.
Qed.

(** * What the program prints is true *)

Theorem regions_counted : forall planes,
  number (region (real_planes planes)) (count_regions planes).
Proof.
  intros planes. apply regions_count with (1 := look_vanishes) (2 := look_constant)
    (3 := look_plane). lia.
Qed.

Theorem faces_counted : forall planes k,
  number (face_of_codimension k (real_planes planes)) (nth k (count_faces planes) 0%Z).
Proof.
  intros planes k. apply codimension_number.
  apply (@faces_count _ look restrict real_form look_vanishes look_constant look_plane
    (length planes) [] planes k). lia.
Qed.

(** One face, one codimension: together they are all faces. *)
Theorem all_faces_counted : forall planes,
  number (face (real_planes planes)) (fold_right Z.add 0%Z (count_faces planes)).
Proof.
  intros planes. apply codimensions_total; [|apply faces_counted].
  exact (@codimension_exists _ look restrict real_form look_vanishes look_constant look_plane planes).
Qed.

Theorem zaslavsky : forall planes,
  number (region (real_planes planes)) (alternating (characteristic_polynomial planes)).
Proof.
  intros planes. unfold characteristic_polynomial. rewrite polynomial_regions.
  apply regions_counted.
Qed.

Theorem faces_alternating : forall planes, alternating (count_faces planes) = 1%Z.
Proof.
  intros planes. unfold count_faces.
  now rewrite (@faces_alternate _ look restrict real_form look_vanishes look_constant look_plane).
Qed.

(** * A list with witnesses that is long enough is complete *)

Definition real_point (w : witness) : point :=
  fun i => IZR (nth i (numerators w) 0%Z) / IZR (denominator w).

Lemma product_real a : forall x d, d <> 0 ->
  linear (map IZR a) (fun i => IZR (nth i x 0%Z) / d) = IZR (product a x) / d.
Proof.
  induction a as [|c a IH]; intros x d D; cbn; [lra|]. destruct x as [|y x]; cbn.
  - replace (linear (map IZR a) (fun _ => 0 / d)) with 0; [field; trivial|].
    clear. induction a as [|b a IH]; cbn; [trivial|]. rewrite <- IH. lra.
  - rewrite IH, plus_IZR, mult_IZR by trivial. field. trivial.
Qed.

Lemma sign_at_real w f : (0 < denominator w)%Z ->
  sign_at w f = sgn (value (real_form f) (real_point w)).
Proof.
  intros D. apply IZR_lt in D. unfold sign_at, value, real_point. cbn.
  rewrite product_real by lra.
  set (n := (constant f * denominator w + product (coefficients f) (numerators w))%Z).
  replace (_ + _) with (/ IZR (denominator w) * IZR n).
  2: { unfold n. rewrite plus_IZR, mult_IZR. field. lra. }
  rewrite sgn_times by now apply Rinv_0_lt_compat.
  symmetry. destruct (Z.compare_spec n 0) as [E|E|E].
  - rewrite E. now apply sgn_zero.
  - apply sgn_minus. now apply IZR_lt.
  - apply sgn_plus. now apply IZR_lt.
Qed.

Lemma shown_real open w planes s : (0 < denominator w)%Z -> shown open w planes s = true ->
  signs (real_planes planes) (real_point w) = s /\ (open = true -> ~ In Zero s).
Proof.
  intros D. revert s. induction planes as [|f planes IH]; intros [|a s]; cbn [shown]; try easy.
  intros [[A B]%andb_prop C]%andb_prop. destruct (IH _ C) as [S N]. split.
  - unfold real_planes in *. cbn [map]. rewrite signs_cons, S, <- sign_at_real by trivial.
    f_equal. now destruct (sign_at w f), a.
  - intros ->. specialize (N eq_refl). intros [->|H]; easy.
Qed.

Lemma confirmed_real open planes l : forall last left, confirmed open planes last left l = true ->
  Z.of_nat (length l) = left /\ NoDup (map fst l) /\
  (forall s, In s (map fst l) -> (last < code 1 s)%Z /\ face (real_planes planes) s /\
    (open = true -> ~ In Zero s)).
Proof.
  induction l as [|[s w] l IH]; intros last left; cbn [confirmed].
  - intros E%Z.eqb_eq. cbn. repeat split; [lia|constructor| | |]; easy.
  - intros [[[A B]%andb_prop C]%andb_prop D]%andb_prop.
    apply Z.ltb_lt in A, B. destruct (IH _ _ D) as (Len & N & E).
    destruct (shown_real _ _ _ _ B C) as [S O]. cbn [length map fst]. split; [lia|]. split.
    + constructor; trivial. intros I. apply E in I. lia.
    + intros t [<-|I].
      * repeat split; trivial. now exists (real_point w).
      * destruct (E t I) as (F & G). split; [lia|trivial].
Qed.

Lemma long_enough T (P : T -> Prop) n l :
  number P n -> NoDup l -> (forall s, In s l -> P s) -> Z.of_nat (length l) = n -> lists P l.
Proof.
  intros (l' & (N' & L') & <-) N I E. split; trivial. intros s. split; auto. intros H.
  apply (@NoDup_length_incl _ l l' N); [lia| |now apply L'].
  intros t T1. apply L'. auto.
Qed.

Theorem regions_complete : forall planes list, complete_regions planes list = true ->
  lists (region (real_planes planes)) (map fst list).
Proof.
  intros planes l H. destruct (confirmed_real _ _ _ _ _ H) as (Len & N & E).
  apply long_enough with (1 := regions_counted planes); trivial.
  - intros s I. destruct (E s I) as (_ & F & Z). split; auto.
  - now rewrite map_length.
Qed.

Theorem faces_complete : forall planes list, complete_faces planes list = true ->
  lists (face (real_planes planes)) (map fst list).
Proof.
  intros planes l H. destruct (confirmed_real _ _ _ _ _ H) as (Len & N & E).
  apply long_enough with (1 := all_faces_counted planes); trivial.
  - intros s I. now destruct (E s I).
  - now rewrite map_length.
Qed.
