(** General position of great circles: no two coincide, and no three have a common point. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General Bounded Merge Attained.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Lemma pairs_permutation T (Q : T -> T -> Prop) l l' : (forall a b, Q a b -> Q b a) -> Permutation l l' ->
  ForallOrdPairs Q l -> ForallOrdPairs Q l'.
Proof.
  intros S. induction 1 as [|a l l' P IH|a b l|l l' l2 P IH P' IH']; intros F; auto.
  - inversion F; subst. constructor; auto. now apply Permutation_Forall with l.
  - inversion F as [|? ? Fb F1]; subst. inversion F1 as [|? ? Fa F2]; subst. inversion Fb; subst.
    constructor; [constructor; auto|]. now constructor.
Qed.

Lemma independent_nodup gs : independent gs -> NoDup gs.
Proof.
  induction gs as [|g gs IH]; intros D; constructor.
  - intros I. destruct (D (1 :: map (fun _ => 0) gs)) as (v & V); [cbn; now rewrite map_length|].
    injection V as V0 V. pose proof (zeros_none _ _ V) as N. pose proof (proj1 (Forall_forall _ _) N g I) as Z.
    cbv beta in Z. unfold along in Z. lra.
  - apply IH. exact (@independent_less [] g gs D).
Qed.

Lemma independent_rank gs : independent gs -> rank gs (length gs).
Proof.
  intros D. split; [exists gs; auto with datatypes|]. intros hs I E.
  apply NoDup_incl_length; trivial. now apply independent_nodup.
Qed.

Lemma rank_independent gs : rank gs (length gs) -> independent gs.
Proof.
  intros [(hs & I & D & L) _]. apply independent_permutation with hs; trivial.
  apply NoDup_Permutation_bis; trivial; [now apply independent_nodup|lia].
Qed.

Definition unit (i : nat) : form R := Form 0 (map (fun k => if (k =? i)%nat then 1 else 0) (seq 0 3)).

Lemma along_unit_form i v : (i < 3)%nat -> along (unit i) v = v i.
Proof. intros L. destruct i as [|[|[|i]]]; [| | |lia]; unfold along; cbn; ring. Qed.

Lemma no_kernel_rank gs : (forall v, none gs v -> v 0%nat = 0 /\ v 1%nat = 0 /\ v 2%nat = 0) ->
  exists k, rank gs k /\ (3 <= k)%nat.
Proof.
  intros H.
  assert (forall fs, exists k, rank fs k) as Rank.
  { intros fs. destruct (@rank_exists _ look_real restrict_real (fun f => f) look_real_vanishes
      look_real_constant look_real_plane _ fs (le_n _)) as [k R]. rewrite map_id in R. now exists k. }
  destruct (Rank gs) as (k & R). exists k. split; trivial.
  assert (forall i fs, (i < 3)%nat -> incl gs fs -> rank fs k -> rank (unit i :: fs) k) as Same.
  { intros i fs L I F. destruct (Rank (unit i :: fs)) as (m & M).
    destruct (rank_step F M) as [[-> _]|[_ (v & V & N)]]; trivial. exfalso. apply N.
    assert (none gs v) as G by (unfold none in *; rewrite Forall_forall in *; auto).
    destruct (H v G) as (X & Y & Z). rewrite along_unit_form by trivial.
    destruct i as [|[|[|i]]]; trivial; lia. }
  pose proof (Same 0%nat gs ltac:(lia) (incl_refl _) R) as R0.
  pose proof (Same 1%nat _ ltac:(lia) (incl_tl _ (incl_refl gs)) R0) as R1.
  pose proof (Same 2%nat _ ltac:(lia) (incl_tl _ (incl_tl _ (incl_refl gs))) R1) as [_ U].
  apply (U [unit 2; unit 1; unit 0]).
  - intros f [<-|[<-|[<-|[]]]]; cbn; auto.
  - intros [|a [|b [|c [|]]]] L; try easy.
    exists (fun i => match i with O => c | 1%nat => b | _ => a end). cbn. repeat (f_equal; try ring).
Qed.

Lemma same_plane_symmetric (f g : form R) : ~ same_plane f g -> ~ same_plane g f.
Proof.
  intros N (c & C & E). apply N. exists (/ c). split; [now apply Rinv_neq_0_compat|].
  intros x. rewrite E. field. trivial.
Qed.

Lemma dependent_pair f g : same_plane f g -> ~ independent [f; g].
Proof.
  intros (c & C & E) D. destruct (D [0; 1] eq_refl) as (v & V). injection V as V0 V1.
  change (along f v = 0) in V0. change (along g v = 1) in V1. rewrite along_value, !E in V1.
  rewrite along_value in V0. nra.
Qed.

(** Different planes that are planes: any two are independent. *)
Lemma different_general planes : great_circles planes ->
  (forall f, In f planes -> exists x, value f x <> 0) -> different planes -> general 2 planes.
Proof.
  intros [_ C] Some D. rewrite Forall_forall in C.
  assert (forall f, In f planes -> look_real f = Plane) as Kind.
  { intros f I. destruct (look_real f) eqn:K; trivial; exfalso.
    - destruct (Some f I) as (x & X). apply X. now apply look_real_vanishes.
    - now apply (@central_look f (C f I)). }
  intros [|f [|g [|k fs]]] rest P L; try (cbn in L; lia).
  - intros [|] ?; [|easy]. now exists origin.
  - apply independent_one, Kind, (Permutation_in f (Permutation_sym P)). now left.
  - assert (In f planes /\ In g planes) as [If Ig].
    { split; [apply (Permutation_in f (Permutation_sym P))|apply (Permutation_in g (Permutation_sym P))]; cbn; auto. }
    pose proof (pairs_permutation same_plane_symmetric P D) as F. inversion F as [|? ? Ff _]; subst.
    inversion Ff as [|? ? N _]; subst. apply independent_two; auto.
    destruct (look_real (restrict_real f g)) eqn:K; trivial; exfalso.
    + destruct (@vanishing_times f g (Kind f If) (Kind g Ig) K) as (c & Cn & E). apply N.
      exists (/ c). split; [now apply Rinv_neq_0_compat|]. intros x. rewrite E. field. trivial.
    + now apply (@central_look _ (@central_restrict f g (C f If) (C g Ig))).
Qed.

Lemma general_great_circles planes : great_circles planes ->
  (forall f, In f planes -> exists x, value f x <> 0) ->
  (general 3 planes <-> different planes /\
    forall f g h rest x, Permutation planes (f :: g :: h :: rest) ->
      value f x = 0 -> value g x = 0 -> value h x = 0 -> x 0%nat = 0 /\ x 1%nat = 0 /\ x 2%nat = 0).
Proof.
  intros [S C] Some.
  assert (forall f x, In f planes -> along f x = value f x) as Along.
  { intros f x I. pose proof (proj1 (Forall_forall _ _) C f I) as Z. unfold value, along. rewrite Z. ring. }
  split.
  - intros G. split.
    + clear - G. unfold different. induction planes as [|f l IH]; constructor.
      * apply Forall_forall. intros g (l1 & l2 & ->)%in_split Same. apply (dependent_pair Same).
        apply (G [f; g] (l1 ++ l2)); [|cbn; lia]. cbn. constructor. symmetry. apply Permutation_middle.
      * apply IH. now apply general_tail with f.
    + intros f g h rest x P F0 G0 H0.
      assert (incl [f; g; h] planes) as I.
      { intros k K. apply (Permutation_in k (Permutation_sym P)). cbn in *. tauto. }
      assert (independent [f; g; h]) as D by (apply (G [f; g; h] rest); trivial; cbn; lia).
      assert (of_space 3 [f; g; h]) as S3.
      { unfold of_space in *. rewrite Forall_forall in *. auto. }
      assert (forall i, (i < 3)%nat -> x i = 0) as Zero.
      { apply (no_direction x S3 (independent_rank D)). intros k K. rewrite Along by auto.
        destruct K as [<-|[<-|[<-|[]]]]; trivial. }
      repeat split; apply Zero; lia.
  - intros [D T] fs rest P L. destruct (Nat.eq_dec (length fs) 3) as [Three|N].
    2: { apply (@different_general planes (conj S C) Some D fs rest P). lia. }
    destruct fs as [|f [|g [|h [|k fs]]]]; try easy.
    assert (incl [f; g; h] planes) as I.
    { intros k K. apply (Permutation_in k (Permutation_sym P)). cbn in *. tauto. }
    destruct (@no_kernel_rank [f; g; h]) as (k & R & K).
    + intros v V. inversion V as [|? ? F0 V1]; subst. inversion V1 as [|? ? G0 V2]; subst.
      inversion V2 as [|? ? H0 _]; subst. rewrite !Along in * by (apply I; cbn; auto).
      now apply (T f g h rest).
    + apply rank_independent. replace (length [f; g; h]) with k; trivial.
      destruct R as [(hs & Ih & Dh & Lh) _]. pose proof (NoDup_incl_length (independent_nodup Dh) Ih). cbn in *. lia.
Qed.
