"""Files of claims: Python programs that are run, with messages that name their lines.

While a file is read, the functions of its claims are changed in one point: where they return a
comparison that is false, they return the values compared (as pytest does for ``assert``).
"""

from __future__ import annotations

import ast
import importlib.util
import operator
import re
import sys
import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from hashlib import sha256
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType
from typing import Any, TypeVar

from arrangement.errors import refusal
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError
from proofs_check.statements.statement import Claim, Registry

#: What comparisons do, by the nodes of the syntax tree.
_COMPARISONS: dict[str, Callable[[Any, Any], Any]] = {
    "Eq": operator.eq,
    "NotEq": operator.ne,
    "Lt": operator.lt,
    "LtE": operator.le,
    "Gt": operator.gt,
    "GtE": operator.ge,
    "Is": operator.is_,
    "IsNot": operator.is_not,
    "In": lambda a, b: a in b,
    "NotIn": lambda a, b: a not in b,
}
#: Letters of a line, or of what an error says, that are printed.
_LONGEST = 200
#: Under this name a file finds `compared`; no name of a program can be the same.
_COMPARED = "@compared"
#: Longer names of claims break every table.
_LONGEST_ID = 80
_Kind = TypeVar("_Kind")


@dataclass(frozen=True)
class Unequal:
    """A comparison that is false, with its values in words."""

    text: str

    def __bool__(self) -> bool:
        return False


def id_of(function: Callable[..., Any], given: str | None) -> str:
    """Return the id of what a decorator makes: the one given, or the name of the function.

    Raises:
        OwnClaimError: it has other signs than those of an id, or very many.
    """
    name = given or function.__name__.strip("_").lower().replace("_", "-")
    if not re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", name):
        raise OwnClaimError(f"{shown(name)} is not an id; use lower case words with hyphens")
    if len(name) > _LONGEST_ID:
        raise OwnClaimError(f"the id {shown(name)} is longer than {_LONGEST_ID} characters")
    return name


def compared(text: str, kind: str, left: Any, right: Any) -> Any:
    """Return what a comparison gives; if it is False, what was compared."""
    found = _COMPARISONS[kind](left, right)
    if type(found).__name__ not in ("bool", "bool_") or found:
        return found
    return Unequal(f"{text} is false: {shown(left)} and {shown(right)}")


class _Comparisons(ast.NodeTransformer):
    """Puts `compared` around the comparisons that functions of claims return."""

    inside = False

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        before = self.inside
        names = (getattr(call, "func", None) for call in node.decorator_list)
        self.inside = any("claim" in (getattr(f, "id", ""), getattr(f, "attr", "")) for f in names)
        self.generic_visit(node)
        self.inside = before
        return node

    def visit_Return(self, node: ast.Return) -> ast.AST:
        if self.inside and node.value is not None:
            node.value = self._told(node.value)
        return node

    def _told(self, value: ast.expr) -> ast.expr:
        if isinstance(value, ast.BoolOp) and isinstance(value.op, ast.And):
            value.values = [self._told(part) for part in value.values]
        if not isinstance(value, ast.Compare) or len(value.ops) > 1:
            return value
        texts = (ast.unparse(value), type(value.ops[0]).__name__)
        arguments = [*map(ast.Constant, texts), value.left, *value.comparators]
        call = ast.Call(ast.Name(_COMPARED, ast.Load()), arguments, [])
        return ast.fix_missing_locations(ast.copy_location(call, value))


class _Loader(SourceFileLoader):
    """Compiles a file afresh, with its comparisons reported."""

    def path_stats(self, path: Any) -> Any:
        """Report nothing of the file, so that no compiled form is read or kept."""
        raise OSError

    def source_to_code(  # type: ignore[override]
        self, data: Any, path: Any, *, _optimize: int = -1
    ) -> Any:
        tree = _Comparisons().visit(ast.parse(data, path))
        return compile(tree, path, "exec", dont_inherit=True, optimize=_optimize)

    def exec_module(self, module: ModuleType) -> None:
        module.__dict__[_COMPARED] = compared
        super().exec_module(module)


def load(path: str) -> Registry:
    """Run a Python file and return the claims in it, in order of definition.

    Raises:
        OwnClaimError: the file cannot be read or run, has no claims, or two with one id.
    """
    found = defined(path, Claim, "claims; decorate a function with @claim(...)")
    name = Path(path).name
    return Registry(replace(one, file=path, locator=one.locator or name) for one in found)


def split(name: str) -> tuple[str | None, str]:
    """Return the file (None for the registry) and the id ("" for all claims of a file)."""
    if name.endswith(".py"):
        return name, ""
    file, found, id = name.rpartition(".py:")
    return (f"{file}.py", id) if found else (None, name)


def named(name: str) -> tuple[Claim, ...]:
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


def defined(path: str, kind: type[_Kind], what: str) -> tuple[_Kind, ...]:
    """Run a Python file and return the values of a kind that it has names for, in order.

    Raises:
        OwnClaimError: the file cannot be read or run, or has none; `what` says of what.
    """
    names = vars(_run(str(Path(path).resolve()), file_digest(path)))
    found = {id(value): value for value in names.values() if isinstance(value, kind)}
    if not found:
        raise OwnClaimError(f"{path} has no {what}")
    return tuple(found.values())


def file_digest(path: str) -> str:
    """Return the SHA-256 of a file of claims, by which a sweep knows that it has not changed."""
    try:
        return sha256(Path(path).read_bytes()).hexdigest()
    except OSError as error:
        raise OwnClaimError(f"cannot read {path}: {error.strerror}") from None


def heading(path: str) -> str:
    """Return the first line of the docstring of a file, or ""."""
    text = ast.get_docstring(ast.parse(Path(path).read_bytes())) or ""
    return text.partition("\n")[0]


def line_of(error: BaseException, path: str) -> str:
    """Return where in a file an error arose: its name, the line, and what stands there."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == path]
    if not frames:
        return ""
    return f"{Path(path).name}, line {frames[-1].lineno}: {(frames[-1].line or '')[:_LONGEST]}"


@lru_cache(maxsize=16)
def _run(path: str, digest: str) -> ModuleType:
    name = f"proofs_check_own_{digest[:16]}"
    spec = importlib.util.spec_from_file_location(name, path, loader=_Loader(name, path))
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    sys.path.insert(0, str(Path(path).parent))
    try:
        _Loader(name, path).exec_module(module)
    except OwnClaimError:
        raise
    except SyntaxError as error:
        stands = f": {error.text.strip()[:_LONGEST]}" if error.text else ""
        where = f"{Path(error.filename or path).name}, line {error.lineno}"
        raise OwnClaimError(f"{where}: {type(error).__name__}: {error.msg}{stands}") from error
    except Exception as error:
        where = line_of(error, path)
        raise OwnClaimError(
            f"{path} does not run: {type(error).__name__}: {str(error)[:_LONGEST]} ({where})"
        ) from error
    finally:
        sys.path.remove(str(Path(path).parent))
    return module
