"""The arrangement lab, opened in headless Chromium: its counts against the enumerators."""

import json
import random
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement, InputError, families, read_arrangement
from arrangement.counts import characteristic_polynomial, t_vector
from arrangement.enumeration.regions import walls
from arrangement.library.census import census
from arrangement.pictures.lab.lines import lab_page, line_exercises
from tests.browser import Browser

Rows = Sequence[Sequence[int]]


def arrangements(number: int, seed: int, most: int = 9) -> list[Arrangement]:
    """Return random lines and central planes: generic, degenerate, coincident, of low rank, few."""
    rng = random.Random(seed)
    found = []
    for _ in range(number):
        dimension, size = rng.choice([2, 3, 3]), rng.choice([1, 1, 2, 3, 9])
        rows: list[list[int]] = []
        for _ in range(rng.randint(0, most)):
            row = [rng.randint(-size, size) for _ in range(3)]
            if any(row[:dimension]):
                rows.append(row)
        if rng.random() < 0.15:  # all through a point, or all through a line
            rows = [[a, b, 0] for a, b, _ in rows if a or b]
        if rows and rng.random() < 0.2:
            rows.append([-2 * x for x in rows[0]])
        found.append(made(dimension, rows))
    return found


def made(dimension: int, rows: Rows) -> Arrangement:
    offsets = [row[2] for row in rows] if dimension == 2 else None
    return Arrangement([row[:dimension] for row in rows], offsets, dimension=dimension)


def expected(planes: Arrangement) -> dict[str, Any]:
    """Return what the page should say, by the enumerators and the counts."""
    texts = [{str(k): n for k, n in v.items()} for v in (t_vector(planes), planes.p_vector)]
    return {
        "planes": len(planes),
        "distinct_planes": len(planes.distinct),
        "dimension": planes.dimension,
        "rank": planes.rank,
        "f_vector": list(planes.faces().f_vector),
        "regions": planes.f_vector[-1],
        "bounded_regions": len(planes.bounded_regions()),
        "characteristic_polynomial": list(map(int, characteristic_polynomial(planes).all_coeffs())),
        "t_vector": texts[0],
        "p_vector": texts[1],
        "simple": planes.is_simple,
        "simplicial": planes.is_simplicial,
        "triangles": triangles(planes),
    }


def triangles(planes: Arrangement) -> int:
    """Return how many regions of the projective plane, or bounded ones, have three sides."""
    if planes.dimension == 3:
        return planes.p_vector.get(3, 0) // 2 if planes.rank == 3 else 0
    bounded = {region.signs for region in planes.bounded_regions()}
    sides = zip(planes.regions(), walls(planes, planes.faces()), strict=True)
    return sum(region.signs in bounded and len(found) == 3 for region, found in sides)


