(* A proof that no vectors of R^3 have the signs of a chirotope, as the signs and the comparisons that
   the theorem is about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

(* Elements of a chirotope that a file may have: 161,700 triples. *)
let most_elements = 100

let about = function Object members -> List.mem_assoc "elements" members | _ -> false

(* The triples i < j < k below n, in lexicographic order. *)
let triples n =
  let from low = List.init (max 0 (n - low)) (fun i -> low + i) in
  List.concat_map (fun i ->
    List.concat_map (fun j -> List.map (fun k -> (i, j, k)) (from (j + 1))) (from (i + 1)))
    (from 0)

let comparison elements i value =
  let where = Printf.sprintf "proof[%d]" i in
  let index below value = Reader.index where below value in
  match Reader.list where (Some 8) value with
  | [ a; b; c; d; e; smaller; larger; often ] ->
    let element value = Z.of_int (index elements value) in
    let term value =
      match index 3 value with 0 -> First | 1 -> Second | _ -> Third in
    let often =
      match often with Integer n -> n | _ -> malformed "%s has no integer at its end" where in
    { relation = ((((element a, element b), element c), element d), element e);
      smaller = term smaller; larger = term larger; often }
  | _ -> assert false

(* Signs and comparisons. *)
let certificate value =
  let members =
    Reader.keys "the certificate" [ "schema_version"; "certificate"; "elements"; "signs"; "proof" ]
      [] value in
  Reader.version "the certificate" 1 members;
  (match List.assoc "certificate" members with
   | Text "no coordinates" -> ()
   | _ -> malformed "this is no certificate of no coordinates");
  let elements =
    Reader.index "elements" (most_elements + 1) (List.assoc "elements" members) in
  let text = Reader.text "the signs" (List.assoc "signs" members) in
  let triples = triples elements in
  if String.length text <> List.length triples then
    malformed "%d elements have %d signs, not %d" elements (List.length triples)
      (String.length text);
  let sign = function
    | '-' -> Z.minus_one | '0' -> Z.zero | '+' -> Z.one
    | _ -> malformed "the signs are not a text of the signs -, 0, +" in
  let signs = List.mapi (fun at (i, j, k) ->
    (((Z.of_int i, Z.of_int j), Z.of_int k), sign text.[at])) triples in
  (signs, List.mapi (comparison elements) (Reader.list "proof" None (List.assoc "proof" members)))
