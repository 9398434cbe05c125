(** Final polynomials: signs of triples that no vectors of R^3 have. *)

Require Import Reals ZArith List Bool Lia Lra Psatz Permutation Mergesort Orders.
Import ListNotations.
Open Scope Z_scope.
Set Implicit Arguments.

(** * The statement *)

Definition triple := (Z * Z * Z)%type.

Definition det (u v w : R * R * R) : R :=
  let '(a, b, c) := u in let '(d, e, f) := v in let '(g, h, i) := w in
  (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g))%R.

Definition has_sign (x : R) (s : Z) : Prop :=
  match s with Z0 => x = 0%R | Zpos _ => (0 < x)%R | Zneg _ => (x < 0)%R end.

(** Vectors, numbered by integers, whose determinants have the signs of a list. *)
Definition coordinates (signs : list (triple * Z)) (v : Z -> R * R * R) : Prop :=
  forall i j k s, In ((i, j, k), s) signs -> has_sign (det (v i) (v j) (v k)) s.

(** * The checker *)

(** The three terms of [abc][ade] - [abd][ace] + [abe][acd] = 0, and one that is smaller than
    another, or as large: a factor of the proof, so often. *)
Inductive term := First | Second | Third.
Record comparison := Compare {
  relation : Z * Z * Z * Z * Z; smaller : term; larger : term; often : Z }.

(** A triple in order, and 1 or -1 by the number of exchanges. *)
Definition sorted (t : triple) : Z * triple :=
  let '(i, j, k) := t in
  if i <? j then
    if j <? k then (1, (i, j, k)) else if i <? k then (-1, (i, k, j)) else (1, (k, i, j))
  else if i <? k then (-1, (j, i, k)) else if j <? k then (1, (j, k, i)) else (-1, (k, j, i)).

Definition same (s t : triple) : bool :=
  let '(i, j, k) := s in let '(a, b, c) := t in (i =? a) && (j =? b) && (k =? c).

(** The sign of a triple in any order, 0 where the list has none. *)
Definition sign (signs : list (triple * Z)) (t : triple) : Z :=
  let (exchanges, t) := sorted t in
  match find (fun entry => same (fst entry) t) signs with
  | Some (_, s) => exchanges * s
  | None => 0
  end.

Definition listed (signs : list (triple * Z)) (t : triple) : bool :=
  existsb (fun entry => same (fst entry) (snd (sorted t))) signs.

Definition brackets (r : Z * Z * Z * Z * Z) (t : term) : triple * triple :=
  let '(a, b, c, d, e) := r in
  match t with
  | First => ((a, b, c), (a, d, e))
  | Second => ((a, b, d), (a, c, e))
  | Third => ((a, b, e), (a, c, d))
  end.

Definition term_sign (signs : list (triple * Z)) (r : Z * Z * Z * Z * Z) (t : term) : Z :=
  let (left, right) := brackets r t in
  let product := Z.sgn (sign signs left * sign signs right) in
  match t with Second => - product | _ => product end.

(** The term beside two others, if they are two. *)
Definition beside (s t : term) : option term :=
  match s, t with
  | First, Second | Second, First => Some Third
  | First, Third | Third, First => Some Second
  | Second, Third | Third, Second => Some First
  | _, _ => None
  end.

(** Whether the signs force a comparison, and whether it is strict. *)
Definition forced (signs : list (triple * Z)) (c : comparison) : option bool :=
  match beside (smaller c) (larger c) with
  | None => None
  | Some third =>
      let s := term_sign signs (relation c) (smaller c) in
      let l := term_sign signs (relation c) (larger c) in
      let t := term_sign signs (relation c) third in
      let (left, right) := brackets (relation c) third in
      if negb (s =? 0) && (l =? - s) && listed signs left && listed signs right then
        if t =? 0 then Some false
        else if (t =? s) && (0 <=? often c) then Some (0 <? often c)
        else None
      else None
  end.

Fixpoint all_forced (signs : list (triple * Z)) (proof : list comparison) (strict : bool) : bool :=
  match proof with
  | [] => strict
  | c :: proof =>
      match forced signs c with
      | None => false
      | Some strict' => all_forced signs proof (strict || strict')
      end
  end.

(** The triples that a comparison multiplies, with exponents. *)
Definition exponents (c : comparison) : list (triple * Z) :=
  let (l1, l2) := brackets (relation c) (larger c) in
  let (s1, s2) := brackets (relation c) (smaller c) in
  [(snd (sorted l1), often c); (snd (sorted l2), often c);
   (snd (sorted s1), - often c); (snd (sorted s2), - often c)].

