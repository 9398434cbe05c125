(** What the checker accepts is true. *)

Require Import Reals ZArith QArith List Bool Lia Lra.
Require Import Model Checker Numbers Rows Leaves Regions Witness.
Import ListNotations.
Open Scope R_scope.
Set Implicit Arguments.

(** * States *)

Lemma state_of_in (P : contact R -> state -> Prop) reals states :
  Forall2 P reals states -> forall i s, state_of i states = Some s ->
  exists r, P r s /\ forall s', P r s' -> Forall2 P reals (set_state i s' states).
Proof.
  induction 1 as [|r s reals states Hr H IH]; intros i s0; cbn [state_of set_state]; [easy|].
  destruct (i =? 0)%Z.
  - intros [= ->]. exists r. split; trivial. now constructor.
  - intros E. destruct (IH _ _ E) as (r' & Hr' & Set'). exists r'. split; trivial.
    intros s' P'. constructor; auto.
Qed.

Lemma all_undecided d reals (bodies : list integer_contact) D :
  Forall2 (weighted D) bodies reals ->
  Forall2 (in_state d) reals (map (fun _ => Undecided) bodies).
Proof. induction 1; cbn; constructor; trivial. exact I. Qed.

(** * Trees *)

Lemma refutes_sound g d forces t : forall r states,
  refutes (integer_form g) r states t = true -> inside r (motion d) ->
  Forall2 (in_state d) (contacts (real_question g)) states ->
  ~ equilibrium (real_question g) d forces.
Proof.
  induction t as [l multipliers | ppp H1 ppm H2 pmp H3 pmm H4 mpp H5 mpm H6 mmp H7 mmm H8
    | j k p q first H1 second H2 | i detached H1 attached H2
    | i stick H1 plus H2 minus H3]; intros r states Test Inside States; cbn [refutes] in Test.
  - eapply leaf_sound; [apply inside_spans, Inside | exact States | exact Test].
  - destruct r; [|discriminate]. bools. cbn [inside] in Inside.
    destruct (orthants_cover Inside)
      as [Here | [Here | [Here | [Here | [Here | [Here | [Here | Here]]]]]]];
      [eapply H1 | eapply H2 | eapply H3 | eapply H4
        | eapply H5 | eapply H6 | eapply H7 | eapply H8]; eassumption.
  - destruct r; [discriminate|]. bools.
    destruct (@edge_covers j k p q g0 g1 g2 g3 (motion d)) as [Here | Here];
      [now apply same_false | assumption | assumption | assumption | eapply H1 | eapply H2];
      eassumption.
  - destruct (state_of i states) as [[]|] eqn:E; try discriminate. bools.
    destruct (state_of_in States _ E) as (r' & _ & Now).
    destruct (Rle_dec (preload r' - stiffness r' * dot (N r') d) 0).
    + eapply H1; [eassumption | assumption | now apply Now].
    + eapply H2; [eassumption | assumption | apply Now; cbn; lra].
  - destruct (state_of i states) as [[]|] eqn:E; try discriminate. bools.
    destruct (state_of_in States _ E) as (r' & Touch & Now). cbn in Touch.
    destruct (Rtotal_order (dot (T r') d) 0) as [L | [L | L]].
    + eapply H3; [eassumption | assumption | now apply Now].
    + eapply H1; [eassumption | assumption | now apply Now].
    + eapply H2; [eassumption | assumption | now apply Now].
Qed.

(** * The theorems *)

(** An accepted proof of "not resisted" leaves no equilibrium, whatever motion and forces. *)
Theorem not_resisted : forall question tree,
  check question (NotResisted tree) = true ->
  forall d forces, ~ equilibrium (real_question question) d forces.
Proof.
  intros g t Test d forces. eapply refutes_sound; [exact Test | cbn; lra |].
  eapply all_undecided, bodies_weighted.
Qed.

(** A proof of "resisted" is accepted exactly when its motion and forces are an equilibrium. *)
Theorem resisted : forall question motion forces,
  check question (Resisted motion forces) = true <->
  equilibrium (real_question question) (real_vector motion) (real_forces forces).
Proof. exact confirms_equilibrium. Qed.
