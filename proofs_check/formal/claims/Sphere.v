(** Central planes of R^3, which are great circles of the sphere: proofs of the claims. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * Formulas *)

Lemma choose_1 m : choose m 1 = Z.of_nat m.
Proof. induction m as [|m IH]; cbn [choose]; [lia|]. rewrite choose_none, IH. lia. Qed.

Lemma choose_2 m : 2 * choose m 2 = Z.of_nat m * (Z.of_nat m - 1).
Proof.
  induction m as [|m IH]; [reflexivity|].
  change (choose (S m) 2) with (choose m 1 + choose m 2). rewrite choose_1. nia.
Qed.

Lemma circles_3 m : central_regions (S m) 3 = Z.of_nat (S m) * Z.of_nat (S m) - Z.of_nat (S m) + 2.
Proof.
  unfold central_regions. cbn [choose_upto]. rewrite choose_1. pose proof (choose_2 m). nia.
Qed.

Lemma circles_2 m : central_regions (S m) 2 = 2 * Z.of_nat (S m).
Proof. unfold central_regions. cbn [choose_upto]. rewrite choose_1. lia. Qed.

Lemma central_upto m d : central_regions m d <= choose_upto m d.
Proof.
  pose proof (upto_positive m d). destruct m as [|m]; [cbn; lia|].
  destruct d as [|d]; [cbn; lia|]. unfold central_regions. rewrite upto_step.
  pose proof (@upto_wider m d (S d) ltac:(lia)). lia.
Qed.

Section GreatCircles.

Variable planes : list (form R).
Hypothesis circles : great_circles planes.
Let m := size planes.

Lemma circle_regions n : number (region planes) n -> n <= m * m - m + 2.
Proof.
  intros N. destruct circles as [S C]. pose proof (central_regions_at_most S C N) as H.
  unfold m, size. destruct planes as [|f l]; [cbn in *; lia|].
  cbn [length] in *. rewrite circles_3 in H. exact H.
Qed.

Lemma circle_faces n : number (face_of_codimension 0 planes) n -> n <= m * m - m + 2.
Proof.
  intros N. destruct circles as [S C].
  pose proof (@central_faces_at_most 3 planes 0 n S C ltac:(lia) N) as H.
  rewrite choose_none, !Nat.sub_0_r in H. unfold m, size.
  destruct planes as [|f l]; [cbn in *; lia|]. cbn [length] in *. rewrite circles_3 in H. lia.
Qed.

Lemma circle_arcs n : 2 <= m -> number (face_of_codimension 1 planes) n -> n <= 2 * m * (m - 1).
Proof.
  unfold m, size. intros M N. destruct circles as [S C].
  pose proof (@central_faces_at_most 3 planes 1 n S C ltac:(lia) N) as H.
  rewrite choose_1 in H. change (3 - 1)%nat with 2%nat in H.
  destruct (length planes) as [|[|k]]; try (cbn in M; lia).
  change (Datatypes.S (Datatypes.S k) - 1)%nat with (Datatypes.S k) in H. rewrite circles_2 in H. lia.
Qed.

Lemma circle_rays n : number (face_of_codimension 2 planes) n -> n <= m * (m - 1).
Proof.
  intros N. destruct circles as [S C].
  pose proof (@central_faces_at_most 3 planes 2 n S C ltac:(lia) N) as H.
  pose proof (choose_2 (length planes)). change (3 - 2)%nat with 1%nat in H.
  assert (central_regions (length planes - 2) 1 <= 2) by (destruct (length planes - 2)%nat; cbn; lia).
  pose proof (choose_nonneg (length planes) 2). unfold m, size in *. nia.
Qed.

Lemma circle_origins n : number (face_of_codimension 3 planes) n -> n <= 1.
Proof.
  intros N. destruct circles as [S C]. rewrite (number_unique N (faces_real_count planes 3)).
  apply (@deep_faces 3 planes 3 S C (le_n _)).
Qed.

Lemma edges_at_most n : number (face_of_codimension 1 planes) n -> n <= 2 * (m * m).
Proof.
  intros N. destruct (Z.le_gt_cases 2 m) as [M|M]; [pose proof (circle_arcs M N); lia|].
  unfold m, size in *. destruct circles as [S C].
  pose proof (@central_faces_at_most 3 planes 1 n S C ltac:(lia) N) as H.
  rewrite choose_1 in H. destruct (length planes) as [|[|k]]; cbn in *; lia.
Qed.

Lemma total_below f : (forall k, number (face_of_codimension k planes) (f k)) -> 4 <= m ->
  f 0%nat + f 1%nat + f 2%nat + f 3%nat <
  choose_upto (length planes) 3 + choose (length planes) 1 * choose_upto (length planes - 1) 2 +
  choose (length planes) 2 * choose_upto (length planes - 2) 1 + choose (length planes) 3.
