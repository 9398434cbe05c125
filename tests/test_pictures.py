"""Properties of pictures: every view of both packages, and every built-in instance.

Options have forms, scenes know no format, labels cover nothing, legends have their place, themes
keep what is described, TikZ shows the same items, and files repeat byte for byte.
"""

import os
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from PIL import Image

from arrangement import Arrangement, ArrangementError, InputError, read_arrangement
from arrangement.cli import main as draw_planes
from arrangement.drawing.layout import BELOW, lay_out, picture_width
from arrangement.drawing.output import font_settings, own_settings, picture_bytes
from arrangement.drawing.path_artist import Paths, figure, into
from arrangement.drawing.scene import ROLES, Ball, Item, Label, Mark, Path as Drawn, Scene, measure
from arrangement.drawing.themes import _from_oklab, _oklab, apply_theme
from arrangement.drawing.tikz import tex_text, tikz
from arrangement.drawing.views import Printing
from arrangement.library.families import catalan, generic, shi
from arrangement.numbers import exact
from arrangement.pictures import DRAWINGS as OF_PLANES, compose, draw_sphere
from arrangement.pictures.views import write_drawing
from equilibrium import read_grasp
from equilibrium.cli import main as draw_grasps
from equilibrium.grasps.inputs import from_float_data
from equilibrium.pictures import DRAWINGS as OF_GRASPS
from tests.docpages import ROOT
from tests.drawn import VIEWS, digests, files, offences, scene, usual
from tests.instances import ARRANGEMENTS, PLANAR
from tests.latex import RESOLUTION, Pixels, compiled, not_compiled, page_count, pages, unlike

EVERY_VIEW = pytest.mark.parametrize(("drawings", "view"), VIEWS)

# Options and scenes.


@pytest.mark.parametrize("drawings", [OF_PLANES, OF_GRASPS])
@pytest.mark.parametrize("kind", ["view", "model", "page"])
def test_every_option_has_a_form_on_the_command_line(drawings, kind):
    for name in getattr(drawings, f"{kind}s"):
        for option in drawings.options(kind, name).values():
            assert option.text, option.name


@EVERY_VIEW
def test_a_view_makes_a_scene_that_knows_no_format(drawings, view):
    made = usual(drawings, view)
    assert len({item.name.partition("-")[0] for item in made.items}) > 1
    for item in made.items:
        assert isinstance(item, Item)
        assert item.role in ROLES
        points = (
            item.place if isinstance(item, Label | Mark)
            else item.centre if isinstance(item, Ball) else item.points
        )  # fmt: skip
        assert np.isfinite(np.asarray(points)).all()


HUGE = 10**350
LARGE = {
    "one": [(HUGE + 7, 1, 0), (0, 1, 1), (1, 0, 2), (1, 1, 1)],
    "all": [(1, HUGE, HUGE), (HUGE, HUGE + 1, 1), (HUGE, 1, HUGE), (1, 1, 1)],
}


@pytest.mark.slow
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("normals", LARGE.values(), ids=LARGE)
@pytest.mark.parametrize("kind", ["view", "page", "model"])
def test_normals_beyond_floats_are_drawn_or_refused(kind, normals, tmp_path):
    planes = Arrangement(normals)
    drawings = OF_PLANES.of(planes)
    suffix = {"view": "svg", "page": "html", "model": "stl"}[kind]
    for name in getattr(drawings, f"{kind}s"):
        path = tmp_path / f"{name}.{suffix}"
        try:
            drawings.write(planes, path, **{"model" if kind == "model" else "view": name})
            error = ""
        except ArrangementError as refused:
            error = str(refused)
        reason = re.search("about 1.8e308|floats|when rounded|planes of rank", error)
        assert bool(reason) != path.exists(), error


def test_a_page_of_normals_of_five_thousand_digits(tmp_path):
    long = 10**5000
    write_drawing(Arrangement([(long, 1, 0), (0, 1, 1), (1, 0, 2)]), tmp_path / "a.html")
    assert "0" * 5000 in (tmp_path / "a.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("planes", "names"), [("braid-a3", "xyz"), ("paper-three-contacts", "xyr")]
)
def test_axes_without_names_are_on(planes, names, tmp_path):
    words = ["draw", planes, "--text", "text", "--axes", "-o", str(tmp_path / "a.svg")]
    assert draw_planes(words) == 0
    written = re.findall(r">([xyzr])</text>", (tmp_path / "a.svg").read_text(encoding="utf-8"))
    assert sorted(written) == sorted(names)


# Labels and legends.


