(* Multipliers that contradict the linear conditions of inscribability of a graph, as the theorem
   takes them. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let about = function Object members -> List.mem_assoc "cutsets" members | _ -> false

let edge count i value =
  let where = Printf.sprintf "edges[%d]" i in
  match Reader.list where (Some 4) value with
  | [ u; v; a; b ] ->
    let vertex value = Z.of_int (Reader.index where count value) in
    { ends = (vertex u, vertex v);
      lower = Reader.rational where a; upper = Reader.rational where b }
  | _ -> assert false

(* The vertices for which [inside] holds that some path inside joins to the first, each after a
   neighbour. What is left out is noticed by the checker. *)
let grown neighbours inside =
  let seen = Array.map not inside in
  let found = ref [] and waiting = Queue.create () in
  let reach v =
    if not seen.(v) then (
      seen.(v) <- true;
      found := v :: !found;
      Queue.add v waiting) in
  Array.iteri (fun v is_in -> if is_in && !found = [] then reach v) inside;
  while not (Queue.is_empty waiting) do
    List.iter reach neighbours.(Queue.pop waiting)
  done;
  List.rev_map Z.of_int !found

let cutset neighbours i value =
  let where = Printf.sprintf "cutsets[%d]" i in
  let count = Array.length neighbours in
  match Reader.list where (Some 2) value with
  | [ side; factor ] ->
    let inside = Array.make count false in
    List.iter (fun v -> inside.(Reader.index where count v) <- true)
      (Reader.list where None side);
    { one_side = grown neighbours inside; other_side = grown neighbours (Array.map not inside);
      factor = Reader.rational where factor }
  | _ -> assert false

(* Multipliers of the vertices, the edges with theirs, and the cutsets. *)
let certificate value =
  let members = Reader.keys "the certificate"
    [ "schema_version"; "certificate"; "vertices"; "edges"; "cutsets" ] [] value in
  Reader.version "the certificate" 1 members;
  (match List.assoc "certificate" members with
   | Text "no weights" -> ()
   | _ -> malformed "this is no certificate of no weights");
  let entries key = Reader.list key None (List.assoc key members) in
  let vertices = List.map (Reader.rational "vertices") (entries "vertices") in
  let count = List.length vertices in
  let edges = List.mapi (edge count) (entries "edges") in
  let neighbours = Array.make count [] in
  List.iter (fun { ends = u, v; _ } ->
    let u = Z.to_int u and v = Z.to_int v in
    neighbours.(u) <- v :: neighbours.(u);
    neighbours.(v) <- u :: neighbours.(v)) edges;
  (vertices, edges, List.mapi (cutset neighbours) (entries "cutsets"))
