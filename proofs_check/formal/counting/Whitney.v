(** The printed polynomial is the characteristic polynomial: Whitney's formula. *)

Require Import Reals ZArith List Bool Lia Lra.
Require Import Planes Sides Rank Recursion Counting.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Lemma pick_map T U (r : T -> U) mask : forall l, pick mask (map r l) = map r (pick mask l).
Proof. induction mask as [|[] mask IH]; intros [|a l]; cbn; f_equal; auto. Qed.

(** * Sets of masks that correspond *)

Lemma whitney_same B B' k c (e : list bool -> list bool) :
  (forall m m', e m = e m' -> m = m') ->
  (forall b m, subset B k b m <-> exists m', subset B' k b m' /\ e m' = m) ->
  whitney_number B' k c -> whitney_number B k c.
Proof.
  intros I E (n & n' & N & N' & ->). exists n, n'. split; [|split; trivial].
  - now apply number_image with (P := subset B' k true) (e := e).
  - now apply number_image with (P := subset B' k false) (e := e).
Qed.

Definition picks (e : list bool -> list bool) (B B' : list (form R)) : Prop :=
  (forall m m', e m = e m' -> m = m') /\
  (forall m', length m' = length B' -> length (e m') = length B /\ pick (e m') B = pick m' B') /\
  (forall m, length m = length B -> meet (pick m B) ->
    exists m', length m' = length B' /\ e m' = m).

Lemma picks_whitney e B B' k c : picks e B B' -> whitney_number B' k c -> whitney_number B k c.
Proof.
  intros (I & F & G). apply whitney_same with e; trivial. intros b m. split.
  - intros (L & M & R & P). destruct (G m L M) as (m' & L' & <-). exists m'. split; trivial.
    destruct (F m' L') as [_ E]. rewrite E in *. unfold subset. tauto.
  - intros (m' & (L & M & R & P) & <-). destruct (F m' L) as [L' E].
    unfold subset. rewrite E. tauto.
Qed.

Lemma meet_tail f fs : meet (f :: fs) -> meet fs.
Proof. intros (x & X). exists x. intros g G. apply X. now right. Qed.

Lemma picks_refl B : picks (fun m => m) B B.
Proof. repeat split; eauto. Qed.

Lemma picks_keep e f B B' : picks e B B' -> exists e', picks e' (f :: B) (f :: B').
Proof.
  intros (I & F & G). exists (fun m => match m with [] => [] | b :: m => b :: e m end).
  split; [|split].
  - intros [|a m] [|b m']; intros H; try easy. injection H as -> H. f_equal. auto.
  - intros [|b m']; [easy|]. intros [= L]. destruct (F m' L) as [L' E]. cbn.
    split; [now rewrite L'|]. destruct b; now rewrite E.
  - intros [|b m]; [easy|]. intros [= L] M. destruct (G m L) as (m' & L' & <-).
    + destruct b; [now apply meet_tail with f|trivial].
    + exists (b :: m'). cbn. auto.
Qed.

Lemma picks_constant e f B B' : (forall x, value f x <> 0) -> picks e B B' ->
  picks (fun m => false :: e m) (f :: B) B'.
Proof.
  intros N (I & F & G). split; [|split].
  - intros m m' [= H]. auto.
  - intros m' L. destruct (F m' L) as [L' E]. cbn. now rewrite L', E.
  - intros [|[] m]; [easy| |]; intros [= L] M.
    + destruct M as (x & X). destruct (N x). apply X. now left.
    + destruct (G m L M) as (m' & L' & <-). now exists m'.
Qed.

(** * A form that is 0 everywhere: subsets with it and without it cancel *)

Fixpoint flip (i : nat) (m : list bool) : list bool :=
  match i, m with
  | _, [] => []
  | O, b :: m => negb b :: m
  | S i, b :: m => b :: flip i m
  end.

Lemma flip_flip i : forall m, flip i (flip i m) = m.
Proof.
  induction i as [|i IH]; intros [|b m]; cbn; trivial; [now rewrite negb_involutive|now rewrite IH].
Qed.

Lemma flip_pick T (v : T) l2 l1 : forall m, length m = length (l1 ++ v :: l2) ->
  length (flip (length l1) m) = length (l1 ++ v :: l2) /\ exists a b c,
  pick m (l1 ++ v :: l2) = a ++ (if b : bool then [v] else []) ++ c /\
  pick (flip (length l1) m) (l1 ++ v :: l2) = a ++ (if negb b then [v] else []) ++ c.
Proof.
  induction l1 as [|f l1 IH]; intros [|b m] L; try easy.
  - split; [exact L|]. exists [], b, (pick m l2). now destruct b.
  - injection L as L. destruct (IH m L) as (L' & a & b' & c & E & E').
    split; [cbn; now rewrite L'|].
    destruct b; [exists (f :: a), b', c|exists a, b', c]; cbn; rewrite E, E'; auto.
Qed.

Lemma flip_subset l1 v l2 k b m : (forall x, value v x = 0) ->
  subset (l1 ++ v :: l2) k b m -> subset (l1 ++ v :: l2) k (negb b) (flip (length l1) m).
Proof.
  intros V (L & (x & X) & R & P).
  destruct (flip_pick v l2 l1 m L) as (L' & a & b' & c & E & E').
  assert (forall w, along v w = 0) as Flat.
  { intros w. rewrite along_value, !V. ring. }
  rewrite E in *. unfold subset. rewrite E'. split; [trivial|]. split; [|split].
  - exists x. intros f F.
    assert (In f (a ++ (if b' then [v] else []) ++ c) \/ f = v) as [G| ->]; [|now apply X|apply V].
    destruct b'; cbn in *; rewrite in_app_iff in *; cbn in *; intuition auto.
  - destruct b'; cbn in *.
    + apply (@rank_more (a ++ c) (a ++ v :: c)) in R; trivial.
      * intros f F. rewrite in_app_iff in *. cbn. tauto.
      * intros f F. rewrite in_app_iff in *. cbn in F. destruct F as [F|[<-|F]]; auto.
    + apply (@rank_more (a ++ c) (a ++ v :: c)); trivial.
      * intros f F. rewrite in_app_iff in *. cbn. tauto.
      * intros f F. rewrite in_app_iff in *. cbn in F. destruct F as [F|[<-|F]]; auto.
  - rewrite <- P. rewrite !app_length. destruct b'; cbn [negb length app Nat.add].
    + rewrite Nat.add_succ_r, Nat.even_succ, <- Nat.negb_even, negb_involutive. reflexivity.
    + rewrite Nat.add_succ_r, Nat.even_succ, <- Nat.negb_even. reflexivity.
Qed.

Lemma whitney_vanishes B v k c : In v B -> (forall x, value v x = 0) ->
  whitney_number B k c -> c = 0%Z.
Proof.
  intros (l1 & l2 & ->)%in_split V (e & o & E & O & ->).
  enough (e = o) by lia. apply (number_unique E).
  apply number_image with (P := subset (l1 ++ v :: l2) k false) (e := flip (length l1)); trivial.
  - intros m m' H. apply (f_equal (flip (length l1))) in H. now rewrite !flip_flip in H.
  - intros m. split.
    + intros S. exists (flip (length l1) m). split; [|apply flip_flip].
      now apply (@flip_subset l1 v l2 k true m V).
    + intros (m' & S & <-). now apply (@flip_subset l1 v l2 k false m' V).
Qed.

(** * The recursion *)

Section Whitney.

Variable F : Type.
Variable look : F -> kind.
Variable restrict : F -> F -> F.
Variable real : F -> form R.
Hypothesis look_vanishes : forall f, look f = Vanishes -> forall x, value (real f) x = 0.
Hypothesis look_constant : forall f, look f = Constant ->
  exists c, c <> 0 /\ forall x, value (real f) x = c.
Hypothesis look_plane : forall h, look h = Plane -> exists j, slope (real h) j <> 0 /\
  forall g, below (real h) j (real g) (real (restrict h g)).

Lemma onto_picks r B : forall B', onto look r B = Some B' ->
  exists e, picks e (map real (map r B)) (map real B').
Proof.
  induction B as [|g B IH]; cbn; intros B' H.
  - injection H as <-. exists (fun m => m). apply picks_refl.
  - destruct (look (r g)) eqn:L; [easy| |].
    + destruct (IH _ H) as (e & E). exists (fun m => false :: e m). apply picks_constant; trivial.
      intros x. destruct (look_constant L) as (c & N & V). now rewrite V.
    + destruct (onto look r B) as [B1|]; [|easy]. injection H as <-.
      destruct (IH _ eq_refl) as (e & E). now apply picks_keep with e.
Qed.

Lemma onto_vanishes r B : onto look r B = None ->
  exists v, In v (map real (map r B)) /\ forall x, value v x = 0.
Proof.
  induction B as [|g B IH]; cbn; [easy|]. destruct (look (r g)) eqn:L; intros H.
  - exists (real (r g)). split; [now left|now apply look_vanishes].
  - destruct (IH H) as (v & I & V). exists v. auto.
  - destruct (onto look r B); [easy|]. destruct (IH eq_refl) as (v & I & V). exists v. auto.
Qed.

(** Subsets with h are subsets of the restriction. *)
Lemma subset_plane h B k b m : look h = Plane ->
  subset (real h :: map real B) k b (true :: m) <->
  exists k', k = S k' /\ subset (map real (map (restrict h) B)) k' (negb b) m.
Proof.
  intros K. destruct (look_plane K) as (j & Sl & D).
  assert (forall gs, meet (real h :: map real gs) <-> meet (map real (map (restrict h) gs))) as Meet.
  { intros gs. split.
    - intros (x & X). exists x. intros f (g & <- & G)%in_map_iff.
      apply in_map_iff in G as (g0 & <- & G). destruct (D g0) as (p & P & V).
      rewrite V, value_foot, (X (real h)) by now left.
      rewrite (X (real g0)) by (right; now apply in_map). ring.
    - intros (x & X). exists (foot (real h) j x). intros f [<-|(g & <- & G)%in_map_iff].
      + now apply foot_on.
      + destruct (D g) as (p & P & V). specialize (X (real (restrict h g))).
        rewrite V in X. apply Rmult_integral in X as [X|X]; trivial; [lra|].
        now apply in_map, in_map. }
  assert (forall gs k, rank (real h :: map real gs) (S k) <->
    rank (map real (map (restrict h) gs)) k) as Rank.
  { intros gs k'.
    assert (forall k, rank (map real (map (restrict h) gs)) k -> rank (real h :: map real gs) (S k))
      as Up.
    { intros k2. apply rank_below with (1 := Sl). now apply all_below. }
    split; [|apply Up]. intros R.
    destruct (@rank_exists _ look restrict real look_vanishes look_constant look_plane _
      (map (restrict h) gs) (le_n _)) as (k2 & R2).
    pose proof (rank_unique (Up _ R2) R) as [= <-]. exact R2. }
  unfold subset. cbn [pick length]. rewrite !map_length, !pick_map.
  rewrite Nat.even_succ, <- Nat.negb_even, !map_length. split.
  - intros (L & M & R & P).
    destruct (@rank_exists _ look restrict real look_vanishes look_constant look_plane _
      (map (restrict h) (pick m B)) (le_n _)) as (k2 & R2).
    exists k2. pose proof (proj2 (Rank _ _) R2) as R3. split; [exact (rank_unique R R3)|].
    split; [lia|]. split; [now apply Meet|]. split; [trivial|]. rewrite <- P.
    now rewrite negb_involutive.
  - intros (k' & -> & L & M & R & P). split; [lia|]. split; [now apply Meet|].
    split; [now apply Rank|]. now rewrite P, negb_involutive.
Qed.

Lemma subset_without f B k b m : subset (f :: B) k b (false :: m) <-> subset B k b m.
Proof. unfold subset. cbn. split; intros (L & H); (split; [lia|trivial]). Qed.

Lemma masks_split (P : list bool -> Prop) n n' : ~ P [] ->
  number (fun m => P (false :: m)) n -> number (fun m => P (true :: m)) n' ->
  number P (n + n').
Proof.
  intros N A B. eapply number_iff; [|apply number_or;
    [|apply number_image with (2 := fun u => iff_refl (exists t, P (false :: t) /\ false :: t = u)) (3 := A)
     |apply number_image with (2 := fun u => iff_refl (exists t, P (true :: t) /\ true :: t = u)) (3 := B)]].
  - intros [|[] m]; cbn beta; split; try tauto.
    + intros [(t & _ & ?)|(t & _ & ?)]; discriminate.
    + intros [(t & _ & ?)|(t & H & [= <-])]; [discriminate|trivial].
    + intros H. right. now exists m.
    + intros [(t & H & [= <-])|(t & _ & ?)]; [trivial|discriminate].
    + intros H. left. now exists m.
  - cbn beta. intros s (t & _ & <-) (t' & _ & ?). discriminate.
  - now intros a b [= ->].
  - now intros a b [= ->].
Qed.

Lemma nth_difference k : forall l l', nth k (difference l l') 0%Z = (nth k l 0 - nth k l' 0)%Z.
Proof.
  assert (forall l k, nth k (difference [] l) 0%Z = (- nth k l 0)%Z) as Nil.
  { induction l as [|b l IH]; intros [|k']; cbn; try lia. apply IH. }
  induction k as [|k IH]; intros [|a l] l'.
  - rewrite Nil. cbn. lia.
  - destruct l'; cbn; lia.
  - rewrite Nil. destruct l'; cbn; lia.
  - destruct l' as [|b l']; cbn [difference nth]; [lia|apply IH].
Qed.

Lemma polynomial_whitney : forall n B k, (length B <= n)%nat ->
  whitney_number (map real B) k (nth k (polynomial look restrict n B) 0%Z).
Proof.
  assert (forall k, whitney_number [] k (nth k [1%Z] 0%Z)) as Nil.
  { assert (forall k b m, subset [] k b m -> m = [] /\ k = O /\ b = true) as Only.
    { intros k b [|? m] (L & _ & R & P); [|easy]. cbn in R, P.
      now rewrite (rank_unique R rank_nil), <- P. }
    intros [|k].
    - exists 1%Z, 0%Z. split; [|split; trivial].
      + apply number_one with (a := []). intros m. split; [apply Only|]. intros ->.
        repeat split; [exists origin; easy|exists []|].
        * repeat split; [easy|]. intros [|]; [|easy]. intros _. now exists origin.
        * intros [|g gs] I _; cbn; [lia|]. destruct (I g). now left.
      + apply number_none. intros m H. now destruct (Only _ _ _ H) as (_ & _ & ?).
    - exists 0%Z, 0%Z. replace (nth (S k) [1%Z] 0%Z) with 0%Z by now destruct k.
      split; [|split; trivial]; apply number_none; intros m H;
      now destruct (Only _ _ _ H) as (_ & ? & _). }
  induction n as [|n IH]; intros [|h B] k L; try apply Nil; [cbn in L; lia|].
  cbn in L. cbn [polynomial map]. destruct (look h) eqn:K.
  - replace (nth k [] 0%Z) with 0%Z by now destruct k.
    destruct (IH B k ltac:(lia)) as (e & o & E & O & _).
    assert (forall b m, subset (real h :: map real B) k b (true :: m) <->
      subset (map real B) k (negb b) m) as With.
    { intros b m. pose proof (look_vanishes K) as V. unfold subset. cbn [pick length].
      rewrite Nat.even_succ, <- Nat.negb_even.
      assert (rank (real h :: pick m (map real B)) k <-> rank (pick m (map real B)) k) as R.
      { apply rank_more; [intros f; now right|]. intros f [<-|F0]; [right|now left].
        intros v. rewrite along_value, !V. ring. }
      assert (meet (real h :: pick m (map real B)) <-> meet (pick m (map real B))) as M.
      { split; [apply meet_tail|]. intros (x & X). exists x. intros f [<-|F0]; auto. }
      rewrite R, M. split; intros (A1 & A2 & A3 & A4); (split; [lia|]);
      (split; [trivial|]); (split; [trivial|]); destruct b, (Nat.even _); easy. }
    exists (e + o)%Z, (o + e)%Z. split; [|split; [|lia]]; apply masks_split.
    + now intros (? & _).
    + revert E. apply number_iff. intros m. now rewrite subset_without.
    + revert O. apply number_iff. intros m. now rewrite With.
    + now intros (? & _).
    + revert O. apply number_iff. intros m. now rewrite subset_without.
    + revert E. apply number_iff. intros m. now rewrite With.
  - apply picks_whitney with (e := fun m => false :: m) (B' := map real B); [|apply IH; lia].
    apply picks_constant; [|apply picks_refl].
    intros x. destruct (look_constant K) as (c & N & V). now rewrite V.
  - rewrite nth_difference. destruct (IH B k ltac:(lia)) as (e & o & E & O & ->).
    assert (forall k, whitney_number (map real (map (restrict h) B)) k
      (nth k match onto look (restrict h) B with
        | None => [] | Some B' => polynomial look restrict n B' end 0%Z)) as Below.
    { intros k'. destruct (onto look (restrict h) B) as [B'|] eqn:Ot.
      - destruct (onto_picks _ _ Ot) as (e' & E').
        apply picks_whitney with (1 := E'). apply IH.
        destruct (@onto_some _ look real look_constant (restrict h) B B' Ot)
          as (_ & _ & _ & Len). lia.
      - destruct (onto_vanishes _ _ Ot) as (v & I & V).
        replace (nth k' [] 0%Z) with 0%Z by now destruct k'.
        pose proof (IH (map (restrict h) B) k' ltac:(rewrite map_length; lia)) as W.
        now rewrite (@whitney_vanishes _ v _ _ I V W) in W. }
    assert (exists e' o', number (fun m => subset (real h :: map real B) k true (true :: m)) e' /\
      number (fun m => subset (real h :: map real B) k false (true :: m)) o' /\
      (o' - e' = nth k match onto look (restrict h) B with
        | None => [] | Some B' => 0 :: polynomial look restrict n B' end 0)%Z)
      as (e' & o' & E' & O' & Eq).
    { destruct k as [|k].
      - exists 0%Z, 0%Z. split; [|split; [|now destruct (onto look (restrict h) B)]];
        apply number_none; intros m H; apply (subset_plane B 0 _ m K) in H;
        now destruct H as (k' & ? & _).
      - destruct (Below k) as (e' & o' & E' & O' & Eq). exists o', e'. split; [|split].
        + revert O'. apply number_iff. intros m. rewrite (subset_plane B (S k) true m K). split.
          * intros H. now exists k.
          * now intros (k' & [= <-] & H).
        + revert E'. apply number_iff. intros m. rewrite (subset_plane B (S k) false m K). split.
          * intros H. now exists k.
          * now intros (k' & [= <-] & H).
        + rewrite <- Eq. now destruct (onto look (restrict h) B); destruct k. }
    exists (e + e')%Z, (o + o')%Z. split; [|split; [|lia]]; apply masks_split; trivial;
    try (now intros (? & _)).
    + revert E. apply number_iff. intros m. now rewrite subset_without.
    + revert O. apply number_iff. intros m. now rewrite subset_without.
Qed.

End Whitney.

Theorem whitney : forall planes k,
  whitney_number (real_planes planes) k (nth k (characteristic_polynomial planes) 0%Z).
Proof.
  intros planes k. apply (@polynomial_whitney _ look restrict real_form look_vanishes look_constant
    look_plane (length planes) planes k (le_n _)).
Qed.
