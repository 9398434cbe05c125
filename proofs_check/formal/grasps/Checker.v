(** The checker: a question, a proof, yes or no, in rational numbers. *)

Require Import ZArith QArith List Bool.
Require Import Model Rationals.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * Proofs *)

(** Contacts and generators are counted from 0; directions are along the tangents of a contact. *)
Definition direction := (Q * Q)%type.

Inductive tree :=
(* Of some contacts (alpha, (h_1, h_2)). *)
| Leaf (virtual_motion : list Q) (multipliers : list (Z * (Q * Q * Q)))
(* The point p g_j + q g_k replaces g_j in the first part, g_k in the second. *)
| Edge (j k : nat) (p q : Q) (first second : tree)
| Attachment (contact : Z) (detached attached : tree)
(* Of a contact with one tangent. *)
| Slip (contact : Z) (stick plus minus : tree)
(* Each sector goes from its direction to that of the next one, the last to the first. *)
| Directions (contact : Z) (stick : tree) (sectors : list (direction * tree))
| Cut (contact : Z) (middle : direction) (first second : tree).

Inductive proof :=
| Resisted (motion : list Q) (forces : list (Q * Q * Q))
| NotResisted (tree : tree)
(* Of an assembly: for each body, whether it is in the part. *)
| NotResistedPart (part : list bool) (tree : tree).

(** * Vectors *)

Fixpoint qdot (v w : list Q) : Q :=
  match v, w with x :: v, y :: w => qplus (qtimes x y) (qdot v w) | _, _ => 0%Q end.

Fixpoint qadd (v w : list Q) : list Q :=
  match v, w with
  | x :: v, y :: w => qplus x y :: qadd v w
  | [], w => w
  | v, [] => v
  end.

Definition qscaled (t : Q) (v : list Q) : list Q := map (qtimes t) v.
Definition qvanishes (v : list Q) : bool := forallb qzero v.

(** * Contacts as rows *)

Definition qplanar_row (c : contact Q) : row Q :=
  let wrench f_x f_y :=
    [f_x; f_y; qminus (qtimes (point_x c) f_y) (qtimes (point_y c) f_x)] in
  Row (wrench (normal_x c) (normal_y c)) (wrench (Qopp (normal_y c)) (normal_x c)) []
    (values2 c).

Definition qcross (a b : vector3 Q) : vector3 Q := Vector3
  (qminus (qtimes (y_of a) (z_of b)) (qtimes (z_of a) (y_of b)))
  (qminus (qtimes (z_of a) (x_of b)) (qtimes (x_of a) (z_of b)))
  (qminus (qtimes (x_of a) (y_of b)) (qtimes (y_of a) (x_of b))).

Definition qspatial_row (c : contact3 Q) : row Q :=
  let wrench f :=
    let m := qcross (point3 c) f in [x_of f; y_of f; z_of f; x_of m; y_of m; z_of m] in
  Row (wrench (normal3 c)) (wrench (tangent3 c)) (wrench (qcross (normal3 c) (tangent3 c)))
    (values3 c).

Definition qat_body (i : nat) (w : list Q) : list Q := repeat 0%Q (3 * i) ++ w.
Definition qon_bodies (j : joint Q) (w : list Q) : list Q :=
  match body_b j with
  | None => qat_body (body_a j) w
  | Some b => qadd (qat_body (body_a j) w) (qscaled (-1) (qat_body b w))
  end.

Definition qjoint_row (j : joint Q) : row Q :=
  let c := qplanar_row (touch j) in
  Row (qon_bodies j (normal c)) (qon_bodies j (tangent1 c)) [] (values_of c).

Definition qrows_of (g : question Q) : list (row Q) :=
  match g with
  | InPlane cs _ => map qplanar_row cs
  | InSpace cs _ => map qspatial_row cs
  | OfBodies _ js _ => map qjoint_row js
  end.

(** A contact with the linear forms that are its spring and its slip at the motion d, on (1, d). *)
Record body := Body { row_at : row Q; spring : list Q; slip1 : list Q; slip2 : list Q }.

Definition body_of (c : row Q) : body :=
  let v := values_of c in
  Body c (preload v :: qscaled (Qopp (stiffness v)) (normal c)) (0%Q :: tangent1 c)
    (0%Q :: tangent2 c).

Definition mu_of (c : body) : Q := friction (values_of (row_at c)).

Definition one_tangent (c : body) : bool :=
  match tangent2 (row_at c) with [] => true | _ => false end.

(** * Directions of slip *)

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

Inductive state :=
  Undecided | Detached | Attached | Stick | SlipPlus | SlipMinus | Sector (u v : direction).

