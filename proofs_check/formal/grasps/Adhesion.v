(** Contacts with adhesion: each pulls by a constant force against its normal, besides its law. *)

Require Import Reals QArith Qreals List.
Require Import Model Rationals Checker Vectors Soundness.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The statement *)

(** The wrench of the pulls of contacts, one number for each. *)
Fixpoint pull (cs : list (row R)) (adhesion : list R) : list R :=
  match cs, adhesion with
  | c :: cs, a :: adhesion => add (times (- a) (normal c)) (pull cs adhesion)
  | _, _ => []
  end.

(** Spring, friction cone and dissipation are about the forces without the pulls; balance is about
    all: forces, pulls and load add up to 0. *)
Definition balances_pulled (g : question R) (adhesion : list R) (d : list R)
    (forces : list (R * R * R)) :=
  equilibrium (dimension g) (rows_of g) (add (pull (rows_of g) adhesion) (load_of g)) d forces.

(** * The checker *)

Fixpoint qpull (cs : list (row Q)) (adhesion : list Q) : list Q :=
  match cs, adhesion with
  | c :: cs, a :: adhesion => qadd (qscaled (Qopp a) (normal c)) (qpull cs adhesion)
  | _, _ => []
  end.

Definition with_load F (g : question F) (load : list F) : question F :=
  match g with
  | InPlane cs _ => InPlane cs load
  | InSpace cs _ => InSpace cs load
  | OfBodies count js _ => OfBodies count js load
  end.

(** The pulls are a part of the load. *)
Definition pulled (g : question Q) (adhesion : list Q) : question Q :=
  with_load g (qadd (qpull (qrows_of g) adhesion) (load_of g)).

Definition check_pulled (g : question Q) (adhesion : list Q) (p : proof) : bool :=
  check (pulled g adhesion) p.

(** * What it accepts is true *)

Lemma pull_real : forall cs adhesion,
  reals (qpull cs adhesion) = pull (map real_row cs) (reals adhesion).
Proof.
  induction cs as [|c cs IH]; intros [|a adhesion]; trivial.
  cbn [qpull pull map reals]. rewrite qadd_real, qscaled_real, IH, Q2R_opp. reflexivity.
Qed.

Lemma pulled_right g adhesion d forces :
  balances (real_question (pulled g adhesion)) d forces <->
  balances_pulled (real_question g) (reals adhesion) d forces.
Proof.
  assert (load_of (real_question (pulled g adhesion)) =
    add (pull (rows_of (real_question g)) (reals adhesion)) (load_of (real_question g))) as L.
  { rewrite <- rows_real, <- pull_real, <- !load_real, <- qadd_real. now destruct g. }
  unfold balances, balances_pulled. rewrite L. now destruct g.
Qed.

Theorem not_resisted_pulled : forall question adhesion proof,
  (forall d forces, proof <> Resisted d forces) -> check_pulled question adhesion proof = true ->
  forall d forces, ~ balances_pulled (real_question question) (reals adhesion) d forces.
Proof.
  intros g adhesion p No Test d forces E. apply pulled_right in E.
  now apply (@not_resisted (pulled g adhesion) p No Test d forces).
Qed.

Theorem resisted_pulled : forall question adhesion motion forces,
  check_pulled question adhesion (Resisted motion forces) = true <->
  balances_pulled (real_question question) (reals adhesion) (reals motion) (real_forces forces).
Proof. intros. unfold check_pulled. rewrite resisted. apply pulled_right. Qed.