OTHER_OPTIONS: list[tuple[str, str, dict[str, Any]]] = [
    ("sphere", "reflection-b3", {"labels": "signs"}),
    ("sphere", "braid-a3", {"sides": True, "axes": "x,y,z"}),
    ("sphere", "five-generic-planes", {"width": 60.0}),
    ("planes", "cube-diagonals", {"lift": ["++++", "+-+-"], "sides": True, "axes": "x,y,z"}),
    ("planes", "braid-a3", {"lift": ["++++++"], "body": "cube"}),
    ("stereographic", "reflection-b3", {"whole": True, "labels": "signs"}),
    ("gnomonic", "reflection-b3", {"camera": (0, 0, 1)}),
    ("dual", "five-generic-planes", {"hull": True}),
    ("dual", "reflection-b3", {"width": 88.0}),
    ("graph", "reflection-b3", {"labels": "signs"}),
    ("lines", "generic-lines-affine", {"faces": "all", "sides": True}),
    ("lines", "pencil", {"projective": True, "sides": True}),
    ("lines", "shi-a2-affine", {"projective": True, "labels": "signs", "colour": "sides"}),
    ("cells", "cube-diagonals", {"body": "ball", "explode": 2}),
    ("lattice", "reflection-b3", {"width": 180.0}),
    ("stereographic", "reflection-b3", {"whole": False}),
    ("stereographic", "reflection-b3", {"colour": "signs", "width": 60.0}),
    ("gnomonic", "reflection-b3", {"camera": (1, 0, 1), "colour": "none"}),
    ("dual", "reflection-b3", {"hull": True}),
    ("dual", "reflection-b3", {"coordinates": "even", "colour": "signs"}),
    ("graph", "reflection-b3", {"colour": "signs"}),
    ("graph", "reflection-b3", {"width": 50.0}),
]


@pytest.mark.slow
@pytest.mark.parametrize(("view", "name", "options"), OTHER_OPTIONS)
def test_no_label_is_cut_off_or_covers_another_or_an_edge(view, name, options):
    assert offences(lay_out(scene(OF_PLANES, view, name, **options))) == []


def test_the_check_finds_each_kind_of_offence():
    with own_settings():
        made = Scene(40, 40)
        made.text((50, 50), "one")
        made.line([(40, 50), (60, 50)], ec="black", gid="edge-1")
        assert offences(made) == ["'one' on edge-1"]
        made.circle((50, 50), 15, fc="white", ec="none", zorder=2)
        assert offences(made) == []
        made.text((53, 50), "two")
        made.text((1, 90), "three")
        assert offences(made) == ["three", "'one' and 'two'"]
        made = Scene(40, 20)
        assert made.write((30, 30), "one")
        assert not made.write((33, 30), "two")


WITH_LEGENDS = pytest.mark.parametrize(
    ("drawings", "view", "name"),
    [(d, v, "five-generic-planes" if d is OF_PLANES else "") for d, v in VIEWS if v != "lines"],
)


@WITH_LEGENDS
def test_keys_and_lines_below_take_a_sixth_of_the_height(drawings, view, name):
    with own_settings():
        made = scene(drawings, view, name)
        made.legend.captions.clear()
        made.legend.table.clear()
        sheet = lay_out(made)
        assert sheet.height - made.height <= BELOW * sheet.height + 1e-6
        assert sheet.width == made.width
        assert lay_out(made, "none").height == made.height


@WITH_LEGENDS
def test_at_the_right_it_stands_beside_the_picture(drawings, view, name):
    wide = 260.0
    with own_settings():
        made = scene(drawings, view, name, width=picture_width(wide, "right"))
        count, keys = len(made.items), made.legend.keys
        sheet = lay_out(made, "right")
        assert sheet.paper[0] == pytest.approx(wide)
        texts = [item for item in sheet.items[count:] if isinstance(item, Label)]
        assert {word for key in keys for word in key.text.split()} <= {
            word for item in texts for word in item.text.split()
        }
        captions = {line for text in made.legend.captions for line in text.split()}
        for item in texts:
            w, h = measure(item.text, item.size)
            beside = item.place[0] >= made.width and item.place[0] + w <= sheet.width + 0.01
            assert beside or set(item.text.split()) <= captions
            assert h / 2 - 1 <= item.place[1] <= sheet.height


def test_an_emphatic_line_stays_on_the_sheet():
    """Bold letters are wider than others."""
    made = Scene(88.0, 40.0)
    made.legend.line("depends on the rounding: not resisted for others within", True)
    words = [x for x in lay_out(made).items if isinstance(x, Label)]
    assert len(words) == 1
    for x in words:
        width = measure(x.text, x.size, weight="bold")[0]
        assert width > 1.1 * measure(x.text, x.size)[0]
        assert x.place[0] >= 0
        assert x.place[0] + width <= made.width


def test_without_a_legend_captions_stay(tmp_path):
    planes = read_arrangement("braid-a3-in-r4")
    for legend, shown in (("none", False), ("below", True)):
        path = tmp_path / f"{legend}.svg"
        OF_PLANES.write(planes, path, "sphere", legend=legend, text="text")
        svg = path.read_text(encoding="utf-8")
        assert "essentialisation" in svg
        assert ("odd number" in svg) == shown


