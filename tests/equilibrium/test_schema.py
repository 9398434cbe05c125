"""The published schema of grasp files against the reader, and the units that files carry."""

import dataclasses
import json
from dataclasses import fields, replace
from fractions import Fraction

import jsonschema
import pytest

from arrangement.errors import InputError
from equilibrium import CertificateError, Circle, Contact, Grasp, GraspError, Polygon, Units
from equilibrium.certificate.checker import check
from equilibrium.decide.solver import solve
from equilibrium.grasps.inputs import random_grasp
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.instances import paths
from equilibrium.grasps.schemas import certificate_schema, grasp_schema
from tests.schemas import validator

VALIDATOR = validator(grasp_schema())
CONTACT = {"point": ["-1", 0], "normal": ["3/5", "-0.8"], "friction": "1/2"}
SPATIAL = {"point": [0, 0, "-1"], "normal": ["3/5", 0, "0.8"], "friction": "1/2"}
MISSING = object()


def grasp(**changes):
    document = {"schema_version": 1, "contacts": [CONTACT]} | changes
    return {key: value for key, value in document.items() if value is not MISSING}


def contact(**changes):
    entry = CONTACT | changes
    return grasp(contacts=[{key: value for key, value in entry.items() if value is not MISSING}])


GOOD = [
    grasp(),
    grasp(contacts=[]),
    grasp(description="two words"),
    grasp(units={"length": "mm", "force": "N"}),
    grasp(outline=[["0", 0], ["4", "0"], ["0", "3"]]),
    grasp(outline={"centre": ["0", "1/2"], "radius": "1"}),
    contact(stiffness="2", preload=0),
    *(contact(adhesion=x) for x in ("5/2", 0, "-0")),
    *(contact(stiffness=x) for x in ("0", "0.00", 0)),
    grasp(contacts=[SPATIAL, SPATIAL | {"tangent": ["4/5", 0, "-3/5"]}]),
    grasp(
        contacts=[SPATIAL],
        outline={"vertices": [["0", 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]]},
    ),
    contact(stiffness="00.50", preload="0/7", friction="+1."),
    contact(point=["+.5", "-7/3"], preload="-0"),
    contact(stiffness="10/03"),
    contact(point=["-1e3", "2.5E-3"], stiffness="1e-2", preload="-0e5"),
]

BAD = [
    *(grasp(schema_version=x) for x in (2, "1", True, MISSING)),
    *(grasp(contacts=x) for x in (MISSING, {}, [[]])),
    grasp(contact=[]),
    grasp(description=3),
    *(grasp(units=x) for x in ("mm", {"length": "mm"}, {"length": "mm", "force": ""})),
    *(grasp(units={"length": "mm", "force": x}) for x in (" N", "m\nm", 3, None, "N" * 21)),
    grasp(units={"length": "mm", "force": "N", "time": "s"}),
    *(grasp(outline=[["0", 0], ["4", "0"], *x]) for x in ([], [["0", 0.5]], [["0", "1", "2"]])),
    grasp(outline={"centre": ["0", "0"]}),
    grasp(outline={"centre": ["0", "0"], "radius": "0"}),
    grasp(outline={"centre": ["0", "0"], "radius": "1", "corners": []}),
    *(grasp(outline=x) for x in ("round", None)),
    *(contact(**{name: MISSING}) for name in ("point", "normal", "friction")),
    *(contact(point=x) for x in (["0"], "00", {"0": 1, "1": 1})),
    *(
        contact(point=["0", x])
        for x in ("1e10000", "1 /2", "1/0", ".", "", "٣", True, None, 0.5, "1" * 100_001)
    ),
    *(contact(friction=x) for x in ("-1/2", -1)),
    contact(stiffness="-1"),
    contact(preload="-1/10"),
    contact(adhesion="-1/10"),
    contact(colour="red"),
]


def accepted(document):
    try:
        read_grasp(document)
    except InputError:
        return False
    return True


def test_the_schema_is_a_schema():
    meta = jsonschema.Draft202012Validator.META_SCHEMA
    assert jsonschema.Draft202012Validator(meta).is_valid(grasp_schema())


@pytest.mark.parametrize(
    ("kind", "part"),
    [(Contact, ("$defs", "contact")), (Units, ("properties", "units")), (Grasp, ())],
)
def test_the_schema_has_the_fields_and_defaults_of_the_code(kind, part):
    schema = grasp_schema()
    for key in part:
        schema = schema[key]
    # Whether the stiffness is there says whether it was given.
    given = {x.name: x.default for x in fields(kind) if x.name != "stiffness_given"}
    properties = schema["properties"]
    assert properties.keys() - {"schema_version", "description"} == given.keys()
    assert set(schema["required"]) - {"schema_version"} == {
        name for name, default in given.items() if default is dataclasses.MISSING
    }
    defaults = {name: str(x) for name, x in given.items() if isinstance(x, Fraction)}
    assert {k: v["default"] for k, v in properties.items() if "default" in v} == defaults


@pytest.mark.parametrize("document", GOOD)
def test_good_documents_pass_both(document):
    assert accepted(document)
    assert VALIDATOR.is_valid(document)


@pytest.mark.parametrize("document", BAD)
def test_bad_documents_fail_both(document):
    assert not accepted(document)
    assert not VALIDATOR.is_valid(document)


