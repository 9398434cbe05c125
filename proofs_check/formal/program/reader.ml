(* A certificate of the package as the question and the proof that the theorems are about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

(* Splits in a row, as in the package's own checker. *)
let most_splits = 300

let keys where required optional value =
  match value with
  | Object members ->
    List.iter (fun (key, _) ->
      if not (List.mem key required || List.mem key optional) then
        malformed "%s has the unknown key %S" where key) members;
    List.iter (fun key ->
      if not (List.mem_assoc key members) then malformed "%s has no key %S" where key) required;
    members
  | _ -> malformed "%s is not an object" where

let list where length value =
  match value with
  | List items when length = None || length = Some (List.length items) -> items
  | List items -> malformed "%s has %d entries" where (List.length items)
  | _ -> malformed "%s is not a list" where

let text where = function Text text -> text | _ -> malformed "%s is not a text" where

(* A rational in lowest terms. *)
let fraction n d =
  let g = Z.gcd n d in
  { qnum = Z.divexact n g; qden = Z.divexact d g }

let digits text = text <> "" && String.for_all (fun c -> c >= '0' && c <= '9') text

(* An integer, or a text: "12", "-7/3", "0.25", "1e-3"; no other form. *)
let rational where value =
  let wrong () = malformed "%s is not an exact number such as \"7/3\", \"-0.25\" or 12" where in
  let unsigned text =
    match String.index_opt text '/', String.index_opt text '.' with
    | None, None when digits text -> fraction (Z.of_string text) Z.one
    | Some i, None ->
      let n = String.sub text 0 i and d = String.sub text (i + 1) (String.length text - i - 1) in
      if not (digits n && digits d) || Z.equal (Z.of_string d) Z.zero then wrong ();
      fraction (Z.of_string n) (Z.of_string d)
    | None, Some i ->
      let decimals = String.sub text (i + 1) (String.length text - i - 1) in
      let all = String.sub text 0 i ^ decimals in
      if not (digits all) then wrong ();
      fraction (Z.of_string all) (Z.pow (Z.of_int 10) (String.length decimals))
    | _ -> wrong () in
  (* A decimal may have an exponent of at most four digits. *)
  let scaled text =
    match String.index_opt (String.lowercase_ascii text) 'e' with
    | None -> unsigned text
    | Some i ->
      let after = String.sub text (i + 1) (String.length text - i - 1) in
      let signed = after <> "" && (after.[0] = '-' || after.[0] = '+') in
      let power = if signed then String.sub after 1 (String.length after - 1) else after in
      if String.contains_from text 0 '/' || not (digits power) || String.length power > 4 then wrong ();
      let q = unsigned (String.sub text 0 i) and ten = Z.pow (Z.of_int 10) (int_of_string power) in
      if after.[0] = '-' then fraction q.qnum (Z.mul q.qden ten)
      else fraction (Z.mul q.qnum ten) q.qden in
  match value with
  | Integer n -> fraction n Z.one
  | Text text when String.length text > longest_number ->
    malformed "%s has more than %d characters" where longest_number
  | Text text when text <> "" && (text.[0] = '-' || text.[0] = '+') ->
    let q = scaled (String.sub text 1 (String.length text - 1)) in
    if text.[0] = '-' then { q with qnum = Z.neg q.qnum } else q
  | Text text -> scaled text
  | _ -> wrong ()

let vector where size value = List.map (rational where) (list where (Some size) value)

let pair where value =
  match List.map (rational where) (list where (Some 2) value) with
  | [ x; y ] -> (x, y)
  | _ -> assert false

let index where below value =
  match value with
  | Integer i when Z.sign i >= 0 && Z.lt i (Z.of_int below) -> Z.to_int i
  | _ -> malformed "%s is not a number from 0 to %d" where (below - 1)

let version ?old where due members =
  let dues = due :: Option.to_list old in
  match List.assoc "schema_version" members with
  | Integer n when List.exists (fun due -> Z.equal n (Z.of_int due)) dues -> ()
  | _ -> malformed "the schema_version of %s is not %d" where due

(* Friction, preload and stiffness of a contact, at least 0; in space the stiffness is above 0. *)
let law ~spring where members =
  let number key missing =
    match List.assoc_opt key members with
    | Some value -> rational (where ^ ": " ^ key) value
    | None -> fraction (Z.of_int missing) Z.one in
  let friction = number "friction" 0 in
  let stiffness = number "stiffness" 1 in
  let preload = number "preload" 0 in
  if Z.sign friction.qnum < 0 then malformed "%s: the friction is below 0" where;
  if Z.sign stiffness.qnum < (if spring then 1 else 0) then
    malformed "%s: the stiffness is not %s 0" where (if spring then "above" else "at least");
  if Z.sign preload.qnum < 0 then malformed "%s: the preload is below 0" where;
  { friction; stiffness; preload }

(* A contact in the plane, with a unit normal. *)
let contact i value =
  let where = Printf.sprintf "contacts[%d]" i in
  let members = keys where [ "point"; "normal"; "friction" ] [ "stiffness"; "preload"; "adhesion" ] value in
  let point_x, point_y = pair (where ^ ": point") (List.assoc "point" members) in
  let normal_x, normal_y = pair (where ^ ": normal") (List.assoc "normal" members) in
  let values2 = law ~spring:false where members in
  let common = Z.lcm normal_x.qden normal_y.qden in
  let square q = let n = Z.mul q.qnum (Z.divexact common q.qden) in Z.mul n n in
  if not (Z.equal (Z.add (square normal_x) (square normal_y)) (Z.mul common common)) then
    malformed "%s: the normal is not exactly unit" where;
  { point_x; point_y; normal_x; normal_y; values2 }

(* How strongly a contact, which has been read, pulls. *)
let adhesion i value =
  let where = Printf.sprintf "contacts[%d]" i in
  match value with
  | Object members when List.mem_assoc "adhesion" members ->
    let pull = rational (where ^ ": adhesion") (List.assoc "adhesion" members) in
    if Z.sign pull.qnum < 0 then malformed "%s: the adhesion is below 0" where;
    pull
  | _ -> fraction Z.zero Z.one

(* A label; what it says does not matter here. *)
let unit_of_measure where value =
  let text = text where value in
  let bytes = String.length text in
  let characters =
    String.fold_left (fun n c -> if Char.code c land 0xC0 = 0x80 then n else n + 1) 0 text in
  if characters < 1 || characters > 20 || String.exists (fun c -> c < ' ' || c = '\127') text
     || text.[0] = ' ' || text.[bytes - 1] = ' ' then
    malformed "%s is not a text of 1 to 20 characters" where

let labels members =
  Option.iter (fun value -> ignore (text "the description" value))
    (List.assoc_opt "description" members);
  Option.iter (fun value ->
    List.iter (fun (key, value) -> unit_of_measure ("the unit of " ^ key) value)
      (keys "units" [ "length"; "force" ] [] value))
    (List.assoc_opt "units" members)

let grasp contact value =
  let members =
    keys "the grasp" [ "schema_version"; "contacts" ] [ "description"; "units" ] value in
  version "the grasp" 1 members;
  labels members;
  List.mapi contact (list "contacts" None (List.assoc "contacts" members))

let outside = "which is outside what is proved; omit --verified to have it checked"

(* What a certificate may have beside what is proved. *)
let others =
  [ ("max_displacement", "a largest displacement of contact points");
    ("bounds", "bounds of grasps"); ("pyramid", "friction pyramids");
    ("enclosure", "an enclosure of an equilibrium (Krawczyk's test)") ]

(* The kind of a certificate about a grasp or an assembly, and its keys with their values. *)
let certificate subject value =
  let members = match value with Object members -> members | _ -> [] in
  let kind =
    match List.assoc_opt "certificate" members with
    | Some (Text ("resisted" | "not resisted" as kind)) -> kind
    | Some (Text ("stable" | "unstable")) -> malformed "this is an old certificate"
    | _ -> malformed "this is not a certificate" in
  List.iter (fun (key, what) ->
    if List.mem_assoc key members then malformed "the certificate has %s, %s" what outside) others;
  let own = if kind = "resisted" then [ "motion"; "forces" ] else [ "tree" ] in
  ignore (keys "the certificate" ([ "schema_version"; "certificate"; subject; "wrench" ] @ own) []
    value);
  version ~old:3 "the certificate" 4 members;
  (kind, members)
