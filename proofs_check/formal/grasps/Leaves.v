(** A leaf that holds leaves no equilibrium in its region and states. *)

Require Import Reals ZArith QArith Qreals List Bool Lia Lra Psatz.
Require Import Model Rationals Checker Arcs Vectors Regions.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Definition spring_at (c : row R) (d : list R) :=
  preload (values_of c) - stiffness (values_of c) * dot (normal c) d.
Definition slip_at (c : row R) (d : list R) : pair_R := (dot (tangent1 c) d, dot (tangent2 c) d).
Definition moves (s : pair_R) := fst s <> 0 \/ snd s <> 0.

(** What a state says of a motion. *)
Definition in_state (d : list R) (c : row R) (s : state) : Prop :=
  match s with
  | Undecided => True
  | Detached => spring_at c d <= 0
  | Attached => 0 <= spring_at c d
  | Stick => 0 <= spring_at c d /\ slip_at c d = plane_zero
  | SlipPlus => 0 <= spring_at c d /\ 0 < fst (slip_at c d) /\ snd (slip_at c d) = 0
  | SlipMinus => 0 <= spring_at c d /\ fst (slip_at c d) < 0 /\ snd (slip_at c d) = 0
  | Sector u v => 0 <= spring_at c d /\ moves (slip_at c d) /\
      0 < turn2 (real_pair u) (real_pair v) /\
      between (real_pair u) (real_pair v) (slip_at c d)
  end.

(** What is known of the direction of slip. *)
Definition known (w : way) (s : pair_R) : Prop :=
  match w with
  | Anywhere => True
  | Forth => 0 < fst s /\ snd s = 0
  | Back => fst s < 0 /\ snd s = 0
  | Within u v => moves s /\ 0 < turn2 (real_pair u) (real_pair v) /\
      between (real_pair u) (real_pair v) s
  end.

(** * One contact *)

