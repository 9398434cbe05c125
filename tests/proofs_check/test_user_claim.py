"""Claims of a user's file: what is checked, how failures shrink, what is saved."""

import json
import re
import sys
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from random import Random
from types import ModuleType

import pytest
from hypothesis import assume, given, strategies as st

from arrangement import Arrangement, read_arrangement
from arrangement.console import progress
from arrangement.library.census import census, identify
from equilibrium.grasps.inputs.documents import read_grasp
from proofs_check import ClaimError, ClaimVerdict, claim, evaluate
from proofs_check.cli.program import EXAMPLES
from proofs_check.instances.arrangements import line_cases
from proofs_check.instances.domains import DOMAINS, domain, known_families, size
from proofs_check.own_claims.claim_file import _FolderFinder, load
from proofs_check.own_claims.language import read
from proofs_check.own_claims.one_line import formula_of, one_line_claim
from proofs_check.own_claims.shrink import shrink

HEAD = "from proofs_check import claim\n"
SAVE = ["--save", "counterexamples"]


@pytest.fixture
def write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], str]:
    monkeypatch.chdir(tmp_path)

    def writer(body: str) -> str:
        path = tmp_path / "mine.py"
        path.write_text(HEAD + body, encoding="utf-8")
        return str(path)

    return writer


def triangles(planes: Arrangement) -> int:
    """Regions with three facets, counted on the faces themselves."""
    facets = [face.signs for face in planes.faces(2)]
    sides = (
        sum(all(a in (0, b) for a, b in zip(f, r.signs, strict=True)) for f in facets)
        for r in planes.regions()
    )
    return sum(number == 3 for number in sides)


@pytest.mark.slow
def test_documented_example_finds_counterexample(tmp_path, run):
    example = files("proofs_check.examples") / "triangles.py"
    found = run.json("run {} --save", example, tmp_path)
    assert [r["verdict"] for r in found["results"]] == ["refuted", "holds"]
    planes = read_arrangement(str(tmp_path / "twice-as-many-triangles.json"))
    assert planes.is_simple
    assert triangles(planes) != 2 * len(planes)
    # All types in general position with fewer planes have twice as many triangles.
    assert all(triangles(p) == 2 * m for m in (4, 5) for p in census(m, simple=True))
    assert len(planes) == 6
    assert not (tmp_path / "at-least-twice-as-many-triangles.json").exists()


def test_false_claim_refuted_by_smallest_instance(write, tmp_path, run):
    path = write(
        '@claim("No two planes coincide.", of="central")\n'
        "def different(planes):\n"
        '    return len(planes.distinct) == len(planes) or "two coincide"\n'
    )
    run("run", path, code=1)
    assert [file.name for file in tmp_path.iterdir()] == ["mine.py"]
    out = run("run", path, *SAVE, code=1)
    assert re.search("verdict +refuted\n", out)
    saved = tmp_path / "counterexamples" / "different.json"
    assert str(saved.relative_to(tmp_path)) in out
    planes = read_arrangement(str(saved))
    first, second = planes.integer_planes
    assert first == second
    assert sorted(first) == [0, 0, 0, 1]
    assert "two coincide" in json.loads(saved.read_text(encoding="utf-8"))["description"]


def test_a_wrong_claim_on_grasps_is_saved_as_a_grasp_file(write, tmp_path, run):
    path = write(
        '@claim("Preloads are at most 1.", of="grasp", samples=60)\n'
        "def small_preload(grasp):\n"
        '    return all(c.preload <= 1 for c in grasp) or "a large preload"\n'
    )
    run("run", path, *SAVE, code=1)
    grasp = read_grasp(str(tmp_path / "counterexamples" / "small-preload.json"))
    (contact,) = grasp
    assert contact.point == (0, 0)
    assert (contact.friction, contact.stiffness, contact.preload) == (0, 1, 2)


def test_failure_of_many_planes_stays_large(write, tmp_path, run):
    path = write(
        '@claim("At most 12 regions.", of="distinct", classes=5, samples=20)\n'
        "def few(planes):\n"
        '    return planes.f_vector[3] <= 12 or "more"\n'
    )
    run("run", path, *SAVE, code=1)
    found = read_arrangement(str(tmp_path / "counterexamples" / "few.json"))
    least = min(m for m in range(3, 6) for p in census(m) if p.f_vector[3] > 12)
    assert len(found) == least
    assert found.f_vector[3] > 12


