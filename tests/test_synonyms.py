"""Names of other programs: each target runs, and unknown attributes are answered with it."""

import copy
import dataclasses
import doctest
import json
import math
import pickle
import re
import shlex
import subprocess
import sys
from dataclasses import FrozenInstanceError
from importlib import import_module
from importlib.resources import files
from inspect import signature
from pathlib import Path
from types import SimpleNamespace
from typing import ClassVar

import pytest

import arrangement
import equilibrium
import proofs_check
from arrangement import Arrangement, Segments, families, synonyms
from arrangement.cli import main as arrangement_main
from arrangement.errors import HintsMixin
from arrangement.library.families import FAMILIES
from equilibrium import Contact, Grasp, ResistedSet, read_grasp, solve
from equilibrium.model.synonyms import ARGUMENTS, NAMES, STATICS


class Painted(HintsMixin):
    """A value that takes a synonym as an argument of its own, and fails for another reason."""

    _synonyms: ClassVar = {"color": "colour"}

    def __init__(self, color):
        raise TypeError(f"{color} is not painted")


LINES = Arrangement([[1, 0], [0, 1], [1, 1]], [0, 0, 1])


def run(expression: str, **names: object) -> None:
    """Run an expression, maybe after an import, as a test; show its value only if it raises."""
    before, separator, last = expression.rpartition("; ")
    example = doctest.DocTestParser().get_doctest(
        f">>> {before}{separator}value = {last}\n", names, expression, None, 0
    )
    doctest.DebugRunner().run(example, clear_globs=False)
    assert "value" in example.globs


@pytest.mark.parametrize("planes", [LINES, families.braid(3)], ids=["affine", "central"])
@pytest.mark.parametrize("program", synonyms.ARRANGEMENT)
def test_names_for_arrangements_run(program, planes, tmp_path):
    pytest.importorskip("matplotlib")
    regions = planes.regions()
    planes.save(tmp_path / "a.json")
    names = {
        "A": planes,
        "B": planes[:1],
        "arrangement": arrangement,
        "i": 1,
        "json": json,
        "normal": [1] * planes.dimension,
        "offset": 0,
        "pandas": PANDAS,
        "point": regions[0].witness,
        "r": regions[0],
        "s": regions[1],
    }
    for word, name in synonyms.ARRANGEMENT[program].items():
        assert word not in dir(planes), f"{word} is there"
        names["path"] = str(tmp_path / ("a.svg" if "write" in name else "a.json"))
        run(name.replace("A.dual", "A.dual" if planes.is_central else "A.cone().dual"), **names)
        with pytest.raises(AttributeError) as error:
            getattr(planes, word)
        assert str(error.value).endswith(f"; use {name}")


def test_families_are_named_by_the_package():
    used = synonyms.PACKAGE.items()
    named = {name for name, use in used if use == f"arrangement.families.{name}"}
    assert named == {name.replace("-", "_") for name in FAMILIES}


#: The one name of pandas that is used, which takes arrays and lists.
PANDAS = SimpleNamespace(DataFrame=len)
EXAMPLE = files("proofs_check.examples") / "triangles.py"
#: Values for the letters of what the packages answer.
VALUES = {
    "A": LINES,
    "F": LINES.regions(),
    "json": json,
    "pandas": PANDAS,
    "r": LINES.bounded_regions()[0],
    "S": Segments([((0, 0), (4, 4)), ((0, 4), (4, 0))]),
    "normal": [1, 0],
    "offset": 1,
    "contact": Contact([0, 1], [0, -1], 1),
    "grasp": read_grasp("paper-four-contacts-preload-1"),
    "claim": proofs_check.registry()["fukuda-bound-attained"],
    "wrench": [0, "1/2", 0],
    "direction": [0, 1, 0],
    "wrenches": [[0, 0.5, 0]],
    "u": [1, 0, 0],
    "v": [0, 1, 0],
    "statement": "regions <= 7",
    "of": "lines",
    "quantity": "regions",
    "low": 3,
    "high": 3,
}