Section Contact.
  Variables (d : list R) (c : row Q) (c_n c_1 c_2 : R).
  Hypothesis Law : law d (real_row c) (c_n, c_1, c_2).
  Let r := real_row c.

  Lemma normal_nonneg : 0 <= c_n.
  Proof. destruct Law as [-> _]. apply Rmax_l. Qed.

  Lemma normal_spring : spring_at r d <= c_n.
  Proof. destruct Law as [-> _]. apply Rmax_r. Qed.

  Lemma normal_attached : 0 <= spring_at r d -> c_n = spring_at r d.
  Proof. intros A. destruct Law as [-> _]. now apply Rmax_right. Qed.

  Lemma normal_detached : spring_at r d <= 0 -> c_n = 0.
  Proof. intros A. destruct Law as [-> _]. now apply Rmax_left. Qed.

  Variable l : list Q.
  Hypothesis Mu : 0 <= Q2R (friction (values_of c)).
  Let mu := Q2R (friction (values_of c)).
  Let a := Q2R (qdot (normal c) l).
  Let b_q : direction := (qdot (tangent1 c) l, qdot (tangent2 c) l).
  Let b := real_pair b_q.
  Let f : pair_R := (c_1, c_2).
  (* The work of the contact on the virtual motion. *)
  Let work := c_n * a + dot2 f b.

  Lemma cone : dot2 f f <= mu * c_n * (mu * c_n).
  Proof. destruct Law as (_ & _ & C & _). exact C. Qed.

  Lemma nothing_works : c_n = 0 -> work = 0.
  Proof.
    intros Z. pose proof cone as C. rewrite Z in C.
    assert (c_1 = 0 /\ c_2 = 0) as [E1 E2] by (unfold dot2, f in C; cbn in C; split; nra).
    unfold work, dot2, f. cbn. rewrite Z, E1, E2. ring.
  Qed.

  Lemma disc_work room : beyond_disc_real room mu b -> - room * c_n <= dot2 f b.
  Proof. intros B. exact (@disc_bound _ _ _ _ f B normal_nonneg cone). Qed.

  Lemma sector_work u v room : 0 < turn2 u v -> moves (slip_at r d) -> between u v (slip_at r d) ->
    beyond_end_real room mu b u -> beyond_end_real room mu b v ->
    turn2 u b < 0 \/ turn2 b v < 0 -> - room * c_n <= dot2 f b.
  Proof.
    intros UV M S U V Out. destruct Law as (_ & _ & _ & D).
    destruct (D M) as (Limit & t & T & F1 & F2).
    replace (dot2 f b) with (- t * dot2 (slip_at r d) b)
      by (unfold dot2, f; cbn in *; rewrite F1, F2; cbn; ring).
    apply (@sector_bound u v) with (mu := mu); trivial; [apply normal_nonneg|].
    change (t * t * dot2 (slip_at r d) (slip_at r d) = mu * c_n * (mu * c_n)).
    unfold mu. cbn in Limit. rewrite <- Limit, F1, F2. unfold dot2. cbn. ring.
  Qed.

  (** Friction against a slip along the one tangent. *)
  Lemma line_work : snd (slip_at r d) = 0 -> fst (slip_at r d) <> 0 ->
    c_2 = 0 /\ (0 < fst (slip_at r d) -> c_1 = - (mu * c_n)) /\
    (fst (slip_at r d) < 0 -> c_1 = mu * c_n).
  Proof.
    intros Z N. destruct Law as (_ & Limit & _ & D). cbn in Limit. fold mu in Limit.
    destruct D as (Full & t & T & F1 & F2); [now left|]. cbn in Full. fold mu in Full.
    cbn [slip_at fst snd] in Z, N. fold r in F1, F2. rewrite Z in F2.
    assert (c_2 = 0) as E2 by lra. rewrite E2 in Full. cbn [slip_at fst snd].
    repeat split; trivial; intros S.
    - assert (0 <= - c_1) by nra. nra.
    - assert (0 <= c_1) by nra. nra.
  Qed.

  (** The work is at least [alpha] for each unit of normal force. *)
  Lemma below_work w alpha :
    known w (slip_at r d) -> below alpha w (friction (values_of c)) (qdot (normal c) l) b_q = true ->
    Q2R alpha * c_n <= work.
  Proof.
    intros K B. unfold work.
    enough (- Q2R (qminus (qdot (normal c) l) alpha) * c_n <= dot2 f b) as G
      by (rewrite qminus_real in G; fold a in G; lra).
    set (room := qminus (qdot (normal c) l) alpha) in *. pose proof normal_nonneg as Nn.
    destruct w as [| | |u v]; cbn [known below] in *; fold room in B.
    - apply disc_work. now apply beyond_disc_right in B.
    - apply qleb_real in B. rewrite qtimes_real in B. fold mu in B.
      destruct K as [K Z]. destruct (line_work Z) as (E2 & E1 & _); [lra|].
      unfold dot2, f, b, real_pair. cbn [fst snd]. rewrite E2, (E1 K).
      apply (Rmult_le_compat_r c_n) in B; trivial. lra.
    - apply qleb_real in B. rewrite qtimes_real, Q2R_opp in B. fold mu in B.
      destruct K as [K Z]. destruct (line_work Z) as (E2 & _ & E1); [lra|].
      unfold dot2, f, b, real_pair. cbn [fst snd]. rewrite E2, (E1 K).
      apply (Rmult_le_compat_r c_n) in B; trivial. lra.
    - destruct K as (M & UV & S).
      destruct (qnonneg (qturn u b_q) && qnonneg (qturn b_q v)) eqn:In;
        [apply disc_work; now apply beyond_disc_right in B|].
      apply andb_false_iff in In.
      assert (turn2 (real_pair u) b < 0 \/ turn2 b (real_pair v) < 0) as Out.
      { unfold b. rewrite <- !qturn_real. destruct In as [I|I]; [left|right]; apply Rnot_le_lt;
          intros L; apply qnonneg_real in L; congruence. }
      apply andb_true_iff in B. destruct B as [Bu Bv]. apply beyond_end_right in Bu, Bv.
      exact (@sector_work _ _ _ UV M S Bu Bv Out).
  Qed.

  (** Of one tangent. *)
  Lemma kappa_work w : known w (slip_at r d) -> (forall u v, w <> Within u v) -> tangent2 c = [] ->
    Q2R (kappa w (friction (values_of c)) (qdot (normal c) l) (qdot (tangent1 c) l, 0%Q)) * c_n <=
      work.
  Proof.
    intros K N One. apply (@below_work w); trivial.
    assert (b_q = (qdot (tangent1 c) l, 0%Q)) as E by (unfold b_q; now rewrite One).
    rewrite E. set (k := kappa _ _ _ _). cbn [below].
    assert (forall x y, Q2R (qminus x (qminus x y)) = Q2R y) as Cancel
      by (intros; rewrite !qminus_real; ring).
    destruct w as [| | |u v]; [| | |now destruct (N u v)]; unfold k, kappa, below; cbn [fst snd].
    - apply andb_true_iff. set (x := qdot (tangent1 c) l).
      assert (Q2R (Z.abs (Qnum x) # Qden x) = Rabs (Q2R x)) as A.
      { unfold Q2R. cbn [Qnum Qden]. rewrite abs_IZR, Rabs_mult. f_equal.
        symmetry. apply Rabs_right. left. apply inverse_pos. }
      rewrite qnonneg_real, qleb_real, !qtimes_real, !Cancel, qtimes_real, qdot2_real, A.
      fold mu. unfold dot2, real_pair. cbn [fst snd]. rewrite zero_real.
      split; [exact (Rmult_le_pos _ _ Mu (Rabs_pos _))|].
      assert (Rabs (Q2R x) * Rabs (Q2R x) = Q2R x * Q2R x) as S
        by (rewrite <- Rabs_mult; apply Rabs_right; nra).
      right. replace (mu * Rabs (Q2R x) * (mu * Rabs (Q2R x)))
        with (mu * mu * (Rabs (Q2R x) * Rabs (Q2R x))) by ring. rewrite S. ring.
    - apply qleb_real. rewrite !Cancel. right. reflexivity.
    - apply qleb_real. rewrite !Cancel, !qtimes_real, !Q2R_opp. right. ring.
  Qed.
End Contact.

(** * Bounds *)

(** [injection] would compute. *)
Lemma some_same A (a b : A) : Some a = Some b -> a = b.
Proof. intros E. now injection E. Qed.

Definition value (m : bound) (x : list R) : R :=
  match m with
  | Linear form => dot (reals form) x
  | Pressed k e => Q2R k * Rmax 0 (dot (reals e) x)
  end.

(** It lies above its interpolation between generators. *)
Definition concave (m : bound) : Prop := match m with Pressed k _ => Q2R k <= 0 | _ => True end.

Section Bound.
  Variables (d : list R) (gens : list (list Q)) (l : list Q) (c : row Q) (s : state).
  Variables c_n c_1 c_2 : R.
  Hypothesis Here : spans gens (1 :: d).
  Hypothesis Mu : 0 <= Q2R (friction (values_of c)).
  Hypothesis Law : law d (real_row c) (c_n, c_1, c_2).
  Hypothesis State : in_state d (real_row c) s.
  Let r := real_row c.
  Let work := c_n * dot (normal r) (reals l) +
    (c_1 * dot (tangent1 r) (reals l) + c_2 * dot (tangent2 r) (reals l)).

  Lemma spring_form : dot (reals (spring (body_of c))) (1 :: d) = spring_at r d.
  Proof.
    unfold spring_at, r. cbn [spring body_of reals map dot]. fold (reals (qscaled (Qopp (stiffness (values_of c))) (normal c))).
    rewrite qscaled_real, dot_times, Q2R_opp. cbn. ring.
  Qed.

  Lemma slip1_form : dot (reals (slip1 (body_of c))) (1 :: d) = fst (slip_at r d).
  Proof. cbn. rewrite zero_real. unfold reals. ring. Qed.

  Lemma slip2_form : dot (reals (slip2 (body_of c))) (1 :: d) = snd (slip_at r d).
  Proof. cbn. rewrite zero_real. unfold reals. ring. Qed.

  Lemma apart : dot [1] (1 :: d) <> 0.
  Proof. cbn. lra. Qed.

  Lemma work_pairs : c_n * Q2R (qdot (normal c) l) +
    dot2 (c_1, c_2) (real_pair (qdot (tangent1 c) l, qdot (tangent2 c) l)) = work.
  Proof. unfold work, dot2, real_pair. cbn [fst snd]. rewrite !qdot_real. reflexivity. Qed.

  Lemma one_tangent_slip : one_tangent (body_of c) = true ->
    tangent2 c = [] /\ snd (slip_at r d) = 0.
  Proof. unfold one_tangent, r. cbn. destruct (tangent2 c); now cbn. Qed.

  Lemma way_known : known (way_of (body_of c) s gens) (slip_at r d).
  Proof.
    assert (forall w, w = (if negb (one_tangent (body_of c)) then Anywhere
      else if forallb (fun g => qpositive (qdot (slip1 (body_of c)) g)) gens then Forth
      else if forallb (fun g => qpositive (Qopp (qdot (slip1 (body_of c)) g))) gens then Back
      else Anywhere) -> known w (slip_at r d)) as Signs.
    { intros w ->. destruct (one_tangent (body_of c)) eqn:One; [|exact I].
      destruct (one_tangent_slip One) as [_ Z]. cbn [negb].
      destruct (forallb _ gens) eqn:E1; [|destruct (forallb _ gens) eqn:E2 in |- *].
      - split; trivial. rewrite <- slip1_form. apply (form_pos _ Here apart). intros g G.
        rewrite <- qdot_real. apply qpositive_real.
        rewrite forallb_forall in E1. now apply E1.
      - split; trivial. rewrite <- slip1_form. apply (form_neg _ Here apart). intros g G.
        rewrite <- qdot_real. rewrite forallb_forall in E2. specialize (E2 _ G).
        apply qpositive_real in E2. rewrite Q2R_opp in E2. lra.
      - exact I. }
    unfold way_of. destruct s; cbn [in_state known] in *; try tauto; now apply Signs.
  Qed.

  Lemma bound_with_right multipliers m :
    bound_with (body_of c) s gens l multipliers = Some m ->
    concave m /\ value m (1 :: d) <= work.
  Proof.
    destruct multipliers as [[alpha h_1] h_2]. unfold bound_with.
    set (none := qzero h_1 && qzero h_2). set (under := below _ _ _ _ _).
    set (allowed := match s with Undecided => _ | _ => _ end).
    destruct allowed eqn:A; cbn [negb]; [|easy]. intros E.
    assert (value m (1 :: d) = Q2R alpha * spring_at r d +
      dot2 (Q2R h_1, Q2R h_2) (slip_at r d) /\ concave m) as [-> C].
    { destruct (qzero alpha && none) eqn:Z; apply some_same in E; subst m; cbn [value concave]; split; trivial.
      - unfold none in Z. rewrite !andb_true_iff, !qzero_real in Z. destruct Z as (Z0 & Z1 & Z2).
        rewrite Z0, Z1, Z2. unfold dot2. cbn. ring.
      - rewrite !qadd_real, !dot_add, !qscaled_real, !dot_times, spring_form, slip1_form, slip2_form.
        unfold dot2. cbn [fst snd]. ring. }
    split; trivial. clear E C m. rewrite <- work_pairs.
    assert (under = true -> Q2R alpha * c_n <= c_n * Q2R (qdot (normal c) l) +
      dot2 (c_1, c_2) (real_pair (qdot (tangent1 c) l, qdot (tangent2 c) l))) as Under
      by (intros U; exact (@below_work d c c_n c_1 c_2 Law l Mu _ alpha way_known U)).
    assert (none = true -> dot2 (Q2R h_1, Q2R h_2) (slip_at r d) = 0) as None.
    { unfold none. rewrite andb_true_iff, !qzero_real. intros [-> ->]. unfold dot2. cbn. ring. }
    pose proof (normal_spring Law) as Ns. fold r in Ns.
    pose proof (@normal_attached _ _ _ _ _ Law) as Na. fold r in Na.
    pose proof (@normal_detached _ _ _ _ _ Law) as Nd. fold r in Nd.
    pose proof (@nothing_works d c c_n c_1 c_2 Law l) as Nothing.
    unfold allowed in A. clear allowed.
    destruct s as [| | | | | |u v]; cbn [in_state] in State; fold r in State.
    - rewrite !andb_true_iff, qnonneg_real in A. destruct A as ((P & H) & U).
      rewrite (None H). specialize (Under U). nra.
    - rewrite !andb_true_iff, qnonneg_real in A. destruct A as (P & H).
      rewrite (None H), (Nothing (Nd State)). nra.
    - rewrite andb_true_iff in A. destruct A as (H & U).
      rewrite (None H). specialize (Under U). rewrite (Na State) in *. lra.
    - destruct State as [S Z]. specialize (Under A). rewrite (Na S) in *. rewrite Z.
      unfold dot2 at 1, plane_zero. cbn [fst snd]. lra.
    - rewrite andb_true_iff, qleb_real, zero_real in A. destruct A as (H & U).
      destruct State as (S & P & Z). specialize (Under U). rewrite (Na S) in *.
      unfold dot2 at 1. cbn [fst snd]. rewrite Z. nra.
    - rewrite andb_true_iff, qleb_real, zero_real in A. destruct A as (H & U).
      destruct State as (S & P & Z). specialize (Under U). rewrite (Na S) in *.
      unfold dot2 at 1. cbn [fst snd]. rewrite Z. nra.
    - rewrite !andb_true_iff, !qleb_real, !qdot2_real, !zero_real in A. destruct A as ((HU & HV) & U).
      destruct State as (S & _ & _ & B). specialize (Under U). rewrite (Na S) in *.
      pose proof (@between_dot _ _ _ _ B HU HV) as H.
      unfold real_pair at 1 in H. cbn [fst snd] in H. lra.
  Qed.

  Lemma bound_without_right m :
    bound_without (body_of c) s gens l = Some m -> concave m /\ value m (1 :: d) <= work.
  Proof.
    unfold bound_without. set (k := kappa _ _ _ _).
    destruct (one_tangent (body_of c)) eqn:One; cbn [negb]; [|apply bound_with_right].
    destruct (one_tangent_slip One) as [Empty _].
    assert ((forall u v, s <> Sector u v) -> Q2R k * c_n <= work) as K.
    { intros N. rewrite <- work_pairs.
      apply (@kappa_work d c c_n c_1 c_2 Law l Mu _ way_known); trivial.
      intros u v. unfold way_of. rewrite One. cbn [negb]. destruct s; try easy;
        [destruct (forallb _ gens); [|destruct (forallb _ gens)]; easy ..|].
      intros [= -> ->]. now destruct (N u v). }
    assert ((forall u v, s <> Sector u v) ->
      (if forallb (fun g => qnonneg (qdot (spring (body_of c)) g)) gens then
         Some (Linear (qscaled k (spring (body_of c))))
       else if qnonneg k then Some (Linear []) else Some (Pressed k (spring (body_of c)))) = Some m ->
      concave m /\ value m (1 :: d) <= work) as Pressing.
    { intros N E. specialize (K N). pose proof (normal_nonneg Law) as Nn.
      pose proof (@normal_attached _ _ _ _ _ Law) as Na. fold r in Na.
      destruct (forallb _ gens) eqn:P in E; [|destruct (qnonneg k) eqn:Nonneg in E];
        apply some_same in E; subst m; cbn [value concave].
      - split; trivial.
        rewrite qscaled_real, dot_times, spring_form, <- Na; trivial.
        rewrite <- spring_form. apply (form_nonneg _ Here). intros g G.
        rewrite forallb_forall in P. specialize (P _ G). apply qnonneg_real in P.
        now rewrite qdot_real in P.
      - split; trivial. apply qnonneg_real in Nonneg. cbn [reals map dot]. nra.
      - assert (Q2R k <= 0) as Neg.
        { left. apply Rnot_le_lt. intros L. apply qnonneg_real in L. congruence. }
        split; trivial. rewrite spring_form.
        assert (c_n = Rmax 0 (spring_at r d)) as <- by exact (proj1 Law). exact K. }
    destruct s as [| | | | | |u v]; try (apply Pressing; easy); intros E; [|discriminate].
    apply some_same in E; subst m. cbn. split; trivial. rewrite <- work_pairs.
    rewrite (@nothing_works d c c_n c_1 c_2 Law l); [lra|]. exact (normal_detached Law State).
  Qed.
End Bound.

(** * All contacts *)

Definition pressed_value (pressed : list (Q * list Q)) (x : list R) : R :=
  fold_right (fun m sum => value (Pressed (fst m) (snd m)) x + sum) 0 pressed.

Lemma least_work d gens l : spans gens (1 :: d) ->
  forall cs i states forces multipliers form pressed,
  Forall (fun c => 0 <= Q2R (friction (values_of c))) cs ->
  Forall2 (law d) (map real_row cs) forces ->
  Forall2 (in_state d) (map real_row cs) states ->
  least i (map body_of cs) states gens l multipliers = Some (form, pressed) ->
  Forall (fun m => Q2R (fst m) <= 0) pressed /\
  dot (reals form) (1 :: d) + pressed_value pressed (1 :: d) <=
    dot (total (map real_row cs) forces) (reals l).
Proof.
  intros Here. induction cs as [|c cs IH];
    intros i states forces multipliers form pressed Mu Law States E;
    inversion Law as [|? force ? forces' First Others]; subst;
    inversion States as [|? s ? states' State States']; subst; cbn [least map] in E.
  - injection E as <- <-. cbn. split; [constructor | lra].
  - inversion_clear Mu as [|? ? Mu1 Mu2].
    destruct (match given i multipliers with Some _ => _ | None => _ end) as [m|] eqn:M; [|easy].
    destruct (least (i + 1) (map body_of cs) states' gens l multipliers) as [[sum others]|] eqn:L;
      [|destruct m; discriminate].
    destruct (IH _ _ _ _ _ _ Mu2 Others States' L) as [Concave Work].
    destruct force as [[c_n c_1] c_2].
    assert (concave m /\ value m (1 :: d) <= c_n * dot (normal (real_row c)) (reals l) +
      (c_1 * dot (tangent1 (real_row c)) (reals l) + c_2 * dot (tangent2 (real_row c)) (reals l)))
      as [Cm Vm].
    { destruct (given i multipliers) as [given_m|].
      - exact (@bound_with_right d gens l c s c_n c_1 c_2 Here Mu1 First State given_m m M).
      - exact (@bound_without_right d gens l c s c_n c_1 c_2 Here Mu1 First State m M). }
    cbn [total map]. autorewrite with dot.
    destruct m as [own|k e]; apply some_same, pair_equal_spec in E; destruct E as [<- <-]; cbn [value concave] in Cm, Vm.
    + split; trivial. rewrite qadd_real, dot_add. lra.
    + split; [now constructor|]. cbn [pressed_value fold_right fst snd].
      fold (pressed_value others (1 :: d)). cbn [value]. lra.
Qed.

Lemma at_generator_real pressed g : Q2R (at_generator pressed g) = pressed_value pressed (reals g).
Proof.
  induction pressed as [|[k e] pressed IH]; cbn [at_generator pressed_value fold_right fst snd];
    [apply zero_real|].
  rewrite qplus_real, IH. f_equal. cbn [value]. rewrite <- qdot_real.
  destruct (qpositive (qdot e g)) eqn:P.
  - apply qpositive_real in P. rewrite qtimes_real, Rmax_right; lra.
  - assert (Q2R (qdot e g) <= 0).
    { apply Rnot_lt_le. intros L. apply qpositive_real in L. congruence. }
    rewrite zero_real, Rmax_left; lra.
Qed.

(** What is concave is at least the sum of what it is on generators. *)
Lemma pressed_concave pressed gens x : Forall (fun m => Q2R (fst m) <= 0) pressed ->
  forall ts, length ts = length gens -> Forall (Rle 0) ts ->
  (forall f, dot f x = combination f ts gens) ->
  fold_right (fun p sum => fst p * pressed_value pressed (reals (snd p)) + sum) 0 (combine ts gens)
    <= pressed_value pressed x.
Proof.
  intros C ts L T E. induction C as [|[k e] pressed K C IH]; cbn [pressed_value fold_right fst snd].
  - clear. induction (combine ts gens) as [|[t g] l IH]; cbn [fold_right fst snd]; lra.
  - fold (pressed_value pressed x). cbn [fst] in K.
    assert (Rmax 0 (dot (reals e) x) <=
      fold_right (fun p sum => fst p * Rmax 0 (dot (reals e) (reals (snd p))) + sum) 0
        (combine ts gens)) as M.
    { rewrite E. clear - T. revert gens. induction T as [|t ts Ht T IH]; intros [|g gens];
        cbn [combination combine fold_right fst snd]; try (rewrite Rmax_left; lra).
      specialize (IH gens). set (rest := fold_right _ _ _) in *.
      pose proof (Rmax_l 0 (dot (reals e) (reals g))). pose proof (Rmax_r 0 (dot (reals e) (reals g))).
      pose proof (Rmax_l 0 (combination (reals e) ts gens)).
      pose proof (Rmax_r 0 (combination (reals e) ts gens)).
      apply Rmax_lub; nra. }
    enough (fold_right (fun p sum => fst p * (value (Pressed k e) (reals (snd p)) +
        pressed_value pressed (reals (snd p))) + sum) 0 (combine ts gens) =
      Q2R k * fold_right (fun p sum => fst p * Rmax 0 (dot (reals e) (reals (snd p))) + sum) 0
        (combine ts gens) +
      fold_right (fun p sum => fst p * pressed_value pressed (reals (snd p)) + sum) 0
        (combine ts gens)) as S.
    { unfold pressed_value in S at 1. unfold pressed_value at 1. rewrite S.
      change (fold_right _ 0 pressed) with (pressed_value pressed x). cbn [value].
      pose proof (Rmult_le_compat_neg_l _ _ _ K M). lra. }
    clear. induction (combine ts gens) as [|[t g] l IH]; cbn [fold_right fst snd]; [ring|].
    rewrite IH. cbn [value]. ring.
Qed.

(** The test at the generators: at least 0, and above 0 at a motion. *)
Lemma test_positive sum pressed : forall ts gens, Forall (Rle 0) ts ->
  forallb
    (fun g =>
       let work := qplus (qdot sum g) (at_generator pressed g) in
       if qpositive (hd 0%Q g) then qpositive work else qnonneg work)
    gens = true ->
  let whole := combination (reals sum) ts gens +
    fold_right (fun p s => fst p * pressed_value pressed (reals (snd p)) + s) 0 (combine ts gens) in
  0 <= whole /\ (0 < combination [1] ts gens -> 0 < whole).
Proof.
  intros ts gens T. revert gens. induction T as [|t ts Ht T IH]; intros [|g gens] Test;
    cbn [combination combine fold_right fst snd]; try lra.
  cbn [forallb] in Test. apply andb_true_iff in Test. destruct Test as [Now Test].
  destruct (IH gens Test) as [Nonneg Pos]. cbv zeta in Now.
  assert (dot [1] (reals g) = Q2R (hd 0%Q g)) as Head by (destruct g; cbn; rewrite ?zero_real; ring).
  set (now_at := Q2R (qplus (qdot sum g) (at_generator pressed g))).
  assert (now_at = dot (reals sum) (reals g) + pressed_value pressed (reals g)) as W
    by (unfold now_at; now rewrite qplus_real, qdot_real, at_generator_real).
  assert (0 <= now_at /\ (0 < Q2R (hd 0%Q g) -> 0 < now_at)) as [N P].
  { destruct (qpositive (hd 0%Q g)) eqn:E.
    - apply qpositive_real in Now. fold now_at in Now. lra.
    - apply qnonneg_real in Now. fold now_at in Now. split; trivial. intros L.
      apply qpositive_real in L. congruence. }
  rewrite Head. set (rest := combination (reals sum) ts gens) in *.
  set (others := fold_right _ _ _) in *.
  replace (t * dot (reals sum) (reals g) + rest + (t * pressed_value pressed (reals g) + others))
    with (t * now_at + (rest + others)) by (rewrite W; ring).
  split; [nra|]. intros One.
  destruct (Rlt_le_dec 0 (combination [1] ts gens)) as [X|X]; [specialize (Pos X); nra|].
  assert (0 < t * Q2R (hd 0%Q g)) as TH by lra.
  destruct (Rle_lt_or_eq_dec 0 t Ht) as [Lt | <-]; [|lra].
  assert (0 < Q2R (hd 0%Q g)) as H by (apply Rmult_lt_reg_l with t; lra).
  specialize (P H). nra.
Qed.

Lemma leaf_right cs load gens d forces states l multipliers :
  spans gens (1 :: d) ->
  Forall (fun c => 0 <= Q2R (friction (values_of c))) cs ->
  leaf_holds (map body_of cs) load gens states l multipliers = true ->
  Forall2 (in_state d) (map real_row cs) states ->
  Forall2 (law d) (map real_row cs) forces ->
  ~ Forall (fun x => x = 0) (add (total (map real_row cs) forces) (reals load)).
Proof.
  intros Here Mu Test States Law Balance. unfold leaf_holds in Test.
  destruct (least _ _ _ _ _ _) as [[form pressed]|] eqn:L; [|easy].
  destruct (@least_work d gens l Here _ _ _ _ _ _ _ Mu Law States L) as [Concave Work].
  apply (dot_vanishing (reals l)) in Balance. rewrite dot_add in Balance.
  set (sum := qadd [qdot load l] form) in Test.
  assert (dot (reals sum) (1 :: d) + pressed_value pressed (1 :: d) <= 0) as Below.
  { unfold sum. rewrite qadd_real, dot_add.
    replace (dot (reals [qdot load l]) (1 :: d)) with (dot (reals load) (reals l))
      by (cbn; rewrite qdot_real; ring).
    lra. }
  destruct Here as (ts & Len & T & E).
  pose proof (@pressed_concave pressed gens (1 :: d) Concave ts Len T E) as Super.
  rewrite E in Below. pose proof (E [1]) as One. cbn [dot] in One. rewrite Rmult_1_l, Rplus_0_r in One.
  destruct (test_positive _ _ _ T Test) as [_ Positive]. specialize (Positive ltac:(lra)). lra.
Qed.