(** What is known of the direction in which a contact slips, if it does. *)
Inductive way := Anywhere | Forth | Back | Within (u v : direction).

(** [gens] generate the region of the motions (1, d). *)
Definition way_of (c : body) (s : state) (gens : list (list Q)) : way :=
  match s with
  | SlipPlus => Forth
  | SlipMinus => Back
  | Sector u v => Within u v
  | Undecided | Attached =>
      if negb (one_tangent c) then Anywhere
      else if forallb (fun g => qpositive (qdot (slip1 c) g)) gens then Forth
      else if forallb (fun g => qpositive (Qopp (qdot (slip1 c) g))) gens then Back
      else Anywhere
  | _ => Anywhere
  end.

(** Whether for each unit of normal force the contact does at least [alpha] on a virtual motion
    where [a] is along its normal and [b] along its tangents. *)
Definition below (alpha : Q) (w : way) (mu a : Q) (b : direction) : bool :=
  let room := qminus a alpha in
  match w with
  | Anywhere => beyond_disc room mu b
  | Forth => qleb (qtimes mu (fst b)) room
  | Back => qleb (qtimes (Qopp mu) (fst b)) room
  | Within u v =>
      if qnonneg (qturn u b) && qnonneg (qturn b v) then beyond_disc room mu b
      else beyond_end room mu b u && beyond_end room mu b v
  end.

(** The largest such number, of one tangent. *)
Definition kappa (w : way) (mu a : Q) (b : direction) : Q :=
  qminus a (qtimes mu
    match w with
    | Forth => fst b
    | Back => Qopp (fst b)
    | _ => Qmake (Z.abs (Qnum (fst b))) (Qden (fst b))
    end).

(** What a contact does at least: a linear form, or [kappa max(0, e)] of its spring e. *)
Inductive bound := Linear (form : list Q) | Pressed (kappa : Q) (spring : list Q).

(** With multipliers, if they are allowed. *)
Definition bound_with (c : body) (s : state) (gens : list (list Q)) (l : list Q)
    (multipliers : Q * Q * Q) : option bound :=
  let '(alpha, h_1, h_2) := multipliers in
  let none := qzero h_1 && qzero h_2 in
  let under := below alpha (way_of c s gens) (mu_of c) (qdot (normal (row_at c)) l)
    (qdot (tangent1 (row_at c)) l, qdot (tangent2 (row_at c)) l) in
  let allowed :=
    match s with
    | Undecided => qnonneg alpha && none && under
    | Detached => qnonneg alpha && none
    | Attached => none && under
    | Stick => under
    | SlipPlus => qleb h_1 0 && under
    | SlipMinus => qleb 0 h_1 && under
    | Sector u v => qleb (qdot2 (h_1, h_2) u) 0 && qleb (qdot2 (h_1, h_2) v) 0 && under
    end in
  if negb allowed then None
  else if qzero alpha && none then Some (Linear [])
  else Some (Linear (qadd (qscaled alpha (spring c))
    (qadd (qscaled h_1 (slip1 c)) (qscaled h_2 (slip2 c))))).

(** Without multipliers; with two tangents they are 0. *)
Definition bound_without (c : body) (s : state) (gens : list (list Q)) (l : list Q) :
    option bound :=
  let k := kappa (way_of c s gens) (mu_of c) (qdot (normal (row_at c)) l)
    (qdot (tangent1 (row_at c)) l, 0%Q) in
  if negb (one_tangent c) then bound_with c s gens l (0, 0, 0)%Q
  else
    match s with
    | Sector _ _ => None
    | Detached => Some (Linear [])
    | _ =>
        if forallb (fun g => qnonneg (qdot (spring c) g)) gens then
          Some (Linear (qscaled k (spring c)))
        else if qnonneg k then Some (Linear [])
        else Some (Pressed k (spring c))
    end.

Definition given (i : Z) (multipliers : list (Z * (Q * Q * Q))) : option (Q * Q * Q) :=
  match find (fun m => fst m =? i) multipliers with Some m => Some (snd m) | None => None end.

(** The bounds of the contacts from number [i] on, added up: linear forms, and the others. *)
Fixpoint least (i : Z) (bodies : list body) (states : list state) (gens : list (list Q))
    (l : list Q) (multipliers : list (Z * (Q * Q * Q))) : option (list Q * list (Q * list Q)) :=
  match bodies, states with
  | c :: bodies, s :: states =>
      match
        match given i multipliers with
        | Some m => bound_with c s gens l m
        | None => bound_without c s gens l
        end, least (i + 1) bodies states gens l multipliers
      with
      | Some (Linear form), Some (sum, pressed) => Some (qadd form sum, pressed)
      | Some (Pressed k e), Some (sum, pressed) => Some (sum, (k, e) :: pressed)
      | _, _ => None
      end
  | [], [] => Some ([], [])
  | _, _ => None
  end.

