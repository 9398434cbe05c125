(* Trees of contact states and of regions of motions, of grasps and of assemblies, as the theorem
   takes them. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let whole n = { qnum = Z.of_int n; qden = Z.one }

let rec natural n = if n = 0 then O else S (natural (n - 1))

(* What the nodes of a tree are about. *)
type subject = {
  contacts : int;
  number : int -> int;  (* of a contact, among those of the question *)
  tangents : int;
  motion : string -> t -> q list;
  whole_multipliers : bool;  (* of a contact both; a leaf may have none *)
  regions : bool;
}

(* The contact of a key of multipliers. *)
let contact_key subject key =
  let i =
    if Reader.digits key && String.length key < 10 then int_of_string key else -1 in
  if i < 0 || i >= subject.contacts || string_of_int i <> key then
    malformed "multipliers: there is no contact %S" key;
  i

(* Multipliers of a leaf: the key is a contact, the value [alpha] or [alpha, h]. *)
let multiplier subject (key, value) =
  let i = contact_key subject key in
  let row =
    match value with
    | List [ alpha ] when not subject.whole_multipliers -> [ Reader.rational "alpha" alpha ]
    | _ -> Reader.vector "multipliers" (subject.tangents + 1) value in
  let entry k = match List.nth_opt row k with Some x -> x | None -> whole 0 in
  (Z.of_int (subject.number i), ((entry 0, entry 1), entry 2))

let leaf subject value =
  let optional = if subject.whole_multipliers then [ "multipliers" ] else [] in
  let required = "virtual_motion" :: (if optional = [] then [ "multipliers" ] else []) in
  let members = Reader.keys "a leaf" required optional value in
  let given =
    match List.assoc_opt "multipliers" members with
    | Some (Object given) -> given
    | None -> []
    | Some _ -> malformed "multipliers is not an object" in
  let motion = subject.motion "virtual_motion" (List.assoc "virtual_motion" members) in
  Leaf (motion, List.map (multiplier subject) given)

(* What is known of a contact, as far as a further split needs to know. *)
type decided = Touches | Closed | Slides of direction * direction

let after u v = qpositive (qturn u v)

(* Each direction with the next one, the last with the first. *)
let around = function
  | [] -> []
  | first :: rest as all -> List.combine all (rest @ [ first ])

(* The region is cut between g_j and g_k, which are opposite. *)
let halved j k first second =
  Edge (natural j, natural k, whole 1, whole 1, first, second)

let orthants = function
  | [ a; b; c; d; e; f; g; h ] ->
    let last = halved 4 3 and middle = halved 3 2 in
    halved 2 1 (middle (last a b) (last c d)) (middle (last e f) (last g h))
  | _ -> assert false

(* [cone]: the region is simplicial; [states]: the contacts that are decided. *)
let rec node subject depth cone states value =
  let child = node subject (depth + 1) in
  let has key = match value with Object members -> List.mem_assoc key members | _ -> false in
  let split required optional =
    if depth = Reader.most_splits then
      malformed "more than %d splits in a row" Reader.most_splits;
    Reader.keys "a node" required optional value in
  let contact members =
    let i = Reader.index "contact" subject.contacts (List.assoc "contact" members) in
    (i, Z.of_int (subject.number i)) in
  match value with
  | List _ when not subject.whole_multipliers -> Leaf (subject.motion "a virtual motion" value, [])
  | _ when has "virtual_motion" -> leaf subject value
  | _ when subject.regions && has "orthants" ->
    let members = split [ "orthants" ] [] in
    if cone then malformed "orthants cut the half space only";
    orthants (List.map (child true states)
                (Reader.list "orthants" (Some 8) (List.assoc "orthants" members)))
  | _ when subject.regions && has "edge" ->
    let members = split [ "edge"; "children" ] [ "at" ] in
    if not cone then malformed "an edge cuts a simplicial cone only";
    let corner value = Reader.index "a generator" 4 value in
    let p, q =
      match List.assoc_opt "at" members with
      | Some value -> Reader.pair "at" value
      | None -> (whole 1, whole 1) in
    List.iter (fun x ->
      if Z.sign x.qnum <= 0 || not (Z.equal x.qden Z.one) then
        malformed "at has integers above 0 only") [ p; q ];
    (match List.map corner (Reader.list "edge" (Some 2) (List.assoc "edge" members)),
           List.map (child true states)
             (Reader.list "children" (Some 2) (List.assoc "children" members)) with
     | [ j; k ], [ first; second ] ->
       if j = k then malformed "an edge has two generators";
       Edge (natural j, natural k, p, q, first, second)
     | _ -> assert false)
  | _ when has "attachment" ->
    let members = split [ "contact"; "attachment" ] [] in
    let i, number = contact members in
    if List.mem_assoc i states then malformed "contact %d is not undecided" (i + 1);
    let parts = Reader.keys "attachment" [ "detached"; "attached" ] []
      (List.assoc "attachment" members) in
    Attachment (number,
      child cone ((i, Closed) :: states) (List.assoc "detached" parts),
      child cone ((i, Touches) :: states) (List.assoc "attached" parts))
  | _ when subject.tangents = 1 && has "slip" ->
    let members = split [ "contact"; "slip" ] [] in
    let i, number = contact members in
    if List.assoc_opt i states <> Some Touches then malformed "contact %d is not attached" (i + 1);
    let parts = Reader.keys "slip" [ "stick"; "slip+"; "slip-" ] []
      (List.assoc "slip" members) in
    let part key = child cone ((i, Closed) :: states) (List.assoc key parts) in
    let stick = part "stick" in
    let plus = part "slip+" in
    Slip (number, stick, plus, part "slip-")
  | _ when subject.tangents = 2 && has "directions" ->
    let members = split [ "contact"; "directions"; "children" ] [] in
    let i, number = contact members in
    let ends = List.map (Reader.pair "directions")
      (Reader.list "directions" None (List.assoc "directions" members)) in
    let children = Reader.list "children" (Some (max 2 (List.length ends + 1)))
      (List.assoc "children" members) in
    let sector (u, v) = child cone ((i, Slides (u, v)) :: states) in
    (match List.assoc_opt i states, ends, children with
     | Some (Slides (u, v)), [ middle ], [ first; second ] ->
       if not (after u middle && after middle v) then
         malformed "contact %d: the direction is not inside its sector" (i + 1);
       Cut (number, middle, sector (u, middle) first, sector (middle, v) second)
     | Some Touches, _ :: _, stick :: rest ->
       let pairs = around ends in
       let below (_, y) = Z.sign y.qnum < 0 in
       let crossings = List.filter (fun (u, v) -> below u && not (below v)) pairs in
       if not (List.for_all (fun (u, v) -> after u v) pairs && List.length crossings = 1) then
         malformed "contact %d: the directions do not go round once, each less than half a turn \
                    from the one before" (i + 1);
       let stick = child cone ((i, Closed) :: states) stick in
       let sectors = List.map2 (fun (u, v) part -> (u, sector (u, v) part)) pairs rest in
       Directions (number, stick, sectors)
     | _ -> malformed "contact %d is not attached, or its sector has not one direction" (i + 1))
  | _ when subject.tangents = 2 && has "plane" ->
    malformed "the tree is planar along two axes, %s" Reader.outside
  | _ when subject.tangents = 2 && has "faces" ->
    malformed "faces are for friction pyramids, %s" Reader.outside
  | _ -> malformed "a node is a virtual motion or an object that says how it splits"

let tree subject = node subject 0 false []
