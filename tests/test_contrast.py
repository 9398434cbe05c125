"""Contrast in both themes of the labs, from the variables of their styles (WCAG 2.1, level AA)."""

import re
from collections.abc import Callable

import pytest

from arrangement.pictures.lab.lines import lab_page as lines_page
from equilibrium.pictures.lab.page import lab_page

PAGES: dict[str, Callable[..., str]] = {"slip": lab_page, "lines": lines_page}
#: Text, and graphics that tell something, with what lies behind. Names a page lacks are left out.
TEXT = {
    "ink": ["paper", "panel", "accent-soft", "body", *(f"sides-{k}" for k in range(2, 8))],
    "soft": ["paper", "panel"],
    "yes": ["paper", "panel", "yes-soft"],
    "no": ["paper", "panel", "no-soft"],
}
GRAPHICS = {
    **{
        name: ["paper", "panel", "body"]
        for name in ("ink", "soft", "accent", "load", "move", "cone")
    },
    "focus": ["paper", "panel", "accent-soft"],
    "no": ["paper", "panel"],
}


def themes(page: str) -> dict[str, dict[str, str]]:
    """Return the colours of the light theme, of the dark one, and of the system's dark one."""
    style = re.sub(r"/\*.*?\*/", "", page[page.index("<style>") : page.index("</style>")])
    selectors = {
        "light": ":root",
        "dark": ':root[data-theme="dark"]',
        "system": ':root:not([data-theme="light"])',
    }
    own = {
        name: dict(re.findall(r"--([\w-]+):\s*(#[0-9a-f]{6})", "".join(blocks)))
        for name, selector in selectors.items()
        if (blocks := re.findall(rf"(?<![\w,]){re.escape(selector)} {{(.*?)}}", style, re.S))
    }
    return {name: {**own["light"], **found} for name, found in own.items()}


def contrast(one: str, other: str) -> float:
    def luminance(colour: str) -> float:
        shares = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
        r, g, b = (x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in shares)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    low, high = sorted(map(luminance, (one, other)))
    return (high + 0.05) / (low + 0.05)


def test_black_on_white_is_21_and_a_known_grey_is_just_enough():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#767676", "#ffffff") == pytest.approx(4.54, abs=0.01)


@pytest.mark.parametrize("name", PAGES)
def test_text_and_graphics_stand_out_in_both_themes(name):
    page = PAGES[name]()
    found = themes(page)
    assert set(found) == {"light", "dark", "system"}
    assert found["dark"] == found["system"]
    assert found["dark"]["paper"] != found["light"]["paper"]
    weak = [
        (theme, front, behind, round(contrast(colours[front], colours[behind]), 2))
        for theme, colours in found.items()
        for pairs, least in ((TEXT, 4.5), (GRAPHICS, 3))
        for front, backs in pairs.items()
        for behind in backs
        if front in colours and behind in colours
        if contrast(colours[front], colours[behind]) < least
    ]
    assert weak == []
    used = set(re.findall(r"[ {;]color:\s*var\(--([\w-]+)\)", page))
    assert used <= set(TEXT), "text in a colour that is not compared"
