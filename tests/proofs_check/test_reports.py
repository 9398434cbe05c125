"""Reports: the JSON record is complete, and every other form is made from it alone."""

import contextlib
import copy
import html
import io
import json
import re
import runpy
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement, InputError
from arrangement.library.families import generic
from equilibrium.grasps.inputs.documents import read_grasp
from proofs_check import Kind, evaluate, registry
from proofs_check.reports import forms as pages, report
from proofs_check.reports.formula import mathml
from proofs_check.reports.page import html_page, pictures, python_lines
from proofs_check.reports.report import commit
from proofs_check.reports.text import value_text

ROOT = Path(__file__).parents[2]
IDS = ("different-slip-states", "step-1-square-bound")
VOID = {"meta", "link", "br", "input"}


@pytest.fixture(scope="module")
def record() -> dict[str, Any]:
    return report.json_record([report.result_record(evaluate(registry()[id], 3)) for id in IDS], 3)


@pytest.fixture(scope="module")
def page(record: dict[str, Any]) -> str:
    return html_page(record)


@pytest.mark.parametrize("form", ["txt", "md", "html", "json"])
@pytest.mark.parametrize("missing", ["id", "records", "routes"])
def test_record_without_a_key_is_refused(form, missing, record, tmp_path, refused):
    broken = copy.deepcopy(record)
    del broken["results"][0][missing]
    path = tmp_path / "broken.json"
    path.write_text(json.dumps(broken), encoding="utf-8")
    assert refused("report {} --format", path, form).count("\n") == 1


@pytest.mark.parametrize("form", ["txt", "md", "html"])
def test_reports_have_no_control_characters(form, tmp_path, run):
    text = "a\x1b[31m\u202e\x9b\u2066b"
    path, made = tmp_path / "record.json", tmp_path / f"report.{form}"
    path.write_text(json.dumps(hostile(text)), encoding="utf-8")
    printed = run("report {} --format", path, form, code=1)
    printed += run("report {} -o", path, made, code=1)
    for shown in (printed, made.read_text(encoding="utf-8")):
        assert r"\x1b" in shown
        assert all(c == "\n" or c.isprintable() for c in shown)


def hostile(text: str) -> dict[str, Any]:
    """A record in which every text that a run takes from elsewhere is the given one."""
    case = {"label": text, "values": [text, [1, text]], "holds": False, "covered": True}
    case |= {"note": text, "assumption": text, "instance": {"planes": [["1", "0"]], text: text}}
    result = {
        **dict.fromkeys(("id", "locator", "statement", "evidence", "meaning", "verdict"), text),
        **dict.fromkeys(("formula", "section", "file", "quantity"), text),
        "proof": [text, text],
        "prose": text,
        "badges": [{"names": [text], "meaning": text}],
        "views": [{"name": text, "caption": text, "options": {text: text}, "instance": None}],
        "expected": text,
        "as_expected": False,
        "hypotheses": [text],
        "saving_hypothesis": text,
        "routes": [text, text],
        "rows": True,
        "records": [case],
        "counterexample": case,
        "milliseconds": 3,
        "table": {"columns": ["a", text], "rows": [[1, text]]},
    }
    environment = {"python": text, "versions": {text: text}, "commit": text}
    return {
        **dict.fromkeys(("title", "about", "command", "date"), text),
        "schema_version": 1,
        "seed": 0,
        "as_expected": False,
        "environments": [environment],
        "results": [result],
    }


