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
from types import ModuleType, SimpleNamespace
from typing import ClassVar

import numpy as np
import pytest

import arrangement
import equilibrium
import proofs_check
from arrangement import Arrangement, Segments, families, synonyms
from arrangement.cli import main as arrangement_main
from arrangement.errors import InputError
from arrangement.hints import HintsMixin
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


def answer(owner: object, word: str) -> str:
    """Return what is to be written in place of an unknown name."""
    with pytest.raises(AttributeError) as error:
        getattr(owner, word)
    text = re.split(r" \((?:from|import) |, floats as |; \w+ has", str(error.value))[0]
    head, _, use = text.partition("; use ")
    assert head.endswith(f"has no attribute {word!r}")
    return use


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
        assert answer(planes, word) == name


@pytest.mark.parametrize("name", FAMILIES)
def test_families_are_found_by_their_names(name):
    word = name.replace("-", "_")
    for owner in (arrangement, Arrangement, LINES):
        use = answer(owner, word)
        assert use.startswith(f"arrangement.families.{word}("), f"{owner}: {use}"


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
    "id": "fukuda-bound-attained",
    "corners": [(0, 0), (4, 0), (0, 4)],
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
    usual = {arrangement: "lines.json", proofs_check: str(EXAMPLE)}.get(owner, "grasp.json")
    sources = {"source": solve(GRASP, LOAD).certificate}
    if owner is proofs_check:  # a package of the same name is there once it has been imported
        monkeypatch.delattr(proofs_check, "claims", raising=False)
    for word, use in table.items():
        assert answer(owner, word) == use
        path = "arch.json" if "assembly(path" in use else usual
        packages = {"arrangement": arrangement, "equilibrium": equilibrium}
        run(use.replace("[...]", "None"), **names | packages, path=path, **sources)


@pytest.mark.parametrize("kind", [Arrangement, Grasp, Contact])
def test_classes_answer_as_their_values_do(kind):
    for word, name in kind._synonyms.items():
        if word not in dir(kind):
            assert answer(kind, word) == name


def test_import_of_another_name_is_answered():
    with pytest.raises(
        ImportError, match=r"'diagonals'; use arrangement\.families\.diagonals\(n\) "
    ):
        from arrangement import diagonals  # noqa: F401
    with pytest.raises(ImportError, match=r"'read_csv'; use read_grasp\(path\) \(from"):
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
    with pytest.raises(
        TypeError, match=r"needs friction. Write Contact\(point, normal, friction\)"
    ):
        Contact([0, 0], [0, 1])
    with pytest.raises(TypeError, match=r"no argument hyperplanes. Write Arrangement\(normals\)"):
        Arrangement(hyperplanes=[[1, 0]])
    with pytest.raises(TypeError, match="has no argument normal; use normals"):
        Arrangement(normal=[[1, 0]])
    with pytest.raises(TypeError, match=r"claim has no argument domain. Write claim"):
        proofs_check.claim("regions > 2", domain="simple")
    with pytest.raises(TypeError, match=r"exercise has no argument marks; use points[.]"):
        proofs_check.exercise("How many?", marks=2)


def test_call_is_answered_with_what_was_typed():
    with pytest.raises(TypeError, match=r"no argument mu; use friction[.] Write Con") as error:
        Contact(np.array([0.1, 0]), normal=[1, 0], mu=0.4)
    use = str(error.value).partition("Write ")[2].partition("\n")[0]
    assert use == 'Contact(["0.1", "0.0"], normal=[1, 0], friction="0.4")'
    run(use, Contact=Contact)
    with pytest.raises(TypeError, match=r"Write Contact\(point, normal, friction\)"):
        Contact([Painted, 0], normal=[1, 0], mu=0.4)  # no numbers to write


