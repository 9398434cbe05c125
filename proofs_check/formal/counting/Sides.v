(** Foot, between, near: how sign vectors change from one plane to the next. *)

Require Import Reals ZArith List Bool Lia Lra Psatz Permutation.
Require Import Planes.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * Signs *)

Lemma sgn_minus r : sgn r = Minus <-> r < 0.
Proof. unfold sgn. destruct (Rlt_dec r 0), (Rlt_dec 0 r); split; try easy; lra. Qed.

Lemma sgn_plus r : sgn r = Plus <-> 0 < r.
Proof. unfold sgn. destruct (Rlt_dec r 0), (Rlt_dec 0 r); split; try easy; lra. Qed.

Lemma sgn_zero r : sgn r = Zero <-> r = 0.
Proof. unfold sgn. destruct (Rlt_dec r 0), (Rlt_dec 0 r); split; try easy; lra. Qed.

Lemma sgn_times p r : 0 < p -> sgn (p * r) = sgn r.
Proof.
  intros P. destruct (sgn r) eqn:E.
  - rewrite sgn_minus in *. nra.
  - rewrite sgn_zero in *. subst. lra.
  - rewrite sgn_plus in *. nra.
Qed.

Definition vector_eq_dec (s t : list sign) : {s = t} + {s <> t}.
Proof. decide equality. apply sign_eq_dec. Defined.

Lemma signs_cons f B x : signs (f :: B) x = sgn (value f x) :: signs B x.
Proof. reflexivity. Qed.

(** * Points *)

Definition slope (f : form R) (j : nat) : R := nth j (coefficients f) 0.

Definition move (x : point) (j : nat) (t : R) : point :=
  fun i => if (i =? j)%nat then x i + t else x i.

Definition blend (t : R) (x y : point) : point := fun i => (1 - t) * x i + t * y i.

Lemma linear_move a : forall x j t, linear a (move x j t) = linear a x + t * nth j a 0.
Proof.
  induction a as [|c a IH]; intros x j t; [destruct j; cbn; lra|].
  destruct j as [|j]; cbn [linear nth].
  - change (fun i => move x 0 t (S i)) with (fun i => x (S i)). unfold move; cbn. ring.
  - change (fun i => move x (S j) t (S i)) with (move (fun i => x (S i)) j t).
    rewrite IH. unfold move at 1; cbn. ring.
Qed.

Lemma value_move f x j t : value f (move x j t) = value f x + t * slope f j.
Proof. unfold value, slope. rewrite linear_move. ring. Qed.

Lemma linear_blend a : forall t x y, linear a (blend t x y) = (1 - t) * linear a x + t * linear a y.
Proof.
  induction a as [|c a IH]; intros t x y; cbn; [ring|].
  change (fun i => blend t x y (S i)) with (blend t (fun i => x (S i)) (fun i => y (S i))).
  rewrite IH. unfold blend. ring.
Qed.

Lemma value_blend f t x y : value f (blend t x y) = (1 - t) * value f x + t * value f y.
Proof. unfold value. rewrite linear_blend. ring. Qed.

(** * Foot: the point of the plane h = 0 below or above x, along coordinate j *)

Definition foot (h : form R) (j : nat) (x : point) : point := move x j (- value h x / slope h j).

Lemma foot_on h j x : slope h j <> 0 -> value h (foot h j x) = 0.
Proof. intros. unfold foot. rewrite value_move. field. trivial. Qed.

Lemma value_foot g h j x :
  value g (foot h j x) = value g x - value h x * (slope g j / slope h j).
Proof. unfold foot. rewrite value_move. unfold Rdiv. ring. Qed.

Lemma signs_foot B h j x : value h x = 0 -> signs B (foot h j x) = signs B x.
Proof.
  intros E. apply map_ext. intros f. f_equal. rewrite value_foot, E. ring.
Qed.

(** * Between: of two points of one face on different sides of h, a point on h *)

Lemma sgn_blend f t x y :
  0 < t < 1 -> sgn (value f x) = sgn (value f y) -> sgn (value f (blend t x y)) = sgn (value f x).
Proof.
  intros T E. rewrite value_blend. destruct (sgn (value f x)) eqn:X; symmetry in E;
  rewrite ?sgn_minus, ?sgn_plus, ?sgn_zero in *; nra.
Qed.

Lemma signs_blend B t x y :
  0 < t < 1 -> signs B x = signs B y -> signs B (blend t x y) = signs B x.
Proof.
  intros T E. induction B as [|f B IH]; trivial.
  rewrite !signs_cons in *. injection E as E1 E2. rewrite sgn_blend; trivial. now rewrite IH.
