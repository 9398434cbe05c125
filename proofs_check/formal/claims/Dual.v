(** The dual graph of central planes of R^3: at most twice as many edges as regions, less four. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Sphere Merge.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

Local Notation rho B := (regions look_real restrict_real (length B) B).
Local Notation onto' h B := (onto look_real (restrict_real h) B).

(** Regions that a plane adds to those of the planes B: its own, cut by them. *)
Definition added (h : form R) (B : list (form R)) : Z :=
  match onto' h B with None => 0 | Some B' => rho B' end.

Lemma enough n B : (length B <= n)%nat -> regions look_real restrict_real n B = rho B.
Proof.
  intros L. apply (@regions_enough _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane); trivial.
Qed.

Lemma onto_length r B B' : onto look_real r B = Some B' -> (length B' <= length B)%nat.
Proof.
  intros O. destruct (@onto_all (fun _ => True) (fun _ => True) r B (fun _ _ => I)
    ltac:(apply Forall_forall; trivial) B' O). trivial.
Qed.

Lemma rho_cons h B : look_real h = Plane -> rho (h :: B) = rho B + added h B.
Proof.
  intros K. cbn [length regions]. rewrite K. f_equal. unfold added.
  destruct (onto' h B) eqn:O; trivial. apply enough, (onto_length _ _ O).
Qed.

Lemma rho_rev B : rho (rev B) = rho B.
Proof.
  apply (@number_unique _ (region (rev B))); [apply regions_real_count|].
  apply number_image with (P := region B) (e := @rev sign); [| |apply regions_real_count].
  - intros a b E. rewrite <- (rev_involutive a), E. apply rev_involutive.
  - intros u. unfold region, face, signs. split.
    + intros [(x & X) N]. exists (rev u). rewrite rev_involutive. split; trivial. split.
      * exists x. rewrite <- X, map_rev. now rewrite rev_involutive.
      * now rewrite <- in_rev.
    + intros (t & [(x & X) N] & <-). split; [exists x; now rewrite map_rev, X|now rewrite <- in_rev].
Qed.

(** Faces of codimension 0: the planes of A become forms that must not be 0, one after the other. *)
Lemma faces_open n : forall nz A, (length A <= n)%nat -> Forall (fun f => look_real f = Plane) A ->
  nth 0 (faces look_real restrict_real n nz A) 0 = rho (rev A ++ nz).
Proof.
  induction n as [|n IH]; intros nz [|h A] L P; try (cbn in L; lia); trivial.
  cbn in L. inversion P as [|? ? K P']; subst. cbn [faces]. rewrite K, nth_sum.
  rewrite IH by (trivial; lia). replace (nth 0 _ 0) with 0
    by now destruct (onto look_real (restrict_real h) nz).
  cbn [rev]. rewrite <- app_assoc. cbn [app]. lia.
Qed.

Lemma rho_two B : Forall (fun f => look_real f = Plane) B -> B <> [] -> 2 <= rho B.
Proof.
  induction 1 as [|h B K P IH]; [easy|]. intros _. rewrite rho_cons by trivial.
  destruct B as [|g B]; [reflexivity|]. specialize (IH ltac:(easy)).
  enough (0 <= added h (g :: B)) by lia.
  unfold added. destruct (onto' h (g :: B)); [now apply regions_nonneg|lia].
Qed.

(** * On a circle *)

Lemma onto_app r X Y : onto look_real r (X ++ Y) =
  match onto look_real r X, onto look_real r Y with Some X', Some Y' => Some (X' ++ Y') | _, _ => None end.
Proof.
  induction X as [|g X IH]; cbn; [now destruct (onto look_real r Y)|].
  destruct (look_real (r g)); trivial. rewrite IH.
  destruct (onto look_real r X), (onto look_real r Y); trivial.
Qed.

Section Circle.

Variable D : list nat.
Hypothesis two : (length D <= 2)%nat.
Let good (f : form R) := within D f /\ central f /\ look_real f = Plane.

Lemma added_nonneg h B : 0 <= added h B.
Proof. unfold added. destruct (onto' h B); [apply regions_nonneg|]; lia. Qed.

Lemma added_within h B B' : good h -> Forall good B -> onto' h B = Some B' ->
  Forall (within (remove Nat.eq_dec (pivot_real (coefficients h)) D)) B' /\ Forall central B' /\
  length B' = length B /\ Forall (fun g => look_real g = Plane) B'.
Proof.
  intros (W & C & K) G O.
  assert (Forall (within D) B /\ Forall central B) as [WB CB].
  { split; (eapply Forall_impl; [|exact G]); unfold good; tauto. }
  destruct (@onto_all (within D) (within (remove Nat.eq_dec (pivot_real (coefficients h)) D))
    (restrict_real h) B (fun g => @within_restrict D h g K W) WB B' O) as [W' _].
  destruct (@onto_all central central (restrict_real h) B (fun g => @central_restrict h g C) CB B' O)
    as [C' _].
  repeat split; trivial.
  - apply central_onto with h; trivial. now constructor.
  - clear - O. revert B' O. induction B as [|g B IH]; cbn; intros B' O; [injection O as <-; constructor|].
    destruct (look_real (restrict_real h g)) eqn:E; [easy|now apply IH|].
    destruct (onto' h B); [|easy]. injection O as <-. constructor; auto.
Qed.

Lemma added_two h B : good h -> Forall good B -> added h B <= 2.
Proof.
  intros G GB. unfold added. destruct (onto' h B) as [B'|] eqn:O; [|lia].
  destruct (added_within G GB O) as (W & C & L & P). destruct G as (Wh & _ & K).
  pose proof (@pivot_within D h K Wh).
  pose proof (@central_regions_bound (length B') _ B' (le_n _) W C) as H1.
  set (d := length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) in *.
  destruct d as [|[|d]]; [| |lia]; destruct (length B') as [|k]; cbn in H1; try rewrite circles_1 in H1; cbn in *; lia.
Qed.

Lemma added_some h B : good h -> Forall good B -> B <> [] -> onto' h B <> None -> added h B = 2.
Proof.
  intros G GB NB N. apply Z.le_antisymm; [now apply added_two|].
  unfold added. destruct (onto' h B) as [B'|] eqn:O; [|easy].
  destruct (added_within G GB O) as (_ & _ & L & P). apply rho_two; trivial.
  intros ->. now destruct B.
Qed.

(** More lines cut a circle into no more arcs than two sets of them do one by one. *)
Lemma rho_app X Y : X <> [] -> Forall good X -> Forall good Y -> rho (X ++ Y) <= rho X + rho Y.
Proof.
  intros N GX GY. induction GX as [|h X G GX IH]; [easy|]. clear N.
  pose proof (proj2 (proj2 G)) as K. cbn [app]. rewrite !rho_cons by trivial.
  assert (Forall good (X ++ Y)) as GXY by now apply Forall_app.
  pose proof (added_two G GXY) as Two. destruct X as [|g X].
  - cbn [app] in *. change (added h []) with 1. change (rho []) with 1. lia.
  - specialize (IH ltac:(easy)). destruct (onto' h (g :: X)) eqn:O.
    + assert (added h (g :: X) = 2); [|lia]. apply added_some; trivial; congruence.
    + assert (added h ((g :: X) ++ Y) = 0); [|pose proof (added_nonneg h (g :: X)); lia].
      unfold added. now rewrite onto_app, O.
Qed.

End Circle.

(** * Edges and regions *)

Section Sphere.

Let circle (f : form R) := within (seq 0 3) f /\ central f.

Lemma arcs n h nz A : (length A <= n)%nat -> general 2 (h :: nz ++ A) -> Forall circle (h :: nz ++ A) ->
  nth 0 match onto' h nz with None => []
    | Some nz' => faces look_real restrict_real n nz' (skim look_real (restrict_real h) A) end 0
  <= match A, nz with
     | [], _ => added h nz
     | _, [] => added h A
     | _, _ => added h A + added h nz
     end.
Proof.
  intros L G C. pose proof (restricted_planes G) as P.
  pose proof (@general_plane 1 _ h G (or_introl eq_refl)) as K.
  assert (length (remove Nat.eq_dec (pivot_real (coefficients h)) (seq 0 3)) <= 2)%nat as Two.
  { inversion C as [|? ? [W _]]; subst. pose proof (@pivot_within _ h K W) as Less. rewrite seq_length in Less. lia. }
  inversion C as [|? ? [Wh Ch] CB]; subst.
  assert (Forall (fun f => within (remove Nat.eq_dec (pivot_real (coefficients h)) (seq 0 3)) f /\
    central f /\ look_real f = Plane) (map (restrict_real h) (nz ++ A))) as Good.
  { apply Forall_map. rewrite Forall_forall in *. intros g I. destruct (CB g I). repeat split; auto.
    - now apply within_restrict.
    - now apply central_restrict. }
  rewrite map_app in Good. apply Forall_app in Good as [Gn GA]. apply Forall_app in P as [Pn PA].
  unfold added. rewrite (onto_full _ Pn), (onto_full _ PA), (skim_full _ PA).
  rewrite faces_open.
  - destruct A as [|a A]; [cbn [map rev app]; lia|]. destruct nz as [|b nz].
    + cbn [map]. rewrite app_nil_r, <- (map_cons (restrict_real h)), rho_rev. lia.
    + rewrite <- (rho_rev (map (restrict_real h) (a :: A))).
      apply rho_app with (1 := Two); trivial.
      * cbn. now destruct (rev (map (restrict_real h) A)).
      * now apply Forall_rev.
  - now rewrite map_length.
  - now apply Forall_map.
Qed.

Lemma edges_open n : forall nz A, (length A <= n)%nat -> A <> [] -> nz <> [] ->
  general 2 (nz ++ A) -> Forall circle (nz ++ A) ->
  nth 1 (faces look_real restrict_real n nz A) 0 <= rho A - 2 + rho (rev A ++ nz) - rho nz.
Proof.
  induction n as [|n IH]; intros nz [|h A] L NA Nnz G C; try easy; try (cbn in L; lia).
  cbn in L. pose proof (Permutation_sym (Permutation_middle nz A h)) as Swap.
  pose proof (general_permutation Swap G) as G1. pose proof (Permutation_Forall Swap C) as C1.
  pose proof (@general_plane 1 _ h G1 (or_introl eq_refl)) as K.
  pose proof (@arcs n h nz A ltac:(lia) G1 C1) as Arcs.
  cbn [faces]. rewrite K, nth_sum, rho_cons by trivial. cbn [rev]. rewrite <- app_assoc. cbn [app].
  replace (nth 1 match onto' h nz with Some nz' => _ | None => _ end 0) with
    (nth 0 match onto' h nz with None => []
      | Some nz' => faces look_real restrict_real n nz' (skim look_real (restrict_real h) A) end 0)
    by now destruct (onto' h nz).
  destruct nz as [|b nz]; [easy|]. destruct A as [|a A].
  - replace (nth 1 (faces look_real restrict_real n (h :: b :: nz) []) 0) with 0 by now destruct n.
    cbn [rev app]. rewrite rho_cons by trivial. change (rho []) with 1. change (added h []) with 1. lia.
  - pose proof (IH (h :: b :: nz) (a :: A) ltac:(lia) ltac:(easy) ltac:(easy) G1 C1) as H.
    rewrite (@rho_cons h (b :: nz)) in H by trivial. lia.
Qed.

Lemma edges_bound planes : of_space 3 planes -> Forall central planes -> general 2 planes ->
  (2 <= length planes)%nat ->
  nth 1 (faces_real planes) 0 <= 2 * nth 0 (faces_real planes) 0 - 4.
Proof.
  intros S Ce G M.
  assert (Forall (fun f => look_real f = Plane) planes) as P.
  { apply Forall_forall. intros f I. now apply (@general_plane 1 planes). }
  assert (Forall circle planes) as C by now apply of_space_central.
  unfold faces_real. rewrite (faces_open [] (le_n _) P), app_nil_r, rho_rev.
  destruct planes as [|h [|a A]]; cbn [length] in M; try lia.
  inversion P as [|? ? K _]; subst.
  pose proof (@arcs (length (a :: A)) h [] (a :: A) (le_n _) G C) as Arcs.
  pose proof (@edges_open (length (a :: A)) [h] (a :: A) (le_n _) ltac:(easy) ltac:(easy) G C) as H.
  change (length (h :: a :: A)) with (Datatypes.S (length (a :: A))).
  cbn [faces]. rewrite K, nth_sum. cbn [onto nth] in *.
  rewrite (@rho_cons h []) in H by trivial. change (rho []) with 1 in H. change (added h []) with 1 in H.
  assert (rho (rev (a :: A) ++ [h]) = rho (h :: a :: A)) as E by apply (rho_rev (h :: a :: A)).
  rewrite E in H. change (regions _ _ _ (h :: a :: A)) with (rho (h :: a :: A)).
  rewrite (@rho_cons h (a :: A)) in * by trivial. lia.
Qed.

End Sphere.

Lemma as_many_as_rank planes k : Forall central planes -> rank planes k -> (k <= length planes)%nat.
Proof.
  intros C R. pose proof (@origin_face planes k C R) as O. pose proof (@faces_length (length planes) [] planes (le_n _)) as L.
  fold (faces_real planes) in L. destruct (Nat.le_gt_cases k (length planes)) as [|G]; trivial.
  rewrite nth_overflow in O; lia.
Qed.

(** Planes of rank 2 or 3, some of which may coincide. *)
Lemma dual_edges planes k e f : great_circles planes -> rank planes k -> (2 <= k)%nat ->
  number (face_of_codimension 1 planes) e -> number (face_of_codimension 0 planes) f ->
  e <= 2 * f - 4.
Proof.
  intros [S C] R K E F. destruct (merge C) as (B & fill & M & G & Fill & _).
  pose proof (proj1 M) as I.
  assert (of_space 3 B) as SB by (unfold of_space in *; rewrite Forall_forall in *; auto).
  assert (Forall central B) as CB by (rewrite Forall_forall in *; auto).
  apply (proj1 (merged_rank k M)) in R. pose proof (as_many_as_rank CB R).
  apply (merged_number _ _ M Fill) in E. apply (merged_number _ _ M Fill) in F.
  rewrite (number_unique E (faces_real_count B 1)), (number_unique F (faces_real_count B 0)).
  apply edges_bound; trivial. lia.
Qed.

Lemma dual_faces planes v e f : great_circles planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) v -> number (face_of_codimension 1 planes) e ->
  number (face_of_codimension 0 planes) f ->
  2 <= f /\ e <= 2 * f - 4 /\ v <= f - 2 /\ 2 * v <= e.
Proof.
  intros G R V E F. pose proof (@dual_edges planes 3 e f G R ltac:(lia) E F).
  pose proof (number_nonneg E). destruct G as [S C]. pose proof (sphere_euler S C R V E F). lia.
Qed.

Lemma ray_facets planes v e : great_circles planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) v -> number (face_of_codimension 1 planes) e -> 2 * v <= e.
Proof. intros G R V E. apply (dual_faces G R V E (faces_real_count planes 0)). Qed.
