(** Contacts that may let go: their states, trees of states, faces of their planes. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Sphere Graph Crossed Mixed.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * States of contacts *)

Lemma read_states cs x : map (state_at x) cs =
  map (fun p => contact_at (fst p) (snd p)) (combine (signs (map slip cs) x) (signs (map gap cs) x)).
Proof. induction cs as [|c cs IH]; trivial. cbn. now rewrite IH. Qed.

Definition read (m : nat) (s : list sign) : list contact_state :=
  map (fun p => contact_at (fst p) (snd p)) (combine (firstn m s) (skipn m s)).

Lemma read_signs cs x : map (state_at x) cs = read (length cs) (signs (contact_planes cs) x).
Proof.
  unfold read, contact_planes. rewrite read_states. unfold signs. rewrite map_app.
  assert (length cs = length (map (fun f => sgn (value f x)) (map slip cs))) as L by now rewrite !map_length.
  now rewrite L, firstn_app, skipn_app, firstn_all, skipn_all, Nat.sub_diag, firstn_O, app_nil_r.
Qed.

Lemma state_read cs s : state cs s -> exists t, face (contact_planes cs) t /\ read (length cs) t = s.
Proof.
  intros (x & <-). exists (signs (contact_planes cs) x). split; [now exists x|]. symmetry. apply read_signs.
Qed.

Lemma number_map T U (P : T -> Prop) (Q : U -> Prop) (f : T -> U) n m :
  (forall u, Q u -> exists t, P t /\ f t = u) -> number P n -> number Q m -> m <= n.
Proof.
  intros H (l & (_ & L) & <-) (k & (N & K) & <-).
  enough (length k <= length (map f l))%nat by (rewrite map_length in *; lia).
  apply NoDup_incl_length; trivial. intros u I. apply K, H in I as (t & Pt & <-).
  apply in_map_iff. exists t. split; trivial. now apply L.
Qed.

Lemma states_of_faces cs n f : number (face (contact_planes cs)) f -> number (state cs) n -> n <= f.
Proof. apply number_map with (f := read (length cs)), state_read. Qed.

(** * Trees of states *)

Lemma path_length s : (length (flat_map choices s) <= 2 * length s)%nat.
Proof. induction s as [|[|a] s IH]; cbn in *; lia. Qed.

(** Nodes at one depth are no more than faces. *)
Lemma depth_of_faces cs k f n : number (face (contact_planes cs)) f ->
  number (fun p => node cs p /\ length p = k) n -> n <= f.
Proof.
  apply number_map with (f := fun t => firstn k (flat_map choices (read (length cs) t))).
  intros p [(s & rest & S & E) L]. destruct (state_read S) as (t & F & <-). exists t. split; trivial.
  rewrite E, <- L, firstn_app, Nat.sub_diag, firstn_all, firstn_O. apply app_nil_r.
Qed.

Definition choice_eq_dec (a b : choice) : {a = b} + {a <> b}.
Proof. decide equality. apply sign_eq_dec. Defined.

Lemma filter_number T (P : T -> Prop) (p : T -> bool) l :
  lists P l -> number (fun a => P a /\ p a = true) (Z.of_nat (length (filter p l))).
Proof.
  intros [N L]. exists (filter p l). split; trivial. split; [now apply NoDup_filter|].
  intros a. rewrite filter_In, L. reflexivity.
Qed.

Lemma depths_total T (a : T -> nat) (l : list T) b m : (forall x, In x l -> (a x < m)%nat) ->
  (forall k, (k < m)%nat -> Z.of_nat (length (filter (fun x => (a x =? k)%nat) l)) <= b k) ->
  Z.of_nat (length l) <= total b m.
