"""The Coq sources, without Coq: `make formal` compiles them."""

import re
from pathlib import Path

import pytest

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
    script = (FOLDER / "build.sh").read_text(encoding="utf-8")
    (listed,) = re.findall(r"^for file in ([^;]*); do$", script, re.MULTILINE)
    compiled = {
        *listed.replace("\\", "").split(),
        *re.findall(r"^coqc (\w+)\.v", script, re.MULTILINE),
    }
    assert compiled == {path.stem for path in SOURCES}
    assert len(SOURCES) > 5


def test_the_axioms_of_every_theorem_of_the_program_are_printed():
    """The theorems about what is extracted: the last word on certificates, and on counts."""
    about = [FOLDER / "grasps" / "Soundness.v", FOLDER / "counting" / "Counting.v"]
    theorems = [
        name for path in about for name in re.findall(r"^Theorem (\w+)", path.read_text(), re.M)
    ]
    printed = re.findall(r"^Print Assumptions (\w+)\.", (FOLDER / "Extract.v").read_text(), re.M)
    assert theorems == printed
    assert {"not_resisted", "faces_complete"} <= set(theorems)
