"""What a file seems to be by its content, for errors about files that are not what is read."""

from __future__ import annotations

import re

from arrangement.numbers.exact import shown

#: Characters that are looked at.
_HEAD_SIZE = 4096
_ROWS = "numpy.savetxt writes rows as text"
#: Patterns of the beginning of a file, read as latin-1, with what it is and what to do.
_KINDS = {
    r"\s*\Z": "empty",
    r"PK[\s\S]*\.npy": f"an archive of NumPy arrays; {_ROWS}",
    r"PK": "a spreadsheet or another zip archive; save it as CSV",
    r"\x93NUMPY": f"a NumPy array; {_ROWS}",
    r"%PDF": "a PDF document",
    r"\x89PNG|\xff\xd8\xff|GIF8|\s*<svg|.*\n?<svg": "a picture",
    r"\x1f\x8b": "compressed by gzip; unpack it",
    r"SQLite format 3": "an SQLite database",
    r"(?i)\s*<(!doctype html|html)": "an HTML page",
    r"\s*solid\b[\s\S]*?facet": "an STL mesh; equilibrium make mesh takes it",
    r"OFF\s": "an OFF mesh",
    r"[\s\S]*?^[HV]-representation": "a file of cdd or lrs; write each row b, -a as a | b",
    r"_(application|version|type)\b|[\s\S]*<\?pm |[\s\S]*<object [^>]*polymake": "a data file "
    'of an old polymake; in polymake save(load("OLD.poly"), "NEW.hyar") writes one that is read, '
    "or write the rows of HYPERPLANES alone, one a line",
    r"\s*(<[?!][^>]*>\s*)*<COLLADA\b": "a COLLADA model",
    r"\s*(<[?!][^>]*>\s*)*<mujoco\b": "an MJCF model of MuJoCo (`equilibrium draw --model scene` "
    "writes such scenes)",
    r"\s*(<[?!][^>]*>\s*)*<robot\b": "a URDF model",
    r"\s*(<[?!][^>]*>\s*)*<sdf\b": "an SDF model",
    r"[\s\S]*?\\(begin|documentclass|\[)|\s*\$": "LaTeX; write its equations alone, one a line",
    r"[\s\S]*?^(from [\w.]+ import |import \w+|def \w+\()": "a Python program, which is not run",
    r"\[[\w.]+\]\s*$": "TOML; write the same keys and lists as JSON, or a table as CSV",
    r"(---|[\w ]+:)\s*$": "YAML; write the same keys and lists as JSON, or a table as CSV",
    r"(not )?resisted\b|planes +[0-9]": "an answer that a command printed",
}


def content_kind(content: bytes | str) -> str:
    """Return what a content seems to be, with what to do where that is known.

    >>> content_kind(b"%PDF-1.7"), content_kind("Three lines\\n")
    ('a PDF document', "a text that begins with 'Three lines'")
    """
    head = content[:_HEAD_SIZE]
    text = head.decode("latin-1") if isinstance(head, bytes) else head
    for pattern, kind in _KINDS.items():
        if re.match(pattern, text, re.MULTILINE):
            return kind
    if root := re.match(r"\s*(?:<[?!][^>]*>\s*)*<([A-Za-z_][\w.:-]*)", text):
        return f"XML with the root <{root[1][:40]}>"
    if isinstance(content, bytes):
        return "not UTF-8 text"
    first = next(filter(None, map(str.strip, text.splitlines())))
    return f"a text that begins with {shown(first)}"