Proof.
  revert l. induction m as [|m IH]; intros l Low B.
  - destruct l as [|x l]; [cbn; lia|]. specialize (Low x (or_introl eq_refl)). lia.
  - cbn [total]. rewrite (filter_split (fun x => (a x =? m)%nat) l).
    pose proof (B m ltac:(lia)). rewrite Nat2Z.inj_add.
    enough (Z.of_nat (length (filter (fun x => negb (a x =? m)%nat) l)) <= total b m) by lia. apply IH.
    + intros x [I N]%filter_In. apply Low in I. destruct (Nat.eqb_spec (a x) m); [easy|lia].
    + intros k K. eapply Z.le_trans; [|apply (B k); lia]. apply inj_le. clear.
      induction l as [|x l IH]; trivial. cbn. destruct (a x =? m)%nat, (a x =? k)%nat eqn:E; cbn; rewrite ?E; cbn; lia.
Qed.

Lemma three_faces cs : cs <> [] -> Forall planar cs -> forall f, number (face (contact_planes cs)) f -> 3 <= f.
Proof.
  intros N P f. destruct cs as [|c cs]; [easy|]. inversion P as [|? ? (_ & _ & C & D) _]; subst.
  assert (forall a, exists x, sgn (value (slip c) x) = a) as Any.
  { intros a. destruct (D [match a with Minus => (-1)%R | Zero => 0%R | Plus => 1%R end; 0%R] eq_refl) as (v & V).
    injection V as V _. exists v. unfold value. rewrite C, V.
    destruct a; rewrite ?sgn_minus, ?sgn_zero, ?sgn_plus; lra. }
  intros (l & (Nl & L) & <-).
  enough (length [Minus; Zero; Plus] <= length (map (hd Zero) l))%nat by (rewrite map_length in *; cbn in *; lia).
  apply NoDup_incl_length.
  - repeat constructor; cbn; intuition discriminate.
  - intros a _. destruct (Any a) as (x & X). apply in_map_iff. exists (signs (contact_planes (c :: cs)) x).
    split; [exact X|]. apply L. now exists x.
Qed.

Lemma tree_of_faces cs f n : cs <> [] -> Forall planar cs ->
  number (face (contact_planes cs)) f -> number (node cs) n -> n <= 2 * size cs * f.
Proof.
  intros N P F (l & (Nl & L) & <-). pose proof (three_faces N P F) as Three.
  assert (forall p, In p l -> (length p < S (2 * length cs))%nat) as Low.
  { intros p (s & rest & (x & <-) & E)%L. pose proof (path_length (map (state_at x) cs)) as H.
    rewrite E, app_length, map_length in H. lia. }
  assert (forall k, Z.of_nat (length (filter (fun p => (length p =? k)%nat) l)) <=
    match k with O => 1 | S O => 2 | _ => f end) as B.
  { intros k.
    assert (number (fun p => node cs p /\ length p = k) (Z.of_nat (length (filter (fun p => (length p =? k)%nat) l)))) as Nk.
    { eapply number_iff; [|apply (@filter_number _ (node cs) (fun p => (length p =? k)%nat) l); now split].
      intros p. cbn beta. now rewrite Nat.eqb_eq. }
    pose proof (depth_of_faces F Nk) as Most.
    assert (forall few, (forall p, node cs p -> length p = k -> In p few) ->
      Z.of_nat (length (filter (fun p => (length p =? k)%nat) l)) <= size few) as Few.
    { intros few H. apply inj_le, NoDup_incl_length; [now apply NoDup_filter|].
      intros p [I E]%filter_In. apply Nat.eqb_eq in E. apply H; trivial. now apply L. }
    destruct k as [|[|k]].
    - apply (Few [[]]). intros [|a p] _ E; [now left|easy].
    - apply (Few [[LetsGo]; [Holds]]). intros [|a [|b p]] (s & rest & _ & E) Len; try easy.
      destruct s as [|[|t] s]; cbn in E; [easy| |]; injection E as <- _; cbn; auto.
    - now apply Most. }
  pose proof (@depths_total _ (@length choice) l _ (S (2 * length cs)) Low (fun k _ => B k)) as H.
  eapply Z.le_trans; [exact H|]. unfold size. destruct cs as [|c cs]; [easy|].
  assert (forall m, total (fun k => match k with O => 1 | S O => 2 | _ => f end) (S (S m)) = 3 + Z.of_nat m * f) as Sum.
  { induction m as [|m IH]; [reflexivity|]. cbn [total] in *. rewrite IH, Nat2Z.inj_succ. lia. }
  replace (S (2 * length (c :: cs)))%nat with (S (S (2 * length cs + 1)))%nat by (cbn; lia).
  rewrite Sum. cbn [length]. nia.
