(** A part of an assembly that touches the rest at one pair of bodies: its contacts with the rest
    and its whole load are a question about one body. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Rationals Checker Vectors.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Bodies in R^(3b) *)

(** The motion of one body. *)
Definition motion_of (d : list R) (i : nat) : list R :=
  [nth (3 * i) d 0; nth (3 * i + 1) d 0; nth (3 * i + 2) d 0].

Definition motion_at (d : list R) (b : option nat) : list R :=
  match b with None => [0; 0; 0] | Some i => motion_of d i end.

Lemma dot_at_body i w d : dot (at_body i w) d = dot w (skipn (3 * i) d).
Proof.
  unfold at_body. generalize (3 * i)%nat as m. intros m. revert d.
  induction m as [|m IH]; intros [|x d]; cbn [repeat app skipn dot]; trivial.
  - now rewrite dot_nil.
  - rewrite IH. ring.
Qed.

Lemma dot_three (x y z : R) d m : dot [x; y; z] (skipn m d) =
  x * nth m d 0 + y * nth (m + 1) d 0 + z * nth (m + 2) d 0.
Proof.
  revert d. induction m as [|m IH]; intros d.
  - destruct d as [|a [|b [|c d]]]; cbn; ring.
  - destruct d as [|a d]; cbn [skipn nth plus]; [cbn; ring | apply IH].
Qed.

(** What a wrench of three numbers on a body does under a motion of all. *)
Lemma on_body (x y z : R) i d : dot (at_body i [x; y; z]) d = dot [x; y; z] (motion_of d i).
Proof. rewrite dot_at_body, dot_three. unfold motion_of. cbn. ring. Qed.

Definition less (v w : list R) : list R := add v (times (-1) w).

Lemma dot_joint j (x y z : R) d : dot (on_bodies j [x; y; z]) d =
  dot [x; y; z] (motion_of d (body_a j)) - dot [x; y; z] (motion_at d (body_b j)).
Proof.
  unfold on_bodies. destruct (body_b j) as [b|]; cbn [motion_at].
  - rewrite dot_add, dot_times, !on_body. ring.
  - rewrite on_body. cbn. ring.
Qed.

(** * A part *)

Section Part.
  Variable part : list bool.

  (** The bodies of the part move by [u], the others do not. *)
  Definition together (u : list R) : list R :=
    flat_map (fun s : bool => if s then u else [0; 0; 0]) part.

  Definition member (b : option nat) : R := if inside part b then 1 else 0.

  Lemma nth_together x y z i k : (k < 3)%nat ->
    nth (3 * i + k) (together [x; y; z]) 0 = member (Some i) * nth k [x; y; z] 0.
  Proof.
    intros K. unfold together, member, inside. revert i.
    induction part as [|s rest IH]; intros i; cbn [flat_map].
    - rewrite nth_overflow by (cbn; lia). destruct i; cbn [nth]; ring.
    - destruct i as [|i].
      + rewrite Nat.mul_0_r. cbn [plus nth].
        rewrite app_nth1 by (destruct s; cbn; lia).
        destruct s, k as [|[|[|k]]]; cbn; try ring; lia.
      + rewrite app_nth2 by (destruct s; cbn [length]; lia).
        replace (3 * S i + k - length (if s then [x; y; z] else [0; 0; 0]%R))%nat
          with (3 * i + k)%nat by (destruct s; cbn [length]; lia).
        apply IH.
  Qed.

  Lemma motion_together x y z i :
    motion_of (together [x; y; z]) i = times (member (Some i)) [x; y; z].
  Proof.
    unfold motion_of, times. cbn [map].
    replace (3 * i)%nat with (3 * i + 0)%nat at 1 by lia.
    now rewrite !nth_together by lia.
  Qed.

  Lemma joint_together j (a b c x y z : R) :
    dot (on_bodies j [a; b; c]) (together [x; y; z]) =
    (member (Some (body_a j)) - member (body_b j)) * dot [a; b; c] [x; y; z].
  Proof.
    rewrite dot_joint, motion_together.
    destruct (body_b j) as [i|]; cbn [motion_at]; rewrite ?motion_together; cbn;
      unfold member; cbn [inside]; ring.
  Qed.
End Part.

Lemma load_together : forall part load x y z,
  dot (reals load) (flat_map (fun s : bool => if s then [x; y; z] else [0; 0; 0]) part) =
  dot (reals (load_on part load)) [x; y; z].
