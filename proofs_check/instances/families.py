"""Members of a named family, or of a random one, as instances of claims.

``family("catalan", n=range(2, 9))`` and the text ``catalan(n=2..8)`` are the same. The names and
parameters are those of `arrangement.library.families`; `n` stands for an integer `type` too.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from math import prod
from typing import Any

from arrangement.arrangement import Arrangement
from arrangement.errors import refusal
from arrangement.library.families import FAMILIES
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError, UnknownDomainError
from proofs_check.statements.statement import Case

MOST_MEMBERS = 10_000
_CALL = re.compile(r"([A-Za-z][\w-]*)\s*(?:\((.*)\))?", re.ASCII | re.DOTALL)
_RANGE = re.compile(r"(-?[0-9]{1,9})(?:\.\.(-?[0-9]{1,9}))?", re.ASCII)


@dataclass(frozen=True)
class Member:
    """One arrangement of a family, and the parameters that made it."""

    planes: Arrangement
    parameters: Mapping[str, Any]

    def to_dict(self) -> dict[str, Any]:
        """Return the arrangement in file form."""
        return self.planes.to_dict()


class Family:
    """Members of a family for all combinations of the given parameters, made when asked for.

    Attributes:
        name: as on the command line.
        parameters: the values of each.
    """

    def __init__(self, name: str, parameters: Mapping[str, Sequence[Any]]) -> None:
        self.name, self.parameters = name, dict(parameters)

    def __len__(self) -> int:
        return prod(map(len, self.parameters.values()))

    def __str__(self) -> str:
        return self._label({key: span(values) for key, values in self.parameters.items()})

    @cached_property
    def variable(self) -> str | None:
        """The parameter that takes several integers, if it is the only one that varies."""
        several = [key for key, values in self.parameters.items() if len(values) > 1]
        only = several[0] if len(several) == 1 else None
        return only if only and all(type(x) is int for x in self.parameters[only]) else None

    @property
    def integers(self) -> tuple[str, ...]:
        """The parameters that are integers in all members."""
        items = self.parameters.items()
        return tuple(key for key, values in items if all(type(x) is int for x in values))

    def cases(self) -> Iterator[Case]:
        """Yield the members in order, as cases.

        Raises:
            InputError: the family has no such member.
        """
        for values in product(*self.parameters.values()):
            chosen = dict(zip(self.parameters, values, strict=True))
            planes = FAMILIES[self.name](**{_parameter(self.name, k): v for k, v in chosen.items()})
            yield Case(self._label(chosen), Member(planes, chosen), planes.to_dict())

    def _label(self, values: Mapping[str, Any]) -> str:
        return f"{self.name}({', '.join(f'{key}={value}' for key, value in values.items())})"


def family(name: str, **parameters: Any) -> Family:
    """Return members of a family as the instances of a claim.

    Args:
        name: as `arrangement make --help` lists them, such as "catalan" or "random-integer".
        parameters: those of the family, each a value, or a range or list of values; all
            combinations are taken.

    Raises:
        UnknownDomainError: no family has this name.
        OwnClaimError: it has other parameters, or there are too many members.

    >>> from proofs_check import family
    >>> print(family("catalan", n=range(2, 9)), len(family("generic", m=[3, 5], d=range(2, 5))))
    catalan(n=2..8) 6
    """
    known = name.replace("_", "-")
    if known not in FAMILIES:
        raise UnknownDomainError(str(refusal(f"no family is {shown(name)}", known, FAMILIES)))
    usable = inspect.signature(FAMILIES[known]).parameters
    values = {key: _several(names) for key, names in parameters.items()}
    for key in values:
        if _parameter(known, key) not in usable:
            mistake = f"the family {known} has no parameter {shown(key)}"
            raise OwnClaimError(str(refusal(mistake, key, usable, "it has")))
    names = {_parameter(known, key) for key in values}
    missing = {
        "n" if key == "type" else key: _several(range(2, 7))
        for key, parameter in usable.items()
        if parameter.default is parameter.empty and key not in names
    }
    if missing:
        example = Family(known, values | missing)
        raise OwnClaimError(f"the family {known} needs {' and '.join(missing)}: {example}")
    made = Family(known, values)
    if not 1 <= len(made) <= MOST_MEMBERS:
        raise OwnClaimError(f"{made} has {len(made):,} members; give 1 to {MOST_MEMBERS:,}")
    return made


def is_family(text: str) -> bool:
    """Return whether a text is written as a family, or names one."""
    return text.strip().endswith(")") or text.strip().replace("_", "-") in FAMILIES


def read_family(text: str) -> Family:
    """Read a family such as ``catalan(n=2..8)``, ``coxeter(type=E6)`` or ``generic(m=3,5,8, d=4)``.

    A parameter that is true or false may stand alone: ``discriminantal(n=3..5, d=2, affine)``.

    Raises:
        UnknownDomainError: no family has this name.
        OwnClaimError: it is written in another way, or `family` refuses it.
    """
    call = _CALL.fullmatch(text.strip())
    if call is None:
        raise OwnClaimError(f"{shown(text)} is not a family; write one as catalan(n=2..8)")
    values: dict[str, list[str]] = {}
    made = FAMILIES.get(call[1].replace("_", "-"))
    usable = inspect.signature(made).parameters if made else {}
    flags = {key for key, parameter in usable.items() if parameter.default is False}
    for part in (call[2] or "").split(",") if (call[2] or "").strip() else ():
        key, equals, value = (x.strip() for x in part.rpartition("="))
        if part.strip() in flags and part.strip() not in values:
            values[part.strip()] = ["true"]
        elif equals and re.fullmatch(r"[a-z]\w*", key, re.ASCII) and key not in values:
            values[key] = [value]
        elif not equals and values:
            values[next(reversed(values))].append(value)  # of a list, or of edges such as 1-2,2-3
        else:
            raise OwnClaimError(f"{shown(part)} in {shown(text)} is not a parameter; write n=2..8")
    return family(call[1], **{key: _read(parts) for key, parts in values.items()})


def _read(parts: list[str]) -> Any:
    ranges = [_RANGE.fullmatch(part) for part in parts]
    if all(ranges):
        bounds = [(int(match[1]), int(match[2] or match[1])) for match in ranges if match]
        if sum(high - low + 1 for low, high in bounds) > MOST_MEMBERS:
            raise OwnClaimError(f"{','.join(parts)} has more than {MOST_MEMBERS:,} values")
        return [x for low, high in bounds for x in range(low, high + 1)]
    if all(part[:1].isalpha() for part in parts):
        return [{"true": True, "false": False}.get(part.lower(), part) for part in parts]
    return ",".join(parts)  # edges


def _several(value: Any) -> Sequence[Any]:
    """Return the values of a parameter; a text or a number is one."""
    if isinstance(value, range):
        return value
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return tuple(value) if not hasattr(value, "nodes") else (value,)
    return (value,)


def _parameter(name: str, key: str) -> str:
    """Return the parameter of a family that a name means: n may be its type."""
    usable = inspect.signature(FAMILIES[name]).parameters
    return "type" if key == "n" and "n" not in usable and "type" in usable else key


def span(values: Sequence[Any], comma: str = ",") -> str:
    """Return values as a text reads them: 2..8 for three or more successive integers."""
    if len(values) > 2 and all(type(x) is int for x in values):
        low, high = values[0], values[-1]
        if list(values) == list(range(low, high + 1)):
            return f"{low}..{high}"
    return comma.join(map(str, values))