@pytest.mark.parametrize(("drawings", "view"), VIEWS)
def test_legends_hold_no_advice_about_the_software(drawings, view):
    legend = usual(drawings, view).legend
    texts = [
        *legend.captions,
        *(text for text, _ in legend.lines),
        *(key.text for key in legend.keys),
    ]
    advice = r"`|--[a-z]|\bno room\b|too (small|many)|without (end|limit)"
    assert not [text for text in texts if re.search(advice, text)]


def test_a_picture_of_rounded_data_says_so_without_advice():
    points, normals = [[-0.31, 0], [0.31, 0]], [[1, 0], [-1, 0]]
    grasp = from_float_data(points, normals, 0.5, as_given=True).grasp
    texts = [text for text, _ in OF_GRASPS.draw(grasp, "resist").scene.legend.lines]
    (text,) = (text for text in texts if "rounded" in text)
    assert "`" not in text


@pytest.mark.parametrize(
    ("name", "view", "items"),
    [
        ("shi-a2-affine", "lines", "lines"),
        ("shi-a2-affine", "graph", "lines"),
        ("braid-a3", "sphere", "circles"),
        ("braid-a3", "stereographic", "circles"),
        ("braid-a3", "dual", "circles"),
        ("braid-a3", "gnomonic", "lines"),
        ("braid-a3", "cells", "planes"),
        ("braid-a3", "poset", "planes"),
    ],
)
def test_a_legend_names_what_the_picture_shows(name, view, items):
    lines = scene(OF_PLANES, view, name, labels="numbers").legend.lines
    assert (f"regions by number; numbers of {items} are italic", False) in lines


# Themes.


def lightness(colour: Any) -> float:
    return float(_oklab(to_rgb(colour))[0])


def test_in_print_wrenches_are_black_and_one_set_has_a_hatching():
    for view, wrench in (("grasp", (0, 1, 1)), ("slice", (0, 1, 0))):
        coloured = scene(OF_GRASPS, view, "paper-three-contacts-preload-1", wrench=wrench)
        made = apply_theme(coloured, "mono").items
        if view == "grasp":
            fills = {x.name: x.style.get("fc") for x in made if x.name.startswith("wrench-")}
            assert fills["wrench-force"] == fills["wrench-torque-head"] == "#000000"
        else:
            sets = [x for x in made if "polygon" in x.name]
            assert sets
            assert all("hatch" in x.style and not x.style["lw"] for x in sets)


@given(st.tuples(*[st.floats(0, 1)] * 3))
def test_oklab_and_back(rgb):
    light, a, b = _oklab(rgb).tolist()
    assert np.allclose(_from_oklab((light, a, b), 1.0)[:3], rgb, atol=1e-4)


def test_greys_have_no_hue_in_oklab_and_white_has_lightness_one():
    assert np.allclose(_oklab((1.0, 1.0, 1.0)), (1, 0, 0), atol=1e-4)
    assert np.allclose(_oklab((0.5, 0.5, 0.5))[1:], 0, atol=1e-4)


@EVERY_VIEW
def test_dark_letters_are_light_and_mono_has_no_colour(drawings, view):
    made = usual(drawings, view)
    dark, mono = apply_theme(made, "dark"), apply_theme(made, "mono")
    assert apply_theme(made, "light") is made
    assert len(mono.items) == len(made.items) == len(dark.items) - 1
    plain = {id(i) for i in made.items if isinstance(i, Label) and "plate" not in i.style}
    for old, new in zip(made.items, dark.items[1:], strict=True):
        if id(old) in plain and lightness(old.style.get("color", "black")) < 0.4:
            assert lightness(new.style["color"]) > 0.6
    for item in mono.items:
        for key in ("fc", "ec", "color"):
            colour = item.style.get(key, "none")
            if not isinstance(item, Ball) and str(colour) != "none":
                assert abs(_oklab(to_rgb(colour))[1:]).max() < 1e-2


def test_mono_keeps_apart_what_colours_keep_apart():
    own = "signs:#fdf0c0,#b9dfd3,#7fb9d8,#6a96c8,#8a7fb5,#d8a640"
    made = scene(OF_PLANES, "sphere", "five-generic-planes", colour=own)
    mono = apply_theme(made, "mono")
    pairs = {
        (str(old.style["fc"]), (new.style["fc"], new.style.get("hatch", "")))
        for old, new in zip(made.items, mono.items, strict=True)
        if isinstance(old, Drawn) and old.name.startswith("region")
    }
    assert len(pairs) == len({a for a, _ in pairs}) == len({b for _, b in pairs}) >= 4


# TikZ.


