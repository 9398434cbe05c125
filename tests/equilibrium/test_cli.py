"""The command `equilibrium`: JSON contract, exit codes, files whole or not at all."""

import io
import json

import pytest

from arrangement.numbers.exact import number_text
from equilibrium import Contact, Grasp, read_grasp, solve
from equilibrium.cli.program import main
from equilibrium.grasps.inputs.random import random_grasp

THREE = "paper-three-contacts"


def call(capsys, *arguments):
    code = main(arguments)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_verdicts_in_json(capsys):
    code, out, err = call(capsys, "solve", THREE, "--wrench", "0", "-1/2", "0", "--json")
    (piece,) = json.loads(out)["equilibria"]
    assert (code, err, json.loads(out)["stable"]) == (0, "", True)
    assert piece["motion"] == ["0", "-1/2", "0"]
    assert piece["forces"] == [["0", "0"], ["1/2", "0"], ["0", "0"]]
    assert len(piece["states"]) == 3
    code, out, err = call(capsys, "solve", THREE, "--wrench", "0", "1", "0", "--json")
    document = json.loads(out)
    assert (code, err, document["stable"], document["equilibria"]) == (1, "", False, [])


def test_all_equilibria_of_many_contacts_on_request(capsys, tmp_path):
    path = tmp_path / "grasp.json"
    for contacts, complete in ((20, True), (21, False)):
        grasp = random_grasp(contacts, seed=0)
        path.write_text(json.dumps(grasp.to_dict()))
        asked = ("solve", str(path), "--wrench", "1", "1/2", "0")
        few, every = (json.loads(call(capsys, *asked, *x, "--json")[1]) for x in ((), ("--all",)))
        assert ("complete" not in few, "complete" not in every) == (complete, True)
        (found,) = few["equilibria"]
        pieces = solve(grasp, (1, "1/2", 0)).equilibria
        assert any(piece.contains(found["motion"], found["forces"]) for piece in pieces)
        assert len(every["equilibria"]) == len(pieces)
        text = call(capsys, *asked)[1]
        assert ("--all" in text.splitlines()[0]) is not complete
        assert text.count("contact ") == contacts


@pytest.mark.parametrize(("wrench", "code"), [("-1", 0), ("1", 1)])
def test_certificate_is_written_and_verified(capsys, tmp_path, wrench, code):
    path = tmp_path / "certificate.json"
    arguments = ("solve", THREE, "--wrench", "0", wrench, "0", "--certificate", str(path))
    assert call(capsys, *arguments)[0] == code
    assert call(capsys, "verify", str(path))[0] == 0
    verified, out, _ = call(capsys, "verify", str(path), "--json")
    found = json.loads(out)
    assert (verified, found["valid"], found["compared"]) == (0, True, False)
    assert (found["wrench"], len(found["grasp"]["contacts"])) == (["0", wrench, "0"], 3)
    asked = ("verify", str(path), "--wrench", "0", wrench, "0", "--grasp")
    code, out, _ = call(capsys, *asked, THREE)
    assert (code, "compared with no" in out, f"wrench (0, {wrench}, 0)" in out) == (0, False, True)
    code, out, _ = call(capsys, *asked, THREE, "--preload", "1")
    assert code == 1
    assert out.startswith(
        "not valid: it is about another grasp: preload of contact 1 is 0; expected "
    )
    assert (
        call(capsys, *asked[:-1])[0] == call(capsys, "verify", str(path), "--at", "0", "0")[0] == 2
    )
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_a_changed_certificate_says_what_fails(capsys, tmp_path):
    path = tmp_path / "certificate.json"
    call(capsys, "solve", THREE, "--wrench", "0", "1", "0", "--certificate", str(path))
    document = json.loads(path.read_text())
    document["wrench"][1] = "-1"
    path.write_text(json.dumps(document))
    code, out, _ = call(capsys, "verify", str(path))
    assert code == 1
    assert "must be above 0" in out
    code, out, _ = call(capsys, "verify", str(path), "--json")
    assert code == 1
    assert "must be above 0" in json.loads(out)["problem"]


