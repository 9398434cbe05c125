"""Every page of the documentation does what it shows."""

import importlib
import os
import re
import runpy
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

import arrangement
import equilibrium
import proofs_check
from arrangement import cli as arrangement_cli
from arrangement.enumeration.choose import ENGINES
from arrangement.library.families import simplicial, simplicial_entries
from arrangement.numbers import budget
from arrangement.pictures.lab.lines import line_exercises
from equilibrium.cli import program as equilibrium_cli
from equilibrium.methods.registry import DECIDING
from equilibrium.pictures.lab.page import slip_exercises
from proofs_check.cli import program as claims_cli
from tests.docpages import ROOT, Page, blocks, commands, loose_literals, with_free_port
from tests.test_clock import FACTORS, set_clock

DOCS = ROOT / "docs"
GENERATED = {"_build", "_generated", "names"}
PAGES = [
    path
    for path in sorted(DOCS.rglob("*.rst"))
    if not GENERATED & set(path.relative_to(DOCS).parts)
]
_FIGURE = re.compile(r"(?:figure|image|raw|include)::\s*(?:/|\.\./)*_generated/(\S+)")


def name(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty directory to work in, and a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return tmp_path


def run(text: str) -> list[str]:
    page = Page(Path("page.rst"), text)
    page.run()
    return page.problems


#: Pages with programs that wait for each other, which the clock of the machine is left to.
WAITING = {"cluster"}


@pytest.mark.parametrize("page", [*PAGES, ROOT / "README.md"], ids=name)
def test_a_page_read_from_top_to_bottom_does_what_it_shows(page, desk, monkeypatch):
    """The clock is fast and slow by turns, from reading to reading: no answer depends on it."""
    if page.stem not in WAITING:
        set_clock(monkeypatch, *FACTORS, *reversed(FACTORS))
    running = Page(page, page.read_text(encoding="utf-8"))
    running.run()
    assert not running.problems, "\n\n".join(running.problems)


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_no_block_of_code_is_left_out(page):
    text = page.read_text(encoding="utf-8")
    assert loose_literals(text) == [], "use a code-block with a language"
    found = list(blocks(text))
    shell = [
        (block.line, line) for block in found if block.argument == "console"
        for _, line, _ in commands(block)
    ]  # fmt: skip
    for block in found:
        place = f"{name(page)}:{block.line}"
        if block.caption:
            after = [line for number, line in shell if number > block.line]
            below = "\n".join([*after, *re.findall(r"(?m)^ *>>> .*$", text)])
            assert block.caption in below, f"{place}: no command uses {block.caption}"
        elif block.directive == "literalinclude":
            shown = (page.parent / block.argument).resolve()
            run_elsewhere = shown.parent == DOCS / "figures" or shown.suffix == ".v"
            assert run_elsewhere, f"{place}: nothing runs {block.argument}"
        elif block.argument not in ("console", "text"):
            assert ">>> " in block.body, f"{place}: nothing runs this {block.argument}"


def test_every_generated_picture_has_a_script():
    """The script NAME.py makes the files whose names start with NAME."""
    scripts = [path.stem for path in (DOCS / "figures").glob("[!_]*.py")]
    for page in PAGES:
        for picture in _FIGURE.findall(page.read_text(encoding="utf-8")):
            makers = [stem for stem in scripts if re.fullmatch(rf"{stem}(-.*)?\.\w+", picture)]
            assert makers, f"{name(page)}: no script of docs/figures makes {picture}"


def test_every_work_cited_on_a_page_is_in_the_bibliography():
    listed = set(re.findall(r"(?m)^\.\. \[(\w+)\]", (DOCS / "bibliography.rst").read_text("utf-8")))
    assert "HaasHeger2018" in listed
    for page in PAGES:
        cited = set(re.findall(r"\[([A-Z]\w+\d{4})\]_", page.read_text(encoding="utf-8")))
        assert cited <= listed, name(page)


def known(dotted: str) -> bool:
    """Whether a dotted name is a module of the project, or something in one."""
    names = dotted.split(".")
    for length in range(len(names), 0, -1):
        try:
            found = importlib.import_module(".".join(names[:length]))
        except ImportError:
            continue
        for name in names[length:]:
            found = getattr(found, name, None)
        return found is not None
    return False


_NAME = re.compile(r"(?<!`)`((?:arrangement|equilibrium|proofs_check|slipstates)\.[\w.]+)`(?!`)")
_TEST = re.compile(r"``?(tests/[\w/]+\.py)(?:::(\w+))?``?")


def test_every_dotted_name_on_a_page_is_there():
    found = {
        (name(page), dotted)
        for page in [*PAGES, *ROOT.glob("*.md")]
        for dotted in _NAME.findall(page.read_text(encoding="utf-8"))
    }
    assert len(found) > 20
    assert {one for one in found if not known(one[1])} == set()
    assert not known("equilibrium.plane.no_such_room")


def test_every_test_on_a_page_is_there():
    found = {
        one
        for page in [*PAGES, *ROOT.glob("*.md")]
        for one in _TEST.findall(page.read_text("utf-8"))
    }
    assert len(found) > 8
    for path, function in sorted(found):
        assert (ROOT / path).is_file(), path
        assert not function or f"def {function}(" in (ROOT / path).read_text("utf-8"), function


@pytest.mark.parametrize("package", [arrangement, equilibrium, proofs_check])
def test_public_names_are_on_the_api_page_once(package):
    text = (DOCS / "api" / f"{package.__name__}.rst").read_text(encoding="utf-8")
    listed = [
        name
        for group in re.findall(r"(?m)^   :nosignatures:\n\n((?:   .+\n)+)", text)
        for name in group.split()
    ]
    names = (name for name in dir(package) if not name.startswith("_"))
    assert sorted(listed) == sorted(f"~{package.__name__}.{name}" for name in names)


def test_the_table_of_engines_is_that_of_the_code():
    text = (DOCS / "architecture.rst").read_text(encoding="utf-8")
    table = text[text.index("Which engine enumerates") : text.index("Exact and approximate")]
    rows = re.findall(r"(?m)^   \* - ``([\w-]+)``\n     - (.*)$", table)
    assert rows == [(key, engine.can) for key, engine in ENGINES.items()]


@pytest.mark.parametrize(
    "text",
    [
        ">>> 1 + 1\n3\n",
        ">>> x = 1\n\n>>> y\n1\n",
        ".. code-block:: console\n\n   $ arrangement count three-generic-planes\n   planes 4\n",
        ".. code-block:: console\n\n   $ arrangement count no-such-file\n",
        ".. code-block:: console\n\n   $ arrangement count pencil > a.txt\n   planes 5\n",
    ],
)
def test_a_page_that_shows_something_else_is_caught(desk, text):
    assert run(text)


def test_names_files_and_exit_codes_pass_from_block_to_block(desk):
    text = """
>>> from pathlib import Path
>>> x = 2

.. code-block:: json
   :caption: one.json

   {"schema_version": 1, "planes": [["1", "0", "0"]]}

Some text, and then

.. code-block:: console

   $ arrangement count \\
         one.json
   planes           1
   ...
   $ arrangement count one.json > counted.txt
   $ arrangement count two.json
   error: ...
   $ echo $?
   2

>>> x, Path("counted.txt").read_text().split()[:2]
(2, ['planes', '1'])
"""
    assert run(text) == []
    assert (desk / "one.json").read_text(encoding="utf-8").startswith('{"schema')


def test_port_of_a_page_is_a_free_one():
    text = "$ dask scheduler --port 18786 &\n$ dask worker tcp://127.0.0.1:18786 &\n"
    free = with_free_port(text)
    (port, other) = re.findall(r"\d{4,}", free)
    assert port == other != "18786"
    assert free == text.replace("18786", port)
    assert with_free_port("no port") == "no port"


@pytest.mark.parametrize("command", ["rm -r .", "pip install other", "make no-such-target"])
def test_an_unknown_command_is_no_page(desk, command):
    with pytest.raises(Exception, match=r"rm -r|other|non-zero"):
        run(f".. code-block:: console\n\n   $ {command}\n")


@pytest.fixture
def draw(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], list[str]]:
    """Make the figures of a folder with one script; return the files that are there."""
    monkeypatch.syspath_prepend(tmp_path)
    make_figures = runpy.run_path(str(DOCS / "conf.py"))["make_figures"]
    (tmp_path / "figures").mkdir()

    def make(script: str) -> list[str]:
        path = tmp_path / "figures" / "one.py"
        if not path.exists() or path.read_text(encoding="utf-8") != script:
            path.write_text(script, encoding="utf-8")
            os.utime(path, (1, 1))
        make_figures(SimpleNamespace(srcdir=str(tmp_path), outdir=str(tmp_path / "out")))
        return sorted(path.name for path in (tmp_path / "_generated").glob("[!.]*"))

    return make


