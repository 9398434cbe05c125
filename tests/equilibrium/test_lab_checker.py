"""The deciding modules of the slip lab against the solver and the checker of certificates.

They run in node where there is one, else in Chromium.
"""

import json
import random
import shutil
import subprocess
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from arrangement import InputError
from equilibrium import Contact, Grasp, solve
from equilibrium.certificate.checker import check
from equilibrium.decide.as_printed import OPTIONS
from equilibrium.methods.registry import METHODS
from equilibrium.pictures.lab.page import DECIDES, lab_page
from tests.equilibrium.mutations import mutants
from tests.equilibrium.test_lab import Question, questions, texts
from tests.javascript.check import node, paths

CORE = Path(__file__).parent.parent / "javascript" / "core.mjs"
#: Asks for answers to questions by a method (the full model is ""), and reports on documents.
Ask = Callable[[list[Question], list[Any], str], tuple[list[Any], list[Any]]]

IN_PAGE = """
const [questions, certificates, method] = arguments;
const attempt = (action) => { try { return action(); } catch (e) { return { error: e.message }; } };
return { answers: questions.map(([grasp, wrench]) => attempt(() => (method
    ? { stable: lab.says(method, grasp, wrench) } : lab.solve(grasp, wrench)))),
  reports: certificates.map((document) => attempt(() => lab.check(document))) };
"""


@pytest.fixture
def ask(request: pytest.FixtureRequest, tmp_path: Path) -> Ask:
    """Return what puts questions and certificates to the modules of the page."""
    modules = [str(path.resolve()) for path in paths(DECIDES)]
    opened = None
    if not node():
        opened = request.getfixturevalue("browser")
        opened.show(lab_page(), tmp_path)

    def run(
        asked: list[Question], documents: list[Any], method: str
    ) -> tuple[list[Any], list[Any]]:
        put = [[grasp.to_dict(), texts(wrench)] for grasp, wrench in asked]
        if opened:
            found = opened.run(IN_PAGE, put, documents, method)
        else:
            form = {"questions": put, "certificates": documents, "method": method}
            text = json.dumps({**form, "modules": modules})
            program = shutil.which("node") or ""
            done = subprocess.run(
                [program, str(CORE)], input=text, capture_output=True, text=True, check=True
            )
            found = json.loads(done.stdout)
        return found["answers"], found["reports"]

    return run


def rare(number: int, seed: int) -> list[Question]:
    """Return grasps far away, tiny and huge, coincident, and wrenches at boundaries."""
    rng = random.Random(seed)
    sizes = [Fraction(1), Fraction(10**12), Fraction(1, 10**9), Fraction(7, 3)]
    found: list[Question] = []
    for grasp, wrench in questions(number, seed, most=4):
        size, force = rng.choice(sizes), rng.choice(sizes)
        contacts = [
            Contact(
                [x * size for x in c.point],
                c.normal,
                c.friction,
                c.stiffness * force / size,
                c.preload * force,
            )
            for c in grasp
        ]
        (x, y, turn), hair = wrench, Fraction(rng.choice([0, 0, 1, -1]), 10**30)
        found.append((Grasp(contacts), [x * force * (1 + hair), y * force, turn * force * size]))
    return found


def assert_agreement(asked: list[Question], ask: Ask) -> None:
    """Compare verdicts, and check the proofs of each side by the other side's checker."""
    verdicts = [solve(grasp, wrench) for grasp, wrench in asked]
    documents = [verdict.certificate.to_dict() for verdict in verdicts]
    answers, reports = ask(asked, documents, "")
    for (grasp, wrench), verdict, answer, report in zip(
        asked, verdicts, answers, reports, strict=True
    ):
        assert answer.get("stable") == verdict.stable, (grasp, wrench, answer)
        assert check(answer["certificate"], question=(grasp, tuple(wrench)))
        assert report.get("valid"), (grasp, wrench, report)
        assert report["leaves"] == check(verdict.certificate.to_dict()).leaves