Proof.
  intros N M. destruct circles as [S C].
  assert (forall k, (k < 3)%nat ->
    f k <= choose (length planes) k * choose_upto (length planes - k) (3 - k)) as Each.
  { intros k K. pose proof (@central_faces_at_most 3 planes k (f k) S C K (N k)).
    pose proof (choose_nonneg (length planes) k).
    pose proof (central_upto (length planes - k) (3 - k)). nia. }
  pose proof (Each 0%nat ltac:(lia)) as H0. pose proof (Each 1%nat ltac:(lia)) as H1.
  pose proof (Each 2%nat ltac:(lia)) as H2. rewrite choose_none, !Nat.sub_0_r in H0.
  change (3 - 1)%nat with 2%nat in H1. change (3 - 2)%nat with 1%nat in H2.
  pose proof (circle_origins (N 3%nat)).
  assert (1 < choose (length planes) 3); [|lia].
  unfold m, size in M. destruct (length planes) as [|[|[|[|k]]]]; try (cbn in M; lia).
  pose proof (choose_nonneg k 1). pose proof (choose_nonneg k 2). pose proof (choose_nonneg k 3).
  cbn [choose]. rewrite !choose_none. cbn [choose]. lia.
Qed.

End GreatCircles.

Lemma general_circles planes : great_circles planes -> general 3 planes -> 3 <= size planes ->
  let m := size planes in
  number (face_of_codimension 3 planes) 1 /\
  number (face_of_codimension 2 planes) (m * (m - 1)) /\
  number (face_of_codimension 1 planes) (2 * m * (m - 1)) /\
  number (face_of_codimension 0 planes) (m * m - m + 2).
Proof.
  intros [S C] G M m. unfold m, size in *.
  pose proof (fun k K => @general_faces 3 planes k S C G K) as Exact.
  repeat split.
  - rewrite <- (@one_origin 3 planes S C (@general_rank 3 planes S C G ltac:(lia))). apply faces_real_count.
  - pose proof (Exact 2%nat ltac:(lia)) as H. change (3 - 2)%nat with 1%nat in H.
    destruct (length planes) as [|[|[|k]]]; try (cbn in M; lia).
    change (Datatypes.S (Datatypes.S (Datatypes.S k)) - 2)%nat with (Datatypes.S k) in H.
    pose proof (choose_2 (Datatypes.S (Datatypes.S (Datatypes.S k)))) as Two.
    cbn [central_regions choose_upto] in H.
    replace (Z.of_nat _ * (Z.of_nat _ - 1)) with
      (choose (Datatypes.S (Datatypes.S (Datatypes.S k))) 2 * (2 * 1)) by lia. exact H.
  - pose proof (Exact 1%nat ltac:(lia)) as H. change (3 - 1)%nat with 2%nat in H.
    rewrite choose_1 in H. destruct (length planes) as [|[|k]]; try (cbn in M; lia).
    change (Datatypes.S (Datatypes.S k) - 1)%nat with (Datatypes.S k) in H. rewrite circles_2 in H.
    replace (2 * Z.of_nat _ * (Z.of_nat _ - 1)) with
      (Z.of_nat (Datatypes.S (Datatypes.S k)) * (2 * Z.of_nat (Datatypes.S k))) by lia. exact H.
  - pose proof (Exact 0%nat ltac:(lia)) as H. rewrite choose_none, !Nat.sub_0_r, Z.mul_1_l in H.
    destruct (length planes) as [|k]; [cbn in M; lia|]. now rewrite circles_3 in H.
Qed.

Lemma general_circle_regions planes : great_circles planes -> general 3 planes ->
  1 <= size planes ->
  number (region planes) (size planes * size planes - size planes + 2).
Proof.
  intros [S C] G M. pose proof (general_regions S C G) as H. unfold size in *.
  destruct (length planes) as [|k]; [cbn in M; lia|]. now rewrite circles_3 in H.
Qed.

Lemma circles_firstn planes i : great_circles planes -> great_circles (firstn i planes).
Proof.
  intros [S C]. split; apply Forall_forall; intros f H.
  - apply (proj1 (Forall_forall _ _) S). rewrite <- (firstn_skipn i planes). apply in_app_iff. now left.
  - apply (proj1 (Forall_forall _ _) C). rewrite <- (firstn_skipn i planes). apply in_app_iff. now left.
Qed.

Lemma tests_bound planes f : great_circles planes ->
  (forall i, (i < length planes)%nat -> number (region (firstn i planes)) (f i)) ->
  total f (length planes) <= size planes ^ 3.
