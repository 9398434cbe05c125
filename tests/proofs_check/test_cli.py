"""The command: output, exit codes, reports."""

import json
from dataclasses import replace

import pytest

import proofs_check.claims
from proofs_check import ClaimVerdict, Registry, registry

QUICK = ("step-1-square-bound", "table-three-contacts")
QUICKEST = ("constraint-count", "fukuda-bound-attained")


def test_list_names_every_claim(run):
    text = run("list")
    assert all(claim.id in text for claim in registry())
    claims = run.json("list")["claims"]
    assert [claim["id"] for claim in claims] == [claim.id for claim in registry()]
    assert all(len(set(claim["routes"])) == 2 for claim in claims)


def test_run_prints_every_row_of_a_table(run):
    out = run("run", *QUICK)
    assert out.count("Yes, numbers fit  Yes, numbers fit") == 5
    assert "smallest counterexample: m = 1" in " ".join(out.split())
    assert run.err == ""


def test_run_json_has_both_values_side_by_side(run):
    record = run.json("run", *QUICK, "--seed", "3")
    assert record["seed"] == 3
    assert record["as_expected"] is True
    assert [result["id"] for result in record["results"]] == list(QUICK)
    rows = record["results"][1]["records"]
    assert [row["values"] for row in rows].count(["No", "No"]) == 2
    assert record["results"][0]["counterexample"]["instance"]["planes"] == [["1", "0", "0"]]


@pytest.mark.usefixtures("scrambled")
def test_processes_change_nothing_of_what_is_said(tmp_path, run):
    """Nor its order, though a claim that takes long comes first."""
    said, found = [], []
    for jobs in ("1", "2"):
        path = tmp_path / f"{jobs}.json"
        names = (QUICK[1], *QUICKEST)
        said.append(run("run", *names, "--jobs", jobs, "--output", path))
        record = json.loads(path.read_text(encoding="utf-8"))
        found.append([{**result, "milliseconds": 0} for result in record["results"]])
        assert [result["id"] for result in found[-1]] == list(names)
    assert said[0] == said[1]
    assert found[0] == found[1]


def test_claims_that_take_minutes_are_checked_when_asked_for(monkeypatch, run):
    known = [registry()[id] for id in QUICKEST]
    claims = Registry([known[0], replace(known[1], large=True)])
    monkeypatch.setattr(proofs_check.claims, "registry", lambda: claims)
    for options, ids in ((), QUICKEST[:1]), (("--large",), QUICKEST), (QUICKEST[1:],) * 2:
        results = run.json("run", *options)["results"]
        assert [result["id"] for result in results] == list(ids)


def test_exit_code_one_when_a_verdict_is_not_the_expected_one(monkeypatch, run):
    wrong = replace(registry()["step-1-square-bound"], expected=ClaimVerdict.HOLDS)
    monkeypatch.setattr(proofs_check.claims, "registry", lambda: Registry([wrong]))
    assert "not as expected: step-1-square-bound" in run("run", code=1)


def test_text_keeps_to_the_width(monkeypatch, run):
    monkeypatch.setenv("COLUMNS", "72")
    assert max(map(len, run("run step-1-square-bound", QUICKEST[0]).splitlines())) <= 72


@pytest.mark.parametrize(
    ("words", "note"),
    [
        (
            ["bounded_regions <= m"],
            "bounded_regions is 0 for every arrangement that was tried; all",
        ),
        (["bounded_regions <= m**2", "--of", "lines"], ""),
        (["simple implies regions >= m", "--of", "pencil(m=4..5)"], "simple is false for every"),
        (["bounded_regions >= 1"], ""),  # refuted, on lines as well
    ],
)
def test_quantities_that_are_0_wherever_tried_are_reported(run, words, note):
    run("try", *words, "--samples", "20", code=None)
    assert run.err.startswith(note)
    assert bool(note) == bool(run.err)


def test_claims_are_listed_a_line_each_in_a_pipe(run):
    lines = run("list").splitlines()
    assert [line.split()[0] for line in lines] == list(proofs_check.claims.entries())
