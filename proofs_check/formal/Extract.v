(** The checker as an OCaml program, its integers those of zarith. *)

Require Import ZArith Extraction ExtrOcamlZBigInt.
Require Import Checker Soundness.

(** One line beyond the standard library's: without it, gcd counts down bits one by one. *)
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".

Extraction "checker.ml" check.

Print Assumptions not_resisted.
Print Assumptions resisted.
