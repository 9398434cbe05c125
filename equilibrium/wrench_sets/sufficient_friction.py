"""The least friction of named contacts that resists a load, with a certificate on either side.

It is an end of the resisted values of a parameter, the coefficient of these contacts. Where no
coefficient up to 1 is enough, those above are 1 over a parameter: so all are asked about.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from arrangement.console.number_form import JsonMixin
from arrangement.hints import hints_on_arguments
from arrangement.library.files.json_files import Source
from arrangement.numbers.functions import Span
from equilibrium.grasps.inputs.parameter import question_document
from equilibrium.model.assembly import Assembly
from equilibrium.model.errors import GraspError
from equilibrium.model.grasp import Grasp, chosen_contacts
from equilibrium.model.parameter import ParametricQuestion
from equilibrium.model.subject import Subject
from equilibrium.model.synonyms import ARGUMENTS

from .parameter import TOLERANCE, ResistedValues, proved_values

_LETTER = "f"
_UP_TO_1 = Span(Fraction(0), Fraction(1))
_FROM_1 = Span(Fraction(0), Fraction(1), has_low=False)


@dataclass(frozen=True, repr=False)
class SufficientFriction(JsonMixin):
    """Which coefficients of some contacts resist a load.

    Attributes:
        contacts: their numbers, from 1; the others keep their own friction.
        up_to_1: the answers for the coefficients f from 0 to 1.
        from_1: those for the coefficients 1/f with f from 0, which is none, to 1; None where one up
            to 1 is enough.
    """

    json_fields = ("contacts", "low", "high", "impossible", "up_to_1", "from_1")

    contacts: tuple[int, ...]
    up_to_1: ResistedValues
    from_1: ResistedValues | None

    @property
    def low(self) -> Fraction | None:
        """No coefficient below this one is enough, proved; None if it is proved that none is."""
        below, above = (
            values.between.without(values.not_resisted) if values else []
            for values in (self.up_to_1, self.from_1)
        )
        return below[0].low if below else 1 / above[-1].high if above else None

    @property
    def high(self) -> Fraction | None:
        """The least coefficient that is proved to be enough; None if none is."""
        if self.up_to_1.resisted:
            return self.up_to_1.resisted[0].low
        most = self.from_1.resisted if self.from_1 else ()
        return 1 / most[-1].high if most else None

    @property
    def impossible(self) -> bool:
        """Whether it is proved that no coefficient is enough."""
        return self.low is None

    @property
    def values(self) -> ResistedValues:
        """The answers that have the least coefficient."""
        return self.from_1 or self.up_to_1


@hints_on_arguments(ARGUMENTS)
def sufficient_friction(
    source: Source | Grasp | Assembly,
    contacts: Iterable[int],
    wrench: Any = None,
    tolerance: Any = TOLERANCE,
) -> SufficientFriction:
    """Return the least friction coefficient, the same at some contacts, that resists a load.

    Args:
        source: a grasp in the plane or an assembly; or a document of one: a path, a built-in name
            or a mapping.
        contacts: numbers, from 1, of those that get the coefficient; the others keep their own.
        wrench: on the grasp, or on the bodies of an assembly, in place of that of the source.
        tolerance: the largest width of what may be left unproved between two proofs; above 1 of
            one over the coefficient.

    Raises:
        InputError: no such contact, or no question.

    >>> ladder = {"schema_version": 1, "contacts": [
    ...     {"point": ["0", "0"], "normal": ["0", "1"], "friction": "0"},
    ...     {"point": ["4", "3"], "normal": ["-1", "0"], "friction": "0"}],
    ...     "wrench": ["0", "-1", "-2"]}
    >>> least = sufficient_friction(ladder, [1])
    >>> least.low, least.high, sufficient_friction(ladder, [2]).impossible
    (Fraction(2, 3), Fraction(2, 3), True)
    """
    if isinstance(source, (Grasp, Assembly)):
        source = source.to_dict()
    document = question_document(source, wrench)
    known = {key: x for key, x in document.items() if key != "wrench"}
    subject: Subject = (Assembly if "bodies" in known else Grasp).from_dict(known)
    chosen = chosen_contacts(contacts, len(subject.contact_numbers))
    if not chosen:
        raise GraspError("contacts are []; expected at least one number")
    points = subject.points_of(chosen)

    def values(coefficient: str, between: Span) -> ResistedValues:
        listed = [
            {**entry, "friction": coefficient} if i in points else entry
            for i, entry in enumerate(document["contacts"])
        ]
        family = ParametricQuestion({**document, "contacts": listed}, _LETTER)
        return proved_values(family, between, tolerance)

    up_to_1 = values(_LETTER, _UP_TO_1)
    enough = bool(up_to_1.resisted)
    return SufficientFriction(chosen, up_to_1, None if enough else values(f"1/{_LETTER}", _FROM_1))
