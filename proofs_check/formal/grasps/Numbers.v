(** Rationals as integers, and linear forms on cones over the reals. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Checker.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Integers and rationals *)

Ltac reals :=
  repeat (rewrite mult_IZR || rewrite plus_IZR || rewrite minus_IZR || rewrite opp_IZR).

Ltac bools :=
  repeat match goal with
  | H : (_ && _)%bool = true |- _ => apply andb_prop in H; destruct H
  | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
  | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
  | H : (_ =? _)%Z = true |- _ => apply Z.eqb_eq in H
  | H : (_ <? _)%Z = false |- _ => apply Z.ltb_ge in H
  | H : (_ <=? _)%Z = false |- _ => apply Z.leb_gt in H
  end.

Lemma common_pos l : (0 < common l)%Z.
Proof.
  induction l as [|q l IH]; cbn; [lia|].
  pose proof (Z.lcm_nonneg (Zpos (Qden q)) (common l)).
  assert (Z.lcm (Zpos (Qden q)) (common l) <> 0)%Z; [|unfold common in *; lia].
  rewrite Z.lcm_eq_0. lia.
Qed.

Lemma common_divides q l : In q l -> (Zpos (Qden q) | common l)%Z.
Proof.
  induction l as [|p l IH]; cbn; [easy|]. intros [->|H].
  - apply Z.divide_lcm_l.
  - apply Z.divide_trans with (common l); [auto | apply Z.divide_lcm_r].
Qed.

Lemma clear_real d q : (Zpos (Qden q) | d)%Z -> IZR (clear d q) = IZR d * Q2R q.
Proof.
  intros [k ->]. unfold clear, Q2R. rewrite Z.div_mul by lia. rewrite !mult_IZR.
  field. apply not_0_IZR. lia.
Qed.

Lemma clear_common q l : In q l -> IZR (clear (common l) q) = IZR (common l) * Q2R q.
Proof. intros; apply clear_real; now apply common_divides. Qed.

(** * Homogeneous motions over the reals *)

Definition evalR (f : quad Z) (x : quad R) : R :=
  IZR (q0 f) * q0 x + IZR (q1 f) * q1 x + IZR (q2 f) * q2 x + IZR (q3 f) * q3 x.

Definition real_quad (g : quad Z) : quad R :=
  Quad (IZR (q0 g)) (IZR (q1 g)) (IZR (q2 g)) (IZR (q3 g)).

Lemma eval_real f g : evalR f (real_quad g) = IZR (eval f g).
Proof. unfold evalR, eval; cbn. rewrite !plus_IZR, !mult_IZR. ring. Qed.

Definition shift (t : R) (g : quad Z) (x : quad R) : quad R :=
  Quad (t * IZR (q0 g) + q0 x) (t * IZR (q1 g) + q1 x)
       (t * IZR (q2 g) + q2 x) (t * IZR (q3 g) + q3 x).

Lemma eval_shift f t g x : evalR f (shift t g x) = t * IZR (eval f g) + evalR f x.
Proof. rewrite <- eval_real. unfold evalR, shift, real_quad; cbn. ring. Qed.

(** The cone of finitely many generators. *)
Inductive spans : list (quad Z) -> quad R -> Prop :=
| spans_nil : spans [] (Quad 0 0 0 0)
| spans_cons t g gens x : 0 <= t -> spans gens x -> spans (g :: gens) (shift t g x).

Lemma form_nonneg f gens x :
  spans gens x -> (forall g, In g gens -> 0 <= eval f g)%Z -> 0 <= evalR f x.
Proof.
  induction 1 as [|t g gens x Ht Hx IH]; intros H; [unfold evalR; cbn; lra|].
  rewrite eval_shift.
  assert (0 <= evalR f x) by (apply IH; intros; apply H; now right).
  assert (0 <= IZR (eval f g)) by (apply IZR_le, H; now left). nra.
Qed.

Lemma form_pos f gens x :
  spans gens x -> (forall g, In g gens -> 0 < eval f g)%Z -> 0 < evalR f x \/ q0 x = 0.
Proof.
  induction 1 as [|t g gens x Ht Hx IH]; intros H; [now right|].
  rewrite eval_shift. cbn [shift q0].
  assert (0 < IZR (eval f g)) by (apply IZR_lt, H; now left).
  assert (0 <= evalR f x).
  { apply form_nonneg with gens; trivial.
    intros g' Hg. apply Z.lt_le_incl, H. now right. }
  destruct IH as [IH | IH]; [intros; apply H; now right | left; nra |].
  destruct (Rle_lt_or_eq_dec 0 t Ht) as [Lt | <-]; [left; nra|].
  right. lra.
Qed.

Definition opposite (f : quad Z) : quad Z := Quad (- q0 f)%Z (- q1 f)%Z (- q2 f)%Z (- q3 f)%Z.

Lemma eval_opposite f g : eval (opposite f) g = (- eval f g)%Z.
Proof. unfold eval, opposite; cbn. ring. Qed.

Lemma evalR_opposite f x : evalR (opposite f) x = - evalR f x.
Proof. unfold evalR, opposite; cbn. rewrite !opp_IZR. ring. Qed.

Lemma form_nonpos f gens x :
  spans gens x -> (forall g, In g gens -> eval f g <= 0)%Z -> evalR f x <= 0.
Proof.
  intros Hx H. assert (0 <= evalR (opposite f) x).
  { apply form_nonneg with gens; trivial. intros g Hg. rewrite eval_opposite.
    specialize (H g Hg). lia. }
  rewrite evalR_opposite in H0. lra.
Qed.

Lemma form_neg f gens x :
  spans gens x -> (forall g, In g gens -> eval f g < 0)%Z -> evalR f x < 0 \/ q0 x = 0.
Proof.
  intros Hx H. assert (0 < evalR (opposite f) x \/ q0 x = 0) as [P|P].
  { apply form_pos with gens; trivial. intros g Hg. rewrite eval_opposite.
    specialize (H g Hg). lia. }
  - left. rewrite evalR_opposite in P. lra.
  - now right.
Qed.