#: Pixels that may differ, for each pixel of an edge: lines between two pixels are drawn otherwise.
LIMIT = 0.03


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
    with made.clip((160.0, 20.0, 190.0, 60.0)):
        made.circle((180, 60), 25, fc="#ee6677", ec="black", lw=1.5, alpha=0.5)
    with made.clip(((40.0, 60.0), 20.0)):
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
        (
            "Möbius & 100% {of} ab_cd \\ ~ ^ #",
            r"M\"{o}bius \& 100\% \{of\} ab\_cd \textbackslash{} \textasciitilde{}"
            r" \textasciicircum{} \#",
        ),
    ],
)
def test_labels_are_maths_where_they_mean_it(text, latex):
    assert tex_text(text) == latex


@EVERY_VIEW
def test_styles_are_those_of_the_roles_and_all_is_plain_text(drawings, view):
    """One style at the top for each role that occurs; no letter that pdflatex does not know."""
    made = usual(drawings, view)
    text = tikz(made, fragment=True)
    head, _, body = text.partition("bounding box")
    roles = {item.role for item in made.items}
    assert {role for role in ROLES if f"/slipstates/{role}/.style" in head} == roles
    assert "/.style" not in body
    assert text.isascii()
    assert body.count(r"\begin{scope}") == body.count(r"\end{scope}")
    assert text.startswith("% The preamble needs:")
    assert r"\documentclass" not in text


def test_pictures_in_one_document_do_not_take_shadings_of_each_other():
    scenes = [scene(OF_PLANES, "sphere", "braid-a3"), every_kind()]
    pattern = re.compile(r"\\pgfdeclareradialshading\{([\w-]+)\}(.*)")
    found = [pair for made in scenes for pair in pattern.findall(tikz(made))]
    assert len(found) == len(dict(found)) == len({content for _, content in found}) == 6


def document(folder: Path, papers: Sequence[Any], texts: Sequence[str]) -> Path:
    """Return a document with fragments on pages of their own."""
    width, height = (max(paper[k] for paper in papers) for k in (0, 1))
    paper = f"paperwidth={width}mm,paperheight={height + 1}mm,margin=0mm"
    head = [
        r"\RequirePackage{fix-cm}\documentclass{article}",
        rf"\usepackage[{paper}]{{geometry}}\usepackage{{tikz,amssymb}}",
        r"\pagestyle{empty}\parindent0pt\begin{document}",
    ]
    source = folder / "all.tex"
    source.write_text("\n".join([*head, "\\newpage\n".join(texts), r"\end{document}"]))
    return source


def by_latex(folder: Path, scenes: Sequence[Scene], texts: Sequence[str]) -> list[Pixels]:
    """Return the pages of a document with fragments."""
    return pages(compiled(document(folder, [made.paper for made in scenes], texts)))


def differences(folder: Path, scenes: Sequence[Scene], drawn: Sequence[Pixels]) -> Iterator[float]:
    """Yield how unlike pages of a document are to our own PDF."""
    for k, (made, page) in enumerate(zip(scenes, drawn, strict=True)):
        own = folder / f"own-{k}.pdf"
        own.write_bytes(picture_bytes(".pdf", lambda made=made: figure(made)))
        (expected,) = pages(own)
        rows, columns, _ = expected.shape
        rest = np.ones_like(page)
        rest[:rows, :columns] = page[:rows, :columns]
        assert np.array_equal(rest, page)
        yield unlike(page[:rows, :columns], expected)


@pytest.mark.slow
@pytest.mark.usefixtures("latex")
def test_tikz_shows_what_our_own_pictures_show(tmp_path):
    """What is wrong is seen: of wide, pale, shifted and missing lines and of another fill."""
    made = without_labels(scene(OF_PLANES, "sphere", "braid-a3"))
    scenes = [every_kind(), made, without_labels(scene(OF_GRASPS, "resist", "paper-four-contacts"))]
    texts = [tikz(sheet, fragment=True) for sheet in scenes]
    found = list(differences(tmp_path, scenes, by_latex(tmp_path, scenes, texts)))
    assert max(found) < LIMIT, found
    changes = [
        ("line width=0.9bp", "line width=2.5bp"),
        ("layer=hidden]", "layer=hidden, xshift=5bp]"),
        ("fill=slipstates1", "fill=slipstates1!60!black"),
        ("x=1bp, y=1bp", "x=1pt, y=1pt"),
        ("layer=circle]", "layer=circle, transparent]"),
    ]
    wrong = [texts[1].replace(*change) for change in changes]
    sheets = [made] * len(wrong)
    found = list(differences(tmp_path, sheets, by_latex(tmp_path, sheets, wrong)))
    assert min(found) > 1.5 * LIMIT, found


def label_boxes(made: Scene, pixels: Pixels) -> Iterator[tuple[str, slice, slice]]:
    """Yield the text of each label and the rows and columns of its box, a little wider."""
    scale = len(pixels) / made.height
    for item in made.items:
        if isinstance(item, Label):
            w, h = measure(item.text, item.size, item.rotation)
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
def test_a_document_compiles_and_its_letters_are_where_ours_are(drawings, view, tmp_path):
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