def test_a_wrench_is_three_words_or_one_or_a_force_at_a_point(capsys):
    def wrench(*words):
        code, out, _ = call(capsys, "solve", THREE, *words, "--json")
        assert code in (0, 1)
        return json.loads(out)["wrench"]

    assert wrench("--wrench", "1/2", "-1e-1", "3") == ["1/2", "-1/10", "3"]
    assert wrench("--wrench", "-0.5,1,0") == ["-1/2", "1", "0"]
    assert wrench("--force", "1", "2", "--at", "3,5") == ["1", "2", "1"]
    assert wrench("--force", "1,2") == ["1", "2", "0"]
    assert wrench("--weight", "2", "--at", "1/2", "7") == ["0", "-2", "-1"]


def test_contacts_on_cone_boundary_not_slipping(capsys):
    edge, slipping = "paper-four-contacts-preload-1", (THREE, "--preload", "1")
    _, out, _ = call(capsys, "solve", edge, "--wrench", "0,2,0")
    still = [line for line in out.splitlines() if "slip" in line]
    assert "motion (0, 0, 0)" in out
    assert still
    assert all("not slipping" in line for line in still)
    _, out, _ = call(capsys, "solve", *slipping, "--wrench", "0,1,0")
    assert "slip+" in out
    assert "not slipping" not in out


def test_long_numbers_are_rounded_unless_they_are_wanted_exactly(capsys):
    asked = ("solve", THREE, "--wrench", "1/12345678901234567", "-1/2", "0")
    (x, y, r), *_ = (piece.motion for piece in solve(read_grasp(THREE), asked[3:]).equilibria)
    assert f"({x}, {y}, {r})" in call(capsys, *asked, "--exact")[1]
    assert "(≈5.4e-17, ≈-0.5, ≈-5.4e-17)" in call(capsys, *asked)[1]
    assert f"({number_text(x, 20)}, " in call(capsys, *asked, "--digits", "20")[1]
    document = json.loads(call(capsys, *asked, "--digits", "3", "--json")[1])
    assert document["equilibria"][0]["motion"] == [str(x), str(y), str(r)]
    assert call(capsys, *asked)[1] == call(capsys, *asked, "--digits", "6")[1]


def test_least_friction_printed_with_certain_digits(capsys):
    asked = (
        "resisted",
        "paper-three-contacts-preload-1",
        "--wrench",
        "1/7",
        "1",
        "1/3",
        "--margin",
    )
    bounds = "between 652447/1048576 and 28/45"
    assert f"least uniform friction: 0.622222 ({bounds})" in call(capsys, *asked)[1]
    assert f"least uniform friction: 0.622 ({bounds})" in call(capsys, *asked, "--digits", "3")[1]
    assert f"least uniform friction: {bounds}" in call(capsys, *asked, "--exact")[1]


@pytest.mark.parametrize("way", [("--weight", "1"), ("--force", "0", "-1"), ("--wrench=0,-1,-2",)])
@pytest.mark.parametrize("command", ["draw", "lab"])
def test_pictures_and_pages_take_a_load_as_verdicts_do(command, way, tmp_path, capsys):
    at = () if way[0].startswith("--wrench") else ("--at", "2", "0")
    made = []
    for number, load in enumerate([(*way, *at), ("--wrench", "0", "-1", "-2")]):
        target = tmp_path / f"{number}.html"
        assert call(capsys, command, "ladder", *load, "-o", str(target))[0] == 0
        made.append(target.read_text(encoding="utf-8"))
    assert made[0] == made[1]


def test_magnitudes_along_a_force(capsys):
    found = call(capsys, "resisted", "ladder", "--weight", "1", "--at", "2", "0")
    assert found == call(capsys, "resisted", "ladder", "--wrench", "0", "-1", "-2")


def test_make_writes_the_file_that_it_prints(tmp_path, capsys):
    asked = ("make", "random", "--contacts", "3")
    printed = call(capsys, *asked)[1]
    assert call(capsys, *asked, "-o", str(tmp_path / "g.json"))[1] == ""
    assert (tmp_path / "g.json").read_text(encoding="utf-8") == printed


