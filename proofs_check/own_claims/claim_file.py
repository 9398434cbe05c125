"""Files of claims: Python programs that are run, with messages that name their lines.

A file is run once for each content of it and of what it imports from its folder (`imports_from`).
Two files that each have a ``helper.py`` beside them import their own one, in any order. The claims
return the values of comparisons that are false (`false_comparison`).
"""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from hashlib import sha256
from importlib.abc import MetaPathFinder
from importlib.machinery import SOURCE_SUFFIXES, FileFinder, ModuleSpec, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any, NamedTuple, TypeVar

from arrangement.errors import refusal
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError
from proofs_check.statements.statement import Claim, Registry

from .false_comparison import COMPARE_NAME, compare_values, explain_returns

#: Of a source line or of an error's text: so that a message stays short.
_MAX_QUOTED_CHARACTERS = 200
#: Longer ids break every table of claims.
_MAX_ID_CHARACTERS = 80
_Kind = TypeVar("_Kind")


def load(path: str) -> Registry:
    """Run a Python file and return the claims in it, in order of definition.

    Raises:
        OwnClaimError: the file cannot be read or run, has no claims, or two with one id.
    """
    claims = values_in_file(path, Claim, "claims; decorate a function with @claim(...)")
    name = Path(path).name
    return Registry(replace(c, file=path, locator=c.locator or name) for c in claims)


def claims_named(name: str) -> tuple[Claim, ...]:
    """Return the claims that FILE.py means, all of the file, or FILE.py:ID, one of them.

    Raises:
        OwnClaimError: as `load`, or the file has no claim with this id.
    """
    file, id = split(name)
    if file is None:
        raise OwnClaimError(f"{shown(name)} is not a file of claims; give FILE.py or FILE.py:ID")
    claims = tuple(load(file))
    chosen = tuple(claim for claim in claims if id in ("", claim.id))
    if not chosen:
        known = [claim.id for claim in claims]
        raise OwnClaimError(str(refusal(f"{file} has no claim {shown(id)}", id, known, "it has")))
    return chosen


def split(name: str) -> tuple[str | None, str]:
    """Split FILE.py or FILE.py:ID into the file (None: no file is named) and the id (or "")."""
    if name.endswith(".py"):
        return name, ""
    stem, colon, id = name.rpartition(".py:")
    return (f"{stem}.py", id) if colon else (None, name)


def values_in_file(path: str, kind: type[_Kind], what: str) -> tuple[_Kind, ...]:
    """Run a Python file and return the values of a kind that it has names for, in order.

    Args:
        what: the kind in words, for the error that the file has none.

    Raises:
        OwnClaimError: the file cannot be read or run, or has none.
    """
    module = _run(path).module
    of_kind = [value for value in vars(module).values() if isinstance(value, kind)]
    if not of_kind:
        raise OwnClaimError(f"{path} has no {what}")
    return tuple({id(value): value for value in of_kind}.values())  # once, under several names too


def file_digest(path: str) -> str:
    """Return a SHA-256 of a file of claims and of what it imports from its folder.

    A sweep knows by it that neither has changed. Without such imports it is that of the file.

    Raises:
        OwnClaimError: the file cannot be read or run.
    """
    (_, own), *others = file_digests(path).items()
    return sha256(repr([own, *sorted(others)]).encode()).hexdigest() if others else own


def file_digests(path: str) -> dict[str, str]:
    """Return the SHA-256 of a file of claims, then of what it imports from its folder, by names.

    Raises:
        OwnClaimError: the file cannot be read or run.
    """
    digests = _run(path).digests
    folder = Path(next(iter(digests))).parent
    return {Path(file).relative_to(folder).as_posix(): digest for file, digest in digests.items()}


class _Run(NamedTuple):
    """A file that was run.

    Attributes:
        module: what it defines.
        digests: the SHA-256 of the file, and of each file of its folder that it imports.
    """

    module: ModuleType
    digests: dict[str, str]

    @property
    def is_current(self) -> bool:
        """Whether no file has changed since."""
        return all(sha256_of(file) == digest for file, digest in self.digests.items())


#: The last runs, by path.
_runs: dict[str, _Run] = {}
_MAX_RUNS = 16


def _run(path: str) -> _Run:
    """Run a file as a module, once for each content of it and of what it imports."""
    shown_path, path = path, str(Path(path).resolve())
    if path in _runs and _runs[path].is_current:
        return _runs[path]
    try:
        digest = sha256(Path(path).read_bytes()).hexdigest()
    except OSError as error:
        raise OwnClaimError(f"cannot read {shown_path}: {error.strerror}") from None
    name = f"proofs_check_own_{sha256(f'{digest} {path}'.encode()).hexdigest()[:16]}"
    loader = _ClaimFileLoader(name, path)
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    vars(module)[COMPARE_NAME] = compare_values
    sys.modules[name] = module
    try:
        with imports_from(Path(path).parent) as digests:
            loader.exec_module(module)
    except OwnClaimError:
        raise
    except SyntaxError as error:
        source = f": {error.text.strip()[:_MAX_QUOTED_CHARACTERS]}" if error.text else ""
        where = f"{Path(error.filename or path).name}, line {error.lineno}"
        raise OwnClaimError(f"{where}: {type(error).__name__}: {error.msg}{source}") from error
    except Exception as error:
        reason = f"{type(error).__name__}: {str(error)[:_MAX_QUOTED_CHARACTERS]}"
        where = line_of(error, path)
        raise OwnClaimError(f"{path} does not run: {reason} ({where})") from error
    if len(_runs) >= _MAX_RUNS:
        del _runs[next(iter(_runs))]
    _runs[path] = _Run(module, {path: digest, **digests})
    return _runs[path]


class _ClaimFileLoader(SourceFileLoader):
    """Compiles a file with `explain_returns`, and neither reads nor writes a ``.pyc`` file."""

    def get_code(self, fullname: str) -> CodeType:
        tree = ast.parse(self.get_data(self.path), self.path)
        explain_returns(tree)
        code: CodeType = compile(tree, self.path, "exec", dont_inherit=True)
        return code


def line_of(error: BaseException, path: str) -> str:
    """Return where in a file an error arose, as "NAME, line N: SOURCE"; "" if not in this file."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == path]
    if not frames:
        return ""
    source = (frames[-1].line or "")[:_MAX_QUOTED_CHARACTERS]
    return f"{Path(path).name}, line {frames[-1].lineno}: {source}"


def heading(path: str) -> str:
    """Return the first line of the docstring of a file, or ""."""
    docstring = ast.get_docstring(ast.parse(Path(path).read_bytes())) or ""
    return docstring.partition("\n")[0]


def id_of(function: Callable[..., Any], id: str | None) -> str:
    """Return the id of a claim or exercise: the one given, or the name of its function.

    Raises:
        OwnClaimError: it is not of lower case words with hyphens, or too long.
    """
    name = id or function.__name__.strip("_").lower().replace("_", "-")
    if not re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", name):
        raise OwnClaimError(f"{shown(name)} is not an id; use lower case words with hyphens")
    if len(name) > _MAX_ID_CHARACTERS:
        raise OwnClaimError(f"the id {shown(name)} is longer than {_MAX_ID_CHARACTERS} characters")
    return name


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
