"""The registries of drawings: options are those of the views, scenes know no format, no circles."""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arrangement import Arrangement, ArrangementError, InputError, read_arrangement
from arrangement.cli import main as draw_planes
from arrangement.drawing.command import _KINDS
from arrangement.drawing.registry import Drawings
from arrangement.drawing.scene.items import ROLES, Ball, Item, Label, Mark
from arrangement.drawing.scene.scene import Scene
from arrangement.pictures import DRAWINGS as OF_PLANES
from arrangement.pictures.views import drawings_of, write_drawing
from equilibrium import read_grasp
from equilibrium.cli.program import main as draw_grasp
from equilibrium.pictures import DRAWINGS as OF_GRASPS
from tests.docpages import ROOT

KINDS = ("view", "model", "page")
ALL = [
    (drawings, kind, name)
    for drawings in (OF_PLANES, OF_GRASPS)
    for kind in KINDS
    for name in getattr(drawings, f"{kind}s")
]
SUBJECTS = {
    "arrangement.pictures": read_arrangement("braid-a3"),
    "equilibrium.pictures": read_grasp("paper-three-contacts-preload-1"),
}


def function(drawings: Drawings, kind: str, name: str) -> Any:
    module, _, found = getattr(drawings, f"{kind}s")[name].partition(":")
    return getattr(importlib.import_module(f"{drawings.package}.{module}"), found)


@pytest.mark.parametrize(("drawings", "kind", "name"), ALL)
def test_every_option_has_a_form_on_the_command_line(
    drawings: Drawings, kind: str, name: str
) -> None:
    for option in drawings.options(kind, name).values():
        assert option.kind in _KINDS
        assert option.text, option.name


@pytest.mark.parametrize(("drawings", "name"), [(d, n) for d, k, n in ALL if k == "view"])
def test_a_view_makes_a_scene_that_knows_no_format(drawings: Drawings, name: str) -> None:
    needed = [o.name for o in drawings.options("view", name).values() if o.required]
    options = {key: [(0, 2, 0)] if key == "wrenches" else (0, 2, 0) for key in needed}
    subject = read_arrangement("pencil") if name == "lines" else SUBJECTS[drawings.package]
    scene = function(drawings, "view", name).scene(subject, **options)
    assert isinstance(scene, Scene)
    assert scene.items
    assert len({item.name.partition("-")[0] for item in scene.items}) > 1
    for item in scene.items:
        assert isinstance(item, Item)
        assert item.role in ROLES
        points = (
            item.place if isinstance(item, Label | Mark)
            else item.centre if isinstance(item, Ball) else item.points
        )  # fmt: skip
        assert np.isfinite(np.asarray(points)).all()


@pytest.mark.parametrize(
    ("drawings", "view", "options", "meant"),
    [
        (OF_PLANES, "spere", {}, "did you mean sphere"),
        (OF_PLANES, "lattice", {"mobius": True}, "did you mean moebius"),
        (OF_PLANES, "sphere", {"colour": "side"}, "did you mean sides"),
        (OF_GRASPS, "slices", {}, "did you mean slice"),
        (OF_GRASPS, "resist", {"extend": 3}, "did you mean extent"),
    ],
)
def test_mistakes_name_the_nearest_names(
    drawings: Drawings, view: str, options: dict[str, Any], meant: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=meant):
        drawings.write(SUBJECTS[drawings.package], tmp_path / "a.svg", view, **options)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("main", "words"),
    [
        (draw_planes, ["pencil", "--with", "90"]),
        (draw_grasp, ["paper-three-contacts", "--with", "90"]),
    ],
)
def test_the_command_line_names_the_nearest_option(
    main: Any, words: list[str], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["draw", *words, "-o", str(tmp_path / "a.svg")])
    assert stopped.value.code == 2
    assert "did you mean --width" in capsys.readouterr().err


HUGE = 10**350
LARGE = {
    "one": [(HUGE + 7, 1, 0), (0, 1, 1), (1, 0, 2), (1, 1, 1)],
    "all": [(1, HUGE, HUGE), (HUGE, HUGE + 1, 1), (HUGE, 1, HUGE), (1, 1, 1)],
}


