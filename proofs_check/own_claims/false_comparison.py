"""Comparisons that show their two sides where they are false: "3 == 4 is false: 3 and 4".

A claim that ends with ``return len(p) == m`` returns False, and its two sides are lost: they are
values of a call that is over. Computing them again may change them (a random number, an iterator).
So, as pytest does with ``assert``, the source is changed before it is compiled::

    return len(p) == m    becomes    return compare_values("len(p) == m", "Eq", len(p), m)

Only comparisons that a claim itself returns, alone or joined by ``and``, are changed.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from arrangement.numbers.exact import shown

#: The name of `compare_values` in changed source; with its "@" no program can use it.
COMPARE_NAME = "@compare_values"
#: The comparisons, by the names of their classes in `ast`.
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


@dataclass(frozen=True)
class FalseComparison:
    """The result of a comparison that is false, in place of False.

    Attributes:
        text: the comparison and the values of its two sides.
    """

    text: str

    def __bool__(self) -> bool:
        return False


def compare_values(text: str, kind: str, left: Any, right: Any) -> Any:
    """Compare two values; return a `FalseComparison` in place of False.

    Args:
        text: the source of the comparison.
        kind: the name of its class in `ast`, such as "Eq".
    """
    result = _COMPARISONS[kind](left, right)
    is_boolean = type(result).__name__ in ("bool", "bool_")  # of Python or NumPy
    if is_boolean and not result:
        return FalseComparison(f"{text} is false: {shown(left)} and {shown(right)}")
    return result


def explain_returns(module: ast.Module) -> None:
    """Change the comparisons that the claims of a module return into calls of `compare_values`."""
    for node in ast.walk(module):
        if isinstance(node, ast.FunctionDef) and _is_claim(node):
            for statement in _own_returns(node):
                if statement.value is not None:
                    statement.value = _as_call(statement.value)


def _is_claim(function: ast.FunctionDef) -> bool:
    for decorator in function.decorator_list:
        match decorator:  # @claim(...) or @proofs_check.claim(...)
            case ast.Call(func=ast.Name(id="claim") | ast.Attribute(attr="claim")):
                return True
    return False


def _own_returns(function: ast.FunctionDef) -> Iterator[ast.Return]:
    """Yield the returns of a function, without those of functions that are defined inside it."""
    nodes: list[ast.AST] = [*function.body]
    while nodes:
        node = nodes.pop()
        if isinstance(node, ast.Return):
            yield node
        elif not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            nodes += ast.iter_child_nodes(node)


def _as_call(value: ast.expr) -> ast.expr:
    """Return a comparison as a call; ``a and b`` part by part; all else as it is."""
    match value:
        case ast.BoolOp(op=ast.And(), values=parts):
            value.values = [_as_call(part) for part in parts]
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            function = ast.Name(COMPARE_NAME, ast.Load())
            text = ast.Constant(ast.unparse(value))
            kind = ast.Constant(type(op).__name__)
            call = ast.Call(function, [text, kind, left, right], [])
            # Errors name the line of the comparison.
            return ast.fix_missing_locations(ast.copy_location(call, value))
    return value
