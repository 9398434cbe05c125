"""The lesson on what the paper says has every claim, with the verdict of the registry."""

import re
from pathlib import Path

from proofs_check import registry

LESSON = Path(__file__).parents[2] / "docs" / "lessons" / "10-paper-and-truth.rst"
_ENTRY = re.compile(r"^\*\*([a-z0-9-]+)\*\* \(\*(.+?)\*\)\n {3}\S", re.MULTILINE)


def test_the_lesson_has_every_claim_once_with_its_verdict() -> None:
    found = _ENTRY.findall(LESSON.read_text(encoding="utf-8"))
    assert len(found) == len(dict(found))
    assert dict(found) == {claim.id: claim.expected.value for claim in registry()}
