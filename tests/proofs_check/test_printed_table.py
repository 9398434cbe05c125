"""Numbers in print against computed ones: what agrees, differs, or is beyond the computer."""

import json
from importlib.resources import files
from pathlib import Path

import pytest

from proofs_check.cli.program import main
from proofs_check.course.printed_table import check_table

EXAMPLES = files("proofs_check.examples")


def test_the_simplicial_catalogue_agrees_with_its_vectors_in_print():
    rows = list(check_table(str(EXAMPLES / "simplicial.csv")))
    assert len(rows) == 30
    assert all(row.agrees for row in rows)


@pytest.mark.campaign
def test_numbers_of_types_agree_and_the_conflict_in_print_is_found(capsys):
    assert main(["table", str(EXAMPLES / "oeis.csv"), "--json"]) == 1
    rows = [json.loads(line) for line in capsys.readouterr()[0].splitlines()]
    verdicts = [row["verdict"] for row in rows]
    assert verdicts.count("conflict") == 1
    assert verdicts.count("agree") >= 15
    assert "differ" not in verdicts


def table(tmp_path: Path, *rows: str, first: str = "printed,arrangement,quantity") -> str:
    path = tmp_path / "table.csv"
    path.write_text("\n".join([first, *rows, ""]), encoding="utf-8")
    return str(path)


def test_both_values_are_printed_and_the_exit_code_is_no(tmp_path, capsys):
    path = table(tmp_path, "25,braid-a3,regions", '"51,840",coxeter type=E6,regions')
    assert main(["table", path]) == 1
    out, _ = capsys.readouterr()
    assert out.splitlines() == [
        "differ        braid-a3, regions: printed 25, computed 24",
        "agree         coxeter type=E6, regions: printed 51,840, computed 51,840",
        "1 differ, 1 agree",
    ]
    path = table(
        tmp_path,
        "1 14 36 24,braid-a3,f-vector",
        "t3=4 t2=3,braid-a3,t-vector",
        "43,lines n=6,affine-simple-types",
        "4,pseudolines n=6,simple-types",
    )
    assert main(["table", path]) == 0
