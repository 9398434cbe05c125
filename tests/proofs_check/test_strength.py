"""Words as strong as the evidence: proved, all cases, no counterexample found, refuted."""

import os
import re
from collections import Counter
from dataclasses import replace
from itertools import product
from pathlib import Path

import pytest

from proofs_check import Kind, Source, claim, evaluate, registry
from proofs_check.instances.domains import domain, known_families
from proofs_check.own_claims.one_line import one_line_claim
from proofs_check.reports import report, text
from proofs_check.statements.evidence import strength_from
from proofs_check.statements.statement import ClaimVerdict, Strength

FEW = ["--classes", "3..4", "--samples", "4"]
SIMPLE_TRIANGLES = ["try", "p_vector.get(3, 0) <= 4*m", "--of", "simple"]


def test_strength_is_that_of_the_weakest_evidence():
    for verdict, kind in product((None, *ClaimVerdict), Kind):
        found = strength_from(verdict, kind)
        if verdict in (None, ClaimVerdict.REFUTED):
            assert found is (Strength.REFUTED if verdict else None)
        else:
            assert (found is Strength.PROVED) == (kind is Kind.PROVED)
            assert (found is Strength.SAMPLED) == (kind is Kind.SAMPLED)


def test_registry_has_17_proofs_13_enumerations_and_12_samples():
    kinds = {kind: Counter[Strength]() for kind in ClaimVerdict}
    for entry in registry():
        kinds[entry.expected][strength_from(entry.expected, entry.kind)] += 1
    assert [kinds[ClaimVerdict.HOLDS][strength] for strength in Strength] == [17, 13, 12, 0]
    added = kinds[ClaimVerdict.HOLDS_UNDER_HYPOTHESIS]
    assert [added[strength] for strength in Strength] == [7, 1, 1, 0]
    assert kinds[ClaimVerdict.REFUTED] == {Strength.REFUTED: 18}
    # Pages that count claims say whether the one that takes minutes is among them.
    (large,) = (entry for entry in registry() if entry.large)
    assert (large.expected, large.kind) == (ClaimVerdict.HOLDS, Kind.EXHAUSTIVE)
    docs = Path(__file__).parents[2] / "docs"
    pages = [docs / "checking.rst", docs / "lessons/10-paper-and-truth.rst"]
    checking, lesson = (" ".join(page.read_text(encoding="utf-8").split()) for page in pages)
    assert (
        "68 claims that `make verify` checks, 41 stand as they are: 17 are proved, 12 hold in all "
        "cases, and for 12 no counterexample was found. Nine need a hypothesis (7, 1 and 1), and "
        "18 are refuted." in checking
    )
    assert "of all 69 claims, 42 stand as they are, 13 of them in all cases" in checking
    assert "So of all 69 claims, 42 stand as they are: 17 are proved and 13 hold" in lesson
    assert "other 68 claims, 41 stand as they are." in lesson


@pytest.mark.parametrize(
    ("id", "words"),
    [
        ("fukuda-bound-attained", "proved"),
        ("step-1-square-bound", "proved under the hypothesis m >= 2"),
        ("table-three-contacts", "holds in all cases"),
        (
            "table-four-contacts",
            "holds in all cases under the hypothesis (0,0.0.25,-0.25) is a misprint of "
            "(0,0.25,-0.25)",
        ),
        ("method-linear-compliance", "no counterexample found (3 tried)"),
        (
            "method-cones-only",
            "no counterexample found (6 tried) under the hypothesis friction is above 1",
        ),
        ("single-solution", "refuted"),
    ],
)
def test_a_verdict_is_in_the_four_words(id, words):
    result = evaluate(registry()[id])
    record = report.result_record(result)
    assert text.conclusion(record) == words
    assert result.strength is Strength(record["strength"])
    # A record of an earlier release has none of the new fields and means the same.
    old = {k: v for k, v in record.items() if k not in ("strength", "tried", "added_hypotheses")}
    assert text.conclusion(old) == words


def test_numbers_of_verdicts_agree_with_their_verbs():
    cases = {"verdict": ClaimVerdict.HOLDS.value, "evidence_kind": Kind.EXHAUSTIVE.value}
    assert text.counts_by_strength([cases]) == [(1, "holds in all cases")]
    assert text.counts_by_strength([cases] * 3) == [(3, "hold in all cases")]


def test_evidence_from_samples_says_nowhere_that_a_claim_holds():
    for claim_of_paper in registry():
        if claim_of_paper.kind is Kind.SAMPLED and claim_of_paper.hypothesis:
            found = report.evidence_text(evaluate(claim_of_paper))
            assert "; no counterexample found when friction is above 1; counterexample" in found
            assert "holds" not in found