Qed.

Lemma between B h x y :
  signs B x = signs B y -> value h x < 0 -> 0 < value h y ->
  exists z, signs B z = signs B x /\ value h z = 0.
Proof.
  intros E X Y. set (t := - value h x / (value h y - value h x)).
  assert (0 < t < 1).
  { unfold t. split.
    - apply Rdiv_lt_0_compat; lra.
    - apply Rmult_lt_reg_r with (value h y - value h x); [lra|].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  exists (blend t x y). split; [now apply signs_blend|].
  rewrite value_blend. unfold t. field. lra.
Qed.

(** * Near: the neighbours of a point on no plane show what it shows *)

Lemma near_one f x j : value f x <> 0 ->
  exists e, 0 < e /\ forall t, -e < t < e -> sgn (value f (move x j t)) = sgn (value f x).
Proof.
  intros N. exists (Rabs (value f x) / (Rabs (slope f j) + 1)).
  pose proof (Rabs_pos (slope f j)). pose proof (Rabs_pos_lt _ N).
  split; [apply Rdiv_lt_0_compat; lra|]. intros t T.
  assert (Rabs t * (Rabs (slope f j) + 1) < Rabs (value f x)).
  { assert (Rabs t < Rabs (value f x) / (Rabs (slope f j) + 1)) as T' by (apply Rabs_def1; lra).
    apply Rmult_lt_compat_r with (r := Rabs (slope f j) + 1) in T'; [|lra].
    unfold Rdiv in T'. rewrite Rmult_assoc, Rinv_l in T'; lra. }
  assert (Rabs (t * slope f j) < Rabs (value f x)).
  { rewrite Rabs_mult. pose proof (Rabs_pos t). nra. }
  rewrite value_move. destruct (sgn (value f x)) eqn:E;
  rewrite ?sgn_minus, ?sgn_plus, ?sgn_zero in *; try lra.
  - rewrite (Rabs_left _ E) in *. apply Rabs_def2 in H2. lra.
  - rewrite (Rabs_right (value f x)) in * by lra. apply Rabs_def2 in H2. lra.
Qed.

Lemma near B x j : ~ In Zero (signs B x) ->
  exists e, 0 < e /\ forall t, -e < t < e -> signs B (move x j t) = signs B x.
Proof.
  induction B as [|f B IH]; intros N; [exists 1; split; [lra|trivial]|].
  rewrite signs_cons in N. cbn in N.
  destruct IH as (e1 & P1 & H1); [tauto|].
  destruct (@near_one f x j) as (e2 & P2 & H2).
  { intros E. apply N. left. now apply sgn_zero. }
  exists (Rmin e1 e2). split; [now apply Rmin_glb_lt|]. intros t T.
  pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2).
  rewrite !signs_cons, H1, H2; trivial; lra.
Qed.

Lemma both_sides B h x j : slope h j <> 0 -> value h x = 0 -> ~ In Zero (signs B x) ->
  (exists y, signs B y = signs B x /\ value h y < 0) /\
  (exists y, signs B y = signs B x /\ 0 < value h y).
Proof.
  intros S E N. destruct (@near B x j N) as (e & P & H).
  assert (forall t, -e < t < e -> value h (move x j t) = t * slope h j) as V.
  { intros. rewrite value_move, E. ring. }
  destruct (Rdichotomy _ _ S); split; [exists (move x j (e / 2)) | exists (move x j (- e / 2))
    | exists (move x j (- e / 2)) | exists (move x j (e / 2))];
  (split; [apply H; lra | rewrite V; nra]).
Qed.

(** * Lists and numbers *)

Lemma lists_length T (P : T -> Prop) l l' : lists P l -> lists P l' -> length l = length l'.
Proof.
  intros [N E] [N' E']. apply Permutation_length, NoDup_Permutation; trivial.
  intros s. now rewrite E, E'.
Qed.