Proof.
  intros G N.
  assert (forall n, (n <= length planes)%nat -> total f n <= Z.of_nat n ^ 3) as All; [|now apply All].
  induction n as [|n IH]; intros L; [cbn; lia|]. cbn [total].
  pose proof (IH ltac:(lia)). pose proof (N n ltac:(lia)) as Nn.
  assert (f n <= match n with O => 1 | _ => Z.of_nat n * Z.of_nat n - Z.of_nat n + 2 end) as B.
  { destruct n as [|n].
    - cbn [firstn] in Nn. rewrite (number_unique Nn region_nil). lia.
    - pose proof (circle_regions (circles_firstn (Datatypes.S n) G) Nn) as H1. unfold size in H1.
      rewrite firstn_length_le in H1 by lia. exact H1. }
  rewrite Nat2Z.inj_succ. unfold Z.succ. destruct n as [|n]; [cbn in *; lia|]. nia.
Qed.

(** * All faces *)

Lemma slip_states_total planes : number (face planes) (fold_right Z.add 0 (faces_real planes)).
Proof.
  apply codimensions_total; [|apply faces_real_count]. intros s F.
  pose proof (@codimension_exists _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane planes s) as H.
  rewrite map_id in H. now apply H.
Qed.

Lemma four_terms_far planes : (forall k, (4 <= k)%nat -> nth k (faces_real planes) 0 = 0) ->
  fold_right Z.add 0 (faces_real planes) =
  nth 0 (faces_real planes) 0 + nth 1 (faces_real planes) 0 + nth 2 (faces_real planes) 0 +
  nth 3 (faces_real planes) 0.
Proof.
  intros Far.
  assert (forall l, (forall k, nth k l 0 = 0) -> fold_right Z.add 0 l = 0) as Zeros.
  { induction l as [|a l IH]; trivial. intros H. cbn. rewrite IH.
    - specialize (H O). cbn in H. lia.
    - intros k. apply (H (Datatypes.S k)). }
  destruct (faces_real planes) as [|a [|b [|c [|z l]]]]; cbn [fold_right nth]; try lia.
  rewrite (Zeros l); [lia|]. intros k. apply (Far (Datatypes.S (Datatypes.S (Datatypes.S (Datatypes.S k))))). lia.
Qed.

Lemma four_terms planes : great_circles planes -> fold_right Z.add 0 (faces_real planes) =
  nth 0 (faces_real planes) 0 + nth 1 (faces_real planes) 0 + nth 2 (faces_real planes) 0 +
  nth 3 (faces_real planes) 0.
Proof.
  intros [S C]. apply four_terms_far. intros k K.
  pose proof (number_nonneg (faces_real_count planes k)).
  pose proof (@deep_faces 3 planes k S C ltac:(lia)) as H1. destruct (Nat.eqb_spec k 3); lia.
Qed.

Lemma slip_states_bound planes n : great_circles planes -> number (face planes) n ->
  n <= 4 * size planes * size planes - 4 * size planes + 3.
Proof.
  intros G N. rewrite (number_unique N (slip_states_total planes)), (four_terms G).
  pose proof (circle_faces G (faces_real_count planes 0)) as F0.
  pose proof (circle_origins G (faces_real_count planes 3)) as F3.
  destruct (Z.le_gt_cases 2 (size planes)) as [M|M].
  - pose proof (circle_arcs G M (faces_real_count planes 1)).
    pose proof (circle_rays G (faces_real_count planes 2)). lia.
  - pose proof (@faces_length (length planes) [] planes (le_n _)) as L. fold (faces_real planes) in L.
    unfold size in *. destruct G as [S C].
    pose proof (@central_faces_at_most 3 planes 1 _ S C ltac:(lia) (faces_real_count planes 1)) as F1.
    rewrite (@nth_overflow _ (faces_real planes) 2), (@nth_overflow _ (faces_real planes) 3) by lia.
    destruct (length planes) as [|[|k]]; cbn in *; lia.
Qed.

Lemma general_slip_states planes : great_circles planes -> general 3 planes -> 3 <= size planes ->
  number (face planes) (4 * size planes * size planes - 4 * size planes + 3).
Proof.
  intros G Ge M. destruct (general_circles G Ge M) as (F3 & F2 & F1 & F0).
  pose proof (slip_states_total planes) as T. rewrite (four_terms G) in T.
  rewrite <- (number_unique F0 (faces_real_count planes 0)), <- (number_unique F1 (faces_real_count planes 1)),
    <- (number_unique F2 (faces_real_count planes 2)), <- (number_unique F3 (faces_real_count planes 3)) in T.
  replace (4 * size planes * size planes - 4 * size planes + 3) with
    (size planes * size planes - size planes + 2 + 2 * size planes * (size planes - 1) +
     size planes * (size planes - 1) + 1) by ring. exact T.
Qed.