Module ByTriple <: TotalLeBool.
  Definition t := (triple * Z)%type.
  Definition leb (x y : t) : bool :=
    let '(i, j, k, _) := x in let '(a, b, c, _) := y in
    if i =? a then if j =? b then k <=? c else j <=? b else i <=? a.
  Theorem leb_total : forall x y, leb x y = true \/ leb y x = true.
  Proof.
    intros [[[i j] k] s] [[[a b] c] r]. unfold leb. rewrite (Z.eqb_sym a i), (Z.eqb_sym b j).
    destruct (i =? a); [destruct (j =? b)|]; rewrite !Z.leb_le; lia.
  Qed.
End ByTriple.
Module Import ByTripleSort := Sort ByTriple.

(** Whether exponents add up to 0 wherever equal triples stand side by side. *)
Fixpoint cancel (t : triple) (sum : Z) (l : list (triple * Z)) : bool :=
  match l with
  | [] => sum =? 0
  | (s, z) :: l => if same s t then cancel t (sum + z) l else (sum =? 0) && cancel s z l
  end.

Definition final (signs : list (triple * Z)) (proof : list comparison) : bool :=
  all_forced signs proof false && cancel (0, 0, 0) 0 (sort (flat_map exponents proof)).

(** * It is right *)

Lemma same_eq s t : same s t = true -> s = t.
Proof.
  destruct s as [[i j] k], t as [[a b] c]. cbn.
  rewrite !andb_true_iff, !Z.eqb_eq. now intros [[-> ->] ->].
Qed.

Lemma has_sign_neg x s : has_sign x s -> has_sign (- x) (- s).
Proof. destruct s; cbn; lra. Qed.

Lemma has_sign_mult x y s r : has_sign x s -> has_sign y r -> has_sign (x * y) (s * r).
Proof. destruct s, r; cbn; intros; subst; nra. Qed.

Lemma has_sign_sgn x s : has_sign x s -> has_sign x (Z.sgn s).
Proof. now destruct s. Qed.

Section Sound.

Variable signs : list (triple * Z).
Variable v : Z -> R * R * R.
Hypothesis H : coordinates signs v.

Definition at_triple (t : triple) : R :=
  let '(i, j, k) := t in det (v i) (v j) (v k).

Lemma at_sorted t : at_triple t = (IZR (fst (sorted t)) * at_triple (snd (sorted t)))%R.
Proof.
  destruct t as [[i j] k]. unfold sorted.
  repeat match goal with |- context [if ?b then _ else _] => destruct b end; cbn;
  destruct (v i) as [[? ?] ?], (v j) as [[? ?] ?], (v k) as [[? ?] ?]; cbn; ring.
Qed.

