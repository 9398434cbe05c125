(** Bounded regions: as many as the characteristic polynomial says at 1, but for the sign. *)

Require Import Reals ZArith List Bool Lia Lra ClassicalDedekindReals.
Require Import Planes Sides Rank Recursion Counting Bounds General.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Directions in which a region is unbounded *)

Definition toward (a : sign) (r : R) : Prop :=
  match a with Plus => 0 <= r | Minus => r <= 0 | Zero => r = 0 end.

Definition recedes (B : list (form R)) (s : list sign) (v : point) : Prop :=
  Forall2 (fun f a => toward a (along f v)) B s.

Lemma value_plus f x t v : value f (plus x t v) = value f x + t * along f v.
Proof. unfold value, along. rewrite linear_plus. ring. Qed.

Lemma toward_stays a r u t : sgn r = a -> toward a u -> 0 <= t -> sgn (r + t * u) = a.
Proof. intros <- U T. destruct (sgn r) eqn:E; cbn in U; rewrite ?sgn_minus, ?sgn_zero, ?sgn_plus in *; nra. Qed.

Lemma recedes_stays B x v : recedes B (signs B x) v ->
  forall t, 0 <= t -> signs B (plus x t v) = signs B x.
Proof.
  intros H t T. induction B as [|f B IH]; trivial. rewrite !signs_cons in *. inversion H; subst.
  rewrite IH by trivial. f_equal. rewrite value_plus. now apply toward_stays.
Qed.

Lemma stays_recedes B s x v : (forall t, 0 <= t -> signs B (plus x t v) = s) -> recedes B s v.
Proof.
  revert s. induction B as [|f B IH]; intros s H.
  - rewrite <- (H 0) by lra. constructor.
  - destruct s as [|a s]; [now specialize (H 0 ltac:(lra))|]. constructor.
    + assert (forall t, 0 <= t -> sgn (value f x + t * along f v) = a) as V.
      { intros t T. specialize (H t T). rewrite signs_cons, value_plus in H. now injection H. }
      pose proof (V 0 ltac:(lra)) as V0. pose proof (V 1 ltac:(lra)) as V1. rewrite Rmult_0_l, Rplus_0_r in V0.
      destruct (Req_dec (along f v) 0) as [E|E]; [rewrite E; destruct a; cbn; lra|].
      specialize (V (- value f x / along f v)).
      replace (value f x + - value f x / along f v * along f v) with 0 in V by (field; trivial).
      rewrite (proj2 (sgn_zero 0) eq_refl) in V. unfold Rdiv in V.
      destruct (Rdichotomy _ _ E) as [L|L]; [apply Rinv_lt_0_compat in L as I|apply Rinv_0_lt_compat in L as I];
      destruct a; cbn; rewrite ?sgn_minus, ?sgn_zero, ?sgn_plus in V0, V1; try lra;
      (specialize (V ltac:(nra)); discriminate).
    + apply IH. intros t T. specialize (H t T). rewrite signs_cons in H. now injection H.
Qed.

Definition ends (B : list (form R)) (s : list sign) : Prop :=
  region B s /\ forall v, recedes B s v -> none B v.

Lemma ends_bounded B s : bounded B s <-> ends B s.
Proof.
  split; intros [R H]; (split; [trivial|]); intros v.
  - intros D. apply Forall_forall. intros f F. destruct R as [(x & <-) _]. apply (H v); trivial.
    exists x. intros t T. exact (@recedes_stays B x v D t T).
  - intros (x & X) f F. assert (none B v) as N by (apply H, stays_recedes with x; exact X).
    now apply (proj1 (Forall_forall _ _) N).
Qed.

Lemma none_dec B v : none B v \/ ~ none B v.
Proof. destruct (Forall_dec (fun f => along f v = 0) (fun f => Req_EM_T (along f v) 0) B); tauto. Qed.

Lemma holds_dec (P : point -> Prop) B : (forall v, P v -> none B v) \/ ~ forall v, P v -> none B v.
Proof.
  destruct (sig_not_dec (exists v, P v /\ ~ none B v)) as [Y|N].
  - right. intros H. apply Y. intros (v & V & W). auto.
  - left. intros v V. destruct (none_dec B v) as [|W]; trivial. destruct N. now exists v.
Qed.

(** * Counting *)

Definition truth (P : Prop) (k : Z) : Prop := (P /\ k = 1 \/ ~ P /\ k = 0)%Z.

Lemma truth_dec (P : Prop) : P \/ ~ P -> exists k, truth P k.
Proof. intros [H|H]; [exists 1%Z; now left|exists 0%Z; now right]. Qed.

Lemma number_extend T (P : T -> Prop) a l k n : ~ In a l -> truth (P a) k ->
  number (fun s => In s l /\ P s) n -> number (fun s => In s (a :: l) /\ P s) (k + n).
Proof.
  intros I K N. destruct K as [[H ->]|[H ->]].
  - eapply number_iff; [|apply number_or with (P := fun s => s = a) (3 := N)].
    + intros s. cbn. split; [intros [->|[]]; auto|intros [[<-|]]; auto].
    + intros s -> [? _]. easy.
    + now apply number_one with a.
  - rewrite Z.add_0_l. revert N. apply number_iff. intros s. cbn. split; [tauto|]. intros [[<-|] ?]; tauto.
Qed.

