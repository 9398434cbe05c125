(* Strict JSON (RFC 8259): UTF-8, no floats, no key twice in one object, bounded nesting. *)

type t =
  | Null
  | Bool of bool
  | Integer of Z.t
  | Text of string
  | List of t list
  | Object of (string * t) list

exception Malformed of string

let malformed format = Printf.ksprintf (fun text -> raise (Malformed text)) format

(* Lists and objects inside one another. *)
let deepest = 1000

(* Characters of one number; longer ones cost quadratic time elsewhere. *)
let longest_number = 100_000

(* True for the bytes of valid UTF-8: no overlong form, no surrogate, nothing above U+10FFFF. *)
let utf_8 text =
  let size = String.length text in
  let byte i = if i < size then Char.code text.[i] else 0 in
  let tail i = byte i land 0xC0 = 0x80 in
  let rec from i =
    if i >= size then true
    else
      let a = byte i and b = byte (i + 1) in
      if a < 0x80 then from (i + 1)
      else if a >= 0xC2 && a <= 0xDF then tail (i + 1) && from (i + 2)
      else if a >= 0xE0 && a <= 0xEF then
        tail (i + 1) && tail (i + 2)
        && (a <> 0xE0 || b >= 0xA0)
        && (a <> 0xED || b < 0xA0)
        && from (i + 3)
      else
        a >= 0xF0 && a <= 0xF4
        && tail (i + 1) && tail (i + 2) && tail (i + 3)
        && (a <> 0xF0 || b >= 0x90)
        && (a <> 0xF4 || b < 0x90)
        && from (i + 4)
  in
  from 0

let parse text =
  if not (utf_8 text) then malformed "the file is not UTF-8 text";
  let size = String.length text in
  let at = ref (if size >= 3 && String.sub text 0 3 = "\xEF\xBB\xBF" then 3 else 0) in
  let wrong () = malformed "the file is not valid JSON (byte %d)" !at in
  let peek () = if !at < size then text.[!at] else '\000' in
  let rec blanks () =
    match peek () with ' ' | '\t' | '\n' | '\r' -> incr at; blanks () | _ -> () in
  let expect word =
    let length = String.length word in
    if !at + length <= size && String.sub text !at length = word then at := !at + length
    else wrong () in
  let rec digits () = match peek () with '0' .. '9' -> incr at; digits () | _ -> () in
  let number () =
    let start = !at in
    if peek () = '-' then incr at;
    let first = !at in
    digits ();
    if !at = first || (text.[first] = '0' && !at > first + 1) then wrong ();
    (match peek () with
     | '.' | 'e' | 'E' -> malformed "a number is a float; write a string such as \"1/4\""
     | _ -> ());
    if !at - start > longest_number then
      malformed "a number has more than %d characters" longest_number;
    Integer (Z.of_string (String.sub text start (!at - start))) in
  let hexadecimal () =
    if !at + 4 > size then wrong ();
    let digit c = match c with
      | '0' .. '9' -> Char.code c - 48
      | 'a' .. 'f' -> Char.code c - 87
      | 'A' .. 'F' -> Char.code c - 55
      | _ -> wrong () in
    let value = ref 0 in
    String.iter (fun c -> value := (16 * !value) + digit c) (String.sub text !at 4);
    at := !at + 4;
    !value in
  let character buffer =
    incr at;
    let escaped = peek () in
    incr at;
    match escaped with
    | '"' | '\\' | '/' -> Buffer.add_char buffer escaped
    | 'b' -> Buffer.add_char buffer '\b'
    | 'f' -> Buffer.add_char buffer '\012'
    | 'n' -> Buffer.add_char buffer '\n'
    | 'r' -> Buffer.add_char buffer '\r'
    | 't' -> Buffer.add_char buffer '\t'
    | 'u' ->
      let code = hexadecimal () in
      let code =
        if code land 0xFC00 = 0xD800 && !at + 1 < size && String.sub text !at 2 = "\\u" then begin
          let back = !at in
          at := !at + 2;
          let low = hexadecimal () in
          if low land 0xFC00 = 0xDC00 then 0x10000 + ((code land 0x3FF) lsl 10) + (low land 0x3FF)
          else (at := back; code)
        end
        else code in
      (* A lone half of a pair means no character; no text with one is a key or a number. *)
      Buffer.add_utf_8_uchar buffer (if Uchar.is_valid code then Uchar.of_int code else Uchar.rep)
    | _ -> wrong () in
  let string () =
    expect "\"";
    let buffer = Buffer.create 16 in
    while peek () <> '"' do
      if !at >= size || peek () < ' ' then wrong ();
      if peek () = '\\' then character buffer
      else (Buffer.add_char buffer (peek ()); incr at)
    done;
    incr at;
    Buffer.contents buffer in
  (* The items up to the closing bracket, the opening one being read. *)
  let items close item =
    incr at;
    blanks ();
    if peek () = close then (incr at; [])
    else begin
      let read = ref [] and more = ref true in
      while !more do
        read := item () :: !read;
        blanks ();
        if peek () = ',' then incr at
        else if peek () = close then (incr at; more := false)
        else wrong ()
      done;
      List.rev !read
    end in
  let rec value depth =
    if depth > deepest then malformed "the file is nested too deeply";
    blanks ();
    match peek () with
    | '{' ->
      let members = items '}' (fun () ->
        blanks ();
        let key = string () in
        blanks ();
        expect ":";
        (key, value (depth + 1))) in
      let seen = Hashtbl.create 8 in
      List.iter (fun (key, _) ->
        if Hashtbl.mem seen key then malformed "a key appears twice in one object: %S" key;
        Hashtbl.add seen key ()) members;
      Object members
    | '[' -> List (items ']' (fun () -> value (depth + 1)))
    | '"' -> Text (string ())
    | 't' -> expect "true"; Bool true
    | 'f' -> expect "false"; Bool false
    | 'n' -> expect "null"; Null
    | _ -> number () in
  let document = value 0 in
  blanks ();
  if !at < size then wrong ();
  document
