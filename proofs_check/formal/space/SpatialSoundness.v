(** What the checker for grasps in space accepts is true. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import SpatialModel SpatialChecker Arcs SpatialNumbers.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * States *)

Definition spring_of (c : contact3 R) (d : screw R) := preload3 c - stiffness3 c * work (N c) d.
Definition slip_of (c : contact3 R) (d : screw R) : pair_R := (work (T1 c) d, work (T2 c) d).
Definition moves (s : pair_R) := fst s <> 0 \/ snd s <> 0.

(** What a state says of a motion. *)
Definition in_state3 (d : screw R) (c : contact3 R) (s : state3) : Prop :=
  match s with
  | Undecided3 => True
  | Detached3 => spring_of c d <= 0
  | Attached3 => 0 <= spring_of c d
  | Stick3 => 0 <= spring_of c d /\ slip_of c d = plane_zero
  | Sector u v => 0 <= spring_of c d /\ moves (slip_of c d) /\
      0 < turn2 (real_pair u) (real_pair v) /\
      between (real_pair u) (real_pair v) (slip_of c d)
  end.

(** * One contact *)

Section Contact.
  Variables (d l : screw R) (c : contact3 R) (c_n c_1 c_2 : R).
  Hypothesis Mu : 0 <= friction3 c.
  Hypothesis Law : law3 d c (c_n, c_1, c_2).
  Let a := work (N c) l.
  Let b : pair_R := (work (T1 c) l, work (T2 c) l).
  Let f : pair_R := (c_1, c_2).

  Lemma normal_nonneg : 0 <= c_n.
  Proof. destruct Law as [-> _]. apply Rmax_l. Qed.

  Lemma normal_spring : spring_of c d <= c_n.
  Proof. destruct Law as [-> _]. apply Rmax_r. Qed.

  Lemma normal_attached : 0 <= spring_of c d -> c_n = spring_of c d.
  Proof. intros A. destruct Law as [-> _]. now apply Rmax_right. Qed.

  Lemma normal_detached : spring_of c d <= 0 -> c_n = 0.
  Proof. intros A. destruct Law as [-> _]. now apply Rmax_left. Qed.

  Lemma cone : dot2 f f <= friction3 c * c_n * (friction3 c * c_n).
  Proof. destruct Law as (_ & C & _). unfold dot2, f. cbn. lra. Qed.

  Lemma disc_work room : beyond_disc_real room (friction3 c) b -> - room * c_n <= dot2 f b.
  Proof. intros B. exact (@disc_bound _ _ _ _ f B normal_nonneg cone). Qed.

  Lemma sector_work u v room : 0 < turn2 u v -> moves (slip_of c d) -> between u v (slip_of c d) ->
    beyond_end_real room (friction3 c) b u -> beyond_end_real room (friction3 c) b v ->
    turn2 u b < 0 \/ turn2 b v < 0 -> - room * c_n <= dot2 f b.
  Proof.
    intros UV M S U V Out. destruct Law as (_ & _ & D).
    destruct (D M) as (Limit & t & T & F1 & F2).
    replace (dot2 f b) with (- t * dot2 (slip_of c d) b)
      by (unfold dot2, f; cbn in *; rewrite F1, F2; cbn; ring).
    apply (@sector_bound u v) with (mu := friction3 c); trivial; [apply normal_nonneg|].
    rewrite <- Limit, F1, F2. unfold dot2. cbn. ring.
  Qed.

  (** The work of the contact on the virtual motion is at least what the multipliers say. *)
  Lemma contact_work s mu_q a_q b_q alpha h :
    allowed s mu_q a_q b_q alpha h = true -> in_state3 d c s ->
    Q2R mu_q = friction3 c -> Q2R a_q = a -> real_pair b_q = b ->
    Q2R alpha * spring_of c d + dot2 (real_pair h) (slip_of c d) <= c_n * a + dot2 f b.
  Proof.
    intros A S MuQ AQ BQ. unfold allowed in A.
    pose proof normal_nonneg as Nn. pose proof normal_spring as Ns.
    assert (Zero : qzero (fst h) && qzero (snd h) = true ->
      dot2 (real_pair h) (slip_of c d) = 0).
    { rewrite andb_true_iff, !qzero_real. intros [H1 H2]. unfold dot2, real_pair. cbn.
      rewrite H1, H2. ring. }
    assert (Disc : beyond_disc (qminus a_q alpha) mu_q b_q = true ->
      Q2R alpha * c_n <= c_n * a + dot2 f b).
    { intros D. apply beyond_disc_right in D. rewrite qminus_real, MuQ, AQ, BQ in D.
      apply disc_work in D. lra. }
    destruct s as [ | | | | u v]; cbn [in_state3] in S.
    - apply andb_true_iff in A. destruct A as [A D]. apply andb_true_iff in A. destruct A as [A H].
      apply qnonneg_real in A. specialize (Zero H). specialize (Disc D). nra.
    - apply andb_true_iff in A. destruct A as [A H]. apply qnonneg_real in A. specialize (Zero H).
      pose proof (normal_detached S) as E. pose proof cone as C. rewrite E in C.
      assert (c_1 = 0 /\ c_2 = 0) as [E1 E2] by (unfold dot2, f in C; cbn in C; split; nra).
      replace (dot2 f b) with 0 by (unfold dot2, f; cbn; rewrite E1, E2; ring). rewrite E. nra.
    - apply andb_true_iff in A. destruct A as [H D]. specialize (Zero H). specialize (Disc D).
      rewrite (normal_attached S) in *. lra.
    - destruct S as [S Still]. specialize (Disc A). rewrite (normal_attached S) in *. rewrite Still.
      unfold dot2 at 1, plane_zero. cbn. lra.
    - destruct S as (S & M & UV & B).
      apply andb_true_iff in A. destruct A as [A D]. apply andb_true_iff in A. destruct A as [U V].
      rewrite qleb_real, qdot2_real, zero_real in U, V.
      pose proof (@between_dot _ _ _ _ B U V) as H.
      enough (Q2R alpha * c_n <= c_n * a + dot2 f b) by (rewrite (normal_attached S) in *; lra).
      destruct (qnonneg (qturn u b_q) && qnonneg (qturn b_q v)) eqn:In; [now apply Disc|].
      apply andb_false_iff in In.
      assert (turn2 (real_pair u) b < 0 \/ turn2 b (real_pair v) < 0) as Out.
      { rewrite <- BQ, <- !qturn_real. destruct In as [I|I]; [left|right]; apply Rnot_le_lt; intros L;
          apply qnonneg_real in L; congruence. }
      apply andb_true_iff in D. destruct D as [Du Dv]. apply beyond_end_right in Du, Dv.
      rewrite qminus_real, MuQ, AQ, BQ in Du, Dv.
      pose proof (@sector_work _ _ _ UV M B Du Dv Out). lra.
  Qed.
