"""The interactive page of an arrangement, opened in headless Chromium."""

import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from arrangement import Arrangement, families, read_arrangement
from arrangement.numbers.exact import sign_text
from arrangement.pictures import arrangement_page, cells_page
from arrangement.pictures.names import equation
from tests.arrangement.test_lab import arrangements
from tests.browser import Browser

#: Regions, arcs and crossings, from the literature: coordinate planes (cube), A3 (permutohedron),
#: B3 (truncated cuboctahedron), m generic planes (m^2 - m + 2), pencils.
KNOWN = {
    "coordinate-planes": (8, 12, 6),
    "braid-a3": (24, 36, 14),
    "reflection-b3": (48, 72, 26),
    "nine-generic-planes": (74, 144, 72),
    "pencil": (10, 10, 2),
    "coincident-planes": (4, 4, 2),
    "paper-four-contacts": (4, 4, 2),
}

Opened = Callable[..., None]


@pytest.fixture
def opened(browser: Browser, tmp_path: Path) -> Opened:
    """Return a function that writes the page of an arrangement and opens it."""

    def open_page(source: str | Arrangement, **options: Any) -> None:
        planes = read_arrangement(source) if isinstance(source, str) else source
        browser.show(arrangement_page(planes, **options), tmp_path)

    return open_page


def counts(browser: Browser) -> tuple[int, ...]:
    text = browser.text("ball-counts")
    return tuple(map(int, re.findall(r"\d+", text)))


def dual_counts(browser: Browser) -> tuple[int, ...]:
    text = browser.text("dual-counts")
    return tuple(map(int, re.findall(r"\d+", text)))


def facts(browser: Browser) -> dict[str, str]:
    """Return what the page says about what is chosen."""
    names = browser.texts("#chosen dt")
    values = browser.texts("#chosen dd")
    return dict(zip(names, values, strict=True))


def vector(text: str) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, text.replace("\u2212", "-").strip("()").split(", ")))


def signs(text: str) -> tuple[int, ...]:
    return tuple({"+": 1, "\u2212": -1, "0": 0}[sign] for sign in text)


def listed(browser: Browser) -> set[str]:
    """Return the sign vectors of all regions; a plane that was taken away has a dot."""
    return set(browser.texts("#regions option")[1:])


def expected(planes: Arrangement) -> set[str]:
    return {sign_text(face.signs, "\u2212") or "(no plane)" for face in planes.regions()}


@pytest.mark.parametrize("name", KNOWN)
def test_the_page_shows_every_cell_and_stays_silent(name, browser, opened):
    opened(name)
    assert counts(browser) == dual_counts(browser) == KNOWN[name]
    assert listed(browser) == expected(read_arrangement(name))
    assert browser.count("#dual .vertex") == KNOWN[name][0]
    assert browser.count("#dual .edge") == KNOWN[name][1]
    assert KNOWN[name][0] / 2 <= browser.count("#ball .region") <= KNOWN[name][0]
    for colour in ("sides", "signs", "parity", "none"):
        browser.put("colour", colour)
        numbers = [int(re.findall(r"\d+", text)[-1]) for text in browser.texts("#legend li")]
        assert sum(numbers) == KNOWN[name][0]
    assert browser.messages() == []


@pytest.mark.slow
@pytest.mark.parametrize("number", range(12))
def test_page_counts_what_the_enumerators_count(number, browser, opened):
    planes = arrangements(12, seed=7)[number]
    if planes.dimension == 2:
        planes = Arrangement(planes.normals, dimension=2)
    assert_counted(planes, browser, opened)


@pytest.mark.parametrize("size", [10, 16, 14])
def test_page_counts_in_real_number_fields(size, browser, opened):
    """In Q(sqrt 5), in Q(sqrt 2), and in a field of degree 3."""
    assert_counted(families.regular(size), browser, opened)


def assert_counted(planes: Arrangement, browser: Browser, opened: Opened) -> None:
    opened(planes)
    assert listed(browser) == expected(planes)
    if planes.rank == 3:
        crossings, arcs, regions = planes.faces().f_vector[1:]
        assert counts(browser) == dual_counts(browser) == (regions, arcs, crossings)
    assert browser.messages() == []


