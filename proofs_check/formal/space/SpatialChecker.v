(** The checker for grasps in space, in rational numbers that are kept in lowest terms. *)

Require Import ZArith QArith List Bool.
Require Import SpatialModel.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * Proofs, as they stand in a document *)

(** Contacts are counted from 0; directions are along the two tangents of a contact. *)
Definition direction := (Q * Q)%type.

Inductive tree3 :=
| Leaf3 (virtual_motion : screw Q) (multipliers : list (Z * (Q * Q * Q)))  (* alpha, h_1, h_2 *)
| Attachment3 (contact : Z) (detached attached : tree3)
(* Each sector goes from its direction to that of the next one, the last to the first. *)
| Directions (contact : Z) (stick : tree3) (sectors : list (direction * tree3))
| Cut (contact : Z) (middle : direction) (first second : tree3).

Inductive proof3 :=
| Resisted3 (motion : screw Q) (forces : list (Q * Q * Q))
| NotResisted3 (tree : tree3).

(** * Rational numbers *)

Definition lowest (q : Q) : Q :=
  let d := Z.gcd (Qnum q) (Zpos (Qden q)) in Qmake (Qnum q / d) (Z.to_pos (Zpos (Qden q) / d)).

Definition qplus (a b : Q) := lowest (a + b).
Definition qtimes (a b : Q) := lowest (a * b).
Definition qminus (a b : Q) := lowest (a - b).
Definition qzero (a : Q) : bool := Qnum a =? 0.
Definition qnonneg (a : Q) : bool := 0 <=? Qnum a.
Definition qpositive (a : Q) : bool := 0 <? Qnum a.
Definition qleb (a b : Q) : bool := Qle_bool a b.

Definition qdot3 (a b : vector3 Q) : Q :=
  qplus (qplus (qtimes (x_of a) (x_of b)) (qtimes (y_of a) (y_of b))) (qtimes (z_of a) (z_of b)).
Definition qcross (a b : vector3 Q) : vector3 Q := Vector3
  (qminus (qtimes (y_of a) (z_of b)) (qtimes (z_of a) (y_of b)))
  (qminus (qtimes (z_of a) (x_of b)) (qtimes (x_of a) (z_of b)))
  (qminus (qtimes (x_of a) (y_of b)) (qtimes (y_of a) (x_of b))).
Definition qwork (w d : screw Q) : Q := qplus (qdot3 (along w) (along d)) (qdot3 (about w) (about d)).
Definition qadd3 (a b : vector3 Q) : vector3 Q :=
  Vector3 (qplus (x_of a) (x_of b)) (qplus (y_of a) (y_of b)) (qplus (z_of a) (z_of b)).
Definition qtimes3 (t : Q) (a : vector3 Q) : vector3 Q :=
  Vector3 (qtimes t (x_of a)) (qtimes t (y_of a)) (qtimes t (z_of a)).
Definition qsum (v w : screw Q) : screw Q :=
  Screw (qadd3 (along v) (along w)) (qadd3 (about v) (about w)).
Definition qscaled (t : Q) (w : screw Q) : screw Q :=
  Screw (qtimes3 t (along w)) (qtimes3 t (about w)).
Definition qnothing : screw Q := Screw (Vector3 0 0 0)%Q (Vector3 0 0 0)%Q.
Definition qvanishes (w : screw Q) : bool :=
  qzero (x_of (along w)) && qzero (y_of (along w)) && qzero (z_of (along w)) &&
  qzero (x_of (about w)) && qzero (y_of (about w)) && qzero (z_of (about w)).

(** A contact with the wrenches of unit forces along its normal and its tangents. *)
Record body := Body {
  n_wrench : screw Q; t_wrench : screw Q; u_wrench : screw Q; mu_of : Q; k_of : Q; q_of : Q }.

