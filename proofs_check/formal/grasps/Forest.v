(** Where the contact graph of an assembly is a forest, its question is one question for each body:
    about its contacts with what it hangs on, and the load of all that hangs on it. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz Arith.
Require Import Model Rationals Checker Vectors Parts.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Local Notation force := (R * R * R)%type.

(** * Lists that are chosen, and spread *)

Lemma chosen A (a : A) (P : nat -> A -> Prop) n :
  (forall i, (i < n)%nat -> exists x, P i x) -> exists f, forall i, (i < n)%nat -> P i (f i).
Proof.
  induction n as [|n IH]; intros H; [exists (fun _ => a); lia|].
  destruct IH as [f F]; [intros; apply H; lia|]. destruct (H n) as [x X]; [lia|].
  exists (fun i => if Nat.eqb i n then x else f i). intros i I.
  destruct (Nat.eqb_spec i n) as [->|]; trivial. apply F. lia.
Qed.

Section Spread.
  Variables (A : Type) (edge : A -> nat).

  (** Each takes the next one of its edge. *)
  Fixpoint spread (l : list A) (f : nat -> list force) : list force :=
    match l with
    | [] => []
    | x :: l =>
        hd (0, 0, 0) (f (edge x)) ::
        spread l (fun i => if Nat.eqb i (edge x) then tl (f i) else f i)
    end.

  Definition on_edge (i : nat) (l : list A) : list A := filter (fun x => Nat.eqb (edge x) i) l.

  Lemma spread_holds (P : nat -> A -> force -> Prop) : forall l f,
    (forall x, In x l -> Forall2 (P (edge x)) (on_edge (edge x) l) (f (edge x))) ->
    Forall2 (fun x => P (edge x) x) l (spread l f).
  Proof.
    induction l as [|x l IH]; intros f H; cbn [spread]; constructor.
    - specialize (H x (or_introl eq_refl)). unfold on_edge in H. cbn [filter] in H.
      rewrite Nat.eqb_refl in H. inversion H; subst. easy.
    - apply IH. intros y I. specialize (H y (or_intror I)). unfold on_edge in *. cbn [filter] in H.
      destruct (Nat.eqb_spec (edge y) (edge x)) as [E|E].
      + rewrite E in *. rewrite Nat.eqb_refl in H. now inversion H; subst.
      + destruct (Nat.eqb_spec (edge x) (edge y)); [congruence | trivial].
  Qed.

  Lemma spread_edge i : forall l f, length (f i) = length (on_edge i l) ->
    map snd (filter (fun p => Nat.eqb (edge (fst p)) i) (combine l (spread l f))) = f i.
  Proof.
    induction l as [|x l IH]; intros f L; cbn [spread combine filter map fst] in *.
    - now destruct (f i).
    - unfold on_edge in *. cbn [filter] in L. destruct (Nat.eqb_spec (edge x) i) as [<-|N].
      + cbn [map snd]. rewrite IH; rewrite Nat.eqb_refl; destruct (f (edge x)); try easy.
        cbn in *. lia.
      + rewrite IH; destruct (Nat.eqb_spec i (edge x)) as [E|E]; congruence.
  Qed.

  Lemma spread_length : forall l f, length (spread l f) = length l.
  Proof. induction l; intros; cbn; auto. Qed.
End Spread.

(** * Blocks of three *)

Lemma fold_seq_shift (g : nat -> R) n : forall a,
  fold_right (fun k sum => g k + sum) 0 (seq (S a) n) =
  fold_right (fun k sum => g (S k) + sum) 0 (seq a n).
Proof. induction n as [|n IH]; intros a; cbn; [trivial|]. now rewrite IH. Qed.

Lemma fold_seq_same (g h : nat -> R) n : (forall k, g k = h k) -> forall a,
  fold_right (fun k sum => g k + sum) 0 (seq a n) = fold_right (fun k sum => h k + sum) 0 (seq a n).
Proof. intros E. induction n as [|n IH]; intros a; cbn; [trivial|]. now rewrite IH, E. Qed.

(** All terms but one are 0. *)
Lemma fold_seq_one (g : nat -> R) k n : forall a, (a <= k < a + n)%nat ->
  (forall m, (a <= m < a + n)%nat -> m <> k -> g m = 0) ->
  fold_right (fun m sum => g m + sum) 0 (seq a n) = g k.
Proof.
  assert (forall n a, (forall m, (a <= m < a + n)%nat -> g m = 0) ->
    fold_right (fun m sum => g m + sum) 0 (seq a n) = 0) as None.
  { induction n0 as [|n0 IH]; intros a H; cbn; trivial. rewrite IH, H by (intros; try apply H; lia). ring. }
  induction n as [|n IH]; intros a K H; [lia|]. cbn.
  destruct (Nat.eq_dec a k) as [->|N].
  - rewrite None; [ring|]. intros. apply H; lia.
  - rewrite IH, (H a) by (intros; try apply H; lia). ring.
Qed.

Lemma skipn_twice A (v : list A) n m : skipn m (skipn n v) = skipn (n + m) v.
Proof. revert v. induction n as [|n IH]; intros [|x v]; cbn; rewrite ?skipn_nil; trivial. Qed.

Lemma dot_three_more (s : bool) v w x y z :
  dot v ((if s then [x; y; z] else [0; 0; 0]) ++ w) =
  (if s then dot (skipn (3 * 0) v) [x; y; z] else 0) + dot (skipn 3 v) w.
Proof.
  destruct v as [|a [|b [|c v]]], s; cbn; rewrite ?dot_nil; ring.
Qed.

Lemma dot_blocks part : forall v x y z,
  dot v (together part [x; y; z]) =
  fold_right (fun k sum => (if nth k part false then dot (skipn (3 * k) v) [x; y; z] else 0) + sum) 0
    (seq 0 (length part)).
Proof.
  unfold together. induction part as [|s part IH]; intros v x y z; cbn [flat_map length seq fold_right].
  - apply dot_nil.
  - rewrite fold_seq_shift. cbn [nth].
    rewrite (@fold_seq_same _ (fun k => if nth k part false
      then dot (skipn (3 * k) (skipn 3 v)) [x; y; z] else 0)).
    + rewrite <- IH. apply dot_three_more.
    + intros k. replace (3 * S k)%nat with (3 + 3 * k)%nat by lia. now rewrite skipn_twice.
Qed.

Lemma zero_blocks : forall n v, (length v <= 3 * n)%nat ->
  (forall k, (k < n)%nat -> forall x y z, dot (skipn (3 * k) v) [x; y; z] = 0) ->
  Forall (fun x => x = 0) v.
Proof.
  induction n as [|n IH]; intros v L H.
  - destruct v; [constructor | cbn in L; lia].
  - assert (Forall (fun x => x = 0) (skipn 3 v)) as Rest.
    { apply IH; [rewrite skipn_length; lia|]. intros k K x y z. rewrite skipn_twice.
      replace (3 + 3 * k)%nat with (3 * S k)%nat by lia. apply H. lia. }
    pose proof (H 0%nat ltac:(lia)) as Z. cbn [Nat.mul skipn] in Z.
    pose proof (Z 1 0 0) as X. pose proof (Z 0 1 0) as Y. pose proof (Z 0 0 1) as W.
    destruct v as [|a [|b [|c v]]]; cbn in *; rewrite ?dot_nil in *;
      repeat (constructor; [lra|]); exact Rest || constructor.
Qed.

(** * Forests *)

Section Forest.
  Variables (b : nat) (parent : nat -> option nat) (js : list (joint Q)) (load : list Q).

  (** The body of a contact that hangs on the other one, or on the ground. *)
  Definition child (j : joint Q) : nat :=
    match body_b j with
    | Some m => match parent m with
        | Some p => if Nat.eqb p (body_a j) then m else body_a j
        | None => body_a j
        end
    | None => body_a j
    end.

  (** Each contact joins a body with what it hangs on, which comes before it. *)
  Definition is_forest : Prop :=
    (forall i p, parent i = Some p -> (p < i)%nat) /\
    (forall j, In j js -> (child j < b)%nat /\
      ((body_a j = child j /\ body_b j = parent (child j)) \/
       (body_b j = Some (child j) /\ parent (child j) = Some (body_a j)))) /\
    (length load <= 3 * b)%nat.

  (** Whether a body is another one or hangs on it. *)
  Fixpoint hangs (fuel k i : nat) : bool :=
    Nat.eqb k i ||
    match fuel, parent k with
    | S fuel, Some p => hangs fuel p i
    | _, _ => false
    end.

  Definition branch (i : nat) : list bool := map (fun k => hangs k k i) (seq 0 b).

  (** The question about one body. *)
  Definition one_body (i : nat) : question Q :=
    InPlane (map (inward (branch i)) (filter (crosses (branch i)) js)) (load_on (branch i) load).

  Hypothesis Forest : is_forest.

  Lemma hangs_fuel : forall k fuel i, (k <= fuel)%nat -> hangs fuel k i = hangs k k i.
  Proof.
    destruct Forest as [P _].
    induction k as [k IH] using lt_wf_ind. intros fuel i L.
    destruct (parent k) as [p|] eqn:E.
    - pose proof (P _ _ E). destruct fuel as [|fuel]; [lia|]. destruct k as [|k]; [lia|].
      cbn [hangs]. rewrite E. f_equal. rewrite (IH p) by lia. symmetry. apply IH; lia.
    - destruct fuel, k; cbn [hangs]; rewrite ?E; trivial.
  Qed.

  Lemma hangs_step k i : hangs k k i =
    Nat.eqb k i || match parent k with Some p => hangs p p i | None => false end.
  Proof.
    destruct Forest as [P _]. destruct (parent k) as [p|] eqn:E.
    - pose proof (P _ _ E). destruct k as [|k]; [lia|]. cbn [hangs]. rewrite E. f_equal.
      apply hangs_fuel. lia.
    - destruct k; cbn [hangs]; rewrite ?E; trivial.
  Qed.

  Lemma hangs_least k i : hangs k k i = true -> (i <= k)%nat.
  Proof.
    destruct Forest as [P _]. revert i. induction k as [k IH] using lt_wf_ind. intros i.
    rewrite hangs_step. destruct (Nat.eqb_spec k i) as [->|]; [lia|]. cbn [orb].
    destruct (parent k) as [p|] eqn:E; [|easy]. pose proof (P _ _ E). intros H1.
    specialize (IH p ltac:(lia) i H1). lia.
  Qed.

  Lemma in_branch i k : (k < b)%nat -> inside (branch i) (Some k) = hangs k k i.
  Proof.
    intros K. cbn [inside]. unfold branch.
    rewrite nth_indep with (d' := hangs b b i) by (rewrite map_length, seq_length; lia).
    change (hangs b b i) with ((fun k => hangs k k i) b). rewrite map_nth, seq_nth by lia. trivial.
  Qed.

  Lemma parent_in_branch i k : (k < b)%nat ->
    inside (branch i) (parent k) = match parent k with Some p => hangs p p i | None => false end.
  Proof.
    destruct Forest as [P _]. intros K. destruct (parent k) as [p|] eqn:E; [|easy].
    apply in_branch. pose proof (P _ _ E). lia.
  Qed.

  (** The contacts of a branch with the rest are those of its first body. *)
  Lemma crossing i j : In j js -> crosses (branch i) j = Nat.eqb (child j) i.
  Proof.
    destruct Forest as (P & J & _). intros I. destruct (J _ I) as [C Ends]. unfold crosses.
    assert (xorb (inside (branch i) (Some (child j))) (inside (branch i) (parent (child j))) =
      Nat.eqb (child j) i) as X.
    { rewrite in_branch, parent_in_branch, hangs_step by trivial.
      destruct (Nat.eqb_spec (child j) i) as [E|N]; cbn [orb].
      - destruct (parent (child j)) as [p|] eqn:F; trivial. pose proof (P _ _ F).
        destruct (hangs p p i) eqn:G; trivial. apply hangs_least in G. lia.
      - destruct (match parent (child j) with Some p => hangs p p i | None => false end); trivial. }
    destruct Ends as [[A B]|[B A]]; rewrite B.
    - rewrite A at 1. exact X.
    - rewrite <- A at 1. rewrite xorb_comm. exact X.
  Qed.

  Lemma crossing_all i : filter (crosses (branch i)) js = on_edge child i js.
  Proof. unfold on_edge. apply filter_ext_in. intros j I. now apply crossing. Qed.

  Lemma ends_of i j : (i < b)%nat -> In j (on_edge child i js) ->
    pair_of (branch i) j = (Some i, parent i).
  Proof.
    destruct Forest as (P & J & _). intros K I. unfold on_edge in I. apply filter_In in I.
    destruct I as [I E]. apply Nat.eqb_eq in E. subst i. destruct (J _ I) as [_ Ends].
    unfold pair_of. destruct Ends as [[A B]|[B A]].
    - rewrite A. now rewrite in_branch, hangs_step, Nat.eqb_refl, B.
    - rewrite B. assert (inside (branch (child j)) (Some (body_a j)) = false) as ->; [|now rewrite A].
      rewrite <- A, parent_in_branch, A by trivial. pose proof (P _ _ A).
      destruct (hangs _ _ _) eqn:G; trivial. apply hangs_least in G. lia.
  Qed.

  Lemma one_place i : (i < b)%nat -> at_one_place (branch i) (filter (crosses (branch i)) js) = true.
  Proof.
    intros K. rewrite crossing_all. unfold at_one_place.
    destruct (on_edge child i js) as [|first rest] eqn:E; trivial.
    assert (forall a, same_end a a = true) as Same by (intros [a|]; cbn; rewrite ?Nat.eqb_refl; trivial).
    apply forallb_forall. intros j I. rewrite <- E in I.
    assert (In first (on_edge child i js)) as F by (rewrite E; now left).
    rewrite (@ends_of i j K I), (@ends_of i first K F). cbn [fst snd]. now rewrite !Same.
  Qed.

  (** * From one body to all *)

  Section Parts.
  Variables (u : nat -> list R) (f : nat -> list force).
  Hypothesis Each : forall i, (i < b)%nat -> balances (real_question (one_body i)) (u i) (f i).

  (** The motion of a body: its own, and those of all on which it hangs. *)
  Fixpoint moved (fuel k : nat) : list R :=
    match fuel, parent k with
    | S fuel, Some p => add (u k) (moved fuel p)
    | _, _ => u k
    end.

  Definition motion_all : list R := flat_map (fun k => moved k k) (seq 0 b).

  Lemma moved_fuel : forall k fuel, (k <= fuel)%nat -> moved fuel k = moved k k.
  Proof.
    destruct Forest as [P _].
    induction k as [k IH] using lt_wf_ind. intros fuel L.
    destruct (parent k) as [p|] eqn:E.
    - pose proof (P _ _ E). destruct fuel as [|fuel]; [lia|]. destruct k as [|k]; [lia|].
      cbn [moved]. rewrite E. f_equal. rewrite (IH p) by lia. symmetry. apply IH; lia.
    - destruct fuel, k; cbn [moved]; rewrite ?E; trivial.
  Qed.

  Lemma moved_step k : moved k k =
    match parent k with Some p => add (u k) (moved p p) | None => u k end.
  Proof.
    destruct Forest as [P _]. destruct (parent k) as [p|] eqn:E.
    - pose proof (P _ _ E). destruct k as [|k]; [lia|]. cbn [moved]. rewrite E. f_equal.
      apply moved_fuel. lia.
    - destruct k; cbn [moved]; rewrite ?E; trivial.
  Qed.

  Lemma u_length i : (i < b)%nat -> length (u i) = 3%nat.
  Proof. intros K. apply (Each K). Qed.

  Lemma add_three (v w : list R) : length v = 3%nat -> length w = 3%nat -> length (add v w) = 3%nat.
  Proof. destruct v as [|? [|? [|? [|? ?]]]], w as [|? [|? [|? [|? ?]]]]; easy. Qed.

  Lemma moved_length : forall k, (k < b)%nat -> length (moved k k) = 3%nat.
  Proof.
    destruct Forest as [P _].
    induction k as [k IH] using lt_wf_ind. intros K. rewrite moved_step.
    destruct (parent k) as [p|] eqn:E; [|now apply u_length]. pose proof (P _ _ E).
    apply add_three; [now apply u_length | apply IH; lia].
  Qed.

  Lemma three_entries (v : list R) : length v = 3%nat -> [nth 0 v 0; nth 1 v 0; nth 2 v 0] = v.
  Proof. now destruct v as [|? [|? [|? [|? ?]]]]. Qed.

  Lemma flat_nth (g : nat -> list R) : forall n a k i, (forall m, (a <= m < a + n)%nat -> length (g m) = 3%nat) ->
    (a <= k < a + n)%nat -> (i < 3)%nat ->
    nth (3 * (k - a) + i) (flat_map g (seq a n)) 0 = nth i (g k) 0.
  Proof.
    induction n as [|n IH]; intros a k i G K I; [lia|]. cbn [seq flat_map].
    destruct (Nat.eq_dec k a) as [->|N].
    - rewrite Nat.sub_diag, app_nth1 by (rewrite G; lia). reflexivity.
    - rewrite app_nth2 by (rewrite G; lia). rewrite G by lia.
      replace (3 * (k - a) + i - 3)%nat with (3 * (k - S a) + i)%nat by lia.
      apply IH; trivial; [intros; apply G; lia | lia].
  Qed.

  Lemma motion_of_all k : (k < b)%nat -> motion_of motion_all k = moved k k.
  Proof.
    intros K. rewrite <- (three_entries _ (moved_length K)). unfold motion_of, motion_all.
    assert (forall i, (i < 3)%nat ->
      nth (3 * k + i) (flat_map (fun k => moved k k) (seq 0 b)) 0 = nth i (moved k k) 0) as At.
    { intros i I. rewrite <- (@flat_nth (fun k => moved k k) b 0 k i); trivial.
      - now rewrite Nat.sub_0_r.
      - intros m M. apply moved_length. lia.
      - lia. }
    rewrite <- !At by lia. now rewrite Nat.add_0_r.
  Qed.

  Lemma all_length : length motion_all = (3 * b)%nat.
  Proof.
    unfold motion_all. assert (forall n a, (a + n <= b)%nat ->
      length (flat_map (fun k => moved k k) (seq a n)) = (3 * n)%nat) as L.
    { induction n as [|n IH]; intros a H; cbn [seq flat_map]; [reflexivity|].
      rewrite app_length, moved_length, IH by lia. lia. }
    apply L. lia.
  Qed.

  (** Relative to what it hangs on a body moves by its own motion. *)
  Lemma relative i w : (i < b)%nat ->
    dot w (less (motion_at motion_all (Some i)) (motion_at motion_all (parent i))) = dot w (u i).
  Proof.
    destruct Forest as [P _]. intros K. unfold less. cbn [motion_at].
    rewrite motion_of_all, dot_comm, dot_add, dot_times, moved_step by trivial.
    destruct (parent i) as [p|] eqn:E; cbn [motion_at].
    - pose proof (P _ _ E). rewrite motion_of_all by lia. rewrite dot_add, (dot_comm w). ring.
    - rewrite (dot_comm w). destruct w as [|? [|? [|? ?]]]; cbn; ring.
  Qed.

  Definition forces_all : list force := spread child js f.

  Lemma laws_all : Forall2 (law motion_all) (map (fun j => joint_row (real_joint j)) js) forces_all.
  Proof.
    destruct Forest as (P & J & _).
    assert (Forall2 (fun j => law motion_all (joint_row (real_joint j))) js forces_all) as H.
    { apply (spread_holds child (fun i j => law motion_all (joint_row (real_joint j)))).
      intros x I. destruct (J _ I) as [C _]. set (i := child x) in *.
      destruct (Each C) as (_ & Law & _). cbn [real_question one_body rows_of] in Law.
      rewrite map_map, map_map in Law.
      rewrite (map_ext _ (inward_row (branch i))) in Law
        by (intros; unfold inward_row; now rewrite planar_row_real).
      rewrite crossing_all in Law.
      assert (forall j, In j (on_edge child i js) -> crosses (branch i) j = true /\
        pair_of (branch i) j = (Some i, parent i)) as Edge.
      { intros j Ij. split; [|now apply ends_of]. unfold on_edge in Ij. apply filter_In in Ij.
        rewrite crossing by tauto. tauto. }
      revert Edge Law. generalize (on_edge child i js) (f i). clear I.
      induction l as [|j l IH]; intros forces Edge Law; inversion Law; subst; constructor.
      - destruct (Edge j (or_introl eq_refl)) as [X Y].
        destruct (@inward_dot (branch i) j motion_all X) as [N T]. rewrite Y in N, T.
        cbn [fst snd] in N, T. rewrite relative in N, T by trivial.
        destruct y as [[c_n c_1] c_2]. unfold law in *. rewrite N, T.
        replace (values_of (joint_row (real_joint j))) with (values_of (inward_row (branch i) j));
          [assumption|].
        unfold inward_row, joint_row, inward. now destruct (inside (branch i) (Some (body_a j))).
      - apply IH; trivial. intros; apply Edge; now right. }
    clear - H. induction H; cbn; constructor; trivial.
  Qed.

  Lemma edge_length i : (i < b)%nat -> length (f i) = length (on_edge child i js).
  Proof.
    intros K. destruct (Each K) as (_ & Law & _). cbn [real_question one_body rows_of] in Law.
    rewrite crossing_all, !map_map in Law. revert Law. generalize (on_edge child i js) (f i).
    induction l as [|j l IH]; intros forces H; inversion H; cbn; auto.
  Qed.

  Lemma on_bodies_length j : In j js -> forall x y z,
    (length (on_bodies (real_joint j) [x; y; z]) <= 3 * b)%nat.
  Proof.
    destruct Forest as (P & J & _). intros I x y z. destruct (J _ I) as [C Ends].
    assert (forall i, (i < b)%nat -> (length (at_body i [x; y; z]) <= 3 * b)%nat) as At.
    { intros i K. unfold at_body. rewrite app_length, repeat_length. cbn [length]. lia. }
    unfold on_bodies. cbn [body_a body_b real_joint].
    destruct Ends as [[A B]|[B A]]; rewrite B.
    - rewrite A. destruct (parent (child j)) as [p|] eqn:E; [|now apply At]. pose proof (P _ _ E).
      apply add_length; [now apply At | unfold times; rewrite map_length; apply At; lia].
    - pose proof (P _ _ A). apply add_length; [apply At; lia|].
      unfold times. rewrite map_length. now apply At.
  Qed.

  Lemma total_length_all : forall l forces, incl l js ->
    (length (total (map (fun j => joint_row (real_joint j)) l) forces) <= 3 * b)%nat.
  Proof.
    induction l as [|j l IH]; intros [|[[c_n c_1] c_2] forces] I; cbn [map total length]; try lia.
    assert (In j js) as J by (apply I; now left).
    repeat apply add_length; unfold times; rewrite ?map_length;
      try (apply on_bodies_length; trivial); [cbn; lia|].
    apply IH. intros x X. apply I. now right.
  Qed.

  Lemma balance_all : Forall (fun x => x = 0)
    (add (total (map (fun j => joint_row (real_joint j)) js) forces_all) (reals load)).
  Proof.
    destruct Forest as (P & J & Load). set (v := add _ _).
    assert (length v <= 3 * b)%nat as L.
    { unfold v. apply add_length; [apply total_length_all, incl_refl|].
      unfold reals. now rewrite map_length. }
    apply (@zero_blocks b); trivial.
    enough (forall n k, (k < b)%nat -> (b - k <= n)%nat -> forall x y z,
      dot (skipn (3 * k) v) [x; y; z] = 0) as Down by (intros; apply (Down b); trivial; lia).
    induction n as [|n IH]; intros k K N x y z; [lia|].
    assert (dot v (together (branch k) [x; y; z]) = 0) as B.
    { unfold v. rewrite dot_add, (part_total (branch k) js forces_all) by apply spread_length.
      unfold together. rewrite load_together.
      destruct (Each K) as (_ & _ & B). cbn [real_question one_body rows_of load_of] in B.
      apply (dot_vanishing [x; y; z]) in B. rewrite dot_add in B. rewrite !map_map in B.
      rewrite (map_ext _ (inward_row (branch k))) in B
        by (intros; unfold inward_row; now rewrite planar_row_real).
      assert (map snd (filter (fun p => crosses (branch k) (fst p)) (combine js forces_all)) = f k)
        as ->; [|exact B].
      etransitivity; [|apply (@spread_edge _ child k js f); now apply edge_length].
      f_equal. apply filter_ext_in. intros [j g] I. apply in_combine_l in I. now apply crossing. }
    rewrite dot_blocks in B. rewrite (@fold_seq_one _ k) in B.
    - rewrite <- B. pose proof (in_branch k K) as I. cbn [inside] in I. rewrite I, hangs_step.
      now rewrite Nat.eqb_refl.
    - unfold branch. rewrite map_length, seq_length. lia.
    - unfold branch at 1. rewrite map_length, seq_length. intros m M D.
      pose proof (@in_branch k m ltac:(lia)) as I. cbn [inside] in I. rewrite I.
      destruct (hangs m m k) eqn:G; trivial. apply hangs_least in G. apply IH; lia.
  Qed.
  End Parts.

  Lemma forest_equilibria :
    (exists d forces, balances (real_question (OfBodies b js load)) d forces) <->
    forall i, (i < b)%nat -> exists d forces, balances (real_question (one_body i)) d forces.
  Proof.
    assert (forall i d forces, balances (real_question (one_body i)) d forces <->
      equilibrium 3 (map real_row (map (fun j => qplanar_row (inward (branch i) j))
        (filter (crosses (branch i)) js))) (reals (load_on (branch i) load)) d forces) as One.
    { intros i d forces. unfold balances, one_body. cbn [real_question dimension rows_of load_of].
      rewrite !map_map. rewrite (map_ext _ (fun x => real_row (qplanar_row (inward (branch i) x))))
        by (intros; now rewrite planar_row_real). reflexivity. }
    assert (forall d forces, balances (real_question (OfBodies b js load)) d forces <->
      equilibrium (3 * b) (map real_row (map qjoint_row js)) (reals load) d forces) as Whole.
    { intros d forces. unfold balances. cbn [real_question dimension rows_of load_of].
      rewrite !map_map. rewrite (map_ext _ (fun x => real_row (qjoint_row x)))
        by (intros; now rewrite joint_row_real). reflexivity. }
    split.
    - intros (d & forces & E) i K. apply Whole in E.
      destruct (@part_equilibrium (branch i) js _ load d forces (one_place K) E) as (d' & g & E').
      exists d', g. now apply One.
    - intros H.
      destruct (@chosen (list R * list force) ([], [])
        (fun i x => balances (real_question (one_body i)) (fst x) (snd x)) b) as [c C].
      { intros i K. destruct (H i K) as (d & g & E). now exists (d, g). }
      exists (motion_all (fun i => fst (c i))), (forces_all (fun i => snd (c i))). apply Whole.
      split; [|split].
      + now apply all_length with (f := fun i => snd (c i)).
      + rewrite map_map, (map_ext _ (fun j => joint_row (real_joint j)) joint_row_real).
        now apply laws_all.
      + rewrite map_map, (map_ext _ (fun j => joint_row (real_joint j)) joint_row_real).
        now apply balance_all with (u := fun i => fst (c i)).
  Qed.
End Forest.

(** A forest holds its loads exactly where each body does, with all that hangs on it. *)
Theorem forest_by_bodies : forall count parent joints load, is_forest count parent joints load ->
  (exists d forces, balances (real_question (OfBodies count joints load)) d forces) <->
  forall i, (i < count)%nat ->
    exists d forces, balances (real_question (one_body count parent joints load i)) d forces.
Proof. exact forest_equilibria. Qed.
