(** The law of passive frictional contacts in space, over the real numbers.

    This file is the statement. Conventions: one object frame; a contact's normal points INTO the
    object, its tangents are the one that is given and the normal times that; forces act ON the
    object. The cone of friction is round. *)

Require Import Reals QArith Qreals List.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Record vector3 F := Vector3 { x_of : F; y_of : F; z_of : F }.

(** A wrench (force, torque), or a small motion (translation, rotation). *)
Record screw F := Screw { along : vector3 F; about : vector3 F }.

Record contact3 F := Contact3 {
  point3 : vector3 F;
  normal3 : vector3 F;   (* unit *)
  tangent3 : vector3 F;  (* unit, at a right angle to the normal *)
  friction3 : F;         (* coefficient mu of Coulomb's law *)
  stiffness3 : F;        (* k of the normal spring *)
  preload3 : F           (* q, the force of the spring before any motion *)
}.

(** The contacts of a grasp and the wrench that is applied to the object. *)
Record question3 F := Question3 { contacts3 : list (contact3 F); applied3 : screw F }.

Definition dot3 (a b : vector3 R) := x_of a * x_of b + y_of a * y_of b + z_of a * z_of b.

Definition cross (a b : vector3 R) := Vector3
  (y_of a * z_of b - z_of a * y_of b) (z_of a * x_of b - x_of a * z_of b)
  (x_of a * y_of b - y_of a * x_of b).

(** The work of a wrench on a motion. *)
Definition work (w d : screw R) := dot3 (along w) (along d) + dot3 (about w) (about d).

(** The wrench (f, p x f) of the force f at the contact point p. *)
Definition wrench3 (c : contact3 R) (f : vector3 R) := Screw f (cross (point3 c) f).

(** The wrenches of unit forces along the normal and the two tangents. By duality, [work (N c) d]
    is the displacement of the contact point under the motion [d] along the normal, and so on. *)
Definition N (c : contact3 R) := wrench3 c (normal3 c).
Definition T1 (c : contact3 R) := wrench3 c (tangent3 c).
Definition T2 (c : contact3 R) := wrench3 c (cross (normal3 c) (tangent3 c)).

(** What a contact can do under the motion [d]: unilateral spring (it may let go), round friction
    cone, maximum dissipation: where it slips, friction is opposite to the slip, and as large as
    the cone lets it. *)
Definition law3 (d : screw R) (c : contact3 R) (force : R * R * R) :=
  let '(c_n, c_1, c_2) := force in
  let limit := friction3 c * c_n in
  let s_1 := work (T1 c) d in
  let s_2 := work (T2 c) d in
  c_n = Rmax 0 (preload3 c - stiffness3 c * work (N c) d) /\
  c_1 * c_1 + c_2 * c_2 <= limit * limit /\
  (s_1 <> 0 \/ s_2 <> 0 -> c_1 * c_1 + c_2 * c_2 = limit * limit /\
    exists t, 0 <= t /\ c_1 = - t * s_1 /\ c_2 = - t * s_2).

Definition add3 (a b : vector3 R) :=
  Vector3 (x_of a + x_of b) (y_of a + y_of b) (z_of a + z_of b).
Definition times3 (t : R) (a : vector3 R) := Vector3 (t * x_of a) (t * y_of a) (t * z_of a).
Definition plus (v w : screw R) := Screw (add3 (along v) (along w)) (add3 (about v) (about w)).
Definition scaled (t : R) (w : screw R) := Screw (times3 t (along w)) (times3 t (about w)).
Definition nothing := Screw (Vector3 0 0 0) (Vector3 0 0 0).

(** The sum of the wrenches of all contacts. *)
Fixpoint total3 (cs : list (contact3 R)) (forces : list (R * R * R)) :=
  match cs, forces with
  | c :: cs, (c_n, c_1, c_2) :: forces =>
      plus (plus (scaled c_n (N c)) (plus (scaled c_1 (T1 c)) (scaled c_2 (T2 c))))
        (total3 cs forces)
  | _, _ => nothing
  end.

(** One force for each contact, as the law has it; together they balance the applied wrench. *)
Definition equilibrium3 (g : question3 R) (d : screw R) (forces : list (R * R * R)) :=
  Forall2 (law3 d) (contacts3 g) forces /\ plus (total3 (contacts3 g) forces) (applied3 g) = nothing.

(** Documents have rational numbers, and are about real motions and forces. *)
Definition real_vector3 (a : vector3 Q) := Vector3 (Q2R (x_of a)) (Q2R (y_of a)) (Q2R (z_of a)).
Definition real_screw (w : screw Q) := Screw (real_vector3 (along w)) (real_vector3 (about w)).

Definition real_contact3 (c : contact3 Q) : contact3 R :=
  Contact3 (real_vector3 (point3 c)) (real_vector3 (normal3 c)) (real_vector3 (tangent3 c))
    (Q2R (friction3 c)) (Q2R (stiffness3 c)) (Q2R (preload3 c)).

Definition real_question3 (g : question3 Q) : question3 R :=
  Question3 (map real_contact3 (contacts3 g)) (real_screw (applied3 g)).

Definition real_forces3 (forces : list (Q * Q * Q)) : list (R * R * R) :=
  map (fun f => let '(n, a, b) := f in (Q2R n, Q2R a, Q2R b)) forces.