@pytest.mark.slow
@pytest.mark.usefixtures("latex")
def test_every_view_and_its_letters_are_the_same_in_tikz(tmp_path):
    """Lines are compared without letters, whose fonts differ: these are where ours are."""
    views = [usual(drawings, view) for drawings, view in VIEWS]
    scenes = [sheet for made in views for sheet in (made, without_labels(made))]
    drawn = by_latex(tmp_path, scenes, [tikz(sheet, fragment=True) for sheet in scenes])
    found = list(differences(tmp_path, scenes[1::2], drawn[1::2]))
    assert max(found) < LIMIT, found
    for made, sheet, bare in zip(views, drawn[::2], drawn[1::2], strict=True):
        columns, rows = (round(length / 25.4 * RESOLUTION) for length in made.paper)
        check_letters(made, sheet[:rows, :columns], bare[:rows, :columns])


# Repetition.


#: One of each kind; each is in another part of the instances.
REPEATED = ["shi-a2-affine", "paper-three-contacts-preload-1", "braid-a3"]
#: Prints a digest of every picture of an instance.
SCRIPT = """
import sys
from tests.drawn import digests, files
for name, view, _, contents in files(sys.argv[1:], sys.argv[1:]):
    print(*digests(name, view, contents), sep="\\n")
"""


@pytest.mark.slow
@pytest.mark.parametrize("part", range(3))
def test_all_pictures_repeat_and_compile(part, tmp_path):
    """The pictures are pages of one document; what a view refuses has none.

    Another process, with another seed of hashes, draws the same.
    """
    names, (again,) = PLANAR[part::3], {*PLANAR[part::3]} & {*REPEATED}
    tried = [name for name in names if name in ARRANGEMENTS][:1]
    lines, papers, texts, wrong = [], [], [], []
    for name, view, made, contents in files(names, {again}, tried):
        lines += digests(name, view, contents)
        papers.append(made.paper)
        texts.append(tikz(made, fragment=True))
        if view in OF_PLANES.views and (found := offences(lay_out(made))):
            wrong.append((name, view, found))
    assert wrong == []
    assert {line.split()[0] for line in lines} == set(names)
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT, again],
        env={**os.environ, "PYTHONHASHSEED": "4"},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert sorted(done.stdout.splitlines()) == sorted(
        line for line in lines if line.split()[0] == again
    )
    if not_compiled() is None:
        assert page_count(compiled(document(tmp_path, papers, texts))) == len(texts)


@pytest.mark.parametrize(
    ("drawings", "view", "room"),
    # A section is drawn as planes are.
    [(*one, ((120, 90), (60, 25))[k % 2]) for k, one in enumerate(VIEWS) if one[1] != "section"],
)
def test_user_axes_hold_one_artist_per_element(drawings, view, room):
    figure = Figure(figsize=[length / 25.4 for length in room])
    axes = figure.add_axes((0.1, 0.1, 0.8, 0.8))
    axes.set_title("kept")
    made: list[Scene] = []

    def make(width: float) -> Scene:
        made.append(lay_out(scene(drawings, view, width=width), "none"))
        return made[-1]

    assert into(axes, make) is figure
    found = {artist.get_gid() for artist in axes.findobj()} - {None}
    assert found == {item.name for item in made[-1].items} - {""}
    figure.canvas.draw()
    sheet = axes.get_window_extent()
    for artist in axes.texts:
        place = artist.get_window_extent()
        assert sheet.x0 - 2 < place.x0, artist
        assert place.x1 < sheet.x1 + 2, artist
    assert axes.get_title() == "kept"


def test_planes_and_grasps_draw_themselves():
    planes, grasp = read_arrangement("braid-a3"), read_grasp("paper-four-contacts")
    assert planes.draw().axes[0].findobj(Paths)
    whole = Figure(figsize=(4, 2))
    left, right = whole.subfigures(1, 2)
    assert planes.draw("dual", ax=left) is grasp.draw(ax=right) is whole
    assert [len(part.axes) for part in (left, right)] == [1, 1]
    with pytest.raises(InputError, match="did you mean dual"):
        planes.draw("duel")
    with pytest.raises(InputError, match=r"use labels[.]"):
        planes.draw(label="none")