Fixpoint at_generator (pressed : list (Q * list Q)) (g : list Q) : Q :=
  match pressed with
  | [] => 0%Q
  | (k, e) :: pressed =>
      let x := qdot e g in
      qplus (if qpositive x then qtimes k x else 0%Q) (at_generator pressed g)
  end.

Definition leaf_holds (bodies : list body) (load : list Q) (gens : list (list Q))
    (states : list state) (l : list Q) (multipliers : list (Z * (Q * Q * Q))) : bool :=
  match least 0 bodies states gens l multipliers with
  | None => false
  | Some (form, pressed) =>
      let sum := qadd [qdot load l] form in
      forallb
        (fun g =>
           let work := qplus (qdot sum g) (at_generator pressed g) in
           if qpositive (hd 0%Q g) then qpositive work else qnonneg work)
        gens
  end.

(** * Regions of the space of motions *)

Fixpoint axes (before n : nat) : list (list Q) :=
  match n with
  | O => []
  | S n => (repeat 0%Q before ++ [1%Q]) :: (repeat 0%Q before ++ [-1]%Q) :: axes (S before) n
  end.

(** Generators of all (g_0, d) with g_0 >= 0, which stand for the motions d / g_0. *)
Definition half_space (n : nat) : list (list Q) := [1%Q] :: axes 1 n.

(** A multiple with whole numbers that have no common divisor, where all are whole. *)
Definition primitive (v : list Q) : list Q :=
  let d := fold_right (fun q d => Z.gcd (Qnum q) d) 0 v in
  if 0 <? d then map (fun q => Qmake (Qnum q / d) (Qden q)) v else v.

Fixpoint replaced A (i : nat) (new : list A) (l : list A) : list A :=
  match l, i with
  | [], _ => []
  | _ :: l, O => new ++ l
  | x :: l, S i => x :: replaced i new l
  end.

(** * States of contacts *)

Fixpoint state_of (i : Z) (states : list state) : option state :=
  match states with
  | [] => None
  | s :: rest => if i =? 0 then Some s else state_of (i - 1) rest
  end.

Fixpoint set_state (i : Z) (s : state) (states : list state) : list state :=
  match states with
  | [] => []
  | t :: rest => if i =? 0 then s :: rest else t :: set_state (i - 1) s rest
  end.

Fixpoint has_one_tangent (i : Z) (bodies : list body) : bool :=
  match bodies with
  | [] => false
  | c :: rest => if i =? 0 then one_tangent c else has_one_tangent (i - 1) rest
  end.

(** * Trees *)

Fixpoint refutes (bodies : list body) (load : list Q) (gens : list (list Q)) (states : list state)
    (t : tree) {struct t} : bool :=
  match t with
  | Leaf l multipliers => leaf_holds bodies load gens states l multipliers
  | Edge j k p q first second =>
      match nth_error gens j, nth_error gens k with
      | Some g, Some h =>
          let v := primitive (qadd (qscaled p g) (qscaled q h)) in
          let new := if qvanishes v then [] else [v] in
          negb (Nat.eqb j k) && qpositive p && qpositive q &&
          refutes bodies load (replaced j new gens) states first &&
          refutes bodies load (replaced k new gens) states second
      | _, _ => false
      end
  | Attachment i detached attached =>
      match state_of i states with
      | Some Undecided =>
          refutes bodies load gens (set_state i Detached states) detached &&
          refutes bodies load gens (set_state i Attached states) attached
      | _ => false
      end
  | Slip i stick plus minus =>
      match state_of i states with
      | Some Attached =>
          has_one_tangent i bodies &&
          refutes bodies load gens (set_state i Stick states) stick &&
          refutes bodies load gens (set_state i SlipPlus states) plus &&
          refutes bodies load gens (set_state i SlipMinus states) minus
      | _ => false
      end
  | Directions i stick sectors =>
      match state_of i states, sectors with
      | Some Attached, (first, _) :: _ =>
          refutes bodies load gens (set_state i Stick states) stick &&
          (fix all (sectors : list (direction * tree)) : bool :=
             match sectors with
             | [] => true
             | (u, t) :: rest =>
                 let v := match rest with (v, _) :: _ => v | [] => first end in
                 qpositive (qturn u v) &&
                 refutes bodies load gens (set_state i (Sector u v) states) t && all rest
             end) sectors
      | _, _ => false
      end
  | Cut i middle first second =>
      match state_of i states with
      | Some (Sector u v) =>
          qpositive (qturn u middle) && qpositive (qturn middle v) &&
          refutes bodies load gens (set_state i (Sector u middle) states) first &&
          refutes bodies load gens (set_state i (Sector middle v) states) second
      | _ => false
      end
  end.

