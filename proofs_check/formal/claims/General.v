(** Central planes in general position; Euler's relation over the real numbers. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

Lemma general_permutation d B B' : Permutation B B' -> general d B -> general d B'.
Proof. intros P G fs rest P'. apply G with rest. now transitivity B'. Qed.

Lemma general_tail d h B : general d (h :: B) -> general d B.
Proof.
  intros G fs rest P. apply G with (h :: rest). rewrite <- Permutation_middle. now constructor.
Qed.

Lemma general_restrict d h B : general (S d) (h :: B) -> general d (map (restrict_real h) B).
Proof.
  intros G fs' rest' P L. destruct (Permutation_map_inv _ _ (Permutation_sym P)) as (l & E & P').
  apply eq_sym, map_eq_app in E. destruct E as (fs & rest & -> & <- & <-).
  rewrite map_length in L.
  assert (independent (h :: fs)) as D.
  { apply G with rest; [|cbn; lia]. cbn. now constructor. }
  intros values Len. rewrite map_length in Len.
  destruct (D (0%R :: values)) as (v & V); [cbn; lia|]. exists v.
  injection V as V0 V. rewrite <- V, map_map. apply map_ext. intros g.
  unfold restrict_real. cbn. rewrite linear_less, V0. ring.
Qed.

Lemma general_plane d B g : general (S d) B -> In g B -> look_real g = Plane.
Proof.
  intros G (l1 & l2 & ->)%in_split.
  assert (independent [g]) as D.
  { apply G with (l1 ++ l2); [|cbn; lia]. cbn. symmetry. apply Permutation_middle. }
  destruct (look_real g) eqn:L; trivial; exfalso;
  (apply (@independent_slope [g] g D); [now left|];
   apply (@look_flat _ look_real (fun f => f) look_real_vanishes look_real_constant); congruence).
Qed.

Lemma onto_full r B : Forall (fun g => look_real (r g) = Plane) B ->
  onto look_real r B = Some (map r B).
Proof. induction 1 as [|g B G _ IH]; cbn; trivial. now rewrite G, IH. Qed.

Lemma skim_full r A : Forall (fun g => look_real (r g) = Plane) A ->
  skim look_real r A = map r A.
Proof. induction 1 as [|g B G _ IH]; cbn; trivial. now rewrite G, IH. Qed.

Lemma restricted_planes d h B : general (S (S d)) (h :: B) ->
  Forall (fun g => look_real (restrict_real h g) = Plane) B.
Proof.
  intros G%general_restrict. apply Forall_forall. intros g H.
  apply general_plane with (1 := G). now apply in_map.
Qed.

Lemma restricted_within D h B : look_real h = Plane -> within D h ->
  Forall (within D) B ->
  Forall (within (remove Nat.eq_dec (pivot_real (coefficients h)) D)) (map (restrict_real h) B).
Proof.
  intros L H W. apply Forall_map. eapply Forall_impl; [|exact W]. intros g G.
  now apply within_restrict.
Qed.

Lemma restricted_central h B : central h -> Forall central B ->
  Forall central (map (restrict_real h) B).
Proof.
  intros H C. apply Forall_map. eapply Forall_impl; [|exact C]. intros g G.
  now apply central_restrict.
Qed.

Lemma look_nowhere D f : (length D <= 0)%nat -> within D f -> central f -> look_real f = Vanishes.
Proof.
  intros L W C. destruct (look_real f) eqn:E; trivial.
  - now destruct (@central_look f C).
  - destruct D; [|cbn in L; lia]. now destruct (@within_nil f W).
Qed.

Lemma regions_exact n : forall D d B, (length B <= n)%nat -> (length D <= d)%nat ->
  Forall (within D) B -> Forall central B -> general d B ->
  regions look_real restrict_real n B = central_regions (length B) d.
Proof.
  induction n as [|n IH]; intros D d [|h B] L LD W C G; try (cbn in L; lia); trivial.
  cbn in L. inversion W as [|? ? Wh WB]; subst. inversion C as [|? ? Ch CB]; subst.
  cbn [regions length]. destruct d as [|d].
  - now rewrite (look_nowhere LD Wh Ch).
  - pose proof (@general_plane d (h :: B) h G (or_introl eq_refl)) as K. rewrite K, central_step.
    pose proof (@pivot_within D h K Wh) as Less.
    rewrite (IH D (S d) B) by (trivial; try lia; now apply general_tail with h). f_equal.
    pose proof (restricted_within K Wh WB) as W'. pose proof (restricted_central Ch CB) as C'.
    destruct d as [|d].
    + destruct B as [|g B]; [destruct n; reflexivity|]. cbn [map] in W', C'. inversion W'; subst. inversion C'; subst.
      cbn [onto length]. now rewrite (@look_nowhere (remove Nat.eq_dec (pivot_real (coefficients h)) D)
        (restrict_real h g) ltac:(lia) H1 H3).
    + rewrite (@onto_full _ _ (restricted_planes G)).
      rewrite (IH (remove Nat.eq_dec (pivot_real (coefficients h)) D) (S d)); trivial.
      * now rewrite map_length.
      * rewrite map_length. lia.
      * lia.
      * now apply general_restrict.
Qed.

Lemma faces_exact n : forall D d nz A k, (length A <= n)%nat -> (length D <= d)%nat -> (k < d)%nat ->
  Forall (within D) (nz ++ A) -> Forall central (nz ++ A) -> general d (nz ++ A) ->
  nth k (faces look_real restrict_real n nz A) 0 =
  choose (length A) k * central_regions (length nz + length A - k) (d - k).
Proof.
  assert (forall D d nz k, (length D <= d)%nat -> (k < d)%nat ->
    Forall (within D) (nz ++ []) -> Forall central (nz ++ []) -> general d (nz ++ []) ->
    nth k [regions look_real restrict_real (length nz) nz] 0 =
    choose 0 k * central_regions (length nz + 0 - k) (d - k)) as Nil.
  { intros D d nz [|k] L K W C G; rewrite app_nil_r in *.
    - rewrite choose_none, Nat.add_0_r, !Nat.sub_0_r, Z.mul_1_l. cbn [nth].
      now apply regions_exact with D.
    - replace (nth (S k) [regions look_real restrict_real (length nz) nz] 0) with 0 by now destruct k.
      reflexivity. }
  induction n as [|n IH]; intros D d nz [|h A] k L LD K W C G; try (cbn in L; lia);
    try (now apply Nil with D).
  cbn in L. destruct d as [|d]; [lia|].
  assert (general (S d) (h :: nz ++ A)) as G1.
  { apply general_permutation with (2 := G). symmetry. apply Permutation_middle. }
  pose proof (@general_plane d (h :: nz ++ A) h G1 (or_introl eq_refl)) as Kind.
  assert (Forall (within D) (h :: nz ++ A)) as W1.
  { apply Permutation_Forall with (2 := W). symmetry. apply Permutation_middle. }
  assert (Forall central (h :: nz ++ A)) as C1.
  { apply Permutation_Forall with (2 := C). symmetry. apply Permutation_middle. }
  inversion W1 as [|? ? Wh W2]; subst. inversion C1 as [|? ? Ch C2]; subst.
  pose proof (@pivot_within D h Kind Wh) as Less.
  cbn [faces length]. rewrite Kind, nth_sum.
  rewrite (IH D (S d) (h :: nz) A k ltac:(lia) LD K W1 C1 G1). cbn [length].
  destruct k as [|k].
  - rewrite !choose_none. replace (nth 0 _ 0) with 0
      by now destruct (onto look_real (restrict_real h) nz).
    rewrite !Nat.sub_0_r. replace (length nz + S (length A))%nat with (S (length nz) + length A)%nat
      by lia. lia.
  - destruct d as [|d]; [lia|]. pose proof (restricted_planes G1) as P.
    apply Forall_app in P as [P1 P2]. rewrite (@onto_full _ _ P1), (@skim_full _ _ P2). cbn [nth].
    rewrite (IH (remove Nat.eq_dec (pivot_real (coefficients h)) D) (S d)).
    + rewrite !map_length.
      change (choose (S (length A)) (S k)) with (choose (length A) k + choose (length A) (S k)).
      replace (S (length nz) + length A - S k)%nat with (length nz + length A - k)%nat by lia.
      replace (length nz + S (length A) - S k)%nat with (length nz + length A - k)%nat by lia.
      cbn [Nat.sub]. ring.
    + rewrite map_length. lia.
    + lia.
    + lia.
    + rewrite <- map_app. now apply restricted_within.
    + rewrite <- map_app. now apply restricted_central.
    + rewrite <- map_app. now apply general_restrict.
Qed.

Theorem general_faces d planes k : of_space d planes -> Forall central planes ->
  general d planes -> (k < d)%nat ->
  number (face_of_codimension k planes)
    (choose (length planes) k * central_regions (length planes - k) (d - k)).
Proof.
  intros S C G K. pose proof (faces_real_count planes k) as N. unfold faces_real in N.
  rewrite (@faces_exact (length planes) (seq 0 d) d [] planes k) in N; trivial.
  - now rewrite seq_length.
  - now apply of_space_within.
Qed.

Theorem general_regions d planes : of_space d planes -> Forall central planes ->
  general d planes -> number (region planes) (central_regions (length planes) d).
Proof.
  intros S C G. pose proof (regions_real_count planes) as N. unfold regions_real in N.
  rewrite (@regions_exact (length planes) (seq 0 d) d planes) in N; trivial.
  - now rewrite seq_length.
  - now apply of_space_within.
Qed.

(** * Affine planes in general position *)

Lemma simple_permutation d B B' : Permutation B B' -> simple d B -> simple d B'.
Proof.
  intros P [G N]. split; [now apply general_permutation with B|].
  intros fs rest P'. apply N with rest. now transitivity B'.
Qed.

Lemma simple_tail d h B : simple d (h :: B) -> simple d B.
Proof.
  intros [G N]. split; [now apply general_tail with h|].
  intros fs rest P. apply N with (h :: rest). rewrite <- Permutation_middle. now constructor.
Qed.

Lemma simple_restrict d h B : simple (S d) (h :: B) -> simple d (map (restrict_real h) B).
Proof.
  intros [G N]. split; [now apply general_restrict|]. intros fs' rest' P L (x & X).
  destruct (Permutation_map_inv _ _ (Permutation_sym P)) as (l & E & P').
  apply eq_sym, map_eq_app in E. destruct E as (fs & rest & -> & <- & <-).
  rewrite map_length in L. apply (N (h :: fs) rest); [cbn; now constructor|cbn; lia|].
  pose proof (@general_plane d (h :: B) h G (or_introl eq_refl)) as K.
  exists (foot h (pivot_real (coefficients h)) x). intros f [<-|F].
  - now apply foot_on, look_real_slope.
  - destruct (@restrict_real_below h f K) as (p & Pos & V).
    pose proof (X _ (in_map (restrict_real h) _ _ F)) as Z. rewrite V in Z.
    apply Rmult_integral in Z as [Z|]; [lra|trivial].
Qed.

Lemma simple_constant B : simple 0 B -> Forall (fun f => look_real f = Constant) B.
Proof.
  intros [_ N]. apply Forall_forall. intros f (l1 & l2 & ->)%in_split.
  destruct (look_real f) eqn:K; trivial; exfalso;
  (apply (N [f] (l1 ++ l2)); [cbn; symmetry; apply Permutation_middle|reflexivity|]).
  - exists origin. intros g [<-|[]]. now apply look_real_vanishes.
  - exists (foot f (pivot_real (coefficients f)) origin). intros g [<-|[]].
    now apply foot_on, look_real_slope.
Qed.

Lemma onto_constant r B : Forall (fun f => look_real f = Constant) (map r B) ->
  onto look_real r B = Some [] /\ skim look_real r B = [].
Proof.
  induction B as [|g B IH]; intros C; [now split|]. inversion C as [|? ? K C']; subst.
  destruct (IH C'). cbn. now rewrite K.
Qed.

Lemma affine_regions_exact n : forall d B, (length B <= n)%nat -> simple (S d) B ->
  regions look_real restrict_real n B = choose_upto (length B) (S d).
Proof.
  induction n as [|n IH]; intros d [|h B] L G; try (cbn in L; lia);
    try (now rewrite upto_zero).
  cbn in L. cbn [regions length]. rewrite (@general_plane d (h :: B) h (proj1 G) (or_introl eq_refl)), upto_step.
  rewrite (IH d B ltac:(lia) (simple_tail G)). f_equal.
  pose proof (simple_restrict G) as G'. destruct d as [|d].
  - destruct (@onto_constant _ _ (simple_constant G')) as [-> _]. now destruct n.
  - rewrite (@onto_full _ _ (restricted_planes (proj1 G))).
    rewrite (IH d) by (rewrite ?map_length; trivial; lia). now rewrite map_length.
Qed.

Lemma affine_faces_exact n : forall d nz A k, (length A <= n)%nat -> (k <= S d)%nat ->
  simple (S d) (nz ++ A) ->
  nth k (faces look_real restrict_real n nz A) 0 =
  choose (length A) k * choose_upto (length nz + length A - k) (S d - k).
Proof.
  assert (forall d nz k, simple (S d) (nz ++ []) ->
    nth k [regions look_real restrict_real (length nz) nz] 0 =
    choose 0 k * choose_upto (length nz + 0 - k) (S d - k)) as Nil.
  { intros d nz [|k] G; rewrite app_nil_r in *.
    - rewrite choose_none, Nat.add_0_r, !Nat.sub_0_r, Z.mul_1_l. cbn [nth].
      now apply affine_regions_exact.
    - replace (nth (S k) [regions look_real restrict_real (length nz) nz] 0) with 0 by now destruct k.
      reflexivity. }
  induction n as [|n IH]; intros d nz [|h A] k L K G; try (cbn in L; lia);
    try (now apply Nil).
  cbn in L. assert (simple (S d) (h :: nz ++ A)) as G1.
  { apply simple_permutation with (2 := G). symmetry. apply Permutation_middle. }
  pose proof (@general_plane d (h :: nz ++ A) h (proj1 G1) (or_introl eq_refl)) as Kind.
  cbn [faces length]. rewrite Kind, nth_sum, (IH d (h :: nz) A k ltac:(lia) K G1). cbn [length].
  destruct k as [|k].
  - rewrite !choose_none. replace (nth 0 _ 0) with 0
      by now destruct (onto look_real (restrict_real h) nz).
    rewrite !Nat.sub_0_r. replace (length nz + S (length A))%nat with (S (length nz) + length A)%nat
      by lia. lia.
  - change (choose (S (length A)) (S k)) with (choose (length A) k + choose (length A) (S k)).
    replace (S (length nz) + length A - S k)%nat with (length nz + length A - k)%nat by lia.
    replace (length nz + S (length A) - S k)%nat with (length nz + length A - k)%nat by lia.
    cbn [Nat.sub]. rewrite Z.mul_add_distr_r, Z.add_comm. f_equal.
    pose proof (simple_restrict G1) as G'. destruct d as [|d].
    + apply simple_constant in G'. rewrite map_app in G'. apply Forall_app in G' as [C1 C2].
      destruct (@onto_constant _ _ C1) as [-> _], (@onto_constant _ _ C2) as [_ ->].
      assert (k = O) as -> by lia. rewrite choose_none. now destruct n.
    + pose proof (restricted_planes (proj1 G1)) as P.
      apply Forall_app in P as [P1 P2]. rewrite (@onto_full _ _ P1), (@skim_full _ _ P2). cbn [nth].
      rewrite (IH d) by (rewrite <- ?map_app, ?map_length; trivial; lia). now rewrite !map_length.
Qed.

Theorem simple_faces d planes k : (1 <= d)%nat -> (k <= d)%nat -> simple d planes ->
  number (face_of_codimension k planes)
    (choose (length planes) k * choose_upto (length planes - k) (d - k)).
Proof.
  intros D K G. pose proof (faces_real_count planes k) as N. unfold faces_real in N.
  destruct d as [|d]; [lia|]. now rewrite (@affine_faces_exact (length planes) d [] planes k) in N.
Qed.

Theorem simple_regions d planes : (1 <= d)%nat -> simple d planes ->
  number (region planes) (choose_upto (length planes) d).
Proof.
  intros D G. pose proof (regions_real_count planes) as N. unfold regions_real in N.
  destruct d as [|d]; [lia|]. now rewrite (@affine_regions_exact (length planes) d planes) in N.
Qed.

(** * Euler's relation *)

(** a 0 - a 1 + a 2 - ..., n terms *)
Fixpoint alternate (a : nat -> Z) (n : nat) : Z :=
  match n with O => 0 | S n => a O - alternate (fun k => a (S k)) n end.

Lemma alternate_list l : forall n, (length l <= n)%nat ->
  alternate (fun k => nth k l 0) n = alternating l.
Proof.
  induction l as [|a l IH]; intros n L.
  - clear L. cbn. induction n as [|n IH]; trivial. cbn in *.
    replace (alternate (fun k : nat => 0) n) with 0; [reflexivity|].
    rewrite <- IH at 1. clear. induction n; trivial.
  - destruct n as [|n]; [cbn in L; lia|]. cbn [alternate nth alternating].
    rewrite (IH n) by (cbn in L; lia). reflexivity.
Qed.

Lemma alternate_ext n : forall a b, (forall k, a k = b k) -> alternate a n = alternate b n.
Proof.
  induction n as [|n IH]; intros a b E; trivial. cbn. rewrite E. f_equal. apply IH. auto.
Qed.

Lemma sum_length l : forall l', (length (sum l l') <= Nat.max (length l) (length l'))%nat.
Proof. induction l as [|a l IH]; intros [|b l']; cbn; try lia. pose proof (IH l'). lia. Qed.

Lemma faces_length n : forall nz A, (length A <= n)%nat ->
  (length (faces look_real restrict_real n nz A) <= S (length A))%nat.
Proof.
  induction n as [|n IH]; intros nz [|h A] L; cbn [faces length]; try lia.
  cbn in L. destruct (look_real h); try (pose proof (IH nz A); lia).
  eapply Nat.le_trans; [apply sum_length|]. pose proof (IH (h :: nz) A ltac:(lia)).
  destruct (onto look_real (restrict_real h) nz) as [nz'|]; cbn [length]; [|lia].
  pose proof (skim_length look_real (restrict_real h) A).
  pose proof (IH nz' (skim look_real (restrict_real h) A) ltac:(lia)). lia.
Qed.

Theorem euler_relation planes f : (forall k, number (face_of_codimension k planes) (f k)) ->
  alternate f (S (length planes)) = 1.
Proof.
  intros N. rewrite (@alternate_ext _ f (fun k => nth k (faces_real planes) 0)).
  - rewrite alternate_list by now apply faces_length. unfold faces_real.
    now rewrite (@faces_alternate _ look_real restrict_real (fun f => f) look_real_vanishes
      look_real_constant look_real_plane).
  - intros k. apply (number_unique (N k)), faces_real_count.
Qed.

(** Codimensions from that of the space on: nothing but the origin. *)
Lemma faces_deep n : forall D nz A k, (length A <= n)%nat -> (length D <= k)%nat ->
  Forall (within D) nz -> Forall (within D) A -> Forall central nz -> Forall central A ->
  nth k (faces look_real restrict_real n nz A) 0 <=
    (if (length D =? k)%nat then match nz with [] => 1 | _ => 0 end else 0).
Proof.
  assert (forall D nz k, (length D <= k)%nat -> Forall (within D) nz -> Forall central nz ->
    nth k [regions look_real restrict_real (length nz) nz] 0 <=
    (if (length D =? k)%nat then match nz with [] => 1 | _ => 0 end else 0)) as Nil.
  { intros D nz [|k] L W C.
    - assert (length D = O) as E by lia. rewrite E. cbn [Nat.eqb nth].
      destruct nz as [|g nz]; [reflexivity|]. cbn [regions length].
      inversion W; subst. inversion C; subst. now rewrite (@look_nowhere D g ltac:(lia)).
    - replace (nth (S k) [regions look_real restrict_real (length nz) nz] 0) with 0 by now destruct k.
      destruct (length D =? S k)%nat; [destruct nz|]; lia. }
  induction n as [|n IH]; intros D nz [|h A] k L LD W WA C CA; try (cbn in L; lia);
    try (now apply Nil).
  cbn in L. inversion WA as [|? ? Wh WA']; subst. inversion CA as [|? ? Ch CA']; subst.
  cbn [faces]. destruct (look_real h) eqn:Kind; try (apply IH; trivial; lia).
  rewrite nth_sum. pose proof (@pivot_within D h Kind Wh) as Less.
  set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D) in *.
  pose proof (IH D (h :: nz) A k ltac:(lia) LD ltac:(now constructor) WA' ltac:(now constructor) CA')
    as H1.
  replace (if (length D =? k)%nat then 0 else 0) with 0 in H1 by now destruct (length D =? k)%nat.
  destruct (onto look_real (restrict_real h) nz) as [nz'|] eqn:O.
  - destruct k as [|k]; [lia|]. cbn [nth].
    destruct (@onto_all (within D) (within D') (restrict_real h) nz
      (fun g => @within_restrict D h g Kind Wh) W nz' O) as [W' _].
    destruct (@onto_all central central (restrict_real h) nz (fun g => @central_restrict h g Ch) C nz' O)
      as [C' _].
    pose proof (@skim_all (within D) (within D') (restrict_real h) A
      (fun g => @within_restrict D h g Kind Wh) WA') as WS.
    pose proof (@skim_all central central (restrict_real h) A (fun g => @central_restrict h g Ch) CA')
      as CS.
    pose proof (skim_length look_real (restrict_real h) A).
    pose proof (IH D' nz' (skim look_real (restrict_real h) A) k ltac:(lia) ltac:(lia) W' WS C' CS) as H2.
    pose proof (@central_onto h nz nz' ltac:(now constructor) O) as Len.
    destruct (Nat.eqb_spec (length D) (S k)), (Nat.eqb_spec (length D') k); try lia;
    destruct nz, nz'; cbn in Len; lia.
  - replace (nth k [] 0) with 0 by now destruct k.
    destruct (length D =? k)%nat; [destruct nz|]; lia.
Qed.

(** On the sphere: central planes of R^3. *)
Lemma deep_faces d planes k : of_space d planes -> Forall central planes -> (d <= k)%nat ->
  nth k (faces_real planes) 0 <= if (k =? d)%nat then 1 else 0.
Proof.
  intros S C K.
  pose proof (@faces_deep (length planes) (seq 0 d) [] planes k (le_n _)
    ltac:(rewrite seq_length; lia) ltac:(constructor) (of_space_within S) ltac:(constructor) C) as H.
  rewrite seq_length in H. destruct (Nat.eqb_spec d k), (Nat.eqb_spec k d); try lia; exact H.
Qed.

Lemma origin_face planes k : Forall central planes -> rank planes k ->
  1 <= nth k (faces_real planes) 0.
Proof.
  intros C Rank. destruct (faces_real_count planes k) as (l & (_ & I) & <-).
  assert (face_of_codimension k planes (signs planes origin)) as H.
  { split; [now exists origin|]. replace (through planes (signs planes origin)) with planes; trivial.
    clear - C. induction C as [|g planes G C IH]; trivial. rewrite signs_cons.
    assert (sgn (value g origin) = Zero) as ->.
    { apply sgn_zero. unfold value. rewrite linear_origin, G. ring. }
    cbn. now rewrite <- IH. }
  apply I in H. destruct l; [easy|]. cbn [length]. lia.
Qed.

Lemma one_origin d planes : of_space d planes -> Forall central planes -> rank planes d ->
  nth d (faces_real planes) 0 = 1.
Proof.
  intros S C Rank. pose proof (@deep_faces d planes d S C (le_n _)) as H.
  rewrite Nat.eqb_refl in H. pose proof (@origin_face planes d C Rank). lia.
Qed.

Theorem sphere_euler planes v e f : of_space 3 planes -> Forall central planes -> rank planes 3 ->
  number (face_of_codimension 2 planes) v -> number (face_of_codimension 1 planes) e ->
  number (face_of_codimension 0 planes) f -> v - e + f = 2.
Proof.
  intros S C Rank V E F. pose proof (one_origin S C Rank) as Origin.
  assert (forall k, (4 <= k)%nat -> nth k (faces_real planes) 0 = 0) as Far.
  { intros k K. pose proof (number_nonneg (faces_real_count planes k)).
    pose proof (@deep_faces 3 planes k S C ltac:(lia)) as H1. destruct (Nat.eqb_spec k 3); lia. }
  rewrite (number_unique V (faces_real_count planes 2)),
    (number_unique E (faces_real_count planes 1)), (number_unique F (faces_real_count planes 0)).
  pose proof (@faces_alternate _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length planes) [] planes (le_n _)) as Alt.
  change (alternating (faces_real planes) = 1) in Alt.
  assert (forall l, (forall k, nth k l 0 = 0) -> alternating l = 0) as Zeros.
  { induction l as [|a l IH]; trivial. intros H. cbn. rewrite IH.
    - specialize (H O). cbn in H. lia.
    - intros k. apply (H (Datatypes.S k)). }
  destruct (faces_real planes) as [|a [|b [|c [|z l]]]]; try (cbn in Origin; lia).
  cbn [nth] in *. cbn [alternating] in Alt. rewrite (Zeros l) in Alt.
  - lia.
  - intros k. apply (Far (Datatypes.S (Datatypes.S (Datatypes.S (Datatypes.S k))))). lia.
Qed.

(** Planes in general position, as many as the space has dimensions or more, have its rank. *)
Lemma general_rank d planes : of_space d planes -> Forall central planes -> general d planes ->
  (d <= length planes)%nat -> rank planes d.
Proof.
  intros S C G L.
  destruct (@rank_exists _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length planes) planes (le_n _)) as [k Rank].
  rewrite map_id in Rank. enough (k = d) by now subst. apply Nat.le_antisymm.
  - destruct (Nat.le_gt_cases k d) as [|K]; trivial.
    pose proof (@deep_faces d planes k S C ltac:(lia)) as H.
    pose proof (@origin_face planes k C Rank). destruct (Nat.eqb_spec k d); lia.
  - destruct Rank as [_ U]. rewrite <- (firstn_length_le planes L). apply U.
    + intros g H. rewrite <- (firstn_skipn d planes). apply in_app_iff. now left.
    + apply G with (skipn d planes); [now rewrite firstn_skipn|]. rewrite firstn_length. lia.
Qed.
