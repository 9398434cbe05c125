"""Named grasps that ship with the package, for users, tests and figures."""

from __future__ import annotations

from importlib.resources import files
from importlib.resources.abc import Traversable


def paths() -> dict[str, Traversable]:
    """Return the built-in grasps: their files by name."""
    folders = (folder for folder in files(__name__).iterdir() if folder.is_dir())
    found = {path.name: path for folder in folders for path in folder.iterdir()}
    return {
        name.removesuffix(".json"): found[name] for name in sorted(found) if name.endswith(".json")
    }