Qed.

(** * The numbers of the model *)

Lemma planar_space cs : Forall planar cs -> of_space 3 (contact_planes cs) /\ Forall central (map slip cs).
Proof.
  intros P. unfold of_space, contact_planes. rewrite Forall_app, !Forall_map.
  repeat split; (eapply Forall_impl; [|exact P]); unfold planar; tauto.
Qed.

Lemma contact_faces cs k n : Forall planar cs -> (k <= 3)%nat ->
  number (face_of_codimension k (contact_planes cs)) n -> n <= most_mixed 0 (length cs) (length cs) 3 k.
Proof.
  intros P K N. destruct (planar_space P) as [S C].
  rewrite (number_unique N (count_number k (contact_planes cs))).
  pose proof (Permutation_app_comm (map slip cs) (map gap cs)) as Q. unfold contact_planes in *.
  rewrite (permuted_count k Q). pose proof (Permutation_Forall Q S) as S'.
  pose proof (@mixed_all (map gap cs) (length (map gap cs ++ map slip cs)) (seq 0 3) 3 [] (map slip cs) k
    (le_n _) ltac:(now rewrite seq_length) K ltac:(constructor) (of_space_within S') C) as H.
  now rewrite !map_length in H.
Qed.

Lemma total_choose p k q : total (fun i => choose (p + i) k) q = choose (p + q) (S k) - choose p (S k).
Proof.
  induction q as [|q IH]; [rewrite Nat.add_0_r; cbn; lia|]. cbn [total]. rewrite IH, <- plus_n_Sm.
  change (choose (S (p + q)) (S k)) with (choose (p + q) k + choose (p + q) (S k)). lia.
Qed.

Lemma preload_faces cs points lines facets regions : Forall planar cs -> 3 <= size cs ->
  number (face_of_codimension 3 (contact_planes cs)) points ->
  number (face_of_codimension 2 (contact_planes cs)) lines ->
  number (face_of_codimension 1 (contact_planes cs)) facets ->
  number (face_of_codimension 0 (contact_planes cs)) regions ->
  let n := length cs in let m := size cs in
  points <= choose (2 * n) 3 - choose n 3 + 1 /\
  lines <= choose n 2 * (m + 2) + (choose (2 * n) 2 - choose n 2) * (2 * m - 1) /\
  facets <= m * (2 * m - 2 + total (fun i => 1 + (m - 1 + Z.of_nat i)) n) + m * (2 * m + choose (2 * n - 1) 2) /\
  regions <= m * m - m + 2 + total (fun i => 1 + (m + Z.of_nat i) + choose (n + i) 2) n.
Proof.
  intros P M N3 N2 N1 N0 n m. apply (contact_faces P) in N3, N2, N1, N0; try lia.
  fold n in N3, N2, N1, N0. unfold most_mixed in *. cbn [Nat.ltb Nat.leb Nat.sub Nat.add] in *.
  assert (m = Z.of_nat n) as Em by reflexivity. assert (3 <= n)%nat as Big by (unfold size in M; fold n in M; lia).
  replace (2 * n)%nat with (n + n)%nat by lia.
  assert (forall a b q, (forall i, a i = b i) -> total a q = total b q) as Ext.
  { intros a b q E. induction q as [|q IH]; trivial. cbn. now rewrite IH, E. }
  assert (forall x, choose_upto x 1 = 1 + Z.of_nat x) as U1 by (intros; cbn [choose_upto]; now rewrite choose_1).
  assert (forall x, choose_upto x 2 = 1 + Z.of_nat x + choose x 2) as U2 by (intros; cbn [choose_upto]; now rewrite choose_1).
  rewrite !total_choose in *. rewrite !choose_none, ?choose_1, ?Nat.sub_0_r in *.
  destruct n as [|[|[|n']]] eqn:En; try lia. rewrite <- En in *. repeat split.
  - cbn [choose_upto] in N3. lia.
  - rewrite U1 in N2. rewrite mixed_total in N2. replace (n - 2)%nat with (S n') in N2 by lia.
    rewrite (Ext (fun i => choose_upto (S n' + i) 0) (fun _ => 1)) in N2 by reflexivity.
    assert (forall q, total (fun _ => 1) q = Z.of_nat q) as One by (induction q; cbn [total]; lia).
    rewrite One in N2. change (central_regions (S n') 1) with 2 in N2.
    replace (1 + Z.of_nat (n + n - 2)) with (2 * m - 1) in N2 by lia. rewrite <- Em in N2. lia.
  - rewrite U2, mixed_total in N1. replace (n - 1)%nat with (S (S n')) in N1 by lia. rewrite circles_2 in N1.
    rewrite (Ext _ (fun i => 1 + (m - 1 + Z.of_nat i))) in N1 by (intros; rewrite U1; lia).
    rewrite <- Em in N1. replace (1 + Z.of_nat (n + n - 1)) with (2 * m) in N1 by lia.
    replace (2 * Z.of_nat (S (S n'))) with (2 * m - 2) in N1 by lia. lia.
  - rewrite mixed_total in N0. rewrite (Ext _ (fun i => 1 + (m + Z.of_nat i) + choose (n + i) 2)) in N0
      by (intros; rewrite U2; lia).
    replace (central_regions n 3) with (m * m - m + 2) in N0 by (rewrite En, circles_3, <- En; lia). lia.
Qed.

Lemma faces_beyond n : forall D nz A k, (length A <= n)%nat -> (length D < k)%nat ->
  Forall (within D) A -> nth k (faces look_real restrict_real n nz A) 0 = 0.
Proof.
  induction n as [|n IH]; intros D nz [|h A] [|k] L LD W; try (cbn in L; lia); try lia; try now destruct k.
  cbn in L. inversion W as [|? ? Wh WA]; subst. cbn [faces].
  destruct (look_real h) eqn:K; try (apply IH with D; trivial; lia).
  rewrite nth_sum, IH with (D := D) by (trivial; lia). pose proof (@pivot_within D h K Wh) as Less.
  destruct (onto look_real (restrict_real h) nz) as [nz'|]; cbn [nth]; [|lia].
  rewrite IH with (D := remove Nat.eq_dec (pivot_real (coefficients h)) D); [lia| |lia|].
  - pose proof (skim_length look_real (restrict_real h) A). lia.
  - apply skim_all with (P := within D); trivial. intros g G. now apply within_restrict.
Qed.

Lemma faces_of_space planes : of_space 3 planes ->
  number (face planes) (count 0 planes + count 1 planes + count 2 planes + count 3 planes).
Proof.
  intros S. pose proof (slip_states_total planes) as T. rewrite four_terms_far in T; trivial.
  intros k K. apply (@faces_beyond (length planes) (seq 0 3) [] planes k (le_n _)).
  - rewrite seq_length. lia.
  - now apply of_space_within.
Qed.

Lemma central_contacts cs : Forall planar cs -> Forall (fun c => central (gap c)) cs ->
  great_circles (contact_planes cs) /\ size (contact_planes cs) = 2 * size cs.
Proof.
  intros P G. destruct (planar_space P) as [S C]. split.
  - split; trivial. unfold contact_planes. apply Forall_app. split; trivial. now apply Forall_map.
  - unfold size, contact_planes. rewrite app_length, !map_length. lia.
Qed.