@pytest.mark.parametrize("view", ["sphere", "dual", "stereographic", "gnomonic", "graph"])
def test_style_by_signs_by_number_and_by_circle(view):
    planes = generic(4)
    drawn, regions = planes.draw(view), planes.regions()
    front = [k for k in (1, 3, 5) if any(f"-{k}" in x.name for x in drawn.scene.items)]
    for number in front:
        signs = exact.sign_text(regions[number - 1].signs)
        for which, fill in ((signs, f"#12345{number}"), (number, f"#65432{number}")):
            drawn.region(which).set(fc=fill)
            styled = [x.name for x in drawn.scene.items if x.style.get("fc") == fill]
            assert {name.split("-")[1] for name in styled} == {str(number)}
    for number in (1, 2, 3, 4):
        drawn.circle(number).set(ec=f"#00000{number}")
    lines = [x for x in drawn.scene.items if re.match("(front|back|arc|edge)-|limb-.*-", x.name)]
    for item in lines:
        assert item.style["ec"] == f"#00000{item.name.split('-')[1]}", item.name
    assert {x.style["ec"] for x in lines} == {f"#00000{k}" for k in (1, 2, 3, 4)}
    for wrong in (lambda: drawn.region("+++++"), lambda: drawn.circle(5), lambda: drawn.region(99)):
        with pytest.raises(InputError, match=r"the picture has no .*; it has"):
            wrong()
    signs = regions[front[0] - 1].signs
    drawn.region(signs).set(facecolor="#abcdef")
    assert "#abcdef" in {x.style.get("fc") for x in drawn.scene.items}
    for style, said in (
        ({"linewith": 2}, "did you mean linewidth"),
        ({"fc": 3}, "colour"),
        ({"color": "red"}, "is for text"),
    ):
        with pytest.raises(InputError, match=said):
            drawn.region(signs).set(**style)


def test_panels_share_common_legend_entries(tmp_path):
    planes, grasp = read_arrangement("braid-a3"), read_grasp("paper-four-contacts")
    parts = [planes.draw("sphere"), planes.draw("graph"), grasp.draw()]
    whole = compose(parts, titles=["one", "two", "three"])
    names = {item.name for item in whole.scene.items} - {""}
    for k, part in enumerate(parts, 1):
        assert {f"panel-{k}-{x.name}" for x in part.scene.items if x.name} < names
    assert len({entry.split()[0] for entry in whole.scene.legend.table}) == 24
    texts = [key.text for key in whole.scene.legend.keys]
    assert len(texts) == len(set(texts)) > 3
    assert not offences(lay_out(whole.scene))
    whole.restyle("panel-1-region-2", fc="#123456")
    for suffix in ("svg", "tex"):
        whole.write(tmp_path / f"a.{suffix}")
        assert "123456" in (tmp_path / f"a.{suffix}").read_text()
    for wrong in ({"columns": 0}, {"titles": ["one"]}):
        with pytest.raises(InputError):
            compose(parts, **wrong)
    with pytest.raises(InputError, match="no element"):
        whole.restyle("panel-4-*", fc="red")


def test_panels_of_unlike_counts_keep_their_keys():
    """Both have a tinted key, which means 4 bounded regions here and 12 there."""
    whole = compose([shi("A2").draw(), catalan("A2").draw()])
    assert not whole.scene.legend.keys
    texts = {item.text for item in whole.scene.items if isinstance(item, Label)}
    assert {"4 bounded regions", "12 bounded regions", "(a)", "(b)"} < texts


def test_several_views_are_panels_of_one_width(tmp_path, capsys):
    path = tmp_path / "two.svg"
    words = ["draw", "braid-a3", "-o", str(path), "--view", "sphere,dual", "--labels", "none"]
    assert draw_planes([*words, "--width", "150", "--columns", "1"]) == 0
    (found,) = re.findall(r'<svg.* width="([0-9.]+)pt"', path.read_text())
    assert float(found) == pytest.approx(150 * 72 / 25.4)
    assert draw_planes([*words[:-1], "non"]) == 2
    assert "did you mean none" in capsys.readouterr().err
    assert draw_planes(["draw", "braid-a3", "-o", str(path), "--columns", "2"]) == 2


def test_what_turns_is_a_gif_of_so_many_pictures(tmp_path, monkeypatch, capsys):
    path = tmp_path / "turn.gif"
    write_drawing(read_arrangement("coordinate-planes"), path, "planes", frames=3)
    with Image.open(path) as found:
        assert found.n_frames == 3
    films: list[Any] = []
    monkeypatch.setattr(Printing, "write_movie", lambda *arguments: films.append(arguments))
    write_drawing(read_arrangement("coordinate-planes"), path, "planes")
    assert [change["azimuth"] for change in films[0][-1](4)] == [0, 90, 180, 270]
    assert draw_planes(["draw", "braid-a3", "-o", str(path), "--view", "graph"]) == 2
    assert "does not turn; there are sphere, planes" in capsys.readouterr().err


def test_a_quarter_turn_of_the_viewer_is_that_of_the_direction():
    planes = read_arrangement("coordinate-planes")
    turned, meant = ({"camera": (3, 1, 2), "azimuth": 90.0}, {"camera": (-1, 3, 2)})
    one, other = (OF_PLANES.draw(planes, "cells", **how).scene.items for how in (turned, meant))
    for a, b in zip(one, other, strict=True):
        assert a.name == b.name
        if isinstance(a, Drawn):
            assert np.abs(a.points - b.points).max() < 0.2


