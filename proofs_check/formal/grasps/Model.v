(** The law of passive frictional contacts in R^n, over the real numbers.

    This file is the statement: whoever believes the theorem has to read it, and nothing else.
    Conventions: one frame; a contact's normal points INTO the body on which its force acts. In the
    plane, counter-clockwise is positive, and the tangent is the normal turned by +90 degrees. In
    space the tangents are the one that is given and the normal times that; cones are round. *)

Require Import Reals QArith Qreals List.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The law *)

(** Vectors of R^n are lists; entries that are left out at the end are 0. *)
Fixpoint dot (v w : list R) : R :=
  match v, w with x :: v, y :: w => x * y + dot v w | _, _ => 0 end.

Fixpoint add (v w : list R) : list R :=
  match v, w with
  | x :: v, y :: w => x + y :: add v w
  | [], w => w
  | v, [] => v
  end.

Definition times (t : R) (v : list R) : list R := map (Rmult t) v.

Record values F := Values {
  friction : F;   (* coefficient mu of Coulomb's law *)
  stiffness : F;  (* k of the normal spring *)
  preload : F     (* q, the force of the spring before any motion *)
}.

(** A contact: the generalised forces that a unit force along its normal and along its tangents is,
    in R^n. Where there is one tangent, the second is []. By duality [dot (normal c) d] is the
    displacement at the contact along the normal under the motion [d], and so on. *)
Record row F := Row {
  normal : list F; tangent1 : list F; tangent2 : list F; values_of : values F }.

(** What a contact can do under the motion [d]: unilateral spring (it may let go), friction cone,
    maximum dissipation: where it slips, friction is opposite to the slip, and as large as the cone
    lets it. *)
Definition law (d : list R) (c : row R) (force : R * R * R) :=
  let '(c_n, c_1, c_2) := force in
  let limit := friction (values_of c) * c_n in
  let s_1 := dot (tangent1 c) d in
  let s_2 := dot (tangent2 c) d in
  c_n = Rmax 0 (preload (values_of c) - stiffness (values_of c) * dot (normal c) d) /\
  0 <= limit /\ c_1 * c_1 + c_2 * c_2 <= limit * limit /\
  (s_1 <> 0 \/ s_2 <> 0 -> c_1 * c_1 + c_2 * c_2 = limit * limit /\
    exists t, 0 <= t /\ c_1 = - t * s_1 /\ c_2 = - t * s_2).

(** The sum of all forces of the contacts. *)
Fixpoint total (cs : list (row R)) (forces : list (R * R * R)) : list R :=
  match cs, forces with
  | c :: cs, (c_n, c_1, c_2) :: forces =>
      add (add (times c_n (normal c)) (add (times c_1 (tangent1 c)) (times c_2 (tangent2 c))))
        (total cs forces)
  | _, _ => []
  end.

(** A motion in R^n, and one force for each contact, as the law has it; together they balance the
    load. *)
Definition equilibrium (n : nat) (cs : list (row R)) (load d : list R) (forces : list (R * R * R)) :=
  length d = n /\ Forall2 (law d) cs forces /\
  Forall (fun x => x = 0) (add (total cs forces) load).

(** * Grasps and assemblies *)

(** A contact in the plane. *)
Record contact F := Contact {
  point_x : F; point_y : F; normal_x : F; normal_y : F; values2 : values F }.

(** A contact in space: its normal and its tangent are unit, at a right angle. *)
Record vector3 F := Vector3 { x_of : F; y_of : F; z_of : F }.
Record contact3 F := Contact3 {
  point3 : vector3 F; normal3 : vector3 F; tangent3 : vector3 F; values3 : values F }.

(** A contact of two bodies in the plane, whose force acts on the first and, in the other
    direction, on the second; [None] is the ground, which is fixed. Bodies are counted from 0. *)
Record joint F := Joint { body_a : nat; body_b : option nat; touch : contact F }.

(** A wrench is (force x, y, torque), in space (force x, y, z, torque x, y, z); on several bodies
    one after the other. *)
Inductive question F :=
| InPlane (contacts : list (contact F)) (load : list F)
| InSpace (contacts : list (contact3 F)) (load : list F)
| OfBodies (count : nat) (joints : list (joint F)) (load : list F).

(** The wrench (f, p x f) of the force f at the contact point p. *)
Definition wrench (c : contact R) (f_x f_y : R) : list R :=
  [f_x; f_y; point_x c * f_y - point_y c * f_x].

Definition planar_row (c : contact R) : row R :=
  Row (wrench c (normal_x c) (normal_y c)) (wrench c (- normal_y c) (normal_x c)) [] (values2 c).

Definition cross (a b : vector3 R) := Vector3
  (y_of a * z_of b - z_of a * y_of b) (z_of a * x_of b - x_of a * z_of b)
  (x_of a * y_of b - y_of a * x_of b).

Definition wrench3 (c : contact3 R) (f : vector3 R) : list R :=
  let m := cross (point3 c) f in [x_of f; y_of f; z_of f; x_of m; y_of m; z_of m].

Definition spatial_row (c : contact3 R) : row R :=
  Row (wrench3 c (normal3 c)) (wrench3 c (tangent3 c)) (wrench3 c (cross (normal3 c) (tangent3 c)))
    (values3 c).

(** In the numbers of the bodies: a wrench on the first one, and its opposite on the second. *)
Definition at_body (i : nat) (w : list R) : list R := repeat 0 (3 * i) ++ w.
Definition on_bodies (j : joint R) (w : list R) : list R :=
  match body_b j with
  | None => at_body (body_a j) w
  | Some b => add (at_body (body_a j) w) (times (-1) (at_body b w))
  end.

Definition joint_row (j : joint R) : row R :=
  let c := planar_row (touch j) in
  Row (on_bodies j (normal c)) (on_bodies j (tangent1 c)) [] (values_of c).

Definition dimension F (g : question F) : nat :=
  match g with InPlane _ _ => 3 | InSpace _ _ => 6 | OfBodies b _ _ => 3 * b end.

Definition load_of F (g : question F) : list F :=
  match g with InPlane _ w | InSpace _ w | OfBodies _ _ w => w end.

Definition rows_of (g : question R) : list (row R) :=
  match g with
  | InPlane cs _ => map planar_row cs
  | InSpace cs _ => map spatial_row cs
  | OfBodies _ js _ => map joint_row js
  end.

Definition balances (g : question R) (d : list R) (forces : list (R * R * R)) :=
  equilibrium (dimension g) (rows_of g) (load_of g) d forces.

(** Documents have rational numbers, and are about real motions and forces. *)
Definition real_values (v : values Q) : values R :=
  Values (Q2R (friction v)) (Q2R (stiffness v)) (Q2R (preload v)).

Definition real_contact (c : contact Q) : contact R :=
  Contact (Q2R (point_x c)) (Q2R (point_y c)) (Q2R (normal_x c)) (Q2R (normal_y c))
    (real_values (values2 c)).

Definition real_vector3 (a : vector3 Q) := Vector3 (Q2R (x_of a)) (Q2R (y_of a)) (Q2R (z_of a)).

Definition real_contact3 (c : contact3 Q) : contact3 R :=
  Contact3 (real_vector3 (point3 c)) (real_vector3 (normal3 c)) (real_vector3 (tangent3 c))
    (real_values (values3 c)).

Definition real_joint (j : joint Q) : joint R :=
  Joint (body_a j) (body_b j) (real_contact (touch j)).

Definition reals (v : list Q) : list R := map Q2R v.

Definition real_question (g : question Q) : question R :=
  match g with
  | InPlane cs w => InPlane (map real_contact cs) (reals w)
  | InSpace cs w => InSpace (map real_contact3 cs) (reals w)
  | OfBodies b js w => OfBodies b (map real_joint js) (reals w)
  end.

Definition real_forces (forces : list (Q * Q * Q)) : list (R * R * R) :=
  map (fun f => let '(n, a, b) := f in (Q2R n, Q2R a, Q2R b)) forces.
