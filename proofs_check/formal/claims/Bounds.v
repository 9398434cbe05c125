(** The recursion over the real numbers: bounds, general position, Euler's relation. *)

Require Import Reals ZArith List Bool Lia Lra.
Require Import Planes Sides Rank Recursion.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The recursion over the real numbers *)

Fixpoint flat_real (a : list R) : bool :=
  match a with [] => true | c :: a => if Req_EM_T c 0 then flat_real a else false end.

Definition look_real (f : form R) : kind :=
  if flat_real (coefficients f) then if Req_EM_T (constant f) 0 then Vanishes else Constant
  else Plane.

Fixpoint pivot_real (a : list R) : nat :=
  match a with [] => O | c :: a => if Req_EM_T c 0 then S (pivot_real a) else O end.

Fixpoint less (b : R) (u v : list R) : list R :=
  match u, v with
  | x :: u, y :: v => x - b * y :: less b u v
  | [], y :: v => - (b * y) :: less b [] v
  | u, [] => u
  end.

Definition restrict_real (h g : form R) : form R :=
  let j := pivot_real (coefficients h) in
  let b := slope g j / slope h j in
  Form (constant g - b * constant h) (less b (coefficients g) (coefficients h)).

Lemma flat_real_linear a : flat_real a = true -> forall x, linear a x = 0.
Proof.
  induction a as [|c a IH]; cbn; trivial. destruct (Req_EM_T c 0); [|easy].
  intros H x. subst. rewrite IH by trivial. ring.
Qed.

Lemma pivot_real_spec a : flat_real a = false -> nth (pivot_real a) a 0 <> 0.
Proof. induction a as [|c a IH]; cbn; [easy|]. now destruct (Req_EM_T c 0). Qed.

Lemma linear_less b u : forall v x, linear (less b u v) x = linear u x - b * linear v x.
Proof.
  induction u as [|c u IH].
  - induction v as [|d v IH]; intros x; cbn; [ring|]. rewrite IH. cbn. ring.
  - intros [|d v] x; cbn; [ring|]. rewrite IH. ring.
Qed.

Lemma look_real_vanishes f : look_real f = Vanishes -> forall x, value f x = 0.
Proof.
  unfold look_real. destruct (flat_real _) eqn:E; [|easy]. destruct (Req_EM_T _ 0) as [Z|]; [|easy].
  intros _ x. unfold value. rewrite flat_real_linear, Z by trivial. ring.
Qed.

Lemma look_real_constant f : look_real f = Constant ->
  exists c, c <> 0 /\ forall x, value f x = c.
Proof.
  unfold look_real. destruct (flat_real _) eqn:E; [|easy]. destruct (Req_EM_T _ 0) as [|N]; [easy|].
  intros _. exists (constant f). split; trivial.
  intros x. unfold value. rewrite flat_real_linear by trivial. ring.
Qed.

Lemma look_real_slope h : look_real h = Plane -> slope h (pivot_real (coefficients h)) <> 0.
Proof.
  unfold look_real. destruct (flat_real _) eqn:E; [now destruct (Req_EM_T _ 0)|].
  intros _. now apply pivot_real_spec.
Qed.

Lemma restrict_real_below h g : look_real h = Plane ->
  below h (pivot_real (coefficients h)) g (restrict_real h g).
Proof.
  intros L. exists 1. split; [lra|]. intros x.
  rewrite value_foot. unfold restrict_real, value. cbn. rewrite linear_less. ring.
Qed.

Lemma look_real_plane h : look_real h = Plane -> exists j, slope h j <> 0 /\
  forall g, below h j g (restrict_real h g).
Proof.
  intros L. exists (pivot_real (coefficients h)). split; [now apply look_real_slope|].
  intros g. now apply restrict_real_below.
Qed.

Definition regions_real B := regions look_real restrict_real (length B) B.
Definition faces_real A := faces look_real restrict_real (length A) [] A.

Lemma regions_real_count B : number (region B) (regions_real B).
Proof.
  pose proof (@regions_count _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length B) B (le_n _)) as H.
  now rewrite map_id in H.