@pytest.mark.parametrize(
    ("words", "now"),
    [
        ("limit ladder", "equilibrium resisted ladder --wrench F_X F_Y TAU"),
        ("gws ladder", "equilibrium info ladder --force-closure"),
        ("check proof.json", "equilibrium verify CERTIFICATE, or equilibrium solve"),
        ("export ladder", "equilibrium draw ladder --model scene -o FILE.xml"),
        ("resisted ladder --any-direction", "--smallest"),
        ("resisted ladder --direction 0 1 0", "--wrench"),
        ("solve ladder --weight 1 --literal signs", "--as-printed"),
        ("verify proof.json --proved", "--verified"),
        ("make mesh a.stl --friction 1 --within 1", "--max-distance"),
        ("examples", "equilibrium list"),
        ("friction ladder", "equilibrium resisted ladder --wrench F_X F_Y TAU --friction 1 2"),
        ("tilt", "equilibrium resisted GRASP --wrench F_X F_Y TAU --parameter t=0..1"),
        ("quiz", "equilibrium lab -o LAB.html, a page with exercises, which proofs-check grade"),
        ("slides", "equilibrium lab -o LAB.html'"),
        ("import a.stl", "equilibrium make mesh FILE --friction 1/2 --random 4 -o GRASP.json"),
        ("animate ladder -o a.gif", "equilibrium lab -o LAB.html, where contacts"),
        ("region ladder -o a.svg", "equilibrium draw ladder --view resist -o REGION.svg"),
        ("resisted ladder -o a.svg", "equilibrium draw ladder --view resist -o REGION.svg"),
        ("solve ladder --weight 1 --angle 30", "--force F_X F_Y, or a letter in the file"),
        ("make arch --stones 9", "equilibrium make arch --voussoirs N -o ARCH.json"),
    ],
)
def test_other_words_say_what_to_write(capsys, words, now):
    with pytest.raises(SystemExit) as stopped:
        main(words.split())
    assert stopped.value.code == 2
    assert f"; write '{now}" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("word", "use"),
    [
        ("ladder", "solve ladder --weight 1"),
        ("my contacts.csv", "solve 'my contacts.csv' --weight 1"),
    ],
)
def test_subjects_typed_as_commands_are_answered_with_a_command(capsys, word, use):
    with pytest.raises(SystemExit):
        main([word])
    expected = f"{word!r} is not a command; write equilibrium {use} (see"
    assert expected in capsys.readouterr().err


def test_families_typed_as_commands_are_answered_with_two(capsys):
    with pytest.raises(SystemExit):
        main(["arch", "5"])
    expected = (
        "'arch' is a family; write 'equilibrium make arch --voussoirs 5 -o FILE.json', then "
        "'equilibrium solve FILE.json' (see"
    )
    assert expected in capsys.readouterr().err


def test_numbers_that_stand_alone_name_the_option_of_the_wrench(capsys):
    with pytest.raises(SystemExit):
        main(["solve", "ladder", "0", "-1", "0"])
    expected = "unexpected argument '0'; write --wrench F_X F_Y TAU"
    assert expected in capsys.readouterr().err


def test_info_describes_a_grasp(capsys):
    code, out, _ = call(capsys, "info", "paper-three-contacts")
    assert code == 0
    rows = dict(line.split("  ", 1) for line in out.splitlines() if line[0] != " ")
    assert {name: text.strip() for name, text in rows.items()} == {
        "contacts": "3, in the plane",
        "stiffness": "given",
        "rank": "3 of 3 tangential hyperplanes",
        "force closure": "yes",
    }
    assert call(capsys, "info", "two-opposed-fingers")[1].endswith("no (round cones, proved)\n")


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("info ladder --count", "--count goes with --modes"),
        ("info ladder --modes --norm L1", "--norm goes with --force-closure"),
        ("info ladder --modes --at 0 1", "--at goes with --force or --weight"),
        ("info ladder --force-closure --at 0 1", "--at goes with --force or --weight"),
        ("info ladder --modes --preload 1", "--preload does not go with --modes"),
        (
            "solve ladder --weight 1 --methods --robust friction=1%",
            "--robust goes with the verdict of the full model, not with --methods",
        ),
        ("solve ladder --weight 1 --methods mosek", "there is no method 'mosek'"),
        ("solve wedge --weight 1 --methods printed", "no method 'printed' for one wrench of such"),
        (
            "solve ladder --weight 1 --as-printed signs --max-displacement 1",
            "--max-displacement goes with the verdict of the full model, not with --as-printed",
        ),
    ],
)
def test_options_that_do_not_go_together_are_refused(capsys, words, reason):
    assert main(words.split()) == 2
    assert reason in capsys.readouterr().err