End Contact.

(** * Leaves *)

Lemma some_pair A B (a a' : A) (b b' : B) : Some (a, b) = Some (a', b') -> a = a' /\ b = b'.
Proof. intros E. now injection E. Qed.

Lemma least_work d l : forall cs i states forces multipliers number rest,
  Forall (fun c => 0 <= Q2R (friction3 c)) cs ->
  Forall2 (law3 d) (map real_contact3 cs) forces ->
  Forall2 (in_state3 d) (map real_contact3 cs) states ->
  least i (map body_of cs) states l multipliers = Some (number, rest) ->
  Q2R number + work (real_screw rest) d <=
    work (total3 (map real_contact3 cs) forces) (real_screw l).
Proof.
  induction cs as [|c cs IH]; intros i states forces multipliers number rest Mu Law States E;
    inversion Law as [|? force ? forces' Here There]; subst;
    inversion States as [|? s ? states' State States']; subst; cbn [least map] in E.
  - injection E as <- <-. cbn. rewrite qnothing_real, !work_nothing, zero_real. lra.
  - inversion_clear Mu as [|? ? Mu1 Mu2].
    destruct (given3 i multipliers) as [[alpha h_1] h_2].
    destruct (allowed _ _ _ _ _ _) eqn:A in E; [|easy].
    destruct (least (i + 1) (map body_of cs) states' l multipliers) as [[number' rest']|] eqn:L;
      [|easy].
    specialize (IH _ _ _ _ _ _ Mu2 There States' L).
    destruct force as [[c_n c_1] c_2].
    assert (W := @contact_work d (real_screw l) (real_contact3 c) c_n c_1 c_2 Mu1 Here _ _ _ _ _ _
      A State eq_refl).
    rewrite !qwork_real, n_real in W. specialize (W eq_refl).
    unfold real_pair at 1 in W. cbn [fst snd] in W. rewrite !qwork_real, t_real, u_real in W.
    specialize (W eq_refl). unfold dot2, slip_of, real_pair, spring_of in W. cbn [fst snd] in W.
    cbn [total3 map]. autorewrite with work.
    destruct (qzero alpha && qzero h_1 && qzero h_2) eqn:Z.
    + injection E as <- <-. rewrite !andb_true_iff, !qzero_real in Z.
      destruct Z as [[Z1 Z2] Z3]. rewrite Z1, Z2, Z3 in W. lra.
    + apply some_pair in E. destruct E as [<- <-]. rewrite !qsum_real, !qscaled_real, n_real, t_real, u_real.
      autorewrite with work real. cbn [k_of q_of body_of] in *.
      cbn [preload3 stiffness3 real_contact3] in W. lra.
Qed.

Lemma leaf3_right g d forces states l multipliers :
  Forall (fun c => 0 <= Q2R (friction3 c)) (contacts3 g) ->
  leaf3_holds (map body_of (contacts3 g)) (applied3 g) states l multipliers = true ->
  Forall2 (in_state3 d) (map real_contact3 (contacts3 g)) states ->
  ~ equilibrium3 (real_question3 g) d forces.
Proof.
  intros Mu Test States [Law Balance]. unfold leaf3_holds in Test.
  destruct (least _ _ _ _ _) as [[number rest]|] eqn:L; [|easy].
  apply andb_true_iff in Test. destruct Test as [V P].
  apply qvanishes_real in V. apply qpositive_real in P. rewrite qplus_real, qwork_real in P.
  pose proof (@least_work _ _ _ _ _ _ _ _ _ Mu Law States L) as W. rewrite V, work_nothing in W.
  assert (B := f_equal (fun w => work w (real_screw l)) Balance). cbn beta in B.
  rewrite work_plus, work_nothing in B. cbn [contacts3 applied3 real_question3] in *. lra.
Qed.

(** * Trees *)

Lemma state3_in (P : contact3 R -> state3 -> Prop) reals states :
  Forall2 P reals states -> forall i s, state3_of i states = Some s ->
  exists r, P r s /\ forall s', P r s' -> Forall2 P reals (set_state3 i s' states).
Proof.
  induction 1 as [|r s reals states Hr H IH]; intros i s0; cbn [state3_of set_state3]; [easy|].
  destruct (i =? 0)%Z.
  - intros [= ->]. exists r. split; trivial. now constructor.
  - intros E. destruct (IH _ _ E) as (r' & Hr' & Set'). exists r'. split; trivial.
    intros s' P'. constructor; auto.
Qed.

Definition tree3_induction (P : tree3 -> Prop)
  (leaf : forall l multipliers, P (Leaf3 l multipliers))
  (attachment : forall i detached attached, P detached -> P attached ->
    P (Attachment3 i detached attached))
  (directions : forall i stick sectors, P stick -> Forall (fun x => P (snd x)) sectors ->
    P (Directions i stick sectors))
  (cut : forall i middle first second, P first -> P second -> P (Cut i middle first second)) :
  forall t, P t :=
  fix all t :=
    match t with
    | Leaf3 l multipliers => leaf l multipliers
    | Attachment3 i detached attached => attachment i _ _ (all detached) (all attached)
    | Directions i stick sectors => directions i stick sectors (all stick)
        ((fix each (l : list (direction * tree3)) : Forall (fun x => P (snd x)) l :=
            match l with
            | [] => Forall_nil _
            | x :: l => Forall_cons x (all (snd x)) (each l)
            end) sectors)
    | Cut i middle first second => cut i middle _ _ (all first) (all second)
    end.

(** Each sector with its two ends. *)
Fixpoint fan (first : direction) (sectors : list (direction * tree3)) :
    list (direction * direction * tree3) :=
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
  Variables (g : question3 Q) (d : screw R) (forces : list (R * R * R)).
  Hypothesis Mu : Forall (fun c => 0 <= Q2R (friction3 c)) (contacts3 g).
  Let bodies := map body_of (contacts3 g).
  Let reals := map real_contact3 (contacts3 g).

  Lemma directions_test i stick first t rest states :
    refutes3 bodies (applied3 g) states (Directions i stick ((first, t) :: rest)) = true ->
    state3_of i states = Some Attached3 /\
    refutes3 bodies (applied3 g) (set_state3 i Stick3 states) stick = true /\
    Forall (fun x => let '(u, v, t) := x in
      qpositive (qturn u v) = true /\
      refutes3 bodies (applied3 g) (set_state3 i (Sector u v) states) t = true)
      (fan first ((first, t) :: rest)).
  Proof.
    cbn [refutes3]. destruct (state3_of i states) as [[]|]; try easy.
    rewrite !andb_true_iff. intros [S [[A B] C]]. repeat split; trivial.
    cbn [fan]. constructor; [destruct rest as [|[v ?] ?]; now split|].
    clear A B. induction rest as [|[u t'] rest IH]; [constructor|].
    rewrite !andb_true_iff in C. destruct C as [[A B] C]. cbn [fan].
    constructor; [|now apply IH]. destruct rest as [|[v ?] ?]; now split.
  Qed.

  Lemma refutes3_right t : forall states,
    refutes3 bodies (applied3 g) states t = true -> Forall2 (in_state3 d) reals states ->
    ~ equilibrium3 (real_question3 g) d forces.
  Proof.
    induction t as [l multipliers | i detached attached H1 H2 | i stick sectors H1 H2
      | i middle first second H1 H2] using tree3_induction; intros states Test States.
    - now apply (@leaf3_right _ _ _ _ _ _ Mu Test).
    - cbn [refutes3] in Test. destruct (state3_of i states) as [[]|] eqn:E; try easy.
      apply andb_true_iff in Test. destruct Test as [T1 T2].
      destruct (state3_in States _ E) as (c & _ & Now).
      destruct (Rle_lt_dec (spring_of c d) 0) as [S|S].
      + apply (H1 _ T1). now apply Now.
      + apply (H2 _ T2). apply Now. cbn. lra.
    - destruct sectors as [|[first t] rest].
      { cbn in Test. destruct (state3_of i states) as [[]|]; easy. }
      destruct (directions_test _ _ _ _ _ _ Test) as (E & T1 & T2).
      destruct (state3_in States _ E) as (c & Touch & Now). cbn in Touch.
      assert (slip_of c d = plane_zero \/ moves (slip_of c d)) as [Still|M].
      { unfold slip_of, plane_zero, moves. cbn.
        destruct (Req_dec (work (SpatialModel.T1 c) d) 0) as [->|]; [|tauto].
        destruct (Req_dec (work (SpatialModel.T2 c) d) 0) as [->|]; tauto. }
      + apply (H1 _ T1). now apply Now.
      + destruct (@round_covers (slip_of c d) (real_pair first) M
          (map (fun x => real_pair (fst x)) rest)) as (u & v & I & UV & B).
        { change (real_pair first :: map (fun x => real_pair (fst x)) rest)
            with (map (fun x : direction * tree3 => real_pair (fst x)) ((first, t) :: rest)).
          rewrite <- fan_arcs, Forall_map. revert T2. apply Forall_impl. intros [[u v] t'] [P _].
          cbn. rewrite <- qturn_real. now apply qpositive_real. }
        change (real_pair first :: map (fun x => real_pair (fst x)) rest)
          with (map (fun x : direction * tree3 => real_pair (fst x)) ((first, t) :: rest)) in I.
        rewrite <- fan_arcs in I. apply in_map_iff in I. destruct I as ([[u' v'] t'] & Eq & I).
        cbn in Eq. injection Eq as <- <-.
        rewrite Forall_forall in T2, H2. destruct (T2 _ I) as [_ T3].
        apply (H2 _ (fan_tree _ _ _ _ _ I) _ T3). apply Now. cbn. tauto.
    - cbn [refutes3] in Test. destruct (state3_of i states) as [[| | | |u v]|] eqn:E; try easy.
      rewrite !andb_true_iff, !qpositive_real, !qturn_real in Test.
      destruct Test as [[[UM MV] T1] T2].
      destruct (state3_in States _ E) as (c & (Touch & M & UV & B) & Now).
      destruct (turns_between UV B) as [US SV].
      destruct (Rle_lt_dec 0 (turn2 (slip_of c d) (real_pair middle))) as [L|L].
      + apply (H1 _ T1). apply Now. repeat split; trivial. now apply between_turns.
      + apply (H2 _ T2). apply Now. repeat split; trivial. apply between_turns; trivial.
        unfold turn2 in *. lra.
  Qed.
End Trees.

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

Lemma obeys3_law c d force :
  obeys3 (body_of c) d force = true <->
  law3 (real_screw d) (real_contact3 c)
    (let '(n, a, b) := force in (Q2R n, Q2R a, Q2R b)).
Proof.
  destruct force as [[c_n c_1] c_2]. unfold obeys3, law3.
  rewrite !andb_true_iff, orb_true_iff, !andb_true_iff, !qzero_real, !qleb_real, !qeqb_real.
  cbn [fst snd]. rewrite !qturn_real, !qdot2_real, !qwork_real, t_real, u_real, zero_real.
  set (e := qminus _ _).
  assert (Q2R e = spring_of (real_contact3 c) (real_screw d)) as E.
  { unfold e, spring_of. real. now rewrite qwork_real, n_real. }
  fold (spring_of (real_contact3 c) (real_screw d)). rewrite <- E.
  replace (Q2R (if qnonneg e then e else 0%Q)) with (Rmax 0 (Q2R e)).
  2: { destruct (qnonneg e) eqn:P.
       - apply Rmax_right. now apply qnonneg_real.
       - rewrite zero_real. apply Rmax_left. apply Rlt_le, Rnot_le_lt. intros L.
         apply qnonneg_real in L. congruence. }
  real. unfold real_pair. cbn [fst snd]. real. rewrite !qwork_real, t_real, u_real.
  change (mu_of (body_of c)) with (friction3 c).
  change (friction3 (real_contact3 c)) with (Q2R (friction3 c)).
  set (s := (work (T1 (real_contact3 c)) (real_screw d), work (T2 (real_contact3 c)) (real_screw d))).
  set (f := (Q2R c_1, Q2R c_2)).
  change (work (T1 (real_contact3 c)) (real_screw d)) with (fst s).
  change (work (T2 (real_contact3 c)) (real_screw d)) with (snd s).
  change (Q2R c_1 * Q2R c_1 + Q2R c_2 * Q2R c_2) with (dot2 f f).
  change (Q2R c_1) with (fst f). change (Q2R c_2) with (snd f).
  split.
  - intros [[A B] C]. repeat split; trivial.
    + destruct C as [[C1 C2]|[[_ _] C]]; [tauto | trivial].
    + destruct C as [[C1 C2]|[[C D] _]]; [tauto|]. now apply turn_parallel.
  - intros (A & B & C). repeat split; trivial.
    destruct (Req_dec (fst s) 0) as [Z1|Z1], (Req_dec (snd s) 0) as [Z2|Z2]; [tauto| | |];
    right; (destruct C as (C & t & T & F1 & F2); [tauto|]); repeat split; trivial;
    unfold turn2, dot2; rewrite F1, F2; try ring;
    pose proof (Rmult_le_pos _ _ T (Rle_0_sqr (fst s)));
    pose proof (Rmult_le_pos _ _ T (Rle_0_sqr (snd s))); unfold Rsqr in *; lra.
Qed.

Lemma all_obey3_law d : forall cs forces,
  all_obey3 (map body_of cs) d forces = true <->
  Forall2 (law3 (real_screw d)) (map real_contact3 cs) (real_forces3 forces).
Proof.
  induction cs as [|c cs IH]; intros [|f forces]; cbn [all_obey3 map real_forces3].
  1: split; [constructor | trivial].
  1, 2: split; [discriminate | intros H; inversion H].
  rewrite andb_true_iff, obeys3_law, IH.
  split; [intros []; now constructor | intros H; inversion H; now split].
Qed.

Lemma sum_of_real : forall cs forces,
  real_screw (sum_of (map body_of cs) forces) =
  total3 (map real_contact3 cs) (real_forces3 forces).
Proof.
  induction cs as [|c cs IH]; intros [|[[n a] b] forces]; cbn [sum_of map real_forces3 total3];
    try apply qnothing_real.
  rewrite !qsum_real, !qscaled_real, n_real, t_real, u_real. f_equal. apply IH.
Qed.

(** * The theorems *)

(** An accepted proof of "not resisted" leaves no equilibrium, whatever motion and forces. *)
Theorem not_resisted_in_space : forall question tree,
  check3 question (NotResisted3 tree) = true ->
  forall d forces, ~ equilibrium3 (real_question3 question) d forces.
Proof.
  intros g t Test d forces. apply andb_true_iff in Test. destruct Test as [Mu Test].
  assert (Forall (fun c => 0 <= Q2R (friction3 c)) (contacts3 g)) as Friction.
  { rewrite forallb_forall in Mu. apply Forall_forall. intros c I. apply qnonneg_real.
    apply (Mu (body_of c)). now apply in_map. }
  apply (@refutes3_right _ _ _ Friction t _ Test).
  rewrite map_map. generalize (contacts3 g) as cs.
  induction cs; cbn; constructor; trivial. exact I.
Qed.

(** A proof of "resisted" is accepted exactly when its motion and forces are an equilibrium. *)
Theorem resisted_in_space : forall question motion forces,
  check3 question (Resisted3 motion forces) = true <->
  equilibrium3 (real_question3 question) (real_screw motion) (real_forces3 forces).
Proof.
  intros g d forces. cbn [check3]. unfold equilibrium3.
  rewrite andb_true_iff, qvanishes_real, qsum_real, sum_of_real, all_obey3_law. reflexivity.
Qed.