Qed.

Lemma faces_real_apart nz A k : number (apart nz A k)
  (nth k (faces look_real restrict_real (length A) nz A) 0%Z).
Proof.
  pose proof (@faces_count _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length A) nz A k (le_n _)) as H.
  now rewrite !map_id in H.
Qed.

Lemma faces_real_count A k : number (face_of_codimension k A) (nth k (faces_real A) 0%Z).
Proof. apply codimension_number, faces_real_apart. Qed.

Arguments Z.add : simpl never.
Arguments Z.mul : simpl never.
Arguments Z.sub : simpl never.

(** * Binomial coefficients *)

(** Regions of m central planes of R^d in general position. *)
Definition central_regions (m d : nat) : Z :=
  match m, d with O, _ => 1 | S _, O => 0 | S m, S d => 2 * choose_upto m d end.

Open Scope Z_scope.

Lemma choose_nonneg n : forall k, 0 <= choose n k.
Proof.
  induction n as [|n IH]; intros [|k]; cbn; try lia.
  pose proof (IH k). pose proof (IH (S k)). lia.
Qed.

Lemma choose_none n : choose n 0 = 1.
Proof. now destruct n. Qed.

Lemma choose_grows n k : choose n k <= choose (S n) k.
Proof. destruct k; [rewrite !choose_none; lia|]. cbn. pose proof (choose_nonneg n k). lia. Qed.

Lemma upto_step n k : choose_upto (S n) (S k) = choose_upto n (S k) + choose_upto n k.
Proof.
  induction k as [|k IH]; [cbn; rewrite choose_none; lia|].
  change (choose_upto (S n) (S (S k))) with (choose_upto (S n) (S k) + choose (S n) (S (S k))).
  rewrite IH. cbn. lia.
Qed.

Lemma upto_positive n k : 1 <= choose_upto n k.
Proof. induction k; cbn; [lia|]. pose proof (choose_nonneg n (S k)). lia. Qed.

Lemma upto_grows n k : choose_upto n k <= choose_upto (S n) k.
Proof.
  induction k as [|k IH]; [cbn; lia|]. pose proof (choose_grows n (S k)). cbn [choose_upto]. lia.
Qed.

Lemma upto_grows_many n n' k : (n <= n')%nat -> choose_upto n k <= choose_upto n' k.
Proof. induction 1; [lia|]. pose proof (upto_grows m k). lia. Qed.

Lemma upto_wider n k k' : (k <= k')%nat -> choose_upto n k <= choose_upto n k'.
Proof. induction 1; [lia|]. cbn. pose proof (choose_nonneg n (S m)). lia. Qed.

Lemma upto_zero k : choose_upto 0 k = 1.
Proof. induction k; cbn; lia. Qed.

Lemma central_step m d :
  central_regions (S m) (S d) = central_regions m (S d) + central_regions m d.
Proof.
  destruct m as [|m].
  - cbn. rewrite upto_zero. lia.
  - destruct d as [|d]; [cbn; lia|]. unfold central_regions. rewrite upto_step. lia.
Qed.

Lemma central_nonneg m d : 0 <= central_regions m d.
Proof. destruct m, d; cbn; try lia. pose proof (upto_positive m d). lia. Qed.

