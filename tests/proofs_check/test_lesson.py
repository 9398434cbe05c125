"""The lesson on what the paper says has every claim, with the verdict of the registry."""

import re
from collections import Counter
from pathlib import Path

from proofs_check import Verdict, registry

LESSON = Path(__file__).parents[2] / "docs" / "lessons" / "10-paper-and-truth.rst"
_ENTRY = re.compile(r"^\*\*([a-z0-9-]+)\*\* \(\*(.+?)\*\)\n {3}\S", re.MULTILINE)


def test_the_lesson_has_every_claim_once_with_its_verdict():
    found = _ENTRY.findall(LESSON.read_text(encoding="utf-8"))
    assert len(found) == len(dict(found))
    assert dict(found) == {claim.id: claim.expected.value for claim in registry()}


def test_the_table_of_the_lesson_counts_the_verdicts_by_section():
    text = LESSON.read_text(encoding="utf-8")
    table = text.partition(".. list-table:: The verdicts")[2].partition("\n\nSo most")[0]
    table = table.replace("\\", "")  # before a number that would begin a list
    rows = [row.split("\n     - ") for row in table.strip().split("   * - ")[1:]]
    head, *found = [[cell.strip() for cell in row] for row in rows]
    counts = Counter((claim.section, claim.expected.value) for claim in registry())
    sections = dict.fromkeys(claim.section for claim in registry())
    assert head == ["section", *(verdict.value for verdict in Verdict)]
    assert found == [
        [section, *(str(counts[section, verdict.value]) for verdict in Verdict)]
        for section in sections
    ]
