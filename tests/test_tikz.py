"""TikZ files: they compile, and what they show is what our own PDF shows."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arrangement import InputError, read_arrangement
from arrangement.drawing.figure import figure
from arrangement.drawing.output import own_settings, picture_bytes
from arrangement.drawing.registry import Drawings
from arrangement.drawing.scene.items import ROLES, Label
from arrangement.drawing.scene.scene import Scene
from arrangement.drawing.tikz.tex_text import tex_text
from arrangement.drawing.tikz.tikz import tikz
from arrangement.pictures import DRAWINGS as OF_PLANES
from equilibrium import read_grasp
from equilibrium.pictures import DRAWINGS as OF_GRASPS
from tests.instances import PLANAR
from tests.latex import RESOLUTION, Pixels, compiled, page_count, pages, unlike

#: What a view cannot do without.
NEEDED: dict[str, dict[str, Any]] = {
    "methods": {"wrenches": [(0, 2, 0), (1, -1, 0)]},
    "proof": {"wrench": (0, -1, 0)},
    "grasp": {"wrench": (0, 1, 1)},
}
#: Pixels that may differ, for each pixel of an edge: lines between two pixels are drawn otherwise.
LIMIT = 0.03
#: What to draw; of lines in the plane, some with parallels.
SHOWN = {"lines": "shi-a2-affine"}
VIEWS = [(OF_PLANES, name) for name in OF_PLANES.views] + [(OF_GRASPS, n) for n in OF_GRASPS.views]


def shown(drawings: Drawings, view: str) -> str:
    """Return the instance that a view shows in these tests."""
    return SHOWN.get(view, "braid-a3" if drawings is OF_PLANES else "paper-four-contacts")


def scene(drawings: Drawings, view: str, name: str, **options: Any) -> Scene:
    """Return the scene of a view of a built-in instance, in our own fonts."""
    module, _, function = drawings.views[view].partition(":")
    draw = getattr(importlib.import_module(f"{drawings.package}.{module}"), function)
    read: Any = read_arrangement if drawings is OF_PLANES else read_grasp
    with own_settings():
        made: Scene = draw.scene(read(name), **NEEDED.get(view, {}), **options)
    return made


def without_labels(made: Scene) -> Scene:
    """Return a sheet with all but the letters."""
    bare = Scene(*made.paper)
    bare.items = [item for item in made.items if not isinstance(item, Label)]
    return bare


def every_kind() -> Scene:
    """Return a sheet with what few views have."""
    made = Scene(80, 40)
    made.ball((40, 60), 30)
    made.circle((110, 60), 30, fc="#4477aa", ec="none", gid="region-0")
    made.ball((110, 60), 30, "#ffffff60", "#00000060", zorder=2)
    square = np.array([[150, 30], [210, 30], [210, 90], [150, 90]])
    made.polygon(square, fc="#ccddee", ec="#7d7d7d", lw=0, hatch="//////")
    for k, hatch in enumerate(["\\\\", "--", "||", "xx", "++", "...", "oo"]):
        left = 85 + 19 * k
        box = [(left, 95), (left + 15, 95), (left + 15, 110), (left, 110)]
        made.polygon(box, fc="#eeeeee", ec="#7d7d7d", lw=0, hatch=hatch)
    made.ball((110, 15), 8, "#0000ff10", "#0000ffc0", zorder=3)
    made.line([(10, 15), (215, 15)], ec="#aa3377", lw=2, ls=(0, (3, 1, 1, 1)), capstyle="butt")
    with made.clipped((160.0, 20.0, 190.0, 60.0)):
        made.circle((180, 60), 25, fc="#ee6677", ec="black", lw=1.5, alpha=0.5)
    with made.clipped(((40.0, 60.0), 20.0)):
        made.line([(0, 30), (80, 90)], ec="black", lw=3)
    for k, sign in enumerate("ox_"):
        made.mark((20 + 12 * k, 103), sign, 6, color="#228833", mew=1.2)
    made.polygon(np.array([[60, 97], [75, 97], [68, 109]]), fc="white", ec="black", lw=1.5,
                 joinstyle="round")  # fmt: skip
    return made


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        ("+\u200a−\n−\u200a0", r"${+}{-}$ \\ ${-}{0}$"),
        ("w = (0, −1/2, 1)", "$w=(0,-1/2,1)$"),
        ("\u20071 +\u200a−\u200a+", r"\phantom{0}$1\;{+}{-}{+}$"),
        ("f_x −2 to 1, τ −1 to 1", r"$f_x\;{-}2$ to 1, $\tau \;{-}1$ to 1"),
        ("1,2,5–9", "$1{,}2{,}5$--$9$"),
        ("(a) Grasp Wrench Space, L1", "(a) Grasp Wrench Space, $L_1$"),
        ("contacts 1 to 3: ● stick, − slip−", r"contacts 1 to 3: $\bullet$ stick, $-$ slip$-$"),
        ("Σμ = −9", r"$\Sigma \mu =-9$"),
        ("1: λ = (1, −1)", r"$1$: $\lambda =(1,-1)$"),
        ("$f_x$ (10⁵ N)", "$f_x$ ($10^{5}$ N)"),
        ("ℝ³", r"$\mathbb{R}^{3}$"),
        ("≈3.3e+19", r"$\approx 3.3\cdot 10^{19}$"),
        ("2–3 minus signs", "2--3 minus signs"),
        ("Möbius & 100% {of} ab_cd \\ ~ ^ #", None),
    ],
)
def test_labels_are_maths_where_they_mean_it(text: str, latex: str | None) -> None:
    if latex is not None:
        assert tex_text(text) == latex
    else:
        escaped = r"M\"{o}bius \& 100\% \{of\} ab\_cd \textbackslash{} \textasciitilde{}"
        assert tex_text(text) == escaped + r" \textasciicircum{} \#"


@pytest.mark.parametrize(("drawings", "view"), VIEWS)
def test_styles_are_those_of_the_roles_and_all_is_plain_text(drawings: Drawings, view: str) -> None:
    """One style at the top for each role that occurs; no letter that pdflatex does not know."""
    made = scene(drawings, view, shown(drawings, view))
    text = tikz(made, fragment=True)
    head, _, body = text.partition("bounding box")
    roles = {item.role for item in made.items}
    assert {role for role in ROLES if f"/slipstates/{role}/.style" in head} == roles
    assert "/.style" not in body
    assert text.isascii()
    assert body.count(r"\begin{scope}") == body.count(r"\end{scope}")
    assert text.startswith("% The preamble needs:")
    assert r"\documentclass" not in text


def document(folder: Path, scenes: list[Scene], texts: list[str]) -> Path:
    """Return a document with fragments on pages of their own."""
    width, height = (max(s.paper[k] for s in scenes) for k in (0, 1))
    paper = f"paperwidth={width}mm,paperheight={height + 1}mm,margin=0mm"
    head = [
        r"\RequirePackage{fix-cm}\documentclass{article}",
        rf"\usepackage[{paper}]{{geometry}}\usepackage{{tikz,amssymb}}",
        r"\pagestyle{empty}\parindent0pt\begin{document}",
    ]
    source = folder / "all.tex"
    source.write_text("\n".join([*head, "\\newpage\n".join(texts), r"\end{document}"]))
    return source


def differences(folder: Path, scenes: list[Scene], texts: list[str]) -> Iterator[float]:
    """Compile fragments on pages of one document; yield how unlike they are to our own PDF."""
    source = document(folder, scenes, texts)
    for k, (made, drawn) in enumerate(zip(scenes, pages(compiled(source)), strict=True)):
        own = folder / f"own-{k}.pdf"
        own.write_bytes(picture_bytes(".pdf", lambda made=made: figure(made)))
        (expected,) = pages(own)
        rows, columns, _ = expected.shape
        rest = np.ones_like(drawn)
        rest[:rows, :columns] = drawn[:rows, :columns]
        assert np.array_equal(rest, drawn)
        yield unlike(drawn[:rows, :columns], expected)


@pytest.mark.campaign
@pytest.mark.usefixtures("latex")
def test_tikz_shows_what_our_own_pictures_show(tmp_path: Path) -> None:
    """What is wrong is seen: of wide, pale, shifted and missing lines and of another fill."""
    made = without_labels(scene(OF_PLANES, "sphere", "braid-a3"))
    scenes = [every_kind(), made, without_labels(scene(OF_GRASPS, "resist", "paper-four-contacts"))]
    texts = [tikz(sheet, fragment=True) for sheet in scenes]
    found = list(differences(tmp_path, scenes, texts))
    assert max(found) < LIMIT, found
    changes = [
        ("line width=0.9bp", "line width=2.5bp"),
        ("layer=hidden]", "layer=hidden, xshift=5bp]"),
        ("fill=slipstates1", "fill=slipstates1!60!black"),
        ("x=1bp, y=1bp", "x=1pt, y=1pt"),
        ("layer=circle]", "layer=circle, transparent]"),
    ]
    wrong = [texts[1].replace(*change) for change in changes]
    found = list(differences(tmp_path, [made] * len(wrong), wrong))
    assert min(found) > 1.5 * LIMIT, found


@pytest.mark.campaign
@pytest.mark.usefixtures("latex")
def test_every_view_is_the_same_in_tikz(tmp_path: Path) -> None:
    """Without letters: of these, fonts differ."""
    scenes = [without_labels(scene(d, view, shown(d, view))) for d, view in VIEWS]
    found = list(differences(tmp_path, scenes, [tikz(made, fragment=True) for made in scenes]))
    assert max(found) < LIMIT, found


def label_boxes(made: Scene, pixels: Pixels) -> Iterator[tuple[str, slice, slice]]:
    """Yield the text of each label and the rows and columns of its box, a little wider."""
    scale = len(pixels) / made.height
    for item in made.items:
        if isinstance(item, Label):
            w, h = made.measure(item.text, item.size, item.rotation)
            left = {"left": 0.0, "center": 0.5, "right": 1.0}[item.ha] * w
            low = {"bottom": 0.0, "top": 1.0}.get(item.va, 0.5) * h
            x, y = item.place[0] - left, made.height - (item.place[1] - low)
            # Words are up to a tenth wider in the small sizes of Computer Modern.
            wide, high = (2 + 0.1 * max(w, h) * (w > h), 1.5 + 0.1 * max(w, h) * (h > w))
            ends = [(y - h - high, y + high), (x - wide, x + w + wide)]
            rows, columns = (slice(max(0, int(a * scale)), int(b * scale) + 1) for a, b in ends)
            yield item.text, rows, columns


def check_letters(made: Scene, drawn: Pixels, bare: Pixels) -> None:
    """All ink of the letters is in the boxes that our own letters have."""
    ink = np.abs(drawn - bare).max(axis=2) > 0.1
    inside = np.zeros_like(ink)
    for text, rows, columns in label_boxes(made, ink):
        assert ink[rows, columns].any(), f"{text!r} is not there"
        inside[rows, columns] = True
    assert (ink & ~inside).sum() <= 0.02 * ink.sum()


@pytest.mark.usefixtures("latex")
@pytest.mark.parametrize(("drawings", "view"), [(OF_PLANES, "lattice"), (OF_GRASPS, "proof")])
def test_a_document_compiles_and_its_letters_are_where_ours_are(
    drawings: Drawings, view: str, tmp_path: Path
) -> None:
    name = "reflection-b3" if drawings is OF_PLANES else "paper-four-contacts"
    made = scene(drawings, view, name)
    sheets = []
    for k, sheet in enumerate((made, without_labels(made))):
        source = tmp_path / f"{k}.tex"
        source.write_text(tikz(sheet))
        (found,) = pages(compiled(source))
        sheets.append(found)
    for pixels, length in zip(sheets[0].shape, reversed(made.paper), strict=False):
        assert abs(pixels - length / 25.4 * RESOLUTION) <= 1
    check_letters(made, *sheets)


@pytest.mark.campaign
@pytest.mark.usefixtures("latex")
def test_letters_of_every_view_are_where_ours_are(tmp_path: Path) -> None:
    """On pages of one document, in the corner of each."""
    views = [scene(drawings, view, shown(drawings, view)) for drawings, view in VIEWS]
    scenes = [sheet for made in views for sheet in (made, without_labels(made))]
    source = document(tmp_path, scenes, [tikz(sheet, fragment=True) for sheet in scenes])
    drawn = pages(compiled(source))
    for made, sheet, bare in zip(views, drawn[::2], drawn[1::2], strict=True):
        columns, rows = (round(length / 25.4 * RESOLUTION) for length in made.paper)
        check_letters(made, sheet[:rows, :columns], bare[:rows, :columns])


@pytest.mark.campaign
@pytest.mark.usefixtures("latex")
@pytest.mark.parametrize("name", PLANAR)
def test_all_pictures_of_all_instances_compile(name: str, tmp_path: Path) -> None:
    """On pages of one document; what a view refuses has no picture."""
    found = []
    for drawings, view in VIEWS:
        with suppress(InputError):
            found.append(scene(drawings, view, name))
    source = document(tmp_path, found, [tikz(made, fragment=True) for made in found])
    assert found
    assert page_count(compiled(source)) == len(found)