Definition refuted (n : nat) (cs : list (row Q)) (load : list Q) (t : tree) : bool :=
  let bodies := map body_of cs in
  forallb (fun c => qnonneg (mu_of c)) bodies &&
  refutes bodies load (half_space n) (map (fun _ => Undecided) bodies) t.

(** * A motion and forces *)

Definition obeys (c : row Q) (d : list Q) (force : Q * Q * Q) : bool :=
  let '(c_n, c_1, c_2) := force in
  let v := values_of c in
  let e := qminus (preload v) (qtimes (stiffness v) (qdot (normal c) d)) in
  let s := (qdot (tangent1 c) d, qdot (tangent2 c) d) in
  let f := (c_1, c_2) in
  let limit := qtimes (friction v) c_n in
  Qeq_bool c_n (if qnonneg e then e else 0%Q) && qnonneg limit &&
  qleb (qdot2 f f) (qtimes limit limit) &&
  ((qzero (fst s) && qzero (snd s)) ||
   qzero (qturn f s) && qleb (qdot2 f s) 0 && Qeq_bool (qdot2 f f) (qtimes limit limit)).

Fixpoint all_obey (cs : list (row Q)) (d : list Q) (forces : list (Q * Q * Q)) : bool :=
  match cs, forces with
  | c :: cs, f :: forces => obeys c d f && all_obey cs d forces
  | [], [] => true
  | _, _ => false
  end.

Fixpoint sum_of (cs : list (row Q)) (forces : list (Q * Q * Q)) : list Q :=
  match cs, forces with
  | c :: cs, (c_n, c_1, c_2) :: forces =>
      qadd (qadd (qscaled c_n (normal c))
        (qadd (qscaled c_1 (tangent1 c)) (qscaled c_2 (tangent2 c)))) (sum_of cs forces)
  | _, _ => []
  end.

Definition confirmed (n : nat) (cs : list (row Q)) (load d : list Q) (forces : list (Q * Q * Q)) :=
  Nat.eqb (length d) n && all_obey cs d forces && qvanishes (qadd (sum_of cs forces) load).

(** * Parts of assemblies *)

(** The contacts of a part with the rest, all of one body inside with one outside, as contacts of
    one body with the ground; and the whole load of the part. *)
Definition inside (part : list bool) (b : option nat) : bool :=
  match b with None => false | Some i => nth i part false end.

Definition crosses (part : list bool) (j : joint Q) : bool :=
  xorb (inside part (Some (body_a j))) (inside part (body_b j)).

(** The body inside, and what it touches. *)
Definition pair_of (part : list bool) (j : joint Q) : option nat * option nat :=
  if inside part (Some (body_a j)) then (Some (body_a j), body_b j)
  else (body_b j, Some (body_a j)).

Definition inward (part : list bool) (j : joint Q) : contact Q :=
  let c := touch j in
  if inside part (Some (body_a j)) then c
  else Contact (point_x c) (point_y c) (Qopp (normal_x c)) (Qopp (normal_y c)) (values2 c).

Fixpoint load_on (part : list bool) (load : list Q) : list Q :=
  match part with
  | [] => []
  | s :: part =>
      let rest := load_on part (skipn 3 load) in
      if s then qadd [nth 0 load 0; nth 1 load 0; nth 2 load 0]%Q rest else rest
  end.

Definition same_end (a b : option nat) : bool :=
  match a, b with
  | Some i, Some j => Nat.eqb i j
  | None, None => true
  | _, _ => false
  end.

Definition at_one_place (part : list bool) (js : list (joint Q)) : bool :=
  match js with
  | [] => true
  | first :: _ =>
      forallb (fun j => same_end (fst (pair_of part j)) (fst (pair_of part first)) &&
        same_end (snd (pair_of part j)) (snd (pair_of part first))) js
  end.

(** * The checker *)

Definition check (g : question Q) (p : proof) : bool :=
  match p, g with
  | Resisted d forces, _ => confirmed (dimension g) (qrows_of g) (load_of g) d forces
  | NotResisted t, _ => refuted (dimension g) (qrows_of g) (load_of g) t
  | NotResistedPart part t, OfBodies _ js load =>
      let between := filter (crosses part) js in
      at_one_place part between &&
      refuted 3 (map (fun j => qplanar_row (inward part j)) between) (load_on part load) t
  | _, _ => false
  end.
