"""Documents are read strictly; what is hostile or wrong is refused with one clear error."""

import contextlib
import json
import os
import stat
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from arrangement import Arrangement, InputError, read_arrangement
from arrangement.console.writing import write_text_atomically
from arrangement.library import files
from arrangement.library.files.json_files import check_keys, check_list, instances, read_document
from arrangement.library.files.table import read_figure
from arrangement.library.instances import paths
from tests.instances import ONE_BODY, is_in_space

THREE = {"schema_version": 1, "planes": [["1", "0", "0"], ["0", "1", "0"], ["1/2", "-0.25", 3]]}
Write = Callable[[str | bytes], Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def write(content: str | bytes) -> Path:
        path = tmp_path / "document.json"
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    return write


def test_a_file_a_path_text_and_a_mapping_mean_the_same(write):
    path = write(json.dumps(THREE))
    expected = Arrangement([[1, 0, 0], [0, 1, 0], ["1/2", "-1/4", 3]])
    assert read_arrangement(path) == read_arrangement(str(path)) == expected
    assert read_arrangement(THREE) == expected


def test_offsets_dimension_and_description_are_read():
    affine = {"schema_version": 1, "description": "x", "planes": [["1", 0]], "offsets": ["1/2"]}
    assert read_arrangement(affine) == Arrangement([[1, 0]], ["1/2"])
    empty = {"schema_version": 1, "planes": [], "dimension": 4}
    assert read_arrangement(empty) == Arrangement([], dimension=4)


def test_a_byte_order_mark_and_standard_input_are_accepted(write, monkeypatch):
    path = write(b"\xef\xbb\xbf" + json.dumps(THREE).encode())
    assert len(read_arrangement(path)) == 3
    with path.open() as stream:
        monkeypatch.setattr(sys, "stdin", stream)
        assert len(read_arrangement("-")) == 3


def document(**changes: Any) -> str:
    return json.dumps({"schema_version": 1, "planes": [["1", "0", "0"]], **changes})


def one_number(text: str) -> str:
    return '{"schema_version": 1, "planes": [[' + text + ', "0", "1"]]}'


NESTED = "[" * 10_000_000
HOSTILE: dict[str, tuple[str | bytes, str]] = {
    "code": (one_number("\"__import__('os').system('touch pwned')\""), "not an exact number"),
    "a huge exponent": (one_number("1e999999999"), "float"),
    "a float": (one_number("0.5"), "float"),
    "NaN": (one_number("NaN"), "NaN"),
    "Infinity": (one_number("-Infinity"), "Infinity"),
    "a Boolean": (one_number("true"), "Boolean"),
    "null": (one_number("null"), "NoneType"),
    "a list for a number": (one_number("[1]"), "list"),
    "an object for a number": (one_number('{"p": 1}'), "dict"),
    "too many digits": (one_number("9" * 100_001), "100,001 characters"),
    "a million digits": (one_number("9" * 10**6), "1,000,000 characters"),
    "a lone surrogate": (one_number('"\\ud800"'), "not an exact number"),
    "10 MB of nesting": (NESTED, "bytes of a file"),
    "nesting within the size limit": (NESTED[: 2**22 - 10], "nested too deeply"),
    "nested objects": ('{"a":' * 100_000, "nested too deeply"),
    "nesting in place of a number": (one_number("[" * 900 + "]" * 900), "list"),
    "too long": (document(description="x" * 2**22), "bytes of a file"),
    "empty": ("", "not valid JSON"),
    "two documents": (document() * 2, "not valid JSON"),
    "binary": (bytes(range(256)), "not UTF-8"),
    "UTF-16": (document().encode("utf-16"), "not UTF-8"),
    "bad UTF-8": (document(description="x").encode().replace(b'"x"', b'"\xff"'), "not UTF-8"),
    "duplicate keys": ('{"schema_version": 1, "planes": [], "planes": [["1"]]}', "twice"),
    "a list": ("[1, 2]", "a list"),
    "a number": ("1", "object"),
    "null alone": ("null", "null"),
    "no schema version": ('{"planes": [["1"]]}', "schema_version"),
    "a later schema version": (document(schema_version=2), "schema_version 2"),
    "a Boolean schema version": (document(schema_version=True), "schema_version True"),
    "neither version nor planes": ("{}", '"schema_version": 1, and exactly one of the keys'),
    "two unknown keys": (document(a=1, b=2), "the unknown keys 'a', 'b'; known keys"),
    "a decimal comma": (document(planes=[["3,5"]]), "'3,5', .*; decimals have a point: 3.5"),
    "no planes": ('{"schema_version": 1}', "exactly one of the keys"),
    "normals": ('{"normals": [[1, 0]]}', r'are "planes": \[\[1, 0\], \[1, 1\]\], "off'),
    "planes and contacts": (document(contacts=[]), "contacts and planes|planes and contacts"),
    "an unknown key": (document(plane=[]), "unknown key 'plane'"),
    "an unknown key of a megabyte": (document(**{"x" * 10**6: 1}), "unknown key"),
    "planes as text": (document(planes="12"), "planes is '12'"),
    "planes as an object": (document(planes={}), "planes is an object"),
    "a plane as text": (document(planes=["100"]), r"planes\[0\] is '100'"),
    "a plane as a number": (document(planes=[1]), r"planes\[0\] is 1"),
    "a zero normal": (document(planes=[["1"], ["0"]]), r"normal 2 is the zero vector"),
    "ragged planes": (document(planes=[["1"], ["0", "1"]]), r"normal 2"),
    "no dimension": (document(planes=[]), "dimension"),
    "offsets as text": (document(offsets="0"), "offsets is '0'"),
    "offsets null": (document(offsets=None), "offsets is null"),
    "too many offsets": (document(offsets=[0, 0]), "offsets"),
    "a wrong dimension": (document(dimension=2), "dimension"),
    "a dimension in text": (document(dimension="3"), "dimension"),
    "a Boolean dimension": (document(planes=[["1"]], dimension=True), "dimension"),
    "a vast dimension": (document(planes=[], dimension=10**15), "dimension"),
    "a description that is not a text": (document(description=[1]), "description"),
}


@pytest.mark.parametrize(("content", "message"), HOSTILE.values(), ids=HOSTILE.keys())
def test_hostile_content_is_refused(write, content, message):
    path = write(content)
    with pytest.raises(InputError, match=message) as caught:
        read_arrangement(path)
    assert len(str(caught.value)) < 600
    assert os.listdir(path.parent) == [path.name]  # noqa: PTH208


@pytest.mark.parametrize(
    "source",
    ["no-such-name", "no/such/path.json", "", ".", "a\0b", "x" * 5000, "~", "Pencil", " pencil"],
)
def test_a_source_that_is_not_there_is_refused(source):
    with pytest.raises(InputError):
        read_arrangement(source)


def test_an_unknown_name_points_to_the_list_of_names():
    with pytest.raises(InputError, match="`list` prints"):
        read_arrangement("no-such-name")
    with pytest.raises(InputError, match="did you mean the built-in braid-a3"):
        read_arrangement("brade-a3")


def test_a_directory_and_an_unreadable_file_are_refused(tmp_path):
    with pytest.raises(InputError, match="cannot read"):
        read_arrangement(tmp_path)
    with pytest.raises(InputError, match="bytes of a file"):
        read_arrangement("/dev/zero")


@pytest.mark.parametrize("source", [None, 5, b"pencil", [THREE], 1.5])
def test_a_source_of_the_wrong_type_is_refused(source):
    with pytest.raises(InputError, match="path"):
        read_arrangement(source)


def test_a_mapping_is_checked_like_a_file():
    for wrong in (
        {**THREE, "planes": [[0.5, 1]]},
        {**THREE, "extra": 1},
        {**THREE, "schema_version": 1.0},
        {**THREE, 5: 1},
    ):
        with pytest.raises(InputError):
            read_arrangement(wrong)
    nested: list[Any] = []
    for _ in range(100_000):
        nested = [nested]
    with pytest.raises(InputError):
        read_arrangement({"schema_version": 1, "planes": [nested]})


def test_reading_leaves_the_mapping_alone():
    given = {"schema_version": 1, "planes": [["1", "0"]]}
    read_document(given, ["planes"])["planes"] = 5
    assert given == {"schema_version": 1, "planes": [["1", "0"]]}


@pytest.mark.parametrize("text", ["0.5", "1e999999999", "1.0", "NaN", "-Infinity", "9" * 100_001])
def test_inexact_numbers_are_refused_wherever_they_stand(write, text):
    path = write('{"schema_version": 1, "planes": [], "else": {"deep": [' + text + "]}}")
    with pytest.raises(InputError, match=r"document\.json"):
        read_document(path, ["planes"])


def test_a_larger_limit_can_be_asked_for(write):
    path = write(json.dumps({"schema_version": 1, "planes": [], "description": "x" * 2**22}))
    assert read_document(path, ["planes"], kind="bytes of a certificate")["planes"] == []


def test_keys_and_lists_are_checked_by_name():
    assert check_keys({"a": 1, "b": 2}, ["a"], ["b", "c"], "it") == {"a": 1, "b": 2}
    for wrong, message in (({"b": 1}, '"a"'), ({"a": 1, "d": 1}, "'d'"), ([], "a list")):
        with pytest.raises(InputError, match=f"it .*{message}"):
            check_keys(wrong, ["a"], ["b"], "it")
    assert check_list((1, 2), "it", 2) == [1, 2]
    for value, length in (("ab", None), ({}, None), ([1], 2)):
        with pytest.raises(InputError, match="it "):
            check_list(value, "it", length)


def test_built_in_names_win_over_files(tmp_path, monkeypatch):
    (tmp_path / "pencil").write_text(document(), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert len(read_arrangement("pencil")) == 5
    assert len(read_arrangement("./pencil")) == 1
    assert len(read_arrangement(Path("pencil"))) == 1


def test_writing_replaces_the_file_and_leaves_nothing_else(tmp_path):
    path = tmp_path / "out.json"
    write_text_atomically(path, "one\n")
    path.chmod(0o640)
    write_text_atomically(str(path), "zwei ß\n")
    assert path.read_bytes() == "zwei ß\n".encode()
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert list(tmp_path.iterdir()) == [path]


def test_writing_through_a_link_keeps_the_link(tmp_path):
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_text("old", encoding="utf-8")
    link.symlink_to(target)
    write_text_atomically(link, "new")
    assert link.is_symlink()
    assert target.read_text(encoding="utf-8") == "new"


def test_loops_of_links_and_empty_names_are_refused(tmp_path):
    one, other = tmp_path / "one", tmp_path / "other"
    one.symlink_to(other)
    other.symlink_to(one)
    for path in (one, ""):
        with pytest.raises(InputError, match="cannot write"):
            write_text_atomically(path, "text")


def test_a_failed_write_keeps_the_old_file(tmp_path):
    path = tmp_path / "out"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(InputError, match="cannot write"):
        write_text_atomically(path, "\ud800")
    assert path.read_text(encoding="utf-8") == "old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("name", ["missing/folder/out", ".", "a\0b", "x" * 300])
def test_a_place_that_cannot_be_written_is_refused(tmp_path, name):
    with pytest.raises(InputError, match="cannot write"):
        write_text_atomically(f"{tmp_path}/{name}", "x")


#: f-vectors by hand or from the literature (see the tests of faces)
BUILT_IN = {
    "braid-a3": (1, 14, 36, 24),
    "braid-a3-in-r4": (0, 1, 14, 36, 24),
    "coincident-planes": (0, 1, 4, 4),
    "coordinate-planes": (1, 6, 12, 8),
    "cube-diagonals": (1, 12, 24, 14),
    "five-generic-planes": (1, 20, 40, 22),
    "four-generic-planes": (1, 12, 24, 14),
    "generic-lines-affine": (6, 16, 11),
    "near-pencil": (1, 10, 24, 16),
    "nine-generic-planes": (1, 72, 144, 74),
    "parallel-planes-affine": (0, 2, 7, 6),
    "pencil": (0, 1, 10, 10),
    "reflection-b3": (1, 26, 72, 48),
    "shi-a2-affine": (6, 21, 16),
    "three-generic-planes": (1, 6, 12, 8),
}


@pytest.mark.parametrize(("name", "f_vector"), BUILT_IN.items())
def test_built_in_arrangements_are_what_they_say(name, f_vector):
    assert read_arrangement(name).f_vector == f_vector


def test_every_built_in_document_reads_and_describes_itself():
    known = instances()
    assert set(BUILT_IN) <= set(known)
    for name, path in known.items():
        if name not in ONE_BODY:
            with pytest.raises(
                InputError, match="contacts, planes, polygon, segments; it has none"
            ):
                read_arrangement(name)
        elif is_in_space(name):
            with pytest.raises(InputError, match="in space"):
                read_arrangement(name)
        else:
            assert len(read_arrangement(name)) > 0
        if name in BUILT_IN:
            assert json.loads(path.read_bytes())["description"]


SCHEMA = Path(files.__file__).with_name("arrangement.schema.json")
VALIDATOR = jsonschema.Draft202012Validator(json.loads(SCHEMA.read_bytes()))
PLANES = [["0", "1", "-1/2"], [1, 0, "-0.25"]]
GOOD = [
    {"planes": PLANES},
    {"planes": PLANES, "offsets": ["1/3", 2]},
    {"planes": PLANES, "names": ["ell", ""]},
    {"planes": [], "dimension": 3, "description": "none"},
    {"polygon": [["0", 0], [1, 0], [0, "1/2"]], "description": "a triangle"},
    {"segments": [[["0", 0], [1, "1/2"]]], "description": "one"},
    {"segments": []},
]
BAD = [
    {"planes": PLANES, "schema_version": 2},
    {"planes": PLANES, "colour": "red"},
    {"planes": PLANES, "names": "ell"},
    {"planes": PLANES, "names": ["ell", 2]},
    {"polygon": [["0", 0], [1, 0], [0, 1]], "names": []},
    {"planes": "0"},
    {"planes": [[]]},
    {"planes": [["1", "x"]]},
    {"planes": [["1", 0.5]]},
    {"planes": [["1", False]]},
    {"planes": PLANES, "offsets": "00"},
    {"planes": [], "dimension": -1},
    {"planes": PLANES, "dimension": "3"},
    {"planes": PLANES, "description": 1},
    {"offsets": []},
    {"polygon": [["0", 0], [1, 0]]},
    {"segments": [["0", 0], [1, 0]]},
    {"segments": [[["0", 0], [1]]]},
    {"segments": [], "offsets": []},
    {"polygon": [["0", 0], [1, 0], [0]]},
    {"polygon": [["0", 0], [1, 0], [0, 1]], "planes": PLANES},
    {"polygon": [["0", 0], [1, 0], [0, 1]], "dimension": 2},
]


@pytest.mark.parametrize(
    ("document", "good"), [(one, True) for one in GOOD] + [(one, False) for one in BAD]
)
def test_the_schema_and_the_reader_agree(document, good):
    document = {"schema_version": 1} | document
    assert VALIDATOR.is_valid(document) is good
    with contextlib.nullcontext() if good else pytest.raises(InputError):
        read_figure(document)


def test_what_ships_passes_the_schema():
    jsonschema.Draft202012Validator.check_schema(VALIDATOR.schema)
    assert paths()
    for path in paths().values():
        assert VALIDATOR.is_valid(json.loads(path.read_bytes()))
