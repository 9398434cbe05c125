(** Counterexamples of refuted claims about grasps: equilibria that are checked, and none. *)

Require Import Reals ZArith QArith Qreals List Lia Lra.
Require Model Soundness.
Import ListNotations.

(** A contact in the plane: point, normal, friction, stiffness, preload. *)
Definition at_point (x y n_x n_y mu k q : Q) : Model.contact Q :=
  Model.Contact x y n_x n_y (Model.Values mu k q).

(** Two springs share a force. *)
Definition two_springs : Model.question Q := Model.InPlane
  [at_point 0 0 1 0 1 1 1; at_point (-1) (-1) 1 0 1 1 1]%Q [-1; 0; 0]%Q.

Definition normal_forces (forces : list (R * R * R)) : list R := map (fun f => fst (fst f)) forces.

Lemma two_solutions : exists d forces d' forces',
  Model.balances (Model.real_question two_springs) d forces /\
  Model.balances (Model.real_question two_springs) d' forces' /\
  normal_forces forces <> normal_forces forces'.
Proof.
  exists (Model.reals [0; 0; 1]%Q), (Model.real_forces [(1, 0, 0); (0, 0, 0)]%Q),
    (Model.reals [1 # 2; 0; 0]%Q),
    (Model.real_forces [(1 # 2, - (1 # 2), 0); (1 # 2, 1 # 2, 0)]%Q).
  split; [now apply Soundness.resisted|]. split; [now apply Soundness.resisted|].
  intros [= E _]. apply eqR_Qeq in E. easy.
Qed.

(** Pressed on one side, the other one must let go. *)
Definition opposed : Model.question Q := Model.InPlane
  [at_point 0 0 1 0 1 1 0; at_point (-1) 0 (-1) 0 1 1 0]%Q [-1; 0; 0]%Q.

(** A spring that may pull no contact and let none go. *)
Definition never_lets_go (d : list R) (c : Model.row R) (force : R * R * R) : Prop :=
  let '(c_n, c_t, _) := force in
  let v := Model.values_of c in
  (c_n = Model.preload v - Model.stiffness v * Model.dot (Model.normal c) d /\
  0 <= c_n /\ Rabs c_t <= Model.friction v * c_n)%R.

(** Forces that add up to the opposite of the load, whatever gives them. *)
Definition balanced (g : Model.question R) (forces : list (R * R * R)) : Prop :=
  Forall (fun x => x = 0%R) (Model.add (Model.total (Model.rows_of g) forces) (Model.load_of g)).

Lemma opposed_lets_go :
  (exists d forces, Model.balances (Model.real_question opposed) d forces) /\
  forall d forces, length d = 3%nat ->
    Forall2 (never_lets_go d) (Model.rows_of (Model.real_question opposed)) forces ->
    ~ balanced (Model.real_question opposed) forces.
Proof.
  split.
  - exists (Model.reals [-1; 0; 0]%Q), (Model.real_forces [(1, 0, 0); (0, 0, 0)]%Q).
    now apply Soundness.resisted.
  - intros d forces L H E. destruct d as [|x [|y [|r [|? ?]]]]; try easy.
    cbn in H. inversion H as [|? [[n1 t1] u1] ? ? (E1 & P1 & _) H1]; subst.
    inversion H1 as [|? [[n2 t2] u2] ? ? (E2 & P2 & _) H2]; subst. inversion H2; subst.
    unfold balanced in E. cbn in E. inversion E as [|? ? X _]. unfold Q2R in *. cbn in *. lra.
Qed.

(** A turn in a corner, with preload q of both contacts. *)
Definition corner (q : Z) : Model.question Q := Model.InPlane
  [at_point 0 0 1 0 1 1 (q # 1); at_point (-1) 0 0 1 1 1 (q # 1)]%Q [0; 0; 1]%Q.

Lemma corner_needs_preload :
  (exists d forces, Model.balances (Model.real_question (corner 1)) d forces) /\
  forall d forces, ~ Model.balances (Model.real_question (corner 0)) d forces.
Proof.
  split.
  - exists (Model.reals [0; 0; 0]%Q), (Model.real_forces [(1, -(1), 0); (1, 1, 0)]%Q).
    now apply Soundness.resisted.
  - intros d forces (L & H & E). destruct d as [|x [|y [|r [|? ?]]]]; try easy.
    cbn in H. inversion H as [|? [[n1 t1] u1] ? ? F1 H1]; subst.
    inversion H1 as [|? [[n2 t2] u2] ? ? F2 H2]; subst. inversion H2; subst.
    cbn in E. inversion E as [|? ? X E']; subst. inversion E' as [|? ? Y E'']; subst.
    inversion E'' as [|? ? Z _]; subst. clear H H1 H2 E E' E''.
    destruct F1 as (E1 & G1 & C1 & _), F2 as (_ & G2 & C2 & S2).
    unfold Q2R in *. cbn in *.
    assert (n2 = 1 /\ t1 = -1 /\ t2 = n1)%R as (-> & -> & ->) by (repeat split; lra).
    assert (n1 = 1)%R as -> by nra.
    assert (x = -1)%R as -> by (unfold Rmax in E1; destruct (Rle_dec _ _); lra).
    destruct S2 as (_ & t & T & F & _); [left; lra | lra].
Qed.
