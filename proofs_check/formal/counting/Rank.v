(** The rank of forms, and what elimination does to it. *)

Require Import Reals ZArith List Bool Lia Lra.
Require Import Planes Sides.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

Definition along (f : form R) (v : point) : R := linear (coefficients f) v.

Definition plus (v : point) (c : R) (w : point) : point := fun i => v i + c * w i.

Definition origin : point := fun _ => 0.

Lemma linear_plus a : forall v c w, linear a (plus v c w) = linear a v + c * linear a w.
Proof.
  induction a as [|b a IH]; intros; cbn; [ring|].
  change (fun i => plus v c w (S i)) with (plus (fun i => v (S i)) c (fun i => w (S i))).
  rewrite IH. unfold plus. ring.
Qed.

Lemma along_plus f v c w : along f (plus v c w) = along f v + c * along f w.
Proof. apply linear_plus. Qed.

Lemma linear_origin a : linear a origin = 0.
Proof.
  induction a as [|c a IH]; cbn; trivial. change (fun i => origin (S i)) with origin.
  rewrite IH. unfold origin. ring.
Qed.

Lemma along_value f v : along f v = value f v - value f origin.
Proof. unfold along, value. rewrite linear_origin. ring. Qed.

Lemma along_move f v j t : along f (move v j t) = along f v + t * slope f j.
Proof. apply linear_move. Qed.

Lemma map_at A B (f g : A -> B) l a : map f l = map g l -> In a l -> f a = g a.
Proof. intros E. now apply map_ext_in_iff. Qed.
Arguments map_at {A B f g l a}.