@pytest.mark.parametrize("options", [[], ["--of", "lines"]])
def test_no_verdict_is_undecided_and_not_no(options, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    outside = ["regions <= 8", "--when", "m == 100", *FEW, *options]
    printed = run("try", *outside, "-o", "r.json", code=3)
    assert "verdict     no verdict\n  evidence    no case was checked" in printed
    run("report r.json", code=3)
    Path("mine.py").write_text(
        "from proofs_check import claim\n"
        "@claim('s', of=[1], when=lambda x: False)\ndef empty(x):\n    return True\n"
        "@claim('s', of=[1])\ndef wrong(x):\n    return x == 2\n"
    )
    run("run mine.py:empty", code=3)
    run("run mine.py", code=1)


def test_words_of_a_claim_in_one_line_fit_it(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    # Lines are as wide as the terminal.
    out = " ".join(run("try {} --classes 3 --samples 0 -o r.md", "m < 3", code=1).split())
    assert "the one case: one arrangement of every isomorphism class of 3 planes evidence" in out
    assert re.search(r"smallest counterexample found \([0-9]+ smaller instances tried\)", out)
    tried = out.partition("also tried lines: ")[2]
    assert "refuted by lines (1,0) (0,1) (1,1): m < 3 is false: 3 and 3" in tried
    out = " ".join(run("try {} --of lines", "not simple or not central", *FEW, code=1).split())
    assert "lines (1,0): the statement is false" in out
    (found,) = run.json("try", "m < 3", *FEW, code=1)["results"]
    assert found["routes"] == ["evaluation of the statement"]
    assert (found["expected"], found["expectation_stated"]) == ("holds", False)


def test_nothing_is_as_expected_where_nothing_was(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    run("try", "m < 40", *FEW, "-o", "r.md")
    run("try", "m < 40", *FEW, "-o", "r.txt")
    made = Path("r.md").read_text(encoding="utf-8") + Path("r.txt").read_text(encoding="utf-8")
    assert "expected" not in made
    source = "from proofs_check import claim\n" + "".join(
        f"@claim('s', of=[1, 2]{more})\ndef {name}(x):\n    return {test}\n"
        for name, more, test in (("a", "", "x > 0"), ("b", ", expected='refuted'", "x > 1"))
    )
    Path("mine.py").write_text(source, encoding="utf-8")
    assert "Seed 0; as expected wherever that was stated." in run("report mine.py")
    assert "1 refuted; as expected wherever that was stated" in run("report mine.py --format txt")


def test_claims_of_files_of_one_name_are_told_apart(tmp_path, monkeypatch, run, refused):
    monkeypatch.chdir(tmp_path)
    for folder in ("a", "b"):
        Path(folder).mkdir()
        source = "@claim('s', of=[1])\ndef fine(x):\n    return x == 1\n"
        Path(folder, "mine.py").write_text(f"from proofs_check import claim\n{source}")
    out = run("run a/mine.py b/mine.py")
    assert "fine (a/mine.py)\n" in out
    assert "fine (b/mine.py)\n" in out
    assert "the one case: the 1 given instance\n" in out
    assert "fine (mine.py)\n" in run("run a/mine.py")
    error = refused("run a/mine.py b/mine.py --save c")
    assert "2 claims have the id fine; expected one, for --save" in error


def test_classes_up_to_a_number_are_not_all_of_a_domain(run):
    @claim("s", of="pseudolines", classes=4, families=False, samples=0)
    def few(lines):
        return len(lines) < 10

    result = evaluate(few)
    assert [part.kind for part in result.evidence.parts] == [Kind.EXHAUSTIVE] * 2
    assert result.strength is Strength.SAMPLED
    printed = run("try {} --of pseudolines --samples 0 --strict", "m < 10", code=3)
    assert "no counterexample found (" in printed
    assert "holds in all cases\n" in run("try {} --of generic(m=3..8) --strict", "m < 9")


def test_a_proof_in_a_file_of_a_user_counts_as_samples():
    source = Source(Kind.PROVED, "my proof", lambda _: [])
    mine = replace(registry()["fukuda-bound-attained"], sources=(source,))
    assert (mine.kind, replace(mine, file="mine.py").kind) == (Kind.PROVED, Kind.SAMPLED)


@pytest.mark.parametrize("statement", ["m < 40", "regions < 400"])
def test_samples_never_hold(statement, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    out = run("try", statement, *FEW)
    assert "verdict    no counterexample found (" in out
    assert "holds" not in out
    assert "domain     distinct: central arrangements of different planes, of rank 3" in out
    run("try", statement, *FEW, "--strict", "-o", "r.json", code=3)
    run("report r.json")
    run("report r.json --strict", code=3)


@pytest.mark.slow
@pytest.mark.parametrize("more", [[], ["--classes", "3..8"]])
def test_many_triangles_are_among_the_samples(more, run):
    (found,) = run.json(*SIMPLE_TRIANGLES, "--samples", "0", *more, code=1)["results"]
    assert found["strength"] == "refuted"
    assert len(found["counterexample"]["instance"]["planes"]) == 9


@pytest.mark.parametrize(
    ("statement", "options", "refuting"),
    [
        ("p_vector.get(3, 0) <= 4*m", ["--of", "simple"], 9),  # Fueredi and Palasti
        ("2 * t_vector.get(2, 0) >= m", [], 7),  # Kelly and Moser
        ("2 * t_vector.get(2, 0) >= m", ["--when", "m != 7"], 13),  # Crowe and McKee
        ("3 * t_vector.get(2, 0) >= 2 * m", ["--when", "m > 9 and m != 13"], 10),  # Boeroeczky
        ("regions >= 4 * m", ["--when", "m > 11"], 12),  # near-pencils
        ("p_vector.get(3, 0) < 2 * m * (m - 1) // 3", ["--of", "simple", "--when", "m > 6"], 10),
        ("bounded_p_vector.get(3, 0) < 32", ["--of", "lines"], 11),  # Kobon
        ("regions > 2 * m", ["--of", "lines", "--when", "m > 9"], 10),  # parallels
    ],
)
def test_bounds_are_refuted_by_extremal_families(statement, options, refuting):
    keys = [option.removeprefix("--") for option in options[::2]]
    made = one_line_claim(statement, **dict(zip(keys, options[1::2], strict=True)))
    named = replace(made, samples=0, smaller=None, sources=made.sources[-2:])
    failures = evaluate(named).evidence.failures
    assert refuting in [len(record.document["planes"]) for record in failures]


def test_families_have_coordinates_of_their_domain():
    for name in ("distinct", "lines"):
        cases = [*known_families(domain(name)), *known_families(domain(name), irrational=True)]
        assert len({case.label for case in cases}) == len(cases) >= 50
        assert max(len(case.subject) for case in cases) >= 12


def test_refuted_on_great_circles_is_tried_on_lines(tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    steiner = "regions <= 1 + m + comb(m, 2)"
    out = run("try", steiner, *FEW, "-o", "r.html", code=1)
    assert "domain      distinct: central arrangements" in out
    assert "verdict     refuted\n" in out  # nobody expected anything
    assert "also tried  lines: different lines of the plane: no counterexample found (" in out
    page = Path("r.html").read_text(encoding="utf-8")
    assert "Also tried" in page
    assert "Not as expected" not in page
    (other,) = run.json("try", steiner, *FEW, code=1)["results"][0]["also_tried"]
    assert (other["strength"], other["verdict"]) == ("no counterexample found", "holds")
    alone = run.json("try {} --of distinct", steiner, *FEW, code=1)
    assert "also_tried" not in alone["results"][0]
    assert [file.name for file in tmp_path.iterdir()] == ["r.html"]


@pytest.mark.skipif(os.name == "nt", reason="folders of Windows")
@pytest.mark.parametrize("more", [[], ["--json"]])
def test_a_verdict_is_kept_where_its_file_cannot_be_written(more, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    Path("file").write_text("")
    run("try", "m < 3", *FEW, *more, code=1)
    assert "refuted" in run("try", "m < 3", *FEW, *more, "--save", "file/folder", code=2)
    assert run.err.startswith("error: cannot write 'file/folder'")


def test_stated_expectation_is_named_and_a_default_is_not(tmp_path, run):
    path = tmp_path / "mine.py"
    head = '@claim("s", of="generic(m=3..4)"'
    path.write_text(
        "from proofs_check import claim\n"
        f'{head}, expected="holds")\ndef a(p): return len(p) < 3\n'
        f'{head}, expected="refuted")\ndef b(p): return len(p) > 2\n'
        f"{head})\ndef c(p): return len(p) < 3\n"
    )
    out = run("run", path, code=1)
    assert "refuted (expected: holds)\n" in out
    assert "holds in all cases (expected: refuted)\n" in out
    assert out.count("(expected") == 2


def test_sweep_over_classes_holds_in_all_cases_when_complete(tmp_path, run):
    words = ["sweep", "euler", "--classes", "3..5", "--chunk", "3", "--strict"]
    printed = run(*words, "--store", tmp_path / "part", "--shard", "1/2", code=3)
    assert ": no counterexample found (" in printed
    out = run(*words, "--store", tmp_path / "whole")
    assert ": holds in all cases\n" in out
    assert "on other instances it needs the hypothesis the normals have rank 3" in out
    options = ["--elements", "3..5", "--samples", "9", "--store", tmp_path / "s"]
    (found,) = run.json("sweep step-1-square-bound", *options)["results"]
    assert (found["strength"], found["tried"]) == ("no counterexample found", 9)
    assert found["domain"] == found["over"]
