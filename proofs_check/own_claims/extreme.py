"""The largest or smallest value of a quantity for each number of lines or planes, by enumeration.

The value is computed on one arrangement of every isomorphism class in the census, so it has to be
one that all arrangements of a class share, as all quantities of claims in one line do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from arrangement.arrangement import Arrangement
from arrangement.console.progress import watched
from arrangement.numbers.exact import shown
from proofs_check.errors import OwnClaimError
from proofs_check.instances.domains import domain
from proofs_check.statements.statement import Case

from .language import read, read_statement
from .one_line import value_of
from .user_claim import type_sources


@dataclass
class Extreme:
    """The extreme value among the isomorphism classes of a number of lines or planes.

    Attributes:
        elements: how many.
        value: the extreme one.
        example: the first class that has it.
        reached: how many classes have it.
        classes: how many there are, with the hypothesis if there is one.
    """

    elements: int
    value: int | Fraction
    example: Case
    reached: int = 0
    classes: int = 0


def extremes(
    text: str, of: str, low: int, high: int, *, largest: bool = True, when: str | None = None
) -> Iterator[Extreme]:
    """Return the extreme values of a quantity in the language of one line, by number of elements.

    Args:
        text: such as ``bounded_p_vector[3]`` or ``regions``.
        of: a domain of planes or lines.
        low, high: numbers of elements, in the census.
        when: a hypothesis in the same language.

    Raises:
        OwnClaimError: the text or the domain is not one of these, or a value is not a number.
    """
    chosen = domain(of)
    if chosen.unit in ("contacts", "pseudolines"):
        raise OwnClaimError(f"of is {of}; extremes are of lines or planes, such as lines")
    node, hypothesis = read(text), read_statement(when) if when else None
    type_sources(chosen, low, high)  # refuses numbers that the census has not

    def includes(planes: Arrangement) -> bool:
        holds = hypothesis is None or value_of(hypothesis, planes, {})
        return chosen.contains(planes) and bool(holds)

    def extreme(m: int) -> Extreme | None:
        best: Extreme | None = None
        (source,) = type_sources(chosen, m, m)
        for case in watched(source.cases(Random(0)), "classes"):
            if not includes(case.subject):
                continue
            value = value_of(node, case.subject, {})
            if isinstance(value, bool) or not isinstance(value, (int, Fraction)):
                raise OwnClaimError(
                    f"{text} is {shown(value)} for {case.label}, which is not a number; name a "
                    "count, such as regions or t_vector.get(2, 0)"
                )
            if best is None or (value > best.value if largest else value < best.value):
                best = Extreme(m, value, case, 0, best.classes if best else 0)
            best.classes += 1
            best.reached += value == best.value
        return best

    return filter(None, map(extreme, range(low, high + 1)))
