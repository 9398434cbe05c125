(* A certificate of a grasp, in the plane or in space, as the question and the proof that the
   theorem is about. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let vector3 where value =
  match Reader.vector where 3 value with
  | [ x_of; y_of; z_of ] -> { x_of; y_of; z_of }
  | _ -> assert false

let entries v = [ v.x_of; v.y_of; v.z_of ]

let is_one q = Z.equal q.qnum q.qden

(* The x axis turned by the smallest rotation that takes the z axis to the normal. *)
let usual_tangent n =
  let up = qplus (Tree_reader.whole 1) n.z_of in
  if qzero up then
    { x_of = Tree_reader.whole 1; y_of = Tree_reader.whole 0; z_of = Tree_reader.whole 0 }
  else
    let inverse = Reader.fraction up.qden up.qnum in
    let over a b = qtimes (qtimes a b) inverse in
    { x_of = qminus (Tree_reader.whole 1) (over n.x_of n.x_of);
      y_of = qminus (Tree_reader.whole 0) (over n.x_of n.y_of);
      z_of = qminus (Tree_reader.whole 0) n.x_of }

let contact3 i value =
  let where = Printf.sprintf "contacts[%d]" i in
  let members = Reader.keys where [ "point"; "normal"; "friction" ]
    [ "stiffness"; "preload"; "adhesion"; "tangent" ] value in
  let vector key = vector3 (where ^ ": " ^ key) (List.assoc key members) in
  let normal3 = vector "normal" in
  let product a b = qdot (entries a) (entries b) in
  if not (is_one (product normal3 normal3)) then
    malformed "%s: the normal is not exactly unit" where;
  let tangent3 =
    if List.mem_assoc "tangent" members then vector "tangent" else usual_tangent normal3 in
  if not (is_one (product tangent3 tangent3) && qzero (product normal3 tangent3)) then
    malformed "%s: the tangent is not exactly unit and at a right angle to the normal" where;
  { point3 = vector "point"; normal3; tangent3; values3 = Reader.law ~spring:true where members }

(* Whether a grasp is in space: its first contact has three coordinates. *)
let in_space = function
  | Object grasp ->
    (match List.assoc_opt "contacts" grasp with
     | Some (List (Object contact :: _)) ->
       (match List.assoc_opt "point" contact with
        | Some (List [ _; _; _ ]) -> true
        | _ -> false)
     | _ -> false)
  | _ -> false

let force tangents value =
  match Reader.vector "forces" (tangents + 1) value with
  | [ normal; along ] -> ((normal, along), Tree_reader.whole 0)
  | [ normal; along; across ] -> ((normal, along), across)
  | _ -> assert false

let document value =
  let kind, members = Reader.certificate "grasp" value in
  let grasp = List.assoc "grasp" members in
  let size, tangents = if in_space grasp then (6, 2) else (3, 1) in
  let wrench () = Reader.vector "wrench" size (List.assoc "wrench" members) in
  let question, contacts =
    if in_space grasp then
      let contacts = Reader.grasp contact3 grasp in
      (InSpace (contacts, wrench ()), List.length contacts)
    else
      let contacts = Reader.grasp Reader.contact grasp in
      (InPlane (contacts, wrench ()), List.length contacts) in
  let motion where value = Reader.vector where size value in
  let subject =
    { Tree_reader.contacts; number = Fun.id; tangents; motion; whole_multipliers = false;
      regions = tangents = 1 } in
  let proof =
    if kind = "resisted" then
      Resisted (motion "motion" (List.assoc "motion" members),
        List.map (force tangents)
          (Reader.list "forces" (Some contacts) (List.assoc "forces" members)))
    else NotResisted (Tree_reader.tree subject (List.assoc "tree" members)) in
  (kind, question, Reader.grasp Reader.adhesion grasp, proof)
