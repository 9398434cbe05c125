(** Planes some of which pass through the origin: how many faces they have at most. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Sphere Graph Crossed.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

Local Notation rho B := (regions look_real restrict_real (length B) B).

(** The most regions of b planes of R^d, and c more through the origin. *)
Fixpoint mixed (b c d : nat) : Z :=
  match b, d with
  | S b, S d => mixed b c (S d) + choose_upto (b + c) d
  | _, _ => central_regions c d
  end.

Lemma mixed_total b c d : mixed b c (S d) = central_regions c (S d) + total (fun i => choose_upto (c + i) d) b.
Proof.
  induction b as [|b IH]; [cbn; lia|]. cbn [mixed total]. rewrite IH, (Nat.add_comm b c). lia.
Qed.

Lemma mixed_flat b c : mixed b c 0 = central_regions c 0.
Proof. now destruct b. Qed.

Lemma mixed_step b c d : mixed b (S c) (S d) = mixed b c (S d) + mixed b c d.
Proof.
  induction b as [|b IH]; [cbn [mixed]; apply central_step|]. cbn [mixed]. rewrite IH.
  destruct d as [|d]; [rewrite mixed_flat; cbn; lia|]. cbn [mixed].
  rewrite <- plus_n_Sm, upto_step. lia.
Qed.

Lemma mixed_nonneg b c d : 0 <= mixed b c d.
Proof.
  destruct d as [|d]; [rewrite mixed_flat; apply central_nonneg|].
  induction b as [|b IH]; [apply central_nonneg|]. cbn [mixed]. pose proof (upto_positive (b + c) d). lia.
Qed.

Lemma mixed_upto b c d : mixed b c d <= choose_upto (b + c) d.
Proof.
  destruct d as [|d]; [rewrite mixed_flat; destruct c; cbn; lia|].
  induction b as [|b IH]; [apply central_upto|]. cbn [mixed]. rewrite Nat.add_succ_l, upto_step. lia.
Qed.

(** A plane through the origin makes no more regions than one anywhere. *)
Lemma mixed_trade b c d : mixed b (S c) d <= mixed (S b) c d.
Proof.
  destruct d as [|d]; [rewrite !mixed_flat; pose proof (central_nonneg c 0); cbn in *; lia|].
  rewrite mixed_step. cbn [mixed]. pose proof (mixed_upto b c d). lia.
Qed.

Lemma mixed_trades b c c' d : mixed b (c + c') d <= mixed (b + c) c' d.
Proof.
  revert b. induction c as [|c IH]; intros b; [rewrite Nat.add_0_r; cbn; lia|].
  pose proof (mixed_trade b (c + c') d) as H. pose proof (IH (S b)) as H1.
  replace (b + S c)%nat with (S b + c)%nat by lia. cbn [Nat.add] in *. lia.
Qed.

Lemma mixed_grows_b b b' c d : (b <= b')%nat -> mixed b c d <= mixed b' c d.
Proof.
  induction 1 as [|b' L IH]; [lia|]. destruct d as [|d]; [now rewrite !mixed_flat|].
  cbn [mixed]. pose proof (upto_positive (b' + c) d). lia.
Qed.

Lemma mixed_grows_c b c c' d : (c <= c')%nat -> mixed b c (S d) <= mixed b c' (S d).
Proof.
  induction 1 as [|c' L IH]; [lia|]. rewrite mixed_step. pose proof (mixed_nonneg b c' d). lia.
Qed.

Lemma mixed_grows_d b c d : mixed b c d <= mixed b c (S d).
Proof.
  revert c d. induction b as [|b IH]; intros c d.
  - cbn [mixed]. destruct c; [cbn; lia|]. apply central_grows; lia.
  - destruct d as [|d].
    + rewrite mixed_flat. cbn [mixed]. pose proof (IH c 0%nat) as H. rewrite mixed_flat in H.
      pose proof (upto_positive (b + c) 0). lia.
    + cbn [mixed]. pose proof (IH c (S d)). pose proof (@upto_wider (b + c) d (S d) ltac:(lia)). lia.
Qed.

Lemma mixed_grows b b' c d d' : (b <= b')%nat -> (d <= d')%nat -> mixed b c d <= mixed b' c d'.
Proof.
  intros B. induction 1 as [|d' L IH]; [now apply mixed_grows_b|].
  pose proof (mixed_grows_d b' c d'). lia.
Qed.

(** Forms that are not 0 at the origin, and those that are. *)
Definition away (f : form R) : bool := if Req_EM_T (constant f) 0 then false else true.
Definition aways (B : list (form R)) : nat := length (filter away B).
Definition throughs (B : list (form R)) : nat := length (filter (fun f => negb (away f)) B).

Lemma away_central f : away f = false -> central f.
Proof. unfold away, central. now destruct (Req_EM_T (constant f) 0). Qed.

Lemma central_away f : central f -> away f = false.
Proof. unfold away, central. now destruct (Req_EM_T (constant f) 0). Qed.

Lemma away_restrict h g : central h -> away (restrict_real h g) = away g.
Proof.
  unfold central, away, restrict_real. cbn. intros ->.
  replace (constant g - slope g (pivot_real (coefficients h)) / slope h (pivot_real (coefficients h)) * 0)%R
    with (constant g) by ring. reflexivity.
Qed.

Lemma aways_cons f B : aways (f :: B) = ((if away f then 1 else 0) + aways B)%nat.
Proof. unfold aways. cbn. now destruct (away f). Qed.

Lemma throughs_cons f B : throughs (f :: B) = ((if away f then 0 else 1) + throughs B)%nat.
Proof. unfold throughs. cbn. now destruct (away f). Qed.

Lemma aways_length B : (aways B + throughs B = length B)%nat.
Proof. induction B as [|f B IH]; trivial. rewrite aways_cons, throughs_cons. cbn. destruct (away f); lia. Qed.

Lemma onto_mixed h B : central h -> forall B', onto look_real (restrict_real h) B = Some B' ->
  (aways B' <= aways B)%nat /\ throughs B' = throughs B.
Proof.
  intros C. induction B as [|g B IH]; cbn [onto]; intros B' O; [injection O as <-; auto|].
  destruct (look_real (restrict_real h g)) eqn:L; [easy| |].
  - destruct (IH _ O). rewrite aways_cons, throughs_cons. destruct (away g) eqn:A; [lia|].
    destruct (@central_look (restrict_real h g)); trivial. now apply central_restrict, away_central.
  - destruct (onto look_real (restrict_real h) B) as [B1|]; [|easy]. injection O as <-.
    destruct (IH _ eq_refl). rewrite !aways_cons, !throughs_cons, away_restrict by trivial. destruct (away g); lia.
Qed.

Lemma mixed_regions n : forall D d B, (length B <= n)%nat -> (length D <= d)%nat -> Forall (within D) B ->
  regions look_real restrict_real n B <= mixed (aways B) (throughs B) d.
Proof.
  induction n as [|n IH]; intros D d [|h B] L LD W; try (cbn in L; lia); try (cbn; lia).
  cbn in L. inversion W as [|? ? Wh WB]; subst. rewrite aways_cons, throughs_cons. cbn [regions].
  pose proof (mixed_nonneg ((if away h then 1 else 0) + aways B) ((if away h then 0 else 1) + throughs B) d).
  destruct (look_real h) eqn:K; trivial.
  - pose proof (IH D d B ltac:(lia) LD WB). destruct (away h) eqn:A.
    + pose proof (@mixed_grows (aways B) (1 + aways B) (throughs B) d d ltac:(lia) ltac:(lia)). cbn [Nat.add] in *. lia.
    + destruct (@central_look h); trivial. now apply away_central.
  - pose proof (@pivot_within D h K Wh) as Less. destruct d as [|d]; [lia|].
    pose proof (IH D (S d) B ltac:(lia) LD WB) as H1.
    assert (forall B', onto look_real (restrict_real h) B = Some B' ->
      Forall (within (remove Nat.eq_dec (pivot_real (coefficients h)) D)) B' /\ (length B' <= length B)%nat) as On.
    { apply onto_all with (P := within D); trivial. intros g G. now apply within_restrict. }
    destruct (away h) eqn:A; cbn [Nat.add mixed].
    + destruct (onto look_real (restrict_real h) B) as [B'|]; [|pose proof (upto_positive (aways B + throughs B) d); lia].
      destruct (On _ eq_refl) as [W' L'].
      pose proof (@regions_bound n _ B' ltac:(lia) W'). rewrite aways_length.
      pose proof (@upto_grows_many _ _ (length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) L').
      pose proof (@upto_wider (length B) (length (remove Nat.eq_dec (pivot_real (coefficients h)) D)) d ltac:(lia)). lia.
    + rewrite mixed_step. pose proof (mixed_nonneg (aways B) (throughs B) d).
      destruct (onto look_real (restrict_real h) B) as [B'|] eqn:O; [|lia].
      destruct (On _ eq_refl) as [W' L'], (@onto_mixed h B (away_central h A) _ O) as [Ab Tb].
      pose proof (IH (remove Nat.eq_dec (pivot_real (coefficients h)) D) d B' ltac:(lia) ltac:(lia) W') as H2. rewrite Tb in H2.
      pose proof (@mixed_grows (aways B') (aways B) (throughs B) d d Ab ltac:(lia)). lia.
Qed.

(** Faces of planes A through the origin, where forms [nz] are not 0. *)
Lemma mixed_faces n : forall D d nz A k, (length A <= n)%nat -> (length D <= d)%nat -> (k < d)%nat ->
  Forall (within D) nz -> Forall (within D) A -> Forall central A ->
  nth k (faces look_real restrict_real n nz A) 0 <=
  choose (length A) k * mixed (aways nz) (throughs nz + length A - k) (d - k).
Proof.
  assert (forall a a' b b', 0 <= a <= a' -> 0 <= b <= b' -> a * b <= a' * b') as Product by (intros; nia).
  assert (forall D d nz k, (length D <= d)%nat -> (k < d)%nat -> Forall (within D) nz ->
    nth k [regions look_real restrict_real (length nz) nz] 0 <=
    choose 0 k * mixed (aways nz) (throughs nz + 0 - k) (d - k)) as Nil.
  { intros D d nz [|k] L K N.
    - rewrite choose_none, Nat.add_0_r, !Nat.sub_0_r. cbn [nth].
      pose proof (@mixed_regions (length nz) D d nz (le_n _) L N). lia.
    - replace (nth (S k) _ 0) with 0 by now destruct k. cbn. lia. }
  induction n as [|n IH]; intros D d nz [|h A] k L LD K N W C; try (cbn in L; lia); try (now apply Nil with D).
  cbn in L. inversion W as [|? ? Wh WA]; subst. inversion C as [|? ? Ch CA]; subst. cbn [faces length].
  pose proof (choose_nonneg (length A) k).
  destruct (d - k)%nat as [|e] eqn:Ed; [lia|].
  destruct (look_real h) eqn:Kind.
  1, 2: eapply Z.le_trans; [apply (IH D d nz A k); trivial; lia|]; rewrite Ed; apply Product; split;
    [apply choose_nonneg|apply choose_grows|apply mixed_nonneg|apply mixed_grows_c; lia].
  rewrite nth_sum.
  pose proof (IH D d (h :: nz) A k ltac:(lia) LD K ltac:(now constructor) WA CA) as H1.
  rewrite aways_cons, throughs_cons, (central_away Ch), Ed in H1. cbn [Nat.add] in H1.
  replace (S (throughs nz + length A) - k)%nat with (throughs nz + S (length A) - k)%nat in H1 by lia.
  destruct k as [|k].
  { rewrite choose_none in *. destruct (onto look_real (restrict_real h) nz); cbn [nth]; lia. }
  change (choose (S (length A)) (S k)) with (choose (length A) k + choose (length A) (S k)).
  enough (nth (S k) match onto look_real (restrict_real h) nz with
    | Some nz' => 0 :: faces look_real restrict_real n nz' (skim look_real (restrict_real h) A)
    | None => [] end 0 <= choose (length A) k * mixed (aways nz) (throughs nz + S (length A) - S k) (S e)) by lia.
  pose proof (choose_nonneg (length A) k). pose proof (mixed_nonneg (aways nz) (throughs nz + S (length A) - S k) (S e)).
  destruct (onto look_real (restrict_real h) nz) as [nz'|] eqn:O; cbn [nth]; [|nia].
  set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D).
  destruct (@onto_all (within D) (within D') (restrict_real h) nz
    (fun g => @within_restrict D h g Kind Wh) N nz' O) as [N' _].
  destruct (@onto_mixed h nz Ch _ O) as [Ab Tb].
  pose proof (@skim_all (within D) (within D') (restrict_real h) A (fun g => @within_restrict D h g Kind Wh) WA) as W'.
  pose proof (@skim_all central central (restrict_real h) A (fun g => @central_restrict h g Ch) CA) as C'.
  pose proof (@pivot_within D h Kind Wh) as Less. fold D' in Less.
  pose proof (skim_length look_real (restrict_real h) A) as LA.
  eapply Z.le_trans; [apply (IH D' (d - 1)%nat); trivial; lia|]. rewrite Tb.
  replace (d - 1 - k)%nat with (S e) by lia. apply Product; split.
  - apply choose_nonneg.
  - now apply choose_grows_many.
  - apply mixed_nonneg.
  - eapply Z.le_trans; [exact (@mixed_grows_b (aways nz') (aways nz) _ _ Ab)|]. apply mixed_grows_c. lia.
Qed.

(** The origin: where all of A are 0, if no form of [nz] is 0 there. *)
Lemma mixed_points n : forall D nz A k, (length A <= n)%nat -> (length D <= k)%nat ->
  Forall (within D) nz -> Forall (within D) A -> Forall central A ->
  nth k (faces look_real restrict_real n nz A) 0 <=
    if (length D =? k)%nat then if (throughs nz =? 0)%nat then 1 else 0 else 0.
Proof.
  assert (forall D nz k, (length D <= k)%nat -> Forall (within D) nz ->
    nth k [regions look_real restrict_real (length nz) nz] 0 <=
      if (length D =? k)%nat then if (throughs nz =? 0)%nat then 1 else 0 else 0) as Nil.
  { intros D nz [|k] L W.
    - assert (length D = O) as E by lia. rewrite E. cbn [Nat.eqb nth].
      pose proof (@mixed_regions (length nz) D 0 nz (le_n _) L W) as H. rewrite mixed_flat in H.
      destruct (throughs nz); cbn in *; lia.
    - replace (nth (S k) _ 0) with 0 by now destruct k. destruct (_ =? _)%nat; [destruct (_ =? _)%nat|]; lia. }
  induction n as [|n IH]; intros D nz [|h A] k L LD N W C; try (cbn in L; lia); try (now apply Nil).
  cbn in L. inversion W as [|? ? Wh WA]; subst. inversion C as [|? ? Ch CA]; subst. cbn [faces].
  destruct (look_real h) eqn:Kind; try (apply IH; trivial; lia).
  rewrite nth_sum. pose proof (@pivot_within D h Kind Wh) as Less.
  set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D) in *.
  pose proof (IH D (h :: nz) A k ltac:(lia) LD ltac:(now constructor) WA CA) as H1.
  rewrite throughs_cons, (central_away Ch) in H1. cbn [Nat.add Nat.eqb] in H1.
  replace (if (length D =? k)%nat then 0 else 0) with 0 in H1 by now destruct (length D =? k)%nat.
  destruct (onto look_real (restrict_real h) nz) as [nz'|] eqn:O.
  - destruct k as [|k]; [lia|]. cbn [nth].
    destruct (@onto_all (within D) (within D') (restrict_real h) nz
      (fun g => @within_restrict D h g Kind Wh) N nz' O) as [N' _].
    destruct (@onto_mixed h nz Ch _ O) as [_ Tb].
    pose proof (@skim_all (within D) (within D') (restrict_real h) A (fun g => @within_restrict D h g Kind Wh) WA) as W'.
    pose proof (@skim_all central central (restrict_real h) A (fun g => @central_restrict h g Ch) CA) as C'.
    pose proof (skim_length look_real (restrict_real h) A).
    pose proof (IH D' nz' (skim look_real (restrict_real h) A) k ltac:(lia) ltac:(lia) N' W' C') as H2.
    rewrite Tb in H2. destruct (Nat.eqb_spec (length D) (S k)), (Nat.eqb_spec (length D') k); try lia;
    destruct (throughs nz =? 0)%nat; lia.
  - replace (nth k [] 0) with 0 by now destruct k. destruct (_ =? _)%nat; [destruct (_ =? _)%nat|]; lia.
Qed.

(** Any forms: the bound for affine planes, with forms that are not 0. *)
Lemma upto_faces n D d nz A k : (length A <= n)%nat -> (length D <= d)%nat -> (k <= d)%nat ->
  Forall (within D) nz -> Forall (within D) A ->
  nth k (faces look_real restrict_real n nz A) 0 <=
  choose (length A) k * choose_upto (length nz + length A - k) (d - k).
Proof.
  intros L LD K N W. refine (@faces_bound within choose_upto 0 _ _ _ _ _ n D d nz A k _ _ _ _ _); trivial.
  - apply within_restrict.
  - intros m d0. pose proof (upto_positive m d0). lia.
  - intros. now apply upto_grows_many.
  - intros D0 d0 B W0 L0 _. pose proof (@regions_bound (length B) D0 B (le_n _) W0).
    pose proof (@upto_wider (length B) _ _ L0). lia.
  - lia.
Qed.

Lemma choose_over n : forall k, (n < k)%nat -> choose n k = 0.
Proof.
  induction n as [|n IH]; intros [|k] L; try lia; trivial.
  change (choose (S n) (S k)) with (choose n k + choose n (S k)). rewrite !IH by lia. lia.
Qed.

(** Faces of codimension k of q planes anywhere and p through the origin, where m forms are not 0. *)
Definition most_mixed (m q p d k : nat) : Z :=
  match k with O => 0 | S k' =>
    total (fun i => choose (p + i) k') q * choose_upto (m + q + p - k) (d - k) end +
  (if (k <? d)%nat then choose p k * mixed (m + q) (p - k) (d - k) else 1).

Lemma total_nonneg a n : (forall i, 0 <= a i) -> 0 <= total a n.
Proof. intros H. induction n as [|n IH]; cbn; [lia|]. specialize (H n). lia. Qed.

Lemma most_skip m q p d k : most_mixed m q p d k <= most_mixed m (S q) p d k.
Proof.
  unfold most_mixed. apply Z.add_le_mono.
  - destruct k as [|k]; [lia|]. pose proof (total_nonneg (fun i => choose (p + i) k) q (fun i => choose_nonneg _ _)).
    pose proof (choose_nonneg (p + q) k). cbn [total].
    pose proof (@upto_grows_many (m + q + p - S k) (m + S q + p - S k) (d - S k) ltac:(lia)).
    pose proof (upto_positive (m + q + p - S k) (d - S k)). nia.
  - destruct (k <? d)%nat; [|lia]. apply Z.mul_le_mono_nonneg_l; [apply choose_nonneg|]. apply mixed_grows_b. lia.
Qed.

Lemma mixed_all N : forall n D d nz T k, (length (N ++ T) <= n)%nat -> (length D <= d)%nat -> (k <= d)%nat ->
  Forall (within D) nz -> Forall (within D) (N ++ T) -> Forall central T ->
  nth k (faces look_real restrict_real n nz (N ++ T)) 0 <= most_mixed (length nz) (length N) (length T) d k.
Proof.
  induction N as [|h N IH]; intros n D d nz T k L LD K Z W C.
  { unfold most_mixed. cbn [app length total] in *. rewrite Nat.add_0_r.
    replace (match k with O => 0 | S _ => _ end) with 0 by now destruct k.
    destruct (Nat.ltb_spec k d) as [Less|More].
    - eapply Z.le_trans; [apply (@mixed_faces n D d nz T k L LD Less Z W C)|].
      destruct (Nat.le_gt_cases k (length T)) as [Le|Gt].
      + apply Z.mul_le_mono_nonneg_l; [apply choose_nonneg|]. rewrite <- (aways_length nz).
        pose proof (mixed_trades (aways nz) (throughs nz) (length T - k) (d - k)).
        now replace (throughs nz + length T - k)%nat with (throughs nz + (length T - k))%nat by lia.
      + rewrite choose_over by trivial. lia.
    - pose proof (@mixed_points n D nz T k L ltac:(lia) Z W C).
      destruct (length D =? k)%nat; [destruct (throughs nz =? 0)%nat|]; lia. }
  destruct n as [|n]; [cbn in L; lia|]. cbn [app length faces] in *.
  inversion W as [|? ? Wh WA]; subst.
  destruct (look_real h) eqn:Kind.
  1, 2: eapply Z.le_trans; [apply (IH n D d nz T k); trivial; lia|apply most_skip].
  rewrite nth_sum.
  pose proof (IH n D d (h :: nz) T k ltac:(lia) LD K ltac:(now constructor) WA C) as H1.
  unfold most_mixed in *. cbn [length] in H1.
  replace (S (length nz) + length N)%nat with (length nz + S (length N))%nat in H1 by lia.
  destruct k as [|k].
  { destruct (onto look_real (restrict_real h) nz); cbn [nth]; lia. }
  cbn [total].
  enough (nth (S k) match onto look_real (restrict_real h) nz with
    | Some nz' => 0 :: faces look_real restrict_real n nz' (skim look_real (restrict_real h) (N ++ T))
    | None => [] end 0 <=
    choose (length T + length N) k * choose_upto (length nz + S (length N) + length T - S k) (d - S k)) by lia.
  pose proof (choose_nonneg (length T + length N) k).
  pose proof (upto_positive (length nz + S (length N) + length T - S k) (d - S k)).
  destruct (onto look_real (restrict_real h) nz) as [nz'|] eqn:O; cbn [nth]; [|nia].
  set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D).
  destruct (@onto_all (within D) (within D') (restrict_real h) nz
    (fun g => @within_restrict D h g Kind Wh) Z nz' O) as [N' LN].
  pose proof (@skim_all (within D) (within D') (restrict_real h) (N ++ T)
    (fun g => @within_restrict D h g Kind Wh) WA) as W'.
  pose proof (@pivot_within D h Kind Wh) as Less. fold D' in Less.
  pose proof (skim_length look_real (restrict_real h) (N ++ T)) as LA.
  set (A := skim look_real (restrict_real h) (N ++ T)) in *.
  pose proof (@upto_faces n D' (d - 1)%nat nz' A k ltac:(lia) ltac:(lia) ltac:(lia) N' W') as H2.
  replace (d - 1 - k)%nat with (d - S k)%nat in H2 by lia. rewrite app_length in LA.
  pose proof (@choose_grows_many (length A) (length T + length N) k ltac:(lia)).
  pose proof (@upto_grows_many (length nz' + length A - k)
    (length nz + S (length N) + length T - S k) (d - S k) ltac:(lia)).
  pose proof (choose_nonneg (length A) k). pose proof (upto_positive (length nz' + length A - k) (d - S k)). nia.
Qed.
