(* A certificate of a grasp in space as the question and the proof that the theorems are about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let whole n = { qnum = Z.of_int n; qden = Z.one }

let vector3 where value =
  match List.map (Reader.rational where) (Reader.list where (Some 3) value) with
  | [ x_of; y_of; z_of ] -> { x_of; y_of; z_of }
  | _ -> assert false

let screw where value =
  match List.map (Reader.rational where) (Reader.list where (Some 6) value) with
  | [ a; b; c; d; e; f ] ->
    { along = { x_of = a; y_of = b; z_of = c }; about = { x_of = d; y_of = e; z_of = f } }
  | _ -> assert false

let is_one q = Z.equal q.qnum q.qden

(* The x axis turned by the smallest rotation that takes the z axis to the normal. *)
let usual_tangent n =
  let up = qplus (whole 1) n.z_of in
  if qzero up then { x_of = whole 1; y_of = whole 0; z_of = whole 0 }
  else
    let inverse = Reader.fraction up.qden up.qnum in
    let over a b = qtimes (qtimes a b) inverse in
    { x_of = qminus (whole 1) (over n.x_of n.x_of);
      y_of = qminus (whole 0) (over n.x_of n.y_of);
      z_of = qminus (whole 0) n.x_of }

let contact i value =
  let where = Printf.sprintf "contacts[%d]" i in
  let members = Reader.keys where [ "point"; "normal"; "friction" ]
    [ "stiffness"; "preload"; "tangent" ] value in
  let vector key = vector3 (where ^ ": " ^ key) (List.assoc key members) in
  let normal3 = vector "normal" in
  if not (is_one (qdot3 normal3 normal3)) then
    malformed "%s: the normal is not exactly unit" where;
  let tangent3 =
    if List.mem_assoc "tangent" members then vector "tangent" else usual_tangent normal3 in
  if not (is_one (qdot3 tangent3 tangent3) && qzero (qdot3 normal3 tangent3)) then
    malformed "%s: the tangent is not exactly unit and at a right angle to the normal" where;
  let friction3, stiffness3, preload3 = Reader.law where members in
  { point3 = vector "point"; normal3; tangent3; friction3; stiffness3; preload3 }

(* Whether a certificate is of a grasp in space: its first contact has three coordinates. *)
let about = function
  | Object members ->
    (match List.assoc_opt "grasp" members with
     | Some (Object grasp) ->
       (match List.assoc_opt "contacts" grasp with
        | Some (List (Object contact :: _)) ->
          (match List.assoc_opt "point" contact with
           | Some (List [ _; _; _ ]) -> true
           | _ -> false)
        | _ -> false)
     | _ -> false)
  | _ -> false

let multiplier contacts (key, value) =
  let i = Reader.contact_key contacts key in
  match value with
  | List [ alpha ] -> (i, ((Reader.rational "alpha" alpha, whole 0), whole 0))
  | _ ->
    let found = vector3 "multipliers" value in
    (i, ((found.x_of, found.y_of), found.z_of))

(* What is known of a contact, as far as a further split needs to know. *)
type decided = Touches | Closed | Slides of direction * direction

let after u v = qpositive (qturn u v)

(* Each direction with the next one, the last with the first. *)
let around = function
  | [] -> []
  | first :: rest as all -> List.combine all (rest @ [ first ])

let rec node contacts depth states value =
  let child states = node contacts (depth + 1) states in
  let split () =
    if depth = Reader.most_splits then
      malformed "more than %d splits in a row" Reader.most_splits in
  let has key = match value with Object members -> List.mem_assoc key members | _ -> false in
  let at members = Reader.index "contact" contacts (List.assoc "contact" members) in
  match value with
  | List _ -> Leaf3 (screw "a virtual motion" value, [])
  | _ when has "virtual_motion" ->
    let motion, given = Reader.long_leaf value in
    Leaf3 (screw "virtual_motion" motion, List.map (multiplier contacts) given)
  | _ when has "attachment" ->
    split ();
    let members = Reader.keys "a node" [ "contact"; "attachment" ] [] value in
    let i = at members in
    if List.mem_assoc i states then malformed "contact %d is not undecided" (i + 1);
    let parts = Reader.keys "attachment" [ "detached"; "attached" ] []
      (List.assoc "attachment" members) in
    Attachment3 (Z.of_int i,
      child ((i, Closed) :: states) (List.assoc "detached" parts),
      child ((i, Touches) :: states) (List.assoc "attached" parts))
  | _ when has "directions" ->
    split ();
    let members = Reader.keys "a node" [ "contact"; "directions"; "children" ] [] value in
    let i = at members in
    let ends = List.map (Reader.pair "directions")
      (Reader.list "directions" None (List.assoc "directions" members)) in
    let children = Reader.list "children" (Some (max 2 (List.length ends + 1)))
      (List.assoc "children" members) in
    let sector (u, v) = child ((i, Slides (u, v)) :: states) in
    (match List.assoc_opt i states, ends, children with
     | Some (Slides (u, v)), [ middle ], [ first; second ] ->
       if not (after u middle && after middle v) then
         malformed "contact %d: the direction is not inside its sector" (i + 1);
       Cut (Z.of_int i, middle, sector (u, middle) first, sector (middle, v) second)
     | Some Touches, _ :: _, stick :: rest ->
       let pairs = around ends in
       let below (_, y) = Z.sign y.qnum < 0 in
       let crossings = List.filter (fun (u, v) -> below u && not (below v)) pairs in
       if not (List.for_all (fun (u, v) -> after u v) pairs && List.length crossings = 1) then
         malformed "contact %d: the directions do not go round once, each less than half a turn \
                    from the one before" (i + 1);
       let stick = child ((i, Closed) :: states) stick in
       let sectors = List.map2 (fun (u, v) part -> (u, sector (u, v) part)) pairs rest in
       Directions (Z.of_int i, stick, sectors)
     | _ -> malformed "contact %d is not attached, or its sector has not one direction" (i + 1))
  | _ when has "plane" -> malformed "the tree is planar along two axes, %s" Reader.outside
  | _ when has "faces" -> malformed "faces are for friction pyramids, %s" Reader.outside
  | _ -> malformed "a node is a list of six numbers or an object that says how it splits"

let document value =
  let kind, members = Reader.certificate value in
  let contacts3 = Reader.grasp contact (List.assoc "grasp" members) in
  let question = { contacts3; applied3 = screw "wrench" (List.assoc "wrench" members) } in
  let count = List.length contacts3 in
  let force value =
    let { x_of; y_of; z_of } = vector3 "forces" value in
    ((x_of, y_of), z_of) in
  let proof =
    if kind = "resisted" then
      Resisted3 (screw "motion" (List.assoc "motion" members),
        List.map force (Reader.list "forces" (Some count) (List.assoc "forces" members)))
    else NotResisted3 (node count 0 [] (List.assoc "tree" members)) in
  (kind, question, proof)
