(** The checker: a question, a proof, yes or no. All arithmetic is in integers. *)

Require Import ZArith QArith List Bool.
Require Import Model.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * Proofs, as they stand in a document *)

(** The corners of a simplicial cone are counted from 0 to 3, contacts from 0. *)
Inductive corner := Corner0 | Corner1 | Corner2 | Corner3.

Inductive tree :=
| Leaf (virtual_motion : vector Q) (multipliers : list (Z * (Q * Q)))  (* contact, (alpha, h) *)
| Orthants (ppp ppm pmp pmm mpp mpm mmp mmm : tree)
| Edge (j k : corner) (p q : Z) (first second : tree)
| Attachment (contact : Z) (detached attached : tree)
| Slip (contact : Z) (stick plus minus : tree).

Inductive proof :=
| Resisted (motion : vector Q) (forces : list (Q * Q))
| NotResisted (tree : tree).

(** * Integers instead of rationals *)

(** A common denominator of rationals, and the integer [d q] where [d] is one for [q]. *)
Definition common (l : list Q) : Z := fold_right (fun q d => Z.lcm (Zpos (Qden q)) d) 1 l.
Definition clear (d : Z) (q : Q) : Z := Qnum q * (d / Zpos (Qden q)).

(** A homogeneous motion (d_0, d), which stands for the motion d / d_0, or a linear form on them. *)
Record quad F := Quad { q0 : F; q1 : F; q2 : F; q3 : F }.

Definition eval (f g : quad Z) : Z := q0 f * q0 g + q1 f * q1 g + q2 f * q2 g + q3 f * q3 g.
Definition combine (p : Z) (f : quad Z) (q : Z) (g : quad Z) : quad Z :=
  Quad (p * q0 f + q * q0 g) (p * q1 f + q * q1 g) (p * q2 f + q * q2 g) (p * q3 f + q * q3 g).

Definition entries (v : vector Q) := [along_x v; along_y v; turn v].
Definition clear_vector (d d_0 : Z) (v : vector Q) : quad Z :=
  Quad d_0 (clear d (along_x v)) (clear d (along_y v)) (clear d (turn v)).

(** A contact in integers. With the positive integers [unit_n], [unit_e], [unit_mu] and D:
    - [normal] is unit_n N and [tangent] is unit_n T, without constant term;
    - [spring] is unit_e (q - k N . d);
    - [slope] is unit_mu mu;
    - [weight] times unit_n unit_e unit_mu is D, the same number for all contacts. *)
Record integer_contact := Integers {
  normal : quad Z; tangent : quad Z; spring : quad Z; slope : Z;
  unit_n : Z; unit_e : Z; unit_mu : Z; weight : Z }.

Definition units (c : integer_contact) : Z := unit_n c * unit_e c * unit_mu c.

Definition integers (c : contact Q) : integer_contact :=
  let d := common [point_x c; point_y c] in
  let u := common [normal_x c; normal_y c] in
  let e := common [stiffness c; preload c] in
  let x := clear d (point_x c) in let y := clear d (point_y c) in
  let a := clear u (normal_x c) in let b := clear u (normal_y c) in
  let n := Quad 0 (d * a) (d * b) (x * b - y * a) in
  let k := clear e (stiffness c) in
  {| normal := n;
     tangent := Quad 0 (d * - b) (d * a) (x * a - y * - b);
     spring := Quad (clear e (preload c) * (d * u)) (- k * q1 n) (- k * q2 n) (- k * q3 n);
     slope := Qnum (friction c);
     unit_n := d * u; unit_e := e * (d * u); unit_mu := Zpos (Qden (friction c));
     weight := 1 |}.

Definition with_weight (D : Z) (c : integer_contact) : integer_contact :=
  Integers (normal c) (tangent c) (spring c) (slope c)
    (unit_n c) (unit_e c) (unit_mu c) (D / units c).

(** A question in integers; [load] is [load_unit] times the wrench, [load_weight] is
    D / [load_unit]. *)
Record integer_question := Asked {
  bodies : list integer_contact; load : quad Z; load_unit : Z; load_weight : Z }.

Definition integer_form (g : question Q) : integer_question :=
  let cs := map integers (contacts g) in
  let u := common (entries (applied g)) in
  let D := fold_right (fun c d => Z.lcm (units c) d) u cs in
  Asked (map (with_weight D) cs) (clear_vector u 0 (applied g)) u (D / u).

(** * Leaves *)

Inductive state := Undecided | Detached | Attached | Stick | SlipPlus | SlipMinus.

(** What a contact adds at a generator: nothing, a linear form [alpha e + h s] of the spring e and
    the slip s, or [kappa max(0, e)]. *)
Inductive row := Nothing | Linear (alpha h : Z) | Pressed (kappa : Z).

Definition row_at (c : integer_contact) (r : row) (g : quad Z) : Z :=
  match r with
  | Nothing => 0
  | Linear alpha h => alpha * eval (spring c) g + h * eval (tangent c) g
  | Pressed kappa => kappa * Z.max 0 (eval (spring c) g)
  end.

