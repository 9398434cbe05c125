(** The law of passive frictional contacts in the plane, over the real numbers.

    This file is the statement: whoever believes the theorem has to read it, and nothing else.
    Conventions: one object frame, counter-clockwise positive; a contact's normal points INTO the
    object, its tangent is the normal turned by +90 degrees; forces act ON the object. *)

Require Import Reals QArith Qreals List.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** A wrench (force x, force y, torque), or a small motion (translation x, y, rotation). *)
Record vector F := Vector { along_x : F; along_y : F; turn : F }.

Record contact F := Contact {
  point_x : F; point_y : F;
  normal_x : F; normal_y : F;
  friction : F;   (* coefficient mu of Coulomb's law *)
  stiffness : F;  (* k of the normal spring *)
  preload : F     (* q, the force of the spring before any motion *)
}.

(** The contacts of a grasp and the wrench that is applied to the object. *)
Record question F := Question { contacts : list (contact F); applied : vector F }.

Definition add (u v : vector R) :=
  Vector (along_x u + along_x v) (along_y u + along_y v) (turn u + turn v).

Definition times (a : R) (v : vector R) := Vector (a * along_x v) (a * along_y v) (a * turn v).

Definition dot (u v : vector R) :=
  along_x u * along_x v + along_y u * along_y v + turn u * turn v.

Definition zero := Vector 0 0 0.

(** The wrench (f, p x f) of the force f at the contact point p. *)
Definition wrench (c : contact R) (f_x f_y : R) :=
  Vector f_x f_y (point_x c * f_y - point_y c * f_x).

(** The wrenches of a unit force along the normal and along the tangent. By duality, [dot (N c) d]
    and [dot (T c) d] are the displacements of the contact point under the motion [d]. *)
Definition N (c : contact R) := wrench c (normal_x c) (normal_y c).
Definition T (c : contact R) := wrench c (- normal_y c) (normal_x c).

(** What a contact can do under the motion [d]: unilateral spring (it may let go), friction cone,
    maximum dissipation. *)
Definition law (d : vector R) (c : contact R) (force : R * R) :=
  let (c_n, c_t) := force in
  c_n = Rmax 0 (preload c - stiffness c * dot (N c) d) /\
  Rabs c_t <= friction c * c_n /\
  (dot (T c) d > 0 -> c_t = - friction c * c_n) /\
  (dot (T c) d < 0 -> c_t = friction c * c_n).

(** The sum of the wrenches of all contacts. *)
Fixpoint total (cs : list (contact R)) (forces : list (R * R)) :=
  match cs, forces with
  | c :: cs, (c_n, c_t) :: forces =>
      add (add (times c_n (N c)) (times c_t (T c))) (total cs forces)
  | _, _ => zero
  end.

(** One force for each contact, as the law has it; together they balance the applied wrench. *)
Definition equilibrium (g : question R) (d : vector R) (forces : list (R * R)) :=
  Forall2 (law d) (contacts g) forces /\ add (total (contacts g) forces) (applied g) = zero.

(** Documents have rational numbers, and are about real motions and forces. *)
Definition real_vector (v : vector Q) : vector R :=
  Vector (Q2R (along_x v)) (Q2R (along_y v)) (Q2R (turn v)).

Definition real_contact (c : contact Q) : contact R :=
  Contact (Q2R (point_x c)) (Q2R (point_y c)) (Q2R (normal_x c)) (Q2R (normal_y c))
    (Q2R (friction c)) (Q2R (stiffness c)) (Q2R (preload c)).

Definition real_question (g : question Q) : question R :=
  Question (map real_contact (contacts g)) (real_vector (applied g)).

Definition real_forces (forces : list (Q * Q)) : list (R * R) :=
  map (fun f => (Q2R (fst f), Q2R (snd f))) forces.