class Tags(HTMLParser):
    """Collects the tags and texts of a page, and checks that every tag is closed."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[str] = []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def test_the_record_says_with_what_and_how_everything_was_found(record):
    (environment,) = record["environments"]
    assert environment["python"] == sys.version.split()[0]
    assert {"slipstates", "numpy", "sympy"} <= set(environment["versions"])
    assert "commit" in environment
    assert record["seed"] == 3
    for id, result in zip(IDS, record["results"], strict=True):
        claim = registry()[id]
        assert result["hypotheses"] == list(claim.hypotheses)
        assert result["routes"] == [route.name for route in claim.routes]
        assert result["milliseconds"] >= 0
        assert all(len(case["values"]) == 2 for case in result["records"])
        assert all(case["instance"] for case in result["records"])


def test_the_record_has_no_float_and_survives_a_file(record):
    def refuse(text):
        raise AssertionError(f"a float: {text}")

    text = pages.FORMS[".json"](record)
    assert json.loads(text, parse_float=refuse, parse_constant=refuse) == record


def test_the_counterexample_in_the_record_can_be_checked_again(record):
    refuted = record["results"][1]["counterexample"]
    planes = Arrangement(refuted["instance"]["planes"])
    assert planes.f_vector[3] == refuted["values"][0] > len(planes) ** 2


@pytest.mark.parametrize("ending", [".md", ".html"])
def test_a_report_made_later_from_the_file_is_the_same(tmp_path, record, page, ending, run):
    source, later = tmp_path / "r.json", tmp_path / f"later{ending}"
    source.write_text(pages.FORMS[".json"](record), encoding="utf-8")
    run("report {} --output", source, later)
    text = later.read_text(encoding="utf-8")
    assert text == (page if ending == ".html" else pages.markdown(record))
    plain = text.replace("\\brk ", "").replace("{-}", "-")
    for id in IDS:
        assert id in plain
    assert "under the hypothesis" in plain
    assert "refuted" in plain


def test_the_page_asks_for_nothing_from_outside(page):
    found = Tags(page)
    assert found.open == []
    names = [name for name, _ in found.tags]
    assert not {*names} & {"img", "iframe", "object", "embed", "base", "form"}
    assert names.count("script") == 1
    assert [attrs for name, attrs in found.tags if name == "link"] == [
        {"rel": "icon", "href": "data:,"}
    ]
    for name, attrs in found.tags:
        assert not {key for key in attrs if key in ("src", "srcset") or key.startswith("on")}
        if name == "image":
            assert (attrs["xlink:href"] or "").startswith("data:image/png;base64,")
        if name == "a":
            link = attrs["href"] or ""
            inside = link.startswith("#") and f'id="{link[1:]}"' in page
            # Lessons and proofs, seen from the folder `report` of a checkout.
            assert inside or (ROOT / "report" / link).resolve().is_file(), link
    assert not re.search(r"https?:|url\((?!#)|@import", page)
    assert "svg" in names
    assert re.search(r"default-src 'none'.*script-src 'sha256-", page)
    names_of = [attrs["id"] for _, attrs in found.tags if "id" in attrs]
    assert len(names_of) == len(set(names_of))


@pytest.mark.parametrize(
    "text", ["<script>alert(1)</script>", '"><img src=x onerror=y>', "a|b\n\n# c", "&amp;", "]]>"]
)
def test_texts_of_a_record_stay_texts_in_the_page(text):
    page = html_page(hostile(text))
    found = Tags(page)
    assert found.open == []
    assert [name for name, _ in found.tags].count("script") == 1
    assert "img" not in {name for name, _ in found.tags}
    assert text in "".join(found.texts)


def test_the_bar_says_what_the_record_says(record, page):
    found = re.findall(r'<span class="(\w+)" style="flex-grow:(\d+)"><b>(\d+)</b>', page)
    words = [result["strength"] for result in record["results"]]
    shown = {"proved": "proved", "refuted": "refuted"}
    assert [(shown[css], int(grow), int(number)) for css, grow, number in found] == [
        (word, words.count(word), words.count(word)) for word in ("proved", "refuted")
    ]
    both = copy.deepcopy(record)
    both["results"][0]["verdict"] = None
    assert "1 no verdict" in html_page(both)


def test_a_card_has_statement_formula_routes_picture_and_python(record, page):
    for result in record["results"]:
        card = page.partition(f'id="{result["id"]}"')[2].partition("</article>")[0]
        assert mathml(result["formula"]) in card
        assert "<svg" in card
        card = html.unescape(card)
        assert result["statement"] in card
        assert all(route in card for route in result["routes"])
        assert value_text(result["counterexample"]["values"][1]) in card
        assert python_lines(result) in card


@pytest.mark.parametrize(("seed", "call"), [(0, "]"), (3, "], 3"), (None, "]")])
def test_page_has_the_seed_and_cards_pass_it_on(seed, call, record):
    results = [{**result, "seed": seed} for result in record["results"]]
    page = html_page({**record, "results": results, "seed": seed or 0})
    assert f"<dt>seed</dt><dd>{seed or 0}</dd>" in page
    assert html.unescape(page).count(f"{call})\nprint(") == len(results)


@pytest.mark.parametrize("command", ["", "proofs-check report", None])
def test_markdown_has_a_command_where_the_record_does(command, record):
    kept = {key: value for key, value in record.items() if key != "command"}
    text = pages.markdown(kept if command is None else {**kept, "command": command})
    lines = [line for line in text.splitlines() if line.startswith("- command")]
    assert lines == ([f"- command: {command}"] if command else [])


def test_markdown_has_the_instances_of_counterexamples(record):
    found = [one["counterexample"] for one in record["results"] if one["counterexample"]]
    instances = [json.dumps(one["instance"]) for one in found if one["instance"]]
    lines = pages.markdown(record).splitlines()
    assert instances
    assert [line for line in lines if line.startswith("{")] == instances


@pytest.mark.slow
def test_the_python_of_a_card_gives_its_verdict(record, tmp_path, monkeypatch, run):
    monkeypatch.chdir(tmp_path)
    run("new mine")
    run("report mine.py -o mine.json --seed 2")
    own = json.loads((tmp_path / "mine.json").read_text(encoding="utf-8"))
    for result in (*record["results"], *own["results"]):
        lines = python_lines(result)
        assert lines.count("\n") == 2
        (tmp_path / "again.py").write_text(lines, encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            runpy.run_path("again.py")
        verdict, _, counterexample = said.getvalue().partition("\n")
        assert verdict == result["verdict"]
        assert (counterexample.strip() == "None") == (result["counterexample"] is None)


def test_without_matplotlib_the_page_says_what_is_missing(record, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    page = html_page(record)
    assert "<svg" not in page
    assert page.count("pip install") == len(record["results"])


def test_a_run_repeats_its_page_but_for_times(tmp_path, monkeypatch, run):
    made = []
    for epoch in ("0", "86400"):
        monkeypatch.setenv("SOURCE_DATE_EPOCH", epoch)
        path = tmp_path / "r.html"
        run("run {} --output", IDS[1], path)
        text = path.read_text(encoding="utf-8")
        made.append(re.sub(r'<span class="time">\d+ ms</span>', "", text))
    assert "1970-01-01T00:00:00Z" in made[0]
    assert made[1] == made[0].replace("1970-01-01", "1970-01-02")


def test_every_formula_and_every_proof_of_the_registry_is_there():
    proofs = (ROOT / "docs" / "proofs.rst").read_text(encoding="utf-8")
    for claim in registry():
        assert not claim.formula or mathml(claim.formula).startswith("<math")
        assert (claim.kind is Kind.PROVED) == (claim.proof is not None), claim.id
        if claim.proof:
            section, words = claim.proof
            text = re.split(rf"^{section}\n-+\n", proofs, flags=re.MULTILINE)[1]
            assert f"**{words}" in re.split(r"^-+$", text, flags=re.MULTILINE)[0], claim.id


def test_every_view_of_the_registry_gives_a_picture():
    for claim in registry():
        if claim.views and claim.views[0].instance:
            shown = {"id": claim.id, "views": report.claim_record(claim)["views"]}
            assert len(list(pictures(shown))) == len(claim.views), claim.id


@pytest.mark.parametrize(
    "text",
    [
        "a^",
        "}",
        "{",
        "^2",
        r"\input{x}",
        "a<b",
        r"\frac{1}",
        "x$",
        r"\text{$}",
        "{" * 500,
        "a\\\\b",
        "a^{b",
        r"\binom12",
    ],
)
def test_what_is_no_formula_is_refused_and_stays_text(text):
    with pytest.raises(InputError):
        mathml(text)
    changed = hostile("x")
    changed["results"][0]["formula"] = text
    assert f"<code>{html.escape(text)}</code>" in html_page(changed)
    assert f"${text}$" not in pages.markdown(changed)


@pytest.mark.parametrize("text", ["a|b", "a\n| b |\n\n# c", "a\\|b", "`x` <b>"])
def test_texts_of_a_record_do_not_break_a_markdown_table(text):
    lines = pages.markdown(hostile(text)).splitlines()
    assert [k for k, line in enumerate(lines) if line.startswith("# ")] == [0]
    tables = [line for line in lines if line.startswith("|")]
    # Ends of cells are bars that an even number of backslashes (so none of its own) goes before.
    widths = [len(re.findall(r"(?<!\\)(?:\\\\)*\|", line)) for line in tables]
    assert widths[:3] == [5, 5, 5]
    assert "<b>" not in pages.markdown(hostile(text)).split("```")[0]


def test_the_digest_of_a_report_is_that_of_what_was_found(record, page):
    changed = copy.deepcopy(record)
    changed["date"], changed["results"][0]["milliseconds"] = "later", 10**6
    assert report.digest(changed) == report.digest(record)
    changed["results"][0]["records"][0]["values"][0] = "another"
    assert report.digest(changed) != report.digest(record)
    for made in (pages.markdown(record), page):
        assert report.digest(record) in made


@pytest.mark.parametrize("ending", [".pdf", ".tex"])
def test_a_report_is_printed_from_its_page(ending, tmp_path, refused, record):
    source = tmp_path / "r.json"
    source.write_text(json.dumps(record), encoding="utf-8")
    for command in (["run", "euler"], ["report", str(source)]):
        error = refused(*command, "-o", tmp_path / f"r{ending}")
        assert "write .html and print it from a browser" in error
    assert [path.name for path in tmp_path.iterdir()] == ["r.json"]


def test_an_unexpected_verdict_is_seen_in_every_form(tmp_path, record, page, run):
    changed = json.loads(json.dumps(record))
    changed["as_expected"] = changed["results"][0]["as_expected"] = False
    for make, expected in ((pages.markdown, pages.markdown(record)), (html_page, page)):
        assert "(expected: refuted)" in make(changed)
        assert "(expected: refuted)" not in expected
    path = tmp_path / "r.json"
    path.write_text(json.dumps(changed), encoding="utf-8")
    assert "some verdict differs" in run("report", path, code=1)


def test_invalid_numbers_in_a_record_are_refused_at_once(tmp_path, refused):
    content = hostile("x")
    content["results"][0]["counterexample"]["instance"] = {"planes": [["1e999999999", "0", "1"]]}
    path = tmp_path / "r.json"
    path.write_text(json.dumps(content), encoding="utf-8")
    assert refused("report {} --output", path, tmp_path / "r.html").startswith("error: ")
    assert not (tmp_path / "r.html").exists()


def drawn(instance: dict[str, Any] | None) -> list[str]:
    """Return the names of the elements of each picture of a counterexample."""
    counterexample = {"instance": instance} if instance else None
    result = {"id": "some-id", "counterexample": counterexample}
    names = []
    for svg, _ in pictures(result):
        ET.fromstring(svg.replace("xlink:", ""))
        found = re.findall(r' id="([^"]*)"', svg)
        assert all(name.startswith("some-id-0-") for name in found)
        names.append(" ".join(name.removeprefix("some-id-0-") for name in found))
    return names


def test_planes_are_drawn_with_their_dual():
    for planes in (generic(5), Arrangement([[3, -4, 6], [10**40, 1, 0], [0, 0, -1]])):
        (names,) = drawn(dict(planes.to_dict()))
        edges = re.findall(r"edge-\d+", names)
        assert len(edges) == planes.f_vector[2]


def test_grasp_drawn_with_equilibrium_or_proof():
    document = dict(read_grasp("paper-three-contacts").to_dict())
    (alone,) = drawn(document)
    assert "cone-3" in alone
    assert "force-" not in alone
    (held,) = drawn({**document, "wrench": ["0", "-1", "0"]})
    assert "force-2" in held
    (refused,) = drawn({**document, "wrench": ["0", "1", "0"]})
    assert "1-region-1" in refused
    assert "force-2" not in refused


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_commit_is_that_of_the_checkout(tmp_path, monkeypatch):
    monkeypatch.delenv("GIT_DIR", raising=False)

    def git(*arguments):
        who = ["-c", "user.name=n", "-c", "user.email=e@example.org"]
        done = subprocess.run(
            ["git", "-C", str(tmp_path), *who, *arguments],
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.strip()

    assert commit(tmp_path) is None
    git("init", "-q")
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "f").write_text("1", encoding="utf-8")
    git("add", ".")
    git("commit", "-q", "-m", "m")
    assert commit(tmp_path) == git("rev-parse", "HEAD")
    assert commit(tmp_path / "inside") is None
    (tmp_path / "inside" / "f").write_text("2", encoding="utf-8")
    assert commit(tmp_path) == f"{git('rev-parse', 'HEAD')}+changes"


def test_lines_of_the_plane_are_called_lines():
    assert report.instance_text({"planes": [["1", "0"], ["0", "1"]]}) == "lines (1,0) (0,1)"
    assert report.instance_text({"planes": [["1", "0", "0"]]}) == "planes (1,0,0)"


def test_claims_left_out_stand_apart_from_the_source(record):
    """In every form in a line of their own."""
    source = "Robotics: Science and Systems, 2018"
    shorter = {**record, "about": source, "left_out": ["large-regions-in-print"]}
    page = html_page(shorter)
    assert f"<p>{source}</p>" in page
    assert "Left out, as --large is not given: large-regions-in-print.</p>" in page
    line = "left out, as --large is not given: large-regions-in-print"
    assert line in pages.FORMS[".txt"](shorter).splitlines()
    assert line.replace("_", "\\_") in pages.FORMS[".md"](shorter).splitlines()
    assert all("eft out, as" not in pages.FORMS[end](record) for end in (".txt", ".md", ".html"))
