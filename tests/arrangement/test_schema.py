"""The published schema of arrangement files against the reader."""

import json

import jsonschema
import pytest

from arrangement.errors import InputError
from arrangement.library.files.documents import arrangement_schema
from arrangement.library.files.table import read_arrangement
from arrangement.library.instances import paths

VALIDATOR = jsonschema.Draft202012Validator(arrangement_schema())
PLANES = [["0", "1", "-1/2"], [1, 0, "-0.25"]]
GOOD = [
    {"planes": PLANES},
    {"planes": PLANES, "offsets": ["1/3", 2]},
    {"planes": [], "dimension": 3, "description": "none"},
]
BAD = [
    {"planes": PLANES, "schema_version": 2},
    {"planes": PLANES, "colour": "red"},
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
]


def accepted(document):
    try:
        read_arrangement(document)
    except InputError:
        return False
    return True


@pytest.mark.parametrize("document", GOOD)
def test_good_documents_pass_both(document):
    document = {"schema_version": 1} | document
    assert accepted(document)
    assert VALIDATOR.is_valid(document)


@pytest.mark.parametrize("document", BAD)
def test_bad_documents_fail_both(document):
    document = {"schema_version": 1} | document
    assert not accepted(document)
    assert not VALIDATOR.is_valid(document)


def test_what_ships_passes():
    jsonschema.Draft202012Validator.check_schema(arrangement_schema())
    assert paths()
    for path in paths().values():
        assert VALIDATOR.is_valid(json.loads(path.read_text(encoding="utf-8")))
