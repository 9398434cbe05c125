(** What the checker accepts is true. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Rationals Checker Arcs Vectors Regions Leaves Parts.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * States *)

Lemma state_of_in (P : row R -> state -> Prop) cs states :
  Forall2 P (map real_row cs) states -> forall i s, state_of i states = Some s ->
  exists c, P (real_row c) s /\
    (has_one_tangent i (map body_of cs) = true -> tangent2 c = []) /\
    forall s', P (real_row c) s' -> Forall2 P (map real_row cs) (set_state i s' states).
Proof.
  revert states. induction cs as [|c cs IH]; intros states H i s0 E; inversion H; subst;
    cbn [state_of set_state map has_one_tangent] in *; [easy|].
  destruct (i =? 0)%Z.
  - injection E as ->. exists c. repeat split; trivial.
    + unfold one_tangent. cbn. now destruct (tangent2 c).
    + intros. now constructor.
  - edestruct IH as (c' & Hc & One & Set'); [eassumption | eassumption |]. exists c'.
    repeat split; trivial. intros s' P'. constructor; auto.
Qed.

(** * Trees *)

Definition tree_induction (P : tree -> Prop)
  (leaf : forall l multipliers, P (Leaf l multipliers))
  (edge : forall j k p q first second, P first -> P second -> P (Edge j k p q first second))
  (attachment : forall i detached attached, P detached -> P attached ->
    P (Attachment i detached attached))
  (slip : forall i stick plus minus, P stick -> P plus -> P minus -> P (Slip i stick plus minus))
  (directions : forall i stick sectors, P stick -> Forall (fun x => P (snd x)) sectors ->
    P (Directions i stick sectors))
  (cut : forall i middle first second, P first -> P second -> P (Cut i middle first second)) :
  forall t, P t :=
  fix all t :=
    match t with
    | Leaf l multipliers => leaf l multipliers
    | Edge j k p q first second => edge j k p q _ _ (all first) (all second)
    | Attachment i detached attached => attachment i _ _ (all detached) (all attached)
    | Slip i stick plus minus => slip i _ _ _ (all stick) (all plus) (all minus)
    | Directions i stick sectors => directions i stick sectors (all stick)
        ((fix each (l : list (direction * tree)) : Forall (fun x => P (snd x)) l :=
            match l with
            | [] => Forall_nil _
            | x :: l => Forall_cons x (all (snd x)) (each l)
            end) sectors)
    | Cut i middle first second => cut i middle _ _ (all first) (all second)
    end.

(** Each sector with its two ends. *)
Fixpoint fan (first : direction) (sectors : list (direction * tree)) :
    list (direction * direction * tree) :=
  match sectors with
  | [] => []
  | (u, t) :: rest =>
      (u, match rest with [] => first | (v, _) :: _ => v end, t) :: fan first rest
  end.

Lemma fan_arcs first sectors :
  map (fun x => (real_pair (fst (fst x)), real_pair (snd (fst x)))) (fan first sectors) =
  arcs (real_pair first) (map (fun x => real_pair (fst x)) sectors).
Proof.
  induction sectors as [|[u t] rest IH]; [easy|]. cbn. rewrite IH. f_equal.
  now destruct rest as [|[v t'] rest].
Qed.

Lemma fan_tree first sectors u v t : In (u, v, t) (fan first sectors) -> In (u, t) sectors.
Proof.
  induction sectors as [|[u' t'] rest IH]; [easy|]. cbn. intros [E|E]; [left; congruence | auto].
Qed.

Section Trees.
  Variables (cs : list (row Q)) (load : list Q) (d : list R) (forces : list (R * R * R)).
  Hypothesis Mu : Forall (fun c => 0 <= Q2R (friction (values_of c))) cs.
  Hypothesis Law : Forall2 (law d) (map real_row cs) forces.
  Let bodies := map body_of cs.

  Lemma directions_test gens i stick first t rest states :
    refutes bodies load gens states (Directions i stick ((first, t) :: rest)) = true ->
    state_of i states = Some Attached /\
    refutes bodies load gens (set_state i Stick states) stick = true /\
    Forall (fun x => let '(u, v, t) := x in
      qpositive (qturn u v) = true /\
      refutes bodies load gens (set_state i (Sector u v) states) t = true)
      (fan first ((first, t) :: rest)).
  Proof.
    cbn [refutes]. destruct (state_of i states) as [[]|]; try easy.
    rewrite !andb_true_iff. intros [S [[A B] C]]. repeat split; trivial.
    cbn [fan]. constructor; [destruct rest as [|[v ?] ?]; now split|].
    clear A B. induction rest as [|[u t'] rest IH]; [constructor|].
    rewrite !andb_true_iff in C. destruct C as [[A B] C]. cbn [fan].
    constructor; [|now apply IH]. destruct rest as [|[v ?] ?]; now split.
  Qed.

  Lemma refutes_right t : forall gens states,
    refutes bodies load gens states t = true -> spans gens (1 :: d) ->
    Forall2 (in_state d) (map real_row cs) states ->
    ~ Forall (fun x => x = 0) (add (total (map real_row cs) forces) (reals load)).
  Proof.
    induction t as [l multipliers | j k p q first second H1 H2 | i detached attached H1 H2
      | i stick plus minus H1 H2 H3 | i stick sectors H1 H2 | i middle first second H1 H2]
      using tree_induction; intros gens states Test Here States.
    - exact (@leaf_right cs load gens d forces states l multipliers Here Mu Test States Law).
    - cbn [refutes] in Test. destruct (nth_error gens j) as [g|] eqn:G; [|easy].
      destruct (nth_error gens k) as [h|] eqn:H; [|easy].
      rewrite !andb_true_iff in Test. destruct Test as ((((N & P) & Q) & T1) & T2).
      assert (j <> k) as J by (intros ->; now rewrite Nat.eqb_refl in N).
      destruct (@edge_covers gens (1 :: d) j k p q g h G H J P Q Here) as [S|S];
        [exact (H1 _ _ T1 S States) | exact (H2 _ _ T2 S States)].
    - cbn [refutes] in Test. destruct (state_of i states) as [[]|] eqn:E; try easy.
      apply andb_true_iff in Test. destruct Test as [T1 T2].
      destruct (state_of_in cs States _ E) as (c & _ & _ & Now).
      destruct (Rle_lt_dec (spring_at (real_row c) d) 0) as [S|S].
      + apply (H1 _ _ T1 Here). now apply Now.
      + apply (H2 _ _ T2 Here). apply Now. cbn. lra.
    - cbn [refutes] in Test. destruct (state_of i states) as [[]|] eqn:E; try easy.
      rewrite !andb_true_iff in Test. destruct Test as (((One & T1) & T2) & T3).
      destruct (state_of_in cs States _ E) as (c & Touch & Single & Now). cbn in Touch.
      specialize (Single One).
      assert (snd (slip_at (real_row c) d) = 0) as Z by (cbn; now rewrite Single).
      destruct (Rtotal_order (fst (slip_at (real_row c) d)) 0) as [L | [L | L]].
      + apply (H3 _ _ T3 Here). apply Now. cbn [in_state]. tauto.
      + apply (H1 _ _ T1 Here). apply Now. split; trivial.
        unfold plane_zero. rewrite <- L, <- Z at 1. now destruct (slip_at (real_row c) d).
      + apply (H2 _ _ T2 Here). apply Now. cbn [in_state]. tauto.
    - destruct sectors as [|[first t] rest].
      { cbn in Test. destruct (state_of i states) as [[]|]; easy. }
      destruct (directions_test _ _ _ _ _ _ _ Test) as (E & T1 & T2).
      destruct (state_of_in cs States _ E) as (c & Touch & _ & Now). cbn in Touch.
      set (s := slip_at (real_row c) d) in *.
      assert (s = plane_zero \/ moves s) as [Still|M].
      { unfold plane_zero, moves. destruct s as [x y]. cbn.
        destruct (Req_dec x 0) as [->|]; [|tauto]. destruct (Req_dec y 0) as [->|]; tauto. }
      + apply (H1 _ _ T1 Here). now apply Now.
      + destruct (@round_covers s (real_pair first) M
          (map (fun x => real_pair (fst x)) rest)) as (u & v & I & UV & B).
        { change (real_pair first :: map (fun x => real_pair (fst x)) rest)
            with (map (fun x : direction * tree => real_pair (fst x)) ((first, t) :: rest)).
          rewrite <- fan_arcs, Forall_map. revert T2. apply Forall_impl. intros [[u v] t'] [P _].
          cbn. rewrite <- qturn_real. now apply qpositive_real. }
        change (real_pair first :: map (fun x => real_pair (fst x)) rest)
          with (map (fun x : direction * tree => real_pair (fst x)) ((first, t) :: rest)) in I.
        rewrite <- fan_arcs in I. apply in_map_iff in I. destruct I as ([[u' v'] t'] & Eq & I).
        cbn in Eq. injection Eq as <- <-.
        rewrite Forall_forall in T2, H2. destruct (T2 _ I) as [_ T3].
        apply (H2 _ (fan_tree _ _ _ _ _ I) _ _ T3 Here). apply Now. cbn [in_state]. tauto.
    - cbn [refutes] in Test. destruct (state_of i states) as [[| | | | | |u v]|] eqn:E; try easy.
      rewrite !andb_true_iff, !qpositive_real, !qturn_real in Test.
      destruct Test as [[[UM MV] T1] T2].
      destruct (state_of_in cs States _ E) as (c & (Touch & M & UV & B) & _ & Now).
      set (s := slip_at (real_row c) d) in *.
      destruct (turns_between UV B) as [US SV].
      destruct (Rle_lt_dec 0 (turn2 s (real_pair middle))) as [L|L].
      + apply (H1 _ _ T1 Here). apply Now. repeat split; trivial. now apply between_turns.
      + apply (H2 _ _ T2 Here). apply Now. repeat split; trivial. apply between_turns; trivial.
        fold s. unfold turn2 in *. lra.
  Qed.
End Trees.

Lemma refuted_right n cs load t :
  refuted n cs load t = true ->
  forall d forces, ~ equilibrium n (map real_row cs) (reals load) d forces.
Proof.
  intros Test d forces (Length & Law & Balance).
  unfold refuted in Test. apply andb_true_iff in Test. destruct Test as [Mu Test].
  assert (Forall (fun c => 0 <= Q2R (friction (values_of c))) cs) as Friction.
  { rewrite forallb_forall in Mu. apply Forall_forall. intros c I. apply qnonneg_real.
    apply (Mu (body_of c)). now apply in_map. }
  refine (@refutes_right cs load d forces Friction Law t _ _ Test _ _ Balance).
  - rewrite <- Length. apply half_space_all.
  - rewrite map_map. clear. induction cs; cbn; constructor; trivial. exact I.
Qed.

(** * Equilibria *)

Lemma turn_parallel (f s : pair_R) : moves s -> turn2 f s = 0 -> dot2 f s <= 0 ->
  exists t, 0 <= t /\ fst f = - t * fst s /\ snd f = - t * snd s.
Proof.
  intros M T D. pose proof (dot2_pos s M) as P. exists (- dot2 f s / dot2 s s).
  assert (fst f * dot2 s s = dot2 f s * fst s + turn2 f s * snd s) as A
    by (unfold dot2, turn2; ring).
  assert (snd f * dot2 s s = dot2 f s * snd s - turn2 f s * fst s) as B
    by (unfold dot2, turn2; ring).
  rewrite T in A, B. repeat split.
  - apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
  - apply Rmult_eq_reg_r with (dot2 s s); [|lra]. rewrite A. field. lra.
  - apply Rmult_eq_reg_r with (dot2 s s); [|lra]. rewrite B. field. lra.
Qed.

Lemma obeys_law c d force :
  obeys c d force = true <->
  law (reals d) (real_row c) (let '(n, a, b) := force in (Q2R n, Q2R a, Q2R b)).
Proof.
  destruct force as [[c_n c_1] c_2]. unfold obeys, law.
  rewrite !andb_true_iff, orb_true_iff, !andb_true_iff, !qzero_real, !qleb_real, !qeqb_real.
  cbn [fst snd]. rewrite qnonneg_real, !qturn_real, !qdot2_real, !qdot_real, zero_real.
  set (e := qminus _ _).
  assert (Q2R e = spring_at (real_row c) (reals d)) as E.
  { unfold e, spring_at. real. now rewrite qdot_real. }
  fold (spring_at (real_row c) (reals d)). rewrite <- E.
  replace (Q2R (if qnonneg e then e else 0%Q)) with (Rmax 0 (Q2R e)).
  2: { destruct (qnonneg e) eqn:P.
       - apply Rmax_right. now apply qnonneg_real.
       - rewrite zero_real. apply Rmax_left. apply Rlt_le, Rnot_le_lt. intros L.
         apply qnonneg_real in L. congruence. }
  real. unfold real_pair. cbn [fst snd]. rewrite !qdot_real.
  cbn [real_row tangent1 tangent2 values_of real_values friction].
  set (s := (dot (reals (tangent1 c)) (reals d), dot (reals (tangent2 c)) (reals d))).
  set (f := (Q2R c_1, Q2R c_2)).
  change (dot (reals (tangent1 c)) (reals d)) with (fst s).
  change (dot (reals (tangent2 c)) (reals d)) with (snd s).
  change (Q2R c_1 * Q2R c_1 + Q2R c_2 * Q2R c_2) with (dot2 f f).
  change (Q2R c_1) with (fst f). change (Q2R c_2) with (snd f).
  split.
  - intros [[[A L] B] C]. repeat split; trivial.
    + destruct C as [[C1 C2]|[[_ _] C]]; [tauto | trivial].
    + destruct C as [[C1 C2]|[[C D] _]]; [tauto|]. now apply turn_parallel.
  - intros (A & L & B & C). repeat split; trivial.
    destruct (Req_dec (fst s) 0) as [Z1|Z1], (Req_dec (snd s) 0) as [Z2|Z2]; [tauto| | |];
    right; (destruct C as (C & t & T & F1 & F2); [tauto|]); repeat split; trivial;
    unfold turn2, dot2; rewrite F1, F2; try ring;
    pose proof (Rmult_le_pos _ _ T (Rle_0_sqr (fst s)));
    pose proof (Rmult_le_pos _ _ T (Rle_0_sqr (snd s))); unfold Rsqr in *; lra.
Qed.

Lemma all_obey_law d : forall cs forces,
  all_obey cs d forces = true <->
  Forall2 (law (reals d)) (map real_row cs) (real_forces forces).
Proof.
  induction cs as [|c cs IH]; intros [|f forces]; cbn [all_obey map real_forces].
  1: split; [constructor | trivial].
  1, 2: split; [discriminate | intros H; inversion H].
  rewrite andb_true_iff, obeys_law, IH.
  split; [intros []; now constructor | intros H; inversion H; now split].
Qed.

Lemma sum_of_real : forall cs forces,
  reals (sum_of cs forces) = total (map real_row cs) (real_forces forces).
Proof.
  induction cs as [|c cs IH]; intros [|[[n a] b] forces]; cbn [sum_of map real_forces total];
    trivial.
  rewrite !qadd_real, !qscaled_real. f_equal. apply IH.
Qed.

Lemma confirmed_right n cs load d forces :
  confirmed n cs load d forces = true <->
  equilibrium n (map real_row cs) (reals load) (reals d) (real_forces forces).
Proof.
  unfold confirmed, equilibrium.
  rewrite !andb_true_iff, qvanishes_real, qadd_real, sum_of_real, all_obey_law, Nat.eqb_eq.
  unfold reals at 3. rewrite map_length. tauto.
Qed.

(** * The theorems *)

(** An accepted proof of "not resisted" leaves no equilibrium, whatever motion and forces: of a
    grasp in the plane or in space, or of an assembly, one law in R^n. *)
Theorem not_resisted : forall question proof,
  (forall d forces, proof <> Resisted d forces) -> check question proof = true ->
  forall d forces, ~ balances (real_question question) d forces.
Proof.
  intros g [d' forces'|t|part t] No Test d forces; [now destruct (No d' forces')| |];
    unfold balances; rewrite <- rows_real, <- load_real, <- dimension_real.
  - now apply refuted_right with t.
  - destruct g as [| |count js load]; try easy. cbn [check] in Test.
    apply andb_true_iff in Test. destruct Test as [Place Test]. intros E.
    destruct (@part_equilibrium part js (3 * count) load d forces Place E) as (d' & forces' & E').
    exact (@refuted_right _ _ _ _ Test d' forces' E').
Qed.

(** A proof of "resisted" is accepted exactly when its motion and forces are an equilibrium. *)
Theorem resisted : forall question motion forces,
  check question (Resisted motion forces) = true <->
  balances (real_question question) (reals motion) (real_forces forces).
Proof.
  intros g d forces. unfold balances. rewrite <- rows_real, <- load_real, <- dimension_real.
  cbn [check]. apply confirmed_right.
Qed.
