(* A certificate of an assembly as the question and the proof that the theorem is about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let about = function
  | Object members -> List.mem_assoc "assembly" members
  | _ -> false

(* Bodies are told apart by their names; what a name says does not matter here. *)
let name where value =
  let text = Reader.text where value in
  let characters =
    String.fold_left (fun n c -> if Char.code c land 0xC0 = 0x80 then n else n + 1) 0 text in
  let control i c =
    c < ' ' || c = '\127' || (c = '\xC2' && text.[i + 1] < '\xA0') in
  let bytes = List.init (String.length text) (fun i -> control i text.[i]) in
  if characters < 1 || characters > 40 || List.mem true bytes || String.trim text <> text then
    malformed "%s is not a text of 1 to 40 characters" where;
  text

let body i value =
  let where = Printf.sprintf "bodies[%d]" i in
  match value with
  | Object _ ->
    (* The assembly of a certificate has no outlines. *)
    name where (List.assoc "name" (Reader.keys where [ "name" ] [] value))
  | _ -> name where value

let rec place where names key =
  match names with
  | [] -> malformed "%s: there is no body %S" where key
  | first :: rest -> if first = key then 0 else 1 + place where rest key

let joint names i value =
  let where = Printf.sprintf "contacts[%d]" i in
  let members = match value with
    | Object members -> members
    | _ -> malformed "%s is not an object" where in
  let body key = place where names (Reader.text (where ^ ": " ^ key) (List.assoc key members)) in
  List.iter (fun key ->
    if not (List.mem_assoc key members) then malformed "%s has no key %S" where key)
    [ "body_a"; "body_b" ];
  let is_body (key, _) = key = "body_a" || key = "body_b" in
  let touch = Reader.contact i (Object (List.filter (fun m -> not (is_body m)) members)) in
  let a = body "body_a" in
  let b = if List.assoc "body_b" members = Null then None else Some (body "body_b") in
  if b = Some a then malformed "%s: body_a and body_b are one body" where;
  { body_a = Tree_reader.natural a; body_b = Option.map Tree_reader.natural b; touch }, (a, b)

let assembly value =
  let members =
    Reader.keys "the assembly" [ "bodies"; "contacts" ] [ "schema_version"; "description"; "units" ]
      value in
  if List.mem_assoc "schema_version" members then Reader.version "the assembly" 1 members;
  Reader.labels members;
  let names = List.mapi body (Reader.list "bodies" None (List.assoc "bodies" members)) in
  if List.length (List.sort_uniq compare names) < List.length names then
    malformed "a body is there twice";
  let contacts = Reader.list "contacts" None (List.assoc "contacts" members) in
  let joints = List.mapi (joint names) contacts in
  (names, joints, List.mapi Reader.adhesion contacts)

(* Three numbers for each body, in the order of the bodies. *)
let rows where names value =
  let members = Reader.keys where names [] value in
  List.concat_map (fun key -> Reader.vector (where ^ "." ^ key) 3 (List.assoc key members)) names

(* The same, of those bodies that are there. *)
let some_rows names where value =
  let members = Reader.keys where [] names value in
  List.concat_map (fun key ->
    match List.assoc_opt key members with
    | Some row -> Reader.vector (where ^ "." ^ key) 3 row
    | None -> List.init 3 (fun _ -> Tree_reader.whole 0)) names

(* Shows nothing, and is refused. *)
let nothing = NotResisted (Leaf ([], []))

(* A planar tree about the contacts of some bodies with the rest. *)
let part names joints value =
  let members = Reader.keys "tree" [ "part"; "contacts"; "tree" ] [] value in
  let inside = List.map (fun value ->
      place "tree.part" names (Reader.text "tree.part" value))
    (Reader.list "tree.part" None (List.assoc "part" members)) in
  let places = List.map (Reader.index "tree.contacts" (List.length joints))
    (Reader.list "tree.contacts" None (List.assoc "contacts" members)) in
  let is_in = function None -> false | Some i -> List.mem i inside in
  let crossing =
    List.filteri (fun _ (_, (_, (a, b))) -> is_in (Some a) <> is_in b)
      (List.mapi (fun i j -> (i, j)) joints) in
  if List.map fst crossing <> List.sort compare places
     || List.length (List.sort_uniq compare inside) < List.length inside then nothing
  else
    let rec rank i = function
      | [] -> assert false
      | (first, _) :: rest -> if first = i then 0 else 1 + rank i rest in
    let subject =
      { Tree_reader.contacts = List.length places;
        number = (fun k -> rank (List.nth places k) crossing); tangents = 1;
        motion = (fun where value -> Reader.vector where 3 value);
        whole_multipliers = false; regions = true } in
    NotResistedPart (List.mapi (fun i _ -> is_in (Some i)) names,
      Tree_reader.tree subject (List.assoc "tree" members))

let tree names joints value =
  match value with
  | Object members when List.mem_assoc "part" members -> part names joints value
  | _ ->
    NotResisted (Tree_reader.tree
      { contacts = List.length joints; number = Fun.id; tangents = 1; motion = some_rows names;
        whole_multipliers = true; regions = false } value)

let document value =
  let kind, members = Reader.certificate "assembly" value in
  let names, joints, adhesion = assembly (List.assoc "assembly" members) in
  let load = rows "wrench" names (List.assoc "wrench" members) in
  let question = OfBodies (Tree_reader.natural (List.length names), List.map fst joints, load) in
  let proof =
    if kind = "resisted" then
      Resisted (rows "motion" names (List.assoc "motion" members),
        List.map (Grasp_reader.force 1)
          (Reader.list "forces" (Some (List.length joints)) (List.assoc "forces" members)))
    else tree names joints (List.assoc "tree" members) in
  (kind, question, adhesion, proof)
