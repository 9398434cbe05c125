"""Named grasps that ship with the package, and contacts between bodies, for users and tests."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files
from importlib.resources.abc import Traversable


def paths() -> dict[str, Traversable]:
    """Return the built-in grasps: their files by name."""
    return _in([folder for folder in files(__name__).iterdir() if folder.name != "bodies"])


def bodies() -> dict[str, Traversable]:
    """Return the built-in contacts between several bodies: their files by name."""
    return _in([files(__name__).joinpath("bodies")])


def _in(folders: Iterable[Traversable]) -> dict[str, Traversable]:
    files = {path.name: path for folder in folders if folder.is_dir() for path in folder.iterdir()}
    return {
        name.removesuffix(".json"): files[name] for name in sorted(files) if name.endswith(".json")
    }