def test_verdicts_and_proofs_agree_on_both_sides(ask):
    assert_agreement([*questions(16, seed=21), *rare(9, seed=22)], ask)


@pytest.mark.slow
def test_many_verdicts_agree(ask):
    assert_agreement([*questions(80, 100, most=5), *rare(50, 200)], ask)


def region_proofs() -> list[dict[str, Any]]:
    """Return proofs of the solver that cut the space of motions by orthants and by edges."""
    found = []
    for grasp, wrench in questions(200, seed=23):
        verdict = solve(grasp, wrench)
        document = verdict.certificate.to_dict()
        if not verdict.stable and '"edge"' in json.dumps(document):
            found.append(document)
        if len(found) == 8:
            return found
    pytest.fail("too few proofs have edges")


def test_changed_proofs_are_refused_by_both_checkers_alike(ask):
    sources = [solve(*question).certificate.to_dict() for question in questions(9, seed=24)]
    documents = [
        changed
        for k, document in enumerate([*sources, *region_proofs()])
        for _, change, changed in mutants(document, 12, k)
        if change != "float"  # 1.0 is read as 1 there
    ]
    _, reports = ask([], documents, "")
    seen = set()
    for document, report in zip(documents, reports, strict=True):
        try:
            expected = bool(check(document))
        except InputError:
            assert "error" in report, (document, report)
            seen.add("error")
            continue
        # A constant force, without stiffness, is not for the lab.
        if not any(Fraction(c.get("stiffness", 1)) == 0 for c in document["grasp"]["contacts"]):
            assert report.get("valid") == expected, (document, report)
            seen.add(str(expected))
    assert seen == {"True", "False", "error"}


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"schema_version": 2}, "not a certificate"),
        ({"certificate": "stable"}, "not a certificate"),
        ({"wrench": ["0", "1"]}, "three numbers"),
        ({"wrench": ["0", 0.5, "0"]}, "the wrench must be a text"),
        ({"tree": {"leaf": []}}, "a node is a list"),
        ({"tree": {"orthants": [["1", "0", "0"]]}}, "list of 8"),
        ({"tree": {"edge": [0, 1], "children": [["1", "0", "0"]] * 2}}, "cone of four"),
        ({"tree": {"virtual_motion": ["1", "0", "0"], "multipliers": {"9": ["1"]}}}, "0 to 2"),
        ({"tree": {"contact": 0, "attachment": {"detached": ["1", "0", "0"]}}}, "detached, att"),
        (
            {"tree": {"contact": 0, "slip": dict.fromkeys(("stick", "slip+", "slip-"), ["0"] * 3)}},
            "contact 1 is not attached",
        ),
        ({"tree": {"orthants": [["1", "0", "0"]] * 8, "more": 1}}, 'no "more"'),
    ],
)
def test_what_is_no_certificate_is_explained(change, why, ask):
    contacts = [
        Contact([-1, 0], [1, 0], 1),
        Contact([1, 0], [-1, 0], 1),
        Contact([0, 1], [0, 1], 1),
    ]
    document = solve(Grasp(contacts), [0, 1, 0]).certificate.to_dict()
    _, (report,) = ask([], [{**document, **change}], "")
    assert why in report["error"]


@pytest.mark.parametrize("method", ["cones", "wrench-space", "printed"])
def test_compared_methods_say_what_they_say_in_python(method, ask):
    asked = questions(16, seed=25)
    answers, _ = ask(asked, [], method)
    # The page merges coincident planes.
    options = [name for name in OPTIONS if name != "coincident-planes"]
    for (grasp, wrench), answer in zip(asked, answers, strict=True):
        decide = METHODS[method].decide
        assert decide is not None
        expected = (
            solve(grasp, wrench, as_printed=options).stable
            if method == "printed"
            else decide(grasp, tuple(wrench))[0]
        )
        assert answer["stable"] == expected, (grasp, wrench)
