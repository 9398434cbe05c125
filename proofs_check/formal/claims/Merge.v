(** Planes that coincide, and forms that are 0 everywhere, change no number of faces. *)

Require Import Reals ZArith List Bool Lia Lra Permutation.
Require Import Planes Sides Rank Recursion Bounds General.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Definition times (c : R) (f g : form R) : Prop := c <> 0 /\ forall x, value g x = c * value f x.

(** Every form of A is 0 everywhere or a multiple of one of B. *)
Definition merged (A B : list (form R)) : Prop :=
  incl B A /\ forall g, In g A -> (forall x, value g x = 0) \/ exists f c, In f B /\ times c f g.

Lemma merged_zeros A B x : merged A B -> merged (zeros x A) (zeros x B).
Proof.
  intros [I M]. split.
  - intros f. rewrite !zeros_spec. intros []. auto.
  - intros g. rewrite zeros_spec. intros [G Z]. destruct (M g G) as [|(f & c & F & N & T)]; [now left|].
    right. exists f, c. rewrite zeros_spec. repeat split; trivial.
    rewrite T in Z. now apply Rmult_integral in Z as [|].
Qed.

Lemma merged_rank A B k : merged A B -> rank A k <-> rank B k.
Proof.
  intros [I M].
  assert (forall hs, incl hs A -> independent hs ->
    exists gs, incl gs B /\ independent gs /\ length gs = length hs) as Sub.
  { intros hs J Ind.
    assert (exists gs, incl gs B /\
      Forall2 (fun h f => exists c, c <> 0 /\ forall v, along h v = c * along f v) hs gs)
      as (gs & K & F).
    { assert (forall h, In h hs -> exists f, In f B /\
        exists c, c <> 0 /\ forall v, along h v = c * along f v) as One.
      { intros h H. destruct (M h (J h H)) as [Z|(f & c & F & N & T)].
        - destruct (@independent_slope hs h Ind H). intros v. rewrite along_value, !Z. ring.
        - exists f. split; trivial. exists c. split; trivial. intros v. rewrite !along_value, !T. ring. }
      clear J Ind. induction hs as [|h hs IH]; [exists []; split; [easy|constructor]|].
      destruct IH as (gs & K & F); [intros; apply One; now right|].
      destruct (One h (or_introl eq_refl)) as (f & Bf & C). exists (f :: gs).
      split; [intros g [<-|]; auto|now constructor]. }
    exists gs. split; trivial. split.
    - intros values L.
      assert (exists values', length values' = length hs /\ forall v,
        map (fun f => along f v) hs = values' -> map (fun f => along f v) gs = values)
        as (values' & L' & Good).
      { clear - F L. revert values L. induction F as [|h f hs gs (c & N & E) F IH]; intros values L.
        - destruct values; [|easy]. now exists [].
        - destruct values as [|a values]; [easy|]. injection L as L.
          destruct (IH values L) as (values' & L' & Good). exists (c * a :: values').
          split; [cbn; lia|]. intros v V. injection V as V0 V. cbn. rewrite (Good v V). f_equal.
          rewrite E in V0. now apply Rmult_eq_reg_l in V0. }
      destruct (Ind values' L') as (v & V). exists v. now apply Good.
    - clear - F. induction F; cbn; auto. }
  split; intros [(hs & J & Ind & L) U].
  - split.
    + destruct (Sub hs J Ind) as (gs & K & Ig & Lg). exists gs. repeat split; trivial. lia.
    + intros gs K Ig. apply U; trivial. now apply incl_tran with B.
  - split.
    + exists hs. repeat split; trivial. now apply incl_tran with B.
    + intros gs K Ig. destruct (Sub gs K Ig) as (gs' & K' & I' & <-). now apply U.
Qed.

Lemma merged_sign B h f c : In f B -> times c f h ->
  exists phi, forall x, sgn (value h x) = phi (signs B x).
Proof.
  intros (l1 & l2 & ->)%in_split [N T].
  exists (fun s => match nth (length l1) s Zero with
    | Zero => Zero
    | Plus => if Rlt_dec 0 c then Plus else Minus
    | Minus => if Rlt_dec 0 c then Minus else Plus end).
  intros x. unfold signs. rewrite map_app.
  rewrite app_nth2; rewrite map_length; [|lia]. rewrite Nat.sub_diag. cbn [map nth]. rewrite T.
  destruct (Rlt_dec 0 c) as [P|P]; [rewrite sgn_times by trivial; now destruct (sgn (value f x))|].
  destruct (sgn (value f x)) eqn:E; rewrite ?sgn_minus, ?sgn_plus, ?sgn_zero in *; [nra| |nra].
  rewrite E. ring.
Qed.

Lemma independent_one f : look_real f = Plane -> independent [f].
Proof.
  intros K [|t [|]] L; try easy. pose proof (@look_real_slope f K) as S.
  exists (move origin (pivot_real (coefficients f)) (t / slope f (pivot_real (coefficients f)))).
  cbn. change (linear (coefficients f)) with (along f). rewrite along_move. unfold along.
  rewrite linear_origin. f_equal. field. trivial.
Qed.

Lemma independent_two h g : look_real h = Plane -> look_real (restrict_real h g) = Plane ->
  independent [h; g].
Proof.
  intros K G. apply (@below_independent h _ (@look_real_slope h K) [g] [restrict_real h g]).
  - repeat constructor. now apply restrict_real_below.
  - now apply independent_one.
Qed.

Lemma independent_swap f g : independent [f; g] -> independent [g; f].
Proof.
  intros Ind [|a [|b [|]]] L; try easy. destruct (Ind [b; a] eq_refl) as (v & V).
  injection V as V1 V2. exists v. cbn. now rewrite V1, V2.
Qed.

Lemma general_cons h B : look_real h = Plane ->
  Forall (fun g => look_real (restrict_real h g) = Plane) B -> general 2 B -> general 2 (h :: B).
Proof.
  intros K P G [|f [|g [|k fs]]] rest Q L; try (cbn in L; lia).
  - intros [|] ?; [|easy]. now exists origin.
  - apply independent_one. assert (In f (h :: B)) as [<-|I]; trivial.
    { apply (Permutation_in f (Permutation_sym Q)). now left. }
    now apply (@general_plane 1 B).
  - rewrite Forall_forall in P. cbn in Q.
    assert (In h (f :: g :: rest)) as I by (apply (Permutation_in h Q); now left).
    destruct I as [->|[->|I]].
    + apply Permutation_cons_inv in Q. apply independent_two; trivial. apply P.
      apply (Permutation_in g (Permutation_sym Q)). now left.
    + rewrite perm_swap in Q. apply Permutation_cons_inv in Q. apply independent_swap, independent_two; trivial.
      apply P. apply (Permutation_in f (Permutation_sym Q)). now left.
    + apply in_split in I as (r1 & r2 & ->). apply (G [f; g] (r1 ++ r2)); trivial.
      apply (@Permutation_cons_app_inv _ B (f :: g :: r1) r2 h). exact Q.
Qed.

Lemma onto_planes h B : Forall central (h :: B) ->
  (exists g, In g B /\ look_real (restrict_real h g) = Vanishes) \/
  Forall (fun g => look_real (restrict_real h g) = Plane) B.
Proof.
  intros C. inversion C as [|? ? Ch CB]; subst. clear C.
  induction CB as [|g B Cg CB IH]; [right; constructor|].
  destruct (look_real (restrict_real h g)) eqn:E.
  - left. exists g. split; [now left|trivial].
  - destruct (@central_look _ (@central_restrict h g Ch Cg) E).
  - destruct IH as [(k & I & V)|P]; [left; exists k; split; [now right|trivial]|right; now constructor].
Qed.

(** A form that vanishes on h = 0, and h, are multiples of one another. *)
Lemma vanishing_times h g : look_real h = Plane -> look_real g = Plane ->
  look_real (restrict_real h g) = Vanishes -> exists c, times c g h.
Proof.
  intros K G V. set (j := pivot_real (coefficients h)). set (b := slope g j / slope h j).
  assert (forall x, value g x = b * value h x) as E.
  { intros x. pose proof (@look_real_vanishes _ V x) as Z. unfold restrict_real, value in Z. cbn in Z.
    rewrite linear_less in Z. fold j b in Z. unfold value. lra. }
  assert (b <> 0) as N.
  { intros Z. pose proof (@look_real_slope g G) as S. apply S.
    rewrite <- along_unit, along_value, !E, Z. ring. }
  exists (/ b). split; [now apply Rinv_neq_0_compat|]. intros x. rewrite E. field. trivial.
Qed.

Lemma merge A : Forall central A -> exists B e,
  merged A B /\ general 2 B /\ fills A B e /\ ((length B < length A)%nat \/ B = A).
Proof.
  induction 1 as [|h A Ch C (B & e & [I M] & G & F & Len)].
  - exists [], (fun s => s). split; [split; easy|]. split; [|split; [apply fills_refl|now right]].
    intros fs rest P _. apply Permutation_nil in P. destruct fs; [|easy].
    intros [|] ?; [|easy]. now exists origin.
  - destruct (look_real h) eqn:K.
    + exists B, (fun s => Zero :: e s). split; [split|split; [trivial|split]].
      * intros f Hf. right. auto.
      * intros g [<-|Hg]; [left; now apply look_real_vanishes|auto].
      * apply fills_constant; trivial. intros x. rewrite (@look_real_vanishes _ K). now apply sgn_zero.
      * left. destruct Len as [ | ->]; cbn; lia.
    + now destruct (@central_look h Ch).
    + assert (Forall central B) as CB.
      { rewrite Forall_forall in *. auto. }
      destruct (@onto_planes h B ltac:(now constructor)) as [(g & Bg & V)|P].
      * destruct (@vanishing_times h g K (@general_plane 1 B g G Bg) V) as (c & T).
        destruct (merged_sign B Bg T) as (phi & Phi).
        exists B, (fun s => phi s :: e s). split; [split|split; [trivial|split]].
        -- intros f Hf. right. auto.
        -- intros f [<-|Hf]; [right; now exists g, c|auto].
        -- destruct F as [Inj E]. split; [intros a b [=]; auto|].
           intros x. now rewrite signs_cons, Phi, E.
        -- left. destruct Len as [ | ->]; cbn; lia.
      * destruct (fills_keep h F) as (e' & F' & _). exists (h :: B), e'.
        split; [split|split; [now apply general_cons|split; [exact F'|]]].
        -- intros f [<-|Hf]; [now left|right; auto].
        -- intros f [<-|Hf]; [right; exists h, 1; split; [now left|split; [lra|intros; ring]]|].
           destruct (M f Hf) as [|(g & c & Bg & T)]; [now left|]. right. exists g, c. split; [now right|trivial].
        -- destruct Len as [ | ->]; [left; cbn; lia|now right].
Qed.

Lemma merged_number A B e k n : merged A B -> fills A B e ->
  number (face_of_codimension k A) n <-> number (face_of_codimension k B) n.
Proof.
  intros M [Inj E].
  assert (forall n, number (face_of_codimension k B) n -> number (face_of_codimension k A) n) as Up.
  { intros n0. apply number_image with (e := e); trivial. intros u.
    assert (forall x, rank (through A (signs A x)) k <-> rank (through B (signs B x)) k) as R
      by (intros x; apply merged_rank, merged_zeros, M).
    split.
    - intros [(x & <-) H]. exists (signs B x). split; [|now rewrite E]. split; [now exists x|now apply R].
    - intros (t & [(x & <-) H] & <-). rewrite <- E. split; [now exists x|now apply R]. }
  split; [|apply Up]. intros N. pose proof (faces_real_count B k) as NB.
  now rewrite (number_unique N (Up _ NB)).
Qed.
