(** Counterexamples of refuted claims: what is computed for them. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Counting Graph Contacts.
Import ListNotations.
Set Implicit Arguments.

(** * Two planes *)

Lemma two_planes_general : general 3 (real_planes [Form 0%Z [1%Z; 0%Z; 0%Z]; Form 0%Z [0%Z; 1%Z; 0%Z]]).
Proof.
  intros fs rest P _ values L. apply Permutation_length_2_inv in P.
  destruct fs as [|f [|g [|h fs]]]; [| | |now destruct P].
  1: now exists (fun _ => 0%R); destruct values.
  all: destruct values as [|a [|b [|c values]]]; try easy.
  - destruct P as [[= -> _]|[= -> _]]; [exists (fun i => match i with O => a | _ => 0%R end)
      | exists (fun i => match i with 1%nat => a | _ => 0%R end)]; cbn; f_equal; ring.
  - destruct P as [[= -> -> _]|[= -> -> _]];
    [exists (fun i => match i with O => a | 1%nat => b | _ => 0%R end)
      | exists (fun i => match i with O => b | 1%nat => a | _ => 0%R end)];
    cbn; (f_equal; [ring|]); (f_equal; ring).
Qed.

(** * Trees with closed conditions *)

Definition equal_contact := Contact (real_form (Form 0%Z [1%Z; 0%Z; 0%Z])) (real_form (Form 0%Z [0%Z; 1%Z; 0%Z])).

Definition all_states := [Detached; Attached Minus; Attached Zero; Attached Plus].

(** Paths of three states, and their beginnings. *)
Definition all_paths : list (list choice) :=
  flat_map (fun a => flat_map (fun b => map (fun c => flat_map choices [a; b; c]) all_states) all_states) all_states.

Definition all_nodes : list (list choice) :=
  nodup (list_eq_dec choice_eq_dec)
    (flat_map (fun p => map (fun k => firstn k p) (seq 0 (S (length p)))) all_paths).

Lemma closed_nodes : number (closed_node (repeat equal_contact 3)) 106.
Proof.
  exists all_nodes. split; [|reflexivity]. split; [apply NoDup_nodup|].
  assert (forall s, In s all_states) as All by (intros [|[]]; cbn; tauto).
  assert (forall p, In p all_paths <-> exists a b c, flat_map choices [a; b; c] = p) as Paths.
  { intros p. unfold all_paths. split.
    - intros (a & _ & (b & _ & (c & E & _)%in_map_iff)%in_flat_map)%in_flat_map. now exists a, b, c.
    - intros (a & b & c & E). apply in_flat_map. exists a. split; [apply All|]. apply in_flat_map.
      exists b. split; [apply All|]. apply in_map_iff. exists c. split; [exact E|apply All]. }
  intros p. unfold all_nodes. rewrite nodup_In, in_flat_map. split.
  - intros (q & (a & b & c & <-)%Paths & (k & <- & _)%in_map_iff).
    exists origin, [a; b; c], (skipn k (flat_map choices [a; b; c])). rewrite firstn_skipn. split; [|reflexivity].
    assert (forall s, holds_at origin equal_contact s) as At.
    { intros [|[]]; unfold holds_at, equal_contact, value, origin; cbn; lra. }
    repeat constructor; apply At.
  - intros (x & s & rest & H & E). exists (p ++ rest). split.
    + apply Paths. inversion H as [|? a ? ? _ H1]; subst. inversion H1 as [|? b ? ? _ H2]; subst.
      inversion H2 as [|? c ? ? _ H3]; subst. inversion H3; subst. now exists a, b, c.
    + apply in_map_iff. exists (length p). split.
      * now rewrite firstn_app, Nat.sub_diag, firstn_all, firstn_O, app_nil_r.
      * apply in_seq. rewrite app_length. lia.
Qed.

(** * Points of the unit sphere *)

Definition axis (i : nat) : point := fun j => if Nat.eqb j i then 1%R else 0%R.

Ltac other_plane := intros (c & C & E); pose proof (E (axis 0)) as X; pose proof (E (axis 1)) as Y;
  pose proof (E (axis 2)) as Z; unfold value, axis in X, Y, Z; cbn in X, Y, Z; lra.

Ltac different_planes := repeat (constructor; [repeat (constructor; [other_plane|]); constructor|]); constructor.

Definition octants := real_planes [Form 0%Z [1%Z; 0%Z; 0%Z]; Form 0%Z [0%Z; 1%Z; 0%Z]; Form 0%Z [0%Z; 0%Z; 1%Z]].

Definition side (a : sign) (r : R) : R := match a with Minus => (- r)%R | Zero => 0%R | Plus => r end.

Definition skew (s : list sign) : point :=
  match s with
  | [a; b; c] =>
      let r := match s with [Plus; Plus; Plus] | [Plus; Minus; Minus] => true | _ => false end in
      fun i => match i with
        | O => side a (if r then 2/3 else 1/3)%R
        | 1%nat => side b (2/3)%R
        | _ => side c (if r then 1/3 else 2/3)%R end
  | _ => origin
  end.

Lemma octant s : region octants s -> exists a b c, s = [a; b; c] /\ a <> Zero /\ b <> Zero /\ c <> Zero.
Proof.
  intros [(x & <-) N]. do 3 eexists. split; [reflexivity|]. cbn in N. tauto.
Qed.

Ltac shown := unfold signs, octants, real_planes; cbn [map]; 
  repeat (apply (f_equal2 (@cons sign)); [first [apply sgn_plus|apply sgn_minus]; unfold value; cbn; lra|]); reflexivity.

Lemma skew_signs a b c : a <> Zero -> b <> Zero -> c <> Zero -> signs octants (skew [a; b; c]) = [a; b; c].
Proof. intros A B C. destruct a, b, c; try easy; shown. Qed.

Lemma skew_region a b c : a <> Zero -> b <> Zero -> c <> Zero -> region octants [a; b; c].
Proof.
  intros A B C. split; [exists (skew [a; b; c]); now apply skew_signs|]. intros [|[|[|[]]]]; easy.
Qed.

Lemma skew_hull : exists p s t, on_sphere octants p /\ region octants s /\ region octants t /\
  hull_edge octants p s t /\ ~ share_facet octants s t.
Proof.
  exists skew, [Plus; Plus; Plus], [Plus; Minus; Minus].
  split; [|split; [now apply skew_region|split; [now apply skew_region|split]]].
  - intros s (a & b & c & -> & A & B & C)%octant. split; [now apply skew_signs|].
    destruct a, b, c; try easy; cbn; lra.
  - exists [1%R; 0%R; 0%R]. split; [reflexivity|]. split; [cbn; lra|].
    intros u (a & b & c & -> & A & B & C)%octant N1 N2. destruct a, b, c; try easy; cbn; lra.
  - intros F. enough (separating [Plus; Plus; Plus] [Plus; Minus; Minus] = 1%nat) by easy.
    apply (@facet_one_sign octants); trivial; [|now apply skew_region|now apply skew_region].
    unfold octants, different. cbn. different_planes.
Qed.

(** * Weights *)

Definition diagonals := [Form 0%Z [1%Z; 1%Z; 1%Z]; Form 0%Z [1%Z; 1%Z; (-1)%Z];
  Form 0%Z [1%Z; (-1)%Z; 1%Z]; Form 0%Z [(-1)%Z; 1%Z; 1%Z]].

Lemma diagonals_different : different (real_planes diagonals).
Proof. unfold diagonals, different. cbn. different_planes. Qed.

(** All regions, each with a point of it. *)
Definition at_point (x y z : Z) : witness := Witness [x; y; z] 1.

Definition fourteen : list (list sign * witness) :=
  [([Minus; Minus; Minus; Minus], at_point (-1)%Z (-1)%Z (-1)%Z);
   ([Minus; Minus; Minus; Plus], at_point (-3)%Z 1%Z 0%Z);
   ([Minus; Minus; Plus; Minus], at_point (-1)%Z (-3)%Z 0%Z);
   ([Minus; Minus; Plus; Plus], at_point (-1)%Z (-1)%Z 1%Z);
   ([Minus; Plus; Minus; Minus], at_point (-1)%Z 0%Z (-3)%Z);
   ([Minus; Plus; Minus; Plus], at_point (-1)%Z 1%Z (-1)%Z);
   ([Minus; Plus; Plus; Minus], at_point 1%Z (-1)%Z (-1)%Z);
   ([Plus; Minus; Minus; Plus], at_point (-1)%Z 1%Z 1%Z);
   ([Plus; Minus; Plus; Minus], at_point 1%Z (-1)%Z 1%Z);
   ([Plus; Minus; Plus; Plus], at_point (-1)%Z 0%Z 3%Z);
   ([Plus; Plus; Minus; Minus], at_point 1%Z 1%Z (-1)%Z);
   ([Plus; Plus; Minus; Plus], at_point (-1)%Z 3%Z 0%Z);
   ([Plus; Plus; Plus; Minus], at_point 3%Z 0%Z (-1)%Z);
   ([Plus; Plus; Plus; Plus], at_point 1%Z 1%Z 1%Z)].

Lemma fourteen_regions : lists (region (real_planes diagonals)) (map fst fourteen).
Proof. apply regions_complete. vm_compute. reflexivity. Qed.

Lemma near_regions s : region (real_planes diagonals) s -> lists (neighbours (real_planes diagonals) s)
  (filter (fun t => Nat.eqb (separating s t) 1) (map fst fourteen)).
Proof.
  intros S. destruct fourteen_regions as [N L]. split; [now apply NoDup_filter|].
  intros t. rewrite filter_In, L, Nat.eqb_eq. unfold neighbours. split; intros [T H]; split; trivial.
  - now apply facet_between.
  - now apply (facet_one_sign diagonals_different).
Qed.

Lemma no_diagonal_weights : great_circles (real_planes diagonals) /\ different (real_planes diagonals) /\
  forall w, ~ weights_sum_to_one (real_planes diagonals) w.
Proof.
  split; [split; repeat constructor|]. split; [exact diagonals_different|]. intros w [Sym Sum].
  assert (forall s, In s (map fst fourteen) -> fold_right Rplus 0%R
    (map (w s) (filter (fun t => Nat.eqb (separating s t) 1) (map fst fourteen))) = 1%R) as Each.
  { intros s I. apply fourteen_regions in I. apply Sum; trivial. now apply near_regions. }
  (* Sums over the regions of one class are sums over the other one, weight by weight. *)
  let rec each l := match l with
    | ?s :: ?l =>
        let near := eval vm_compute in (filter (fun t => Nat.eqb (separating s t) 1) (map fst fourteen)) in
        let even := eval vm_compute in (Nat.even (minus_signs s)) in
        let H := fresh "E" in
        match even with
        | true => assert (fold_right Rplus 0%R (map (w s) near) = 1%R) as H by (apply (Each s); cbn; tauto)
        | false => assert (fold_right Rplus 0%R (map (fun t => w t s) near) = 1%R) as H by
            (rewrite (map_ext (fun t => w t s) (w s)); [apply (Each s); cbn; tauto|intros; apply Sym])
        end; cbn in H; each l
    | [] => idtac end in
  let l := eval cbn in (map fst fourteen) in each l.
  lra.
Qed.
