"""Named arrangements that ship with the package, for users, tests and figures."""

from __future__ import annotations

from importlib.resources import files
from importlib.resources.abc import Traversable


def paths() -> dict[str, Traversable]:
    """Return the built-in arrangements: their files by name."""
    folders = (folder for folder in files(__name__).iterdir() if folder.is_dir())
    known = {path.name: path for folder in folders for path in folder.iterdir()}
    return {
        name.removesuffix(".json"): known[name] for name in sorted(known) if name.endswith(".json")
    }
