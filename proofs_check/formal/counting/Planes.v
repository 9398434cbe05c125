(** Planes of real space: their sign vectors, regions and faces.

    This file is the statement: whoever believes the theorems on counts has to read it, and the
    theorems, and nothing else. *)

Require Import Reals ZArith List Bool Permutation.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** A point has coordinates x 0, x 1, ...; a form names finitely many of them, which is its space:
    [Form b [a; c]] is the function b + a (x 0) + c (x 1). Where it is 0 is a plane; a plane
    through the origin has b = 0. *)
Definition point := nat -> R.

Record form F := Form { constant : F; coefficients : list F }.

Fixpoint linear (a : list R) (x : point) : R :=
  match a with
  | [] => 0
  | c :: a => c * x O + linear a (fun i => x (S i))
  end.

Definition value (f : form R) (x : point) : R := constant f + linear (coefficients f) x.

Inductive sign := Minus | Zero | Plus.

Definition sgn (r : R) : sign := if Rlt_dec r 0 then Minus else if Rlt_dec 0 r then Plus else Zero.

(** The sign vector that a point shows: on which side of each plane it lies. *)
Definition signs (planes : list (form R)) (x : point) : list sign :=
  map (fun f => sgn (value f x)) planes.

(** A face is the set of the points of one sign vector; a region one that is on no plane. *)
Definition face (planes : list (form R)) (s : list sign) : Prop := exists x, signs planes x = s.

Definition region (planes : list (form R)) (s : list sign) : Prop :=
  face planes s /\ ~ In Zero s.

(** A list without repeats of exactly the things that fulfil [P]; their number. *)
Definition lists T (P : T -> Prop) (l : list T) : Prop := NoDup l /\ forall s, In s l <-> P s.

Definition number T (P : T -> Prop) (n : Z) : Prop :=
  exists l, lists P l /\ Z.of_nat (length l) = n.

(** Linear independence of the linear parts: whatever values are asked for, one direction has them.
    The rank is the greatest number of independent ones. *)
Definition independent (fs : list (form R)) : Prop :=
  forall values, length values = length fs ->
  exists v, map (fun f => linear (coefficients f) v) fs = values.

Definition rank (fs : list (form R)) (k : nat) : Prop :=
  (exists gs, incl gs fs /\ independent gs /\ length gs = k) /\
  (forall gs, incl gs fs -> independent gs -> (length gs <= k)%nat).

(** The planes on which the face of a sign vector lies; their rank is its codimension. *)
Fixpoint through (planes : list (form R)) (s : list sign) : list (form R) :=
  match planes, s with
  | f :: planes, Zero :: s => f :: through planes s
  | _ :: planes, _ :: s => through planes s
  | _, _ => []
  end.

Definition face_of_codimension (k : nat) (planes : list (form R)) (s : list sign) : Prop :=
  face planes s /\ rank (through planes s) k.

(** Documents have integers, and are about real planes. *)
Definition real_form (f : form Z) : form R :=
  Form (IZR (constant f)) (map IZR (coefficients f)).

Definition real_planes (planes : list (form Z)) : list (form R) := map real_form planes.

(** A half-line from x in direction v that stays in the face of a sign vector. A region is bounded if
    no form changes along any half-line in it; where the forms of R^d have rank d, it has none. *)
Definition half_line (planes : list (form R)) (s : list sign) (v : point) : Prop :=
  exists x, forall t, 0 <= t -> signs planes (fun i => x i + t * v i) = s.

Definition bounded (planes : list (form R)) (s : list sign) : Prop :=
  region planes s /\
  forall v, half_line planes s v -> forall f, In f planes -> linear (coefficients f) v = 0.