Lemma sign_right t : listed signs t = true -> has_sign (at_triple t) (sign signs t).
Proof.
  unfold listed, sign. rewrite at_sorted.
  assert (E : fst (sorted t) = 1 \/ fst (sorted t) = -1).
  { destruct t as [[i j] k]. cbn.
    destruct (i <? j), (j <? k), (i <? k); cbn; auto. }
  destruct (sorted t) as [e s]. cbn [fst snd] in *. intros L.
  destruct (find _ _) as [[s' r]|] eqn:F.
  - apply find_some in F. destruct F as [I S]. apply same_eq in S. cbn in S. subst s'.
    apply has_sign_mult.
    + destruct E as [-> | ->]; cbn; lra.
    + destruct s as [[i j] k]. now apply H.
  - apply existsb_exists in L. destruct L as (x & I & S).
    now rewrite (find_none _ _ F x I) in S.
Qed.

(** A sign that is not 0 is one of the list. *)
Lemma sign_listed t : sign signs t <> 0 -> listed signs t = true.
Proof.
  unfold listed, sign. destruct (sorted t) as [e s]. cbn [snd].
  destruct (find _ _) as [[s' r]|] eqn:F; [|easy]. intros _.
  apply find_some in F. apply existsb_exists. now exists (s', r).
Qed.

Definition at_term (r : Z * Z * Z * Z * Z) (t : term) : R :=
  let product := (at_triple (fst (brackets r t)) * at_triple (snd (brackets r t)))%R in
  match t with Second => - product | _ => product end.

Lemma relation_holds r : (at_term r First + at_term r Second + at_term r Third = 0)%R.
Proof.
  destruct r as [[[[a b] c] d] e]. cbn.
  destruct (v a) as [[? ?] ?], (v b) as [[? ?] ?], (v c) as [[? ?] ?], (v d) as [[? ?] ?],
    (v e) as [[? ?] ?]. cbn. ring.
Qed.

Lemma term_listed r t :
  listed signs (fst (brackets r t)) = true -> listed signs (snd (brackets r t)) = true ->
  has_sign (at_term r t) (term_sign signs r t).
Proof.
  unfold at_term, term_sign. destruct (brackets r t) as [x y]. cbn [fst snd]. intros X Y.
  assert (P : has_sign (at_triple x * at_triple y) (Z.sgn (sign signs x * sign signs y)))
    by (apply has_sign_sgn, has_sign_mult; now apply sign_right).
  destruct t; trivial. now apply has_sign_neg.
Qed.

Lemma term_right r t : term_sign signs r t <> 0 -> has_sign (at_term r t) (term_sign signs r t).
Proof.
  intros N.
  assert (sign signs (fst (brackets r t)) <> 0 /\ sign signs (snd (brackets r t)) <> 0) as [X Y].
  { unfold term_sign in N. destruct (brackets r t) as [x y]. cbn [fst snd].
    split; intros E; apply N; rewrite E, ?Z.mul_0_r; now destruct t. }
  apply term_listed; now apply sign_listed.
Qed.

(** * Products *)

Definition size (t : triple) : R := Rabs (at_triple t).

Fixpoint product (l : list (triple * Z)) : R :=
  match l with [] => 1 | (t, z) :: l => powerRZ (size t) z * product l end%R.

Definition nonzero (l : list (triple * Z)) := forall t z, In (t, z) l -> size t <> 0%R.

Lemma product_app l m : product (l ++ m) = (product l * product m)%R.
Proof. induction l as [|[t z] l IH]; cbn; [lra | rewrite IH; lra]. Qed.

Lemma product_permutation l m : Permutation l m -> product l = product m.
Proof.
  induction 1 as [|[t z] l m _ IH|[t z] [s y] l|l m k _ IH _ IH']; cbn; trivial.
  - now rewrite IH.
  - ring.
  - now rewrite IH.
Qed.

Lemma cancel_right l : forall t sum, size t <> 0%R \/ sum = 0 -> nonzero l ->
  cancel t sum l = true -> (powerRZ (size t) sum * product l = 1)%R.
Proof.
  induction l as [|[s z] l IH]; cbn; intros t sum T N C.
  - apply Z.eqb_eq in C. subst. cbn. lra.
  - assert (S : size s <> 0%R) by (apply (N s z); now left).
    assert (N' : nonzero l) by (intros u y I; apply (N u y); now right).
    destruct (same s t) eqn:E.
    + apply same_eq in E. subst. rewrite <- Rmult_assoc, <- powerRZ_add by trivial.
      apply IH; auto.
    + apply andb_true_iff in C. destruct C as [Z C]. apply Z.eqb_eq in Z. subst. cbn.
      rewrite Rmult_1_l. apply IH; auto.
Qed.

Lemma size_sorted t : size (snd (sorted t)) = size t.
Proof.
  unfold size. rewrite (at_sorted t), Rabs_mult.
  replace (Rabs (IZR (fst (sorted t)))) with 1%R; [lra|].
  destruct t as [[i j] k]. cbn. unfold Rabs.
  destruct (i <? j), (j <? k), (i <? k); cbn; destruct (Rcase_abs _) as [?|?]; lra.
Qed.

Lemma term_size r t :
  Rabs (at_term r t) = (size (fst (brackets r t)) * size (snd (brackets r t)))%R.
Proof. unfold at_term, size. rewrite <- Rabs_mult. destruct t; rewrite ?Rabs_Ropp; trivial. Qed.

Lemma exponents_product c :
  at_term (relation c) (larger c) <> 0%R -> at_term (relation c) (smaller c) <> 0%R ->
  nonzero (exponents c) /\
  product (exponents c) =
    powerRZ (Rabs (at_term (relation c) (larger c)) / Rabs (at_term (relation c) (smaller c)))
      (often c).
Proof.
  intros L S. apply Rabs_no_R0 in L, S. rewrite term_size in L, S. rewrite !term_size.
  unfold exponents.
  destruct (brackets (relation c) (larger c)) as [l1 l2].
  destruct (brackets (relation c) (smaller c)) as [s1 s2]. cbn [fst snd] in *.
  assert (size l1 <> 0 /\ size l2 <> 0 /\ size s1 <> 0 /\ size s2 <> 0)%R as (A & B & C & D)
    by (repeat split; intros E; rewrite E in *; lra).
  split.
  - intros t z I. cbn in I.
    repeat destruct I as [I|I]; try easy; injection I as <- <-; now rewrite size_sorted.
  - cbn [product]. rewrite !size_sorted. unfold Rdiv.
    rewrite !powerRZ_mult, powerRZ_inv', powerRZ_mult, !powerRZ_neg'. field.
    repeat split; now apply powerRZ_NOR.
Qed.

(** What the signs force holds: the ratio is 1, or its power is at least 1. *)
Lemma forced_right c strict : forced signs c = Some strict ->
  nonzero (exponents c) /\
  if strict then (1 < product (exponents c))%R else (1 <= product (exponents c))%R.
Proof.
  unfold forced. destruct (beside (smaller c) (larger c)) as [third|] eqn:B; [|easy].
  pose proof (relation_holds (relation c)) as Sum.
  pose proof (exponents_product c) as P.
  pose proof (term_right (relation c) (smaller c)) as S.
  pose proof (term_right (relation c) (larger c)) as L.
  pose proof (term_listed (relation c) third) as T.
  destruct (brackets (relation c) third) as [left right]. cbn [fst snd] in T.
  set (s := term_sign signs (relation c) (smaller c)) in *.
  set (l := term_sign signs (relation c) (larger c)) in *.
  set (t := term_sign signs (relation c) third) in *.
  destruct (negb (s =? 0) && (l =? - s) && listed signs left && listed signs right) eqn:E;
    [|easy].
  repeat (apply andb_true_iff in E; destruct E as [E ?]).
  apply negb_true_iff, Z.eqb_neq in E. apply Z.eqb_eq in H2.
  specialize (S E). specialize (T H1 H0).
  assert (L' : l <> 0) by lia. specialize (L L').
  assert (Three : (at_term (relation c) (smaller c) + at_term (relation c) (larger c)
    + at_term (relation c) third = 0)%R).
  { destruct (smaller c), (larger c); try easy; cbn in B; injection B as <-; lra. }
  set (x := at_term (relation c) (smaller c)) in *.
  set (y := at_term (relation c) (larger c)) in *.
  set (z := at_term (relation c) third) in *.
  assert (x <> 0 /\ y <> 0)%R as [X Y]
    by (split; intros Zero; rewrite Zero in *; [destruct s|destruct l]; cbn in *; try easy; lra).
  destruct (P Y X) as [N Eq]. clear P. rewrite Eq. clear Eq.
  assert (Xpos : (0 < Rabs x)%R) by now apply Rabs_pos_lt.
  destruct (t =? 0) eqn:Zero.
  - apply Z.eqb_eq in Zero. rewrite Zero in T. cbn in T. intros Q. injection Q as <-.
    split; trivial. replace (Rabs y / Rabs x)%R with 1%R; [rewrite powerRZ_R1; lra|].
    replace y with (- x)%R by lra. rewrite Rabs_Ropp. field. lra.
  - destruct ((t =? s) && (0 <=? often c)) eqn:M; [|easy]. intros Q. injection Q as <-.
    apply andb_true_iff in M. destruct M as [M O]. apply Z.eqb_eq in M. apply Z.leb_le in O.
    rewrite M, H2 in *. split; trivial.
    assert (G : (1 < Rabs y / Rabs x)%R).
    { apply Rmult_lt_reg_r with (Rabs x); trivial.
      replace (Rabs y / Rabs x * Rabs x)%R with (Rabs y) by (field; lra).
      destruct s; cbn in S, L, T; [easy| |].
      - rewrite (Rabs_left y), (Rabs_right x) by lra. lra.
      - rewrite (Rabs_right y), (Rabs_left x) by lra. lra. }
    destruct (often c) as [|p|p]; cbn; [lra | | lia].
    apply Rlt_pow_R1; trivial. apply Pos2Nat.is_pos.
Qed.

Lemma all_forced_right proof : forall strict, all_forced signs proof strict = true ->
  nonzero (flat_map exponents proof) /\
  (1 <= product (flat_map exponents proof))%R /\
  (strict = false -> 1 < product (flat_map exponents proof))%R.
Proof.
  induction proof as [|c proof IH]; cbn [all_forced flat_map]; intros strict A.
  - subst. cbn. repeat split; [easy | lra | easy].
  - destruct (forced signs c) as [strict'|] eqn:F; [|easy].
    apply forced_right in F. destruct F as [N F]. destruct (IH _ A) as (M & G & G'). clear IH.
    rewrite product_app. repeat split.
    + intros t z I. apply in_app_iff in I. destruct I; [now apply (N t z) | now apply (M t z)].
    + assert (1 <= product (exponents c))%R by (destruct strict'; lra). nra.
    + intros ->. cbn in G'. destruct strict'; [nra | specialize (G' eq_refl); nra].
Qed.

End Sound.

(** A proof that is accepted leaves no vectors of R^3 with these signs, rational or not. *)
Theorem no_coordinates : forall signs proof, final signs proof = true ->
  ~ exists v : Z -> R * R * R, coordinates signs v.
Proof.
  intros signs proof F [v C]. apply andb_true_iff in F. destruct F as [A E].
  destruct (all_forced_right C _ _ A) as (N & _ & G). specialize (G eq_refl).
  pose proof (Permuted_sort (flat_map exponents proof)) as P.
  rewrite (product_permutation v P) in G.
  apply (cancel_right (v := v)) in E.
  - cbn [powerRZ] in E. lra.
  - now right.
  - intros t z I. apply (N t z). apply Permutation_sym in P.
    now apply (Permutation_in _ P).
Qed.