Proof.
  induction part as [|s part IH]; intros load x y z; cbn [flat_map load_on].
  - now rewrite dot_nil.
  - specialize (IH (skipn 3 load) x y z).
    assert (dot (reals load) ((if s then [x; y; z] else [0; 0; 0]) ++
        flat_map (fun s : bool => if s then [x; y; z] else [0; 0; 0]) part) =
      (if s then dot (reals [nth 0 load 0; nth 1 load 0; nth 2 load 0]%Q) [x; y; z] else 0) +
      dot (reals (skipn 3 load))
        (flat_map (fun s : bool => if s then [x; y; z] else [0; 0; 0]) part)) as E.
    { destruct load as [|a [|b [|c load]]], s; cbn; rewrite ?zero_real; unfold reals; cbn; ring. }
    rewrite E, IH. destruct s; [|ring]. rewrite qadd_real, dot_add. ring.
Qed.

(** * The one body *)

Definition inward_row (part : list bool) (j : joint Q) : row R :=
  real_row (qplanar_row (inward part j)).

(** Where a contact joins the part with the rest, its row is the one of the one body, on the motion
    of the body inside relative to the one outside. *)
Lemma inward_dot part j d : crosses part j = true ->
  let moved := less (motion_at d (fst (pair_of part j))) (motion_at d (snd (pair_of part j))) in
  dot (normal (joint_row (real_joint j))) d = dot (normal (inward_row part j)) moved /\
  dot (tangent1 (joint_row (real_joint j))) d = dot (tangent1 (inward_row part j)) moved.
Proof.
  intros C. unfold inward_row, joint_row. rewrite planar_row_real.
  cbn [normal tangent1 planar_row]. unfold wrench. rewrite !dot_joint.
  cbn [body_a body_b real_joint touch]. unfold less, pair_of, inward, crosses in *.
  destruct (inside part (Some (body_a j))) eqn:A; cbn [fst snd motion_at].
  - rewrite !(dot_comm _ (add _ _)), !dot_add, !dot_times, !(dot_comm _ [_; _; _]).
    split; ring.
  - unfold real_contact. cbn [point_x point_y normal_x normal_y values2].
    rewrite !(dot_comm _ (add _ _)), !dot_add, !dot_times, !(dot_comm _ [_; _; _]), !Q2R_opp.
    generalize (motion_of d (body_a j)) (motion_at d (body_b j)). intros v w.
    split; destruct v as [|? [|? [|? ?]]], w as [|? [|? [|? ?]]]; cbn; ring.
Qed.

Lemma inward_law part j d force : crosses part j = true ->
  law d (joint_row (real_joint j)) force ->
  law (less (motion_at d (fst (pair_of part j))) (motion_at d (snd (pair_of part j))))
    (inward_row part j) force.
Proof.
  intros C. destruct (inward_dot part j d C) as [N T]. destruct force as [[c_n c_1] c_2].
  unfold law. rewrite <- N, <- T.
  replace (values_of (inward_row part j)) with (values_of (joint_row (real_joint j))); [trivial|].
  unfold inward_row, joint_row, inward. now destruct (inside part (Some (body_a j))).
Qed.

Lemma inward_together part j x y z c_n c_1 c_2 :
  dot (add (times c_n (normal (joint_row (real_joint j))))
    (add (times c_1 (tangent1 (joint_row (real_joint j)))) (times c_2 [])))
    (together part [x; y; z]) =
  if crosses part j then
    dot (add (times c_n (normal (inward_row part j)))
      (add (times c_1 (tangent1 (inward_row part j))) (times c_2 []))) [x; y; z]
  else 0.
Proof.
  unfold inward_row. rewrite planar_row_real. unfold joint_row. cbn [normal tangent1 planar_row].
  rewrite !dot_add, !dot_times. unfold wrench. rewrite !joint_together.
  cbn [body_a body_b real_joint touch]. unfold crosses, inward, member.
  destruct (inside part (Some (body_a j))), (inside part (body_b j)); cbn [xorb];
    unfold real_contact; cbn [point_x point_y normal_x normal_y values2]; rewrite ?Q2R_opp; cbn; ring.
Qed.

Lemma part_total part : forall js forces, length forces = length js -> forall x y z,
  dot (total (map (fun j => joint_row (real_joint j)) js) forces) (together part [x; y; z]) =
  dot (total (map (inward_row part) (filter (crosses part) js))
    (map snd (filter (fun p => crosses part (fst p)) (combine js forces)))) [x; y; z].
Proof.
  induction js as [|j js IH]; intros [|[[c_n c_1] c_2] forces] L x y z; try easy.
  cbn [map total filter combine fst]. rewrite dot_add, IH by (now injection L).
  change (tangent2 (joint_row (real_joint j))) with (@nil R). rewrite inward_together.
  destruct (crosses part j); cbn [map total snd]; [|ring]. rewrite !dot_add. reflexivity.
Qed.

Lemma same_end_right a b : same_end a b = true -> a = b.
Proof. destruct a, b; try easy. cbn. now rewrite Nat.eqb_eq; intros ->. Qed.

