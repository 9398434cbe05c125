(** Weights that satisfy the linear conditions of inscribability: flows show that no cutset weighs
    too little. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz FinFun FunctionalExtensionality.
Require Import Rationals Inscribed.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * The checker *)

(** An edge, its weight. *)
Definition weighted := (edge * Q)%type.

Definition same_edge (e f : edge) : bool := ((fst e =? fst f) && (snd e =? snd f))%Z.

Fixpoint weight (l : list weighted) (e : edge) : Q :=
  match l with [] => 0%Q | (f, w) :: l => if same_edge f e then w else weight l e end.

Fixpoint sum_at (l : list edge) (w : edge -> Q) (v : Z) : Q :=
  match l with
  | [] => 0%Q
  | e :: l => if at_vertex v e then qplus (w e) (sum_at l w v) else sum_at l w v
  end.

(** What flows out of a vertex, less what flows in. *)
Fixpoint net (l : list edge) (flow : list Q) (v : Z) : Q :=
  match l, flow with
  | e :: l, q :: flow =>
      if (fst e =? v)%Z then qplus q (net l flow v)
      else if (snd e =? v)%Z then qminus (net l flow v) q
      else net l flow v
  | _, _ => 0%Q
  end.

Fixpoint within (l : list edge) (w : edge -> Q) (flow : list Q) : bool :=
  match l, flow with
  | e :: l, q :: flow => qleb q (w e) && qleb (Qopp q) (w e) && within l w flow
  | [], [] => true
  | _, _ => false
  end.

Definition vertices (n : nat) : list Z := map Z.of_nat (seq 0 n).

Definition other_end (v : Z) (e : edge) : Z := if (fst e =? v)%Z then snd e else fst e.

(** A flow of more than 1 from the ends of the first edge to those of the second. *)
Definition flow_holds (n : nat) (l : list edge) (w : edge -> Q) (pair : edge * edge)
    (flow : list Q) : bool :=
  let (e, f) := pair in
  within l w flow &&
  forallb (fun v => at_vertex v e || at_vertex v f || qzero (net l flow v)) (vertices n) &&
  qpositive (qminus (qplus (net l flow (fst e)) (net l flow (snd e))) 1).

(** The edges at the root with those that share no vertex with them. *)
Definition apart (pair : edge * edge) : bool :=
  let (e, f) := pair in negb (at_vertex (fst e) f) && negb (at_vertex (snd e) f).
Definition pairs (root : Z) (l : list edge) : list (edge * edge) :=
  filter apart (list_prod (filter (at_vertex root) l) l).

Fixpoint all_flows (n : nat) (l : list edge) (w : edge -> Q) (ps : list (edge * edge))
    (flows : list (list Q)) : bool :=
  match ps, flows with
  | [], _ => true
  | p :: ps, flow :: flows => flow_holds n l w p flow && all_flows n l w ps flows
  | _ :: _, [] => false
  end.