Lemma four_counts T (P1 P2 Q1 Q2 : T -> Prop) l : NoDup l ->
  (forall s, In s l -> exists a b c d, truth (P1 s) a /\ truth (P2 s) b /\ truth (Q1 s) c /\ truth (Q2 s) d /\
    (a + b = c + d)%Z) ->
  exists a b c d, number (fun s => In s l /\ P1 s) a /\ number (fun s => In s l /\ P2 s) b /\
    number (fun s => In s l /\ Q1 s) c /\ number (fun s => In s l /\ Q2 s) d /\ (a + b = c + d)%Z.
Proof.
  induction 1 as [|s l I N IH]; intros H.
  - exists 0%Z, 0%Z, 0%Z, 0%Z. repeat split; apply number_none; cbn; tauto.
  - destruct IH as (a & b & c & d & A & B & C & D & E); [intros; apply H; now right|].
    destruct (H s (or_introl eq_refl)) as (a' & b' & c' & d' & A' & B' & C' & D' & E').
    exists (a' + a)%Z, (b' + b)%Z, (c' + c)%Z, (d' + d)%Z. repeat split; try now apply number_extend. lia.
Qed.

(** * One plane more *)

Section More.

Variables (h : form R) (j : nat) (B : list (form R)).
Hypothesis slant : slope h j <> 0.

(** Regions of B that h = 0 cuts, and whose part on it ends in all directions. *)
Definition cuts (s : list sign) : Prop := (exists x, value h x = 0 /\ signs B x = s) /\ ~ In Zero s.

Definition ends_on (s : list sign) : Prop :=
  cuts s /\ forall v, along h v = 0 /\ recedes B s v -> none B v.

Lemma recedes_cons a s v : recedes (h :: B) (a :: s) v <-> toward a (along h v) /\ recedes B s v.
Proof. unfold recedes. split; [intros H; inversion H; subst; tauto|intros []; now constructor]. Qed.

Lemma none_cons v : none (h :: B) v <-> along h v = 0 /\ none B v.
Proof. unfold none. rewrite Forall_cons_iff. reflexivity. Qed.

Lemma recedes_plus s v w a b : 0 <= a -> 0 <= b -> recedes B s v -> recedes B s w ->
  recedes B s (fun i => a * v i + b * w i).
Proof.
  intros A C V W. revert W. unfold recedes. induction V as [|f c B0 s0 F V IH]; intros W; [constructor|].
  inversion W; subst. constructor; [|auto].
  assert (along f (fun i => a * v i + b * w i) = a * along f v + b * along f w) as ->.
  { pose proof (@along_plus f (fun i => a * v i) b w) as E1. unfold plus in E1. rewrite E1. f_equal.
    pose proof (@along_plus f origin a v) as E2. unfold plus, origin in E2.
    unfold along in *. rewrite linear_origin in E2. rewrite Rplus_0_l in E2. rewrite <- E2.
    f_equal. apply FunctionalExtensionality.functional_extensionality. intros i. ring. }
  destruct c; cbn in *; nra.
Qed.

Lemma cut_both s a : a <> Zero -> cuts s -> region (h :: B) (a :: s).
Proof.
  intros A [(x & X & <-) N]. destruct (@both_sides B h x j slant X N) as [(y & Y & L) (z & Z & G)].
  destruct a; [|easy|].
  - split; [exists y; rewrite signs_cons; f_equal; [now apply sgn_minus|exact Y]|intros [|]; easy].
  - split; [exists z; rewrite signs_cons; f_equal; [now apply sgn_plus|exact Z]|intros [|]; easy].
Qed.

(** A half-line of a region that goes down towards h = 0 meets it. *)
Lemma goes_down x v a : sgn (value h x) = a -> a <> Zero -> recedes B (signs B x) v ->
  ~ toward a (along h v) -> exists z, value h z = 0 /\ signs B z = signs B x.
Proof.
  intros A N D T. assert (along h v <> 0) as NZ by (intros E; apply T; rewrite E; destruct a; cbn; lra).
  exists (plus x (- value h x / along h v) v). split; [rewrite value_plus; field; trivial|].
  apply recedes_stays; trivial. unfold Rdiv.
  destruct (Rdichotomy _ _ NZ) as [L|L]; [apply Rinv_lt_0_compat in L as I|apply Rinv_0_lt_compat in L as I];
  destruct a; try easy; cbn in T; rewrite ?sgn_minus, ?sgn_plus in A; try lra; nra.
Qed.

Lemma region_side s : region B s -> ~ cuts s -> exists a, a <> Zero /\
  (forall b, region (h :: B) (b :: s) <-> b = a) /\
  (forall v, recedes B s v -> toward a (along h v)).
Proof.
  intros [(x & <-) N] M.
  assert (forall y, signs B y = signs B x -> value h y <> 0) as Off.
  { intros y Y E. apply M. split; [now exists y|trivial]. }
  assert (sgn (value h x) <> Zero) as A by (intros E; now apply (Off x), sgn_zero).
  exists (sgn (value h x)). split; [trivial|]. split.
  - intros b. split.
    + intros [(y & Y) Z]. rewrite signs_cons in Y. injection Y as <- Y. pose proof (Off y Y) as NY.
      pose proof (Off x eq_refl) as NX. destruct (Rdichotomy _ _ NX) as [P|P], (Rdichotomy _ _ NY) as [Q|Q].
      * now rewrite (proj2 (sgn_minus _) P), (proj2 (sgn_minus _) Q).
      * destruct (@between B h x y) as (z & Hz & V); trivial; [congruence|]. now destruct (Off z).
      * destruct (@between B h y x) as (z & Hz & V); trivial. destruct (Off z); congruence.
      * now rewrite (proj2 (sgn_plus _) P), (proj2 (sgn_plus _) Q).
    + intros ->. split; [now exists x|]. intros [E|E]; easy.
  - intros v D. set (a := sgn (value h x)) in *.
    assert (toward a (along h v) \/ ~ toward a (along h v)) as [T|T]; trivial.
    { destruct a; cbn; lra. }
    destruct (@goes_down x v a eq_refl A D T) as (z & Z & E). now destruct (Off z).
Qed.

Lemma cut_region s : cuts s -> region B s.
Proof. intros [(x & _ & <-) N]. split; [now exists x|trivial]. Qed.

Lemma cuts_dec n s : number cuts n -> cuts s \/ ~ cuts s.
Proof.
  intros (l & (_ & L) & _). destruct (in_dec vector_eq_dec s l) as [I|I]; [left|right];
  rewrite <- L; trivial.
Qed.

Lemma ends_dec A s : region A s \/ ~ region A s -> ends A s \/ ~ ends A s.
Proof.
  intros [R|R]; [|right; now intros []]. destruct (holds_dec (fun v => recedes A s v) A); [now left; split|].
  right. now intros [].
Qed.

(** Where h depends on B: as many regions end as end of B, and on h = 0. *)
Lemma dependent_more n1 n2 n3 : (forall v, none B v -> along h v = 0) ->
  number (region B) n1 -> number cuts n2 -> number ends_on n3 ->
  forall n, number (ends B) n -> number (ends (h :: B)) (n + n3).
Proof.
  intros Dep (l & (ND & L) & _) Cuts On n Num.
  destruct (@four_counts _ (fun s => ends (h :: B) (Plus :: s)) (fun s => ends (h :: B) (Minus :: s))
    (ends B) ends_on l ND) as (a & b & c & d & Na & Nb & Nc & Nd & E).
  { intros s R%L. destruct (cuts_dec s Cuts) as [M|M].
    - pose proof (@cut_both s Plus ltac:(easy) M) as RP. pose proof (@cut_both s Minus ltac:(easy) M) as RM.
      destruct (truth_dec (ends_dec (or_introl RP))) as (a & Ta).
      destruct (truth_dec (ends_dec (or_introl RM))) as (b & Tb).
      destruct (truth_dec (ends_dec (or_introl R))) as (c & Tc).
      destruct (@truth_dec (ends_on s)) as (d & Td).
      { destruct (holds_dec (fun v => along h v = 0 /\ recedes B s v) B); [left; now split|right; now intros []]. }
      exists a, b, c, d. do 4 (split; [assumption|]).
      assert (forall t, toward t 0) as Flat by (intros []; cbn; lra).
      assert (forall t, ends B s -> region (h :: B) (t :: s) -> ends (h :: B) (t :: s)) as Up.
      { intros t [_ F] Rt. split; trivial. intros v [_ V]%recedes_cons. apply none_cons. auto. }
      assert (forall t, ends (h :: B) (t :: s) -> ends_on s) as Down.
      { intros t [_ F]. split; trivial. intros v [H V].
        apply (proj1 (none_cons v)), F, recedes_cons. rewrite H. auto. }
      assert (ends (h :: B) (Plus :: s) -> ends (h :: B) (Minus :: s) -> ends B s) as Two.
      { intros [_ F] [_ G]. split; trivial. intros v V.
        destruct (Rle_dec 0 (along h v)) as [C|C]; [apply (proj1 (none_cons v)), F|apply (proj1 (none_cons v)), G];
        apply recedes_cons; cbn; split; trivial; lra. }
      assert (ends_on s -> ~ ends (h :: B) (Plus :: s) -> ~ ends (h :: B) (Minus :: s) -> False) as One.
      { intros [_ F] NP NM. apply NP. split; trivial. intros v [V0 V]%recedes_cons.
        destruct (none_dec (h :: B) v) as [|W]; trivial. exfalso. apply NM. split; trivial.
        intros w [W0 W1]%recedes_cons. cbn in V0, W0. apply none_cons.
        assert (along h v <> 0) as HV.
        { intros E. apply W, none_cons. split; trivial. apply F. auto. }
        destruct (Req_dec (along h w) 0) as [HW|HW]; [split; trivial; apply F; auto|exfalso].
        set (u := fun i => - along h w * v i + along h v * w i).
        assert (recedes B s u) as U by (apply recedes_plus; trivial; lra).
        assert (forall f, along f u = - along h w * along f v + along h v * along f w) as Au.
        { intros f. unfold u. pose proof (@along_plus f (fun i => - along h w * v i) (along h v) w) as E1.
          unfold plus in E1. rewrite E1. f_equal. pose proof (@along_plus f origin (- along h w) v) as E2.
          unfold plus, origin in E2. unfold along in *. rewrite linear_origin, Rplus_0_l in E2. rewrite <- E2.
          f_equal. apply FunctionalExtensionality.functional_extensionality. intros i. ring. }
        assert (none B u) as NU by (apply F; split; [rewrite Au; ring|trivial]).
        apply HV, Dep. apply Forall_forall. intros f I.
        pose proof (proj1 (Forall_forall _ _) NU f I) as E0. cbv beta in E0. rewrite Au in E0.
        clear - I V W1 E0 V0 W0 HV HW. revert W1. induction V as [|g a B0 s0 T V IH]; intros W1; [easy|].
        inversion W1; subst. destruct I as [<-|I]; [|now apply IH].
        destruct a; cbn in *; try nra. }
      destruct Ta as [[A ->]|[A ->]], Tb as [[B0 ->]|[B0 ->]], Tc as [[C ->]|[C ->]], Td as [[D ->]|[D ->]];
      trivial; exfalso; eauto.
    - destruct (@region_side s R M) as (a & A & Side & T).
      assert (forall b, ends (h :: B) (b :: s) <-> b = a /\ ends B s) as Same.
      { intros b. split.
        - intros [R1 F]. pose proof (proj1 (Side b) R1) as ->. repeat split; try apply R.
          intros v V. apply (proj1 (none_cons v)), F, recedes_cons. auto.
        - intros [-> [_ F]]. split; [now apply Side|]. intros v [_ V]%recedes_cons. apply none_cons. auto. }
      destruct (truth_dec (ends_dec (or_introl R))) as (c & Tc).
      assert (truth (ends_on s) 0) as Td by (right; split; [now intros []|trivial]).
      assert (forall b, b = a -> truth (ends (h :: B) (b :: s)) c) as Yes.
      { intros b ->. destruct Tc as [[C ->]|[C ->]]; [left|right]; (split; trivial); rewrite Same; tauto. }
      assert (forall b, b <> a -> truth (ends (h :: B) (b :: s)) 0) as No.
      { intros b Nb. right. split; trivial. rewrite Same. tauto. }
      destruct a; [|easy|].
      + exists 0%Z, c, c, 0%Z. repeat split; trivial; [now apply No|now apply Yes|lia].
      + exists c, 0%Z, c, 0%Z. repeat split; trivial; [now apply Yes|now apply No]. }
  assert (c = n) as <-.
  { apply (@number_unique _ (ends B)); trivial. revert Nc. apply number_iff. intros s. split; [tauto|].
    intros F. split; trivial. apply L, F. }
  assert (d = n3) as <-.
  { apply (@number_unique _ ends_on); trivial. revert Nd. apply number_iff. intros s. split; [tauto|].
    intros F. split; trivial. apply L, cut_region, F. }
  assert (forall t k, number (fun s => In s l /\ ends (h :: B) (t :: s)) k ->
    number (fun u => exists s, (In s l /\ ends (h :: B) (t :: s)) /\ t :: s = u) k) as Image.
  { intros t k. apply number_image with (e := cons t); [now intros ? ? [=]|reflexivity]. }
  rewrite <- E. eapply number_iff; [|apply number_or; [|exact (Image _ _ Na)|exact (Image _ _ Nb)]].
  - intros t. cbn beta. split.
    + intros [(s & [_ F] & <-)|(s & [_ F] & <-)]; exact F.
    + intros F. pose proof F as [[(x & <-) N] _]. rewrite signs_cons in *.
      assert (In (signs B x) l) as I by (apply L; split; [now exists x|cbn in N; tauto]).
      destruct (sgn (value h x)); [right|destruct N; now left|left]; now exists (signs B x).
  - cbn beta. intros t (s & _ & <-) (s' & _ & ?). discriminate.
Qed.

(** Where it does not: no region ends, and those of B as well as their parts on h = 0. *)
Lemma independent_more v0 : none B v0 -> along h v0 <> 0 ->
  number (ends (h :: B)) 0 /\ forall s, ends B s <-> ends_on s.
Proof.
  intros N0 H0.
  assert (forall c v, none B (plus v c v0) <-> none B v) as NP.
  { intros c v. unfold none. rewrite !Forall_forall.
    split; intros F f I; specialize (F f I); rewrite along_plus, (proj1 (Forall_forall _ _) N0 f I) in *; lra. }
  assert (forall s c v, recedes B s v -> recedes B s (plus v c v0)) as RP.
  { intros s c v V. clear NP. revert N0. unfold recedes. induction V as [|f a B0 s0 T V IH]; intros N0; [constructor|].
    inversion N0 as [|? ? Z1 Z2]; subst. constructor; [|auto]. rewrite along_plus, Z1, Rmult_0_r, Rplus_0_r. exact T. }
  assert (forall s, length s = length B -> recedes B s origin) as RO.
  { clear. induction B as [|f B0 IH]; intros [|a s] E; try easy; constructor.
    - unfold along. rewrite linear_origin. destruct a; cbn; lra.
    - apply IH. now injection E. }
  split.
  - apply number_none. intros t [[(x & <-) N] F]. rewrite signs_cons in *.
    set (c := match sgn (value h x) with Minus => - / along h v0 | _ => / along h v0 end).
    assert (none (h :: B) (plus origin c v0)) as W.
    { apply F, recedes_cons. split.
      - rewrite along_plus. unfold along at 1. rewrite linear_origin. unfold c.
        destruct (sgn (value h x)); cbn.
        + replace (0 + - / along h v0 * along h v0) with (-1) by (field; trivial). lra.
        + destruct N. now left.
        + replace (0 + / along h v0 * along h v0) with 1 by (field; trivial). lra.
      - apply RP, RO. unfold signs. apply map_length. }
    apply none_cons in W as [W _]. rewrite along_plus in W. unfold along at 1 in W. rewrite linear_origin in W.
    unfold c in W. destruct (sgn (value h x)); [|destruct N; now left|];
    field_simplify in W; trivial; lra.
  - intros s. split.
    + intros [[(x & <-) N] F]. split; [split; trivial|intros v [_ V]; auto].
      exists (plus x (- value h x / along h v0) v0). split; [rewrite value_plus; field; trivial|].
      apply map_ext_in. intros f I. f_equal. rewrite value_plus, (proj1 (Forall_forall _ _) N0 f I). ring.
    + intros [C F]. split; [now apply cut_region|]. intros v V.
      apply (NP (- along h v / along h v0)), F. split; [rewrite along_plus; field; trivial|now apply RP].
Qed.

End More.

(** * On h = 0 *)

Lemma toward_times a p r : 0 < p -> (toward a (p * r) <-> toward a r).
Proof. intros P. destruct a; cbn; split; intros H; nra. Qed.

Lemma ends_below h j B B' : slope h j <> 0 -> Forall2 (below h j) B B' ->
  forall s, ends_on h B s <-> ends B' s.
Proof.
  intros S D s.
  assert (cuts h B s <-> region B' s) as C.
  { unfold cuts, region. rewrite (@below_face B B' h j S D s). reflexivity. }
  assert (forall v, along h v = 0 -> (none B v <-> none B' v) /\ (recedes B s v <-> recedes B' s v)) as Same.
  { intros v V. clear C. revert s. induction D as [|g g' B B' G D IH]; intros s; [split; reflexivity|].
    destruct (below_along G) as (p & P & A). specialize (A v). rewrite V, Rmult_0_l, Rminus_0_r in A.
    split.
    - destruct (IH []) as [N _]. rewrite !none_cons, N, A. split; intros []; split; trivial; nra.
    - destruct s as [|a s]; [split; intros H; inversion H|]. destruct (IH s) as [_ R].
      rewrite !recedes_cons, R, A, toward_times by trivial. reflexivity. }
  assert (forall v, exists w, along h w = 0 /\ forall f, In f B' -> along f w = along f v) as Flat.
  { intros v. exists (move v j (- along h v / slope h j)). split; [rewrite along_move; field; trivial|].
    intros f I. clear - I D S. induction D as [|g g' B B' G D IH]; [easy|]. destruct I as [<-|I]; [|now apply IH].
    destruct (below_along G) as (p & P & A). rewrite !A, !along_move. field. trivial. }
  split.
  - intros [R F]. split; [now apply C|]. intros v V. destruct (Flat v) as (w & W & E).
    assert (none B' w) as N.
    { apply (Same w W), F. split; trivial. apply (Same w W). clear - V E. revert E.
      unfold recedes in *. induction V as [|f a B' s T V IH]; intros E; constructor.
      - rewrite E; [exact T|now left].
      - apply IH. intros g G. apply E. now right. }
    unfold none in *. rewrite Forall_forall in *. intros f I. rewrite <- E by trivial. auto.
  - intros [R F]. split; [now apply C|]. intros v [V D1]. apply (Same v V), F, (Same v V), D1.
Qed.

Lemma ends_fills A B e n : fills A B e -> (forall s, In Zero (e s) <-> In Zero s) ->
  (forall v, none A v <-> none B v) -> number (ends B) n -> number (ends A) n.
Proof.
  intros [I E] Z N. apply number_image with (e := e); trivial.
  assert (forall x v, recedes A (signs A x) v <-> recedes B (signs B x) v) as R.
  { intros x v. split; intros D; apply stays_recedes with x; intros t T.
    - apply I. rewrite <- !E. now apply recedes_stays.
    - rewrite !E. f_equal. now apply recedes_stays. }
  intros u. split.
  - intros [[(x & <-) NZ] F]. exists (signs B x). split; [|now rewrite E]. split.
    + split; [now exists x|]. now rewrite <- Z, <- E.
    + intros v V. apply N, F, R, V.
  - intros (t & [[(x & <-) NZ] F] & <-). rewrite <- E. split.
    + split; [now exists x|]. now rewrite E, Z.
    + intros v V. apply N, F, R, V.
Qed.

(** * Rank *)

Lemma independent_more_forms gs g v : independent gs -> none gs v -> along g v <> 0 -> independent (g :: gs).
Proof.
  intros D N G [|a values] L; [easy|]. injection L as L. destruct (D values L) as (w & W).
  exists (plus w ((a - along g w) / along g v) v).
  change (map (fun f => along f (plus w ((a - along g w) / along g v) v)) (g :: gs) = a :: values). cbn.
  rewrite along_plus. f_equal; [field; trivial|]. rewrite <- W. apply map_ext_in. intros f I.
  rewrite along_plus, (proj1 (Forall_forall _ _) N f I). unfold along. ring.
Qed.

Lemma independent_less l1 h l2 : independent (l1 ++ h :: l2) -> independent (l1 ++ l2).
Proof.
  intros D values L. destruct (D (firstn (length l1) values ++ 0 :: skipn (length l1) values)) as (v & V).
  { rewrite !app_length in *. cbn. rewrite firstn_length, skipn_length. lia. }
  exists v. rewrite map_app in *. cbn in V. rewrite <- (firstn_skipn (length l1) values).
  assert (length (map (fun f => linear (coefficients f) v) l1) = length (firstn (length l1) values)) as Len.
  { rewrite map_length, firstn_length, app_length in *. lia. }
  revert V Len. generalize (map (fun f => linear (coefficients f) v) l1), (firstn (length l1) values).
  clear. intros l. induction l as [|a l IH]; intros [|b l'] V Len; try easy; cbn in *.
  - now injection V.
  - injection V as -> V. f_equal. apply IH; trivial. now injection Len.
Qed.

Lemma first_or_none T (h : T) B hs : incl hs (h :: B) -> In h hs \/ incl hs B.
Proof.
  induction hs as [|f hs IH]; intros J; [now right|].
  destruct (IH (fun g G => J g (or_intror G))) as [H|H]; [left; now right|].
  destruct (J f (or_introl eq_refl)) as [->|F]; [left; now left|right]. intros g [<-|G]; auto.
Qed.

Lemma rank_step B h k m : rank B k -> rank (h :: B) m ->
  m = k /\ (forall v, none B v -> along h v = 0) \/ m = S k /\ exists v, none B v /\ along h v <> 0.
Proof.
  intros [(gs & I & D & L) U] [(hs & J & E & M) W].
  assert (k <= m)%nat as Le by (rewrite <- L; apply W; trivial; now apply incl_tl).
  destruct (Nat.eq_dec m k) as [->|N]; [left|right].
  - split; trivial. intros v V. destruct (Req_dec (along h v) 0) as [|NZ]; trivial. exfalso.
    assert (length (h :: gs) <= k)%nat; [|cbn in *; lia]. apply W.
    + intros f [<-|F]; [now left|right; auto].
    + apply independent_more_forms with v; trivial. unfold none in *. rewrite Forall_forall in *. auto.
  - assert (In h hs) as H.
    { destruct (first_or_none J) as [H|H]; trivial. exfalso. pose proof (U hs H E). lia. }
    apply in_split in H as (l1 & l2 & ->).
    destruct (@independent_dual _ E l1 h l2 eq_refl) as (v & V & N1 & N2 & _).
    assert (none (l1 ++ l2) v) as NV by (apply Forall_app; now split).
    assert (incl (l1 ++ l2) B) as IB.
    { intros f F. destruct (J f) as [<-|]; trivial.
      - apply in_app_iff in F. apply in_app_iff. cbn. tauto.
      - pose proof (proj1 (Forall_forall _ _) NV h F) as Z. cbv beta in Z. lra. }
    pose proof (independent_less _ _ _ E) as D1. pose proof (U _ IB D1) as U1.
    rewrite app_length in *. cbn in M. split; [lia|]. exists v. split; [|rewrite V; lra].
    apply Forall_forall. intros g G. destruct (Req_dec (along g v) 0) as [|NZ]; trivial. exfalso.
    assert (length (g :: l1 ++ l2) <= k)%nat; [|cbn in *; rewrite app_length in *; lia]. apply U.
    + intros f [<-|F]; auto.
    + now apply independent_more_forms with v.
Qed.

(** * The number *)

Definition parity (k : nat) : Z := if Nat.even k then 1 else -1.

Lemma parity_next k : parity (S k) = (- parity k)%Z.
Proof. unfold parity. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even k). Qed.

(** A polynomial at 1: the sum of its coefficients. *)
Definition at_one (l : list Z) : Z := fold_right Z.add 0%Z l.

Lemma at_one_difference l : forall l', at_one (difference l l') = (at_one l - at_one l')%Z.
Proof.
  unfold at_one. induction l as [|a l IH]; [|intros [|b l']; cbn; rewrite ?IH; lia].
  induction l' as [|b l' IH]; cbn in *; rewrite ?IH; lia.
Qed.

Section Count.

Variable F : Type.
Variable look : F -> kind.
Variable restrict : F -> F -> F.
Variable real : F -> form R.

Hypothesis look_vanishes : forall f, look f = Vanishes -> forall x, value (real f) x = 0.
Hypothesis look_constant : forall f, look f = Constant ->
  exists c, c <> 0 /\ forall x, value (real f) x = c.
Hypothesis look_plane : forall h, look h = Plane -> exists j, slope (real h) j <> 0 /\
  forall g, below (real h) j (real g) (real (restrict h g)).

Let flat := @look_flat _ look real look_vanishes look_constant.

Lemma onto_in r B : forall B', onto look r B = Some B' ->
  forall f, In f B' <-> In f (map r B) /\ look f = Plane.
Proof.
  induction B as [|g B IH]; cbn; intros B' O f; [injection O as <-; cbn; tauto|].
  destruct (look (r g)) eqn:L; [easy| |].
  - rewrite (IH B' O f). split; [tauto|]. intros [[<-|] ?]; [congruence|tauto].
  - destruct (onto look r B) as [B1|]; [|easy]. injection O as <-. cbn. rewrite (IH B1 eq_refl f).
    split; [intros [<-|]; tauto|tauto].
Qed.

Lemma onto_flat r B B' : onto look r B = Some B' ->
  incl (map real B') (map real (map r B)) /\
  forall g, In g (map real (map r B)) -> In g (map real B') \/ forall v, along g v = 0.
Proof.
  intros O. split.
  - intros g (f & <- & I)%in_map_iff. apply in_map_iff. exists f. split; trivial. now apply (@onto_in r B B' O f).
  - intros g (f & <- & I)%in_map_iff. destruct (look f) eqn:L.
    1, 2: right; apply flat; congruence.
    left. apply in_map_iff. exists f. split; trivial. now apply (@onto_in r B B' O f).
Qed.

Lemma none_flat A B v : incl B A -> (forall g, In g A -> In g B \/ forall v, along g v = 0) ->
  (none A v <-> none B v).
Proof.
  intros I M. unfold none. rewrite !Forall_forall. split; intros H f G; auto. destruct (M f G); auto.
Qed.

Lemma ends_count n : forall B k, (length B <= n)%nat -> rank (map real B) k ->
  number (ends (map real B)) (parity k * at_one (polynomial look restrict n B)).
Proof.
  assert (forall k n, rank (map real []) k ->
    number (ends (map real [])) (parity k * at_one (polynomial look restrict n []))) as Nil.
  { intros k m R. rewrite (rank_unique R rank_nil).
    replace (parity 0 * at_one (polynomial look restrict m []))%Z with 1%Z by now destruct m.
    apply number_one with (a := []). intros s. split.
    - intros [[(x & <-) _] _]. reflexivity.
    - intros ->. split; [split; [now exists origin|easy]|constructor]. }
  induction n as [|n IH]; intros [|h B] k L R; try (now apply Nil); [cbn in L; lia|].
  cbn in L. cbn [polynomial map] in *. destruct (look h) eqn:K.
  - rewrite Z.mul_0_r. apply number_none. intros s [[(x & <-) N] _]. apply N. left.
    now apply sgn_zero, look_vanishes.
  - destruct (@constant_sign _ look real look_constant h K) as (s & N & S).
    apply ends_fills with (B := map real B) (e := fun t => s :: t).
    + apply fills_constant; trivial. apply fills_refl.
    + intros t. cbn. split; [intros [|]; easy|auto].
    + intros v. apply (@none_flat (real h :: map real B) (map real B) v); [intros g G; now right|]. intros g [<-|G]; [right; apply flat; congruence|now left].
    + apply IH; [lia|]. apply (@rank_more (map real B) (real h :: map real B) k); trivial; [intros g G; now right|].
      intros g [<-|G]; [right; apply flat; congruence|now left].
  - destruct (look_plane K) as (j & S & D). pose proof (@all_below _ restrict real h j B D) as Below.
    destruct (@rank_exists _ look restrict real look_vanishes look_constant look_plane _ B (le_n _)) as (kB & RB).
    destruct (@rank_exists _ look restrict real look_vanishes look_constant look_plane _ (map (restrict h) B) (le_n _))
      as (kR & RR).
    pose proof (rank_unique R (rank_below S Below RR)) as ->.
    set (q := match onto look (restrict h) B with None => [] | Some B' => 0%Z :: polynomial look restrict n B' end).
    assert (number (ends_on (real h) (map real B)) (parity kR * at_one q)) as On.
    { eapply number_iff; [intros s; symmetry; apply (ends_below S Below s)|]. unfold q.
      destruct (onto look (restrict h) B) as [B'|] eqn:O.
      - destruct (@onto_some _ look real look_constant _ _ _ O) as (e & Fe & Z & Len).
        destruct (@onto_flat _ _ _ O) as [Inc Fl].
        apply ends_fills with (1 := Fe) (2 := Z); [intros v; now apply none_flat|].
        apply IH; [lia|]. now apply (@rank_more (map real B') (map real (map (restrict h) B)) kR).
      - cbn. rewrite Z.mul_0_r. apply number_none. intros s [[(x & <-) N] _].
        apply N. now apply (@onto_none _ look real look_vanishes (restrict h) B O). }
    rewrite at_one_difference.
    pose proof (IH B kB ltac:(lia) RB) as NB.
    destruct (rank_step RB R) as [[<- Dep]|[E (v & V & W)]].
    + pose proof (@regions_count _ look restrict real look_vanishes look_constant look_plane _ B (le_n _)) as Reg.
      assert (exists c, number (cuts (real h) (map real B)) c) as (c & Cuts).
      { destruct (onto look (restrict h) B) as [B'|] eqn:O.
        - destruct (@onto_some _ look real look_constant _ _ _ O) as (e & Fe & Z & Len).
          exists (regions look restrict (length B') B').
          eapply number_iff; [|apply (fills_region Fe Z), (@regions_count _ look restrict real look_vanishes
            look_constant look_plane _ B' (le_n _))].
          intros s. unfold cuts, region. now rewrite (below_face S Below s).
        - exists 0%Z. apply number_none. intros s [(x & X & <-) N].
          assert (face (map real (map (restrict h) B)) (signs (map real B) x)) as (y & Y)
            by (apply (below_face S Below); now exists x).
          apply N. rewrite <- Y. now apply (@onto_none _ look real look_vanishes (restrict h) B O). }
      pose proof (@dependent_more (real h) j (map real B) S _ _ _ Dep Reg Cuts On _ NB) as Sum.
      replace (parity (Datatypes.S kR) * (at_one (polynomial look restrict n B) - at_one q))%Z with
        (parity (Datatypes.S kR) * at_one (polynomial look restrict n B) + parity kR * at_one q)%Z; trivial.
      rewrite parity_next. ring.
    + injection E as <-. destruct (@independent_more (real h) (map real B) v V W) as [None Same].
      assert (parity kR * at_one (polynomial look restrict n B) = parity kR * at_one q)%Z as Eq.
      { apply (@number_unique _ (ends_on (real h) (map real B))); trivial. revert NB. now apply number_iff. }
      replace (at_one (polynomial look restrict n B) - at_one q)%Z with 0%Z; [now rewrite Z.mul_0_r|].
      revert Eq. unfold parity. destruct (Nat.even kR); lia.
Qed.

End Count.

(** The program's polynomial at 1, but for its sign, is the number of bounded regions. *)
Theorem bounded_counted : forall planes,
  number (bounded (real_planes planes)) (Z.abs (at_one (characteristic_polynomial planes))).
Proof.
  intros planes.
  destruct (@rank_exists _ look restrict real_form look_vanishes look_constant look_plane _ planes (le_n _)) as (k & R).
  pose proof (@ends_count _ look restrict real_form look_vanishes look_constant look_plane _ planes k (le_n _) R) as N.
  fold (characteristic_polynomial planes) in N.
  eapply number_iff; [intros s; symmetry; apply ends_bounded|].
  pose proof (number_nonneg N) as P. replace (Z.abs _) with
    (parity k * at_one (characteristic_polynomial planes))%Z; [exact N|].
  revert P. unfold parity. destruct (Nat.even k); lia.
Qed.

(** A direction in which forms of the rank of the space do not change is 0. *)
Lemma no_direction d planes v : of_space d planes -> rank planes d ->
  (forall f, In f planes -> along f v = 0) -> forall i, (i < d)%nat -> v i = 0.
Proof.
  intros Sp [(gs & I & D & L) _] H i Li.
  destruct (Req_dec (v i) 0) as [|NZ]; trivial. exfalso.
  pose (e := Form 0 (repeat 0 i ++ 1 :: repeat 0 (d - S i))).
  assert (forall a n w, linear (repeat 0 n ++ a) w = linear a (fun k => w (n + k)%nat)) as Shift.
  { intros a n. induction n as [|n IH]; intros w; [reflexivity|]. cbn. rewrite IH. ring. }
  assert (forall n w, linear (repeat 0 n) w = 0) as Zeros.
  { intros n. induction n as [|n IH]; intros w; cbn; trivial. rewrite IH. ring. }
  assert (along e v = v i) as E.
  { unfold along, e. cbn [coefficients]. rewrite Shift. cbn. rewrite Zeros, Nat.add_0_r. ring. }
  assert (independent (e :: gs)) as Ind.
  { apply independent_more_forms with v; trivial; [|now rewrite E].
    apply Forall_forall. intros f F. now apply H, I. }
  pose (centred := fun f : form R => Form 0 (coefficients f)).
  assert (independent (map centred (e :: gs))) as Ind0.
  { intros values Lv. rewrite map_length in Lv. destruct (Ind values Lv) as (w & W). exists w.
    rewrite map_map. exact W. }
  assert (of_space d (map centred (e :: gs))) as Sp0.
  { apply Forall_map. constructor; cbn.
    - rewrite app_length, repeat_length. cbn. rewrite repeat_length. lia.
    - apply Forall_forall. intros f F. apply (proj1 (Forall_forall _ _) Sp), I, F. }
  assert (Forall central (map centred (e :: gs))) as C0 by (apply Forall_map, Forall_forall; reflexivity).
  destruct (@rank_exists _ look_real restrict_real (fun f => f) look_real_vanishes
    look_real_constant look_real_plane _ (map centred (e :: gs)) (le_n _)) as [k Rank].
  rewrite map_id in Rank. pose proof Rank as [_ U].
  pose proof (U _ (incl_refl _) Ind0) as Len. rewrite map_length in Len. cbn in Len.
  pose proof (@origin_face _ k C0 Rank) as One.
  pose proof (@deep_faces d _ k Sp0 C0 ltac:(lia)) as Deep.
  destruct (Nat.eqb_spec k d); lia.
Qed.

(** Where the forms have the rank of the space, no half-line at all is in a bounded region. *)
Theorem no_half_line : forall d planes s v, of_space d planes -> rank planes d ->
  bounded planes s -> half_line planes s v -> forall i, (i < d)%nat -> v i = 0.
Proof. intros d planes s v Sp R [_ H] Half. exact (no_direction v Sp R (H v Half)). Qed.

(** Planes through the origin have no bounded region, where there are any. *)
Theorem central_unbounded : forall planes, planes <> [] -> Forall central planes ->
  number (bounded planes) 0.
Proof.
  intros [|f planes] N C; [easy|]. apply number_none. intros s [[(x & <-) Z] H]. apply Z. left.
  inversion C as [|? ? Cf _]; subst. apply sgn_zero. unfold value. rewrite Cf, (H x); [ring| |now left].
  exists x. intros t T. change (signs (f :: planes) (plus x t x) = signs (f :: planes) x).
  apply recedes_stays; trivial. clear - C. unfold recedes, signs. induction C as [|g l Cg C IH]; constructor; trivial.
  unfold value, central in *. rewrite Cg, Rplus_0_l. fold (along g x).
  destruct (sgn (along g x)) eqn:E; cbn; rewrite ?sgn_minus, ?sgn_zero, ?sgn_plus in E; lra.
Qed.