COUNTING = """
from pathlib import Path
runs = len(list(Path().glob("one-*.svg")))
Path(f"one-{runs}.svg").write_text("")
"""


def test_a_figure_is_made_once_until_its_script_is_newer(draw, tmp_path):
    assert draw(COUNTING) == ["one-0.svg"]
    assert draw(COUNTING) == ["one-0.svg"]
    os.utime(tmp_path / "figures" / "one.py", (2**32, 2**32))
    assert draw(COUNTING) == ["one-0.svg", "one-1.svg"]


@pytest.mark.parametrize("script", ["1 / 0", "open('two.svg', 'w').close()", "pass"])
def test_a_script_that_fails_or_makes_no_figure_ends_the_build(draw, script):
    with pytest.raises((ZeroDivisionError, RuntimeError)):
        draw(script)


def test_every_command_has_an_example():
    for parser in (arrangement_cli._parser(), equilibrium_cli._parser(), claims_cli._parser()):
        (commands,) = (a.choices for a in parser._actions if isinstance(a.choices, dict))
        for command in commands:
            page = (DOCS / "commands" / f"{parser.prog}-{command}.rst").read_text("utf-8")
            assert f"\n.. command-help:: {parser.prog} {command}\n" in page
            assert f"\n   $ {parser.prog} {command}" in page