Lemma rank_unique fs k k' : rank fs k -> rank fs k' -> k = k'.
Proof.
  intros [(gs & I & D & <-) U] [(gs' & I' & D' & <-) U'].
  apply Nat.le_antisymm; auto.
Qed.

Lemma rank_nil : rank [] 0.
Proof.
  split.
  - exists []. repeat split; [easy|]. intros [|]; [|easy]. intros _. now exists origin.
  - intros [|g gs] I _; cbn; [lia|]. destruct (I g). now left.
Qed.

(** A form whose linear part is 0 is in no independent list. *)
Lemma independent_slope gs g : independent gs -> In g gs -> (forall v, along g v = 0) -> False.
Proof.
  intros D H E. destruct (D (map (fun _ => 1) gs)) as (v & V); [now rewrite map_length|].
  pose proof (map_at V H) as O. cbn in O.
  change (along g v = 1) in O. rewrite E in O. lra.
Qed.

Lemma rank_more fs gs k :
  incl fs gs -> (forall g, In g gs -> In g fs \/ forall v, along g v = 0) ->
  (rank gs k <-> rank fs k).
Proof.
  intros I M.
  assert (forall hs, incl hs gs -> independent hs -> incl hs fs) as Sub.
  { intros hs J D h H. destruct (M h) as [|E]; auto. now destruct (@independent_slope hs h D H). }
  split; intros [(hs & J & D & L) U]; split.
  - exists hs. auto.
  - intros hs' J'. apply U. now apply incl_tran with fs.
  - exists hs. repeat split; trivial. now apply incl_tran with fs.
  - intros hs' J' D'. apply U; auto.
Qed.

(** * All but one of independent forms are independent where one more form is 0 *)

Definition none (fs : list (form R)) (v : point) := Forall (fun f => along f v = 0) fs.

Definition dual (pre post : list (form R)) := forall pre1 f pre2, pre = pre1 ++ f :: pre2 ->
  exists v, along f v = 1 /\ none pre1 v /\ none pre2 v /\ none post v.

Lemma zeros_none (fs : list (form R)) v :
  map (fun f => along f v) fs = map (fun _ => 0) fs -> none fs v.
Proof.
  intros E. apply Forall_forall. intros f H.
  exact (map_at E H).
Qed.

Lemma independent_dual fs : independent fs -> dual fs [].
Proof.
  intros D pre1 f pre2 ->.
  destruct (D (map (fun _ => 0) pre1 ++ 1 :: map (fun _ => 0) pre2)) as (v & V).
  { rewrite !app_length. cbn. now rewrite !map_length. }
  exists v. rewrite map_app in V. cbn in V.
  assert (map (fun f => along f v) pre1 = map (fun _ => 0) pre1 /\
    along f v :: map (fun f => along f v) pre2 = 1 :: map (fun _ => 0) pre2) as [A B].
  { unfold along. revert V.
    generalize (fun f => linear (coefficients f) v) as a. intros a. clear.
    induction pre1 as [|g pre1 IH]; cbn; intros V; [now split|].
    injection V as E V. destruct (IH V) as [X Y]. split; trivial. now rewrite E, X. }
  injection B as E B. repeat split; trivial; now apply zeros_none.
Qed.

Lemma none_plus fs v c w : none fs v -> none fs w -> none fs (plus v c w).
Proof.
  unfold none. rewrite !Forall_forall. intros V W f H. rewrite along_plus, V, W by trivial. ring.
Qed.

Lemma drop h pre : forall post, dual pre post -> exists gs,
  incl gs pre /\
  (forall values, length values = length gs ->
    exists v, along h v = 0 /\ map (fun f => along f v) gs = values /\ none post v) /\
  (length pre = length gs \/
   length pre = S (length gs) /\ exists u, along h u <> 0 /\ none gs u /\ none post u).
Proof.
  induction pre as [|f pre IH]; intros post D.
  - exists []. split; [easy|]. split; [|now left]. intros [|]; [|easy]. intros _.
    exists origin. repeat split; [apply linear_origin|].
    apply Forall_forall. intros. apply linear_origin.
  - destruct (IH (f :: post)) as (gs & I & V & U).
    { intros pre1 g pre2 ->. destruct (D (f :: pre1) g pre2) as (v & A & B & C & E); trivial.
      inversion B; subst. exists v. repeat split; trivial. now constructor. }
    destruct (D [] f pre) as (w & W & _ & Wpre & Wpost); trivial.
    assert (none gs w) as Wgs.
    { apply Forall_forall. intros g H. apply (proj1 (Forall_forall _ _) Wpre), I, H. }
    assert (forall c v, map (fun g => along g (plus v c w)) gs = map (fun g => along g v) gs) as Add.
    { intros c v. apply map_ext_in. intros g H. rewrite along_plus.
      rewrite (proj1 (Forall_forall _ _) Wgs g H). ring. }
    assert (forall u v c, none gs u ->
      map (fun g => along g (plus v c u)) gs = map (fun g => along g v) gs) as Add'.
    { intros u v c N. apply map_ext_in. intros g H. rewrite along_plus.
      rewrite (proj1 (Forall_forall _ _) N g H). ring. }
    (* f stays as soon as some direction with f = 1 and the others 0 lies in h = 0. *)
    assert (forall w', along h w' = 0 -> along f w' = 1 -> none gs w' -> none post w' ->
      forall values, length values = S (length gs) ->
      exists v, along h v = 0 /\ map (fun g => along g v) (f :: gs) = values /\ none post v)
      as Stay.
    { intros w' Hw Fw Gw Pw [|t values] L; [easy|]. injection L as L.
      destruct (V values L) as (v & Hv & Gv & Pv). inversion Pv as [|? ? Fv Pv']; subst.
      exists (plus v t w'). rewrite along_plus, Hv, Hw. repeat split; [ring| |now apply none_plus].
      cbn. rewrite along_plus, Fv, Fw, Add' by trivial. f_equal. ring. }
    destruct U as [U|[U (u & Hu & Gu & Pu)]].
    + destruct (Req_dec (along h w) 0) as [E|N].
      * exists (f :: gs). split; [|split; [now apply (Stay w)|left; cbn; lia]].
        intros g [->|H]; [now left|right; auto].
      * exists gs. split; [now apply incl_tl|]. split.
        -- intros values L. destruct (V values L) as (v & Hv & Gv & Pv). inversion Pv; subst.
           exists v. auto.
        -- right. split; [cbn; lia|]. exists w. auto.
    + inversion Pu as [|? ? Fu Pu']; subst. exists (f :: gs).
      split; [intros g [->|H]; [now left|right; auto]|]. split.
      * apply (Stay (plus w (- along h w / along h u) u)).
        -- rewrite along_plus. field. trivial.
        -- rewrite along_plus, W, Fu. ring.
        -- now apply none_plus.
        -- now apply none_plus.
      * right. split; [cbn; lia|]. exists u. repeat split; trivial. now constructor.
Qed.

(** * Elimination takes one from the rank *)

Section Elimination.

Variable h : form R.
Variable j : nat.
Hypothesis slant : slope h j <> 0.

(** [g'] is g at the foot on h = 0, up to a positive factor. *)
Definition below (g g' : form R) : Prop :=
  exists p, 0 < p /\ forall x, value g' x = p * value g (foot h j x).

Lemma below_along g g' : below g g' -> exists p, 0 < p /\
  forall v, along g' v = p * (along g v - along h v * (slope g j / slope h j)).
Proof.
  intros (p & P & E). exists p. split; trivial. intros v.
  rewrite !along_value, !E, !value_foot. ring.
Qed.

Lemma below_independent gs gs' : Forall2 below gs gs' -> independent gs' -> independent (h :: gs).
Proof.
  intros B D [|t values] L; [easy|]. injection L as L.
  assert (exists values', length values' = length gs' /\ forall v,
    map (fun f => along f v) gs' = values' ->
    map (fun g => along g v - along h v * (slope g j / slope h j)) gs =
    map (fun p => fst p - t * (slope (snd p) j / slope h j)) (combine values gs))
    as (values' & L' & Good).
  { clear D. revert values L. induction B as [|g g' gs gs' G B IH]; intros values L.
    - destruct values; [|easy]. now exists [].
    - destruct values as [|a values]; [easy|]. injection L as L.
      destruct (IH values L) as (values' & L' & Good).
      destruct (@below_along g g' G) as (p & P & E).
      exists (p * (a - t * (slope g j / slope h j)) :: values'). split; [cbn; lia|].
      intros v V. injection V as V0 V. cbn. rewrite (Good v V). f_equal.
      rewrite E in V0. now apply Rmult_eq_reg_l in V0; [|lra]. }
  destruct (D values' L') as (v & V). change (map (fun f => along f v) gs' = values') in V.
  apply Good in V. exists (move v j ((t - along h v) / slope h j)).
  change (map (fun f => along f (move v j ((t - along h v) / slope h j))) (h :: gs) = t :: values).
  cbn. rewrite along_move. f_equal; [field; trivial|].
  clear D L' Good. clear B. revert values L V. induction gs as [|g gs IH]; intros values L V.
  - now destruct values.
  - destruct values as [|a values]; [easy|]. injection L as L. injection V as V0 V.
    cbn in *. rewrite (IH values) by trivial. f_equal. rewrite along_move.
    replace a with (along g v - along h v * (slope g j / slope h j) + t * (slope g j / slope h j))
      by lra. field. trivial.
Qed.

Lemma rank_below zs zs' k : Forall2 below zs zs' -> rank zs' k -> rank (h :: zs) (S k).
Proof.
  intros B [(gs' & I & D & L) U]. split.
  - assert (exists gs, incl gs zs /\ Forall2 below gs gs') as (gs & Igs & Bgs).
    { clear - I B. induction gs' as [|g' gs' IH]; [exists []; split; [easy|constructor]|].
      destruct IH as (gs & A & C); [intros g H; apply I; now right|].
      assert (exists g, In g zs /\ below g g') as (g & G & E).
      { assert (In g' zs') as H by (apply I; now left). clear - B H.
        induction B as [|a a' zs zs' X B IH]; destruct H; subst.
        - exists a. split; [now left|trivial].
        - destruct IH as (g & G & E); trivial. exists g. split; [now right|trivial]. }
      exists (g :: gs). split; [intros f [->|H]; auto|]. now constructor. }
    exists (h :: gs). repeat split.
    + intros f [->|H]; [now left|right; auto].
    + now apply below_independent with gs'.
    + cbn. f_equal. rewrite <- L. clear - Bgs. induction Bgs; cbn; auto.
  - intros fs J Df. destruct (@drop h fs [] (@independent_dual fs Df)) as (gs & Ig & V & Len).
    enough (length gs <= k)%nat by lia.
    assert (incl gs zs) as Igz.
    { intros g G. destruct (J g) as [<-|]; trivial; [now apply Ig|].
      destruct (V (map (fun _ => 1) gs)) as (v & Hv & Gv & _); [now rewrite map_length|].
      pose proof (map_at Gv G) as O. cbn in O. lra. }
    assert (exists gs', incl gs' zs' /\ Forall2 below gs gs') as (gs2 & I2 & B2).
    { clear - Igz B. induction gs as [|g gs IH]; [exists []; split; [easy|constructor]|].
      destruct IH as (gs' & A & C); [intros f H; apply Igz; now right|].
      assert (exists g', In g' zs' /\ below g g') as (g' & G & E).
      { assert (In g zs) as H by (apply Igz; now left). clear - B H.
        induction B as [|a a' zs zs' X B IH]; destruct H; subst.
        - exists a'. split; [now left|trivial].
        - destruct IH as (g' & G & E); trivial. exists g'. split; [now right|trivial]. }
      exists (g' :: gs'). split; [intros f [->|H]; auto|]. now constructor. }
    replace (length gs) with (length gs2) by (clear - B2; induction B2; cbn; auto).
    apply U; trivial. intros values Lv.
    assert (exists values', length values' = length gs /\ forall v, along h v = 0 ->
      map (fun f => along f v) gs = values' -> map (fun f => along f v) gs2 = values)
      as (values' & L' & Good).
    { clear - B2 Lv slant. revert values Lv. induction B2 as [|g g' gs gs' G B IH]; intros values L.
      - destruct values; [|easy]. now exists [].
      - destruct values as [|a values]; [easy|]. injection L as L.
        destruct (IH values L) as (values' & L' & Good).
        destruct (@below_along g g' G) as (p & P & E). exists (a / p :: values'). split; [cbn; lia|].
        intros v Hv Vv. injection Vv as V0 Vv. cbn. rewrite (Good v Hv Vv). f_equal.
        rewrite E, Hv, V0. field. split; trivial; lra. }
    destruct (V values' L') as (v & Hv & Gv & _). exists v. now apply Good.
Qed.

End Elimination.