def test_an_error_in_the_function_gives_no_verdict(write, run):
    path = write('@claim("s", samples=5)\ndef f(p): return 1 // (len(p) - 4) < 9\n')
    (result,) = run.json("run", path, code=3)["results"]
    assert result["verdict"] is None
    assert "ZeroDivisionError" in result["counterexample"]["note"]


def test_instances_outside_hypothesis_skipped_and_counted():
    @claim("s", when=lambda p: p.is_simple, classes=5, families=False, samples=0)
    def all_simple(planes):
        return planes.is_simple

    result = evaluate(all_simple)
    assert result.verdict is ClaimVerdict.HOLDS
    (part,) = result.evidence.parts
    assert (part.checked, part.passed_over) == (3, 4)

    @claim("s", when=lambda p: False, samples=3)
    def nothing(_planes):
        return True

    assert evaluate(nothing).verdict is None


def test_a_claim_that_is_checked_on_nothing_has_no_verdict(write, run):
    path = write('@claim("s", classes=0, families=False, samples=0)\ndef f(p): return True\n')
    (result,) = run.json("run", path, code=3)["results"]
    assert (result["verdict"], result["evidence"]) == (None, "no case was checked")


def test_seed_determines_the_instances():
    @claim("s", of="central", classes=0, families=False, samples=20)
    def small(planes):
        return max(abs(x) for p in planes.integer_planes for x in p) < 9

    one, same = evaluate(small, 1), evaluate(small, 1)
    assert (one.evidence, one.verdict) == (same.evidence, same.verdict)
    drawn = [[small.draw(seed, k, (3, 8)) for k in range(20)] for seed in (1, 1, 2)]
    assert drawn[0] == drawn[1] != drawn[2]


def _many(planes: Arrangement) -> bool:
    return len(planes.distinct) >= 3 and planes.rank == 3


@given(st.integers(0, 10**9))
def test_shrinking_is_minimal_and_keeps_the_failure(seed):
    planes = DOMAINS["rank-3"].draw(Random(seed), 5)
    found, _ = shrink(planes, _many)
    assert _many(found)
    assert len(found) == 3
    assert size(found) <= size(planes)
    assert max(abs(x) for p in found.integer_planes for x in p) == 1


@given(st.integers(0, 10**9))
def test_shrinking_a_grasp_keeps_the_failure(seed):
    grasp = DOMAINS["grasp"].draw(Random(seed), 4)

    def fails(candidate):
        return any(c.friction > 0 for c in candidate)

    assume(fails(grasp))
    found, _ = shrink(grasp, fails)
    assert fails(found)
    assert len(found) == 1
    assert found.contacts[0].point == (0, 0)


def test_shrinking_stops_at_the_limit():
    planes = DOMAINS["simple"].draw(Random(1), 7)
    assert shrink(planes, lambda _: True, tries=3)[1] == 3


@pytest.mark.parametrize("name", sorted(DOMAINS))
def test_what_a_domain_draws_belongs_to_it(name):
    chosen = domain(name)
    for m in range(chosen.least, 7):
        for seed in range(4):
            subject = chosen.draw(Random(seed), m)
            assert chosen.contains(subject)
            assert subject == chosen.draw(Random(seed), m)
    assert all(chosen.contains(case.subject) for case in known_families(chosen))


def test_a_new_file_runs_and_is_never_written_over(tmp_path, monkeypatch, run, refused):
    monkeypatch.chdir(tmp_path)
    assert "proofs-check run 'my paper.py'" in run("new", "my paper")
    text = Path("my paper.py").read_text(encoding="utf-8")
    assert "proofs-check run my paper.py" in text
    found = run.json("run {} --classes 3..4", "my paper.py")
    assert [r["verdict"] for r in found["results"]] == ["holds", "holds", "refuted"]
    assert found["title"] == "Claims of my own"
    assert found["command"].startswith("proofs-check run 'my paper.py'")
    Path("my paper.py").write_text("mine\n", encoding="utf-8")
    assert "is there already" in refused("new", "my paper.py")
    assert Path("my paper.py").read_text(encoding="utf-8") == "mine\n"