def test_file_name_for_a_view_is_answered_with_all_faults():
    lines = Arrangement([[1, 0], [0, 1]], [0, 1])
    with pytest.raises(InputError, match=r"draw\(labels=True\)[.]write\('x[.]svg'\)$"):
        lines.draw("x.svg", labels=True)
    with pytest.raises(InputError, match=r"write\('x[.]svg'\); but .* no option fill; use colour"):
        lines.draw("x.svg", fill="bounded")
    with pytest.raises(InputError, match=r"pictures[.]write_drawing\([.]{3}, 'x[.]html'\)$"):
        lines.draw("x.html")


def test_unusual_calls_fail_as_in_plain_python():
    with pytest.raises(TypeError, match="missing 4 required positional arguments: 'self'"):
        Contact.__init__()
    with pytest.raises(AttributeError, match="has no attribute ''"):
        getattr(Contact, "")


@pytest.mark.parametrize("name", ["generic", "random_integer", "random_degenerate"])
def test_lines_in_general_position_are_affine(name):
    use = answer(Arrangement, name)
    assert use == f"arrangement.families.{name}(m, d, affine=True)"
    run(use, arrangement=arrangement, m=4, d=2)


@pytest.mark.parametrize("word", ARGUMENTS)
def test_another_word_for_an_argument_of_solve_is_answered(word):
    function = equilibrium.resisted_values if word == "parameter" else solve
    with pytest.raises(TypeError) as error:
        function(GRASP, **{word: 1})
    head, _, use = str(error.value).partition(". Write ")[0].partition("; use ")
    assert head == f"{function.__name__} has no argument {word}"
    name, _, value = use.partition("=")
    if name not in signature(function).parameters:
        run(use, grasp=GRASP, friction="1/2", preload=1)
    if value:
        names = dict(zip(("f_x", "f_y", "torque"), LOAD, strict=True))
        run(f"solve(GRASP, {name}={value})", solve=solve, GRASP=GRASP, **names)


@pytest.mark.parametrize("word", synonyms.FILES)
def test_another_word_for_a_file_is_answered(word):
    for read in (read_grasp, arrangement.read_arrangement, equilibrium.read_assembly):
        with pytest.raises(
            TypeError, match=f"{read.__name__} has no argument {word}; use source[.]"
        ):
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
        ("compute_regions", "regions()"),
        ("char_poly", "characteristic_polynomial()"),
        ("CHAMBERS", "chambers()"),
        ("N_CHAMBERS", "chambers()"),
        ("F_VECTOR", "f_vector"),
    ],
)
def test_variants_of_names_are_answered(name, use):
    assert answer(LINES, name) == use
    assert use.startswith(("A.", "len")) or hasattr(LINES, use.removesuffix("()"))


@pytest.mark.parametrize("name", ["cut", "decone", "xyzzy"])
def test_names_that_are_only_alike_are_not_suggested(name):
    assert answer(LINES, name) == ""


RESULT = proofs_check.evaluate(VALUES["claim"])
RESISTED = ResistedSet(VALUES["grasp"])
VERDICT = solve(VALUES["grasp"], VALUES["wrench"])
OWNERS = [
    *(LINES, LINES[:0], LINES.regions(), VALUES["r"], VALUES["S"], LINES.intersection_lattice()),
    *(VALUES["grasp"], VALUES["contact"], equilibrium.Assembly(["block"]), VERDICT, RESISTED),
    *(VERDICT.certificate, VERDICT.verify(), VERDICT.solution, RESISTED.along([0, 1, 0])),
    *(RESISTED.margin([0, 1, 0]), equilibrium.compare(VALUES["grasp"], VALUES["wrench"])),
    *(equilibrium.GraspWrenchSpace(VALUES["grasp"]), RESULT, RESULT.evidence, VALUES["claim"]),
    *(proofs_check.registry(), arrangement, equilibrium, proofs_check, families),
    *(arrangement.counts, arrangement.census, equilibrium.inputs),
]