Lemma central_grows m m' d d' : (m <= m')%nat -> (d <= d')%nat ->
  (1 <= d')%nat \/ (1 <= m)%nat -> central_regions m d <= central_regions m' d'.
Proof.
  intros M D C. destruct m as [|m].
  - destruct m'; cbn; [lia|]. destruct d'; [lia|]. pose proof (upto_positive m' d'). lia.
  - destruct m' as [|m']; [lia|]. destruct d as [|d]; [apply central_nonneg|].
    destruct d' as [|d']; [lia|]. cbn [central_regions].
    assert (choose_upto m d <= choose_upto m' d) by (apply upto_grows_many; lia).
    assert (choose_upto m' d <= choose_upto m' d') by (apply upto_wider; lia). lia.
Qed.

Open Scope R_scope.

(** * Coordinates that forms depend on *)

Definition within (D : list nat) (f : form R) : Prop := forall j, slope f j <> 0 -> In j D.

Lemma along_unit f j : along f (move origin j 1) = slope f j.
Proof. rewrite along_move. unfold along. rewrite linear_origin. ring. Qed.

Lemma slope_restrict h g i : look_real h = Plane ->
  slope (restrict_real h g) i =
  slope g i - slope h i * (slope g (pivot_real (coefficients h)) / slope h (pivot_real (coefficients h))).
Proof.
  intros _. rewrite <- (along_unit (restrict_real h g)), <- (along_unit g i), <- (along_unit h i).
  unfold along, restrict_real. cbn. rewrite linear_less. ring.
Qed.

Lemma within_restrict D h g : look_real h = Plane -> within D h -> within D g ->
  within (remove Nat.eq_dec (pivot_real (coefficients h)) D) (restrict_real h g).
Proof.
  intros L H G i S. pose proof (@look_real_slope h L) as P.
  rewrite slope_restrict in S by trivial.
  destruct (Nat.eq_dec i (pivot_real (coefficients h))) as [->|N].
  - exfalso. apply S. field. trivial.
  - apply in_in_remove; trivial. destruct (Req_dec (slope g i) 0) as [E|E]; [|now apply G].
    apply H. intros F. apply S. rewrite E, F. ring.
Qed.

Lemma central_restrict h g : central h -> central g -> central (restrict_real h g).
Proof. unfold central, restrict_real. cbn. intros -> ->. ring. Qed.

Lemma pivot_within D h : look_real h = Plane -> within D h ->
  (length (remove Nat.eq_dec (pivot_real (coefficients h)) D) < length D)%nat.
Proof. intros L W. apply remove_length_lt, W, look_real_slope, L. Qed.

Lemma within_nil f : within [] f -> look_real f <> Plane.
Proof. intros W L. apply look_real_slope, W in L. destruct L. Qed.

Lemma central_look f : central f -> look_real f <> Constant.
Proof.
  unfold central, look_real. intros ->. destruct (flat_real _); [|easy].
  now destruct (Req_EM_T 0 0).
Qed.

Lemma onto_all (P Q : form R -> Prop) r B : (forall g, P g -> Q (r g)) -> Forall P B ->
  forall B', onto look_real r B = Some B' -> Forall Q B' /\ (length B' <= length B)%nat.
Proof.
  intros H. induction 1 as [|g B G A IH]; cbn; intros B' E.
  - injection E as <-. auto.
  - destruct (look_real (r g)); [easy| |].
    + destruct (IH _ E). auto.
    + destruct (onto look_real r B); [|easy]. injection E as <-. destruct (IH _ eq_refl).
      split; [constructor; auto|cbn; lia].
Qed.

Lemma skim_all (P Q : form R -> Prop) r A : (forall g, P g -> Q (r g)) -> Forall P A ->
  Forall Q (skim look_real r A).
Proof.
  intros H. induction 1 as [|g A G _ IH]; cbn; [constructor|].
  destruct (look_real (r g)); auto.
Qed.

Open Scope Z_scope.

(** * Bounds on regions *)

Lemma regions_nonneg n B : (length B <= n)%nat -> 0 <= regions look_real restrict_real n B.
Proof.
  intros L. apply number_nonneg with (P := region (map (fun f => f) B)).
  now apply (@regions_count _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane).
Qed.

Lemma regions_bound n : forall D B, (length B <= n)%nat -> Forall (within D) B ->
  regions look_real restrict_real n B <= choose_upto (length B) (length D).
Proof.
  induction n as [|n IH]; intros D [|h B] L W; try (cbn in L; lia).
  - cbn. rewrite upto_zero. lia.
  - cbn. rewrite upto_zero. lia.
  - cbn in L. inversion W as [|? ? Wh WB]; subst. cbn [regions length].
    pose proof (upto_positive (S (length B)) (length D)).
    destruct (look_real h) eqn:K; [lia| |].
    + pose proof (IH D B ltac:(lia) WB). pose proof (upto_grows (length B) (length D)). lia.
    + pose proof (IH D B ltac:(lia) WB). pose proof (@pivot_within D h K Wh) as Less.
      destruct (length D) as [|d] eqn:E; [lia|]. rewrite upto_step.
      destruct (onto look_real (restrict_real h) B) as [B'|] eqn:O;
      [|pose proof (upto_positive (length B) d); lia].
      destruct (@onto_all (within D) (within (remove Nat.eq_dec (pivot_real (coefficients h)) D))
        (restrict_real h) B (fun g => @within_restrict D h g K Wh) WB B' O) as [W' L'].
      pose proof (IH _ B' ltac:(lia) W').
      pose proof (@upto_grows_many _ _ (length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) L').
      pose proof (@upto_wider (length B) (length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) d
        ltac:(lia)). lia.
Qed.

Lemma central_onto h B B' : Forall central (h :: B) ->
  onto look_real (restrict_real h) B = Some B' -> length B' = length B.
Proof.
  intros C. inversion C as [|? ? Ch CB]; subst. revert B'. clear C.
  induction CB as [|g B Cg CB IH]; cbn; intros B' E; [now injection E as <-|].
  pose proof (@central_look _ (@central_restrict h g Ch Cg)).
  destruct (look_real (restrict_real h g)); [easy|easy|].
  destruct (onto look_real (restrict_real h) B); [|easy]. injection E as <-.
  cbn. now rewrite IH.
Qed.

Lemma central_regions_bound n : forall D B, (length B <= n)%nat ->
  Forall (within D) B -> Forall central B ->
  regions look_real restrict_real n B <= central_regions (length B) (length D).
Proof.
  induction n as [|n IH]; intros D [|h B] L W C; try (cbn in L; lia); try (cbn; lia).
  cbn in L. inversion W as [|? ? Wh WB]; subst. inversion C as [|? ? Ch CB]; subst.
  cbn [regions length]. pose proof (central_nonneg (S (length B)) (length D)).
  destruct (look_real h) eqn:K; [lia|now destruct (@central_look h Ch)|].
  pose proof (IH D B ltac:(lia) WB CB). pose proof (@pivot_within D h K Wh) as Less.
  destruct (length D) as [|d] eqn:E; [lia|]. rewrite central_step.
  destruct (onto look_real (restrict_real h) B) as [B'|] eqn:O;
  [|pose proof (central_nonneg (length B) d); lia].
  destruct (@onto_all (within D) (within (remove Nat.eq_dec (pivot_real (coefficients h)) D))
    (restrict_real h) B (fun g => @within_restrict D h g K Wh) WB B' O) as [W' _].
  destruct (@onto_all central central (restrict_real h) B (fun g => @central_restrict h g Ch) CB B' O)
    as [C' _].
  pose proof (@central_onto h B B' C O) as Len.
  pose proof (IH _ B' ltac:(lia) W' C') as H1. rewrite Len in H1.
  destruct B as [|b B]; [cbn in *; lia|].
  pose proof (@central_grows (length (b :: B)) (length (b :: B))
    (length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) d ltac:(lia) ltac:(lia)
    ltac:(right; cbn; lia)). lia.
Qed.

(** * Bounds on faces *)

Lemma nth_sum k : forall l l', nth k (sum l l') 0 = nth k l 0 + nth k l' 0.
Proof.
  induction k as [|k IH]; intros [|a l] [|b l']; cbn; try lia; rewrite ?IH; destruct k; cbn; try lia.
Qed.

Lemma choose_grows_many n n' k : (n <= n')%nat -> choose n k <= choose n' k.
Proof. induction 1; [lia|]. pose proof (choose_grows m k). lia. Qed.

Section Faces.

(** [P D f]: f is of the kind looked at and depends on the coordinates D. *)
Variable P : list nat -> form R -> Prop.
Variable bound : nat -> nat -> Z.
Variable low : nat.
Hypothesis P_restrict : forall D h g, look_real h = Plane -> P D h -> P D g ->
  P (remove Nat.eq_dec (pivot_real (coefficients h)) D) (restrict_real h g).
Hypothesis P_within : forall D f, P D f -> within D f.
Hypothesis bound_nonneg : forall m d, 0 <= bound m d.
Hypothesis bound_grows : forall m m' d, (m <= m')%nat -> (low <= d)%nat -> bound m d <= bound m' d.
Hypothesis bound_regions : forall D d B, Forall (P D) B -> (length D <= d)%nat -> (low <= d)%nat ->
  regions look_real restrict_real (length B) B <= bound (length B) d.

Lemma faces_bound n : forall D d nz A k,
  (length A <= n)%nat -> (length D <= d)%nat -> (k + low <= d)%nat ->
  Forall (P D) nz -> Forall (P D) A ->
  nth k (faces look_real restrict_real n nz A) 0 <=
  choose (length A) k * bound (length nz + length A - k) (d - k).
Proof.
  assert (forall a a' b b', 0 <= a <= a' -> 0 <= b <= b' -> a * b <= a' * b') as Product
    by (intros; nia).
  assert (forall D d nz k, (length D <= d)%nat -> (k + low <= d)%nat -> Forall (P D) nz ->
    nth k [regions look_real restrict_real (length nz) nz] 0 <=
    choose 0 k * bound (length nz + 0 - k) (d - k)) as Nil.
  { intros D d nz [|k] L K N.
    - rewrite choose_none, Nat.add_0_r, !Nat.sub_0_r. cbn [nth].
      pose proof (@bound_regions D d nz N L ltac:(lia)). lia.
    - replace (nth (S k) [regions look_real restrict_real (length nz) nz] 0) with 0 by now destruct k.
      cbn. lia. }
  induction n as [|n IH]; intros D d nz [|h A] k L LD K N W; try (cbn in L; lia);
    try (now apply Nil with D).
  cbn in L. inversion W as [|? ? Wh WA]; subst. cbn [faces length].
  pose proof (choose_nonneg (length A) k).
  assert (choose (length A) k * bound (length nz + length A - k) (d - k) <=
    choose (S (length A)) k * bound (length nz + S (length A) - k) (d - k)).
  { apply Product; (split; [auto|]); [apply choose_grows|apply bound_grows; lia]. }
  destruct (look_real h) eqn:Kind;
    try (pose proof (IH D d nz A k ltac:(lia) LD K N WA); lia).
  rewrite nth_sum. pose proof (IH D d (h :: nz) A k ltac:(lia) LD K ltac:(now constructor) WA) as H1.
  cbn [length] in H1. replace (S (length nz) + length A - k)%nat with
    (length nz + S (length A) - k)%nat in H1 by lia.
  assert (nth k match onto look_real (restrict_real h) nz with
    | Some nz' => 0 :: faces look_real restrict_real n nz' (skim look_real (restrict_real h) A)
    | None => [] end 0 <= match k with O => 0 | S k =>
      choose (length A) k * bound (length nz + length A - k) (d - S k) end) as H2.
  { pose proof (choose_nonneg (length A) (pred k)).
    destruct (onto look_real (restrict_real h) nz) as [nz'|] eqn:O.
    2: { replace (nth k [] 0) with 0 by now destruct k. destruct k as [|k]; [lia|].
         cbn [pred] in *. pose proof (bound_nonneg (length nz + length A - k) (d - S k)). nia. }
    destruct k as [|k]; cbn [nth pred] in *; [lia|].
    set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D).
    destruct (@onto_all (P D) (P D') (restrict_real h) nz
      (fun g => @P_restrict D h g Kind Wh) N nz' O) as [N' LN].
    pose proof (@skim_all (P D) (P D') (restrict_real h) A (fun g => @P_restrict D h g Kind Wh) WA)
      as W'.
    pose proof (@pivot_within D h Kind (@P_within D h Wh)) as Less. fold D' in Less.
    pose proof (skim_length look_real (restrict_real h) A) as LA.
    pose proof (IH D' (d - 1)%nat nz' (skim look_real (restrict_real h) A) k ltac:(lia) ltac:(lia)
      ltac:(lia) N' W') as H3.
    replace (d - 1 - k)%nat with (d - S k)%nat in H3 by lia.
    eapply Z.le_trans; [exact H3|]. apply Product; split.
    - apply choose_nonneg.
    - now apply choose_grows_many.
    - apply bound_nonneg.
    - apply bound_grows; lia. }
  destruct k as [|k]; [rewrite choose_none in *; lia|].
  change (choose (S (length A)) (S k)) with (choose (length A) k + choose (length A) (S k)).
  replace (length nz + S (length A) - S k)%nat with (length nz + length A - k)%nat in * by lia. lia.
Qed.

End Faces.

(** * Planes of R^d *)

Lemma of_space_within d planes : of_space d planes -> Forall (within (seq 0 d)) planes.
Proof.
  apply Forall_impl. intros f L j S. apply in_seq. split; [lia|].
  destruct (Nat.lt_ge_cases j d) as [|G]; [lia|]. exfalso. apply S. unfold slope.
  apply nth_overflow. lia.
Qed.

Lemma of_space_central d planes : of_space d planes -> Forall central planes ->
  Forall (fun f => within (seq 0 d) f /\ central f) planes.
Proof.
  intros S%of_space_within C. rewrite Forall_forall in *. auto.
Qed.

Theorem affine_faces_at_most d planes k n : of_space d planes -> (k <= d)%nat ->
  number (face_of_codimension k planes) n ->
  n <= choose (length planes) k * choose_upto (length planes - k) (d - k).
Proof.
  intros S K N. rewrite (number_unique N (faces_real_count planes k)).
  refine (@faces_bound within choose_upto 0 _ _ _ _ _ (length planes) (seq 0 d) d [] planes k
    _ _ _ _ _); trivial.
  - apply within_restrict.
  - intros m d0. pose proof (upto_positive m d0). lia.
  - intros. now apply upto_grows_many.
  - intros D d0 B W L _. pose proof (@regions_bound (length B) D B (le_n _) W).
    pose proof (@upto_wider (length B) _ _ L). lia.
  - now rewrite seq_length.
  - lia.
  - now apply of_space_within.
Qed.

Theorem central_faces_at_most d planes k n : of_space d planes -> Forall central planes ->
  (k < d)%nat -> number (face_of_codimension k planes) n ->
  n <= choose (length planes) k * central_regions (length planes - k) (d - k).
Proof.
  intros S C K N. rewrite (number_unique N (faces_real_count planes k)).
  refine (@faces_bound (fun D f => within D f /\ central f) central_regions 1 _ _ _ _ _
    (length planes) (seq 0 d) d [] planes k _ _ _ _ _); trivial.
  - intros D h g L [] []. split; [now apply within_restrict|now apply central_restrict].
  - tauto.
  - apply central_nonneg.
  - intros. apply central_grows; lia.
  - intros D d0 B W L G.
    pose proof (@central_regions_bound (length B) D B (le_n _)
      ltac:(eapply Forall_impl; [|exact W]; cbn; tauto)
      ltac:(eapply Forall_impl; [|exact W]; cbn; tauto)).
    pose proof (@central_grows (length B) (length B) _ d0 (le_n _) L ltac:(lia)). lia.
  - now rewrite seq_length.
  - lia.
  - now apply of_space_central.
Qed.

Theorem affine_regions_at_most d planes n : of_space d planes ->
  number (region planes) n -> n <= choose_upto (length planes) d.
Proof.
  intros S N. rewrite (number_unique N (regions_real_count planes)).
  replace (choose_upto (length planes) d) with (choose_upto (length planes) (length (seq 0 d)))
    by now rewrite seq_length.
  apply regions_bound; trivial. now apply of_space_within.
Qed.

Theorem central_regions_at_most d planes n : of_space d planes -> Forall central planes ->
  number (region planes) n -> n <= central_regions (length planes) d.
Proof.
  intros S C N. rewrite (number_unique N (regions_real_count planes)).
  replace (central_regions (length planes) d)
    with (central_regions (length planes) (length (seq 0 d))) by now rewrite seq_length.
  apply central_regions_bound; trivial.
  now apply of_space_within.
Qed.