(** A lower bound, for each unit of normal force, of what the contact does against the virtual
    motion: a -+ mu b where the direction of slip is known, else a - mu |b|. *)
Definition kappa (c : integer_contact) (s : state) (gens : list (quad Z)) (l : quad Z) : Z :=
  let a := unit_mu c * eval (normal c) l in
  let b := slope c * eval (tangent c) l in
  let plus := a - b in
  let minus := a + b in
  let unknown := a - slope c * Z.abs (eval (tangent c) l) in
  match s with
  | SlipPlus => plus
  | SlipMinus => minus
  | Stick | Detached => unknown
  | Undecided | Attached =>
      if forallb (fun g => 0 <? eval (tangent c) g) gens then plus
      else if forallb (fun g => eval (tangent c) g <? 0) gens then minus
      else unknown
  end.

Definition row_without (c : integer_contact) (s : state) (gens : list (quad Z)) (l : quad Z) :=
  match s with
  | Detached => Nothing
  | Undecided =>
      if forallb (fun g => eval (spring c) g <=? 0) gens then Nothing
      else
        let k := kappa c s gens l in
        if forallb (fun g => 0 <=? eval (spring c) g) gens then Linear k 0
        else if 0 <=? k then Nothing
        else Pressed k
  | _ => Linear (kappa c s gens l) 0
  end.

(** The multipliers alpha and h, times the unit of [l], are allowed or not. *)
Definition row_with (c : integer_contact) (s : state) (gens : list (quad Z)) (l : quad Z)
    (alpha h : Z) : option row :=
  let alpha := alpha * (unit_n c * unit_mu c) in
  let h := h * (unit_e c * unit_mu c) in
  let below := alpha <=? kappa c s gens l in
  let allowed :=
    match s with
    | Detached => (0 <=? alpha) && (h =? 0)
    | Undecided => (0 <=? alpha) && below && (h =? 0)
    | Attached => below && (h =? 0)
    | Stick => below
    | SlipPlus => below && (h <=? 0)
    | SlipMinus => below && (0 <=? h)
    end in
  if allowed then Some (Linear alpha h) else None.

Definition given (i : Z) (multipliers : list (Z * (Q * Q))) : option (Q * Q) :=
  match find (fun m => fst m =? i) multipliers with Some m => Some (snd m) | None => None end.

(** The rows of the contacts from number [i] on; [u] is the unit of [l]. *)
Fixpoint rows (i : Z) (cs : list integer_contact) (states : list state) (gens : list (quad Z))
    (u : Z) (l : quad Z) (multipliers : list (Z * (Q * Q))) : option (list row) :=
  match cs, states with
  | c :: cs, s :: states =>
      match
        match given i multipliers with
        | Some (alpha, h) => row_with c s gens l (clear u alpha) (clear u h)
        | None => Some (row_without c s gens l)
        end, rows (i + 1) cs states gens u l multipliers
      with
      | Some r, Some rest => Some (r :: rest)
      | _, _ => None
      end
  | [], [] => Some []
  | _, _ => None
  end.

Fixpoint rows_at (cs : list integer_contact) (rs : list row) (g : quad Z) : Z :=
  match cs, rs with
  | c :: cs, r :: rs =>
      match r with
      | Nothing => rows_at cs rs g
      | _ => weight c * row_at c r g + rows_at cs rs g
      end
  | _, _ => 0
  end.

Definition leaf_holds (g : integer_question) (gens : list (quad Z)) (states : list state)
    (motion : vector Q) (multipliers : list (Z * (Q * Q))) : bool :=
  let numbers := flat_map (fun m => [fst (snd m); snd (snd m)]) multipliers in
  let u := common (entries motion ++ numbers) in
  let l := clear_vector u 0 motion in
  let work := load_weight g * eval (load g) l in
  match rows 0 (bodies g) states gens u l multipliers with
  | None => false
  | Some rs =>
      forallb
        (fun v =>
           let sum := work * q0 v + rows_at (bodies g) rs v in
           if 0 <? q0 v then 0 <? sum else 0 <=? sum)
        gens
  end.

(** * Regions of the space of motions *)

Inductive region := HalfSpace | Cone (g0 g1 g2 g3 : quad Z).

Definition unit0 := Quad 1 0 0 0.
Definition unit1 (s : Z) := Quad 0 s 0 0.
Definition unit2 (s : Z) := Quad 0 0 s 0.
Definition unit3 (s : Z) := Quad 0 0 0 s.

Definition orthant (s1 s2 s3 : Z) := Cone unit0 (unit1 s1) (unit2 s2) (unit3 s3).

Definition generators (r : region) : list (quad Z) :=
  match r with
  | HalfSpace => [unit0; unit1 1; unit1 (-1); unit2 1; unit2 (-1); unit3 1; unit3 (-1)]
  | Cone g0 g1 g2 g3 => [g0; g1; g2; g3]
  end.

Definition same (j k : corner) : bool :=
  match j, k with
  | Corner0, Corner0 | Corner1, Corner1 | Corner2, Corner2 | Corner3, Corner3 => true
  | _, _ => false
  end.