@pytest.mark.parametrize("value", OWNERS, ids=lambda x: getattr(x, "__name__", type(x).__name__))
def test_unknown_names_are_answered_with_all_or_the_main_ones(value):
    for owner in (value, *[type(value)] * (not isinstance(value, ModuleType))):
        with pytest.raises(AttributeError) as error:
            owner.xyzzy  # noqa: B018
        name = getattr(owner, "__name__", type(owner).__name__).rpartition(".")[2]
        text = str(error.value).partition(f"; {name} has")[2]
        uses = re.findall(r"(?:[ :,] |^ |, )(\w+)(?=[,(\n]|$)", re.sub(r"\(.*?\)", "()", text))
        assert len(uses) > 1, error.value
        assert not [use for use in uses if use not in dir(owner) and use not in vars(value)]
        assert "xyzzy" not in text


@pytest.mark.parametrize(
    ("owner", "word", "use"),
    [
        (VALUES["grasp"], "along", "equilibrium.ResistedSet(grasp).along(direction)"),
        (Grasp, "margin", "equilibrium.ResistedSet(grasp).margin(wrench)"),
        (VALUES["grasp"], "epsilon", "equilibrium.GraspWrenchSpace(grasp).epsilon"),
        (VALUES["grasp"], "solve", "equilibrium.solve(grasp, wrench)"),
        (VALUES["grasp"], "points", "[x.point for x in grasp]"),
        (VALUES["grasp"], "mu", "[x.friction for x in grasp]"),
        (VERDICT, "motion", "verdict.solution.motion"),
        (VERDICT, "save", "verdict.certificate.save(path)"),
        (equilibrium, "stable", "equilibrium.solve(grasp, wrench).stable"),
        (equilibrium, "force_closure", "equilibrium.GraspWrenchSpace(grasp).force_closure"),
        (arrangement, "regions", "arrangement.read_arrangement(source).regions()"),
        (arrangement, "tutte_polynomial", "arrangement.counts.tutte_polynomial(arrangement)"),
        (LINES, "mobius", "arrangement.counts.moebius(A)"),
        (LINES.regions(), "volumes", "[x.volume for x in facesequence]"),
        (LINES.intersection_lattice(), "f_vector", "intersectionlattice.arrangement.f_vector"),
        (LINES.intersection_lattice(), "hasse", "lattice.arrangement.draw('lattice')"),
        (RESULT, "counterexample", "result.evidence.counterexample"),
        (proofs_check, "counterexample", "proofs_check.evaluate(claim).evidence.counterexample"),
        (VALUES["claim"], "verdict", "proofs_check.evaluate(claim).verdict"),
    ],
)
def test_names_of_results_and_of_the_package_are_found_and_run(owner, word, use, tmp_path):
    pytest.importorskip("matplotlib")
    assert answer(owner, word) == use
    names = VALUES | {"verdict": VERDICT, "result": RESULT, "path": str(tmp_path / "a.json")}
    names |= dict.fromkeys(["lattice", "intersectionlattice"], LINES.intersection_lattice())
    names |= {"facesequence": LINES.bounded_regions(), "source": "braid-a3"}
    packages = {"equilibrium": equilibrium, "proofs_check": proofs_check}
    if "(arrangement)" not in use:  # the letter of a value, as the package is called
        packages["arrangement"] = arrangement
    run(
        use.replace("arrangement.counts", "counts") if "(arr" in use else use,
        **names | packages,
        **{"counts": arrangement.counts} | ({"arrangement": LINES} if "(arr" in use else {}),
    )


def test_answers_are_made_when_they_are_read():
    with pytest.raises(AttributeError) as error:
        LINES.xyzzy  # noqa: B018
    assert pickle.loads(pickle.dumps(error.value)).args == (str(error.value),)