def counted(browser: Browser, listed: Sequence[Arrangement]) -> list[dict[str, Any]]:
    documents = [planes.to_dict() for planes in listed]
    found: list[dict[str, Any]] = browser.run("return arguments[0].map(lab.count)", documents)
    return found


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the file of the lab of five lines."""
    path = tmp_path_factory.mktemp("lab") / "lab.html"
    path.write_text(lab_page(), encoding="utf-8")
    return path


@pytest.fixture
def opened(browser: Browser, page: Path) -> Browser:
    """Return the browser with that page."""
    browser.open(page, 1280, 1000)
    browser.settled()
    return browser


def assert_agreement(browser: Browser, listed: Sequence[Arrangement]) -> None:
    for planes, answer in zip(listed, counted(browser, listed), strict=True):
        answer.pop("type")
        assert answer == expected(planes), planes.to_dict()


def test_its_counts_are_those_of_the_enumerators(opened):
    assert_agreement(opened, arrangements(150, seed=1))


@pytest.mark.slow
def test_its_counts_are_those_of_the_enumerators_on_hundreds(opened):
    assert_agreement(opened, arrangements(250, seed=100, most=14))


def transformed(planes: Arrangement, rng: random.Random) -> Arrangement:
    """Return an arrangement of the same type: planes in another order, turned over, sheared."""
    flips = [rng.choice([-1, 1]) for _ in planes.normals]
    rows = [[s * int(x) for x in row] for s, row in zip(flips, planes.normals, strict=True)]
    rng.shuffle(rows)
    for _ in range(4):
        i, j = rng.sample(range(3), 2)
        factor = rng.choice([-2, -1, 1, 2])
        for row in rows:
            row[i] += factor * row[j]
    if rng.random() < 0.5:
        rows = [[-row[0], *row[1:]] for row in rows]
    return Arrangement(rows)


def test_it_names_every_type_of_up_to_six_planes(opened):
    """By a canonical form of its own; the census distinguishes types by their tope graphs."""
    rng = random.Random(2)
    listed = [
        (transformed(planes, rng), f"{m}.{k}")
        for m in range(3, 7)
        for k, planes in enumerate(census(m), 1)
        for _ in range(4)
    ]
    answers = counted(opened, [planes for planes, _ in listed])
    assert [answer["type"] for answer in answers] == [name for _, name in listed]


def test_simplicial_planes_have_their_number_in_the_catalogue(opened):
    rng = random.Random(3)
    entries = [entry for entry in families.simplicial_entries() if 6 < entry[0] <= 20]
    known = [entry for entry in entries if families.simplicial(*entry).field is None]
    rational = families.simplicial_entries(rational=True)
    assert known == [entry for entry in rational if entry in entries]
    listed = [transformed(families.simplicial(*entry), rng) for entry in known]
    names = [answer["type"] for answer in counted(opened, listed)]
    assert names == [f"A({m},{k})" for m, k in known]
    others = [read_arrangement("reflection-b3"), read_arrangement("nine-generic-planes")]
    assert [answer["type"] for answer in counted(opened, others)] == ["A(9,1)", None]


def test_the_mirrors_of_the_cube_are_called_by_their_name(browser, tmp_path):
    browser.show(lab_page(read_arrangement("reflection-b3")), tmp_path)
    assert fact(browser, "type") == "A(9,1), mirrors of the cube B₃"


def shown(browser: Browser) -> Arrangement:
    """Return the arrangement of the address."""
    version, dimension, rows = browser.run("return location.hash.slice(1)").split("|")
    assert version == "1"
    parts = [row.split(",") for row in rows.split(";") if row]
    offsets = [row[2] for row in parts] if dimension == "2" else None
    return Arrangement([row[: int(dimension)] for row in parts], offsets, dimension=int(dimension))


def fact(browser: Browser, name: str) -> str:
    text: str = browser.run(
        "return [...document.querySelectorAll('#counts dt')].find((e) => e.textContent === "
        "arguments[0]).nextElementSibling.textContent",
        name,
    )
    return text


def assert_right(browser: Browser) -> None:
    """Check what the page shows of its own arrangement."""
    browser.settled()
    planes = shown(browser)
    assert fact(browser, "f-vector") == f"({', '.join(map(str, planes.f_vector))})"
    assert fact(browser, "simple") == ("yes" if planes.is_simple else "no")
    assert fact(browser, "simplicial") == ("yes" if planes.is_simplicial else "no")
    assert "✓" in fact(browser, "|χ(−1)|")
    said = browser.text("said")
    assert f"f-vector {' '.join(map(str, planes.f_vector))}" in said


def grip(browser: Browser, name: str) -> tuple[float, float]:
    """Return a place of the window where a grip can be taken: a third along it, if it is a line."""
    x, y = browser.run(
        "const group = document.querySelector(`[data-grip='${arguments[0]}']`);"
        "const knob = group.querySelector('.knob'), path = group.querySelector('.target');"
        "if (knob) { const r = knob.getBoundingClientRect();"
        "  return [r.x + r.width / 2, r.y + r.height / 2]; }"
        "const p = path.getPointAtLength(path.getTotalLength() * 0.37)"
        "  .matrixTransform(path.getScreenCTM());"
        "return [p.x, p.y];",
        name,
    )
    return x, y


@pytest.mark.parametrize("name", ["end-1-0", "line-3", "circle-1"])
def test_dragging_by_mouse_and_finger_keeps_counts_right(name, opened):
    before = shown(opened)
    x, y = grip(opened, name)
    opened.drag((x, y), (x + 34, y + 25))
    assert_right(opened)
    moved = shown(opened)
    k = int(name.split("-")[1])
    assert [i for i in range(5) if moved.normals[i] != before.normals[i]] == [k]
    x, y = grip(opened, name)
    opened.fingers([(x, y)], [(x - 20, y + 12)], [(x - 40, y + 44)])
    assert_right(opened)
    assert shown(opened) not in (before, moved)
    opened.run("document.getElementById('undo').click()")
    assert shown(opened) == moved
    assert opened.messages() == []


def test_an_end_dragged_near_a_crossing_goes_through_it(opened):
    """Exactly: crossings of three lines cannot be hit by hand otherwise."""
    x, y = middle(opened, "point-2")
    opened.drag(grip(opened, "end-4-0"), (x + 3, y + 2))
    assert_right(opened)
    assert t_vector(shown(opened))[3] == 1


def test_all_can_be_done_with_keys(opened):
    for name, keys in {
        "end-1-0": ["ArrowUp", "ArrowLeft", "["],
        "line-2": ["ArrowUp", "ArrowDown", "[", "]"],
        "circle-3": ["ArrowUp", "ArrowRight", "[", "]"],
    }.items():
        opened.run("document.querySelector(`[data-grip='${arguments[0]}']`).focus()", name)
        for key in keys:
            before = shown(opened)
            opened.key(key)
            assert shown(opened) != before, (name, key)
            assert_right(opened)
            assert opened.run("return document.activeElement.dataset.grip") == name
    opened.key("Delete")
    assert len(shown(opened)) == 4
    opened.run("document.getElementById('plane').focus()")
    opened.key("n")
    assert opened.text("said").startswith("A region")
    assert all(marks(opened))
    opened.key("v")
    assert opened.text("lit-words").startswith("A crossing")


def marks(browser: Browser) -> list[str | None]:
    """Return what is marked in each view."""
    found: list[str | None] = browser.run(
        "return ['plane', 'ball', 'dual']"
        ".map((id) => document.querySelector(`#${id} .lit`)?.dataset.mark ?? null)"
    )
    return found


def middle(browser: Browser, mark: str) -> tuple[float, float]:
    return browser.middle(f"#plane [data-mark='{mark}'] circle")


def test_what_is_under_the_pointer_is_marked_in_all_views(opened):
    """And its sign vector, shown in the order of the planes, is right."""
    for mark, place in {
        "line-2": grip(opened, "line-2"),
        "point-3": middle(opened, "point-3"),
    }.items():
        opened.pointer("mouseMoved", *place)
        assert marks(opened) == [mark] * 3
    said = opened.text("lit-words")
    point = [int(x.replace("\u2212", "-")) for x in said.split("(")[1].split(")")[0].split(" : ")]
    signs = "".join("\u22120+"[s + 1] for s in shown(opened).signs_at(point))
    assert f": signs {signs}; " in said


def test_one_plane_after_another_with_deletion_and_restriction(opened):
    opened.put("algorithm", "planes")
    planes = shown(opened)
    for k in range(1, 6):
        opened.settled()
        first = Arrangement(planes.normals[:k])
        cells = opened.texts("#told tr:nth-child(2) td")
        before, here, now = (int(text.lstrip("+= ")) for text in cells)
        assert now == before + here == first.f_vector[-1]
        assert fact(opened, "f-vector") == f"({', '.join(map(str, first.f_vector))})"
        opened.run("document.getElementById('step').click()")
    opened.run("document.getElementById('back').click()")
    opened.settled()
    assert fact(opened, "planes") == "4"


def checked(browser: Browser) -> str:
    """Let the page check the exercise, and return what it says in the end."""
    said: str = browser.driver.execute_async_script(
        "const [done] = arguments; document.getElementById('exercise-check').click();"
        "const said = document.getElementById('exercise-said'); const look = () => {"
        "if (said.ariaBusy === 'true') setTimeout(look, 5); else done(said.textContent); }; look();"
    )
    return said


def solutions() -> dict[str, str]:
    """Return for each built-in exercise a link that solves it."""
    text = (Path(__file__).parent / "lab_solutions.json").read_text(encoding="utf-8")
    found: dict[str, str] = json.loads(text)
    return found


def test_exercise_solved_by_its_own_solution_only(opened):
    names = opened.texts("#exercise option")[1:]
    solved = solutions()
    assert [name.partition(". ")[2] for name in names] == list(solved)
    assert len(names) >= 8
    for k, name in enumerate(solved):
        opened.put("exercise", k)
        assert checked(opened)[0] == "✗", name
        for link in (list(solved.values())[k - 1], solved[name]):
            opened.put("exercise", k)
            opened.run("location.hash = arguments[0]", link)
            opened.settled()
            assert checked(opened)[0] == ("✓" if link == solved[name] else "✗"), name
    done = opened.text("exercise-done")
    assert done == f"{len(solved)} of {len(solved)} solved"
    assert opened.messages() == []


@pytest.mark.parametrize("name", ["Break Pappus’ theorem", "Break Desargues’ theorem"])
def test_a_theorem_that_closes_closes_for_every_attempt(name, opened):
    """The last three lines meet, by the exact determinant, whenever the attempt is valid."""
    k = list(solutions()).index(name)
    opened.put("exercise", k)
    opened.run("location.hash = arguments[0]", solutions()[name])
    opened.settled()
    assert "meet in a point again" in checked(opened)


def link(planes: Arrangement) -> str:
    ends = planes.offsets if planes.dimension == 2 else [None] * len(planes)
    rows = [
        [*normal, *([] if end is None else [end])]
        for normal, end in zip(planes.normals, ends, strict=True)
    ]
    return f"1|{planes.dimension}|{';'.join(','.join(map(str, row)) for row in rows)}"


@pytest.mark.slow
def test_unusual_arrangements_are_shown(browser, page):
    for planes in (
        made(3, []),
        made(2, []),
        made(3, [[1, 0, 0]]),
        made(2, [[1, 0, 3]]),
        made(3, [[1, 0, 0], [0, 0, 1]]),
        made(2, [[1, 0, 0], [1, 0, 1], [2, 0, 2]]),
        made(3, [[0, 0, 1], [1, 0, 0], [0, 1, 0], [1, 1, 1]]),
        made(3, [[10**40, 1, 0], [10**40 + 1, 1, 0], [1, 10**40, 7]]),
        families.generic(20),
    ):
        browser.open(f"{page.as_uri()}#{link(planes)}")
        assert_right(browser)
        if len(planes) < 20:
            browser.run("document.getElementById('add').click()")
            assert len(shown(browser)) == len(planes) + 1
            assert_right(browser)
        assert browser.messages() == []


def test_what_must_stay_must_stay(opened):
    name = "Few ordinary points"
    k = list(solutions()).index(name)
    opened.put("exercise", k)
    # the same arrangement, but line 1 turned into line 2
    opened.run("location.hash = arguments[0]", exchanged(solutions()[name]))
    opened.settled()
    assert checked(opened).startswith("✗ Not yet. Line 1 must stay")


def exchanged(text: str) -> str:
    head, _, rows = text.rpartition("|")
    first, second, *others = rows.split(";")
    return f"{head}|{';'.join([second, first, *others])}"


def test_other_spaces_shown_by_essentialisation():
    assert '"planes":[["1","0","0"]' in lab_page(read_arrangement("braid-a3-in-r4"))


@pytest.mark.parametrize(
    ("planes", "why"),
    [
        (families.generic(21), "21 planes in the lab; at most 20"),
        (families.regular(10), r"entries in Q\(a\) with a\^2 - 5 = 0.*counts in integers"),
        (made(3, [[10**1000, 1, 0]]), "1,001 digits of a number on a page"),
        (Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [1, 0, 0]), "affine planes of rank 3"),
        (families.coordinate(4), "central planes of rank 4"),
    ],
)
def test_what_it_cannot_show_is_refused(planes, why):
    with pytest.raises(InputError, match=why):
        lab_page(planes)


@pytest.mark.parametrize(
    ("goal", "message"),
    [
        ('{"counts": {"regions": LONG}}', "5,001 digits of a number on a page"),
        ('{"counts": {"t_vector": {"3": LONG}}}', "5,001 digits of a number on a page"),
        ('{"meet": [[1, 2, LONG]]}', "give lists of three plane numbers"),
    ],
)
def test_long_numbers_of_exercises_are_refused(goal, message, tmp_path):
    exercise = {"name": "n", "task": "t", "start": "1|3|1,0,0;0,1,0;0,0,1", "goal": "GOAL"}
    text = json.dumps({"schema_version": 1, "exercises": [exercise]})
    path = tmp_path / "exercises.json"
    path.write_text(text.replace('"GOAL"', goal.replace("LONG", "1" + "0" * 5000)))
    with pytest.raises(InputError, match=f"exercise 1: goal .*{message}"):
        line_exercises(path)
