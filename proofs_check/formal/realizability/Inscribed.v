(** The linear conditions of Rivin for a graph to be that of a polyhedron inscribed in a sphere, and
    multipliers that contradict them. That they are the conditions is Rivin's theorem. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Rationals.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The statement *)

(** Vertices are counted from 0. *)
Definition edge := (Z * Z)%type.
Record graph := Graph { order : Z; edges : list edge }.

Definition vertex (g : graph) (v : Z) : Prop := (0 <= v < order g)%Z.

Fixpoint sum (l : list edge) (f : edge -> R) : R :=
  match l with [] => 0 | e :: l => f e + sum l f end.

Definition chosen (b : bool) (x : R) : R := if b then x else 0.

Definition at_vertex (v : Z) (e : edge) : bool := ((fst e =? v) || (snd e =? v))%Z.
Definition across (side : Z -> bool) (e : edge) : bool := xorb (side (fst e)) (side (snd e)).

(** From every part of a side an edge leads to the rest of it. *)
Definition connected (g : graph) (side : Z -> bool) : Prop :=
  forall part : Z -> bool,
  (exists u, vertex g u /\ side u = true /\ part u = true) ->
  (exists u, vertex g u /\ side u = true /\ part u = false) ->
  exists e, In e (edges g) /\ side (fst e) = true /\ side (snd e) = true /\ across part e = true.

Definition two_vertices (g : graph) (side : Z -> bool) : Prop :=
  exists u v, u <> v /\ vertex g u /\ vertex g v /\ side u = true /\ side v = true.

(** Weights of edges inside (0, 1/2), 1 at each vertex, more than 1 across each minimal cutset that
    is not the set of edges at a vertex. *)
Definition rivin (g : graph) (w : edge -> R) : Prop :=
  (forall e, In e (edges g) -> 0 < w e < 1 / 2) /\
  (forall v, vertex g v -> sum (edges g) (fun e => chosen (at_vertex v e) (w e)) = 1) /\
  (forall side, let other := fun v => negb (side v) in
     connected g side -> connected g other -> two_vertices g side -> two_vertices g other ->
     1 < sum (edges g) (fun e => chosen (across side e) (w e))).

(** * The checker *)

(** An edge with the multipliers of 0 < w and w < 1/2. *)
Record bounded_edge := Bounded { ends : edge; lower : Q; upper : Q }.

(** Both sides of a cutset, each vertex after the first beside an earlier one; the multiplier. *)
Record cutset := Cutset { one_side : list Z; other_side : list Z; factor : Q }.

Definition member (l : list Z) (v : Z) : bool := existsb (Z.eqb v) l.

Fixpoint lookup (u i : Z) (y : list Q) : Q :=
  match y with [] => 0%Q | q :: y => if (u =? i)%Z then q else lookup u (i + 1) y end.

Definition adjacent (l : list edge) (u v : Z) : bool :=
  existsb (fun e => ((fst e =? u) && (snd e =? v) || (fst e =? v) && (snd e =? u))%Z) l.

Fixpoint grown (l : list edge) (seen rest : list Z) : bool :=
  match rest with
  | [] => true
  | v :: rest => existsb (adjacent l v) seen && grown l (v :: seen) rest
  end.

Definition in_order (n v : Z) : bool := ((0 <=? v) && (v <? n))%Z.

Definition side_holds (n : Z) (l : list edge) (side : list Z) : bool :=
  match side with
  | u :: v :: rest => negb (u =? v)%Z && forallb (in_order n) side && grown l [u] (v :: rest)
  | _ => false
  end.

(** Whether each vertex from [i] on is on one side. *)
Fixpoint divided (i : Z) (count : nat) (a b : list Z) : bool :=
  match count with
  | O => true
  | S count => xorb (member a i) (member b i) && divided (i + 1) count a b
  end.

Definition cutset_holds (n : nat) (l : list edge) (c : cutset) : bool :=
  side_holds (Z.of_nat n) l (one_side c) && side_holds (Z.of_nat n) l (other_side c) &&
  divided 0 n (one_side c) (other_side c) && qnonneg (factor c).

Fixpoint factors (cuts : list cutset) (e : edge) : Q :=
  match cuts with
  | [] => 0%Q
  | c :: cuts =>
      if across (member (one_side c)) e then qplus (factor c) (factors cuts e) else factors cuts e
  end.

Definition edge_holds (n : Z) (y : list Q) (cuts : list cutset) (e : bounded_edge) : bool :=
  let (u, v) := ends e in
  in_order n u && in_order n v && negb (u =? v)%Z && qnonneg (lower e) && qnonneg (upper e) &&
  qzero (qplus (qplus (lookup u 0 y) (lookup v 0 y))
    (qplus (qminus (lower e) (upper e)) (factors cuts (ends e)))).

Definition total_of (l : list Q) : Q := fold_right qplus 0%Q l.

(** [y] has one multiplier for each vertex. *)
Definition contradicts (y : list Q) (l : list bounded_edge) (cuts : list cutset) : bool :=
  let n := length y in
  let constant := qminus (qtimes (1 # 2) (total_of (map upper l)))
    (qplus (total_of y) (total_of (map factor cuts))) in
  forallb (edge_holds (Z.of_nat n) y cuts) l &&
  forallb (cutset_holds n (map ends l)) cuts &&
  (qpositive (Qopp constant) ||
   qzero constant &&
   (existsb (fun e => qpositive (lower e) || qpositive (upper e)) l ||
    existsb (fun c => qpositive (factor c)) cuts)).

(** * It is right *)

Lemma sum_plus l f h : sum l (fun e => f e + h e) = sum l f + sum l h.
Proof. induction l; cbn; [lra | rewrite IHl; lra]. Qed.

Lemma sum_times l t f : sum l (fun e => t * f e) = t * sum l f.
Proof. induction l; cbn; [lra | rewrite IHl; lra]. Qed.

Lemma sum_same l f h : (forall e, In e l -> f e = h e) -> sum l f = sum l h.
Proof.
  induction l as [|e l IH]; cbn; intros H; [easy|].
  rewrite (H e), IH; auto.
Qed.

(** The multipliers of vertices, from number [i] on. *)
Fixpoint vertex_sum (i : Z) (y : list Q) (f : Z -> R) : R :=
  match y with [] => 0 | q :: y => Q2R q * f i + vertex_sum (i + 1) y f end.

Lemma lookup_before u : forall y i, (u < i)%Z -> Q2R (lookup u i y) = 0.
Proof.
  induction y as [|q y IH]; intros i L; cbn; [apply zero_real|].
  destruct (Z.eqb_spec u i); [lia|]. apply IH. lia.
Qed.

Lemma vertex_sum_edge u v x : u <> v -> forall y i,
  vertex_sum i y (fun k => chosen (at_vertex k (u, v)) x) =
  x * (Q2R (lookup u i y) + Q2R (lookup v i y)).
Proof.
  intros N. induction y as [|q y IH]; intros i; cbn [vertex_sum lookup];
    [rewrite zero_real; lra|].
  rewrite IH. unfold at_vertex. cbn [fst snd].
  destruct (Z.eqb_spec u i), (Z.eqb_spec v i); cbn [orb chosen]; try lia; try lra.
  - subst. rewrite (@lookup_before i) by lia. lra.
  - subst. rewrite (@lookup_before i y (i + 1)) by lia. lra.
Qed.

Lemma vertex_sum_plus y f h : forall i,
  vertex_sum i y (fun k => f k + h k) = vertex_sum i y f + vertex_sum i y h.
Proof. induction y as [|q y IH]; intros i; cbn; [lra | rewrite IH; lra]. Qed.

Lemma vertex_sum_zero y : forall i, vertex_sum i y (fun _ => 0) = 0.
Proof. induction y as [|q y IH]; intros i; cbn; [lra | rewrite IH; lra]. Qed.

Lemma vertex_sum_edges w y l : (forall e, In e l -> fst e <> snd e) ->
  vertex_sum 0 y (fun k => sum l (fun e => chosen (at_vertex k e) (w e))) =
  sum l (fun e => w e * (Q2R (lookup (fst e) 0 y) + Q2R (lookup (snd e) 0 y))).
Proof.
  induction l as [|[u v] l IH]; intros H; cbn [sum]; [apply vertex_sum_zero|].
  rewrite vertex_sum_plus, IH, vertex_sum_edge; trivial.
  - apply (H (u, v)). now left.
  - intros e I. apply H. now right.
Qed.

Lemma vertex_sum_one f : forall y i,
  (forall v, (i <= v < i + Z.of_nat (length y))%Z -> f v = 1) ->
  vertex_sum i y f = Q2R (total_of y).
Proof.
  induction y as [|q y IH]; intros i H; cbn [vertex_sum total_of fold_right];
    [now rewrite zero_real|].
  rewrite (H i) by (cbn [length]; lia). fold (total_of y). rewrite qplus_real, <- (IH (i + 1)%Z).
  - lra.
  - intros v L. apply H. cbn [length]. lia.
Qed.

(** * Cutsets *)

Lemma member_in l v : member l v = true <-> In v l.
Proof.
  unfold member. rewrite existsb_exists. split.
  - intros (x & I & E). apply Z.eqb_eq in E. now subst.
  - intros I. exists v. split; trivial. apply Z.eqb_refl.
Qed.

Lemma adjacent_edge l u v : adjacent l u v = true ->
  exists e, In e l /\ (e = (u, v) \/ e = (v, u)).
Proof.
  unfold adjacent. rewrite existsb_exists. intros ([a b] & I & E). exists (a, b). split; trivial.
  cbn in E. rewrite orb_true_iff, !andb_true_iff, !Z.eqb_eq in E.
  destruct E as [[-> ->]|[-> ->]]; auto.
Qed.

Lemma grown_connected l (side part : Z -> bool) b : forall rest seen,
  grown l seen rest = true -> (forall v, In v (seen ++ rest) -> side v = true) ->
  (forall v, In v seen -> part v = b) -> (exists v, In v rest /\ part v = negb b) ->
  exists e, In e l /\ side (fst e) = true /\ side (snd e) = true /\ across part e = true.
Proof.
  induction rest as [|v rest IH]; intros seen G S P (u & I & U); [easy|].
  cbn [grown] in G. apply andb_true_iff in G. destruct G as [A G].
  destruct (Bool.eqb (part v) b) eqn:E.
  - apply eqb_prop in E. apply (IH (v :: seen)); trivial.
    + intros x X. apply S. apply in_app_iff. apply in_app_iff in X. cbn in *. tauto.
    + intros x [->|X]; auto.
    + destruct I as [->|I]; [exfalso; rewrite E in U; destruct b; easy | now exists u].
  - apply eqb_false_iff in E. apply existsb_exists in A. destruct A as (s & Is & A).
    apply adjacent_edge in A. destruct A as (e & Ie & Eq). exists e. split; trivial.
    assert (side v = true) by (apply S, in_app_iff; right; now left).
    assert (side s = true) by (apply S, in_app_iff; now left).
    pose proof (P s Is). unfold across.
    destruct Eq as [-> | ->]; cbn [fst snd]; repeat split; trivial;
      destruct (part v), (part s), b; cbn in *; congruence.
Qed.

Lemma side_connected g l (side : Z -> bool) :
  side_holds (order g) (edges g) l = true ->
  (forall v, In v l -> side v = true) -> (forall v, vertex g v -> side v = true -> In v l) ->
  connected g side /\ two_vertices g side.
Proof.
  intros H In1 In2. destruct l as [|u [|v rest]]; [easy | easy |].
  cbn [side_holds] in H. apply andb_true_iff in H. destruct H as [H G].
  apply andb_true_iff in H. destruct H as [N V].
  apply negb_true_iff, Z.eqb_neq in N. rewrite forallb_forall in V.
  assert (Vertex : forall x, In x (u :: v :: rest) -> vertex g x).
  { intros x I. specialize (V x I). unfold in_order in V.
    rewrite andb_true_iff, Z.leb_le, Z.ltb_lt in V. exact V. }
  split.
  - intros part (x & Vx & Sx & Px) (z & Vz & Sz & Pz).
    pose proof (In2 _ Vx Sx) as Ix. pose proof (In2 _ Vz Sz) as Iz.
    apply (@grown_connected (edges g) side part (part u) _ [u] G); trivial.
    + intros s [->|[]]; trivial.
    + destruct (part u) eqn:U.
      * exists z. destruct Iz as [->|Iz]; [congruence | now split].
      * exists x. destruct Ix as [->|Ix]; [congruence | now split].
  - exists u, v. repeat split; trivial; try apply Vertex; try apply In1; cbn; auto.
Qed.

Lemma divided_right a b : forall count i, divided i count a b = true ->
  forall v, (i <= v < i + Z.of_nat count)%Z -> xorb (member a v) (member b v) = true.
Proof.
  induction count as [|count IH]; intros i D v L; [lia|].
  cbn [divided] in D. apply andb_true_iff in D. destruct D as [X D].
  destruct (Z.eq_dec v i) as [->|]; trivial. apply (IH _ D). lia.
Qed.

Lemma cutset_right n l w c : cutset_holds n l c = true ->
  rivin (Graph (Z.of_nat n) l) w ->
  1 < sum l (fun e => chosen (across (member (one_side c)) e) (w e)) /\ 0 <= Q2R (factor c).
Proof.
  unfold cutset_holds. rewrite !andb_true_iff, qnonneg_real.
  intros [[[A B] D] F] (_ & _ & Cut). split; trivial.
  pose proof (@divided_right _ _ _ _ D) as X.
  set (g := Graph (Z.of_nat n) l) in *.
  assert (Bv : forall v, In v (other_side c) -> vertex g v).
  { intros v I. destruct (other_side c) as [|u [|u' rest]]; [easy | easy|].
    cbn [side_holds] in B. rewrite !andb_true_iff, forallb_forall in B.
    destruct B as [[_ B] _]. specialize (B v I). unfold in_order in B.
    rewrite andb_true_iff, Z.leb_le, Z.ltb_lt in B. exact B. }
  destruct (@side_connected g (one_side c) (member (one_side c)) A) as [C1 T1].
  - intros v. apply member_in.
  - intros v _. apply member_in.
  - destruct (@side_connected g (other_side c) (fun v => negb (member (one_side c) v)) B)
      as [C2 T2].
    + intros v I. specialize (Bv v I). unfold vertex in Bv. cbn in Bv.
      specialize (X v). apply member_in in I. rewrite I in X.
      destruct (member (one_side c) v); trivial. apply X. lia.
    + intros v V N. apply member_in. specialize (X v). unfold vertex in V. cbn in V.
      destruct (member (one_side c) v); [easy|]. rewrite xorb_false_l in X. apply X. lia.
    + now apply Cut.
Qed.

Definition excess (w : edge -> R) (l : list edge) (c : cutset) : R :=
  sum l (fun e => chosen (across (member (one_side c)) e) (w e)) - 1.

Fixpoint cut_sum (w : edge -> R) (l : list edge) (cuts : list cutset) : R :=
  match cuts with [] => 0 | c :: cuts => Q2R (factor c) * excess w l c + cut_sum w l cuts end.

Lemma cut_sum_edges w l cuts :
  cut_sum w l cuts =
  sum l (fun e => w e * Q2R (factors cuts e)) - Q2R (total_of (map factor cuts)).
Proof.
  induction cuts as [|c cuts IH]; cbn [cut_sum map total_of fold_right].
  - rewrite zero_real. rewrite (sum_same l _ (fun e => 0 * w e)); [rewrite sum_times; lra|].
    intros e _. cbn. rewrite zero_real. ring.
  - rewrite IH, qplus_real. fold (total_of (map factor cuts)). unfold excess.
    rewrite (sum_same l (fun e => w e * Q2R (factors (c :: cuts) e))
      (fun e => Q2R (factor c) * chosen (across (member (one_side c)) e) (w e)
        + w e * Q2R (factors cuts e))).
    + rewrite sum_plus, sum_times. lra.
    + intros e _. cbn [factors].
      destruct (across (member (one_side c)) e); cbn [chosen]; rewrite ?qplus_real; ring.
Qed.

(** What the bounds of the edges give. *)
Fixpoint bound_sum (w : edge -> R) (l : list bounded_edge) : R :=
  match l with
  | [] => 0
  | e :: l => Q2R (lower e) * w (ends e) + Q2R (upper e) * (1 / 2 - w (ends e)) + bound_sum w l
  end.

Lemma half_real : Q2R (1 # 2) = 1 / 2.
Proof. unfold Q2R. cbn. field. Qed.

Lemma edge_parts n y cuts e : edge_holds n y cuts e = true ->
  fst (ends e) <> snd (ends e) /\ 0 <= Q2R (lower e) /\ 0 <= Q2R (upper e) /\
  Q2R (lookup (fst (ends e)) 0 y) + Q2R (lookup (snd (ends e)) 0 y) +
    (Q2R (lower e) - Q2R (upper e) + Q2R (factors cuts (ends e))) = 0.
Proof.
  unfold edge_holds. destruct (ends e) as [u v]. cbn [fst snd].
  rewrite !andb_true_iff, negb_true_iff, Z.eqb_neq, !qnonneg_real, qzero_real.
  rewrite !qplus_real, qminus_real. tauto.
Qed.

Lemma all_sum w n y cuts l : forallb (edge_holds n y cuts) l = true ->
  sum (map ends l) (fun e => w e * (Q2R (lookup (fst e) 0 y) + Q2R (lookup (snd e) 0 y)))
  + bound_sum w l + sum (map ends l) (fun e => w e * Q2R (factors cuts e)) =
  1 / 2 * Q2R (total_of (map upper l)).
Proof.
  induction l as [|e l IH]; cbn [forallb map sum bound_sum total_of fold_right].
  - rewrite zero_real. lra.
  - rewrite andb_true_iff. intros [E A]. specialize (IH A). apply edge_parts in E.
    destruct E as (_ & _ & _ & E). fold (total_of (map upper l)). rewrite qplus_real.
    assert (w (ends e) * (Q2R (lookup (fst (ends e)) 0 y) + Q2R (lookup (snd (ends e)) 0 y) +
      (Q2R (lower e) - Q2R (upper e) + Q2R (factors cuts (ends e)))) = 0) by (rewrite E; ring).
    lra.
Qed.

Lemma bounds_right w n y cuts l : forallb (edge_holds n y cuts) l = true ->
  (forall e, In e (map ends l) -> 0 < w e < 1 / 2) ->
  0 <= bound_sum w l /\
  (existsb (fun e => qpositive (lower e) || qpositive (upper e)) l = true -> 0 < bound_sum w l).
Proof.
  induction l as [|e l IH]; cbn [forallb map bound_sum existsb].
  - intros _ _. split; [lra | discriminate].
  - rewrite andb_true_iff. intros [E A] W. apply edge_parts in E.
    destruct E as (_ & L & U & _). destruct (W (ends e)) as [W1 W2]; [now left|].
    destruct (IH A) as [P Q]; [intros; apply W; now right|].
    pose proof (Rmult_le_pos _ _ L (Rlt_le _ _ W1)).
    assert (0 <= 1 / 2 - w (ends e)) as W3 by lra. pose proof (Rmult_le_pos _ _ U W3).
    split; [lra|]. rewrite !orb_true_iff, !qpositive_real. intros [[X|X]|X].
    + pose proof (Rmult_lt_0_compat _ _ X W1). lra.
    + assert (0 < 1 / 2 - w (ends e)) as W4 by lra. pose proof (Rmult_lt_0_compat _ _ X W4). lra.
    + specialize (Q X). lra.
Qed.

Lemma cuts_right n w l cuts : forallb (cutset_holds n l) cuts = true ->
  rivin (Graph (Z.of_nat n) l) w ->
  0 <= cut_sum w l cuts /\
  (existsb (fun c => qpositive (factor c)) cuts = true -> 0 < cut_sum w l cuts).
Proof.
  induction cuts as [|c cuts IH]; cbn [forallb cut_sum existsb].
  - intros _ _. split; [lra | discriminate].
  - rewrite andb_true_iff. intros [C A] W. destruct (IH A W) as [P Q].
    destruct (@cutset_right _ _ _ _ C W) as [X F]. fold (excess w l c) in X.
    assert (0 < excess w l c) as X' by (unfold excess; lra).
    pose proof (Rmult_le_pos _ _ F (Rlt_le _ _ X')).
    split; [lra|]. rewrite orb_true_iff, qpositive_real. intros [Y|Y].
    + pose proof (Rmult_lt_0_compat _ _ Y X'). lra.
    + specialize (Q Y). lra.
Qed.

(** Multipliers that are accepted leave no weights that satisfy the conditions. *)
Theorem no_weights : forall y l cuts, contradicts y l cuts = true ->
  ~ exists w, rivin (Graph (Z.of_nat (length y)) (map ends l)) w.
Proof.
  intros y l cuts T [w W]. unfold contradicts in T.
  apply andb_true_iff in T. destruct T as [T C]. apply andb_true_iff in T. destruct T as [E K].
  destruct (@cuts_right _ _ _ _ K W) as [C1 C2].
  destruct W as (Bounds & Vertices & _). cbn [edges order] in *.
  destruct (@bounds_right w _ _ _ _ E Bounds) as [B1 B2].
  pose proof (@all_sum w _ _ _ _ E) as S.
  rewrite <- vertex_sum_edges in S.
  2: { intros e I. apply in_map_iff in I. destruct I as (x & <- & I).
       rewrite forallb_forall in E. specialize (E x I). apply edge_parts in E. tauto. }
  rewrite (@vertex_sum_one _ y 0%Z) in S.
  2: { intros v V. apply Vertices. exact V. }
  pose proof (cut_sum_edges w (map ends l) cuts) as S'.
  rewrite orb_true_iff, andb_true_iff, orb_true_iff, qpositive_real, qzero_real in C.
  rewrite Q2R_opp, qminus_real, qtimes_real, qplus_real, half_real in C.
  destruct C as [C|[C [X|X]]]; [lra | specialize (B2 X); lra | specialize (C2 X); lra].
Qed.
