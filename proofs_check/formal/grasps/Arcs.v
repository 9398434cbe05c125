(** Directions of slip: the greatest product with a unit vector of an arc, and sectors that go round. *)

Require Import Reals List Lra Psatz.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Definition pair_R := (R * R)%type.
Definition dot2 (a b : pair_R) : R := fst a * fst b + snd a * snd b.
Definition turn2 (a b : pair_R) : R := fst a * snd b - snd a * fst b.

Definition plane_zero : pair_R := (0, 0).

(** The closed cone between two directions. *)
Definition between (u v s : pair_R) : Prop :=
  exists p q, 0 <= p /\ 0 <= q /\ fst s = p * fst u + q * fst v /\ snd s = p * snd u + q * snd v.

Lemma squares a b : dot2 a b * dot2 a b + turn2 a b * turn2 a b = dot2 a a * dot2 b b.
Proof. unfold dot2, turn2. ring. Qed.

Lemma dot2_nonneg a : 0 <= dot2 a a.
Proof. unfold dot2. nra. Qed.

Lemma dot2_pos a : fst a <> 0 \/ snd a <> 0 -> 0 < dot2 a a.
Proof. unfold dot2. intros [H|H]; nra. Qed.

Lemma dot2_comm a b : dot2 a b = dot2 b a.
Proof. unfold dot2. ring. Qed.

Lemma schwarz a b : dot2 a b * dot2 a b <= dot2 a a * dot2 b b.
Proof. pose proof (squares a b). nra. Qed.

(** Where the turns say so, a direction is in the cone. *)
Lemma between_turns u v s : 0 < turn2 u v -> 0 <= turn2 u s -> 0 <= turn2 s v -> between u v s.
Proof.
  intros P A B. exists (turn2 s v / turn2 u v), (turn2 u s / turn2 u v).
  repeat split; try (apply Rmult_le_pos; [lra | left; now apply Rinv_0_lt_compat]);
  unfold turn2 in *; field; lra.
Qed.

Lemma turns_between u v s : 0 < turn2 u v -> between u v s -> 0 <= turn2 u s /\ 0 <= turn2 s v.
Proof.
  intros P (p & q & Hp & Hq & X & Y). unfold turn2 in *. rewrite X, Y. split; nra.
Qed.

Lemma between_dot u v s h : between u v s -> dot2 h u <= 0 -> dot2 h v <= 0 -> dot2 h s <= 0.
Proof.
  intros (p & q & Hp & Hq & X & Y) A B. unfold dot2 in *. rewrite X, Y. nra.
Qed.

(** The end of a sector that is between [b] and [s] is nearer to [b]. *)
Lemma near u s b : 0 < dot2 u u -> 0 <= turn2 u s -> turn2 u b <= 0 -> turn2 s b <= 0 ->
  0 < dot2 s b -> (turn2 u s = 0 -> 0 < dot2 u s) ->
  0 < dot2 u b /\ dot2 s b * dot2 s b * dot2 u u <= dot2 u b * dot2 u b * dot2 s s.
