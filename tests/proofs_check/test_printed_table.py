"""Numbers in print against computed ones: what agrees, differs, or is beyond the computer."""

import json
import re
from collections import Counter
from fractions import Fraction
from importlib.resources import files
from pathlib import Path

import pytest

from arrangement import read_arrangement
from arrangement.cli import main as count
from equilibrium.grasps.inputs.documents import read_grasp
from proofs_check import Claim, ClaimVerdict, claim, evaluate, registry
from proofs_check.course.printed_table import check_table
from proofs_check.instances import printed
from proofs_check.instances.grasps import grasp_of, paper_question
from proofs_check.own_claims import one_line
from proofs_check.own_claims.language import read
from proofs_check.own_claims.quantities import QUANTITIES
from proofs_check.statements.evidence import strength_from
from proofs_check.statements.statement import Strength

EXAMPLES = files("proofs_check.examples")


def test_simplicial_catalogue_agrees_with_print():
    rows = list(check_table(str(EXAMPLES / "simplicial.csv")))
    assert len(rows) == 30
    assert all(row.agrees for row in rows)


@pytest.mark.slow
def test_conflict_in_printed_type_numbers_found(run):
    lines = run("run {} --json", EXAMPLES / "oeis.csv", code=1).splitlines()
    rows = [json.loads(line) for line in lines]
    verdicts = [row["verdict"] for row in rows]
    assert verdicts.count("conflict") == 1
    assert verdicts.count("agree") >= 15
    assert "differ" not in verdicts


def table(tmp_path: Path, *rows: str, first: str = "printed,arrangement,quantity") -> str:
    path = tmp_path / "table.csv"
    path.write_text("\n".join([first, *rows, ""]), encoding="utf-8")
    return str(path)


def test_both_values_are_printed_and_the_exit_code_is_no(tmp_path, run):
    path = table(tmp_path, "25,braid-a3,regions", '"51,840",coxeter type=E6,regions')
    out, _ = run("run", path, code=1), run.err
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
    run("run", path)


def test_table_says_why_no_region_is_bounded(tmp_path, run):
    path = table(
        tmp_path, "1,linial type=3,bounded-regions", "1,linial type=3,relatively-bounded-regions"
    )
    differ, agree, _ = run("run", path, code=1).splitlines()
    assert "computed 0 (every region contains a line" in differ
    assert agree.startswith("agree")


def test_bad_row_does_not_stop_the_others(tmp_path, run):
    path = table(
        tmp_path,
        "24,braid-a3,regoins",
        "25,braid-a3,regions",
        "x,braid-a3,regions",
        "1 2,braid-a3,regions",
        "1 2,braid-a3,t-vector",
        "24,no-such-file,regions",
        "4,catalan(k=2),regions",
        "24,braid-a3,regions",
    )
    out, err = run("run", path, code=2), run.err
    assert [line.split("  ")[0] for line in out.splitlines()[:-1]] == [
        *("not read", "differ", "not read", "not read", "not read", "not read", "not read"),
        "conflict",
    ]
    assert "line 2: 'regoins' is not a quantity; did you mean regions?" in out
    assert err == "error: 6 of 8 rows cannot be read\n"


def test_table_takes_every_quantity_of_a_claim_in_one_line(tmp_path):
    path = table(
        tmp_path,
        "1 -6 11 -6,braid-a3,polynomial",
        "(t - 1)*(t - 2)*(t - 3),braid-a3,polynomial",
        "t^3 - 6 t^2,braid-a3,polynomial",
        "-24,braid-a3,chi(-1)",
        "3=24,braid-a3,p_vector",
        "24,braid-a3,p_vector[3]",
        "yes,braid-a3,simplicial",
        "6,braid-a3,planes",
        'p3=1,"generic(m=3, d=2, affine=true)",bounded_p_vector',
        '1,generic m=3 d=2 affine=true,"bounded_p_vector.get(3, 0)"',
        "4 30 336,catalan(n=2..4),regions",
        "3 16 125,shi(n=2..4),(n + 1) ** (n - 1)",
    )
    rows = list(check_table(path))
    assert "a product without its sign" in rows.pop(2).mistake
    assert [row.agrees for row in rows] == [True] * 11, rows


def test_table_reads_the_polynomial_that_count_prints(tmp_path, capsys):
    assert count(["count", "braid-a3"]) == 0
    printed_rows = [line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines()]
    values = [value for name, value in printed_rows if name in ("chi(t)", "factors")]
    path = table(tmp_path, *(f"{value},braid(n=4),polynomial" for value in [*values, "t - 1"]))
    assert [row.computed for row in check_table(path)] == [(1, -6, 11, -6, 0)] * 3
    assert [row.agrees for row in check_table(path)] == [False] * 3
    path = table(tmp_path, *(f"{value},braid-a3,polynomial" for value in values))
    assert [row.agrees for row in check_table(path)] == [True] * 2


def test_there_are_seven_and_ten_rows_and_eight_counts():
    assert len(printed.THREE_CONTACTS) == 7
    assert len(printed.FOUR_CONTACTS) == 10
    assert sorted(printed.STATE_COUNTS) == list(range(2, 10))