CALLS = [
    (Contact, (), {"mu": 1}),
    (Contact, ([0, 0], [0, 1]), {}),
    (Grasp, (), {"points": [[0, 0]]}),
    (equilibrium.Mesh, ("part.stl",), {}),
    (LINES.faces, (), {"dim": 1}),
    (LINES.region_at, (0, 0), {}),
    (LINES.lab, ("page.html",), {}),
    (LINES.to_polymake, ("a.hyar",), {}),
    (LINES.characteristic_polynomial, (5,), {}),
    (LINES.draw, ("lines", [0, 1, 0]), {}),
    (Arrangement.from_equations, (), {"text": "x = 0"}),
    (VALUES["grasp"].with_friction, (), {}),
    (RESISTED.along, (), {"wrench": [0, 1, 0]}),
    (arrangement.pictures.draw_lines, (LINES,), {"figsize": 3}),
    (equilibrium.check_grasps, ([[0, 0]], [[0, 1]]), {}),
    (equilibrium.inputs.from_float_data, ([[0, 0]], [[0, 1]]), {"mu": 0.5}),
    (proofs_check.evaluate, (VALUES["claim"],), {"samples": 3}),
]


@pytest.mark.parametrize(
    ("function", "values", "options"), CALLS, ids=lambda x: getattr(x, "__name__", "")
)
def test_calls_that_do_not_fit_are_answered_with_one_that_does(function, values, options):
    pytest.importorskip("matplotlib")
    with pytest.raises(TypeError) as error:
        function(*values, **options)
    text = str(error.value)
    name, needed = re.findall(r"\. Write (\w+)\((.*?)\)", text)[0]
    assert name == function.__name__
    given = [x for x in needed.split(", ") if x]
    signature(function).bind(*given)
    rows = re.findall(r"^ {4}(\w+)", text, re.MULTILINE)
    assert rows == [*signature(function).parameters]
    assert all(word in text for word in options)


def test_signatures_of_classes_are_those_of_their_values():
    assert [*signature(Contact).parameters][:3] == ["point", "normal", "friction"]
    assert [*signature(Grasp).parameters] == ["contacts", "units", "outline", "data_error"]