@pytest.mark.parametrize(
    ("drawings", "name", "view", "flat"),
    [
        (OF_PLANES, "braid-a3", "cells", "sphere"),
        (OF_GRASPS, "paper-three-contacts", "wrench-set", "slice"),
    ],
)
def test_a_view_with_a_model_names_it(drawings, name, view, flat, tmp_path):
    subject = read_arrangement(name) if drawings is OF_PLANES else read_grasp(name)
    written = drawings.write(subject, tmp_path / "a.stl", view)
    assert written == {"model": view}
    with pytest.raises(InputError, match="has no model; there are models of"):
        drawings.write(subject, tmp_path / "a.stl", flat)


@pytest.mark.parametrize("name", [*OF_PLANES.views, *OF_PLANES.pages])
def test_help_explains_the_options_of_a_view_and_of_no_other(name, capsys):
    kind = "view" if name in OF_PLANES.views else "page"
    helps = []
    for words in (["draw", "--view", name, "--help"], ["draw", "--help"]):
        with pytest.raises(SystemExit):
            draw_planes(words)
        helps.append(capsys.readouterr().out)
    assert "draw_" not in helps[0]
    assert helps[1].count("\n") < 80
    for option in OF_PLANES.options(kind, name):
        assert re.search(rf"^  --{option.replace('_', '-')}\b", helps[0], re.MULTILINE)
    assert ("--window" in helps[0]) == (name == "lines")
    for kind in ("model", "page"):
        there = name in OF_PLANES.entries(kind)
        assert (re.search(rf"^{kind} {name}: ", helps[0], re.MULTILINE) is not None) == there


@pytest.mark.parametrize(
    ("main", "drawings"), [(draw_planes, OF_PLANES), (draw_grasps, OF_GRASPS)], ids=["arr", "eq"]
)
def test_help_without_a_view_lists_views_and_common_options(main, drawings, capsys):
    with pytest.raises(SystemExit):
        main(["draw", "--help"])
    text = capsys.readouterr().out
    assert "draw --view VIEW --help" in text.splitlines()[2]
    for kind in ("view", "model", "page"):
        for name in getattr(drawings, f"{kind}s"):
            shown = name if kind == "view" else f"{kind} {name}"
            first = drawings.summary(kind, name).split()[0]
            assert re.search(rf"^  {shown} +{first}", text, re.MULTILINE), shown
    for option in ("view", "model", "width", "font", "font-size", "theme", "legend", "camera"):
        assert re.search(rf"^  --{option}\b", text, re.MULTILINE), option
    for option in ("labels", "lift", "rays", "tolerance", "frames", "fragment"):
        assert f"--{option}" not in text


@pytest.mark.parametrize(
    ("main", "words", "old", "new"),
    [
        (draw_planes, "braid-a3", "direction", "camera"),
        (draw_planes, "braid-a3", "base", "bottom"),
        (draw_planes, "braid-a3", "color", "colour"),
        (draw_planes, "braid-a3", "plane", "section"),
        (draw_grasps, "ladder", "direction", "camera"),
        (draw_grasps, "ladder", "directions", "rays"),
        (draw_grasps, "ladder", "axes", "slice"),
        (draw_grasps, "ladder", "turn", "rotation"),
        (draw_grasps, "ladder", "piece", "equilibrium"),
    ],
)
def test_another_word_for_an_option_is_answered_with_its_name(
    main, words, old, new, tmp_path, capsys
):
    path = str(tmp_path / "a.svg")
    with pytest.raises(SystemExit):
        main(["draw", words, "-o", path, f"--{old}", "1", "2", "3"])
    refused, first, *_ = capsys.readouterr().err.splitlines()
    assert f" draw has no option '--{old}'; expected one of these, " in refused
    assert first.startswith(f"  --{new} ")


def test_another_word_for_a_keyword_is_answered_with_its_name(tmp_path):
    planes, grasp = read_arrangement("braid-a3"), read_grasp("three-fingers-on-a-ball")
    for call in (
        lambda: planes.draw("sphere", direction=(1, 2, 3)),
        lambda: planes.draw("sphere,dual", direction=(1, 2, 3)),
        lambda: write_drawing(planes, tmp_path / "a.svg", "planes", direction=(1, 2, 3)),
    ):
        with pytest.raises(InputError, match=r"no option direction; use camera[.]"):
            call()
    with pytest.raises(TypeError, match=r"draw_sphere has no argument direction; use camera[.]"):
        draw_sphere(planes, direction=(1, 2, 3))
    with pytest.raises(InputError, match=r"no option axes; use slice[.]"):
        grasp.draw("slice", axes="fx,fz")
    with pytest.raises(InputError, match=r"no option base[.] It has"):
        planes.draw("sphere", base="1")


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".png"])
def test_a_font_is_used_in_every_drawn_format(suffix, tmp_path):
    planes = read_arrangement("coordinate-planes")
    plain, serif, named = (tmp_path / f"{name}{suffix}" for name in ("plain", "serif", "named"))
    write_drawing(planes, plain)
    write_drawing(planes, serif, font="dejavu serif")
    assert serif.read_bytes() != plain.read_bytes()
    if suffix == ".pdf":
        assert b"DejaVuSerif" in serif.read_bytes()
    if suffix == ".png":
        write_drawing(planes, named, font="DejaVu Sans")
        assert named.read_bytes() == plain.read_bytes()


