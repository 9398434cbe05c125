(** The recursions that count regions, faces and the terms of the characteristic polynomial.

    They are written once, for forms of any kind; the program reads them over the integers, the
    theorems for every number of planes read them over the real numbers. *)

Require Import Reals ZArith List Bool Lia Lra.
Require Import Planes Sides Rank.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** What a form is: 0 everywhere, another constant, or one whose zeros are a plane. *)
Inductive kind := Vanishes | Constant | Plane.

(** Sums and differences of lists of numbers, the shorter one filled up with 0. *)
Fixpoint sum (l l' : list Z) : list Z :=
  match l, l' with
  | a :: l, b :: l' => (a + b)%Z :: sum l l'
  | [], l => l
  | l, [] => l
  end.

Fixpoint difference (l l' : list Z) : list Z :=
  match l, l' with
  | a :: l, b :: l' => (a - b)%Z :: difference l l'
  | l, [] => l
  | [], b :: l' => (- b)%Z :: difference [] l'
  end.

Section Recursion.

Variable F : Type.
Variable look : F -> kind.
(** [restrict h g]: a form that is g on the plane of h, and does not depend on one coordinate. *)
Variable restrict : F -> F -> F.

(** The forms that must not be 0, on the plane of h; constants are left out. *)
Fixpoint onto (r : F -> F) (B : list F) : option (list F) :=
  match B with
  | [] => Some []
  | g :: B =>
      let g' := r g in
      match look g' with
      | Vanishes => None
      | Constant => onto r B
      | Plane => match onto r B with None => None | Some B' => Some (g' :: B') end
      end
  end.

(** Other forms on the plane of h; what is constant there decides itself. *)
Fixpoint skim (r : F -> F) (A : list F) : list F :=
  match A with
  | [] => []
  | g :: A =>
      let g' := r g in
      match look g' with Plane => g' :: skim r A | _ => skim r A end
  end.

(** [n] is as large as the list is long, or larger. *)
Fixpoint regions (n : nat) (B : list F) : Z :=
  match n, B with
  | S n, h :: B =>
      match look h with
      | Vanishes => 0
      | Constant => regions n B
      | Plane =>
          regions n B + match onto (restrict h) B with None => 0 | Some B' => regions n B' end
      end
  | _, _ => 1
  end%Z.

(** The faces of A where the forms [nz] are not 0, by codimension. *)
Fixpoint faces (n : nat) (nz A : list F) : list Z :=
  match n, A with
  | S n, h :: A =>
      match look h with
      | Plane =>
          sum (faces n (h :: nz) A)
            match onto (restrict h) nz with
            | None => []
            | Some nz' => 0%Z :: faces n nz' (skim (restrict h) A)
            end
      | _ => faces n nz A
      end
  | _, _ => [regions (length nz) nz]
  end.

(** The coefficients of t^d, t^(d - 1), ... in the characteristic polynomial. *)
Fixpoint polynomial (n : nat) (B : list F) : list Z :=
  match n, B with
  | S n, h :: B =>
      match look h with
      | Vanishes => []
      | Constant => polynomial n B
      | Plane =>
          difference (polynomial n B)
            match onto (restrict h) B with None => [] | Some B' => 0%Z :: polynomial n B' end
      end
  | _, _ => [1%Z]
  end.

(** * What they count *)

Variable real : F -> form R.

Hypothesis look_vanishes : forall f, look f = Vanishes -> forall x, value (real f) x = 0.
Hypothesis look_constant : forall f, look f = Constant ->
  exists c, c <> 0 /\ forall x, value (real f) x = c.
Hypothesis look_plane : forall h, look h = Plane -> exists j, slope (real h) j <> 0 /\
  forall g, below (real h) j (real g) (real (restrict h g)).

Lemma below_face B B' h j : slope h j <> 0 -> Forall2 (below h j) B B' -> restricts h B B'.
Proof.
  intros S D.
  assert (forall x, signs B' x = signs B (foot h j x)) as E.
  { intros x. clear S. induction D as [|g g' B B' (p & P & V) D IH]; trivial.
    rewrite !signs_cons, IH, V, sgn_times; trivial. }
  intros s. split.
  - intros (x & <-). exists (foot h j x). split; [now apply foot_on|now rewrite E].
  - intros (x & X & <-). exists x. rewrite E. now apply signs_foot.
Qed.

Lemma all_below h j B : (forall g, below (real h) j (real g) (real (restrict h g))) ->
  Forall2 (below (real h) j) (map real B) (map real (map (restrict h) B)).
Proof. intros H. induction B; cbn; constructor; auto. Qed.

Lemma skim_length r A : (length (skim r A) <= length A)%nat.
Proof. induction A as [|g A IH]; cbn; [lia|]. destruct (look (r g)); cbn; lia. Qed.

(** Sign vectors with the signs of constants, from those without. *)
Definition fills (B B' : list (form R)) (e : list sign -> list sign) : Prop :=
  (forall a b, e a = e b -> a = b) /\ (forall x, signs B x = e (signs B' x)).

Lemma fills_keep f B B' e : fills B B' e -> exists e', fills (f :: B) (f :: B') e' /\
  (forall s t, e' (s :: t) = s :: e t) /\ e' [] = [].
Proof.
  intros [I E]. exists (fun l => match l with [] => [] | s :: t => s :: e t end).
  repeat split.
  - intros [|a l] [|b l']; intros H; try easy. injection H as -> H. f_equal. auto.
  - intros x. rewrite !signs_cons. now rewrite E.
Qed.

Lemma fills_constant f B B' e s : (forall x, sgn (value f x) = s) -> fills B B' e ->
  fills (f :: B) B' (fun t => s :: e t).
Proof.
  intros S [I E]. split.
  - intros a b [= H]. auto.
  - intros x. now rewrite signs_cons, S, E.
Qed.

Lemma fills_refl B : fills B B (fun s => s).
Proof. split; auto. Qed.

Lemma constant_sign f : look f = Constant ->
  exists s, s <> Zero /\ forall x, sgn (value (real f) x) = s.
Proof.
  intros L. destruct (look_constant L) as (c & N & E). exists (sgn c). split.
  - intros H. now apply sgn_zero in H.
  - intros x. now rewrite E.
Qed.

Lemma onto_none r B : onto r B = None -> forall x, In Zero (signs (map real (map r B)) x).
Proof.
  induction B as [|g B IH]; cbn; intros H x; [easy|].
  destruct (look (r g)) eqn:L.
  - left. now rewrite (look_vanishes L), (proj2 (sgn_zero 0)).
  - right. now apply IH.
  - right. destruct (onto r B); [easy|]. now apply IH.
Qed.

Lemma onto_some r B : forall B', onto r B = Some B' -> exists e,
  fills (map real (map r B)) (map real B') e /\ (forall s, In Zero (e s) <-> In Zero s) /\
  (length B' <= length B)%nat.
Proof.
  induction B as [|g B IH]; cbn; intros B' H.
  - injection H as <-. exists (fun s => s). split; [apply fills_refl|]. split; [easy|cbn; lia].
  - destruct (look (r g)) eqn:L; [easy| |].
    + destruct (IH _ H) as (e & Fe & Z & Len). destruct (constant_sign L) as (s & N & S).
      exists (fun t => s :: e t). split; [now apply fills_constant|]. split; [|lia].
      intros t. cbn. rewrite Z. split; [intros [|]; easy|auto].
    + destruct (onto r B) as [B1|]; [|easy]. injection H as <-.
      destruct (IH _ eq_refl) as (e & Fe & Z & Len).
      destruct (fills_keep (real (r g)) Fe) as (e' & Fe' & C & N).
      exists e'. split; [trivial|]. split; [|cbn; lia].
      intros [|s t]; [now rewrite N|]. rewrite C. cbn. now rewrite Z.
Qed.

Lemma fills_region B B' e n : fills B B' e -> (forall s, In Zero (e s) <-> In Zero s) ->
  number (region B') n -> number (region B) n.
Proof.
  intros [I E] Z. apply number_image with (e := e); trivial. intros u. split.
  - intros [(x & <-) N]. exists (signs B' x). rewrite <- E. repeat split; trivial.
    + now exists x.
    + now rewrite <- Z, <- E.
  - intros (t & [(x & <-) N] & <-). split; [now exists x|]. now rewrite Z.
Qed.

Lemma region_nil : number (region []) 1.
Proof.
  apply number_one with (a := []). intros s. split.
  - intros [(x & <-) _]. reflexivity.
  - intros ->. split; [now exists origin|easy].
Qed.

Lemma region_vanishes f B : (forall x, value f x = 0) -> number (region (f :: B)) 0.
Proof.
  intros V. apply number_none. intros s [(x & <-) N]. apply N. left. now apply sgn_zero.
Qed.

Theorem regions_count : forall n B, (length B <= n)%nat ->
  number (region (map real B)) (regions n B).
Proof.
  induction n as [|n IH]; intros [|h B] L; try apply region_nil; [cbn in L; lia|].
  cbn in L. cbn [regions map]. destruct (look h) eqn:K.
  - now apply region_vanishes, look_vanishes.
  - destruct (constant_sign K) as (s & N & S).
    apply fills_region with (B' := map real B) (e := fun t => s :: t).
    + apply fills_constant; trivial. apply fills_refl.
    + intros t. cbn. split; [intros [|]; easy|auto].
    + apply IH. lia.
  - destruct (look_plane K) as (j & S & D).
    pose proof (below_face S (all_below B D)) as Res.
    eapply one_more; [exact S|exact Res|apply IH; lia|].
    destruct (onto (restrict h) B) as [B'|] eqn:O.
    + destruct (onto_some _ _ O) as (e & Fe & Z & Len). apply (fills_region Fe Z). apply IH. lia.
    + apply number_none. intros s [(x & <-) N]. apply N, onto_none, O.
Qed.

(** * Zaslavsky's theorem and Euler's relation *)

Fixpoint alternating (l : list Z) : Z :=
  match l with [] => 0 | a :: l => a - alternating l end%Z.

Lemma alternating_sum l : forall l', alternating (sum l l') = (alternating l + alternating l')%Z.
Proof. induction l as [|a l IH]; intros [|b l']; cbn; rewrite ?IH; lia. Qed.

Lemma alternating_difference l :
  forall l', alternating (difference l l') = (alternating l - alternating l')%Z.
Proof.
  induction l as [|a l IH]; [|intros [|b l']; cbn; rewrite ?IH; lia].
  induction l' as [|b l' IH]; cbn in *; rewrite ?IH; lia.
Qed.

Theorem polynomial_regions : forall n B, alternating (polynomial n B) = regions n B.
Proof.
  induction n as [|n IH]; intros [|h B]; trivial. cbn. destruct (look h); trivial.
  rewrite alternating_difference, IH. destruct (onto (restrict h) B) as [B'|]; cbn; rewrite ?IH; lia.
Qed.

Lemma regions_enough n n' B : (length B <= n)%nat -> (length B <= n')%nat ->
  regions n B = regions n' B.
Proof. intros. apply (@number_unique _ (region (map real B))); now apply regions_count. Qed.

Theorem faces_alternate : forall n nz A, (length A <= n)%nat ->
  alternating (faces n nz A) = regions (length nz) nz.
Proof.
  induction n as [|n IH]; intros nz [|h A] L; cbn [length] in L; try lia; try (cbn; lia).
  cbn [faces]. destruct (look h) eqn:K; try (apply IH; lia).
  rewrite alternating_sum, IH by lia. cbn [length regions]. rewrite K.
  destruct (onto (restrict h) nz) as [nz'|] eqn:O; cbn [alternating]; [|lia].
  destruct (onto_some _ _ O) as (_ & _ & _ & Len).
  rewrite IH by (pose proof (skim_length (restrict h) A); lia).
  rewrite (@regions_enough (length nz) (length nz') nz') by lia. lia.
Qed.

(** * Faces *)

Definition zeros (x : point) (A : list (form R)) : list (form R) := through A (signs A x).

(** The sign vectors of A and [nz] together, those of [nz] without 0. *)
Definition apart (nz A : list (form R)) (k : nat) (p : list sign * list sign) : Prop :=
  exists x, signs A x = fst p /\ signs nz x = snd p /\ ~ In Zero (snd p) /\ rank (zeros x A) k.

Lemma zeros_spec x A f : In f (zeros x A) <-> In f A /\ value f x = 0.
Proof.
  unfold zeros. induction A as [|g A IH]; [cbn; tauto|].
  rewrite signs_cons. cbn [through]. destruct (sgn (value g x)) eqn:E.
  - apply sgn_minus in E. rewrite IH. cbn. split; [tauto|]. intros [[->|] ?]; [lra|auto].
  - apply sgn_zero in E. cbn. rewrite IH. split; [intros [->|]; tauto|tauto].
  - apply sgn_plus in E. rewrite IH. cbn. split; [tauto|]. intros [[->|] ?]; [lra|auto].
Qed.

Lemma zeros_below x h j A A' : value h x = 0 -> Forall2 (below h j) A A' ->
  Forall2 (below h j) (zeros x A) (zeros x A').
Proof.
  intros X D. unfold zeros. induction D as [|g g' A A' (p & P & V) D IH]; [constructor|].
  rewrite !signs_cons, V, sgn_times, value_foot, X by trivial.
  replace (value g x - 0 * (slope g j / slope h j)) with (value g x) by ring.
  cbn. destruct (sgn (value g x)); trivial. constructor; trivial. now exists p.
Qed.

Lemma look_flat f : look f <> Plane -> forall v, along (real f) v = 0.
Proof.
  intros N v. rewrite along_value. destruct (look f) eqn:L; [| |easy].
  - rewrite !(look_vanishes L). ring.
  - destruct (look_constant L) as (c & _ & E). rewrite !E. ring.
Qed.

Lemma skim_in r A f : In f (skim r A) <-> In f (map r A) /\ look f = Plane.
Proof.
  induction A as [|g A IH]; cbn; [tauto|].
  destruct (look (r g)) eqn:L; cbn; rewrite IH; split; try tauto;
  try (intros [[<-|] ?]; [congruence|tauto]). intros [<-|]; tauto.
Qed.

Lemma skim_rank r A x k :
  rank (zeros x (map real (map r A))) k <-> rank (zeros x (map real (skim r A))) k.
Proof.
  apply rank_more; intros f; rewrite !zeros_spec, !in_map_iff.
  - intros [(g & <- & [G _]%skim_in) Z]. split; trivial. now exists g.
  - intros [(g & <- & G) Z]. destruct (look g) eqn:L; [right|right|left].
    + apply look_flat. congruence.
    + apply look_flat. congruence.
    + split; trivial. exists g. split; trivial. now apply skim_in.
Qed.

Lemma skim_fills r A : exists e, fills (map real (map r A)) (map real (skim r A)) e.
Proof.
  induction A as [|g A [e Fe]]; cbn; [exists (fun s => s); apply fills_refl|].
  destruct (look (r g)) eqn:L.
  - exists (fun t => Zero :: e t). apply fills_constant; trivial.
    intros x. now rewrite (look_vanishes L), (proj2 (sgn_zero 0)).
  - destruct (constant_sign L) as (s & _ & S). exists (fun t => s :: e t).
    now apply fills_constant.
  - destruct (fills_keep (real (r g)) Fe) as (e' & Fe' & _). now exists e'.
Qed.

Lemma zeros_form x A : exists A', zeros x (map real A) = map real A' /\ (length A' <= length A)%nat.
Proof.
  unfold zeros. induction A as [|g A (A' & E & L)]; [now exists []|].
  cbn [map]. rewrite signs_cons. cbn [through].
  destruct (sgn (value (real g) x)); [| |]; rewrite E; [exists A'|exists (g :: A')|exists A'];
  (split; [reflexivity|cbn; lia]).
Qed.

Lemma rank_exists n : forall A, (length A <= n)%nat -> exists k, rank (map real A) k.
Proof.
  induction n as [|n IH]; intros [|h A] L; try (exists O; apply rank_nil); [cbn in L; lia|].
  cbn in L. destruct (look h) eqn:K.
  3: { destruct (look_plane K) as (j & S & D). destruct (IH (map (restrict h) A)) as [k R];
       [rewrite map_length; lia|]. exists (Datatypes.S k). cbn.
       now apply (@rank_below _ _ S _ _ _ (all_below A D)). }
  1, 2: destruct (IH A) as [k R]; [lia|]; exists k; apply (@rank_more (map real A)); trivial;
    [intros g G; now right|intros g [<-|G]; [right; apply look_flat; congruence|now left]].
Qed.

Lemma zeros_cons x f A : zeros x (f :: A) =
  match sgn (value f x) with Zero => f :: zeros x A | _ => zeros x A end.
Proof. unfold zeros. rewrite signs_cons. cbn. now destruct (sgn (value f x)). Qed.

(** The faces off h = 0, and those on it. *)
Definition off (p : list sign * list sign) : list sign * list sign :=
  match p with (a, []) => ([], a) | (a, s :: b) => (s :: a, b) end.

Lemma off_injective p q : off p = off q -> p = q.
Proof. destruct p as [a [|s b]], q as [a' [|s' b']]; cbn; intros [=]; subst; trivial. Qed.

Ltac four := refine (conj _ (conj _ (conj _ _))).

Lemma apart_flat f A nz k n s : look f <> Plane -> (forall x, sgn (value (real f) x) = s) ->
  number (apart nz A k) n -> number (apart nz (real f :: A) k) n.
Proof.
  intros N S. apply number_image with (e := fun p => (s :: fst p, snd p)).
  - intros [] []. cbn. now intros [= -> ->].
  - assert (forall x, rank (zeros x (real f :: A)) k <-> rank (zeros x A) k) as R.
    { intros x. apply rank_more; intros g; rewrite !zeros_spec; cbn; [tauto|].
      intros [[<-|] ?]; [right; now apply look_flat|tauto]. }
    intros [a b]. split.
    + intros (x & X & Y & Z & W). cbn [fst snd] in *. rewrite signs_cons, S in X. exists (signs A x, b).
      split; [|cbn [fst snd]; congruence]. exists x. four; trivial. now apply R.
    + intros ([a' b'] & (x & X & Y & Z & W) & [= <- <-]). exists x. cbn [fst snd] in *.
      rewrite signs_cons, S. four; cbn [fst snd]; trivial; [congruence|]. now apply R.
Qed.

Theorem faces_count : forall n nz A k, (length A <= n)%nat ->
  number (apart (map real nz) (map real A) k) (nth k (faces n nz A) 0%Z).
Proof.
  assert (forall nz k, number (apart (map real nz) [] k) (nth k [regions (length nz) nz] 0%Z)) as Nil.
  { intros nz [|k].
    - apply number_image with (P := region (map real nz)) (e := fun s => ([], s)).
      + now intros a b [=].
      + intros [a b]. split.
        * intros (x & X & Y & Z & _). exists b. cbn [fst snd] in *. subst. repeat split; trivial. now exists x.
        * intros (s & [(x & <-) Z] & [= <- <-]). exists x. four; trivial. apply rank_nil.
      + now apply regions_count.
    - replace (nth (S k) [regions (length nz) nz] 0%Z) with 0%Z by now destruct k.
      apply number_none. intros p (x & _ & _ & _ & R).
      discriminate (rank_unique R rank_nil). }
  induction n as [|n IH]; intros nz [|h A] k L; try apply Nil; [cbn in L; lia|].
  cbn in L. cbn [faces map]. destruct (look h) eqn:K.
  - apply apart_flat with Zero; [congruence| |apply IH; lia].
    intros x. now rewrite (look_vanishes K), (proj2 (sgn_zero 0)).
  - destruct (constant_sign K) as (s & _ & S).
    apply apart_flat with s; [congruence|trivial|apply IH; lia].
  - destruct (look_plane K) as (j & S & D).
    set (lower := match onto (restrict h) nz with None => []
      | Some nz' => 0%Z :: faces n nz' (skim (restrict h) A) end).
    assert (nth k (sum (faces n (h :: nz) A) lower) 0 =
      nth k (faces n (h :: nz) A) 0 + nth k lower 0)%Z as ->.
    { generalize (faces n (h :: nz) A), lower. clear. induction k as [|k IH]; intros [|a l] [|b l'];
      cbn; try lia; rewrite ?IH; destruct k; cbn; try lia. }
    pose (nzR := map real nz). pose (AR := map real A). pose (hR := real h).
    assert (forall x, value hR x = 0 -> signs (map real (map (restrict h) A)) x = signs AR x) as OnA.
    { intros x X. pose proof (all_below A D) as B. fold AR hR in B. clear - B X.
      induction B as [|g g' A0 A' (p & P & V) B IH]; trivial.
      rewrite !signs_cons, IH, V, sgn_times, value_foot, X by trivial. f_equal. f_equal. ring. }
    assert (forall x, value hR x = 0 -> signs (map real (map (restrict h) nz)) x = signs nzR x) as Onz.
    { intros x X. pose proof (all_below nz D) as B. fold nzR hR in B. clear - B X.
      induction B as [|g g' A0 A' (p & P & V) B IH]; trivial.
      rewrite !signs_cons, IH, V, sgn_times, value_foot, X by trivial. f_equal. f_equal. ring. }
    assert (forall x B, signs (map real (map (restrict h) B)) (foot hR j x) =
      signs (map real (map (restrict h) B)) x) as Foot.
    { intros x B. induction B as [|g B IHB]; trivial. cbn [map]. rewrite !signs_cons, IHB.
      destruct (D g) as (p & P & V). rewrite !V, !sgn_times by trivial. f_equal. f_equal.
      rewrite !value_foot. fold hR. field. exact S. }
    assert (forall x, value hR x = 0 -> forall k,
      rank (zeros x (hR :: AR)) (Datatypes.S k) <->
      rank (zeros x (map real (map (restrict h) A))) k) as Deeper.
    { intros x X k'. rewrite zeros_cons, X, (proj2 (sgn_zero 0)) by trivial.
      pose proof (zeros_below X (all_below A D)) as B. fold AR in B.
      assert (forall k, rank (zeros x (map real (map (restrict h) A))) k ->
        rank (hR :: zeros x AR) (Datatypes.S k)) as Up by (intros; eapply rank_below; eauto).
      split; [|apply Up]. intros R.
      destruct (zeros_form x (map (restrict h) A)) as (A' & E & _).
      destruct (@rank_exists _ A' (le_n _)) as (k2 & R2). rewrite <- E in R2.
      pose proof (rank_unique (Up _ R2) R) as [= <-]. exact R2. }
    assert (number (fun p => exists q, apart (hR :: nzR) AR k q /\ off q = p)
      (nth k (faces n (h :: nz) A) 0%Z)) as Off.
    { apply number_image with (P := apart (hR :: nzR) AR k) (e := off);
        [apply off_injective|reflexivity|]. apply (IH (h :: nz)). lia. }
    assert (number (fun p : list sign * list sign => exists x, value hR x = 0 /\
      signs (hR :: AR) x = fst p /\ signs nzR x = snd p /\
      ~ In Zero (signs nzR x) /\ rank (zeros x (hR :: AR)) k) (nth k lower 0%Z)) as On.
    { unfold lower. destruct (onto (restrict h) nz) as [nz'|] eqn:O.
      2: { destruct k; cbn; apply number_none; intros p (x & X & _ & _ & N & _);
           apply N; rewrite <- Onz by trivial; now apply onto_none. }
      destruct (onto_some _ _ O) as (e & [Ie Fe] & Z & _).
      destruct (skim_fills (restrict h) A) as (e' & Ie' & Fe').
      destruct k as [|k]; cbn [nth].
      - apply number_none. intros p (x & X & _ & _ & _ & R).
        destruct (zeros_form x (map (restrict h) A)) as (A' & E & _).
        destruct (@rank_exists _ A' (le_n _)) as (k2 & R2). rewrite <- E in R2.
        apply (Deeper x X) in R2. discriminate (rank_unique R R2).
      - apply number_image with (P := apart (map real nz') (map real (skim (restrict h) A)) k)
          (e := fun q => (Zero :: e' (fst q), e (snd q))).
        + intros [] []. cbn. intros [= E1%Ie' E2%Ie]. now subst.
        + intros [a b]. split.
          * intros (x & X & A1 & A2 & N & R). cbn [fst snd] in *. subst a b.
            exists (signs (map real (skim (restrict h) A)) x, signs (map real nz') x).
            cbn [fst snd]. rewrite <- Fe, <- Fe', OnA, Onz by trivial. split.
            -- exists x. four; trivial; cbn [snd].
               ++ rewrite <- Z, <- Fe, Onz by trivial. exact N.
               ++ apply skim_rank. now apply Deeper.
            -- rewrite signs_cons, X, (proj2 (sgn_zero 0)) by trivial. reflexivity.
          * intros ([a' b'] & (x & X & Y & N & R) & [= <- <-]). cbn [fst snd] in *. subst a' b'.
            exists (foot hR j x). pose proof (@foot_on hR j x S) as V. split; trivial.
            rewrite signs_cons, V, (proj2 (sgn_zero 0)), <- OnA, <- Onz, !Foot, Fe, Fe' by trivial.
            split; [trivial|]. split; [trivial|]. split; [now rewrite Z|]. apply Deeper; trivial.
            unfold zeros. rewrite Foot. now apply skim_rank.
        + apply IH. pose proof (skim_length (restrict h) A). lia. }
    eapply number_iff; [|apply number_or; [|exact Off|exact On]].
    + intros [a b]. cbn beta. split.
      * intros [([a' b'] & (x & X & Y & N & R) & E)|(x & X & A1 & A2 & N & R)].
        -- cbn [fst snd] in *. rewrite signs_cons in Y. subst a' b'. cbn in E. injection E as <- <-.
           exists x. cbn [fst snd]. four; trivial.
           ++ intros H. apply N. now right.
           ++ change (rank (zeros x (hR :: AR)) k). rewrite zeros_cons.
              destruct (sgn (value hR x)) eqn:G; trivial. destruct N. now left.
        -- cbn [fst snd] in *. subst a b. exists x. four; trivial.
      * intros (x & X & Y & N & R). cbn [fst snd] in *.
        destruct (sgn (value hR x)) eqn:G.
        2: { right. exists x. apply sgn_zero in G. subst. auto. }
        1, 2: left; exists (signs AR x, signs (hR :: nzR) x); rewrite !signs_cons in *;
          fold hR in X; rewrite G in *; subst; split; [|reflexivity]; exists x; four; trivial;
          cbn [fst snd]; [rewrite signs_cons, G; reflexivity|intros [|]; [easy|auto]|];
          change (rank (zeros x (hR :: AR)) k) in R; rewrite zeros_cons, G in R; exact R.
    + cbn beta. intros p ([a b] & (x & X & Y & N & _) & <-) (y & V & E & _ & _).
      cbn [fst snd] in *. rewrite signs_cons in Y. subst a b. cbn in E.
      injection E as E _. apply N. left. rewrite <- E, V. now apply sgn_zero.
Qed.

Lemma codimension_exists A s : face (map real A) s ->
  exists k, face_of_codimension k (map real A) s.
Proof.
  intros (x & <-). destruct (zeros_form x A) as (A' & E & _).
  destruct (@rank_exists _ A' (le_n _)) as (k & R). exists k. split; [now exists x|].
  unfold zeros in E. now rewrite E.
Qed.

End Recursion.

Lemma codimension_number planes k n :
  number (apart [] planes k) n -> number (face_of_codimension k planes) n.
Proof.
  intros (l & (N & L) & <-). exists (map fst l). split; [|now rewrite map_length]. split.
  - assert (forall p, In p l -> snd p = []) as E.
    { intros p H. apply L in H. destruct H as (x & _ & <- & _). reflexivity. }
    clear L. induction l as [|[a b] l IH]; cbn; constructor; inversion N; subst.
    + intros ([a' b'] & H & I)%in_map_iff. cbn in H. subst a'.
      pose proof (E (a, b) (or_introl eq_refl)) as E1. pose proof (E _ (or_intror I)) as E2.
      cbn in E1, E2. subst. easy.
    + apply IH; trivial. intros; apply E. now right.
  - intros s. rewrite in_map_iff. split.
    + intros ([a b] & <- & H). apply L in H. destruct H as (x & X & Y & _ & R). cbn in *.
      split; [now exists x|]. unfold zeros in R. now rewrite X in R.
    + intros [(x & <-) R]. exists (signs planes x, []). split; trivial. apply L.
      exists x. refine (conj _ (conj _ (conj _ _))); trivial. easy.
Qed.

(** One face, one codimension: together they are all faces. *)
Lemma codimensions_total planes l :
  (forall s, face planes s -> exists k, face_of_codimension k planes s) ->
  (forall k, number (face_of_codimension k planes) (nth k l 0%Z)) ->
  number (face planes) (fold_right Z.add 0%Z l).
Proof.
  intros Some F.
  assert (forall n, number (fun s => exists k, (k < n)%nat /\
    face_of_codimension k planes s) (fold_right Z.add 0 (firstn n l))%Z) as Sum.
  { induction n as [|n IH].
    - apply number_none. intros s (k & ? & _). lia.
    - assert (fold_right Z.add 0 (firstn (S n) l) =
        fold_right Z.add 0 (firstn n l) + nth n l 0)%Z as ->.
      { clear. revert l. induction n as [|n IH]; intros [|a l]; cbn; try lia.
        change (match l with [] => [] | a0 :: l0 => a0 :: firstn n l0 end) with (firstn (S n) l).
        rewrite IH. lia. }
      eapply number_iff; [|apply number_or; [|exact IH|apply (F n)]].
      + intros s. split.
        * intros [(k & K & H)|H]; [exists k; split; [lia|trivial]|exists n; split; [lia|trivial]].
        * intros (k & K & H). destruct (Nat.eq_dec k n) as [->|]; [now right|].
          left. exists k. split; [lia|trivial].
      + intros s (k & K & [_ H]) [_ H']. pose proof (rank_unique H H'). lia. }
  specialize (Sum (length l)). rewrite firstn_all in Sum. revert Sum. apply number_iff.
  intros s. split.
  - now intros (k & _ & [H _]).
  - intros H. destruct (Some s H) as (k & K). exists k. split; trivial.
    destruct (Nat.lt_ge_cases k (length l)) as [|G]; trivial.
    destruct (F k) as (l' & (_ & L') & Len). rewrite nth_overflow in Len by trivial.
    destruct l'; [|cbn in Len; lia]. now apply L' in K.
Qed.
