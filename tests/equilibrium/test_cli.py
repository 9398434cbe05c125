"""The command `equilibrium`: JSON contract, exit codes, files whole or not at all."""

import io
import json

import pytest

from arrangement.numbers.exact import number_text
from equilibrium import Contact, Grasp, read_grasp, solve
from equilibrium.cli import main
from equilibrium.grasps.inputs.random import random_grasp

THREE = "paper-three-contacts"


def test_verdicts_in_json(run):
    document = run.json("solve {} --wrench 0 -1/2 0", THREE)
    (piece,) = document["equilibria"]
    assert (run.err, document["stable"]) == ("", True)
    assert piece["motion"] == ["0", "-1/2", "0"]
    assert piece["forces"] == [["0", "0"], ["1/2", "0"], ["0", "0"]]
    assert len(piece["states"]) == 3
    document = run.json("solve {} --wrench 0 1 0", THREE, code=1)
    assert (run.err, document["stable"], document["equilibria"]) == ("", False, [])


def test_help_beside_a_wrench_in_space_is_that_of_any_wrench(run):
    usage = run("solve --help")
    assert "--wrench F_X F_Y TAU" in usage
    run("solve two-opposed-fingers --wrench 0 1 0 0 0 0")
    assert run("solve two-opposed-fingers --wrench 0 1 0 0 0 0 --help") == usage


def test_all_equilibria_of_many_contacts_on_request(run, tmp_path):
    path = tmp_path / "grasp.json"
    for contacts, complete in ((20, True), (21, False)):
        grasp = random_grasp(contacts, seed=0)
        path.write_text(json.dumps(grasp.to_dict()))
        asked = "solve {} --wrench 1 1/2 0"
        few, every = (run.json(asked + x, path, code=None) for x in ("", " --all"))
        assert ("complete" not in few, "complete" not in every) == (complete, True)
        (found,) = few["equilibria"]
        pieces = solve(grasp, (1, "1/2", 0)).equilibria
        assert any(piece.contains(found["motion"], found["forces"]) for piece in pieces)
        assert len(every["equilibria"]) == len(pieces)
        text = run(asked, path, code=None)
        assert ("--all" in text.splitlines()[0]) is not complete
        assert text.count("contact ") == contacts


@pytest.mark.parametrize(("wrench", "code"), [("-1", 0), ("1", 1)])
def test_certificate_is_written_and_verified(run, refused, tmp_path, wrench, code):
    path = tmp_path / "certificate.json"
    run("solve {} --wrench 0 {} 0 --certificate", THREE, wrench, path, code=code)
    run("verify", path)
    found = run.json("verify", path)
    assert (found["valid"], found["compared"]) == (True, False)
    assert (found["wrench"], len(found["grasp"]["contacts"])) == (["0", wrench, "0"], 3)
    asked = f"verify {{}} --wrench 0 {wrench} 0"
    out = run(f"{asked} --grasp {THREE}", path)
    assert ("compared with no" in out, f"wrench (0, {wrench}, 0)" in out) == (False, True)
    assert run(f"{asked} --grasp {THREE} --preload 1", path, code=1).startswith(
        "not valid: it is about another grasp: preload of contact 1 is 0; expected "
    )
    refused(asked, path)
    refused("verify {} --at 0 0", path)
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_a_changed_certificate_says_what_fails(run, tmp_path):
    path = tmp_path / "certificate.json"
    run("solve {} --wrench 0 1 0 --certificate", THREE, path, code=1)
    document = json.loads(path.read_text())
    document["wrench"][1] = "-1"
    path.write_text(json.dumps(document))
    assert "must be above 0" in run("verify", path, code=1)
    assert "must be above 0" in run.json("verify", path, code=1)["problem"]


@pytest.mark.parametrize(
    ("words", "wrench"),
    [
        ("--wrench 1/2 -1e-1 3", ["1/2", "-1/10", "3"]),
        ("--wrench -0.5,1,0", ["-1/2", "1", "0"]),
        ("--force 1 2 --at 3,5", ["1", "2", "1"]),
        ("--force 1,2", ["1", "2", "0"]),
        ("--weight 2 --at 1/2 7", ["0", "-2", "-1"]),
    ],
)
def test_a_wrench_is_three_words_or_one_or_a_force_at_a_point(words, wrench, run):
    assert run.json(f"solve {THREE} {words}", code=None)["wrench"] == wrench


def test_contacts_on_cone_boundary_not_slipping(run):
    out = run("solve paper-four-contacts-preload-1 --wrench 0,2,0")
    still = [line for line in out.splitlines() if "slip" in line]
    assert "motion (0, 0, 0)" in out
    assert still
    assert all("not slipping" in line for line in still)
    out = run("solve {} --preload 1 --wrench 0,1,0", THREE)
    assert "slip+" in out
    assert "not slipping" not in out


