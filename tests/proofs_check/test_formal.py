"""The Coq sources, without Coq: `make formal` compiles them."""

import json
import os
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

from arrangement.planes.proved import program
from proofs_check import ClaimVerdict, registry
from proofs_check.reports import report
from proofs_check.reports.page import html_page
from proofs_check.routes.proved import COUNTS
from proofs_check.statements.evidence import Failure, evaluate
from proofs_check.statements.statement import Route

FOLDER = Path(__file__).resolve().parents[2] / "proofs_check" / "formal"
SOURCES = sorted(set(FOLDER.rglob("*.v")) - set(FOLDER.rglob("_build/*")))
#: What leaves a gap in a proof.
GAPS = re.compile(
    r"\b(Admitted|admit|give_up|Abort|Axioms?|Conjectures?|Parameters?|Declare|bypass_check"
    r"|Unset\s+\w+\s+Checking)\b"
)


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.name)
def test_no_proof_is_left_out(path):
    assert GAPS.findall(path.read_text(encoding="utf-8")) == []


def test_a_gap_would_be_seen():
    assert GAPS.search("Proof. intros. Admitted.")
    assert GAPS.search("Unset Guard Checking.")


def test_every_source_is_compiled():
    """All that are copied into one folder, where two of one name would be one."""
    script = (FOLDER / "build.sh").read_text(encoding="utf-8")
    assert "cp ./*.v */*.v program/*.ml _build/" in script
    assert "< <(ls ./*.v | grep -v Extract.v" in script
    assert len({path.name for path in SOURCES}) == len(SOURCES) > 20


#: Stand for Coq and OCaml: what is compiled is written to a log.
TOOLS = {
    "coqc": """
[ "$1" = --version ] && { echo Coq; exit; }
echo "$1" >> "$LOG"; touch "${1}o"
[ "$1" != Extract.v ] || { touch checker.ml checker.mli; echo Axioms:; }
""",
    "coqdep": "",
    "ocamlfind": "touch proved-checker",
}


@pytest.mark.skipif(os.name == "nt", reason="a script for bash")
def test_results_of_coq_are_kept_by_their_sources(tmp_path):
    """They are compiled again where a source or the kept file changed, and without a cache."""
    formal, tools, cache, log = (tmp_path / name for name in ("formal", "bin", "cache", "log"))
    shutil.copytree(FOLDER, formal, ignore=shutil.ignore_patterns("_build"))
    tools.mkdir()
    for name, text in TOOLS.items():
        (tools / name).write_text(f"#!/bin/sh\n{text}\nexit 0\n", encoding="utf-8")
        (tools / name).chmod(0o755)
    paths = {"PATH": f"{tools}:{os.environ['PATH']}", "LOG": str(log)}

    def compiled(cache: Path | str) -> int:
        log.write_text("", encoding="utf-8")
        environment = {**os.environ, **paths, "FORMAL_CACHE": str(cache)}
        command = ["bash", str(formal / "build.sh")]
        subprocess.run(command, env=environment, capture_output=True, timeout=60, check=True)
        assert (formal / "_build" / "checker.ml").is_file()
        return len(log.read_text(encoding="utf-8").splitlines())

    assert [compiled(""), compiled(cache), compiled(cache)] == [len(SOURCES), len(SOURCES), 0]
    with (formal / "counting" / "Planes.v").open("a", encoding="utf-8") as stream:
        stream.write("\n")
    assert [compiled(cache), compiled(cache)] == [len(SOURCES), 0]
    for kept in cache.glob("*.tar.gz"):
        kept.write_bytes(kept.read_bytes()[:-1])
    assert compiled(cache) == len(SOURCES)
    assert compiled("/dev/null/none") == len(SOURCES)


def test_the_axioms_of_every_theorem_of_the_program_are_printed():
    """On grasps and assemblies, on counts, of claims, and on coordinates."""
    about = [FOLDER / "grasps" / name for name in ("Soundness.v", "Adhesion.v", "Forest.v")]
    about += [FOLDER / "counting" / name for name in ("Counting.v", "Whitney.v")]
    about += [FOLDER / "claims" / name for name in ("Bounded.v", "Claims.v")]
    about.append(FOLDER / "realizability" / "FinalPolynomials.v")
    about += [FOLDER / "realizability" / name for name in ("Inscribed.v", "Weights.v")]
    theorems = [
        name for path in about for name in re.findall(r"^Theorem (\w+)", path.read_text(), re.M)
    ]
    text = (FOLDER / "Extract.v").read_text()
    (printed,) = re.findall(r"^Definition theorems := \((.*?)\)\.$", text, re.M | re.S)
    assert theorems == re.findall(r"\w+", printed)
    assert text.endswith("\nPrint Assumptions theorems.\n")
    assert {"not_resisted", "faces_complete"} <= set(theorems)


#: The files of statements, all of whose definitions are meant to be read.
READ = ("Planes.v", "Model.v")


