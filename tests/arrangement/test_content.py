"""What a file seems to be, which errors about it say."""

import io
import json
import re

import numpy as np
import pytest

from arrangement import InputError, read_arrangement
from arrangement.library.files.content import content_kind
from arrangement.library.files.json_files import parse_json, read_text


def saved(save, *arrays, **named) -> bytes:
    stream = io.BytesIO()
    save(stream, *arrays, **named)
    return stream.getvalue()


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (saved(np.savez, points=np.eye(2)), "an archive of NumPy arrays; numpy.savetxt writes"),
        (saved(np.save, np.eye(2)), "a NumPy array; numpy.savetxt writes rows as text"),
        (b"PK\x03\x04\xff", "a spreadsheet or another zip archive; save it as CSV"),
        (b"%PDF-1.4\n\xff", "a PDF document"),
        (b"\x1f\x8b\xff", "compressed by gzip; unpack it"),
        (b"\xff\xfe", "not UTF-8 text (byte 0 is wrong)"),
        (
            b"_application polytope\n_version 2.9.9\n_type RationalPolytope\n",
            "a data file of an old",
        ),
        (b'<?xml version="1.0"?>\n<?pm chk="5"?>\n<object name="a"></object>', "a data file of an"),
        (b"H-representation\nbegin\n 3 3 rational\n", "a file of cdd or lrs; write each row"),
        (b"solid part\nfacet normal 0 0 1\n", "an STL mesh; equilibrium make mesh takes it"),
        (b"\\begin{align}\n x + y &= 1\n\\end{align}\n", "LaTeX; write its equations alone, one a"),
        (b"#!/usr/bin/env python\nimport numpy as np\n", "a Python program, which is not run"),
        (b"contacts:\n  - normal\n", "YAML; write the same keys and lists as JSON"),
        (b"<html>", "an HTML page"),
        (b"<part/>", "XML with the root <part>"),
        (b"planes           3\nrank             2\n", "an answer that a command printed"),
        (b"Three lines\nin a plane\n", "a text that begins with 'Three lines'. It is in none of"),
    ],
)
@pytest.mark.parametrize("ending", ["", ".txt", ".csv"])
def test_file_in_no_format_is_named_by_its_content(content, kind, ending, tmp_path):
    path = tmp_path / f"file{ending}"
    path.write_bytes(content)
    with pytest.raises(InputError) as refused:
        read_arrangement(path)
    assert f"file{ending}' is {kind}" in str(refused.value)
    if b"\xff" not in content and b"NUMPY" not in content:
        with pytest.raises(InputError, match="is not valid JSON, but ") as refused:
            parse_json(*read_text(path))
        assert kind.partition(". It")[0] in str(refused.value)


@pytest.mark.parametrize("name", ["braid-a3", "shi-a2-affine", "generic-lines-affine"])
def test_documents_and_rows_of_numbers_are_plain_texts(name):
    planes = read_arrangement(name)
    rows = "\n".join(" ".join(map(str, normal)) for normal in planes.normals)
    for text in (json.dumps(planes.to_dict()), rows):
        assert content_kind(text).startswith("a text that begins with ")


@pytest.mark.parametrize("rows", ["1 0 0; 0 1 0", "1,0,0;0,1,0", "[1, 0, 0], [0, 1, 0]"])
def test_rows_may_stand_in_place_of_a_file(rows):
    assert read_arrangement(rows) == read_arrangement("[[1, 0, 0], [0, 1, 0]]")


@pytest.mark.parametrize(
    "rows", ["[[1,0],[0,1],]", "[[1,0],[0,1]],", "[[1,0],;[0,1]]", "1 0; 0 1;", "1,0,;0,1,"]
)
def test_one_separator_may_follow_the_last_entry(rows):
    assert read_arrangement(rows) == read_arrangement("[[1, 0], [0, 1]]")


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("[[1,0],,[0,1]]", "a normal is empty, at '],,'"),
        ("((1,0), ,(0,1))", "a normal is empty, at '), ,'"),
        ("[[1,0],[0,1],,]", "a normal is empty, at '],,'"),
        ("[[1,0],[],[0,1]]", "a normal is empty, at '[]'"),
        ("[[,1],[,2]]", "entry 1 of normal 1 is ''"),
        ("[[1,,0],[0,1]]", "entry 2 of normal 1 is ''"),
        ("1 0;,0 1", "entry 1 of normal 2 is ''"),
    ],
)
def test_empty_entries_of_rows_are_refused(rows, message):
    with pytest.raises(InputError, match=re.escape(message)):
        read_arrangement(rows)


@pytest.mark.parametrize(
    ("content", "faults"),
    [
        ('{"schema_version": 1, "planes": [[0.5, 1.5]]}', ["numbers '0.5', '1.5' are floats"]),
        ('{"schema_version": 1, "planes": [["a", 1], [1, "b"]]}', ["normal 1 is 'a'", "2 is 'b'"]),
        ("a,b,c\n1,x,2\n1,2,y\n", ["entry 2 of normal 1 is 'x'", "entry 2 of the offsets is 'y'"]),
        ("1 ?\n! 2\n", ["entry 2 of normal 1 is '?'", "entry 1 of normal 2 is '!'"]),
        ("1 ?\n" * 9, ["entry 2 of normal 5 is '?'", "; 4 more such"]),
    ],
)
def test_all_faults_are_reported_at_once(content, faults, tmp_path):
    path = tmp_path / ("a.json" if content.startswith("{") else "a.csv")
    path.write_text(content)
    with pytest.raises(InputError) as refused:
        read_arrangement(path)
    for fault in faults:
        assert fault in str(refused.value)
