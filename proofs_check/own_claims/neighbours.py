"""What a file of claims imports from its folder: found there first, and unloaded after it.

Two files that each have a ``helper.py`` beside them import their own one, in any order, and the
digests tell when one of them has changed.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from hashlib import sha256
from importlib.abc import MetaPathFinder
from importlib.machinery import SOURCE_SUFFIXES, FileFinder, ModuleSpec, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

#: Packages that are never taken from a folder, not even from that of this repository.
_OWN = {"arrangement", "equilibrium", "proofs_check"}
#: Modules that are never set aside.
_FIXED = {"__main__", *_OWN, *sys.stdlib_module_names}


@contextmanager
def imports_from(folder: Path) -> Iterator[dict[str, str]]:
    """Let imports find the modules of a folder first, and forget these modules at the end.

    Modules of the same names that others have imported are set aside meanwhile. An import inside
    of a function, which runs later, does not find the folder.

    Yields:
        The SHA-256 of each file that was imported from the folder, filled at the end.
    """
    aside = {n: m for n, m in sys.modules.items() if _top(n) not in _FIXED and _has(folder, n)}
    for name in aside:
        del sys.modules[name]
    before = set(sys.modules)
    finder = _FolderFinder(folder)
    sys.meta_path.insert(0, finder)
    sys.path.insert(0, str(folder))  # for packages without __init__.py, and compiled modules
    digests: dict[str, str] = {}
    try:
        yield digests
    finally:
        sys.path.remove(str(folder))
        sys.meta_path.remove(finder)
        new = [name for name in sys.modules if name not in before]
        of_folder = {name for name in new if "." not in name and _is_in(folder, sys.modules[name])}
        for name in new:
            if _top(name) in of_folder:
                spec = sys.modules.pop(name).__spec__
                if spec is not None and spec.has_location and spec.origin:
                    digests[spec.origin] = sha256_of(spec.origin)
        sys.modules.update(aside)


def sha256_of(file: str) -> str:
    """Return the SHA-256 of a file, "" if it cannot be read."""
    try:
        return sha256(Path(file).read_bytes()).hexdigest()
    except OSError:
        return ""


def _top(name: str) -> str:
    return name.partition(".")[0]


def _has(folder: Path, name: str) -> bool:
    top = folder / _top(name)
    return top.with_suffix(".py").is_file() or (top / "__init__.py").is_file()


def _is_in(folder: Path, module: ModuleType) -> bool:
    """Return whether a module is a file or a package of the folder."""
    spec = module.__spec__
    if spec is None:
        return False
    if spec.submodule_search_locations is not None:
        return any(Path(place).parent == folder for place in spec.submodule_search_locations)
    return spec.has_location and Path(spec.origin or "").parent == folder


class _FolderFinder(MetaPathFinder):
    """Finds the Python files of a folder before all others."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: Any = None
    ) -> ModuleSpec | None:
        """Return how to load a module that is a file of the folder or of a package in it."""
        top = _top(fullname)
        if top in _OWN:
            return None
        for place in path if path is not None else [str(self.folder)]:
            if path is None or Path(place).is_relative_to(self.folder / top):
                finder = FileFinder(place, (_UncachedLoader, SOURCE_SUFFIXES))
                spec = finder.find_spec(fullname)
                if spec is not None and spec.loader is not None:
                    return spec
        return None


class _UncachedLoader(SourceFileLoader):
    """Compiles a file anew: a ``.pyc`` file is as old as a second and a length can tell."""

    def get_code(self, fullname: str) -> CodeType:
        source = self.get_data(self.path)
        code: CodeType = compile(source, self.path, "exec", dont_inherit=True)
        return code