Lemma number_unique T (P : T -> Prop) n n' : number P n -> number P n' -> n = n'.
Proof.
  intros (l & L & <-) (l' & L' & <-). f_equal. exact (lists_length L L').
Qed.

Lemma number_of_list T (P : T -> Prop) n l :
  number P n -> lists P l -> Z.of_nat (length l) = n.
Proof. intros N L. apply (@number_unique _ P); trivial. now exists l. Qed.

Lemma number_nonneg T (P : T -> Prop) n : number P n -> (0 <= n)%Z.
Proof. intros (l & _ & <-). lia. Qed.

Lemma number_iff T (P Q : T -> Prop) n : (forall s, P s <-> Q s) -> number P n -> number Q n.
Proof.
  intros E (l & (N & L) & <-). exists l. repeat split; trivial; intros H.
  - now apply E, L.
  - now apply L, E.
Qed.

Lemma number_none T (P : T -> Prop) : (forall s, ~ P s) -> number P 0.
Proof.
  intros H. exists []. repeat split; [constructor| |]; cbn; [easy|]. apply H.
Qed.

Lemma number_one T (P : T -> Prop) a : (forall s, P s <-> s = a) -> number P 1.
Proof.
  intros H. exists [a]. repeat split.
  - repeat constructor. easy.
  - intros [<-|[]]. now apply H.
  - intros E%H. now left.
Qed.

(** Things that correspond one to one. *)
Lemma number_image T U (P : T -> Prop) (Q : U -> Prop) (e : T -> U) n :
  (forall a b, e a = e b -> a = b) -> (forall u, Q u <-> exists t, P t /\ e t = u) ->
  number P n -> number Q n.
Proof.
  intros I E (l & (N & L) & <-). exists (map e l). split.
  - split.
    + now apply FinFun.Injective_map_NoDup.
    + intros u. rewrite E, in_map_iff. split; intros (t & A & B); exists t; firstorder.
  - now rewrite map_length.
Qed.

Lemma number_or T (P Q : T -> Prop) n n' : (forall s, P s -> Q s -> False) ->
  number P n -> number Q n' -> number (fun s => P s \/ Q s) (n + n').
