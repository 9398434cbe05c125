"""Dual polyhedra as meshes and files: closed, oriented, of the stated size, whole or absent."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import trimesh
from hypothesis import given, settings

from arrangement import Arrangement, ArrangementError, InputError
from arrangement.duals.zonohedron import dual_polyhedron

from .test_dual import A3, CUBE_DIAGONALS, DEGENERATE, SQUARE_AXES, rank_three, rank_three_only


@settings(max_examples=15, deadline=None)
@given(rank_three)
def test_mesh_is_closed_oriented_and_of_euler_number_two(planes: Arrangement) -> None:
    mesh = dual_polyhedron(rank_three_only(planes)).to_trimesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert mesh.volume > 0


def test_volume_of_the_mesh_is_the_sum_of_determinants() -> None:
    """The volume of a zonotope is 8 times the sum of all |det(g_i, g_j, g_k)| (McMullen)."""
    mesh = dual_polyhedron(Arrangement(CUBE_DIAGONALS)).to_trimesh()
    assert mesh.volume == pytest.approx(8 * 4 * 4)


@pytest.mark.parametrize("suffix", [".stl", ".glb", ".obj"])
@pytest.mark.parametrize("normals", [A3, DEGENERATE], ids=["A3", "degenerate"])
def test_model_files_come_back_closed_and_of_the_stated_size(
    normals: list[list[int]], suffix: str, tmp_path: Path
) -> None:
    path = tmp_path / f"model{suffix}"
    dual = dual_polyhedron(Arrangement(normals))
    dual.export(path, size=40)
    mesh: Any = trimesh.load(path, force="mesh")
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.euler_number == 2
    assert mesh.volume > 0
    assert len(mesh.vertices) == len(dual.vertices)
    largest = 0.040 if suffix == ".glb" else 40
    assert max(mesh.extents) == pytest.approx(largest, rel=1e-6)
    assert list(tmp_path.iterdir()) == [path]


def test_obj_keeps_whole_polygons(tmp_path: Path) -> None:
    dual_polyhedron(Arrangement(A3)).export(tmp_path / "a3.obj")
    lines = (tmp_path / "a3.obj").read_text().splitlines()
    assert Counter(len(line.split()) - 1 for line in lines if line.startswith("f ")) == {4: 6, 6: 8}


def test_a_failed_export_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "model.stl"
    path.write_bytes(b"old")

    def fail(self: Path, target: Path) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(InputError, match="disk full"):
        dual_polyhedron(Arrangement(SQUARE_AXES)).export(path)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("size", [0, -1, float("nan"), float("inf"), "40"])
def test_a_size_must_be_a_positive_number(size: Any) -> None:
    with pytest.raises(InputError, match="size"):
        dual_polyhedron(Arrangement(SQUARE_AXES)).to_trimesh(size)


def test_unknown_formats_and_missing_folders_are_refused(tmp_path: Path) -> None:
    dual = dual_polyhedron(Arrangement(SQUARE_AXES))
    with pytest.raises(InputError, match=r"\.glb, \.obj, \.stl"):
        dual.export(tmp_path / "model.step")
    with pytest.raises(InputError, match="cannot write"):
        dual.export(tmp_path / "absent" / "model.stl")


def test_vertices_that_rounding_would_join_are_refused() -> None:
    thin = dual_polyhedron(Arrangement(SQUARE_AXES), [1, 1, Fraction(1, 10**400)])
    thin.validate()
    with pytest.raises(ArrangementError, match="two vertices become one"):
        thin.to_trimesh(10)