def test_exact_points_of_a_field_have_the_signs_shown(browser, opened):
    planes = families.coxeter("H3")
    opened(planes)
    assert counts(browser) == (120, 180, 62)
    for region in (0, 57, 119):
        browser.put("regions", region)
        told = facts(browser)
        texts = told["a point inside"].replace("\u2212", "-").strip("()").split(", ")
        assert planes.signs_at([field_number(planes, text) for text in texts]) == signs(
            told["signs"]
        )


def field_number(planes: Arrangement, text: str) -> Any:
    """Return the number of a text such as ``-1 + 3a``."""
    assert planes.field is not None
    terms = re.findall(r"(-?)(\d*)(a?)", text.replace(" ", "").replace("+", ","))
    values = [
        (a, (-1 if minus else 1) * int(digits or 1)) for minus, digits, a in terms if digits or a
    ]
    return planes.field.number([sum(x for a, x in values if a == name) for name in ("", "a")])


def test_the_whole_disk_is_covered_by_regions(browser, opened):
    """Every place of the disk that is on no line belongs to exactly one region."""
    opened("braid-a3", camera=(4, 5, 3))
    wrong = browser.run(
        """
        const view = document.getElementById("ball");
        const box = view.querySelector(".ball").getBoundingClientRect();
        const [cx, cy, r] = [box.left + box.width / 2, box.top + box.height / 2, box.width / 2];
        let missed = 0;
        for (let i = -20; i <= 20; i += 1) {
          for (let j = -20; j <= 20; j += 1) {
            if (i * i + j * j > 380) continue;
            const found = document.elementsFromPoint(cx + (i * r) / 20, cy + (j * r) / 20)
              .filter((element) => element.classList.contains("region"));
            if (found.length !== 1) missed += 1;
          }
        }
        return missed;
        """
    )
    assert wrong <= 4  # places on a line between two regions


def test_pointing_at_a_region_tells_its_signs_and_an_inner_point(browser, opened):
    planes = read_arrangement("coordinate-planes")
    opened(planes, camera=(1, 1, 1))
    browser.pointer("mouseMoved", *browser.middle("#ball .ball"))
    told = facts(browser)
    assert told["signs"] == "+++"
    assert planes.signs_at(vector(told["a point inside"])) == (1, 1, 1)
    assert vector(told["dual vertex, normals as given"]) == (1, 1, 1)
    assert browser.count("#dual .vertex.lit") == 1
    browser.pointer("mouseMoved", 3, 3)
    assert facts(browser) == {}


def test_a_click_on_a_vertex_keeps_its_region(browser, opened):
    opened("braid-a3")
    place = browser.middle("#dual .vertex:not(.back)")
    browser.click_at(*place)
    browser.pointer("mouseMoved", 3, 3)
    marks = [
        browser.run(f"return document.querySelector('#{view} .lit').dataset.mark")
        for view in ("ball", "dual")
    ]
    assert marks[0] == marks[1]
    assert len(facts(browser)["signs"]) == 6
    browser.click_at(*place)
    browser.pointer("mouseMoved", 3, 3)
    assert browser.count(".lit") == 0


def untick(browser: Browser, plane: int) -> None:
    browser.click_at(*browser.middle(f"#planes li:nth-child({plane + 1}) input"))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["braid-a3", "reflection-b3", "coincident-planes", "near-pencil"])
def test_a_plane_taken_away_leaves_the_arrangement_of_the_others(name, browser, opened):
    planes = read_arrangement(name)
    opened(planes)
    left = list(range(len(planes)))
    while left:
        untick(browser, left.pop(0))
        rest = Arrangement([planes.normals[k] for k in left], dimension=3)
        regions, arcs, crossings = counts(browser)
        assert regions == len(rest.regions())
        assert dual_counts(browser) == (regions, arcs, crossings)
        assert listed(browser) == {
            "".join([*"·" * (len(planes) - len(left)), *text]) if left else "·" * len(planes)
            for text in expected(rest)
        }
        if rest.rank == 3:
            assert (crossings, arcs, regions) == rest.f_vector[1:]
            assert crossings - arcs + regions == 2
    browser.run("document.getElementById('all').click()")
    assert listed(browser) == expected(planes)
    assert browser.messages() == []


def shapes(browser: Browser) -> list[str]:
    return [
        browser.run(f"return document.getElementById('{view}').innerHTML")
        for view in ("ball", "dual")
    ]