Proof.
  intros D (l & (N & L) & <-) (l' & (N' & L') & <-). exists (l ++ l'). split.
  - split.
    + induction l as [|a l IH] in P, D, N, L |- *; cbn; trivial. inversion N; subst. constructor.
      * rewrite in_app_iff. intros [A|A]; [easy|]. apply (D a); [apply L; now left|now apply L'].
      * apply IH with (fun s => In s l); trivial; [|easy].
        intros s A. apply D, L. now right.
    + intros s. rewrite in_app_iff, L, L'. reflexivity.
  - rewrite app_length. lia.
Qed.

(** Being in a list is decidable; so a set of known number has one part in it and one outside. *)
Lemma number_part T (P Q : T -> Prop) n q (dec : forall a b : T, {a = b} + {a <> b}) :
  (forall s, Q s -> P s) -> number P n -> number Q q ->
  number (fun s => P s /\ ~ Q s) (n - q) /\ forall s, P s -> Q s \/ ~ Q s.
Proof.
  intros I (l & (N & L) & <-) (l' & (N' & L') & <-).
  pose (inside := fun s => if in_dec dec s l' then true else false).
  assert (forall s, inside s = true <-> Q s) as Y.
  { intros s. unfold inside. rewrite <- L'. now destruct (in_dec dec s l'). }
  split.
  - exists (filter (fun s => negb (inside s)) l). split; [split|].
    + now apply NoDup_filter.
    + intros s. rewrite filter_In, L, negb_true_iff, <- not_true_iff_false, Y. reflexivity.
    + rewrite (@lists_length _ Q l' (filter inside l)); [| now split |].
      * clear. generalize inside as p. intros p. induction l as [|a l IH]; trivial.
        cbn [filter length]. destruct (p a); cbn [length negb]; lia.
      * split; [now apply NoDup_filter|]. intros s. rewrite filter_In, L, Y. firstorder.
  - intros s _. destruct (inside s) eqn:E; [left; now apply Y|right; intros H%Y; congruence].
Qed.

(** * One plane more *)

(** [B'] shows everywhere what [B] shows on h = 0. *)
Definition restricts (h : form R) (B B' : list (form R)) : Prop :=
  forall s, face B' s <-> exists x, value h x = 0 /\ signs B x = s.

(** A region of B that meets h = 0 gives two regions of h :: B, any other one gives one. *)
Lemma one_more h j B B' n n' :
  slope h j <> 0 -> restricts h B B' ->
  number (region B) n -> number (region B') n' -> number (region (h :: B)) (n + n').
Proof.
  intros S Res Num Num'.
  assert (forall s, region B' s -> region B s) as Sub.
  { intros s [(x & _ & <-)%Res Z]. split; trivial. now exists x. }
  destruct (number_part vector_eq_dec Sub Num Num') as [Out Dec].
  (* The regions above h = 0, and those below. *)
  assert (forall side, side = Plus \/ side = Minus ->
    (forall s, region B' s -> region (h :: B) (side :: s))) as Both.
  { intros side Side s [(x & X & <-)%Res Z]. destruct (@both_sides B h x j S X Z) as [(y & Y & Hy) (z & Z' & Hz)].
    split; [|cbn; destruct Side; subst; intros [|]; easy].
    destruct Side; subst; [exists z | exists y]; rewrite signs_cons; f_equal; trivial;
    [now apply sgn_plus | now apply sgn_minus]. }
  assert (number (fun t => exists s, region B' s /\ Plus :: s = t) n') as Up.
  { apply number_image with (P := region B') (e := cons Plus); trivial; [|reflexivity].
    intros a b [= ->]; trivial. }
  assert (number (fun t => exists s, region B' s /\ Minus :: s = t) n') as Down.
  { apply number_image with (P := region B') (e := cons Minus); trivial; [|reflexivity].
    intros a b [= ->]; trivial. }
  assert (number (fun t => region (h :: B) t /\ ~ region B' (tl t)) (n - n')) as Once.
  { destruct Out as (l & (N & L) & <-).
    assert (exists l', lists (fun t => region (h :: B) t /\ In (tl t) l) l' /\ length l' = length l)
      as (l' & (N1 & L1) & Len).
    { assert (forall s, In s l -> region B s /\ ~ region B' s) as All by (intros; now apply L).
      clear L Num Num' Up Down. induction l as [|s l IH]; inversion N; subst.
      - exists []. split; [split; [constructor|intros t; cbn; tauto]|trivial].
      - destruct IH as (l' & (N1 & L1) & Len); trivial; [intros; apply All; now right|].
        destruct (All s) as [[(x & X) Z] Not]; [now left|].
        assert (value h x <> 0) as NZ.
        { intros E. apply Not. split; trivial. apply Res. now exists x. }
        exists ((sgn (value h x) :: s) :: l'). split; [split|cbn; lia].
        + constructor; trivial. rewrite L1. cbn. intros [_ ?]. easy.
        + intros t. cbn. rewrite L1. split.
          * intros [<-|[A B0]]; cbn; [|tauto]. split; [|tauto]. split.
            -- exists x. now rewrite signs_cons, X.
            -- cbn. intros [E|E]; [|easy]. now apply sgn_zero in E.
          * intros [T [E|E]]; [left|right; tauto]. destruct T as [(y & <-) Z'].
            rewrite signs_cons in *. cbn in E. subst s. rewrite <- E. f_equal.
            assert (value h y <> 0) as NY.
            { intros F. apply Z'. left. now apply sgn_zero. }
            destruct (Rdichotomy _ _ NZ) as [A|A], (Rdichotomy _ _ NY) as [C|C].
            ++ now rewrite (proj2 (sgn_minus _) A), (proj2 (sgn_minus _) C).
            ++ destruct (@between B h x y) as (z & Hz & V); trivial; [congruence..|].
               exfalso. apply Not. split; [|congruence]. apply Res. exists z. split; congruence.
            ++ destruct (@between B h y x) as (z & Hz & V); trivial; [congruence..|].
               exfalso. apply Not. split; [|congruence]. apply Res. exists z. split; congruence.
            ++ now rewrite (proj2 (sgn_plus _) A), (proj2 (sgn_plus _) C). }
    exists l'. split; [split|lia]; trivial. intros t. rewrite L1, L. split; [tauto|].
    intros [T NT]. split; [exact T|]. split; [|exact NT]. destruct T as [(x & <-) Z].
    split; [now exists x|]. rewrite signs_cons in Z. cbn in *. tauto. }
  replace (n + n')%Z with (n - n' + (n' + n'))%Z by lia.
  eapply number_iff; [|apply number_or; [|exact Once|apply number_or; [|exact Up|exact Down]]].
  - intros t. cbn beta. split.
    + intros [[T _]|[(s & R & <-)|(s & R & <-)]]; trivial; apply Both; tauto.
    + intros T. destruct T as [(x & <-) Z] eqn:E. clear E.
      assert (region B (signs B x)) as RB by (split; [now exists x|cbn in Z; tauto]).
      destruct (Dec _ RB) as [D|D]; [right|left; split; trivial; split; trivial; now exists x].
      rewrite signs_cons in *. destruct (sgn (value h x)); [right|exfalso; apply Z; now left|left];
      now exists (signs B x).
  - cbn beta. intros t [_ N] [(s & R & <-)|(s & R & <-)]; easy.
  - cbn beta. intros t (s & _ & <-) (s' & _ & ?). discriminate.
Qed.