@pytest.mark.campaign
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("normals", LARGE.values(), ids=LARGE)
@pytest.mark.parametrize("kind", ["view", "page", "model"])
def test_normals_beyond_floats_are_drawn_or_refused(
    kind: str, normals: list[tuple[int, ...]], tmp_path: Path
) -> None:
    planes = Arrangement(normals)
    drawings = drawings_of(planes)
    suffix = {"view": "svg", "page": "html", "model": "stl"}[kind]
    for name in getattr(drawings, f"{kind}s"):
        path = tmp_path / f"{name}.{suffix}"
        try:
            drawings.write(planes, path, **{"model" if kind == "model" else "view": name})
        except ArrangementError as refused:
            error = str(refused)
        else:
            continue
        assert re.search("about 1.8e308|floats|when rounded|shows planes of rank", error), error
        assert not path.exists()


def test_a_page_of_normals_of_five_thousand_digits(tmp_path: Path) -> None:
    long = 10**5000
    write_drawing(Arrangement([(long, 1, 0), (0, 1, 1), (1, 0, 2)]), tmp_path / "a.html")
    assert "0" * 5000 in (tmp_path / "a.html").read_text(encoding="utf-8")


def test_a_wrench_beyond_floats_has_no_page(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = tmp_path / "a.html"
    words = ["draw", "paper-three-contacts", "--wrench", "0", "9" * 5000, "0", "-o", str(path)]
    assert draw_grasp(words) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: a number of the input is too large for a picture")
    assert error.count("\n") == 1
    assert not path.exists()


def test_a_slice_takes_the_preload_of_its_last_part(tmp_path: Path) -> None:
    command = ["draw", "paper-three-contacts", "--view", "slice", "--preload", "2"]
    assert draw_grasp([*command, "-o", str(tmp_path / "a.svg")]) == 0
    scene = function(OF_GRASPS, "view", "slice").scene(
        read_grasp("paper-three-contacts"), preload=2
    )
    assert "(c) preload 2" in {item.text for item in scene.items if isinstance(item, Label)}


def imports(path: Path, package: str) -> Iterator[str]:
    """Yield the modules of a package that one of them names, inside functions too."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            if node.level == 1:
                yield f"{package}.{node.module}"
            elif node.level == 0 and re.match(
                r"(arrangement|equilibrium)\.(drawing|pictures)\.", node.module
            ):
                yield node.module


def test_no_circle_of_imports_among_the_drawings() -> None:
    graph = {}
    for package in ("arrangement.drawing", "arrangement.pictures", "equilibrium.pictures"):
        for path in ROOT.joinpath(*package.split(".")).rglob("*.py"):
            name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
            room = name.rpartition(".")[0]
            graph[name.removesuffix(".__init__")] = set(imports(path, room))
    assert len(graph) > 40
    list(TopologicalSorter(graph).static_order())
    graph["arrangement.drawing.scene.scene"].add("arrangement.pictures.sphere.sphere")
    with pytest.raises(CycleError):
        list(TopologicalSorter(graph).static_order())
    views = {f"{d.package}.{t.split(':')[0]}" for d in (OF_PLANES, OF_GRASPS)
             for t in (*d.views.values(), *d.models.values(), *d.pages.values())}  # fmt: skip
    for low in ("registry", "command", "scene.scene", "figure", "output"):
        assert not graph[f"arrangement.drawing.{low}"] & views - {
            "arrangement.pictures.sphere.sphere"
        }


@pytest.mark.parametrize(
    ("planes", "names"), [("braid-a3", "xyz"), ("paper-three-contacts", "xyr")]
)
def test_axes_without_names_are_on(planes: str, names: str, tmp_path: Path) -> None:
    words = ["draw", planes, "--text", "text", "--axes", "-o", str(tmp_path / "a.svg")]
    assert draw_planes(words) == 0
    written = re.findall(r">([xyzr])</text>", (tmp_path / "a.svg").read_text(encoding="utf-8"))
    assert sorted(written) == sorted(names)


def test_a_misspelt_theme_is_told_the_nearest_one(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert draw_planes(["draw", "pencil", "--theme", "drak", "-o", str(tmp_path / "a.svg")]) == 2
    assert "did you mean dark?" in capsys.readouterr().err
