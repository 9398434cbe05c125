(** The dual graph of planes, no two of which coincide: its edges and its distances. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Merge.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Signs that differ *)

Lemma separating_none s : forall t, length s = length t -> separating s t = O -> s = t.
Proof.
  induction s as [|a s IH]; intros [|b t]; cbn; trivial; try easy.
  destruct (sign_eq_dec a b); [|easy]. intros [= L] E. subst. f_equal. auto.
Qed.

Lemma separating_self s : separating s s = O.
Proof. induction s as [|a s IH]; cbn; trivial. now destruct (sign_eq_dec a a). Qed.

Lemma separating_triangle s : forall t u, length s = length t -> length t = length u ->
  (separating s u <= separating s t + separating t u)%nat.
Proof.
  induction s as [|a s IH]; intros [|b t] [|c u]; cbn; try lia; try easy. intros [= L] [= L'].
  specialize (IH t u L L').
  destruct (sign_eq_dec a b), (sign_eq_dec b c), (sign_eq_dec a c); subst; try easy; lia.
Qed.

(** Each sign of [u] is that of [s] or that of [t]. *)
Definition amid (s u t : list sign) : Prop :=
  length s = length u /\ length u = length t /\ separating s t = (separating s u + separating u t)%nat.

Lemma amid_cons a b c s u t : b = a \/ b = c -> amid s u t -> amid (a :: s) (b :: u) (c :: t).
Proof.
  intros B (L & L' & E). unfold amid. cbn. rewrite L, L', E. repeat split.
  destruct B; subst; destruct (sign_eq_dec a a); try easy; destruct (sign_eq_dec c c); try easy;
  destruct (sign_eq_dec a c); lia.
Qed.

(** * A point of a region that is on none of given planes *)

Lemma avoid C : forall B x, ~ In Zero (signs B x) ->
  (forall f, In f C -> ~ forall y, value f y = 0) ->
  exists y, signs B y = signs B x /\ ~ In Zero (signs C y).
Proof.
  induction C as [|c C IH]; intros B x N H.
  - exists x. split; [trivial|easy].
  - destruct (IH B x N) as (y & E & NC); [intros f F; apply H; now right|].
    destruct (Req_dec (value c y) 0) as [Z|Z].
    + assert (look_real c = Plane) as K.
      { destruct (look_real c) eqn:K; trivial; exfalso.
        - apply (H c (or_introl eq_refl)). now apply look_real_vanishes.
        - destruct (@look_real_constant c K) as (r & R & V). rewrite V in Z. easy. }
      destruct (@both_sides (B ++ C) c y _ (@look_real_slope c K) Z) as [(z & Ez & Vz) _].
      { unfold signs in *. rewrite map_app, in_app_iff, E. tauto. }
      unfold signs in *. rewrite !map_app in Ez.
      assert (map (fun f => sgn (value f z)) B = map (fun f => sgn (value f y)) B /\
        map (fun f => sgn (value f z)) C = map (fun f => sgn (value f y)) C) as [EB EC].
      { clear - Ez. induction B as [|b B IH]; cbn in *; [now split|].
        injection Ez as E1 E2. destruct (IH E2). split; [now f_equal|trivial]. }
      exists z. split; [congruence|]. cbn. rewrite EC. intros [S|S]; [|easy].
      apply sgn_zero in S. lra.
    + exists y. split; trivial. rewrite signs_cons. intros [S|S]; [|easy]. now apply sgn_zero in S.
Qed.

(** * Between two regions *)

Definition apart_at (x y : point) (f : form R) : Prop := sgn (value f x) <> sgn (value f y).

Lemma two_planes A x y : (2 <= separating (signs A x) (signs A y))%nat ->
  exists f g B, incl (f :: g :: B) A /\ (different A -> ~ same_plane f g) /\
    apart_at x y f /\ apart_at x y g.
Proof.
  induction A as [|f A IH]; cbn; [intros; lia|].
  destruct (sign_eq_dec (sgn (value f x)) (sgn (value f y))) as [E|N]; intros L.
  - destruct (IH L) as (g & h & B & I & D & G & H). exists g, h, B. repeat split; trivial.
    + intros k K. right. now apply I.
    + intros O. inversion O; subst. now apply D.
  - assert (exists g, In g A /\ apart_at x y g) as (g & G & S).
    { assert (1 <= separating (signs A x) (signs A y))%nat as L1 by (unfold signs; lia). clear - L1.
      induction A as [|g A IH]; cbn in L1; [lia|].
      destruct (sign_eq_dec (sgn (value g x)) (sgn (value g y))) as [E|N].
      - destruct (IH L1) as (h & H & S). exists h. split; [now right|trivial].
      - exists g. split; [now left|trivial]. }
    exists f, g, []. repeat split; trivial.
    + intros k [<-|[<-|[]]]; [now left|now right].
    + intros O. inversion O as [|? ? O1 _]; subst. rewrite Forall_forall in O1. now apply O1.
Qed.

(** g y (f x) - f y (g x), as a form of x. *)
Definition tie (f g : form R) (y : point) : form R :=
  Form (value g y * constant f - value f y * constant g)
    (less (value f y) (map (Rmult (value g y)) (coefficients f)) (coefficients g)).

Lemma value_tie f g y x : value (tie f g y) x = value g y * value f x - value f y * value g x.
Proof.
  unfold tie, value at 1. cbn [constant coefficients]. rewrite linear_less.
  assert (linear (map (Rmult (value g y)) (coefficients f)) x = value g y * linear (coefficients f) x) as ->.
  { generalize (value g y). intros r. revert x. induction (coefficients f) as [|c a IH]; intros x; cbn; [ring|].
    rewrite IH. ring. }
  unfold value. ring.
Qed.

(** Where the segment from x to y crosses f = 0, as the part of it that lies before. *)
Definition crossing (f : form R) (x y : point) : R := value f x / (value f x - value f y).

Lemma sides_apart f x y : apart_at x y f -> value f x <> 0 -> value f y <> 0 ->
  0 < crossing f x y < 1 /\
  forall t, 0 < t < 1 ->
    (t < crossing f x y -> sgn (value f (blend t x y)) = sgn (value f x)) /\
    (crossing f x y < t -> sgn (value f (blend t x y)) = sgn (value f y)).
Proof.
  intros N X Y. unfold apart_at in N.
  assert (value f x - value f y <> 0) as D.
  { intros E. apply N. f_equal. lra. }
  set (c := crossing f x y).
  assert (value f x = c * (value f x - value f y)) as C by (unfold c, crossing; field; trivial).
  assert (forall t, value f (blend t x y) = (c - t) * (value f x - value f y)) as V.
  { intros t. rewrite value_blend. replace ((c - t) * (value f x - value f y)) with
      (c * (value f x - value f y) - t * (value f x - value f y)) by ring. rewrite <- C. ring. }
  destruct (Rdichotomy _ _ X) as [X1|X1], (Rdichotomy _ _ Y) as [Y1|Y1].
  - exfalso. apply N. now rewrite (proj2 (sgn_minus _) X1), (proj2 (sgn_minus _) Y1).
  - rewrite (proj2 (sgn_minus _) X1), (proj2 (sgn_plus _) Y1).
    split; [split; nra|]. intros t T. split; intros H; rewrite V; [apply sgn_minus|apply sgn_plus]; nra.
  - rewrite (proj2 (sgn_plus _) X1), (proj2 (sgn_minus _) Y1).
    split; [split; nra|]. intros t T. split; intros H; rewrite V; [apply sgn_plus|apply sgn_minus]; nra.
  - exfalso. apply N. now rewrite (proj2 (sgn_plus _) X1), (proj2 (sgn_plus _) Y1).
Qed.

Lemma not_zero A x f : ~ In Zero (signs A x) -> In f A -> value f x <> 0.
Proof.
  intros N F E. apply N. unfold signs. apply in_map_iff. exists f. split; trivial. now apply sgn_zero.
Qed.

Lemma halfway A s t : different A -> region A s -> region A t -> (2 <= separating s t)%nat ->
  exists u, region A u /\ amid s u t /\ (1 <= separating s u)%nat /\ (1 <= separating u t)%nat.
Proof.
  intros D [(x0 & X0) NS] [(y & Y) NT] L. subst s t.
  destruct (@two_planes A x0 y L) as (f & g & B & I & Df & Af & Ag). specialize (Df D).
  assert (In f A /\ In g A) as [Fi Gi] by (split; apply I; cbn; auto).
  pose proof (@not_zero A y f NT Fi) as Fy. pose proof (@not_zero A y g NT Gi) as Gy.
  destruct (@avoid [tie f g y] A x0 NS) as (x & Ex & Nx).
  { intros h [<-|[]] Z. apply Df. exists (value g y / value f y). split.
    - apply Rmult_integral_contrapositive_currified; [trivial|now apply Rinv_neq_0_compat].
    - intros z. specialize (Z z). rewrite value_tie in Z.
      apply Rmult_eq_reg_l with (value f y); trivial. field_simplify; trivial. lra. }
  assert (value (tie f g y) x <> 0) as Tie by (apply (@not_zero [tie f g y]); trivial; now left).
  rewrite value_tie in Tie.
  assert (apart_at x y f /\ apart_at x y g) as [Sf Sg].
  { unfold apart_at in *. split; [now rewrite (map_at Ex Fi)|now rewrite (map_at Ex Gi)]. }
  rewrite <- Ex in *. clear x0 Ex Nx Af Ag.
  pose proof (@not_zero A x f NS Fi) as Fx. pose proof (@not_zero A x g NS Gi) as Gx.
  destruct (sides_apart Sf Fx Fy) as [Cf Hf]. destruct (sides_apart Sg Gx Gy) as [Cg Hg].
  assert (crossing f x y <> crossing g x y) as Ne.
  { unfold crossing. intros E.
    assert (value f x - value f y <> 0) by (intros Z; apply Sf; f_equal; lra).
    assert (value g x - value g y <> 0) by (intros Z; apply Sg; f_equal; lra).
    apply Tie. apply (f_equal (fun r => r * ((value f x - value f y) * (value g x - value g y)))) in E.
    replace (value f x / (value f x - value f y) * ((value f x - value f y) * (value g x - value g y)))
      with (value f x * (value g x - value g y)) in E by (field; trivial).
    replace (value g x / (value g x - value g y) * ((value f x - value f y) * (value g x - value g y)))
      with (value g x * (value f x - value f y)) in E by (field; trivial). lra. }
  set (m := (crossing f x y + crossing g x y) / 2).
  assert (0 < m < 1) as M by (unfold m; lra).
  (* Off the planes that the midpoint may be on, without a change of other signs. *)
  pose (B0 := filter (fun h => if Req_EM_T (value h (blend m x y)) 0 then false else true) A).
  assert (~ In Zero (signs B0 (blend m x y))) as NB.
  { unfold signs. intros (h & Z & H)%in_map_iff. apply sgn_zero in Z. unfold B0 in H.
    apply filter_In in H as [_ H]. now destruct (Req_EM_T _ 0). }
  destruct (@avoid A B0 (blend m x y) NB) as (z & Ez & Nz).
  { intros h H Z. now apply (@not_zero A x h NS H). }
  assert (forall h, In h A -> value h (blend m x y) <> 0 -> sgn (value h z) = sgn (value h (blend m x y))) as Keep.
  { intros h H V. assert (In h B0) as HB.
    { unfold B0. apply filter_In. split; trivial. now destruct (Req_EM_T _ 0). }
    unfold signs in Ez. now apply (map_at Ez). }
  exists (signs A z). split; [split; [now exists z|trivial]|].
  assert (amid (signs A x) (signs A z) (signs A y)) as Am.
  { assert (forall h, In h A -> sgn (value h z) = sgn (value h x) \/ sgn (value h z) = sgn (value h y)) as Each.
    { intros h H. pose proof (@not_zero A x h NS H) as Hx. pose proof (@not_zero A y h NT H) as Hy.
      destruct (sign_eq_dec (sgn (value h x)) (sgn (value h y))) as [E|N].
      - left. pose proof (@sgn_blend h m x y M E) as S. rewrite Keep; trivial.
        intros Z. rewrite Z in S. rewrite (proj2 (sgn_zero 0) eq_refl) in S. symmetry in S. now apply sgn_zero in S.
      - pose proof (@not_zero A z h Nz H) as Hz.
        destruct (sgn (value h z)) eqn:Sz, (sgn (value h x)) eqn:Sx, (sgn (value h y)) eqn:Sy; auto;
        rewrite ?sgn_zero in *; easy. }
    clear - Each. induction A as [|h A IH]; [now repeat split|]. cbn. apply amid_cons.
    - apply Each. now left.
    - apply IH. intros k K. apply Each. now right. }
  split; [exact Am|].
  assert (forall h, In h A -> forall p q, sgn (value h p) <> sgn (value h q) ->
    (1 <= separating (signs A p) (signs A q))%nat) as One.
  { clear. intros h H p q N. induction A as [|k A IH]; [easy|]. cbn.
    destruct (sign_eq_dec (sgn (value k p)) (sgn (value k q))); [|lia].
    destruct H as [->|H]; [easy|auto]. }
  assert (forall k, (k = f \/ k = g) -> In k A /\ value k x <> 0 /\ value k y <> 0 /\ apart_at x y k)
    as Kind by (intros k [->| ->]; auto).
  assert (forall p q, (p = f /\ q = g) \/ (p = g /\ q = f) -> crossing p x y < crossing q x y ->
    (1 <= separating (signs A x) (signs A z))%nat /\ (1 <= separating (signs A z) (signs A y))%nat) as Both.
  { intros p q Pq Less.
    destruct (Kind p ltac:(tauto)) as (Ip & Px & Py & Sp). destruct (Kind q ltac:(tauto)) as (Iq & Qx & Qy & Sq).
    destruct (sides_apart Sp Px Py) as [_ Hp]. destruct (sides_apart Sq Qx Qy) as [_ Hq].
    assert (crossing p x y < m < crossing q x y) as Mid by (unfold m; destruct Pq as [[-> ->]|[-> ->]]; lra).
    destruct (Hp m M) as [_ P1]. destruct (Hq m M) as [Q1 _]. specialize (P1 ltac:(lra)). specialize (Q1 ltac:(lra)).
    assert (value p (blend m x y) <> 0 /\ value q (blend m x y) <> 0) as [Vp Vq].
    { split; intros Z.
      - rewrite Z, (proj2 (sgn_zero 0) eq_refl) in P1. symmetry in P1. now apply sgn_zero in P1.
      - rewrite Z, (proj2 (sgn_zero 0) eq_refl) in Q1. symmetry in Q1. now apply sgn_zero in Q1. }
    split; [apply (One p Ip)|apply (One q Iq)].
    - rewrite (Keep p Ip Vp), P1. exact Sp.
    - rewrite (Keep q Iq Vq), Q1. exact Sq. }
  destruct (Rtotal_order (crossing f x y) (crossing g x y)) as [H|[H|H]]; [|easy|].
  - apply (Both f g); auto.
  - apply (Both g f); auto.
Qed.

(** * Facets *)

Lemma one_differs A x y : separating (signs A x) (signs A y) = 1%nat ->
  exists l1 f l2, A = l1 ++ f :: l2 /\ apart_at x y f /\ signs l1 x = signs l1 y /\ signs l2 x = signs l2 y.
Proof.
  induction A as [|f A IH]; [easy|]. rewrite !signs_cons. cbn [separating].
  destruct (sign_eq_dec (sgn (value f x)) (sgn (value f y))) as [E|N]; intros L.
  - destruct (IH L) as (l1 & g & l2 & -> & G & E1 & E2). exists (f :: l1), g, l2.
    repeat split; trivial. rewrite !signs_cons. now rewrite E, E1.
  - exists [], f, A. repeat split; trivial. injection L as L. apply separating_none; trivial.
    unfold signs. now rewrite !map_length.
Qed.

Lemma zeros_app x A B : zeros x (A ++ B) = zeros x A ++ zeros x B.
Proof.
  induction A as [|f A IH]; trivial. cbn [app]. rewrite !zeros_cons, IH. now destruct (sgn (value f x)).
Qed.

Lemma no_zeros x A : ~ In Zero (signs A x) -> zeros x A = [].
Proof.
  induction A as [|f A IH]; trivial. rewrite signs_cons, zeros_cons. cbn. intros N.
  destruct (sgn (value f x)); try (apply IH; tauto). now destruct N; left.
Qed.

Lemma rank_one f : look_real f = Plane -> rank [f] 1.
Proof.
  intros K. split; [exists [f]; repeat split; [easy|now apply independent_one]|].
  intros gs I Ind. destruct gs as [|g [|g' gs]]; cbn; try lia. exfalso.
  destruct (I g) as [<-|[]]; [now left|]. destruct (I g') as [<-|[]]; [now right; left|].
  destruct (Ind (0 :: 1 :: map (fun _ => 0) gs)) as (v & V); [cbn; now rewrite map_length|].
  injection V as V1 V2 _. lra.
Qed.

Lemma facet_between A s t : region A s -> region A t -> separating s t = 1%nat -> share_facet A s t.
Proof.
  intros [(x & <-) NS] [(y & <-) NT] L.
  destruct (one_differs _ _ _ L) as (l1 & f & l2 & E & Ap & E1 & E2).
  assert (In f A) as F by (rewrite E; apply in_app_iff; cbn; auto).
  pose proof (@not_zero A x f NS F) as X. pose proof (@not_zero A y f NT F) as Y.
  split; [intros Eq; rewrite Eq, separating_self in L; easy|].
  destruct (sides_apart Ap X Y) as [C _]. set (z := blend (crossing f x y) x y).
  assert (value f z = 0) as Z.
  { unfold z. rewrite value_blend. unfold crossing. field. intros D. apply Ap. f_equal. lra. }
  assert (signs l1 z = signs l1 x /\ signs l2 z = signs l2 x) as [Z1 Z2].
  { split; now apply signs_blend. }
  exists (signs A z). split; [split; [now exists z|]|].
  - change (rank (zeros z A) 1). rewrite E, zeros_app, zeros_cons, Z, (proj2 (sgn_zero 0) eq_refl).
    assert (zeros z l1 = [] /\ zeros z l2 = []) as [-> ->].
    { rewrite E in NS. unfold signs in NS. rewrite map_app, in_app_iff in NS. cbn in NS.
      split; apply no_zeros; [rewrite Z1|rewrite Z2]; tauto. }
    apply rank_one. destruct (look_real f) eqn:K; trivial; exfalso.
    + apply X. now apply look_real_vanishes.
    + destruct (@look_real_constant f K) as (c & N & V). now rewrite V in Z.
  - assert (forall l p q, signs l p = signs l q -> borders (signs l p) (signs l q)) as Same.
    { clear. intros l p q ->. unfold borders. induction (signs l q); constructor; auto. }
    unfold borders. rewrite E. unfold signs. rewrite !map_app. cbn. rewrite Z, (proj2 (sgn_zero 0) eq_refl).
    split; apply Forall2_app; try (constructor; [now left|]); apply Same; congruence.
Qed.

(** Two planes through a point that is on a face of codimension 1 are one. *)
Lemma one_plane A x f g : rank (zeros x A) 1 -> In f (zeros x A) -> In g (zeros x A) ->
  look_real f = Plane -> look_real g = Plane -> same_plane f g.
Proof.
  intros [_ U] F G Kf Kg. pose proof (proj1 (zeros_spec x A f) F) as [_ Zf].
  pose proof (proj1 (zeros_spec x A g) G) as [_ Zg].
  destruct (look_real (restrict_real g f)) eqn:K.
  - destruct (@vanishing_times g f Kg Kf K) as (c & N & T). now exists c.
  - exfalso. destruct (@look_real_constant _ K) as (c & N & V).
    destruct (@restrict_real_below g f Kg) as (p & P & W). specialize (W x).
    rewrite V, value_foot, Zf, Zg in W. apply N. rewrite W. ring.
  - pose proof (U [g; f]) as H. cbn in H. enough (2 <= 1)%nat by lia. apply H.
    + intros h [<-|[<-|[]]]; trivial.
    + now apply independent_two.
Qed.

Lemma borders_length u s : borders u s -> length u = length s.
Proof. unfold borders. induction 1; cbn; auto. Qed.

Lemma facet_one_sign A s t : different A -> region A s -> region A t -> share_facet A s t ->
  separating s t = 1%nat.
Proof.
  intros D Rs Rt (N & u & [(z & <-) R] & Bs & Bt). change (rank (zeros z A) 1) in R.
  assert (forall f, In f A -> look_real f <> Vanishes) as Plain.
  { intros f F K. destruct Rs as [(x & <-) NS]. now apply (@not_zero A x f NS F), look_real_vanishes. }
  assert (forall f, In f A -> value f z = 0 -> look_real f = Plane) as Planes.
  { intros f F Z. destruct (look_real f) eqn:K; trivial; [now destruct (Plain f F)|].
    destruct (@look_real_constant f K) as (c & C & V). now rewrite V in Z. }
  assert (separating s t <= 1)%nat as Le.
  { assert (forall f g, In f (zeros z A) -> In g (zeros z A) -> same_plane f g) as Same.
    { intros f g F G. apply one_plane with A z; trivial; apply Planes;
      (now apply zeros_spec in F) || now apply zeros_spec in G. }
    clear - D Bs Bt Same. revert s t Bs Bt. induction D as [|f A Df D IH]; intros s t Bs Bt.
    - inversion Bs; subst. cbn. lia.
    - rewrite signs_cons in *. inversion Bs as [|? a ? s' A1 Bs1]; subst. inversion Bt as [|? b ? t' A2 Bt1]; subst.
      cbn [separating].
      assert (separating s' t' <= 1)%nat as H.
      { apply IH; trivial. intros g h G H. apply Same; rewrite zeros_cons;
        destruct (sgn (value f z)); trivial; now right. }
      destruct (sign_eq_dec a b) as [|Ne]; [exact H|].
      assert (sgn (value f z) = Zero) as Z by (destruct A1, A2; congruence).
      enough (separating s' t' = 0)%nat by lia.
      assert (~ In Zero (signs A z)) as NZ.
      { intros (g & G & I)%in_map_iff. rewrite Forall_forall in Df. apply (Df g I).
        apply Same; rewrite zeros_cons, Z; [now left|right]. apply zeros_spec.
        split; trivial. now apply sgn_zero. }
      assert (forall v w, borders v w -> ~ In Zero v -> w = v) as Eq.
      { clear. intros v w B. induction B as [|a b v w H B IH]; trivial. cbn. intros N.
        destruct H as [->| ->]; [tauto|]. f_equal. tauto. }
      rewrite (Eq _ _ Bs1 NZ), (Eq _ _ Bt1 NZ). apply separating_self. }
  assert (length s = length t) as Len.
  { rewrite <- (borders_length Bs). apply (borders_length Bt). }
  destruct (separating s t) as [|[|k]] eqn:E; trivial; [|lia].
  now destruct N; apply separating_none.
Qed.

(** * Distances *)

Lemma region_length A s : region A s -> length s = length A.
Proof. intros [(x & <-) _]. apply map_length. Qed.

Lemma walk_regions A s t n : walk A s t n -> region A s /\ region A t.
Proof. induction 1; tauto. Qed.

Lemma walk_append A s t u n k : walk A s t n -> walk A t u k -> walk A s u (n + k).
Proof. induction 1 as [|s t v n R F W IH]; trivial. intros H. cbn. apply step with t; auto. Qed.

Lemma walk_long A s t n : different A -> walk A s t n -> (separating s t <= n)%nat.
Proof.
  intros D. induction 1 as [s R|s t u n R F W IH]; [now rewrite separating_self|].
  destruct (walk_regions W) as [Rt Ru].
  pose proof (facet_one_sign D R Rt F). pose proof (@separating_triangle s t u) as T.
  rewrite (region_length R), (region_length Rt), (region_length Ru) in T. specialize (T eq_refl eq_refl). lia.
Qed.

Lemma walk_straight A : different A -> forall n s t, region A s -> region A t ->
  (separating s t <= n)%nat -> walk A s t (separating s t).
Proof.
  intros D. induction n as [|n IH]; intros s t Rs Rt L;
  destruct (separating s t) as [|[|k]] eqn:E; try lia.
  1, 2: assert (s = t) as -> by (apply separating_none; trivial;
    now rewrite (region_length Rs), (region_length Rt)); now apply stay.
  - apply step with t; trivial; [now apply facet_between|now apply stay].
  - destruct (@halfway A s t D Rs Rt ltac:(lia)) as (u & Ru & (_ & _ & Sum) & P & Q).
    rewrite E in Sum. rewrite Sum.
    apply walk_append with u; apply IH; trivial; lia.
Qed.

(** * Two classes *)

Lemma minus_parity s : forall t, ~ In Zero s -> ~ In Zero t -> length s = length t ->
  Nat.even (minus_signs s + minus_signs t) = Nat.even (separating s t).
Proof.
  induction s as [|a s IH]; intros [|b t] Ns Nt E; try easy. cbn [separating minus_signs].
  assert (Nat.even (minus_signs s + minus_signs t) = Nat.even (separating s t)) as H.
  { apply IH; [intros I; apply Ns; now right|intros I; apply Nt; now right|now injection E]. }
  assert (a <> Zero) by (intros ->; apply Ns; now left).
  assert (b <> Zero) by (intros ->; apply Nt; now left).
  rewrite Nat.even_add in H.
  destruct a, b; try easy; cbn [sign_eq_dec sign_rec sign_rect]; rewrite ?Nat.even_add, ?Nat.even_succ,
    <- ?Nat.negb_even, <- H; destruct (Nat.even (minus_signs s)), (Nat.even (minus_signs t)); reflexivity.
Qed.

Lemma two_classes A s t : different A -> region A s -> region A t -> share_facet A s t ->
  Nat.even (minus_signs s) <> Nat.even (minus_signs t).
Proof.
  intros D Rs Rt F. pose proof (@minus_parity s t (proj2 Rs) (proj2 Rt)) as H.
  rewrite (region_length Rs), (region_length Rt), (facet_one_sign D Rs Rt F), Nat.even_add in H.
  specialize (H eq_refl). now destruct (Nat.even (minus_signs s)), (Nat.even (minus_signs t)).
Qed.
