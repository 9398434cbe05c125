(* proved-checker FILE...: a line for each file, exit code 0 all accepted, 1 one refused, 2 one
   malformed. A file is a certificate: of a grasp or an assembly, of a complete list of faces, of signs that no
   vectors have, or of a graph
   with or without weights. With --question first: print what was read of contacts
   and wrench, of planes, of signs, or of a graph, as JSON. With --regions, --faces or
   --polynomial first, files are arrangements: print what is counted. With --lines before these,
   each line of a file is a document of its own. *)

module Zarith = Z
open Checker
module Z = Zarith (* not the extracted module of that name *)

let read path =
  let content channel =
    let buffer = Buffer.create 65536 in
    let block = Bytes.create 65536 in
    let rec more () =
      let n = input channel block 0 65536 in
      if n > 0 then (Buffer.add_subbytes buffer block 0 n; more ()) in
    more ();
    Buffer.contents buffer in
  if path = "-" then (set_binary_mode_in stdin true; content stdin)
  else
    let channel = open_in_bin path in
    Fun.protect ~finally:(fun () -> close_in channel) (fun () -> content channel)

let rational q =
  if Z.equal q.qden Z.one then Z.to_string q.qnum
  else Z.to_string q.qnum ^ "/" ^ Z.to_string q.qden

let quoted texts = "[" ^ String.concat "," (List.map (fun t -> "\"" ^ t ^ "\"") texts) ^ "]"

let texts numbers = quoted (List.map rational numbers)

let values v = [ v.friction; v.stiffness; v.preload ]

let contact2 c = [ c.point_x; c.point_y; c.normal_x; c.normal_y ] @ values c.values2

let contact3 c =
  List.concat_map (fun v -> [ v.x_of; v.y_of; v.z_of ]) [ c.point3; c.normal3; c.tangent3 ]
  @ values c.values3

let rec number = function O -> 0 | S n -> number n + 1

(* A contact of an assembly begins with its bodies, counted from 0. *)
let joint j =
  let body n = Tree_reader.whole (number n) in
  let second = match j.body_b with Some b -> [ body b ] | None -> [] in
  (body j.body_a :: second) @ contact2 j.touch

let question g adhesion =
  let rows, load =
    match g with
    | InPlane (contacts, load) -> (List.map contact2 contacts, load)
    | InSpace (contacts, load) -> (List.map contact3 contacts, load)
    | OfBodies (_, joints, load) -> (List.map joint joints, load) in
  let rows = List.map2 (fun row pull -> row @ [ pull ]) rows adhesion in
  Printf.sprintf "{\"contacts\":[%s],\"wrench\":%s}" (String.concat "," (List.map texts rows))
    (texts load)

(* As the package stores planes: n_1, ..., n_d, b for n . x = b. *)
let planes forms =
  let plane f = quoted (List.map Z.to_string (f.coefficients @ [ Z.neg f.constant ])) in
  "{\"planes\":[" ^ String.concat "," (List.map plane forms) ^ "]}"

type task = Check | Question | Count of (Z.t form list -> Z.t list)

(* Each triple with its sign. *)
let signs entries =
  let entry (((i, j), k), s) = quoted (List.map Z.to_string [ i; j; k; s ]) in
  "{\"signs\":[" ^ String.concat "," (List.map entry entries) ^ "]}"

let graph edges count =
  let pair (u, v) = Printf.sprintf "[%s,%s]" (Z.to_string u) (Z.to_string v) in
  Printf.sprintf "{\"vertices\":%d,\"edges\":[%s]}" count
    (String.concat "," (List.map pair edges))

let answer accepted kind =
  if accepted then (0, "accepted: " ^ kind) else (1, "refused: " ^ kind)

let work task document =
  match task with
  | Count number ->
    let forms, _ = Planes_reader.planes document in
    (0, "counted: " ^ String.concat " " (List.map Z.to_string (number forms)))
  | _ when Planes_reader.about_planes document ->
    let kind, forms, faces = Planes_reader.certificate document in
    if task = Question then (0, planes forms)
    else (
      match kind with
      | Planes_reader.Regions -> answer (complete_regions forms faces) "all regions"
      | Planes_reader.All_faces -> answer (complete_faces forms faces) "all faces")
  | _ when Signs_reader.about document ->
    let entries, proof = Signs_reader.certificate document in
    if task = Question then (0, signs entries) else answer (final entries proof) "no coordinates"
  | _ when Weights_reader.kind document = Some "no weights" ->
    let vertices, edges, cutsets = Weights_reader.multipliers document in
    if task = Question then (0, graph (List.map (fun e -> e.ends) edges) (List.length vertices))
    else answer (contradicts vertices edges cutsets) "no weights"
  | _ when Weights_reader.kind document = Some "weights" ->
    let count, edges, root, flows = Weights_reader.weights document in
    if task = Question then (0, graph (List.map fst edges) count)
    else answer (satisfies (Tree_reader.natural count) edges root flows) "weights"
  | _ ->
    let read =
      if Assembly_reader.about document then Assembly_reader.document else Grasp_reader.document in
    let kind, asked, adhesion, proof = read document in
    if task = Question then (0, question asked adhesion)
    else answer (check_pulled asked adhesion proof) kind

let verdict task text =
  match work task (Json.parse text) with
  | found -> found
  | exception Json.Malformed problem -> (2, "malformed: " ^ problem)
  | exception Stack_overflow -> (2, "malformed: too large for the stack of this program")

let say worst (code, line) =
  print_endline line;
  max worst code

let rec of_lines task worst channel =
  match input_line channel with
  | text -> of_lines task (say worst (verdict task text)) channel
  | exception End_of_file -> worst

let of_file lines task worst path =
  try
    if not lines then say worst (verdict task (read path))
    else if path = "-" then of_lines task worst stdin
    else
      let channel = open_in_bin path in
      Fun.protect ~finally:(fun () -> close_in channel) (fun () -> of_lines task worst channel)
  with Sys_error problem -> say worst (2, "malformed: " ^ problem)

let () =
  let lines, arguments =
    match List.tl (Array.to_list Sys.argv) with
    | "--lines" :: arguments -> (true, arguments)
    | arguments -> (false, arguments) in
  let task, paths =
    match arguments with
    | "--question" :: paths -> (Question, paths)
    | "--regions" :: paths -> (Count (fun forms -> [ count_regions forms ]), paths)
    | "--faces" :: paths -> (Count count_faces, paths)
    | "--polynomial" :: paths -> (Count characteristic_polynomial, paths)
    | paths -> (Check, paths) in
  if paths = [] then (
    prerr_endline
      "usage: proved-checker [--lines] [--question | --regions | --faces | --polynomial] FILE...";
    exit 2);
  exit (List.fold_left (of_file lines task) 0 paths)