Definition satisfies (n : nat) (l : list weighted) (root : Z) (flows : list (list Q)) : bool :=
  let edges := map fst l in
  let w := weight l in
  in_order (Z.of_nat n) root &&
  forallb (fun e => in_order (Z.of_nat n) (fst e) && in_order (Z.of_nat n) (snd e) &&
    negb (fst e =? snd e)%Z && qpositive (w e) && qpositive (qminus (1 # 2) (w e))) edges &&
  forallb (fun v => qzero (qminus (sum_at edges w v) 1)) (vertices n) &&
  all_flows n edges w (pairs root edges) flows.

(** * It is right *)

Fixpoint over (l : list Z) (f : Z -> R) : R :=
  match l with [] => 0 | v :: l => f v + over l f end.

Lemma over_plus l f h : over l (fun v => f v + h v) = over l f + over l h.
Proof. induction l; cbn; lra. Qed.

Lemma over_same l f h : (forall v, In v l -> f v = h v) -> over l f = over l h.
Proof. induction l as [|v l IH]; cbn; intros H; [easy|]. rewrite (H v), IH; auto. Qed.

Lemma over_zero l : over l (fun _ => 0) = 0.
Proof. induction l; cbn; lra. Qed.

Lemma over_one u x l : NoDup l -> over l (fun v => if (u =? v)%Z then x else 0) =
  if member l u then x else 0.
Proof.
  induction 1 as [|v l N D IH]; cbn; trivial. rewrite IH. unfold member.
  destruct (Z.eqb_spec u v); cbn; [|lra].
  subst. destruct (existsb (Z.eqb v) l) eqn:E; [|lra].
  apply member_in in E. easy.
Qed.

Lemma one_real : Q2R 1 = 1.
Proof. unfold Q2R. cbn. field. Qed.

Lemma in_vertices n v : In v (vertices n) <-> (0 <= v < Z.of_nat n)%Z.
Proof.
  unfold vertices. rewrite in_map_iff. split.
  - intros (k & <- & I). apply in_seq in I. lia.
  - intros L. exists (Z.to_nat v). split; [lia|]. apply in_seq. lia.
Qed.

Lemma vertices_once n : NoDup (vertices n).
Proof.
  apply Injective_map_NoDup; [|apply seq_NoDup]. intros a b. lia.
Qed.

Definition indicator (side : Z -> bool) (v : Z) : R := if side v then 1 else 0.

Lemma net_over n side l : forall flow,
  (forall e, In e l -> In (fst e) (vertices n) /\ In (snd e) (vertices n) /\ fst e <> snd e) ->
  forall w, within l w flow = true ->
  over (vertices n) (fun v => indicator side v * Q2R (net l flow v)) <=
  sum l (fun e => chosen (across side e) (Q2R (w e))).
Proof.
  induction l as [|e l IH]; intros flow V w W.
  - cbn. destruct flow; cbn.
    + rewrite (over_same _ _ (fun _ => 0)); [rewrite over_zero; lra|].
      intros v _. rewrite zero_real. ring.
    + rewrite (over_same _ _ (fun _ => 0)); [rewrite over_zero; lra|].
      intros v _. rewrite zero_real. ring.
  - destruct flow as [|q flow]; [easy|]. cbn [within] in W. rewrite !andb_true_iff in W.
    destruct W as [[W1 W2] W]. rewrite qleb_real in W1, W2. rewrite Q2R_opp in W2.
    destruct (V e) as (A & B & N); [now left|].
    assert (IH' := IH flow (fun f I => V f (or_intror I)) w W). clear IH. cbn [sum].
    rewrite (over_same _ _ (fun v =>
      (if (fst e =? v)%Z then indicator side (fst e) * Q2R q else 0) +
      ((if (snd e =? v)%Z then indicator side (snd e) * - Q2R q else 0) +
      indicator side v * Q2R (net l flow v)))).
    + rewrite !over_plus, !over_one by apply vertices_once.
      apply member_in in A, B. rewrite A, B. unfold across, indicator in *.
      destruct (side (fst e)), (side (snd e)); cbn [xorb chosen]; lra.
    + intros v _. cbn [net].
      destruct (Z.eqb_spec (fst e) v) as [E1|E1], (Z.eqb_spec (snd e) v) as [E2|E2];
        try congruence; rewrite ?qplus_real, ?qminus_real, ?E1, ?E2; lra.
Qed.

Section Accepted.
  Variables (n : nat) (l : list weighted) (root : Z) (flows : list (list Q)).
  Hypothesis Test : satisfies n l root flows = true.
  Let g := Graph (Z.of_nat n) (map fst l).
  Let w := fun e => Q2R (weight l e).

  Lemma edges_right : forall e, In e (edges g) ->
    In (fst e) (vertices n) /\ In (snd e) (vertices n) /\ fst e <> snd e /\ 0 < w e < 1 / 2.
  Proof.
    intros e I. unfold satisfies in Test. rewrite !andb_true_iff in Test.
    destruct Test as [[[_ E] _] _]. rewrite forallb_forall in E. specialize (E e I).
    unfold in_order in E.
    rewrite !andb_true_iff, !Z.leb_le, !Z.ltb_lt, negb_true_iff, Z.eqb_neq, !qpositive_real,
      qminus_real, half_real in E.
    rewrite !in_vertices. unfold w. repeat split; try tauto; lra.
  Qed.

  Lemma sum_at_real edges v :
    Q2R (sum_at edges (weight l) v) = sum edges (fun e => chosen (at_vertex v e) (w e)).
  Proof.
    induction edges as [|e edges IH]; cbn; [apply zero_real|].
    destruct (at_vertex v e); cbn [chosen]; rewrite ?qplus_real, IH; unfold w; lra.
  Qed.

  Lemma flow_of p : In p (pairs root (map fst l)) ->
    exists flow, flow_holds n (map fst l) (weight l) p flow = true.
  Proof.
    pose proof Test as F. unfold satisfies in F. rewrite !andb_true_iff in F. destruct F as [_ F].
    revert F. clear Test. generalize flows. induction (pairs root (map fst l)) as [|p' ps IH]; [easy|].
    intros [|flow fs]; cbn [all_flows]; [easy|]. rewrite andb_true_iff. intros [A B].
    intros [->|I]; [now exists flow | now apply (IH fs)].
  Qed.

  Lemma at_ends v e : at_vertex v e = true <-> fst e = v \/ snd e = v.
  Proof. unfold at_vertex. now rewrite orb_true_iff, !Z.eqb_eq. Qed.

  Lemma heavy side : side root = true -> connected g side -> two_vertices g side ->
    connected g (fun v => negb (side v)) -> two_vertices g (fun v => negb (side v)) ->
    1 < sum (edges g) (fun e => chosen (across side e) (w e)).
  Proof.
    intros Root C T C' T'.
    assert (vertex g root) as Vr.
    { unfold satisfies in Test. rewrite !andb_true_iff in Test.
      destruct Test as [[[R _] _] _]. unfold in_order in R.
      rewrite andb_true_iff, Z.leb_le, Z.ltb_lt in R. exact R. }
    (* An edge from the root inside the side. *)
    destruct (C (Z.eqb root)) as (e & Ie & S1 & S2 & X).
    { exists root. repeat split; trivial; try apply Vr. apply Z.eqb_refl. }
    { destruct T as (u & v & N & Vu & Vv & Su & Sv).
      destruct (Z.eqb_spec root u); [exists v | exists u]; repeat split; trivial;
        try apply Vu; try apply Vv; apply Z.eqb_neq; congruence. }
    (* An edge inside the other side. *)
    destruct T' as (u & v & N & Vu & Vv & Su & Sv).
    destruct (C' (Z.eqb u)) as (f & If & F1 & F2 & _).
    { exists u. repeat split; trivial; try apply Vu. apply Z.eqb_refl. }
    { exists v. repeat split; trivial; try apply Vv. now apply Z.eqb_neq. }
    apply negb_true_iff in F1, F2.
    destruct (@flow_of (e, f)) as [flow F].
    { unfold pairs. apply filter_In. split.
      - apply in_prod; trivial. apply filter_In. split; trivial.
        apply at_ends. unfold across in X.
        destruct (Z.eqb_spec root (fst e)), (Z.eqb_spec root (snd e)); auto; easy.
      - unfold apart. rewrite andb_true_iff, !negb_true_iff. unfold at_vertex.
        rewrite !orb_false_iff, !Z.eqb_neq. repeat split; congruence. }
    unfold flow_holds in F. rewrite !andb_true_iff, forallb_forall, qpositive_real in F.
    rewrite qminus_real, qplus_real, one_real in F. destruct F as [[W K] P].
    apply Rlt_le_trans with (over (vertices n)
      (fun v => indicator side v * Q2R (net (map fst l) flow v))).
    - destruct (edges_right e Ie) as (A & B & Ne & _).
      rewrite (over_same _ _ (fun v =>
        (if (fst e =? v)%Z then Q2R (net (map fst l) flow (fst e)) else 0) +
        (if (snd e =? v)%Z then Q2R (net (map fst l) flow (snd e)) else 0))).
      + rewrite over_plus, !over_one by apply vertices_once.
        apply member_in in A, B. rewrite A, B. lra.
      + intros x Ix. specialize (K x Ix). rewrite !orb_true_iff, qzero_real, !at_ends in K.
        unfold indicator.
        destruct (Z.eqb_spec (fst e) x) as [E1|E1], (Z.eqb_spec (snd e) x) as [E2|E2];
          try congruence.
        * rewrite <- E1, S1. ring.
        * rewrite <- E2, S2. ring.
        * destruct K as [[[K|K]|[K|K]]|K]; try congruence.
          -- rewrite <- K, F1. ring.
          -- rewrite <- K, F2. ring.
          -- rewrite K. ring.
    - apply net_over; trivial. intros x Ix. destruct (edges_right x Ix) as (A & B & D & _). auto.
  Qed.
End Accepted.

(** Weights that are accepted satisfy the conditions. *)
Theorem weights_hold : forall n l root flows, satisfies n l root flows = true ->
  rivin (Graph (Z.of_nat n) (map fst l)) (fun e => Q2R (weight l e)).
Proof.
  intros n l root flows Test. split; [|split].
  - intros e I. now apply (@edges_right _ _ _ _ Test e I).
  - intros v V. cbn [edges]. rewrite <- (@sum_at_real l).
    unfold satisfies in Test. rewrite !andb_true_iff in Test. destruct Test as [[_ A] _].
    rewrite forallb_forall in A. specialize (A v). rewrite in_vertices, qzero_real in A.
    specialize (A V). rewrite qminus_real, one_real in A. lra.
  - intros side other C C' T T'.
    destruct (side root) eqn:S; [now apply (@heavy _ _ _ _ Test)|].
    assert (Back : (fun v => negb (other v)) = side)
      by (apply functional_extensionality; intros v; apply negb_involutive).
    replace (fun e => chosen (across side e) (Q2R (weight l e)))
      with (fun e => chosen (across other e) (Q2R (weight l e))).
    + apply (@heavy _ _ _ _ Test); rewrite ?Back; trivial. unfold other. now rewrite S.
    + apply functional_extensionality. intros e. unfold across, other.
      now destruct (side (fst e)), (side (snd e)).
Qed.