Proof.
  intros U A B C D E.
  assert (0 < dot2 b b) as Bpos.
  { destruct (Rle_lt_or_eq_dec _ _ (dot2_nonneg b)) as [|Z]; trivial.
    pose proof (schwarz s b). rewrite <- Z in H. nra. }
  assert (I : dot2 u b * - turn2 s b - dot2 s b * - turn2 u b = dot2 b b * turn2 u s)
    by (unfold dot2, turn2; ring).
  assert (Su := squares u b). assert (Ss := squares s b).
  assert (X : 0 < dot2 u b).
  { destruct (Rle_lt_or_eq_dec _ _ A) as [A'|A'].
    - destruct (Rlt_le_dec 0 (dot2 u b)) as [|L]; trivial. exfalso.
      assert (0 < dot2 b b * turn2 u s) by nra. nra.
    - symmetry in A'. specialize (E A').
      assert (Y : dot2 u b * dot2 s s = dot2 s b * dot2 u s).
      { assert (dot2 u b * dot2 s s - dot2 s b * dot2 u s = - turn2 s b * turn2 u s)
          by (unfold dot2, turn2; ring). nra. }
      assert (0 < dot2 s s) by (pose proof (schwarz s b); pose proof (dot2_nonneg s); nra).
      nra. }
  split; trivial.
  assert (F : dot2 s b * - turn2 u b <= dot2 u b * - turn2 s b).
  { assert (0 <= dot2 b b * turn2 u s) by nra. lra. }
  assert (G : (dot2 s b * turn2 u b) * (dot2 s b * turn2 u b) <=
    (dot2 u b * turn2 s b) * (dot2 u b * turn2 s b)).
  { assert (0 <= dot2 s b * - turn2 u b) by nra. nra. }
  apply Rmult_le_reg_r with (dot2 b b); trivial.
  replace (dot2 s b * dot2 s b * dot2 u u * dot2 b b)
    with (dot2 s b * dot2 s b * (dot2 u u * dot2 b b)) by ring.
  replace (dot2 u b * dot2 u b * dot2 s s * dot2 b b)
    with (dot2 u b * dot2 u b * (dot2 s s * dot2 b b)) by ring.
  rewrite <- Su, <- Ss. nra.
Qed.

(** * The bound on an arc *)

(** What the checker tests: [room] is at least [mu] |b|, or at least [mu] e . b / |e|. *)
Definition beyond_disc_real (room mu : R) (b : pair_R) : Prop :=
  0 <= room /\ mu * mu * dot2 b b <= room * room.

Definition beyond_end_real (room mu : R) (b e : pair_R) : Prop :=
  if Rlt_dec 0 (dot2 e b)
  then 0 <= room /\ mu * mu * (dot2 e b * dot2 e b) <= room * room * dot2 e e
  else 0 <= room \/ room * room * dot2 e e <= mu * mu * (dot2 e b * dot2 e b).

Lemma square_le a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros. destruct (Rle_lt_dec a b); trivial. nra. Qed.

(** Friction [c] of at most mu c_n does not do less than - room c_n on [b]. *)
Lemma disc_bound room mu b c_n c :
  beyond_disc_real room mu b -> 0 <= c_n -> dot2 c c <= mu * c_n * (mu * c_n) ->
  - room * c_n <= dot2 c b.
Proof.
  intros [Room B] N C. pose proof (schwarz c b). pose proof (dot2_nonneg b).
  assert (dot2 c b * dot2 c b <= (room * c_n) * (room * c_n)).
  { assert (dot2 c c * dot2 b b <= mu * c_n * (mu * c_n) * dot2 b b) by nra.
    assert (c_n * c_n * (mu * mu * dot2 b b) <= c_n * c_n * (room * room)) by nra. nra. }
  assert (- dot2 c b <= room * c_n); [apply square_le; nra | lra].
Qed.

Lemma sum_of_ends p q r uu uv vv a a' : 0 <= p -> 0 <= q ->
  r * uu <= a * a -> r * uv <= a * a' -> r * vv <= a' * a' ->
  r * (p * p * uu + 2 * (p * q) * uv + q * q * vv) <= (p * a + q * a') * (p * a + q * a').
Proof.
  intros P Q A B C. pose proof (Rmult_le_pos _ _ P Q) as PQ.
  pose proof (Rmult_le_compat_l _ _ _ (Rmult_le_pos _ _ P P) A).
  pose proof (Rmult_le_compat_l _ _ _ PQ B).
  pose proof (Rmult_le_compat_l _ _ _ (Rmult_le_pos _ _ Q Q) C). lra.
Qed.