def test_methods_are_chosen_by_name(capsys):
    asked = (
        "solve",
        "paper-three-contacts",
        "--wrench",
        "0",
        "1",
        "0",
        "--methods",
        "weak",
        "cones",
    )
    code, out, _ = call(capsys, *asked, "--json")
    assert code == 1
    names = [entry["method"] for entry in json.loads(out)["methods"]]
    assert names == ["complete", "cones", "weak"]


def test_load_of_a_file_is_taken_where_none_is_given(capsys, tmp_path):
    contacts = [
        {"position": [x, 0], "normal": [-x, 0], "mu": 0.5, "normal_force": 1} for x in (-1, 1)
    ]
    path = tmp_path / "a.json"
    path.write_text(json.dumps({"contacts": contacts, "wrench": [0, -3, 0]}))
    assert main(["solve", str(path)]) == 1
    assert main(["solve", str(path), "--wrench", "0,-1,0"]) == 0
    assert main(["resisted", str(path), "--friction", "1", "2"]) == 0
    assert read_grasp(path) == Grasp(Contact([x, 0], [-x, 0], "1/2", preload=1) for x in (-1, 1))
    grasp = {"contacts": [{**entry, "position": {"x": -1, "y": 0}} for entry in contacts[:1]]}
    path.write_text(json.dumps({"grasp": grasp, "wrench": [0, "-1/2", 0]}))
    assert main(["solve", str(path)]) == 1
    path.write_text(json.dumps({"contacts": contacts}))
    capsys.readouterr()
    assert main(["solve", str(path)]) == 2
    assert 'or write the key "wrench" into the file' in capsys.readouterr().err


@pytest.mark.parametrize(
    "content", ["resisted: 1 family", "x,y,nx,ny,mu\n", "", '{"verdict": "resisted"}', "[]"]
)
def test_what_is_no_certificate_says_what_writes_one(capsys, tmp_path, content):
    path = tmp_path / "a.txt"
    path.write_text(content)
    assert main(["verify", str(path)]) == 2
    answer = "GRASP --wrench F_X F_Y TAU --certificate CERT.json` writes a certificate"
    assert answer in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "content", "answer"),
    [
        ("a.xlsx", "PK", "'a.xlsx' is a spreadsheet; save it as CSV"),
        ("a.yaml", "contacts:", "'a.yaml' is not JSON; write the same keys and lists as JSON"),
        ("a.csv", "id,x,y,nx,ny,mu\n", "the column 'id' is unknown; leave it out, or name it one"),
        (
            "-",
            "x,y,nx,ny,mu\n0,0,0,1,1\n",
            "standard input is not JSON; tables are read from files",
        ),
        (
            "a.json",
            '{"schema_version": 1, "contacts": [], "load": ["0", "-1", "0"]}',
            "A load is the key wrench of a file, such as [0, -1, 0], or an option: --wrench F_X",
        ),
        (
            "a.json",
            '{"contacts": [{"pos": [0, 0], "n": [0, 1], "share_of": 1}], "mu": 1, "about": 2}',
            "the unknown keys 'mu', 'about'; known keys are schema_version, contacts, description, "
            "units, outline, data_error. Friction, stiffness and preload are keys of each contact; "
            "contacts[0] has the unknown key 'share_of', and lacks \"friction\"; known keys are",
        ),
        (
            "a.json",
            '[{"point": ["0", "0"], "normal": ["0", "1"], "friction": "mu"}]',
            "One letter, such as t, is for `resisted --parameter t=0..1`",
        ),
        ("a.json", "{}", 'add "schema_version": 1, and the key "contacts"'),
    ],
)
def test_files_that_are_no_grasps_say_what_to_do(
    capsys, tmp_path, monkeypatch, name, content, answer
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(content.encode())))
    if name != "-":
        (tmp_path / name).write_text(content)
    assert main(["solve", name, "--weight", "1"]) == 2
    assert answer in capsys.readouterr().err
