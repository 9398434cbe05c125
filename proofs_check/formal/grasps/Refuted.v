(** Counterexamples of refuted claims about grasps: equilibria that are checked, and none. *)

Require Import Reals ZArith QArith Qreals List Lia Lra.
Require Model Soundness.
Import ListNotations.

(** Contacts are point, normal, friction, stiffness, preload. Two springs share a force. *)
Definition two_springs : Model.question Q := Model.Question
  [Model.Contact 0 0 1 0 1 1 1; Model.Contact (-1) (-1) 1 0 1 1 1]%Q (Model.Vector (-1) 0 0)%Q.

Lemma two_solutions : exists d forces d' forces',
  Model.equilibrium (Model.real_question two_springs) d forces /\
  Model.equilibrium (Model.real_question two_springs) d' forces' /\ map fst forces <> map fst forces'.
Proof.
  exists (Model.real_vector (Model.Vector 0 0 1)%Q), (Model.real_forces [(1, 0); (0, 0)]%Q),
    (Model.real_vector (Model.Vector (1 # 2) 0 0)%Q), (Model.real_forces [(1 # 2, - (1 # 2)); (1 # 2, 1 # 2)]%Q).
  split; [now apply Soundness.resisted|]. split; [now apply Soundness.resisted|].
  intros [= E _]. apply eqR_Qeq in E. easy.
Qed.

(** Pressed on one side, the other one must let go. *)
Definition opposed : Model.question Q := Model.Question
  [Model.Contact 0 0 1 0 1 1 0; Model.Contact (-1) 0 (-1) 0 1 1 0]%Q (Model.Vector (-1) 0 0)%Q.

(** A spring that may pull no contact and let none go. *)
Definition never_lets_go (d : Model.vector R) (c : Model.contact R) (force : R * R) : Prop :=
  let (c_n, c_t) := force in
  (c_n = Model.preload c - Model.stiffness c * Model.dot (Model.N c) d /\
  0 <= c_n /\ Rabs c_t <= Model.friction c * c_n)%R.

Lemma opposed_lets_go :
  (exists d forces, Model.equilibrium (Model.real_question opposed) d forces) /\
  forall d forces, Forall2 (never_lets_go d) (Model.contacts (Model.real_question opposed)) forces ->
    Model.add (Model.total (Model.contacts (Model.real_question opposed)) forces)
      (Model.applied (Model.real_question opposed)) <> Model.zero.
Proof.
  split.
  - exists (Model.real_vector (Model.Vector (-1) 0 0)%Q), (Model.real_forces [(1, 0); (0, 0)]%Q).
    now apply Soundness.resisted.
  - intros d forces H E. cbn in H. inversion H as [|? [n1 t1] ? ? (E1 & P1 & _) H1]; subst.
    inversion H1 as [|? [n2 t2] ? ? (E2 & P2 & _) H2]; subst. inversion H2; subst.
    injection E as X _ _. unfold Model.dot, Model.N, Model.wrench, Q2R in *. cbn in *. lra.
Qed.

(** A turn in a corner, with preload q of both contacts. *)
Definition corner (q : Z) : Model.question Q := Model.Question
  [Model.Contact 0 0 1 0 1 1 (q # 1); Model.Contact (-1) 0 0 1 1 1 (q # 1)]%Q (Model.Vector 0 0 1)%Q.

Lemma corner_needs_preload :
  (exists d forces, Model.equilibrium (Model.real_question (corner 1)) d forces) /\
  forall d forces, ~ Model.equilibrium (Model.real_question (corner 0)) d forces.
Proof.
  split.
  - exists (Model.real_vector (Model.Vector 0 0 0)%Q), (Model.real_forces [(1, -(1)); (1, 1)]%Q).
    now apply Soundness.resisted.
  - intros d forces [H E]. cbn in H. inversion H as [|? [n1 t1] ? ? (E1 & P1 & _) H1]; subst.
    inversion H1 as [|? [n2 t2] ? ? (_ & P2 & S2 & _) H2]; subst. inversion H2; subst.
    injection E as X Y Z. pose proof (Rle_abs (- t1)). pose proof (Rle_abs t2). rewrite Rabs_Ropp in *.
    unfold Model.dot, Model.N, Model.T, Model.wrench, Q2R, Rmax in *. cbn in *.
    destruct (Rle_dec _ _); [|lra]. enough (t2 = - (1 * / 1) * n2)%R by lra. apply S2. lra.
Qed.