(** The same where it is against a slip [s] in a sector, by the ends of the sector. *)
Section Sector.
  Variables (u v s b : pair_R) (room mu c_n t : R).
  Hypothesis UV : 0 < turn2 u v.
  Hypothesis S : between u v s.
  Hypothesis Slips : fst s <> 0 \/ snd s <> 0.
  Hypothesis Mu : 0 <= mu.
  Hypothesis Normal : 0 <= c_n.
  Hypothesis T : 0 <= t.
  Hypothesis Length : t * t * dot2 s s = mu * c_n * (mu * c_n).
  Hypothesis At_u : beyond_end_real room mu b u.
  Hypothesis At_v : beyond_end_real room mu b v.
  Hypothesis Out : turn2 u b < 0 \/ turn2 b v < 0.

  Lemma u_pos : 0 < dot2 u u.
  Proof.
    destruct (Rle_lt_or_eq_dec _ _ (dot2_nonneg u)) as [|Z]; trivial. exfalso.
    pose proof (squares u v). rewrite <- Z in H. nra.
  Qed.

  Lemma v_pos : 0 < dot2 v v.
  Proof.
    destruct (Rle_lt_or_eq_dec _ _ (dot2_nonneg v)) as [|Z]; trivial. exfalso.
    pose proof (squares u v). rewrite <- Z in H. nra.
  Qed.

  (** By the end [e] that is nearer to b. *)
  Lemma by_end e : beyond_end_real room mu b e -> 0 <= room -> 0 < dot2 e e -> 0 < dot2 e b ->
    dot2 s b * dot2 s b * dot2 e e <= dot2 e b * dot2 e b * dot2 s s ->
    t * dot2 s b <= room * c_n.
  Proof.
    unfold beyond_end_real. intros E Room Epos EB Near.
    destruct (Rlt_dec 0 (dot2 e b)) as [_|]; [|lra]. destruct E as [_ E].
    pose proof (dot2_pos s Slips) as Spos.
    apply square_le; [nra|].
    apply Rmult_le_reg_r with (dot2 e e * dot2 s s); [nra|].
    replace (t * dot2 s b * (t * dot2 s b) * (dot2 e e * dot2 s s))
      with ((t * t * dot2 s s) * (dot2 s b * dot2 s b * dot2 e e)) by ring.
    rewrite Length.
    apply Rle_trans with (mu * c_n * (mu * c_n) * (dot2 e b * dot2 e b * dot2 s s)).
    - apply Rmult_le_compat_l; [nra | trivial].
    - replace (mu * c_n * (mu * c_n) * (dot2 e b * dot2 e b * dot2 s s))
        with (mu * mu * (dot2 e b * dot2 e b) * (c_n * c_n * dot2 s s)) by ring.
      replace (room * c_n * (room * c_n) * (dot2 e e * dot2 s s))
        with (room * room * dot2 e e * (c_n * c_n * dot2 s s)) by ring.
      apply Rmult_le_compat_r; [nra | trivial].
  Qed.

  Lemma negative_end e : room < 0 -> beyond_end_real room mu b e ->
    dot2 e b <= 0 /\ room * room * dot2 e e <= mu * dot2 e b * (mu * dot2 e b).
  Proof.
    unfold beyond_end_real. intros Room E. destruct (Rlt_dec 0 (dot2 e b)) as [|L]; [lra|].
    split; [lra|]. destruct E; [lra | nra].
  Qed.

  (** a >= r |u| and b >= r |v| give a b >= r^2 u . v. *)
  Lemma product_of_ends a a' r : 0 <= a -> 0 <= a' ->
    r * r * dot2 u u <= a * a -> r * r * dot2 v v <= a' * a' -> r * r * dot2 u v <= a * a'.
  Proof.
    intros A A' U V. destruct (Rle_lt_dec (dot2 u v) 0) as [|P]; [nra|].
    apply square_le; [nra|]. pose proof (schwarz u v). pose proof u_pos. pose proof v_pos.
    assert ((r * r * dot2 u u) * (r * r * dot2 v v) <= (a * a) * (a' * a'))
      by (apply Rmult_le_compat; nra).
    assert (0 <= r * r * (r * r)) by nra. nra.
  Qed.

  Lemma sector_bound : - room * c_n <= - t * dot2 s b.
  Proof.
    pose proof (dot2_pos s Slips) as Spos. pose proof u_pos as Upos. pose proof v_pos as Vpos.
    enough (t * dot2 s b <= room * c_n) by lra.
    destruct (Rle_lt_dec 0 room) as [Room|Room].
    - destruct (Rle_lt_dec (dot2 s b) 0) as [|SB]; [nra|].
      destruct (turns_between UV S) as [US SV].
      assert (Turn_u : turn2 u s = 0 -> 0 < dot2 u s).
      { destruct S as (p & q & Hp & Hq & X & Y). intros Z.
        assert (turn2 u s = q * turn2 u v) as E by (unfold turn2; rewrite X, Y; ring).
        assert (q = 0) by nra. subst q.
        assert (p <> 0) by (intros ->; destruct Slips as [N|N]; apply N; lra).
        assert (dot2 u s = p * dot2 u u) by (unfold dot2; rewrite X, Y; ring). nra. }
      assert (Turn_v : turn2 s v = 0 -> 0 < dot2 v s).
      { destruct S as (p & q & Hp & Hq & X & Y). intros Z.
        assert (turn2 s v = p * turn2 u v) as E by (unfold turn2; rewrite X, Y; ring).
        assert (p = 0) by nra. subst p.
        assert (q <> 0) by (intros ->; destruct Slips as [N|N]; apply N; lra).
        assert (dot2 v s = q * dot2 v v) by (unfold dot2; rewrite X, Y; ring). nra. }
      (* The reflection that exchanges the ends. *)
      pose (m := fun a : pair_R => (fst a, - snd a)).
      assert (Mdot : forall a a', dot2 (m a) (m a') = dot2 a a') by (intros; unfold dot2, m; cbn; ring).
      assert (Mturn : forall a a', turn2 (m a) (m a') = turn2 a' a)
        by (intros; unfold turn2, m; cbn; ring).
      assert (By_u : turn2 u b <= 0 -> turn2 s b <= 0 -> t * dot2 s b <= room * c_n).
      { intros A B. destruct (@near u s b) as [C D]; trivial. now apply (by_end At_u). }
      assert (By_v : turn2 b v <= 0 -> turn2 b s <= 0 -> t * dot2 s b <= room * c_n).
      { intros A B. destruct (@near (m v) (m s) (m b)) as [C D];
          rewrite ?Mdot, ?Mturn in *; trivial. now apply (by_end At_v). }
      assert (Swap : turn2 b s = - turn2 s b) by (unfold turn2; ring).
      (* b between an end and s would be in the sector. *)
      assert (I : turn2 u s * turn2 b v = turn2 b s * turn2 u v + turn2 u b * turn2 s v)
        by (unfold turn2; ring).
      destruct (Rle_lt_dec (turn2 s b) 0) as [B|B].
      + destruct (Rle_lt_dec (turn2 u b) 0) as [A|A]; [auto|].
        destruct Out as [O|O]; [lra|]. exfalso.
        assert (0 <= turn2 b s * turn2 u v) by nra. assert (0 <= turn2 u b * turn2 s v) by nra.
        destruct (Rle_lt_or_eq_dec _ _ US) as [P|P]; [nra|].
        symmetry in P. specialize (Turn_u P). rewrite P in I.
        assert (turn2 s v = 0) by nra. specialize (Turn_v H1).
        destruct S as (p & q & Hp & Hq & X & Y).
        assert (turn2 u s = q * turn2 u v) as E1 by (unfold turn2; rewrite X, Y; ring).
        assert (turn2 s v = p * turn2 u v) as E2 by (unfold turn2; rewrite X, Y; ring).
        assert (q = 0) by nra. assert (p = 0) by nra. subst. destruct Slips as [N|N]; lra.
      + destruct (Rle_lt_dec (turn2 b v) 0) as [A|A]; [apply By_v; lra|].
        destruct Out as [O|O]; [|lra]. exfalso.
        pose proof (Rmult_lt_0_compat _ _ B UV).
        pose proof (Rmult_le_pos _ _ US (Rlt_le _ _ A)).
        assert (0 <= - turn2 u b) as O' by lra. pose proof (Rmult_le_pos _ _ O' SV).
        rewrite Swap in I.
        lra.
    - destruct (@negative_end u Room At_u) as [Ub U]. destruct (@negative_end v Room At_v) as [Vb V].
      pose proof (Rmult_le_compat_l _ _ _ Mu Ub) as A. pose proof (Rmult_le_compat_l _ _ _ Mu Vb) as B.
      assert (room * room * dot2 u v <= - (mu * dot2 u b) * - (mu * dot2 v b)) as UVb
        by (apply product_of_ends; lra).
      replace (- (mu * dot2 u b) * - (mu * dot2 v b)) with (mu * dot2 u b * (mu * dot2 v b)) in UVb
        by ring.
      destruct S as (p & q & Hp & Hq & X & Y).
      assert (SS : dot2 s s = p * p * dot2 u u + 2 * (p * q) * dot2 u v + q * q * dot2 v v)
        by (unfold dot2; rewrite X, Y; ring).
      assert (SB : dot2 s b = p * dot2 u b + q * dot2 v b)
        by (unfold dot2; rewrite X, Y; ring).
      pose proof (@sum_of_ends _ _ _ _ _ _ _ _ Hp Hq U UVb V) as Main.
      rewrite <- SS in Main.
      replace (p * (mu * dot2 u b) + q * (mu * dot2 v b)) with (mu * dot2 s b) in Main
        by (rewrite SB; ring).
      assert (dot2 s b <= 0) as Sb.
      { pose proof (Rmult_le_compat_l _ _ _ Hp Ub). pose proof (Rmult_le_compat_l _ _ _ Hq Vb). lra. }
      pose proof (Rmult_le_pos _ _ T (Ropp_0_ge_le_contravar _ (Rle_ge _ _ Sb))) as Pos.
      enough (- room * c_n <= - (t * dot2 s b)) by lra.
      apply square_le; [lra|].
      apply Rmult_le_reg_r with (dot2 s s); trivial.
      replace (- (t * dot2 s b) * - (t * dot2 s b) * dot2 s s)
        with (t * t * dot2 s s * (dot2 s b * dot2 s b)) by ring.
      rewrite Length.
      replace (- room * c_n * (- room * c_n) * dot2 s s)
        with (c_n * c_n * (room * room * dot2 s s)) by ring.
      replace (mu * c_n * (mu * c_n) * (dot2 s b * dot2 s b))
        with (c_n * c_n * (mu * dot2 s b * (mu * dot2 s b))) by ring.
      apply Rmult_le_compat_l; [apply Rle_0_sqr | trivial].
  Qed.