def test_stiffness_that_was_not_given_is_not_written():
    bare = Grasp([Contact(("0", 0), (1, 0), "1/2"), Contact((1, 0), (-1, 0), "1/2", preload=1)])
    known = Grasp(replace(c, stiffness_given=True) for c in bare)
    for grasp, written in ((bare, False), (known, True)):
        document = grasp.to_dict()
        assert VALIDATOR.is_valid(document)
        assert ["stiffness" in entry for entry in document["contacts"]] == [written] * 2
        again = read_grasp(document)
        assert again == bare
        assert [c.stiffness_given for c in again] == [written] * 2
        proof = solve(grasp, (0, 0, 0)).certificate
        assert proof.text == solve(known, (0, 0, 0)).certificate.text
    stiff = replace(bare.contacts[0], stiffness=Fraction(3))
    assert stiff.to_dict()["stiffness"] == "3"


def test_what_is_written_and_what_ships_passes():
    for seed in range(5):
        assert VALIDATOR.is_valid(random_grasp(4, seed).to_dict())
    assert paths()
    for path in paths().values():
        assert VALIDATOR.is_valid(json.loads(path.read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    "document",
    [
        contact(normal=["1", "1"]),
        contact(point=["0", "0", "0"]),
        contact(tangent=["0", "0", "1"]),
        contact(point=["0", "0", "0"], normal=["0", "0", "1"], tangent=["0", "0", "1"]),
        grasp(contacts=[CONTACT, SPATIAL]),
        grasp(contacts=[SPATIAL], outline=[["0", 0], ["4", "0"], ["0", "3"]]),
        grasp(outline={"vertices": [["0", 0, 0]] * 3, "faces": [[0, 1, 3]]}),
    ],
)
def test_only_the_reader_checks_lengths_and_dimensions(document):
    assert VALIDATOR.is_valid(document)
    assert not accepted(document)


class TestUnits:
    grasp = Grasp([Contact((-1, 0), (1, 0), "1/2")]).with_units("mm", "N")

    def test_units_survive_files_certificates_and_preload(self):
        assert read_grasp(self.grasp.to_dict()).units == Units("mm", "N")
        assert self.grasp.with_preload(1).units == Units("mm", "N")
        verdict = solve(self.grasp, (-1, 0, 0))
        assert verdict.to_dict()["grasp"]["units"] == {"length": "mm", "force": "N"}
        assert verdict.certificate.to_dict()["grasp"]["units"]["force"] == "N"
        assert check(verdict.certificate.to_dict())

    def test_units_survive_every_changed_copy(self):
        (contact,) = self.grasp
        other = replace(contact, preload="3/2")
        copies = {
            "preload": self.grasp.with_preload("3/2"),
            "friction": self.grasp.with_friction("3/2"),
            "contacts": replace(self.grasp, contacts=(other,)),
        }
        assert {copy.units for copy in copies.values()} == {Units("mm", "N")}
        assert copies["preload"] == copies["contacts"]
        assert copies["friction"].contacts[0] == Contact((-1, 0), (1, 0), "3/2")
        with pytest.raises(GraspError, match="preload is -1"):
            replace(contact, preload=-1)

    def test_units_change_no_verdict_and_no_comparison(self):
        bare = Grasp(self.grasp.contacts)
        assert bare == self.grasp
        assert hash(bare) == hash(self.grasp)
        assert "units" not in bare.to_dict()

    def test_commands_show_them(self, tmp_path, run):
        path = tmp_path / "grasp.json"
        path.write_text(json.dumps(self.grasp.to_dict()), encoding="utf-8")
        for more in ([], ["--methods"]):
            assert "lengths in mm, forces in N" in run("solve {} --wrench -1 0 0", path, *more)
        assert json.loads(run("make random --contacts 1 --units cm lbf"))["units"] == {
            "length": "cm",
            "force": "lbf",
        }


class TestOutline:
    triangle = Polygon([(0, 0), (4, 0), (0, 3)])
    grasp = Grasp([Contact((2, 0), (0, 1), "1/2")], outline=triangle)

    @pytest.mark.parametrize("outline", [triangle, Circle((0, "1/3"), "7/2")])
    def test_outlines_survive_files_and_changed_copies(self, outline):
        grasp = self.grasp.with_outline(outline)
        assert read_grasp(json.loads(json.dumps(grasp.to_dict()))).outline == outline
        for copy in (grasp.with_preload(1), grasp.with_friction(1), grasp.with_units("cm", "N")):
            assert copy.outline == outline

    def test_outlines_change_no_verdict(self):
        bare = self.grasp.with_outline(None)
        assert (bare, hash(bare)) == (self.grasp, hash(self.grasp))
        assert "outline" not in bare.to_dict()
        with pytest.raises(GraspError, match="Polygon, a Circle"):
            Grasp([], outline=[(0, 0), (1, 0), (0, 1)])
        for wrench in ((0, -1, 0), (0, 1, 0)):
            texts = {solve(grasp, wrench).certificate.text for grasp in (bare, self.grasp)}
            assert len(texts) == 1
            assert "outline" not in texts.pop()

    def test_a_certificate_with_an_outline_is_refused(self):
        document = solve(self.grasp, (0, -1, 0)).certificate.to_dict()
        document["grasp"]["outline"] = self.triangle.to_dict()
        schema = validator(certificate_schema())
        with pytest.raises(CertificateError, match="no outline"):
            check(document)
        assert not schema.is_valid(document)
        del document["grasp"]["outline"]
        assert schema.is_valid(document)