def test_words_for_options_of_views_are_answered_at_once(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    with pytest.raises(arrangement.InputError) as error:
        LINES.draw(xlim=(0, 1), ylim=(0, 1), colour="sides")
    head, *rows = str(error.value).splitlines()
    assert head == "the view lines has no option xlim, ylim; use window. It has"
    assert [row.partition(":")[0].strip() for row in rows][:2] == ["projective", "faces"]
    with pytest.raises(arrangement.InputError) as error:
        LINES.draw(title="T", cmap="viridis")
    use, colour = re.findall(r"title, cmap; use (.*) and (colour='.*') \(", str(error.value))[0]
    names = {"LINES": LINES, "TITLE": "Lines", "FILE": "lines.svg"}
    monkeypatch.chdir(tmp_path)
    exec(use.replace("draw(...)", f"LINES.draw({colour})"), names)  # noqa: S102
    assert "Lines" in Path("lines.svg").read_text()
    with pytest.raises(arrangement.InputError, match="window is 2; give a sequence of two corners"):
        LINES.draw(window=2)
    for view in (3, [0, 1, 0], LINES):
        with pytest.raises(arrangement.InputError, match=r"the view is .*; expected one of sphere"):
            LINES.draw(view)


def test_file_names_in_place_of_views_are_answered(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(arrangement.InputError, match=r"the view is 'a.svg'; write ") as error:
        LINES.draw("a.svg", labels="none")
    use = str(error.value).partition("; write ")[2]
    assert use == "draw(labels='none').write('a.svg')"
    run(f"A.{use}", A=LINES)
    assert Path("a.svg").exists()
    with pytest.raises(AttributeError, match="has no window"):
        LINES.draw().show()


def test_texts_and_arrays_in_place_of_values_are_answered():
    remedy = r"write read_grasp\('paper-three-contacts'\)"
    with pytest.raises(equilibrium.GraspError, match=remedy):
        Grasp("paper-three-contacts")
    with pytest.raises(equilibrium.GraspError, match=r"inputs.from_float_data"):
        Grasp([[0, 0], [1, 0]])
    for read in (read_grasp, arrangement.read_arrangement):
        with pytest.raises(arrangement.InputError, match=r"from_float_data.* take arrays"):
            read(np.zeros((2, 2)))
    with pytest.raises(
        arrangement.InputError, match=r"friction is the float 0.5, .*from_float_data"
    ):
        Contact([0, 0], [0, 1], 0.5)
    with pytest.raises(arrangement.InputError, match=r"; give vectors .*read_arrangement\(path\)"):
        Arrangement("lines.csv")
    with pytest.raises(arrangement.InputError, match=r"normal 1 is 1; .* \[\[1, 0\], \[0, 1\]\]"):
        Arrangement([1, 0], [0, 1])
    assert Arrangement.from_equations("x = 0, y = 1") == Arrangement([[1, 0], [0, 1]], [0, 1])


def test_results_show_their_verdict():
    assert repr(RESULT).startswith("<Result: verdict holds, tried ")
    with pytest.raises(proofs_check.ClaimError, match="no claim has the id '0'"):
        proofs_check.registry()[0]


def test_names_for_pictures_run(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    drawing = LINES.draw()
    for value in (LINES, VALUES["S"], VALUES["grasp"], drawing):
        for word in {**synonyms.PICTURES, **synonyms.PAGES}.keys() & value._synonyms.keys():
            if word not in dir(value):
                assert answer(value, word) == value._synonyms[word]
    for use in {*drawing._synonyms.values()} | {*synonyms.PICTURES.values()}:
        owner = "drawing" if use.startswith("write") else "A"
        run(f"{owner}.{use}", A=LINES, drawing=drawing, path="p.svg")
    for value in (LINES, VALUES["grasp"]):
        run("A.lab()", A=value)
        assert {*synonyms.PAGES.values()} == {"lab()"}


def test_names_for_grasps_run():
    pytest.importorskip("matplotlib")
    names = {name: getattr(equilibrium, name) for name in dir(equilibrium)}
    data = {"points": [[0.5, 0], [-0.5, 0]], "normals": [[-1, 0], [1, 0]], "friction": "1/2"}
    made = {"vertices": [[0, 0], [4, 0], [0, 3]], "places": [[0, 1]]}
    made |= {"contacts": [1], "wrench": VALUES["wrench"], "grasp": VALUES["grasp"]}
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
arrangement draw pencil --format tikz | -o FILE.tex
arrangement draw pencil --format= | arrangement convert pencil --to FORMAT
arrangement quiz | arrangement lab -o PAGE.html
arrangement count --lines 5 | arrangement make generic --m 5 --d 2 --affine -o FILE.json
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
arrangement count help help | arrangement count FILE -h
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
proofs-check run --format html | -o FILE
arrangement random --lines 5 | arrangement make random-integer --m 3
equilibrium examples | equilibrium list
proofs-check verify --verbose | proofs-check run
proofs-check try 'regions == m**2' --simple | --of simple
proofs-check try 'regions == m**2' -x | --strict
proofs-check try 'regions == m**2' --lines | --of lines
proofs-check list --refuted | proofs-check run
equilibrium resisted ladder --wrench 0 0 -1 0 0 0 --on-body 1 | --on BODY F_X F_Y TAU
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
        (
            "faces generic(5,2) --bounded",
            "make generic --m 5 --d 2 --affine",
            "faces FILE.json --bounded",
        ),
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
            assert name.endswith(answer(value, word) or "nothing")


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
    with pytest.raises(
        TypeError, match=r"Painted has no argument size. Write Painted\(color\)\n    color$"
    ):
        Painted(size=1)
    with pytest.raises(TypeError, match="solve got too many positional arguments"):
        solve(GRASP, LOAD, 1)