Definition body_of (c : contact3 Q) : body :=
  let unit f := Screw f (qcross (point3 c) f) in
  Body (unit (normal3 c)) (unit (tangent3 c)) (unit (qcross (normal3 c) (tangent3 c)))
    (friction3 c) (stiffness3 c) (preload3 c).

(** * Directions *)

(** Positive where the second is less than half a turn counter-clockwise of the first. *)
Definition qturn (a b : direction) : Q :=
  qminus (qtimes (fst a) (snd b)) (qtimes (snd a) (fst b)).
Definition qdot2 (a b : direction) : Q :=
  qplus (qtimes (fst a) (fst b)) (qtimes (snd a) (snd b)).

(** Whether [room] is at least [mu] times the length of [b]. *)
Definition beyond_disc (room mu : Q) (b : direction) : bool :=
  qnonneg room && qleb (qtimes (qtimes mu mu) (qdot2 b b)) (qtimes room room).

(** Whether [room] is at least [mu] times the product of [b] and the unit vector along [e]. *)
Definition beyond_end (room mu : Q) (b e : direction) : bool :=
  let y := qdot2 e b in
  let left := qtimes (qtimes room room) (qdot2 e e) in
  let right := qtimes (qtimes mu mu) (qtimes y y) in
  if qpositive y then qnonneg room && qleb right left
  else qnonneg room || qleb left right.

(** * Leaves *)

Inductive state3 := Undecided3 | Detached3 | Attached3 | Stick3 | Sector (u v : direction).

(** Whether alpha and h are allowed; the contact does [a] and [b] on the virtual motion. *)
Definition allowed (s : state3) (mu a : Q) (b : direction) (alpha : Q) (h : direction) : bool :=
  let room := qminus a alpha in
  let none := qzero (fst h) && qzero (snd h) in
  match s with
  | Undecided3 => qnonneg alpha && none && beyond_disc room mu b
  | Detached3 => qnonneg alpha && none
  | Attached3 => none && beyond_disc room mu b
  | Stick3 => beyond_disc room mu b
  | Sector u v =>
      qleb (qdot2 h u) 0 && qleb (qdot2 h v) 0 &&
      if qnonneg (qturn u b) && qnonneg (qturn b v) then beyond_disc room mu b
      else beyond_end room mu b u && beyond_end room mu b v
  end.

Definition given3 (i : Z) (multipliers : list (Z * (Q * Q * Q))) : Q * Q * Q :=
  match find (fun m => fst m =? i) multipliers with Some m => snd m | None => (0, 0, 0)%Q end.

(** The work of all contacts at least, as a number and what depends on the motion; [None] where a
    multiplier is not allowed. *)
Fixpoint least (i : Z) (bodies : list body) (states : list state3) (l : screw Q)
    (multipliers : list (Z * (Q * Q * Q))) : option (Q * screw Q) :=
  match bodies, states with
  | c :: bodies, s :: states =>
      let '(alpha, h_1, h_2) := given3 i multipliers in
      let b := (qwork (t_wrench c) l, qwork (u_wrench c) l) in
      if allowed s (mu_of c) (qwork (n_wrench c) l) b alpha (h_1, h_2) then
        match least (i + 1) bodies states l multipliers with
        | Some (number, rest) =>
            if qzero alpha && qzero h_1 && qzero h_2 then Some (number, rest)
            else
              Some (qplus (qtimes alpha (q_of c)) number,
                qsum (qsum (qscaled (qtimes (Qopp alpha) (k_of c)) (n_wrench c))
                  (qsum (qscaled h_1 (t_wrench c)) (qscaled h_2 (u_wrench c)))) rest)
        | None => None
        end
      else None
  | [], [] => Some (0%Q, qnothing)
  | _, _ => None
  end.

Definition leaf3_holds (bodies : list body) (load : screw Q) (states : list state3) (l : screw Q)
    (multipliers : list (Z * (Q * Q * Q))) : bool :=
  match least 0 bodies states l multipliers with
  | Some (number, rest) => qvanishes rest && qpositive (qplus (qwork load l) number)
  | None => false
  end.