def test_only_stable_rows_have_contact_forces():
    for size, rows in ((3, printed.THREE_CONTACTS), (4, printed.FOUR_CONTACTS)):
        for row in rows:
            assert len(row.forces) == (size if row.stable == "Yes" else 0)
            assert bool(row.motion) == (row.stable == "Yes")


def test_only_one_cell_is_a_misprint():
    rows = printed.THREE_CONTACTS + printed.FOUR_CONTACTS
    cells = [c for row in rows for c in (row.wrench, row.motion, *row.forces) if c]
    assert [c for c in cells if printed.read_vector(c)[1]] == ["(0,0.0.25,-0.25)"]


def test_text_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="cannot be read"):
        printed.read_vector("(1,two)")


@pytest.mark.parametrize(
    ("contacts", "preload", "name"),
    [
        (printed.THREE_CONTACT_GRASP, 0, "paper-three-contacts"),
        (printed.THREE_CONTACT_GRASP, 1, "paper-three-contacts-preload-1"),
        (printed.FOUR_CONTACT_GRASP, 0, "paper-four-contacts"),
        (printed.FOUR_CONTACT_GRASP, 1, "paper-four-contacts-preload-1"),
    ],
)
def test_the_grasps_are_the_built_in_ones(contacts, preload, name):
    question = paper_question(contacts, [Fraction(0)] * 3, preload)
    assert grasp_of(question) == read_grasp(name)


@pytest.mark.parametrize("id", ["table-three-contacts", "table-four-contacts"])
def test_every_row_reads_as_printed(id):
    assert evaluate(registry()[id]).as_expected


LESSONS = [
    (Path(__file__).parents[2] / "docs" / "lessons" / f"{name}.rst").read_text(encoding="utf-8")
    for name in ("10-paper-and-truth", "11-model-and-methods")
]
_ENTRY = re.compile(r"^\*\*([a-z0-9-]+)\*\* \(\*(.+?)\*\)\n {3}\S", re.MULTILINE)


def test_the_lessons_have_every_claim_once_with_its_verdict():
    found = [entry for text in LESSONS for entry in _ENTRY.findall(text)]
    assert len(found) == len(dict(found))
    assert dict(found) == {claim.id: words(claim) for claim in registry()}


def words(claim: Claim) -> str:
    """The strength of a claim, and whether it needs a hypothesis."""
    added = " under a hypothesis" * (claim.expected is ClaimVerdict.HOLDS_UNDER_HYPOTHESIS)
    return f"{strength_from(claim.expected, claim.kind).value}{added}"


def test_the_table_of_the_lesson_counts_the_verdicts_by_section():
    table = LESSONS[0].partition(".. list-table:: The verdicts")[2].partition("\n\nSo most")[0]
    table = table.replace("\\", "")  # before a number that would begin a list
    rows = [row.split("\n     - ") for row in table.strip().split("   * - ")[1:]]
    head, *found = [[cell.strip() for cell in row] for row in rows]
    counts = Counter()
    for entry in registry():
        strength, _, added = words(entry).partition(" under ")
        counts[entry.section, strength] += 1
        counts[entry.section, "of these, under a hypothesis"] += bool(added)
    kinds = [*(strength.value for strength in Strength), "of these, under a hypothesis"]
    assert head == ["section", *kinds]
    sections = dict.fromkeys(claim.section for claim in registry())
    assert found == [[section, *(str(counts[section, k]) for k in kinds)] for section in sections]


def test_quantities_may_have_underscores_or_blanks(tmp_path):
    table = tmp_path / "t.csv"
    table.write_text("arrangement,quantity,printed\nbraid-a3,f_vector,1 14 36 24\n")
    assert [row.agrees for row in check_table(str(table))] == [True]
    table.write_text("arrangement,quantity,printed\nbraid-a3,bounded regions,0\n")
    assert [row.quantity for row in check_table(str(table))] == ["bounded_regions"]


@pytest.mark.parametrize("name", ["braid-a3", "shi-a2-affine", "generic-lines-affine"])
def test_every_quantity_is_the_same_in_python_claims_and_tables(name, tmp_path):
    planes = read_arrangement(name)
    for quantity, compute in QUANTITIES.items():
        value = compute(planes)
        assert one_line.value_of(read(quantity), planes, {}) == value
        printed = (
            " ".join(f"{k}={v}" for k, v in value.items())
            if isinstance(value, dict)
            else " ".join(str(int(x)) for x in (value if isinstance(value, tuple) else [value]))
        )
        if printed:  # no region is bounded
            (row,) = check_table(table(tmp_path, f"{printed},{name},{quantity}"))
            assert row.agrees, (quantity, row)
        if quantity.endswith("_vector"):
            method = getattr(planes, quantity)
            assert (method() if callable(method) else method) == value


def test_claims_of_a_file_take_lines_and_their_quantities():
    statement = "Kobon's bound, and bounded regions are those of level 0."

    @claim(statement, of="lines", classes=5, samples=20)
    def kobon(lines):
        m, levels = len(lines), lines.level_vector
        assert lines.bounded_p_vector.get(3, 0) <= m * (m - 2) // 3
        return levels.get(0, 0) == len(lines.bounded_regions()) == lines.bounded_region_count()

    found = evaluate(kobon)
    assert found.verdict is ClaimVerdict.HOLDS
    assert found.evidence.parts[0].checked == 4 + 9 + 47