@pytest.mark.parametrize(
    ("owner", "table"),
    [
        (VALUES["S"], synonyms.SEGMENTS),
        (VALUES["r"], synonyms.FACES),
        (VALUES["F"], synonyms.SEQUENCES),
        (arrangement, synonyms.PACKAGE),
        (equilibrium, equilibrium._SYNONYMS),
        (proofs_check, proofs_check._SYNONYMS),
    ],
    ids=["segments", "faces", "sequences", "arrangement", "equilibrium", "proofs_check"],
)
def test_names_of_segments_and_packages_run(owner, table, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    names = {name: getattr(owner, name) for name in dir(owner)} | vars(owner) | VALUES
    GRASP.save("grasp.json")
    LINES.save("lines.json")
    Path("arch.json").write_text(json.dumps(equilibrium.Assembly(["block"]).to_dict()))
    path = {arrangement: "lines.json", proofs_check: str(EXAMPLE)}.get(owner, "grasp.json")
    sources = {"source": solve(GRASP, LOAD).certificate}
    if owner is proofs_check:  # a package of the same name is there once it has been imported
        monkeypatch.delattr(proofs_check, "claims", raising=False)
    for word, use in table.items():
        with pytest.raises(AttributeError) as error:
            getattr(owner, word)
        assert str(error.value).endswith(f"; use {use}")
        path = "arch.json" if "assembly(path" in use else path
        packages = {"arrangement": arrangement, "equilibrium": equilibrium}
        run(use.replace("[...]", "None"), **names | packages, path=path, **sources)


@pytest.mark.parametrize("kind", [Arrangement, Grasp, Contact])
def test_classes_answer_as_their_values_do(kind):
    for word, name in kind._synonyms.items():
        if word not in dir(kind):
            with pytest.raises(AttributeError, match=re.escape(f"'{word}'; use {name}") + "$"):
                getattr(kind, word)


def test_import_of_another_name_is_answered():
    with pytest.raises(ImportError, match=r"'diagonals'; use arrangement\.families\.diagonals$"):
        from arrangement import diagonals  # noqa: F401
    with pytest.raises(ImportError, match=r"'read_csv'; use read_grasp\(path\)$"):
        from equilibrium import read_csv  # noqa: F401
    from arrangement import cli

    assert cli.__name__ == "arrangement.cli"
    assert not hasattr(arrangement, "diagonals")


#: Tables of hints; names in them such as arrangement.families are imported as they stand.
TABLES = [
    *synonyms.ARRANGEMENT.values(),
    synonyms.PACKAGE,
    equilibrium._SYNONYMS,
    proofs_check._SYNONYMS,
    Grasp._synonyms,
]


def test_packages_that_hints_name_are_modules():
    text = " ".join(use for table in TABLES for use in table.values())
    named = set(re.findall(r"((?:arrangement|equilibrium)\.(?:[a-z]+))\.", text))
    assert "arrangement.families" in named
    named |= {"arrangement.census", "equilibrium.inputs"}
    # In a process of its own: pytest imports files by their paths.
    program = f"""
from importlib import import_module
for place in {sorted(named)}:
    package, _, name = place.partition(".")
    assert import_module(place) is getattr(import_module(package), name), place
"""
    assert subprocess.run([sys.executable, "-c", program]).returncode == 0


def test_public_packages_load_late():
    program = "import sys, arrangement, equilibrium; print(*sys.modules)"
    command = [sys.executable, "-c", program]
    loaded = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    late = {"arrangement.library.families", "arrangement.library.census", "equilibrium.inputs"}
    assert "equilibrium" in loaded
    assert not late & set(loaded)


def test_claim_as_text_is_answered():
    with pytest.raises(proofs_check.ClaimError, match="claim is 'm > 2'; expected a Cl") as error:
        proofs_check.evaluate("m > 2")
    expression, place = re.findall(r"write (evaluate.*?), from ([\w.]+),", str(error.value))[0]
    made = import_module(place).one_line_claim
    run(expression, evaluate=proofs_check.evaluate, one_line_claim=made, TEXT="m > 2")


def test_another_word_for_an_argument_is_answered():
    with pytest.raises(TypeError, match="Contact has no argument mu; use friction"):
        Contact([0, 0], [0, 1], mu="1/2")
    with pytest.raises(TypeError, match="missing 1 required"):
        Contact([0, 0], [0, 1])
    with pytest.raises(TypeError, match="Arrangement has no argument hyperplanes; use one of norm"):
        Arrangement(hyperplanes=[[1, 0]])
    with pytest.raises(TypeError, match="has no argument normal; use normals"):
        Arrangement(normal=[[1, 0]])
    with pytest.raises(TypeError, match=r"claim has no argument domain; use of$"):
        proofs_check.claim("regions > 2", domain="simple")
    with pytest.raises(TypeError, match=r"exercise has no argument marks; use points$"):
        proofs_check.exercise("How many?", marks=2)


@pytest.mark.parametrize("word", ARGUMENTS)
def test_another_word_for_an_argument_of_solve_is_answered(word):
    with pytest.raises(TypeError) as error:
        solve(GRASP, **{word: 1})
    head, _, use = str(error.value).partition("; use ")
    assert head == f"solve has no argument {word}"
    name, _, value = use.partition("=")
    known = signature(solve).parameters | signature(equilibrium.resisted_values).parameters
    if name not in known:
        run(use, grasp=GRASP, friction="1/2", preload=1)
    if value:
        names = dict(zip(("f_x", "f_y", "torque"), LOAD, strict=True))
        run(f"solve(GRASP, {name}={value})", solve=solve, GRASP=GRASP, **names)


@pytest.mark.parametrize("word", synonyms.FILES)
def test_another_word_for_a_file_is_answered(word):
    for read in (read_grasp, arrangement.read_arrangement, equilibrium.read_assembly):
        with pytest.raises(TypeError, match=f"{read.__name__} has no argument {word}; use source$"):
            read(**{word: "paper-four-contacts-preload-1"})
        assert "source" in signature(read).parameters


def test_one_name_means_one_thing():
    rows = [row for words in synonyms.ARRANGEMENT.values() for row in words.items()]
    known = {word.lower(): name for word, name in rows}
    for word, name in rows:
        assert known[word.lower()] == name, word


@pytest.mark.parametrize(
    ("name", "use"),
    [
        ("num_regions", "A.region_count()"),
        ("number_of_bounded_regions", "A.bounded_region_count(relative=True)"),
        ("nb_hyperplanes", "len(A)"),
        ("get_rank", "rank"),
        ("compute_regions", "regions"),
        ("char_poly", "characteristic_polynomial"),
        ("CHAMBERS", "chambers"),
        ("N_CHAMBERS", "chambers"),
        ("F_VECTOR", "f_vector"),
    ],
)
def test_variants_of_names_are_answered(name, use):
    with pytest.raises(AttributeError) as error:
        getattr(LINES, name)
    assert str(error.value).endswith(f"'{name}'; use {use}")
    assert use.startswith(("A.", "len")) or hasattr(LINES, use)


@pytest.mark.parametrize("name", ["zon", "unbounded_face_list", "cut", "decone"])
def test_names_that_are_only_alike_are_answered_with_main_names(name):
    with pytest.raises(AttributeError, match=f"'{name}'; Arrangement has f_vector, ") as error:
        getattr(LINES, name)
    assert str(error.value).endswith(", ...: see help(Arrangement)")


@pytest.mark.parametrize(
    "value",
    [
        LINES,
        VALUES["S"],
        VALUES["grasp"],
        VALUES["contact"],
        equilibrium.Assembly(["block"]),
        solve(VALUES["grasp"], VALUES["wrench"]),
        ResistedSet(VALUES["grasp"]),
    ],
    ids=lambda value: type(value).__name__,
)
def test_main_names_are_there(value):
    for owner in (value, type(value)):
        with pytest.raises(AttributeError) as error:
            owner.xyzzy  # noqa: B018
        names = re.findall(r"; (\w+) has (.+), \.\.\.: see help", str(error.value))
        assert [(type(value).__name__, ", ".join(type(value)._main))] == names
    assert set(value._main) <= {*dir(value)}


def test_names_for_pictures_run(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    drawing = LINES.draw()
    assert set(drawing._main) <= {*dir(drawing)}
    for value in (LINES, VALUES["S"], VALUES["grasp"], drawing):
        for word in {**synonyms.PICTURES, **synonyms.PAGES}.keys() & value._synonyms.keys():
            if word not in dir(value):
                with pytest.raises(AttributeError) as error:
                    getattr(value, word)
                use = str(error.value).partition("; use ")[2]
                assert use == value._synonyms[word]
    for use in {*drawing._synonyms.values()} | {*synonyms.PICTURES.values()}:
        owner = "drawing" if use.startswith("write") else "A"
        run(f"{owner}.{use}", A=LINES, drawing=drawing, path="p.svg")
    for value in (LINES, VALUES["grasp"]):
        run("A.lab()", A=value)
        assert {*synonyms.PAGES.values()} == {"lab()"}


def test_names_for_grasps_run():
    pytest.importorskip("matplotlib")
    names = {name: getattr(equilibrium, name) for name in dir(equilibrium)}
    data = {"points": [[0.5, 0], [-0.5, 0]], "normals": [[-1, 0], [1, 0]], "friction": 0.5}
    made = {"contacts": [1], "wrench": VALUES["wrench"], "grasp": VALUES["grasp"]}
    for word in ("from_arrays", "max_load", "min_friction", "min_preload", "from_polygon"):
        run(Grasp._synonyms[word], **names, **data, **made, equilibrium=equilibrium)
    run(f"grasp.{Grasp._synonyms['plot_resisted_region']}", **names, **made)


def test_sufficient_friction_takes_a_grasp():
    grasp = VALUES["grasp"]
    least = equilibrium.sufficient_friction(grasp, [1, 2], [0, "1/2", 0])
    document = grasp.to_dict() | {"wrench": [0, "1/2", 0]}
    assert least.to_dict() == equilibrium.sufficient_friction(document, [1, 2]).to_dict()


PROGRAMS = {
    "arrangement": "arrangement.cli",
    "equilibrium": "equilibrium.cli.program",
    "proofs-check": "proofs_check.cli.program",
}


#: Lines that newcomers typed, each with the line that the answer puts first, or writes.
GUESSES = """
arrangement 'x = 0; y = 0' | arrangement count 'x = 0; y = 0'
arrangement lines.csv | arrangement count lines.csv
arrangement pencil | arrangement count pencil
arrangement chambers pencil | arrangement count pencil
arrangement characteristic-polynomial pencil | arrangement count pencil
arrangement count pencil --regions | arrangement count pencil
arrangement count pencil --format json | --json
arrangement count pencil --out a.txt | arrangement count pencil > a.txt
arrangement count pencil braid-a3 | for f in pencil braid-a3; do arrangement count $f; done
arrangement count pencil --dim 3 | arrangement faces pencil --dimension K
arrangement vertices pencil | arrangement faces pencil
arrangement faces pencil --dim 1 | --dimension 1
arrangement faces pencil -d 1 | --dimension 1
arrangement faces pencil bounded | arrangement faces pencil --bounded
arrangement plot pencil -o a.svg | arrangement draw pencil -o a.svg
arrangement draw pencil a.svg | arrangement draw pencil -o a.svg
arrangement draw pencil --out a.svg | -o a.svg
arrangement draw pencil --save a.svg | -o a.svg
arrangement draw pencil -o a.svg --color sides | --colour sides
arrangement lab a.csv b.csv -o a.html | for f in a.csv b.csv; do arrangement lab $f -o $f.html; done
arrangement lattice pencil | arrangement draw pencil -o FILE.svg --view lattice
arrangement interactive | arrangement lab -o PAGE.html
arrangement isomorphism pencil | arrangement identify pencil
arrangement families | arrangement list --families
arrangement list families | arrangement list --families
arrangement convert pencil a.m2 | -o a.m2
arrangement convert pencil oscar | --to oscar
arrangement convert pencil --format sage | --to sage
arrangement make braid 4 | arrangement make braid --n 4
arrangement make braid n=4 | arrangement make braid --n 4
arrangement make braid -n 4 | --n 4
arrangement make generic 5 2 | arrangement make generic --m 5 --d 2
arrangement make random | arrangement make random-integer --m 3
arrangement version | arrangement --version
arrangement help count | arrangement count --help
arrangement --json count pencil | arrangement count pencil --json
equilibrium ladder | equilibrium solve ladder --weight 1
equilibrium 'my contacts.csv' | equilibrium solve 'my contacts.csv' --weight 1
equilibrium stable ladder --wrench 0 -1 0 | equilibrium solve ladder --wrench 0 -1 0
equilibrium solve ladder 0 -1 0 | equilibrium solve ladder --wrench 0 -1 0
equilibrium solve ladder 0,-1,0 | equilibrium solve ladder --wrench 0 -1 0
equilibrium solve ladder weight 1 | equilibrium solve ladder --weight 1
equilibrium solve ladder --load 0 -1 0 | --wrench 0 -1 0
equilibrium solve ladder --gravity 9.81 | --weight 9.81
equilibrium solve ladder --fx 1 | --force F_X F_Y
equilibrium solve ladder --proof a.json | --certificate a.json
equilibrium solve ladder --tolerance 1 | equilibrium resisted ladder --tolerance Q
equilibrium friction ladder | equilibrium resisted ladder --friction NUMBER [NUMBER ...]
equilibrium margin ladder | equilibrium resisted ladder --margin
equilibrium limits ladder | equilibrium resisted ladder
equilibrium force-closure ladder | equilibrium info ladder --force-closure
equilibrium modes ladder | equilibrium info ladder --modes
equilibrium info ladder modes | equilibrium info ladder --modes
equilibrium robust ladder | equilibrium solve ladder --robust NAME=Q [NAME=Q ...]
equilibrium figure ladder | equilibrium draw ladder -o FILE.svg
equilibrium certificate ladder | equilibrium solve ladder --certificate OUT.json
equilibrium check a.json | equilibrium verify a.json
equilibrium convert a.csv -o a.json | equilibrium make csv a.csv -o a.json
equilibrium convert a.stl | equilibrium make mesh a.stl --friction Q --random 4
equilibrium make a.stl | equilibrium make mesh a.stl --friction Q --random 4
equilibrium make random 3 | equilibrium make random --contacts 3
equilibrium faces pencil | arrangement faces pencil
equilibrium run euler | proofs-check run euler
proofs-check euler | proofs-check run euler
proofs-check show euler | proofs-check list euler
proofs-check describe euler | proofs-check list euler
proofs-check verdicts | proofs-check run
proofs-check counterexample euler | proofs-check run euler --save FOLDER
proofs-check 'regions == m**2' | proofs-check try 'regions == m**2'
proofs-check reproduce | proofs-check paper -o FOLDER
proofs-check exercises | proofs-check grade FILE.py
proofs-check run --format html | -o html
proofs-check run --list | proofs-check list
proofs-check solve ladder | equilibrium solve ladder --weight 1
proofs-check extreme regions | proofs-check extreme regions --of DOMAIN --classes LOW..HIGH
"""


@pytest.mark.parametrize("guess", GUESSES.strip().splitlines())
def test_guess_is_answered_with_a_line_to_type(guess, tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    for name in ("a.csv", "a.json", "a.stl"):
        (tmp_path / name).touch()
    typed, answer = guess.split(" | ")
    program, *words = shlex.split(typed)
    with pytest.raises(SystemExit) as stopped:
        import_module(PROGRAMS[program]).main(words)
    assert stopped.value.code == 2
    head, *listed = capsys.readouterr().err.splitlines()
    written = re.search(r"; write (.*?)(, where:| \(see .*)$", head)
    first = written[1] if written else listed[0].strip()
    assert f"{first}  ".startswith(f"{answer}  ")
    program, *words = shlex.split(answer)
    if program in PROGRAMS and not re.search(r"\b[A-Z]+(_X)?\b|--(help|version)|>", answer):
        assert import_module(PROGRAMS[program])._parser().parse_args(words).command


@pytest.mark.parametrize("program", PROGRAMS)
def test_every_command_is_listed_for_a_word_that_means_nothing(program, capsys):
    with pytest.raises(SystemExit):
        import_module(PROGRAMS[program]).main(["xyzzy"])
    head, *listed = capsys.readouterr().err.splitlines()
    assert head.startswith("error: there is no command 'xyzzy'; expected one of these")
    parser = import_module(PROGRAMS[program])._parser()
    commands = sorted(row for rows in parser.headings.values() for row in rows)
    for (name, about), line in zip(commands, sorted(listed), strict=True):
        assert line.startswith(f"  {program} {name}")
        assert line.endswith(f"  {about}")


@pytest.mark.parametrize("name", FAMILIES)
def test_families_in_words_are_answered_with_commands_that_run(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    numbers = {"regular": "6", "simplicial": "6, 1"}.get(name, "4")
    refused, made, then = written_for(["faces", f"{name}({numbers})"], capsys)
    assert refused.startswith(f"error: '{name}(")
    then = then.replace("faces", "identify")
    if not re.search("[A-Z],?[A-Z]", made.replace("FILE", "")):  # such as EDGES
        assert arrangement_main(shlex.split(made)[1:]) == 0
        assert arrangement_main(shlex.split(then)[1:]) == 0


def written_for(words, capsys):
    """Return an error of the program arrangement with the two commands that it names."""
    with pytest.raises(SystemExit):
        arrangement_main(words)
    refused = capsys.readouterr().err
    made, then = re.findall("'(arrangement [^']*)'", refused)
    return refused, made, then


@pytest.mark.parametrize(
    ("words", "made", "then"),
    [
        ("count shi 3", "make shi --type 3", "count FILE.json"),
        ("coxeter B3", "make coxeter --type B3", "count FILE.json"),
        ("charpoly shi 3", "make shi --type 3", "count FILE.json"),
        ("count braid(5)", "make braid --n 5", "count FILE.json"),
        ("faces generic(5,2) --bounded", "make generic --m 5 --d 2", "faces FILE.json --bounded"),
        ("draw braid 3 -o b.svg", "make braid --n 3", "draw FILE.json -o b.svg"),
        ("count braid --n=4 --json", "make braid --n 4", "count FILE.json --json"),
        ("draw braid", "make braid --n 3", "draw FILE.json -o FILE.svg"),
    ],
)
def test_families_in_place_of_files_are_answered(words, made, then, capsys):
    expected = [f"arrangement {made} -o FILE.json", f"arrangement {then}"]
    assert list(written_for(words.split(), capsys)[1:]) == expected


GRASP, LOAD = read_grasp("paper-four-contacts-preload-1"), [0, "1/2", 0]


@pytest.mark.parametrize("subject", STATICS)
def test_words_of_statics_run(subject):
    pytest.importorskip("matplotlib")
    names = {name: getattr(equilibrium, name) for name in dir(equilibrium)}
    for name in STATICS[subject].values():
        run(name, **names, G=GRASP, w=LOAD, math=math)


@pytest.mark.parametrize(
    "value", [GRASP, solve(GRASP, LOAD), ResistedSet(GRASP)], ids=["G", "v", "R"]
)
def test_words_of_statics_are_answered(value):
    for word, name in NAMES.items():
        if word not in dir(value):
            with pytest.raises(AttributeError) as error:
                getattr(value, word)
            hint = str(error.value).partition("; use ")[2]
            assert name.endswith(hint or "nothing")


@pytest.mark.parametrize(
    ("values", "noun", "count"),
    [(LINES, "plane", 3), (LINES.regions(), "face", 7), (GRASP, "contact", 4)],
    ids=["planes", "faces", "contacts"],
)
def test_items_that_are_not_there(values, noun, count):
    assert [values[i] for i in range(-count, count)] == [*values, *values]
    for index in (count, -count - 1):
        with pytest.raises(IndexError, match=f"{noun} {index} does not exist; there are {count},"):
            values[index]
    with pytest.raises(TypeError, match=f"{noun}s are numbered from 0; 'x=0' is not such a number"):
        values["x=0"]


def test_tables_and_json_texts_are_answered():
    run(Grasp._synonyms["to_dataframe"], pandas=PANDAS, grasp=GRASP)
    verdict = solve(GRASP, LOAD)
    for name, value in [
        ("grasp", GRASP),
        ("grasp", Grasp),
        ("verdict", verdict),
        ("solution", verdict.solution),
        ("contact", GRASP[0]),
    ]:
        with pytest.raises(AttributeError) as error:
            value.to_json  # noqa: B018
        use = f"json.dumps({name}.to_dict())"
        assert str(error.value).endswith(f"'to_json'; use {use}")
        if not isinstance(value, type):
            run(use, json=json, **{name: value})


@pytest.mark.parametrize(
    ("value", "name", "use"),
    [
        (GRASP[0], "mu", "dataclasses.replace(contact, friction=...)"),
        (GRASP[0], "preload", "dataclasses.replace(contact, preload=...)"),
        (GRASP[0], "paint", ""),
        (GRASP, "friction", "grasp.with_friction(...)"),
        (GRASP, "contacts", "dataclasses.replace(grasp, contacts=...)"),
    ],
)
def test_assignments_are_answered(value, name, use):
    with pytest.raises(FrozenInstanceError) as error:
        setattr(value, name, 1)
    assert str(error.value).partition("; use ")[2] == use
    new = value.contacts if name == "contacts" else "1/3"
    if use:
        run(use.replace("...", "new"), dataclasses=dataclasses, contact=value, grasp=value, new=new)
    assert pickle.loads(pickle.dumps(value)) == copy.copy(value) == value


def test_other_errors_of_types_stay():
    with pytest.raises(TypeError, match="red is not painted"):
        Painted(color="red")
    with pytest.raises(TypeError, match=r"Painted has no argument size; use one of color$"):
        Painted(size=1)
    with pytest.raises(TypeError, match="takes 2 positional arguments"):
        solve(GRASP, LOAD, 1)
