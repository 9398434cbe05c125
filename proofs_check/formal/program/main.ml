(* proved-checker FILE...: a line for each file, exit code 0 all accepted, 1 one refused, 2 one
   malformed. With --question first: print what was read of grasp and wrench, as JSON. *)

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

let texts numbers =
  "[" ^ String.concat "," (List.map (fun q -> "\"" ^ rational q ^ "\"") numbers) ^ "]"

let question g =
  let contact c =
    texts [ c.point_x; c.point_y; c.normal_x; c.normal_y; c.friction; c.stiffness; c.preload ] in
  let { along_x; along_y; turn } = g.applied in
  Printf.sprintf "{\"contacts\":[%s],\"wrench\":%s}"
    (String.concat "," (List.map contact g.contacts)) (texts [ along_x; along_y; turn ])

let verdict echo path =
  match Reader.document (Json.parse (read path)) with
  | _, asked, _ when echo -> (0, question asked)
  | kind, asked, proof ->
    if Checker.check asked proof then (0, "accepted: " ^ kind) else (1, "refused: " ^ kind)
  | exception Json.Malformed problem -> (2, "malformed: " ^ problem)
  | exception Sys_error problem -> (2, "malformed: " ^ problem)
  | exception Stack_overflow -> (2, "malformed: too large for the stack of this program")

let () =
  let arguments = List.tl (Array.to_list Sys.argv) in
  let echo, paths =
    match arguments with "--question" :: paths -> (true, paths) | paths -> (false, paths) in
  if paths = [] then (prerr_endline "usage: proved-checker [--question] FILE..."; exit 2);
  let worst = List.fold_left (fun worst path ->
    let code, line = verdict echo path in
    print_endline line;
    max worst code) 0 paths in
  exit worst