(** The generator at a corner, and the cone with another one there. *)
Definition at_corner (j : corner) (g0 g1 g2 g3 : quad Z) : quad Z :=
  match j with Corner0 => g0 | Corner1 => g1 | Corner2 => g2 | Corner3 => g3 end.
Definition moved (j : corner) (v g0 g1 g2 g3 : quad Z) : region :=
  match j with
  | Corner0 => Cone v g1 g2 g3
  | Corner1 => Cone g0 v g2 g3
  | Corner2 => Cone g0 g1 v g3
  | Corner3 => Cone g0 g1 g2 v
  end.

(** A generator divided by the greatest common divisor of its entries. *)
Definition primitive (v : quad Z) : quad Z :=
  let d := Z.gcd (q0 v) (Z.gcd (q1 v) (Z.gcd (q2 v) (q3 v))) in
  if 0 <? d then Quad (q0 v / d) (q1 v / d) (q2 v / d) (q3 v / d) else v.

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

(** * Trees *)

Fixpoint refutes (g : integer_question) (r : region) (states : list state) (t : tree) : bool :=
  match t with
  | Leaf motion multipliers => leaf_holds g (generators r) states motion multipliers
  | Orthants ppp ppm pmp pmm mpp mpm mmp mmm =>
      match r with
      | Cone _ _ _ _ => false
      | HalfSpace =>
          refutes g (orthant 1 1 1) states ppp && refutes g (orthant 1 1 (-1)) states ppm &&
          refutes g (orthant 1 (-1) 1) states pmp && refutes g (orthant 1 (-1) (-1)) states pmm &&
          refutes g (orthant (-1) 1 1) states mpp && refutes g (orthant (-1) 1 (-1)) states mpm &&
          refutes g (orthant (-1) (-1) 1) states mmp &&
          refutes g (orthant (-1) (-1) (-1)) states mmm
      end
  | Edge j k p q first second =>
      match r with
      | HalfSpace => false
      | Cone g0 g1 g2 g3 =>
          let v := primitive
            (combine p (at_corner j g0 g1 g2 g3) q (at_corner k g0 g1 g2 g3)) in
          negb (same j k) && (0 <? p) && (0 <? q) &&
          refutes g (moved j v g0 g1 g2 g3) states first &&
          refutes g (moved k v g0 g1 g2 g3) states second
      end
  | Attachment i detached attached =>
      match state_of i states with
      | Some Undecided =>
          refutes g r (set_state i Detached states) detached &&
          refutes g r (set_state i Attached states) attached
      | _ => false
      end
  | Slip i stick plus minus =>
      match state_of i states with
      | Some Attached =>
          refutes g r (set_state i Stick states) stick &&
          refutes g r (set_state i SlipPlus states) plus &&
          refutes g r (set_state i SlipMinus states) minus
      | _ => false
      end
  end.

(** * A motion and forces *)

(** The law at one contact: [x] is the motion in integers, [c_n] and [c_t] are [u] times the force. *)
Definition obeys (c : integer_contact) (x : quad Z) (u c_n c_t : Z) : bool :=
  let cone := slope c * c_n in
  let force := unit_mu c * c_t in
  let slip := eval (tangent c) x in
  (c_n * unit_e c * q0 x =? u * Z.max 0 (eval (spring c) x)) &&
  (Z.abs force <=? cone) &&
  (if 0 <? slip then force =? - cone else true) &&
  (if slip <? 0 then force =? cone else true).

Fixpoint all_obey (cs : list integer_contact) (x : quad Z) (u : Z) (forces : list (Q * Q)) : bool :=
  match cs, forces with
  | c :: cs, (c_n, c_t) :: forces =>
      obeys c x u (clear u c_n) (clear u c_t) && all_obey cs x u forces
  | [], [] => true
  | _, _ => false
  end.

(** D u times the total wrench of the contacts. *)
Fixpoint integer_total (cs : list integer_contact) (u : Z) (forces : list (Q * Q)) : quad Z :=
  match cs, forces with
  | c :: cs, (c_n, c_t) :: forces =>
      let w := weight c * (unit_e c * unit_mu c) in
      combine 1 (combine (w * clear u c_n) (normal c) (w * clear u c_t) (tangent c))
              1 (integer_total cs u forces)
  | _, _ => Quad 0 0 0 0
  end.

Definition confirms (g : integer_question) (motion : vector Q) (forces : list (Q * Q)) : bool :=
  let d := common (entries motion) in
  let u := common (flat_map (fun f => [fst f; snd f]) forces) in
  let sum := combine 1 (integer_total (bodies g) u forces) (u * load_weight g) (load g) in
  all_obey (bodies g) (clear_vector d d motion) u forces &&
  (q1 sum =? 0) && (q2 sum =? 0) && (q3 sum =? 0).

(** * The checker *)

Definition check (g : question Q) (p : proof) : bool :=
  let asked := integer_form g in
  match p with
  | Resisted motion forces => confirms asked motion forces
  | NotResisted t => refutes asked HalfSpace (map (fun _ => Undecided) (bodies asked)) t
  end.