@pytest.mark.parametrize("view", ["ball", "dual"])
def test_dragging_one_view_turns_both(view, browser, opened):
    opened("braid-a3")
    before = shapes(browser)
    x, y = browser.middle(f"#{view}")
    browser.drag((x, y), (x + 90, y + 30))
    browser.pointer("mouseMoved", 3, 3)
    after = shapes(browser)
    assert before[0] != after[0]
    assert before[1] != after[1]
    assert facts(browser) == {}, "a drag is not a click"


def test_a_finger_turns_and_a_tap_chooses(browser, opened):
    opened("coordinate-planes", camera=(1, 1, 1))
    before = shapes(browser)
    x, y = browser.middle("#ball .ball")
    browser.fingers([(x, y)], [(x + 30, y)], [(x + 60, y + 20)])
    assert shapes(browser)[0] != before[0]
    assert facts(browser) == {}
    browser.run("document.getElementById('home').click()")
    browser.fingers([(x, y)])
    assert facts(browser)["signs"] == "+++"


def test_arrow_keys_turn_and_home_turns_back(browser, opened):
    opened("braid-a3")
    before = shapes(browser)
    browser.run("document.getElementById('ball').focus()")
    browser.key("ArrowLeft")
    browser.key("ArrowUp")
    turned = shapes(browser)
    assert before[0] != turned[0]
    assert before[1] != turned[1]
    browser.key("Home")
    assert shapes(browser) == before
    browser.key("n")
    assert "signs" in facts(browser)
    browser.key("Escape")
    assert facts(browser) == {}


def test_a_region_brought_to_the_front_is_under_the_middle(browser, opened):
    opened("nine-generic-planes")
    for region in (0, 20, 73):
        browser.put("regions", region)
        told = facts(browser)["signs"]
        browser.pointer("mouseMoved", *browser.middle("#ball .ball"))
        assert facts(browser)["signs"] == told
        browser.pointer("mouseMoved", 3, 3)


@pytest.mark.parametrize(
    "planes",
    [
        Arrangement([], dimension=3),
        Arrangement([[1, 2, 3]]),
        Arrangement([[10**400, 1, 0], [0, 1, 10**400], [1, 0, 1]]),
    ],
    ids=["none", "one", "huge"],
)
def test_unusual_planes_are_shown(planes, browser, opened):
    opened(planes)
    assert counts(browser)[0] == len(planes.regions())
    assert browser.messages() == []


def test_symmetric_coordinates_change_places_and_nothing_else(browser, opened):
    planes = read_arrangement("braid-a3")
    opened(planes)
    before, known = shapes(browser), counts(browser)
    browser.run("document.getElementById('even').click()")
    browser.settled()
    assert shapes(browser)[0] != before[0]
    assert counts(browser) == known
    for x, y in ((0.3, 0.2), (-0.4, 0.5), (0.1, -0.6), (-0.7, -0.2)):
        box = browser.run(
            "const b = document.querySelector('#ball .ball').getBoundingClientRect();"
            "return [b.left + b.width / 2, b.top + b.height / 2, b.width / 2]"
        )
        browser.pointer("mouseMoved", box[0] + x * box[2], box[1] - y * box[2])
        told = facts(browser)
        point = told.get("a point inside", told.get("direction", ""))
        assert planes.signs_at(vector(point)) == signs(told["signs"])
    browser.pointer("mouseMoved", 3, 3)
    browser.run("document.getElementById('even').click()")
    browser.settled()
    assert shapes(browser) == before


def test_irrational_equations_are_readable_and_say_what_a_is():
    planes = families.coxeter("H3")
    a = planes.field.generator
    assert equation((2, 1 + a, 1 - a)) == "2x + (1 + a) y - (-1 + a) z = 0"
    assert equation((a, -a, 2 * a), 1 + a) == "a x - a y + 2a z = 1 + a"
    for page in (arrangement_page(planes), cells_page(planes)):
        assert "numbers in Q(a) with a^2 - 5 = 0, a = 2.23607..." in page
    assert "2x + (1 + a) y - (-1 + a) z = 0" in cells_page(planes)
    assert "numbers in" not in arrangement_page(read_arrangement("braid-a3"))


def test_page_writes_irrational_equations_alike(browser, opened):
    planes = families.coxeter("H3")
    opened(planes)
    shown = [text.replace("\u2212", "-") for text in browser.texts("#planes .exact")]
    assert shown == [equation(plane[:3]) for plane in planes.integer_planes]