def test_page_of_the_proofs_maps_theorems_to_files_and_names_what_they_say():
    """Definitions in statements: in the files to be read, or named, or extracted."""
    page = (FOLDER / "README.md").read_text(encoding="utf-8")
    sources = {path.name: re.sub(r"(?s)\(\*.*?\*\)", "", path.read_text()) for path in SOURCES}
    (printed,) = re.findall(r"(?s)^Definition theorems := \((.*?)\)", sources["Extract.v"], re.M)
    rows = [row.split("|")[1:-1] for row in page.splitlines() if row.startswith("| `")]
    stated = {
        name: row[2] for row in rows if len(row) == 4 for name in re.findall(r"`(\w+)`", row[0])
    }
    assert set(stated) == set(re.findall(r"\w+", printed))
    files = re.findall(r"`([\w/]+\.v)`", page)
    assert all((FOLDER / name).is_file() for name in files)
    begins = r"(?m)^ *(?:Definition|Fixpoint|Inductive|Record) (\w+)"
    defined = {name for text in sources.values() for name in re.findall(begins, text)}
    known = {name for file in READ for name in re.findall(begins, sources[file])}
    known |= set(re.findall(r"\w+", sources["Extract.v"].partition("Extraction ")[2]))
    known |= set(re.findall(r"\w+", page.partition("What has to be read")[2]))
    for name, place in stated.items():
        text = sources[Path(place.strip(" `")).name]
        (statement,) = re.findall(rf"(?s)^Theorem {name}\b(.*?)Proof\.", text, re.M)
        bound = " ".join(re.findall(r"(?:forall|exists) ([^,]*),", statement))
        words = (set(re.findall(r"\w+", statement)) & defined) - set(re.findall(r"\w+", bound))
        assert words <= known, name


def test_claims_and_theorems_name_one_another():
    """Every theorem for claims is of one claim that says it is proved, and there is no other."""
    claims = [claim for claim in registry() if claim.theorems]
    named = [name for claim in claims for name in claim.theorems]
    assert sorted(named) == sorted(report.theorems())
    # A theorem proves a claim, or is a counterexample that refutes it.
    assert all(claim.proof or claim.expected is ClaimVerdict.REFUTED for claim in claims)
    for claim in claims:
        assert claim.theorems[0] == claim.id.replace("-", "_")
        for_all = "for every number of planes" in report.badges(claim)[0]["meaning"]
        assert for_all == (claim.proof is not None), claim.id


def test_a_theorem_is_shown_with_its_claim(run):
    shown = run("list euler")
    assert "vertices - edges + faces = 2." in shown
    assert "Proof" not in shown
    assert "in prose    the whole proof" in run("list dual-planar-3-connected")


def named(claim, **changes):
    claim = replace(claim, **changes)
    shown = report.badges(claim, evaluate(claim, 0).evidence if claim.routes else None)
    return [name for badge in shown for name in badge["names"]]


def test_no_hand_sets_a_badge():
    """Names alone give none: neither of theorems, nor of a route, nor of a file's claim."""
    euler, states = registry()["euler"], registry()["different-slip-states"]
    invented = {"routes": (), "theorems": ("euler", "invented", "two_planes_general")}
    assert named(euler, **invented) == ["theorem euler"]
    assert named(euler, **invented, file="own.py") == []
    called = Route("the program proved in Coq", lambda planes: sum(planes.faces().f_vector))
    assert named(states, routes=(*states.routes, called)) == ["theorem different_slip_states"]
    proved = replace(called, compute=COUNTS[states.id])
    claim = replace(states, routes=(*states.routes, proved))
    found = evaluate(states, 0).evidence
    broken = [replace(r, values=(*r.values, Failure("it failed"))) for r in found.records]
    assert len(report.badges(claim, replace(found, records=tuple(broken)))) == 1


@pytest.mark.skipif(program() is None, reason="`make formal` has not built the program")
def test_the_proved_program_is_a_third_route(run):
    (result,) = run.json("run --verified different-slip-states")["results"]
    assert result["routes"][-1] == "the program proved in Coq"
    assert [len(set(record["values"])) for record in result["records"]] == [1] * 8
    assert {len(record["values"]) for record in result["records"]} == {3}
    assert result["badges"][-1]["names"] == ["counted by the verified program"]
    assert "in 8 of 8 cases" in html_page(json.loads(json.dumps(report.json_record([result], 0))))


@pytest.mark.skipif(program() is None, reason="`make formal` has not built the program")
def test_a_case_beyond_the_proved_program_is_no_evidence():
    """H3 is irrational: its card counts the other case alone."""
    claim = registry()["small-regions-in-print"]
    found = claim.sources[0].cases(Random(0))
    few = [case for case in found if case.label.startswith(("braid(4)", "coxeter('H3')"))]
    source = replace(claim.sources[0], cases=lambda _: few)
    third = Route("the program proved in Coq", COUNTS[claim.id])
    claim = replace(claim, routes=(*claim.routes, third), sources=(source,))
    result = evaluate(claim, 0)
    assert result.verdict is ClaimVerdict.HOLDS
    assert [record.values[-1] for record in result.evidence.records] == [24, NotImplemented]
    assert "in 1 of 2 cases" in report.badges(claim, result.evidence)[-1]["meaning"]
    record = report.json_record([report.result_record(result)], 0)
    assert "beyond this route" in html_page(json.loads(json.dumps(record)))


def test_the_first_route_must_answer():
    euler = registry()["euler"]
    routes = (replace(euler.routes[0], compute=lambda planes: NotImplemented), *euler.routes[1:])
    assert evaluate(replace(euler, routes=routes), 0).verdict is None


def test_the_proved_route_is_of_claims_that_there_are():
    assert set(COUNTS) <= set(registry().ids)