def test_every_command_explains_its_exit_codes():
    for parser in (arrangement_cli._parser(), equilibrium_cli._parser(), claims_cli._parser()):
        assert "3 undecided, 70 internal error" in " ".join(parser.format_help().split())
        (commands,) = (a for a in parser._actions if isinstance(a.choices, dict))
        said = {one.dest: one.help for one in commands._choices_actions}
        for name, command in commands.choices.items():
            text = said[name]
            assert text[0].islower()
            assert not text.endswith(".")
            assert "exit" not in text
            shown = " ".join(command.format_help().split())
            assert f"{text[0].upper()}{text[1:]}." in shown
            assert re.search(
                r"Exit codes: 0 [\w ]+, (1 [\w ]+, )?2 bad input(, 3 [\w ,-]+)?\.$", shown
            )


def test_numbers_on_pages_are_those_of_the_code():
    number = {4: "four", 10: "ten", 12: "twelve", 13: "thirteen"}
    known = [simplicial(*entry) for entry in simplicial_entries()]
    irrational = sum(one.field is not None for one in known)
    methods = len(DECIDING)
    for page, text in (
        ("howto/lab", f"replaces the {number[len(slip_exercises())]} exercises by them"),
        ("howto/arrangement-lab", f"{number[len(line_exercises())]} exercises check themselves"),
        ("lessons/11-model-and-methods", f"All {len(known)} known simplicial arrangements of "
         f"rank 3 with up to {max(map(len, known))} planes are built, {irrational} of them "
         "irrational"),
        ("howto/fields", f"{irrational} of the {len(known)} known simplicial"),
        ("howto/formats", f"the {len(known) - irrational} simplicial arrangements with integer"),
        ("lessons/11-model-and-methods", f"{number[methods]} methods and five wrenches"),
        ("gallery/compare", f"{number[methods]} methods and five wrenches"),
    ):  # fmt: skip
        words = " ".join((DOCS / f"{page}.rst").read_text(encoding="utf-8").split())
        assert text.lower() in words.lower(), (page, text)


#: The last words of a row of the table of limits: kinds of `budget.MAX_SIZES`, or constants.
LIMITS = {
    "CSV file)": ("bytes of a file",),
    "a certificate": ("bytes of a certificate",),
    "of a mesh": ("bytes of a mesh",),
    "one number": ("characters of a number", "digits of a number on a page"),
    "space in a file": ("coordinates",),
    "planes in a picture": ("planes in a picture",),
    "interactive page": ("great circles in a picture", "great circles on a page"),
    "in a ball or cube": ("planes in a body", "cells in a picture"),
    "Hasse diagram": ("regions in a picture", "flats of one rank in a picture"),
    "slip lab": ("contacts in the lab",),
    "arrangement lab": ("planes in the lab",),
    "symmetry is drawn": ("planes whose symmetry is looked for",),
    "is exponential": ("contacts with a choice of three states",),
    "of one picture": ("contacts in a picture", "rays in a picture", "wrenches in a picture"),
    "``resisted --margin``": ("open ranges of friction coefficients",),
    "isomorphism classes": ("arrangement.library.census.catalogue:MOST_PLANES",),
    "tables of types": (
        "arrangement.library.files.others.chirotope:MOST_ELEMENTS",
        "proofs_check.course.printed_table:MOST_PSEUDOLINES",
    ),
    "many grasps, or a record": (
        "bytes of a file of many arrangements",
        "bytes of many grasps",
        "bytes of a record",
    ),
    "after the other": (
        "proofs_check.sweep.sweep:MOST",
        "arrangement.console.options.values:MAX_COUNT",
    ),
    "of a proof": ("equilibrium.certificate.tree:MAX_DEPTH",),
}


def test_the_limits_on_the_page_are_those_of_the_code():
    text = (DOCS / "accuracy.rst").read_text(encoding="utf-8").partition("\nLimits of size\n")[2]
    rows = re.findall(r"   \* - (.+)\n     - (.+)", text.partition("There is no other")[0])[1:]
    assert len(rows) == len(LIMITS)
    assert set(budget.MAX_SIZES) == {x for names in LIMITS.values() for x in names if ":" not in x}
    for what, most in rows:
        (names,) = (names for end, names in LIMITS.items() if what.endswith(end))
        stated = [
            int(number) * (2**20 if "MiB" in most else 1) for number in re.findall(r"[0-9]+", most)
        ]
        for limit in names:
            module, _, constant = limit.partition(":")
            held = vars(importlib.import_module(module)) if constant else budget.MAX_SIZES
            value = held[constant or limit]
            assert value in stated, (what, most, limit, value)
