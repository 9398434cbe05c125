(* An arrangement document of the package, or a certificate that a list of its faces is complete,
   as the planes and the list that the theorems are about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

(* Largest dimension that a file may name, as in the package. *)
let most_coordinates = 1000

(* Integers in the ratio of these numbers, the factor being positive; and the factor. *)
let cleared numbers =
  let common = List.fold_left (fun n q -> Z.lcm n q.qden) Z.one numbers in
  (List.map (fun q -> Z.mul q.qnum (Z.divexact common q.qden)) numbers, common)

let row where value = List.map (Reader.rational where) (Reader.list where None value)

(* The plane n . x = b is the form n . x - b, positive where n . x > b. *)
let plane i normal offset =
  match cleared (offset :: normal) with
  | b :: coefficients, _ ->
    if List.for_all (fun a -> Z.sign a = 0) coefficients then
      malformed "planes[%d] is the zero vector, which defines no plane" i;
    { constant = Z.neg b; coefficients }
  | [], _ -> assert false

(* The planes and the dimension of their space. *)
let planes value =
  let members = Reader.keys "the arrangement" [ "schema_version"; "planes" ]
    [ "offsets"; "dimension"; "description" ] value in
  Reader.version "the arrangement" 1 members;
  Option.iter (fun value -> ignore (Reader.text "the description" value))
    (List.assoc_opt "description" members);
  let normals = List.mapi (fun i value -> row (Printf.sprintf "planes[%d]" i) value)
    (Reader.list "planes" None (List.assoc "planes" members)) in
  let count = List.length normals in
  let offsets =
    match List.assoc_opt "offsets" members with
    | None -> List.map (fun _ -> { qnum = Z.zero; qden = Z.one }) normals
    | Some value ->
      List.map (Reader.rational "offsets") (Reader.list "offsets" (Some count) value) in
  let named =
    Option.map (Reader.index "dimension" (most_coordinates + 1))
      (List.assoc_opt "dimension" members) in
  let dimension =
    match normals, named with
    | normal :: _, _ -> List.length normal
    | [], Some d -> d
    | [], None -> malformed "there are no planes and no dimension" in
  if List.exists (fun normal -> List.length normal <> dimension) normals
     || (named <> None && named <> Some dimension) then
    malformed "the planes have different numbers of coordinates";
  (List.map2 (fun (i, normal) b -> plane i normal b)
     (List.mapi (fun i normal -> (i, normal)) normals) offsets, dimension)

let signs where value =
  let sign = function '-' -> Minus | '0' -> Zero | '+' -> Plus
    | _ -> malformed "%s is not a text of the signs -, 0, +" where in
  List.map sign (List.of_seq (String.to_seq (Reader.text where value)))

(* A sign vector and a point that has it. *)
let face dimension i value =
  let where = Printf.sprintf "faces[%d]" i in
  match Reader.list where (Some 2) value with
  | [ vector; point ] ->
    let point = List.map (Reader.rational where) (Reader.list where (Some dimension) point) in
    let numerators, denominator = cleared point in
    (signs where vector, { numerators; denominator })
  | _ -> assert false

(* Whether a document is about planes alone. *)
let about_planes = function
  | Object members ->
    List.mem_assoc "planes" members && not (List.mem_assoc "grasp" members)
  | _ -> false

type list_of = Regions | All_faces

(* What the list is said to be, the planes, and the list in the order that the theorem asks for. *)
let certificate value =
  let members =
    Reader.keys "the certificate" [ "schema_version"; "certificate"; "planes"; "faces" ] [] value in
  Reader.version "the certificate" 1 members;
  let kind =
    match List.assoc "certificate" members with
    | Text "all regions" -> Regions
    | Text "all faces" -> All_faces
    | _ -> malformed "this is no certificate of all regions or of all faces" in
  let forms, dimension = planes (List.assoc "planes" members) in
  let faces = List.mapi (face dimension) (Reader.list "faces" None (List.assoc "faces" members)) in
  let keyed = List.map (fun (s, w) -> (code Z.one s, (s, w))) faces in
  let sorted = List.stable_sort (fun (a, _) (b, _) -> Z.compare a b) keyed in
  (kind, forms, List.map (fun (_, face) -> face) sorted)