(** * Trees *)

Fixpoint state3_of (i : Z) (states : list state3) : option state3 :=
  match states with
  | [] => None
  | s :: rest => if i =? 0 then Some s else state3_of (i - 1) rest
  end.

Fixpoint set_state3 (i : Z) (s : state3) (states : list state3) : list state3 :=
  match states with
  | [] => []
  | t :: rest => if i =? 0 then s :: rest else t :: set_state3 (i - 1) s rest
  end.

Fixpoint refutes3 (bodies : list body) (load : screw Q) (states : list state3) (t : tree3)
    {struct t} : bool :=
  match t with
  | Leaf3 l multipliers => leaf3_holds bodies load states l multipliers
  | Attachment3 i detached attached =>
      match state3_of i states with
      | Some Undecided3 =>
          refutes3 bodies load (set_state3 i Detached3 states) detached &&
          refutes3 bodies load (set_state3 i Attached3 states) attached
      | _ => false
      end
  | Directions i stick sectors =>
      match state3_of i states, sectors with
      | Some Attached3, (first, _) :: _ =>
          refutes3 bodies load (set_state3 i Stick3 states) stick &&
          (fix all (sectors : list (direction * tree3)) : bool :=
             match sectors with
             | [] => true
             | (u, t) :: rest =>
                 let v := match rest with (v, _) :: _ => v | [] => first end in
                 qpositive (qturn u v) &&
                 refutes3 bodies load (set_state3 i (Sector u v) states) t && all rest
             end) sectors
      | _, _ => false
      end
  | Cut i middle first second =>
      match state3_of i states with
      | Some (Sector u v) =>
          qpositive (qturn u middle) && qpositive (qturn middle v) &&
          refutes3 bodies load (set_state3 i (Sector u middle) states) first &&
          refutes3 bodies load (set_state3 i (Sector middle v) states) second
      | _ => false
      end
  end.

(** * A motion and forces *)

Definition obeys3 (c : body) (d : screw Q) (force : Q * Q * Q) : bool :=
  let '(c_n, c_1, c_2) := force in
  let e := qminus (q_of c) (qtimes (k_of c) (qwork (n_wrench c) d)) in
  let s := (qwork (t_wrench c) d, qwork (u_wrench c) d) in
  let f := (c_1, c_2) in
  let limit := qtimes (mu_of c) c_n in
  Qeq_bool c_n (if qnonneg e then e else 0%Q) &&
  qleb (qdot2 f f) (qtimes limit limit) &&
  ((qzero (fst s) && qzero (snd s)) ||
   qzero (qturn f s) && qleb (qdot2 f s) 0 && Qeq_bool (qdot2 f f) (qtimes limit limit)).

Fixpoint all_obey3 (bodies : list body) (d : screw Q) (forces : list (Q * Q * Q)) : bool :=
  match bodies, forces with
  | c :: bodies, f :: forces => obeys3 c d f && all_obey3 bodies d forces
  | [], [] => true
  | _, _ => false
  end.

Fixpoint sum_of (bodies : list body) (forces : list (Q * Q * Q)) : screw Q :=
  match bodies, forces with
  | c :: bodies, (c_n, c_1, c_2) :: forces =>
      qsum (qsum (qscaled c_n (n_wrench c))
        (qsum (qscaled c_1 (t_wrench c)) (qscaled c_2 (u_wrench c)))) (sum_of bodies forces)
  | _, _ => qnothing
  end.

(** * The checker *)

Definition check3 (g : question3 Q) (p : proof3) : bool :=
  let bodies := map body_of (contacts3 g) in
  match p with
  | Resisted3 motion forces =>
      all_obey3 bodies motion forces && qvanishes (qsum (sum_of bodies forces) (applied3 g))
  | NotResisted3 t =>
      forallb (fun c => qnonneg (mu_of c)) bodies &&
      refutes3 bodies (applied3 g) (map (fun _ => Undecided3) bodies) t
  end.