def test_a_font_is_named_in_editable_text_and_measured(tmp_path):
    planes, path = read_arrangement("braid-a3"), tmp_path / "a.svg"
    write_drawing(planes, path, font="DejaVu Sans Mono", text="text")
    assert "'DejaVu Sans Mono'" in path.read_text()
    with own_settings():
        plain = measure("regions")
    with own_settings(font_settings("DejaVu Sans Mono")):
        assert measure("regions") != plain


def test_a_font_that_is_not_installed_is_refused_with_near_names(tmp_path, capsys):
    for font, expected in (("dejavu", "DejaVu Serif"), ("DejaVu Seriff", "DejaVu Serif")):
        with pytest.raises(InputError, match=expected):
            write_drawing(read_arrangement("braid-a3"), tmp_path / "a.svg", font=font)
    with pytest.raises(InputError, match="TeX sets"):
        write_drawing(read_arrangement("braid-a3"), tmp_path / "a.tex", font="DejaVu Sans")
    assert not [*tmp_path.iterdir()]


def test_bounded_regions_and_others_have_colours_of_their_own():
    lines = read_arrangement("shi-a2-affine")
    for colour, bounded, others in (
        ("bounded:gold,#0af", "#ffd700", "#00aaff"),
        ("bounded:gold", "#ffd700", "#ffffff"),
        ("gold", "#ffd700", "#ffd700"),
    ):
        made = lines.draw("lines", colour=colour)
        fills = {x.name: x.style["fc"] for x in made.scene.items if "fc" in x.style}
        for k, face in enumerate(lines.regions()):
            expected = bounded if face.is_bounded else others
            assert to_hex(fills[f"region-{k + 1}"]) == expected
    with pytest.raises(InputError, match="bounded takes two colours and has 3"):
        lines.draw("lines", colour="bounded:gold,red,blue")


def test_planes_have_colours_of_the_user():
    made = read_arrangement("coordinate-planes").draw("planes", colour="#ff0000,#00ff00,#0000ff")
    facets = [item for item in made.scene.items if (item.name or "").startswith("facet-")]
    brightest = {max(range(3), key=lambda k: to_rgb(item.style["fc"])[k]) for item in facets}
    assert brightest == {0, 1, 2}


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_dots_and_background_of_a_picture_are_chosen(theme, tmp_path):
    sizes, corners = [], []
    for name, options in (("a.png", {"dpi": 72}), ("b.png", {"dpi": 144, "transparent": True})):
        planes = read_arrangement("braid-a3")
        write_drawing(planes, tmp_path / name, "sphere", theme=theme, **options)
        with Image.open(tmp_path / name) as picture:
            sizes.append(picture.width)
            corners.append(picture.convert("RGBA").getpixel((0, 0))[3])
    assert sizes[1] == pytest.approx(2 * sizes[0], abs=1)
    assert corners == [255, 0]


@pytest.mark.parametrize(
    ("path", "options", "message"),
    [
        ("a.svg", {"dpi": 100}, "choice of .png"),
        ("a.png", {"dpi": 5}, "dpi is 5; expected 20 to 2400"),
        ("a.tex", {"transparent": True}, "is for .svg, .pdf and .png"),
    ],
)
def test_dots_and_background_that_do_not_fit_are_refused(path, options, message, tmp_path):
    with pytest.raises(InputError, match=message):
        write_drawing(read_arrangement("braid-a3"), tmp_path / path, **options)


def test_kinds_of_fonts_are_those_of_matplotlib():
    assert font_settings("serif")["font.family"][0] == "DejaVu Serif"
    assert font_settings("Sans-serif")["font.family"][0] == "DejaVu Sans"
    assert font_settings("mono")["font.family"][0] == "DejaVu Sans Mono"


def test_panels_of_several_views_have_one_size():
    made = lay_out(read_arrangement("braid-a3").draw("sphere,dual,graph,lattice").scene)
    assert made.height < 1.3 * made.width
    names = {item.name for item in made.items}
    assert {"panel-1-region-2", "panel-2-vertex-2", "panel-3-vertex-2"} <= names
    assert not [name for name in names if name.startswith("panel-2-region")]
    tall = read_arrangement("braid-a3").draw("dual", width=88.0)
    assert [x for x in tall.scene.items if x.name.startswith("region-")]
    assert tall.scene.height == pytest.approx(2 * tall.scene.width, rel=0.01)