Lemma part_laws part d moved : forall js forces,
  Forall2 (law d) (map (fun j => joint_row (real_joint j)) js) forces ->
  (forall j, In j (filter (crosses part) js) ->
    moved = less (motion_at d (fst (pair_of part j))) (motion_at d (snd (pair_of part j)))) ->
  Forall2 (law moved) (map (inward_row part) (filter (crosses part) js))
    (map snd (filter (fun p => crosses part (fst p)) (combine js forces))).
Proof.
  induction js as [|j js IH]; intros forces H M; inversion H as [|? f ? forces' Here There]; subst;
    [constructor|]. cbn [filter combine fst] in *.
  destruct (crosses part j) eqn:C; cbn [map snd].
  - constructor; [|apply IH; trivial; intros; apply M; now right].
    rewrite (M j (or_introl eq_refl)). now apply inward_law.
  - now apply IH.
Qed.

Lemma three_zero v : (length v <= 3)%nat -> (forall x y z, dot v [x; y; z] = 0) ->
  Forall (fun x => x = 0) v.
Proof.
  intros L H. pose proof (H 1 0 0) as X. pose proof (H 0 1 0) as Y. pose proof (H 0 0 1) as Z.
  destruct v as [|a [|b [|c [|e v]]]]; cbn in *; repeat constructor; try lra; lia.
Qed.

Lemma add_length v w n : (length v <= n)%nat -> (length w <= n)%nat -> (length (add v w) <= n)%nat.
Proof.
  revert w n. induction v as [|x v IH]; intros [|y w] n V W; cbn in *; try lia.
  destruct n; [lia|]. apply le_n_S, IH; lia.
Qed.

Lemma planar_total_length part : forall js forces,
  (length (total (map (inward_row part) js) forces) <= 3)%nat.
Proof.
  induction js as [|j js IH]; intros [|[[c_n c_1] c_2] forces]; cbn [map total length]; try lia.
  repeat apply add_length; unfold times; rewrite ?map_length; cbn; try lia. apply IH.
Qed.

Lemma load_length : forall part load, (length (reals (load_on part load)) <= 3)%nat.
Proof.
  unfold reals. induction part as [|s part IH]; intros load; rewrite map_length; cbn [load_on length];
    [lia|]. specialize (IH (skipn 3 load)). rewrite map_length in IH. destruct s; trivial.
  assert (forall v w, (length v <= 3)%nat -> (length w <= 3)%nat -> (length (qadd v w) <= 3)%nat) as A.
  { intros v w V W. pose proof (qadd_real v w) as E. apply (f_equal (@length R)) in E.
    unfold reals in E. rewrite map_length in E. rewrite E. apply add_length; now rewrite map_length. }
  apply A; [cbn; lia | exact IH].
Qed.

(** An equilibrium of the assembly is one of the one body. *)
Lemma part_equilibrium part js n load d forces :
  at_one_place part (filter (crosses part) js) = true ->
  equilibrium n (map real_row (map qjoint_row js)) (reals load) d forces ->
  exists d' forces', equilibrium 3
    (map real_row (map (fun j => qplanar_row (inward part j)) (filter (crosses part) js)))
    (reals (load_on part load)) d' forces'.
Proof.
  intros Place (_ & Law & Balance).
  rewrite map_map, (map_ext _ (fun j => joint_row (real_joint j)) joint_row_real) in Law, Balance.
  rewrite map_map. change (fun x => real_row (qplanar_row (inward part x))) with (inward_row part).
  assert (length forces = length js) as L.
  { clear - Law. revert forces Law. induction js; intros forces H; inversion H; cbn; auto. }
  set (between := filter (crosses part) js) in *.
  assert (exists moved, length moved = 3%nat /\ forall j, In j between ->
    moved = less (motion_at d (fst (pair_of part j))) (motion_at d (snd (pair_of part j))))
    as (moved & Three & M).
  { assert (forall a b, length (less (motion_at d a) (motion_at d b)) = 3%nat) as Size
      by (intros [a|] [b|]; reflexivity).
    destruct between as [|first rest].
    - exists [0; 0; 0]. split; [reflexivity | easy].
    - exists (less (motion_at d (fst (pair_of part first))) (motion_at d (snd (pair_of part first)))).
      split; [apply Size|]. intros j I. cbn [at_one_place] in Place. rewrite forallb_forall in Place.
      specialize (Place j I). apply andb_true_iff in Place. destruct Place as [E F].
      apply same_end_right in E, F. now rewrite E, F. }
  exists moved, (map snd (filter (fun p => crosses part (fst p)) (combine js forces))).
  split; [exact Three|]. split; [now apply part_laws with d|].
  apply three_zero.
  - apply add_length; [apply planar_total_length | apply load_length].
  - intros x y z. pose proof (dot_vanishing (together part [x; y; z]) Balance) as B.
    rewrite dot_add, (part_total part js forces L) in B. rewrite dot_add, <- B. f_equal.
    unfold together. symmetry. apply load_together.
Qed.