End Sector.

(** * Directions that go round *)

(** Each direction with the next one, the last with the first. *)
Fixpoint arcs (first : pair_R) (l : list pair_R) : list (pair_R * pair_R) :=
  match l with
  | [] => []
  | u :: rest => (u, match rest with [] => first | v :: _ => v end) :: arcs first rest
  end.

Section Round.
  Variables (s first : pair_R).
  Hypothesis Slips : fst s <> 0 \/ snd s <> 0.
  Let y (u : pair_R) := turn2 s u.

  Definition around (arc : pair_R * pair_R) := y (fst arc) <= 0 <= y (snd arc).

  Lemma falls (f : pair_R -> R) l : forall u,
    Forall (fun arc => f (snd arc) < f (fst arc)) (arcs first (u :: l)) -> f first < f u.
  Proof.
    induction l as [|v l IH]; intros u H; inversion_clear H as [|? ? A B]; cbn in A; trivial.
    specialize (IH _ B). lra.
  Qed.

  Lemma stays_below l : forall u, Forall (fun arc => ~ around arc) (arcs first (u :: l)) ->
    y u <= 0 -> y first < 0.
  Proof.
    induction l as [|v l IH]; intros u H U; inversion_clear H as [|? ? A B];
      unfold around in A; cbn [fst snd] in A; [lra|].
    apply (IH _ B). lra.
  Qed.

  Lemma all_below l : forall u, Forall (fun arc => ~ around arc) (arcs first (u :: l)) ->
    y u < 0 -> Forall (fun v => y v < 0) (u :: l).
  Proof.
    induction l as [|v l IH]; intros u H U; constructor; trivial;
      inversion_clear H as [|? ? A B]; unfold around in A; cbn [fst snd] in A.
    apply (IH _ B). lra.
  Qed.

  Lemma above_or_below l : forall u, Forall (fun arc => ~ around arc) (arcs first (u :: l)) ->
    Forall (fun v => 0 < y v) (u :: l) \/ y first < 0.
  Proof.
    induction l as [|v l IH]; intros u H; destruct (Rle_lt_dec (y u) 0) as [U|U];
      try (right; now apply (stays_below H U)).
    - left. now constructor.
    - inversion_clear H as [|? ? A B]. destruct (IH _ B); [left; now constructor | now right].
  Qed.

  (** On one side of the line of [s], turns make the quotients fall. *)
  Lemma quotients l : forall u, 0 < y first * y first ->
    Forall (fun arc => 0 < turn2 (fst arc) (snd arc)) (arcs first (u :: l)) ->
    (Forall (fun v => 0 < y v) (first :: u :: l) \/ Forall (fun v => y v < 0) (first :: u :: l)) ->
    Forall (fun arc => dot2 s (snd arc) / y (snd arc) < dot2 s (fst arc) / y (fst arc))
      (arcs first (u :: l)).
  Proof.
    assert (Step : forall u v, 0 < turn2 u v -> 0 < y u * y v ->
      dot2 s v / y v < dot2 s u / y u).
    { intros u v T P. apply Rmult_lt_reg_r with (y u * y v); trivial.
      assert (y u <> 0 /\ y v <> 0) as [U V] by (split; intros E; rewrite E in P; lra).
      replace (dot2 s v / y v * (y u * y v)) with (dot2 s v * y u) by (field; trivial).
      replace (dot2 s u / y u * (y u * y v)) with (dot2 s u * y v) by (field; trivial).
      pose proof (dot2_pos s Slips) as Spos.
      assert (dot2 s s * turn2 u v = dot2 s u * y v - dot2 s v * y u)
        by (unfold y, dot2, turn2; ring).
      pose proof (Rmult_lt_0_compat _ _ Spos T). lra. }
    induction l as [|v l IH]; intros u F T S; inversion_clear T as [|? ? A B]; cbn in A.
    - constructor; [|constructor]. cbn. apply Step; trivial.
      destruct S as [S|S]; inversion_clear S as [|? ? S1 S2]; inversion_clear S2; nra.
    - constructor.
      + cbn. apply Step; trivial.
        destruct S as [S|S]; inversion_clear S as [|? ? S1 S2]; inversion_clear S2 as [|? ? S3 S4];
          inversion_clear S4; nra.
      + apply IH; trivial.
        destruct S as [S|S]; [left|right]; inversion_clear S as [|? ? S1 S2]; inversion_clear S2;
          now constructor.
  Qed.

  Lemma round_covers l :
    Forall (fun arc => 0 < turn2 (fst arc) (snd arc)) (arcs first (first :: l)) ->
    exists u v, In (u, v) (arcs first (first :: l)) /\ 0 < turn2 u v /\ between u v s.
  Proof.
    intros T.
    destruct (Exists_dec around (arcs first (first :: l))) as [E|E].
    - intros [u v]. unfold around.
      destruct (Rle_dec (y (fst (u, v))) 0), (Rle_dec 0 (y (snd (u, v))));
        [now left | right; tauto | right; tauto | right; tauto].
    - apply Exists_exists in E. destruct E as ([u v] & I & A & B). exists u, v.
      rewrite Forall_forall in T. specialize (T _ I). cbn in *. repeat split; trivial.
      apply between_turns; trivial. unfold y, turn2 in *. lra.
    - exfalso. rewrite <- Forall_Exists_neg in E.
      assert (Forall (fun v => 0 < y v) (first :: first :: l) \/
              Forall (fun v => y v < 0) (first :: first :: l)) as Sides.
      { destruct (above_or_below E) as [S|S].
        - left. constructor; trivial. now inversion S.
        - right. constructor; trivial. now apply (all_below E). }
      assert (0 < y first * y first) as P
        by (destruct Sides as [S|S]; inversion S; nra).
      pose proof (falls (fun v => dot2 s v / y v) (quotients P T Sides)). lra.
  Qed.
End Round.