@pytest.mark.parametrize(
    ("name", "verdicts"),
    [
        ("most_triangles", ["holds", "refuted"]),
        ("regions_of_families", ["holds", "holds"]),
        ("two_fingers", ["holds", "refuted"]),
    ],
)
def test_claims_of_other_papers_have_their_verdicts(name, verdicts, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    example = files("proofs_check.examples") / f"{name}.py"
    run("report {} -o r.json --samples 50", example)
    found = json.loads(Path("r.json").read_text(encoding="utf-8"))
    assert [r["verdict"] for r in found["results"]] == verdicts
    assert len(found["results"][0]["routes"]) == 2
    for case in (case for r in found["results"] for case in r["records"] if len(r["routes"]) > 1):
        assert case["values"][0] == case["values"][1]
        assert case["values"][0] is not None


@pytest.mark.parametrize(
    ("name", "verdicts"), [("gaps", ["refuted"]), ("survey", ["holds", "refuted"])]
)
def test_examples_are_written_and_run(name, verdicts, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    assert "proofs-check run mine.py" in run("new mine --example", name)
    found = run.json("run mine.py --samples 30")
    assert [r["verdict"] for r in found["results"]] == verdicts


def test_every_example_can_be_written():
    folder = files("proofs_check.examples").iterdir()
    assert {*EXAMPLES} == {x.name[:-3] for x in folder if x.name.endswith(".py")} - {"__init__"}


def test_disagreeing_implementations_give_no_verdict(write, run):
    path = write(
        "from arrangement.library.families import generic\n"
        "listed = {'three': generic(3), 'four': generic(4)}\n"
        "def other(p):\n"
        "    return 3 + len(p) // 4 * 2\n"
        '@claim("differ", of=listed, routes=[len, other])\n'
        "def differ(p, m): return m < 9\n"
        "def fails(p):\n"
        "    return len(p) // (len(p) % 2)\n"
        '@claim("raises", of=listed, routes=[len, fails])\n'
        "def raises(p, m): return m < 9\n"
    )
    out = " ".join(run("run", path, code=3).split())
    assert out.count("verdict no verdict evidence") == 2
    assert "the implementations disagree on four, planes (1,1,1)" in out
    assert ": 4 and 5" in out
    assert "the 2 given instances" in out
    assert "ZeroDivisionError: integer division or modulo by zero (mine.py, line 9: return" in out


@pytest.mark.parametrize(
    ("returned", "text"),
    [
        ("len(p) + 0 == 5", "len(p) + 0 == 5 is false: 3 and 5"),
        ("p.rank == 3 and len(p) > 3", "len(p) > 3 is false: 3 and 3"),
        ("len(p) in (1, 2)", "len(p) in (1, 2) is false: 3 and (1, 2)"),
        ("not p", "the function returned False"),
        ("all(x > 3 for x in (1, 2))", "the function returned False"),
        ("len(p) == 4 or 'a reason'", "a reason"),
    ],
)
def test_a_false_comparison_shows_both_sides(write, run, returned, text):
    path = write(f'@claim("s", classes=3, samples=0)\ndef f(p):\n    return {returned}\n')
    (result,) = run.json("run", path, code=1)["results"]
    assert result["verdict"] == "refuted"
    assert result["counterexample"]["note"] == text


def test_comparisons_outside_of_claims_stay_what_they_are(write, run):
    path = write(
        "def small(p):\n    return len(p) < 3\n"
        '@claim("s", classes=3, samples=0, families=False)\n'
        "def f(p):\n"
        "    def inner():\n        return len(p) < 3\n"
        "    return small(p) is False and type(inner()) is bool\n"
    )
    run("run", path)


def test_a_long_case_shows_the_loops_inside(write, monkeypatch, run):
    monkeypatch.setattr(progress, "_FIRST", 0.0)
    path = write(
        "from arrangement.console.progress import note, watched\n"
        '@claim("s", of=[1])\n'
        "def f(_):\n"
        "    note('not for every case')\n"
        "    return len(list(watched(range(5), 'things'))) == 5\n"
    )
    run("run", path)
    err = run.err
    assert "1/5 things" in err
    assert "not for every case" not in err


def claim_in(folder: Path, helper: str) -> str:
    """Write a claim that takes its answer from a file beside it."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "helper.py").write_text(helper, encoding="utf-8")
    (folder / "parts").mkdir(exist_ok=True)
    (folder / "parts" / "inner.py").write_text("from helper import ANSWER\n", encoding="utf-8")
    body = 'from parts.inner import ANSWER\n@claim("s", samples=1)\ndef f(p): return ANSWER\n'
    path = folder / "mine.py"
    path.write_text(HEAD + body, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_each_file_imports_its_own_neighbours(order, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "helper", helper := ModuleType("helper"))
    answers = ("ANSWER = True\n", "ANSWER = 'no'\n")
    paths = [claim_in(tmp_path / str(k), answers[k]) for k in order]
    verdicts = [evaluate(load(path)["f"]).verdict.value for path in paths]
    assert verdicts == [("holds", "refuted")[k] for k in order]
    assert sys.modules["helper"] is helper
    assert not any(name.partition(".")[0] == "parts" for name in sys.modules)
    claim_in(tmp_path / "0", answers[1])
    assert evaluate(load(paths[order.index(0)])["f"]).verdict is ClaimVerdict.REFUTED


def test_own_packages_are_never_taken_from_a_folder():
    finder = _FolderFinder(Path(__file__).parents[2])
    assert finder.find_spec("tests", None) is not None
    for name in ("arrangement", "equilibrium", "proofs_check"):
        assert finder.find_spec(name, None) is None


def test_integers_of_libraries_are_integers(write, run):
    path = write(
        "import numpy, sympy\n"
        "def a(p): return numpy.int64(len(p))\n"
        "def b(p): return sympy.Integer(len(p))\n"
        '@claim("s", routes=[a, b], classes=3, samples=0, families=False)\n'
        "def f(p, m): return type(m) is int\n"
    )
    run("run", path)


@pytest.mark.parametrize(
    ("statement", "options", "code"),
    [
        ("p_vector.get(3, 0) >= m", ["--of", "simple", "--when", "m >= 4"], 0),
        ("p_vector.get(3, 0) == m", ["--of", "simple", "--when", "m >= 4"], 1),
        ("(-1) ** 3 * chi(-1) == regions and m < 99", [], 0),
        ("sum(p_vector.values()) == regions", [], 0),
        ("f_vector[3] - f_vector[2] + f_vector[1] - f_vector[0] == 1", ["--of", "central"], 0),
        ("not simple or regions == 2 + 2 * comb(m, 2) // 1", [], 0),
        ("not simple or t_vector == p_vector or len(t_vector) == 1", [], 0),
        ("max(t_vector.keys()) <= m - 1 < regions / 2", [], 0),
        ("bounded_regions % 2 == 0", ["--of", "simple-affine(d=3)"], 1),
        ("bounded_regions == comb(m - 1, 2)", ["--of", "simple-affine(d=2)"], 0),
        ("sum(bounded_p_vector.values()) == bounded_regions", ["--of", "affine(d=2)"], 0),
        ("bounded_p_vector.get(3, 0) >= m - 1", ["--of", "simple-affine(d=2)"], 1),
        ("bounded_p_vector.get(3, 0) <= m * (m - 2) // 3", ["--of", "lines"], 0),  # Kobon
        ("bounded_p_vector.get(3, 0) >= m - 2", ["--of", "simple-lines"], 0),  # Roberts
        ("relatively_bounded_regions == comb(m - 1, 2)", ["--of", "simple-lines"], 0),
        ("bounded_regions == comb(m - 1, 2)", ["--of", "lines"], 1),
        ("tutte(2, 0) == regions and tutte(0, 0) == relatively_bounded_regions", [], 0),
        ("sum(nbc_sets) == regions and nbc_sets[1] == m", ["--of", "affine(d=2)"], 0),
        ("points_off(211) == chi(211)", ["--of", "generic(m=3..6)"], 0),
        ("points_off(211) == chi(211)", ["--of", "distinct"], 1),
        ("points_off(2) == chi(2)", ["--of", "distinct"], 1),
        ("sum(level_vector.values()) == regions", ["--of", "affine(d=3)"], 0),
        ("level_vector.get(0, 0) == bounded_regions", ["--of", "lines"], 0),
        ("level_vector[3] == regions and polynomial[0] == 1", ["--of", "pseudolines"], 0),
        ("rank == 3 and central and min(f_vector) != abs(-1)", [], 1),
    ],
)
def test_a_claim_in_one_line_has_its_verdict(statement, options, code, write, run):
    numbers = ["--classes", "3..5", "--samples", "6"]
    found = run.json("try", statement, *options, *numbers, *SAVE, code=code)["results"][0]
    assert found["verdict"] == ("refuted" if code else "holds")
    finite = (
        "holds in all cases" if found["over"].endswith("members") else "no counterexample found"
    )
    assert found["strength"] == ("refuted" if code else finite)
    assert (Path("counterexamples") / "try.json").exists() == bool(code)
    assert not code or "is false" in found["counterexample"]["note"]


def test_zero_bounded_regions_are_explained(write, run):
    options = ["--of", "linial(n=3..4)", "--json"]
    run("try", "relatively_bounded_regions >= 1", *options)
    path = write(
        '@claim("s", of="linial(n=3..4)")\ndef f(p):\n    return len(p.bounded_regions()) == 1\n'
    )
    for words in (["try", "bounded_regions == 1", *options], ["run", path, "--json"]):
        note = json.loads(run(*words, code=1))["results"][0]["counterexample"]["note"]
        assert "is false: 0 and 1 (every region contains a line, as the normals span 2 of 3" in note
        assert "relatively_bounded_regions" in note


def test_lines_are_tried_on_every_type():
    found = [case.subject for case in line_cases(range(3, 6))]
    assert {lines.dimension for lines in found} == {2}
    five = (lines for lines in found if len(lines) == 5 and not lines.is_central)
    simple = [lines for lines in five if lines.is_simple]
    assert len({identify(lines).label for lines in simple}) == 6
    triangles = [lines.bounded_p_vector[3] for lines in simple]
    assert (min(triangles), max(triangles)) == (3, 5)  # Roberts, and Kobon


def test_one_claim_named_and_failing_one_keeps_others(write, run, refused):
    head = '@claim("?", of="simple", samples=2, classes=3'
    body = (
        f"{head})\ndef nothing(p): return None\n{head})\ndef good(p): return len(p) > 0\n"
        f"{head}, when=lambda p: p.none)\ndef vain(p): return True\n"
    )
    path = write(body)
    assert "verdict    no counterexample found (" in run("run", path, code=2)
    assert "nothing: no verdict: nothing returned None" in run.err
    assert "vain: no verdict: the hypothesis" in run.err
    assert run.err.endswith("error: 2 of 3 claims have no verdict\n")
    assert [one["id"] for one in run.json("run", f"{path}:good")["results"]] == ["good"]
    run("list", f"{path}:good")
    run("list {} --json", path)
    assert "good" in run("report", path, code=2)
    assert run.err.endswith("error: 2 of 3 claims have no verdict\n")
    assert run("report", f"{path}:good").count("no counterexample found (") == 2
    for words, message in {
        ("run", f"{path}:nothing"): "error: nothing returned None",
        ("report", f"{path}:nothing"): "error: nothing returned None",
        ("run", f"{path}:god"): "did you mean good?",
        ("list", "good"): "no claim has the id 'good'",
    }.items():
        assert message in refused(*words)


@pytest.mark.parametrize(
    ("text", "formula"),
    [
        ("p_vector.get(3, 0) >= m", r"p_{3} \ge m"),
        ("regions == (n + 1)**(n - 1)", r"\text{regions} = (n + 1)^{n - 1}"),
        ("m - (n - 1) - 2 < -m * (-2)", r"m - (n - 1) - 2 \lt (-m) \cdot (-2)"),
        ("m * (n + 1) / 2 != m // 2", r"\frac{m \cdot (n + 1)}{2} \ne \lfloor \frac{m}{2} \rfloor"),
        ("(m**2)**3 > m**2**3", r"(m^{2})^{3} \gt m^{2^{3}}"),
        ("tutte(2, 0) == regions", r"T(2, 0) = \text{regions}"),
        ("abs(chi(-1)) == comb(m, 2)", r"|\chi(-1)| = \binom{m}{2}"),
        ("(m < 3 or simple) and not m % 2 == 0", r"(m \lt 3\; \text{or} \;\text{simple})"
         r"\; \text{and} \;\neg (m\; \text{mod} \;2 = 0)"),
        ("m < 3 or (m < 4 or simple)",
         r"m \lt 3\; \text{or} \;(m \lt 4\; \text{or} \;\text{simple})"),
        ("max(f_vector[1], m) <= 7", r"\max(f_{1}, m) \le 7"),
        ("simple implies binomial(m, 2) < factorial(n)",
         r"\text{simple} \Rightarrow \binom{m}{2} \lt (n)!"),
        ("sum(p_vector.values()) == regions", ""),
        ("p_vector.get(3, 1) == 4", ""),
        ("+".join(["m"] * 200) + ">0", ""),
    ],
)  # fmt: skip
def test_a_claim_in_one_line_has_its_formula_where_there_is_one(text, formula):
    assert formula_of(read(text, ["n"])) == formula
    if "n" not in text:
        assert one_line_claim(text).formula == formula


def test_claim_without_a_statement_is_refused():
    with pytest.raises(ClaimError, match="needs a statement in words, as its first argument"):
        claim(of="lines")(lambda planes: True)
