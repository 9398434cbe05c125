"""What editors and type checkers know of the options of views."""

import pytest

from tests.draw_stubs import ROOT, STUBS, stub


@pytest.mark.parametrize("path", STUBS)
def test_stubs_are_those_of_the_views(path):
    """If not: ``python -m tests.draw_stubs``."""
    assert (ROOT / path).read_text(encoding="utf-8") == stub(*STUBS[path])
