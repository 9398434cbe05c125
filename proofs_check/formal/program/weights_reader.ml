(* Weights that satisfy the linear conditions of inscribability of a graph, or multipliers that
   contradict them, as the theorems take them. *)

open Json

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let kind = function
  | Object members ->
    (match List.assoc_opt "certificate" members with
     | Some (Text ("weights" | "no weights" as kind)) -> Some kind
     | _ -> None)
  | _ -> None

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
let multipliers value =
  let members = Reader.keys "the certificate"
    [ "schema_version"; "certificate"; "vertices"; "edges"; "cutsets" ] [] value in
  Reader.version "the certificate" 1 members;
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

(* A flow between the ends of two edges, as large as possible or more than 1, from shortest paths.
   The checker sees whether it is one, and large enough. *)
let flow count unit capacities (sources, sinks) =
  let room = Array.make_matrix count count Z.zero in
  let neighbours = Array.make count [] in
  List.iter (fun ((u, v), c) ->
    room.(u).(v) <- c;
    room.(v).(u) <- c;
    neighbours.(u) <- v :: neighbours.(u);
    neighbours.(v) <- u :: neighbours.(v)) capacities;
  let is_sink v = v = fst sinks || v = snd sinks in
  let rec path parent v = if parent.(v) = v then [] else (parent.(v), v) :: path parent parent.(v) in
  let shortest () =
    let parent = Array.make count (-1) and waiting = Queue.create () and found = ref [] in
    List.iter (fun v -> parent.(v) <- v; Queue.add v waiting) [ fst sources; snd sources ];
    while !found = [] && not (Queue.is_empty waiting) do
      let u = Queue.pop waiting in
      List.iter (fun v ->
        if parent.(v) < 0 && Z.sign room.(u).(v) > 0 then (
          parent.(v) <- u;
          Queue.add v waiting;
          if is_sink v && !found = [] then found := path parent v)) neighbours.(u)
    done;
    !found in
  let rec push value =
    if Z.leq value unit then
      match shortest () with
      | [] -> ()
      | (u, v) :: _ as steps ->
        let amount = List.fold_left (fun a (u, v) -> Z.min a room.(u).(v)) room.(u).(v) steps in
        List.iter (fun (u, v) ->
          room.(u).(v) <- Z.sub room.(u).(v) amount;
          room.(v).(u) <- Z.add room.(v).(u) amount) steps;
        push (Z.add value amount) in
  push Z.zero;
  List.map (fun ((u, v), c) -> Reader.fraction (Z.sub c room.(u).(v)) unit) capacities

let most_vertices = 1000

(* The number of vertices, the weights, a vertex with few edges, and the flows from it. *)
let weights value =
  let members = Reader.keys "the certificate"
    [ "schema_version"; "certificate"; "vertices"; "edges" ] [] value in
  Reader.version "the certificate" 1 members;
  let count = Reader.index "vertices" (most_vertices + 1) (List.assoc "vertices" members) in
  let weighted i value =
    let where = Printf.sprintf "edges[%d]" i in
    match Reader.list where (Some 3) value with
    | [ u; v; w ] ->
      let vertex value = Reader.index where count value in
      ((vertex u, vertex v), Reader.rational where w)
    | _ -> assert false in
  let edges = List.mapi weighted (Reader.list "edges" None (List.assoc "edges" members)) in
  let unit = List.fold_left (fun n (_, w) -> Z.lcm n w.qden) Z.one edges in
  let capacities = List.map (fun (e, w) -> (e, Z.mul w.qnum (Z.divexact unit w.qden))) edges in
  let degree = Array.make count 0 in
  List.iter (fun ((u, v), _) ->
    degree.(u) <- degree.(u) + 1;
    degree.(v) <- degree.(v) + 1) edges;
  let root = ref 0 in
  Array.iteri (fun v d -> if d < degree.(!root) then root := v) degree;
  let big (u, v) = (Z.of_int u, Z.of_int v) and small (u, v) = (Z.to_int u, Z.to_int v) in
  let root = Z.of_int !root in
  let found =
    List.map (fun (e, f) -> flow count unit capacities (small e, small f))
      (pairs root (List.map (fun (e, _) -> big e) edges)) in
  (count, List.map (fun (e, w) -> (big e, w)) edges, root, found)