def test_long_numbers_are_rounded_unless_they_are_wanted_exactly(run):
    wrench = ("1/12345678901234567", "-1/2", "0")
    asked = ("solve", THREE, "--wrench", *wrench)
    (x, y, r), *_ = (piece.motion for piece in solve(read_grasp(THREE), wrench).equilibria)
    assert f"({x}, {y}, {r})" in run(*asked, "--exact")
    assert "(≈5.4e-17, ≈-0.5, ≈-5.4e-17)" in run(*asked)
    assert f"({number_text(x, 20)}, " in run(*asked, "--digits", "20")
    document = run.json(*asked, "--digits", "3")
    assert document["equilibria"][0]["motion"] == [str(x), str(y), str(r)]
    assert run(*asked) == run(*asked, "--digits", "6")


def test_least_friction_printed_with_certain_digits(run):
    asked = "resisted paper-three-contacts-preload-1 --wrench 1/7 1 1/3 --margin"
    bounds = "between 652447/1048576 and 28/45"
    assert f"least uniform friction: 0.622222 ({bounds})" in run(asked, code=1)
    few = run(asked, "--digits", "3", code=1)
    assert f"least uniform friction: 0.622 ({bounds})" in few
    assert f"least uniform friction: {bounds}" in run(asked, "--exact", code=1)


@pytest.mark.parametrize(
    "way", ["--weight 1 --at 2 0", "--force 0 -1 --at 2 0", "--wrench=0,-1,-2"]
)
@pytest.mark.parametrize("command", ["draw", "lab"])
def test_pictures_and_pages_take_a_load_as_verdicts_do(command, way, tmp_path, run):
    made = []
    for number, load in enumerate([way, "--wrench 0 -1 -2"]):
        target = tmp_path / f"{number}.html"
        run(f"{command} ladder {load} -o", target)
        made.append(target.read_text(encoding="utf-8"))
    assert made[0] == made[1]


def test_magnitudes_along_a_force(run):
    found = run("resisted ladder --weight 1 --at 2 0"), run.err
    assert found == (run("resisted ladder --wrench 0 -1 -2"), run.err)


def test_make_writes_the_file_that_it_prints(tmp_path, run):
    printed = run("make random --contacts 3")
    assert run("make random --contacts 3 -o", tmp_path / "g.json") == ""
    assert (tmp_path / "g.json").read_text(encoding="utf-8") == printed


def test_a_textbook_name_is_answered_with_two_commands(refused):
    answer = (
        "'arch' is a family; write 'equilibrium make arch --voussoirs 5 -o FILE.json', then "
        "'equilibrium solve FILE.json' (see"
    )
    assert answer in refused("arch 5")


def test_info_describes_a_grasp(run):
    lines = run("info paper-three-contacts").splitlines()
    rows = dict(line.split("  ", 1) for line in lines if line[0] != " ")
    assert {name: text.strip() for name, text in rows.items()} == {
        "contacts": "3, in the plane",
        "stiffness": "given",
        "rank": "3 of 3 tangential hyperplanes",
        "force closure": "yes",
    }
    assert run("info two-opposed-fingers").endswith("no (round cones, proved)\n")


def test_methods_are_chosen_by_name(run):
    asked = "solve paper-three-contacts --wrench 0 1 0 --methods weak cones"
    names = [entry["method"] for entry in run.json(asked, code=1)["methods"]]
    assert names == ["complete", "cones", "weak"]


def test_load_of_a_file_is_taken_where_none_is_given(run, refused, tmp_path):
    contacts = [
        {"position": [x, 0], "normal": [-x, 0], "mu": 0.5, "normal_force": 1} for x in (-1, 1)
    ]
    path = tmp_path / "a.json"
    path.write_text(json.dumps({"contacts": contacts, "wrench": [0, -3, 0]}))
    run("solve", path, code=1)
    run("solve {} --wrench 0,-1,0", path)
    run("resisted {} --friction 1 2", path)
    assert read_grasp(path) == Grasp(Contact([x, 0], [-x, 0], "1/2", preload=1) for x in (-1, 1))
    grasp = {"contacts": [{**entry, "position": {"x": -1, "y": 0}} for entry in contacts[:1]]}
    path.write_text(json.dumps({"grasp": grasp, "wrench": [0, "-1/2", 0]}))
    run("solve", path, code=1)
    path.write_text(json.dumps({"contacts": contacts}))
    assert 'or write the key "wrench" into the file' in refused("solve", path)


def test_a_table_on_standard_input_is_referred_to_files(refused, monkeypatch):
    table = io.BytesIO(b"x,y,nx,ny,mu\n0,0,0,1,1\n")
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(table))
    answer = "standard input is not JSON; tables are read from files"
    assert answer in refused("solve - --weight 1")


def test_help_of_views_in_one_process(capsys):
    helps = []
    for view in ("slice", "grasp", "slice"):
        with pytest.raises(SystemExit):
            main(["draw", "--view", view, "--help"])
        helps.append(capsys.readouterr().out)
    assert helps[0] == helps[2] != helps[1]


def test_negative_number_without_a_place(refused):
    error = refused("resisted {} --also -1,0,-0.25 --along 1,1,-1,1/2,-0.25,1/2", THREE)
    assert error.startswith("error: unexpected argument '-0.25'; ")
