(** A plane cuts no more faces than it has itself: faces and regions of any planes, and great circles
    with twice as many facets as regions, less four. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Sphere Bounded Merge Dual Graph Attained Position.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Local Notation rho B := (regions look_real restrict_real (length B) B).
Local Notation on h A := (map (restrict_real h) A).

(** * Faces that a plane cuts *)

Lemma on_signs h x A : look_real h = Plane -> value h x = 0 -> signs (on h A) x = signs A x.
Proof.
  intros K X. unfold signs. rewrite map_map. apply map_ext. intros g.
  destruct (@restrict_real_below h g K) as (p & P & V).
  rewrite V, sgn_times, value_foot, X by trivial. f_equal. ring.
Qed.

Lemma on_below h A : look_real h = Plane ->
  Forall2 (below h (pivot_real (coefficients h))) A (on h A).
Proof. intros K. induction A; cbn; constructor; trivial. now apply restrict_real_below. Qed.

Lemma rank_of A : exists k, rank A k.
Proof.
  destruct (@rank_exists _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane _ A (le_n _)) as [k R]. rewrite map_id in R. now exists k.
Qed.

(** A face with points on both sides of h = 0 is one of the planes on h = 0, too. *)
Lemma cut_face h A x y k : look_real h = Plane -> signs A x = signs A y ->
  value h x < 0 -> 0 < value h y -> rank (zeros x A) k ->
  face_of_codimension k (on h A) (signs A x).
Proof.
  intros K E X Y R. destruct (@between A h x y E X Y) as (z & Z & Hz).
  assert (signs (on h A) z = signs A x) as S by now rewrite on_signs.
  split; [now exists z|]. rewrite <- S. change (rank (zeros z (on h A)) k).
  destruct (rank_of (zeros z (on h A))) as (k' & R').
  pose proof (rank_below (@look_real_slope h K) (zeros_below Hz (@on_below h A K)) R') as Up.
  assert (zeros z A = zeros x A /\ zeros y A = zeros x A) as [Ez Ey]
    by (unfold zeros; now rewrite Z, E).
  rewrite Ez in Up. destruct (rank_step R Up) as [[_ None]|[[= ->] _]]; trivial. exfalso.
  assert (forall f, along f (plus y (-1) x) = value f y - value f x) as V.
  { intros f. rewrite along_plus, !along_value. ring. }
  specialize (None (plus y (-1) x)). rewrite V in None. enough (value h y - value h x = 0) by lra.
  apply None. apply Forall_forall. intros f F. cbv beta. rewrite V.
  pose proof (proj1 (zeros_spec _ _ _) F) as [_ F0]. rewrite <- Ey in F.
  pose proof (proj1 (zeros_spec _ _ _) F) as [_ F1]. lra.
Qed.

Lemma filter_split T (p : T -> bool) l :
  length l = (length (filter p l) + length (filter (fun a => negb (p a)) l))%nat.
Proof. induction l as [|a l IH]; trivial. cbn. destruct (p a); cbn; lia. Qed.

Definition upper (p : list sign * list sign) : bool :=
  match snd p with Plus :: _ => true | _ => false end.

Lemma crossed h A k n m c : look_real h = Plane -> number (apart [h] A k) n ->
  number (face_of_codimension k A) m -> number (face_of_codimension k (on h A)) c -> (n <= m + c)%Z.
Proof.
  intros K (l & (N & L) & <-) (lm & (_ & Lm) & <-) (lc & (_ & Lc) & <-).
  assert (forall p, In p l -> exists x, value h x <> 0 /\ rank (zeros x A) k /\
    p = (signs A x, [sgn (value h x)])) as Each.
  { intros [a b] I. apply L in I as (x & Ea & Eb & NZ & R). cbn [fst snd] in *. subst a b. exists x.
    split; [|now split]. intros Z. apply NZ. left. now apply sgn_zero. }
  set (up := map fst (filter upper l)). set (down := map fst (filter (fun p => negb (upper p)) l)).
  assert (forall s, In s up -> exists x, 0 < value h x /\ rank (zeros x A) k /\ s = signs A x) as Up.
  { intros s ((a & b) & <- & [I U]%filter_In)%in_map_iff. destruct (Each _ I) as (x & NZ & R & [= -> ->]).
    exists x. split; [|now split]. unfold upper in U. cbn in U. destruct (sgn (value h x)) eqn:S; try easy. now apply sgn_plus. }
  assert (forall s, In s down -> exists x, value h x < 0 /\ rank (zeros x A) k /\ s = signs A x) as Down.
  { intros s ((a & b) & <- & [I U]%filter_In)%in_map_iff. destruct (Each _ I) as (x & NZ & R & [= -> ->]).
    exists x. split; [|now split]. unfold upper in U. cbn in U. destruct (sgn (value h x)) eqn:S; try easy.
    - now apply sgn_minus.
    - now apply sgn_zero in S. }
  assert (NoDup up /\ NoDup down) as [Nu Nd].
  { assert (forall q : list sign * list sign -> bool,
      (forall p p', In p l -> In p' l -> q p = true -> q p' = true -> fst p = fst p' -> p = p') ->
      NoDup (map fst (filter q l))) as Once.
    { clear - N. intros q Inj. induction N as [|p l I N IH]; [constructor|]. cbn.
      assert (NoDup (map fst (filter q l))) as Nl by (apply IH; intros; apply Inj; cbn; auto).
      destruct (q p) eqn:Q; trivial. cbn. constructor; trivial.
      intros (p' & E & [I' Q']%filter_In)%in_map_iff. apply I.
      rewrite (Inj p p'); cbn; auto. }
    split; apply Once; intros p p' I I' Q Q' E; destruct (Each _ I) as (x & _ & _ & ->),
      (Each _ I') as (x' & _ & _ & ->); cbn in *; rewrite E; f_equal;
      destruct (Each _ I) as (y & NZ & _ & [= _ Ey]), (Each _ I') as (y' & NZ' & _ & [= _ Ey']).
    - destruct (sgn (value h x)), (sgn (value h x')); easy.
    - assert (sgn (value h x) <> Zero /\ sgn (value h x') <> Zero) as [].
      { rewrite Ey, Ey'. split; intros Z; now apply sgn_zero in Z. }
      destruct (sgn (value h x)), (sgn (value h x')); easy. }
  set (cut := fun s => if in_dec vector_eq_dec s down then true else false).
  pose proof (filter_split upper l) as Sides. pose proof (filter_split cut up) as Cuts.
  assert (length up = length (filter upper l)) as Lu by apply map_length.
  assert (length down = length (filter (fun p => negb (upper p)) l)) as Ld by apply map_length.
  assert (length (filter cut up) <= length lc)%nat.
  { apply NoDup_incl_length; [now apply NoDup_filter|]. intros s [Iu C]%filter_In. apply Lc.
    unfold cut in C. destruct (in_dec vector_eq_dec s down) as [Id|]; [|easy].
    destruct (Up _ Iu) as (y & Y & _ & Ey), (Down _ Id) as (x & X & R & ->).
    now apply cut_face with y. }
  assert (length (filter (fun s => negb (cut s)) up ++ down) <= length lm)%nat as Most.
  { apply NoDup_incl_length.
    - assert (forall s, In s (filter (fun s => negb (cut s)) up) -> ~ In s down) as Apart.
      { intros s [_ C]%filter_In. unfold cut in C. now destruct (in_dec vector_eq_dec s down). }
      apply (NoDup_filter (fun s => negb (cut s))) in Nu.
      clear - Nu Nd Apart. induction Nu as [|s u I Nu IH]; trivial. cbn. constructor.
      + intros [H|H]%in_app_iff; [easy|]. apply (Apart s); cbn; auto.
      + apply IH. intros t It. apply Apart. now right.
    - intros s [[Iu _]%filter_In|Id]%in_app_iff; apply Lm;
      [destruct (Up _ Iu) as (x & _ & R & ->)|destruct (Down _ Id) as (x & _ & R & ->)];
      (split; [now exists x|exact R]). }
  rewrite app_length in Most. lia.
Qed.

(** * Numbers of faces *)

Definition count (k : nat) (A : list (form R)) : Z := nth k (faces_real A) 0%Z.

Lemma count_number k A : number (face_of_codimension k A) (count k A).
Proof. apply faces_real_count. Qed.

Open Scope Z_scope.

Lemma count_nonneg k A : 0 <= count k A.
Proof. exact (number_nonneg (count_number k A)). Qed.

Lemma filled_count A B e k : merged A B -> fills A B e -> count k A = count k B.
Proof.
  intros M F. apply (number_unique (P := face_of_codimension k B)); [|apply count_number].
  apply (merged_number _ _ M F), count_number.
Qed.

Lemma permuted A B : Permutation A B -> exists e, fills A B e.
Proof.
  induction 1 as [|f A B P (e & F)|f g A|A B C P (e & [I E]) Q (e' & [I' E'])].
  - exists (fun s => s). apply fills_refl.
  - destruct (fills_keep f F) as (e' & F' & _). now exists e'.
  - exists (fun l => match l with a :: b :: l => b :: a :: l | _ => l end). split; [|reflexivity].
    intros [|a [|b l]] [|a' [|b' l']]; congruence.
  - exists (fun l => e (e' l)). split; [auto|]. intros x. now rewrite E, E'.
Qed.

Lemma permuted_count A B k : Permutation A B -> count k A = count k B.
Proof.
  intros P. destruct (permuted P) as (e & F). apply filled_count with e; trivial. split.
  - intros f. apply Permutation_in. now symmetry.
  - intros g G. right. exists g, 1%R. split; [now apply Permutation_in with A|].
    split; [lra|]. intros x. ring.
Qed.

Lemma flat_count g A k : look_real g <> Plane -> count k (g :: A) = count k A.
Proof. intros N. unfold count, faces_real. cbn [length faces]. now destruct (look_real g). Qed.

Lemma doubled_count h g A k : look_real h = Plane -> In g A -> look_real g = Plane ->
  look_real (restrict_real h g) = Vanishes -> count k (h :: A) = count k A.
Proof.
  intros K I G V. destruct (vanishing_times h g K G V) as (c & T). destruct (merged_sign A I T) as (phi & Phi).
  apply filled_count with (fun s => phi s :: s).
  - split; [now apply incl_tl|]. intros f [<-|F]; right; [now exists g, c|].
    exists f, 1%R. split; trivial. split; [lra|]. intros x. ring.
  - split; [intros a b [=]; auto|]. intros x. now rewrite signs_cons, Phi.
Qed.

Lemma count_cons h A : look_real h = Plane -> exists off : nat -> Z,
  (forall k, number (apart [h] A k) (off k)) /\ count 0 (h :: A) = off 0%nat /\
  forall k, count (S k) (h :: A) = off (S k) + count k (on h A).
Proof.
  intros K. exists (fun k => nth k (faces look_real restrict_real (length A) [h] A) 0).
  split; [intros k; apply faces_real_apart|].
  assert (faces_real (h :: A) = sum (faces look_real restrict_real (length A) [h] A)
    (0 :: faces look_real restrict_real (length A) [] (skim look_real (restrict_real h) A))) as E.
  { unfold faces_real. cbn [length faces onto]. now rewrite K. }
  split; [unfold count; rewrite E, nth_sum; cbn [nth]; lia|].
  intros k. unfold count at 1. rewrite E, nth_sum. cbn [nth]. f_equal.
  destruct (@skim_fills _ look_real (fun f => f) look_real_vanishes look_real_constant (restrict_real h) A)
    as (e & [I F]). rewrite !map_id in F.
  apply (number_unique (P := face_of_codimension k (on h A))); [|apply count_number].
  pose proof (@faces_count _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length A) [] (skim look_real (restrict_real h) A) k
    (skim_length look_real (restrict_real h) A)) as N%codimension_number.
  rewrite map_id in N. revert N. apply number_image with (e := e); trivial. intros u.
  assert (forall x, rank (zeros x (on h A)) k <-> rank (zeros x (skim look_real (restrict_real h) A)) k) as R.
  { intros x. pose proof (@skim_rank _ look_real (fun f => f) look_real_vanishes look_real_constant
      (restrict_real h) A x k) as R. now rewrite !map_id in R. }
  split.
  - intros [(x & <-) H]. exists (signs (skim look_real (restrict_real h) A) x). split; [|now rewrite F].
    split; [now exists x|now apply R].
  - intros (t & [(x & <-) H] & <-). rewrite <- F. split; [now exists x|now apply R].
Qed.

(** Without forms that are 0 everywhere, faces of codimension 0 are regions. *)
Lemma open_regions A : Forall (fun f => look_real f <> Vanishes) A -> count 0 A = rho A.
Proof.
  intros N. apply (number_unique (P := region A)); [|apply regions_real_count].
  apply number_iff with (P := face_of_codimension 0 A); [|apply count_number]. intros s. split.
  - intros [(x & <-) [_ U]]. split; [now exists x|]. intros (f & Z & I)%in_map_iff.
    apply sgn_zero in Z. rewrite Forall_forall in N.
    destruct (look_real f) eqn:K; [now apply (N f)|destruct (look_real_constant _ K) as (c & C & V); rewrite V in Z; easy|].
    enough (length [f] <= 0)%nat by (cbn in *; lia). apply U; [|now apply independent_one].
    intros g [<-|[]]. now apply zeros_spec.
  - intros [(x & <-) Z]. split; [now exists x|]. change (rank (zeros x A) 0).
    rewrite (no_zeros _ _ Z). apply rank_nil.
Qed.

Lemma grown h A : look_real h = Plane -> Forall (fun g => look_real g = Plane) A ->
  Forall (fun g => look_real (restrict_real h g) <> Vanishes) A ->
  count 0 (h :: A) = count 0 A + count 0 (on h A).
Proof.
  intros K P V. rewrite !open_regions.
  - rewrite (@rho_cons h A K). f_equal. unfold added.
    destruct (onto look_real (restrict_real h) A) as [A'|] eqn:O.
    + destruct (@onto_some _ look_real (fun f => f) look_real_constant _ _ _ O) as (e & F & Z & _).
      rewrite !map_id in F.
      apply (number_unique (P := region (on h A))); [|apply regions_real_count].
      apply (fills_region F Z), regions_real_count.
    + exfalso. clear - V O. induction V as [|g A N V IH]; [easy|]. cbn in O.
      destruct (look_real (restrict_real h g)); [easy|auto|].
      destruct (onto look_real (restrict_real h) A); [easy|auto].
  - now apply Forall_map.
  - eapply Forall_impl; [|exact P]. cbn. congruence.
  - constructor; [congruence|]. eapply Forall_impl; [|exact P]. cbn. congruence.
Qed.

Lemma crossed_count h A : look_real h = Plane -> Forall (fun g => look_real g = Plane) A ->
  Forall (fun g => look_real (restrict_real h g) <> Vanishes) A ->
  forall k, count (S k) (h :: A) <= count (S k) A + count (S k) (on h A) + count k (on h A).
Proof.
  intros K P V k. destruct (@count_cons h A K) as (off & N & _ & E). rewrite E.
  pose proof (crossed K (N (S k)) (count_number (S k) A) (count_number (S k) (on h A))). lia.
Qed.

(** * Faces are linear in the regions *)

Lemma choose_step d k : (1 <= d)%nat -> choose d (S k) = choose (d - 1) k + choose (d - 1) (S k).
Proof. destruct d as [|d]; [lia|]. intros _. now rewrite Nat.sub_succ, Nat.sub_0_r. Qed.

Definition kind_eq_dec (a b : kind) : {a = b} + {a <> b}.
Proof. decide equality. Defined.

Lemma linear_in_regions n : forall D d A, (length A <= n)%nat -> (length D <= d)%nat ->
  Forall (within D) A -> forall k, count k A <= choose d k * count 0 A.
Proof.
  induction n as [|n IH]; intros D d A L LD W k.
  { destruct A; [|cbn in L; lia]. destruct k as [|k]; [rewrite choose_none; lia|].
    pose proof (choose_nonneg d (S k)). change (count 0 []) with 1.
    replace (count (S k) []) with 0 by now destruct k. lia. }
  destruct (Forall_Exists_dec (fun g => look_real g = Plane)
    (fun g => kind_eq_dec (look_real g) Plane) A) as [P|Q].
  2: { apply Exists_exists in Q as (g & (l1 & l2 & ->)%in_split & G).
    assert (Permutation (l1 ++ g :: l2) (g :: l1 ++ l2)) as Q by (symmetry; apply Permutation_middle).
    rewrite !(permuted_count _ Q), !(@flat_count g (l1 ++ l2) _ G). apply IH with D; trivial.
    - rewrite app_length in *. cbn in L. lia.
    - apply (Permutation_Forall Q) in W. now inversion W. }
  destruct A as [|h A]; [apply IH with D; trivial; cbn; lia|]. cbn in L.
  inversion P as [|? ? K PA]; subst. inversion W as [|? ? Wh WA]; subst.
  destruct (Exists_dec (fun g => look_real (restrict_real h g) = Vanishes) A
    (fun g => kind_eq_dec (look_real (restrict_real h g)) Vanishes)) as [V|V%Forall_Exists_neg].
  { apply Exists_exists in V as (g & I & Z).
    rewrite Forall_forall in PA. rewrite !(@doubled_count h g A _ K I (PA g I) Z). now apply IH with D; trivial; lia. }
  destruct k as [|k]; [rewrite choose_none; lia|].
  pose proof (@pivot_within D h K Wh) as Less. set (D' := remove Nat.eq_dec (pivot_real (coefficients h)) D) in *.
  assert (Forall (within D') (on h A)) as W' by now apply restricted_within.
  assert (length (on h A) <= n)%nat as L' by (rewrite map_length; lia).
  pose proof (IH D d A ltac:(lia) LD WA (S k)).
  pose proof (IH D' (d - 1)%nat (on h A) L' ltac:(lia) W' (S k)).
  pose proof (IH D' (d - 1)%nat (on h A) L' ltac:(lia) W' k).
  pose proof (@crossed_count h A K PA V k). rewrite (@grown h A K PA V).
  rewrite (@choose_step d k) in * by lia. lia.
Qed.

Lemma faces_of_regions d planes k n v : of_space d planes ->
  number (face_of_codimension k planes) n -> number (face_of_codimension 0 planes) v -> n <= choose d k * v.
Proof.
  intros S N V. rewrite (number_unique N (count_number k planes)), (number_unique V (count_number 0 planes)).
  apply (@linear_in_regions (length planes) (seq 0 d)); trivial; [now rewrite seq_length|].
  now apply of_space_within.
Qed.

(** * Great circles with twice as many facets as regions, less four *)

Definition defect (A : list (form R)) : Z := 2 * count 0 A - count 1 A.

Lemma alternating_three l : (forall k, (3 <= k)%nat -> nth k l 0 = 0) ->
  alternating l = nth 0 l 0 - nth 1 l 0 + nth 2 l 0.
Proof.
  intros Far.
  assert (forall l, (forall k, nth k l 0 = 0) -> alternating l = 0) as Zeros.
  { induction l0 as [|a l0 IH]; trivial. intros H. cbn. rewrite IH.
    - specialize (H O). cbn in H. lia.
    - intros k. apply (H (S k)). }
  destruct l as [|a [|b [|c l]]]; cbn [nth alternating] in *; try lia.
  rewrite (Zeros l); [lia|]. intros k. apply (Far (S (S (S k)))). lia.
Qed.

(** On a circle there are as many arcs as points, one more with no two points. *)
Lemma circle_euler D A : (length D <= 2)%nat -> Forall (within D) A -> Forall central A ->
  count 0 A - count 1 A = 1 - count 2 A.
Proof.
  intros L W C.
  assert (forall k, (3 <= k)%nat -> count k A = 0) as Far.
  { intros k K. pose proof (count_nonneg k A).
    pose proof (@faces_deep (length A) D [] A k (le_n _) ltac:(lia) ltac:(constructor) W ltac:(constructor) C) as Deep.
    fold (faces_real A) in Deep. fold (count k A) in Deep. destruct (Nat.eqb_spec (length D) k); lia. }
  pose proof (@faces_alternate _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length A) [] A (le_n _)) as Alt.
  change (alternating (faces_real A) = 1) in Alt. unfold count in *.
  now rewrite (alternating_three (faces_real A) Far) in Alt; lia.
Qed.

Lemma circle_points D A : (length D <= 2)%nat -> Forall (within D) A -> Forall central A -> count 2 A <= 1.
Proof.
  intros L W C.
  pose proof (@faces_deep (length A) D [] A 2 (le_n _) L ltac:(constructor) W ltac:(constructor) C) as Deep.
  fold (faces_real A) in Deep. fold (count 2 A) in Deep. destruct (length D =? 2)%nat; lia.
Qed.

Lemma defect_cons h A : great_circles (h :: A) -> general 2 (h :: A) ->
  defect A + 1 - count 2 (on h A) <= defect (h :: A) /\ count 2 (on h A) <= 1.
Proof.
  intros [S C] G. pose proof (@general_plane 1 (h :: A) h G (or_introl eq_refl)) as K.
  assert (Forall (fun g => look_real (restrict_real h g) <> Vanishes) A) as V
    by (eapply Forall_impl; [|exact (restricted_planes G)]; cbn; congruence).
  assert (Forall (fun g => look_real g = Plane) A) as P.
  { apply Forall_forall. intros g I. apply (@general_plane 1 (h :: A)); trivial. now right. }
  pose proof (of_space_within S) as W. inversion W as [|? ? Wh WA]; subst. inversion C as [|? ? Ch CA]; subst.
  pose proof (@pivot_within (seq 0 3) h K Wh) as Less. rewrite seq_length in Less.
  pose proof (restricted_within K Wh WA) as W'. pose proof (restricted_central Ch CA) as C'.
  set (D' := remove _ _ _) in *. assert (length D' <= 2)%nat as Two by lia.
  pose proof (circle_euler Two W' C'). pose proof (circle_points Two W' C').
  pose proof (@grown h A K P V). pose proof (@crossed_count h A K P V 0). unfold defect. lia.
Qed.

Lemma general_2_pair f g : general 2 [f; g] -> general 3 [f; g].
Proof.
  intros G fs rest P _. apply (G fs rest P). apply Permutation_length in P.
  rewrite app_length in P. cbn in P. lia.
Qed.

Lemma three_defect f g h : great_circles [f; g; h] -> general 2 [f; g; h] -> ~ independent [f; g; h] ->
  5 <= defect [f; g; h].
Proof.
  intros Ci G N. pose proof (defect_cons Ci G) as [H _]. destruct Ci as [S C].
  pose proof (@general_plane 1 _ f G (or_introl eq_refl)) as K.
  assert (count 2 (on f [g; h]) = 0) as E.
  { apply (number_unique (P := face_of_codimension 2 (on f [g; h]))); [apply count_number|].
    apply number_none. intros s [_ [(gs & I & D & L) _]]. apply N, independent_restricted; trivial.
    apply independent_permutation with gs; trivial.
    apply NoDup_Permutation_bis; [now apply independent_nodup|cbn in *; lia|].
    intros k Kin. apply I in Kin. clear - Kin. revert s Kin. cbn [map].
    generalize (restrict_real f g) as a, (restrict_real f h) as b. intros a b s Kin.
    destruct s as [|[] [|[] s]]; cbn in *; tauto. }
  assert (of_space 3 [g; h] /\ Forall central [g; h]) as [S2 C2].
  { unfold of_space in *. inversion S; inversion C; subst. now split. }
  assert (general 3 [g; h]) as G3 by (apply general_2_pair; now apply general_tail with f).
  pose proof (@general_faces 3 [g; h] 0 S2 C2 G3 ltac:(lia)) as F0.
  pose proof (@general_faces 3 [g; h] 1 S2 C2 G3 ltac:(lia)) as F1.
  pose proof (number_unique F0 (count_number 0 [g; h])) as E0.
  pose proof (number_unique F1 (count_number 1 [g; h])) as E1.
  cbn [length Nat.sub choose central_regions choose_upto] in E0, E1. unfold defect in *. lia.
Qed.

Lemma defect_grows B : forall A, great_circles (B ++ A) -> general 2 (B ++ A) -> defect A <= defect (B ++ A).
Proof.
  induction B as [|h B IH]; intros A [S C] G; [cbn; lia|]. cbn [app] in *.
  pose proof (defect_cons (conj S C) G). specialize (IH A).
  assert (great_circles (B ++ A)) as Ci by (unfold of_space in S; inversion S; inversion C; subst; now split).
  specialize (IH Ci (general_tail G)). lia.
Qed.

Lemma only_general_defect planes : great_circles planes -> general 2 planes -> defect planes <= 4 ->
  general 3 planes.
Proof.
  intros Ci G Few fs rest P L. destruct (Nat.eq_dec (length fs) 3) as [Three|N].
  2: { apply (G fs rest); trivial. lia. }
  destruct fs as [|f [|g [|h [|k fs]]]]; try easy. destruct (rank_of [f; g; h]) as (k & R).
  destruct (Nat.eq_dec k 3) as [->|N]; [now apply rank_independent|]. exfalso.
  assert (Permutation planes (rest ++ [f; g; h])) as Q by (rewrite P; apply Permutation_app_comm).
  assert (great_circles (rest ++ [f; g; h])) as [S C].
  { destruct Ci as [S C]. split; [apply (Permutation_Forall Q S)|apply (Permutation_Forall Q C)]. }
  pose proof (general_permutation Q G) as GQ.
  pose proof (@defect_grows rest [f; g; h] (conj S C) GQ) as Le.
  assert (great_circles [f; g; h] /\ general 2 [f; g; h]) as [C3 G3].
  { unfold of_space in S. apply Forall_app in S as [_ S], C as [_ C]. split; [now split|].
    clear - GQ. induction rest as [|a rest IH]; trivial. apply IH. now apply general_tail with a. }
  assert (5 <= defect [f; g; h]).
  { apply three_defect; trivial. intros D. apply N. apply (rank_unique R (independent_rank D)). }
  unfold defect in Few, Le, H. rewrite <- !(permuted_count _ Q) in Le. lia.
Qed.

Lemma only_general_dual planes e f : great_circles planes ->
  (forall f, In f planes -> exists x, value f x <> 0%R) -> different planes ->
  number (face_of_codimension 1 planes) e -> number (face_of_codimension 0 planes) f ->
  2 * f - 4 <= e -> general 3 planes.
Proof.
  intros Ci Some D E F Le. apply only_general_defect; trivial; [now apply different_general|].
  unfold defect. rewrite (number_unique E (count_number 1 planes)), (number_unique F (count_number 0 planes)) in Le. lia.
Qed.

(** * Bounds of the dual, in rank 2 too *)

Lemma dual_bounds planes k v e f : great_circles planes -> rank planes k -> (2 <= k)%nat ->
  number (face_of_codimension 2 planes) v -> number (face_of_codimension 1 planes) e ->
  number (face_of_codimension 0 planes) f -> 1 <= f /\ e <= 2 * f - 4 /\ v <= f - 2.
Proof.
  intros Ci R K V E F. pose proof (dual_edges Ci R K E F) as Edges.
  pose proof (number_nonneg E). pose proof (number_nonneg V).
  destruct (Nat.eq_dec k 3) as [->|N]; [pose proof (dual_faces Ci R V E F); lia|].
  destruct Ci as [S C].
  assert (forall j, (3 <= j)%nat -> count j planes = 0) as Far.
  { intros j J. apply (number_unique (P := face_of_codimension j planes)); [apply count_number|].
    apply number_none. intros s [_ [(gs & I & D & L) _]].
    destruct (circle_rank (conj S C)) as (k' & R' & K'). rewrite (rank_unique R' R) in K'.
    destruct R as [_ U]. pose proof (U gs (incl_tran I (@through_incl planes s)) D). lia. }
  pose proof (@faces_alternate _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane (length planes) [] planes (le_n _)) as Alt.
  change (alternating (faces_real planes) = 1) in Alt.
  rewrite (number_unique V (count_number 2 planes)), (number_unique E (count_number 1 planes)),
    (number_unique F (count_number 0 planes)) in *. unfold count in *.
  rewrite (alternating_three (faces_real planes) Far) in Alt. lia.
Qed.

(** A plane that coincides with another one changes no number of faces. *)
Lemma coincident_faces planes f g k n : In f planes -> same_plane f g ->
  number (face_of_codimension k (g :: planes)) n <-> number (face_of_codimension k planes) n.
Proof.
  intros I T. pose proof T as (c & C). destruct (@merged_sign planes g f c I C) as (phi & Phi).
  apply merged_number with (fun s => phi s :: s).
  - split; [now apply incl_tl|]. intros h [<-|H]; right; [now exists f, c|].
    exists h, 1%R. split; trivial. split; [lra|]. intros x. ring.
  - split; [intros a b [=]; auto|]. intros x. now rewrite signs_cons, Phi.
Qed.