(** * Whitney's formula for the characteristic polynomial *)

(** The forms that a mask keeps; a subset of the planes is a mask as long as their list. *)
Fixpoint pick T (mask : list bool) (l : list T) : list T :=
  match mask, l with
  | true :: mask, a :: l => a :: pick mask l
  | false :: mask, _ :: l => pick mask l
  | _, _ => []
  end.

(** Some point is on all of them. *)
Definition meet (fs : list (form R)) : Prop := exists x, forall f, In f fs -> value f x = 0.

(** Subsets of rank k that have a common point, with an even number of planes or an odd one. *)
Definition subset (planes : list (form R)) (k : nat) (even : bool) (mask : list bool) : Prop :=
  length mask = length planes /\ meet (pick mask planes) /\ rank (pick mask planes) k /\
  Nat.even (length (pick mask planes)) = even.

(** The sum of (-1)^|S| over these subsets S. *)
Definition whitney_number (planes : list (form R)) (k : nat) (c : Z) : Prop :=
  exists e o, number (subset planes k true) e /\ number (subset planes k false) o /\ c = (e - o)%Z.

(** * Words of the claims *)

Definition size T (l : list T) : Z := Z.of_nat (length l).

(** Planes of R^d; planes through the origin; both, in R^3: great circles of the sphere. *)
Definition of_space (d : nat) (planes : list (form R)) : Prop :=
  Forall (fun f => length (coefficients f) = d) planes.

Definition central (f : form R) : Prop := constant f = 0.

Definition great_circles (planes : list (form R)) : Prop :=
  of_space 3 planes /\ Forall central planes.

(** General position of central planes: any [d] of them, or fewer, have independent normals. *)
Definition general (d : nat) (planes : list (form R)) : Prop :=
  forall fs rest, Permutation planes (fs ++ rest) -> (length fs <= d)%nat -> independent fs.

(** General position of any planes of R^d: also, no d + 1 of them have a common point. *)
Definition simple (d : nat) (planes : list (form R)) : Prop :=
  general d planes /\
  forall fs rest, Permutation planes (fs ++ rest) -> length fs = S d -> ~ meet fs.

(** Two forms with the same plane: one is a multiple of the other. No two planes coincide. *)
Definition same_plane (f g : form R) : Prop := exists c, c <> 0 /\ forall x, value g x = c * value f x.

Definition different (planes : list (form R)) : Prop :=
  ForallOrdPairs (fun f g => ~ same_plane f g) planes.

(** Planes on different sides of which two regions lie. *)
Definition sign_eq_dec (s t : sign) : {s = t} + {s <> t}.
Proof. decide equality. Defined.

Fixpoint separating (s t : list sign) : nat :=
  match s, t with
  | a :: s, b :: t => if sign_eq_dec a b then separating s t else S (separating s t)
  | _, _ => O
  end.

Fixpoint minus_signs (s : list sign) : nat :=
  match s with
  | [] => O
  | a :: s => if sign_eq_dec a Minus then S (minus_signs s) else minus_signs s
  end.

(** A face that lies in the closure of a region: where it is on no plane it has the region's sign. *)
Definition borders (u s : list sign) : Prop := Forall2 (fun a b => a = Zero \/ a = b) u s.

(** Edges of the dual graph: two regions share a facet, a face of codimension 1. Walks in it. *)
Definition share_facet (planes : list (form R)) (s t : list sign) : Prop :=
  s <> t /\ exists u, face_of_codimension 1 planes u /\ borders u s /\ borders u t.

Inductive walk (planes : list (form R)) : list sign -> list sign -> nat -> Prop :=
  | stay : forall s, region planes s -> walk planes s s 0
  | step : forall s t u n, region planes s -> share_facet planes s t -> walk planes t u n ->
      walk planes s u (S n).

(** * Contacts that may let go *)

(** What two forms of the motion say of a contact: it is detached where [gap] is 0 or positive;
    elsewhere it sticks or slips, as the sign of [slip] tells. Tangential planes pass through the origin. *)
Record contact := Contact { slip : form R; gap : form R }.

Definition planar (c : contact) : Prop :=
  length (coefficients (slip c)) = 3%nat /\ length (coefficients (gap c)) = 3%nat /\
  central (slip c) /\ independent [slip c; gap c].

Definition contact_planes (cs : list contact) : list (form R) := map slip cs ++ map gap cs.

Inductive contact_state := Detached | Attached (s : sign).

Definition contact_at (slip gap : sign) : contact_state :=
  match gap with Minus => Attached slip | _ => Detached end.

Definition state_at (x : point) (c : contact) : contact_state :=
  contact_at (sgn (value (slip c) x)) (sgn (value (gap c) x)).

(** States of all contacts that some motion has. *)
Definition state (cs : list contact) (s : list contact_state) : Prop := exists x, map (state_at x) cs = s.

(** One contact after the other: is it attached, and how does it slip? Nodes of the tree of these
    choices are the beginnings of what states say. *)
Inductive choice := LetsGo | Holds | Slips (s : sign).

Definition choices (s : contact_state) : list choice :=
  match s with Detached => [LetsGo] | Attached s => [Holds; Slips s] end.

Definition node (cs : list contact) (p : list choice) : Prop :=
  exists s rest, state cs s /\ flat_map choices s = p ++ rest.

(** The same where the conditions of states are closed: on borders several states hold. *)
Definition holds_at (x : point) (c : contact) (s : contact_state) : Prop :=
  match s with
  | Detached => 0 <= value (gap c) x
  | Attached a => value (gap c) x <= 0 /\
      match a with
      | Minus => value (slip c) x <= 0 | Zero => value (slip c) x = 0 | Plus => 0 <= value (slip c) x
      end
  end.

Definition closed_node (cs : list contact) (p : list choice) : Prop :=
  exists x s rest, Forall2 (holds_at x) cs s /\ flat_map choices s = p ++ rest.

(** * Duals in a sphere of R^3 *)

(** Weights of pairs of regions that sum to 1 over the neighbours of each region. *)
Definition neighbours (planes : list (form R)) (s t : list sign) : Prop :=
  region planes t /\ share_facet planes s t.

Definition weights_sum_to_one (planes : list (form R)) (w : list sign -> list sign -> R) : Prop :=
  (forall s t, w s t = w t s) /\
  forall s l, region planes s -> lists (neighbours planes s) l -> fold_right Rplus 0 (map (w s) l) = 1.

(** A point of the unit sphere in each region; pairs of them that are edges of their convex hull:
    some direction is greatest at these two alone. *)
Definition on_sphere (planes : list (form R)) (p : list sign -> point) : Prop :=
  forall s, region planes s -> signs planes (p s) = s /\
    p s 0%nat * p s 0%nat + p s 1%nat * p s 1%nat + p s 2%nat * p s 2%nat = 1.

Definition hull_edge (planes : list (form R)) (p : list sign -> point) (s t : list sign) : Prop :=
  exists a, length a = 3%nat /\ linear a (p s) = linear a (p t) /\
    forall u, region planes u -> u <> s -> u <> t -> linear a (p u) < linear a (p s).

Open Scope Z_scope.

(** Binomial coefficients; choose n 0 + ... + choose n k; a 0 + ... + a (n - 1). *)
Fixpoint choose (n k : nat) : Z :=
  match n, k with
  | _, O => 1
  | O, S _ => 0
  | S n, S k => choose n k + choose n (S k)
  end.

Fixpoint choose_upto (n k : nat) : Z :=
  match k with O => 1 | S k => choose_upto n k + choose n (S k) end.

Fixpoint total (a : nat -> Z) (n : nat) : Z :=
  match n with O => 0 | S n => total a n + a n end.
