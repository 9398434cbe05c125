"""Words of an earlier dialect that no page, help text or message uses; the standard ones stand."""

import argparse
import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from arrangement import cli as arrangement_cli
from equilibrium.cli import program as equilibrium_cli
from proofs_check.cli import program as claims_cli

ROOT = Path(__file__).parents[1]
PACKAGES = ("arrangement", "equilibrium", "proofs_check")
#: Each with what is written instead.
WORDS = {
    r"annex(es)?": "optional package",
    r"ground floor": "top level",
    r"wished": "target",
    r"planted": "mutant",
    r"campaign": "extended tests",
    r"hostile": "invalid input",
    r"whisker": "dangling edge",
    r"in so many words": "explicitly",
    r"so many times": "N times",
    r"of the processor": "CPU seconds",
    r"processor time": "CPU time",
    r"proved (program|checker)": "formally verified checker",
    r"complete model": "full model",
    r"classes of flats": "orbits of flats",
    r"images of flats": "orbits of flats",
    r"combinatorial types?": "isomorphism class",
    r"narrow planes": "nearly parallel hyperplanes",
    r"idle motion": "null-space motion",
    r"unfelt": "null-space motion",
    r"told apart": "distinguished",
    r"passed over": "skipped",
    r"in turn with": "alternating with",
    r"a fault of the program": "internal error",
    r"(?<!there )is no (number|list|prime|grasp|certificate|file|text|state)": "is not a",
    r"anew": "again",
    r"marks itself": "self-grading",
    r"of one's own": "your",
    r"known are": "expected one of",
    r"says so": "reports it",
    r"(is|was|are|were) said": "is reported",
    r"is told": "is reported",
    r"literal reading": "as printed",
    r"goes on where": "continues where",
    r"(two|both|the|second|third) routes? (that|to|which|disagree)": "independent implementation",
    r"others within the error": "other data within the rounding error",
    r"asked was": "expected",
    r"place for": "unexpected argument",
    r"as it was rounded": "for the rounded data",
    r"whatever the contacts do": "for all contact forces",
}
DIALECT = re.compile(rf"\b(?:{'|'.join(WORDS)})\b", re.IGNORECASE)


def _pages() -> Iterator[tuple[str, str]]:
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.rst")):
        yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")


def _help() -> Iterator[tuple[str, str]]:
    waiting = [program._parser() for program in (arrangement_cli, equilibrium_cli, claims_cli)]
    while waiting:
        parser = waiting.pop()
        yield parser.prog, parser.format_help()
        for action in parser._actions:
            if isinstance(action, argparse._SubParsersAction):
                waiting += action.choices.values()


def _messages() -> Iterator[tuple[str, str]]:
    for package in PACKAGES:
        for path in (ROOT / package).rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Raise):
                    texts = [x.value for x in ast.walk(node) if isinstance(x, ast.Constant)]
                    text = " ".join(x for x in texts if isinstance(x, str))
                    yield f"{path.relative_to(ROOT)}:{node.lineno}", text


@pytest.mark.parametrize("texts", [_pages, _help, _messages])
def test_no_dialect(texts):
    listed = list(texts())
    assert len(listed) > 20
    found = [(place, hit[0]) for place, text in listed for hit in DIALECT.finditer(text)]
    assert not found, f"write the standard words, see WORDS: {found}"


def test_dialect_found():
    assert DIALECT.search("'x' is no number")
    assert not DIALECT.search("there is no number")
