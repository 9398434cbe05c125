"""What became of a verdict when data near were asked about, in words and as JSON."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

from arrangement.console.number_form import ReprMixin, near
from arrangement.numbers.exact import RationalVector, number_text, to_text
from equilibrium.certificate.document import Certificate
from equilibrium.certificate.robust import read_bounds
from equilibrium.certificate.uncertain import Bounds
from equilibrium.model.labels import AS_ROUNDED
from equilibrium.model.subject import Subject, contacts_of

from . import UNDECIDED

if TYPE_CHECKING:
    from .verdict import Verdict

#: Decides a load of a subject; None where it is undecided.
Decide: TypeAlias = "Callable[[Subject, RationalVector], Verdict | None]"

HOLDS = "holds"
FAILS = "does not hold"
OPEN = UNDECIDED
DEPENDS = "depends on the rounding"


@dataclass(frozen=True, repr=False, kw_only=True)
class _OtherData(ReprMixin):
    """What became of a verdict when other grasps, or assemblies, were asked about.

    Attributes:
        verdict: that of the data themselves, or "depends on the rounding".
        turned: the verdict on other data, if it is another one, and how far these are: `change`,
            see `equilibrium.decide.robustness`.
        inner: where it is, a proof of the verdict for all data within smaller bounds, if found.
        certificate: of the verdict for all data asked about, if it holds.
        reason: why the search ended early, if the time limit was over; else empty.
    """

    verdict: str
    reason: str = ""
    turned: Verdict | None = field(default=None, repr=False)
    change: dict[str, Fraction] = field(default_factory=dict, repr=False)
    inner: Certificate | None = field(default=None, repr=False)
    certificate: Certificate | None = field(default=None, repr=False)

    def _found(self, name: str) -> dict[str, Any]:
        """Return the JSON form of the reason, and of another verdict under a name."""
        document: dict[str, Any] = {"reason": self.reason} if self.reason else {}
        if self.turned is not None:
            sizes = {key: to_text(x) for key, x in self.change.items()}
            document |= {name: self.turned.to_dict(), "change": sizes}
            if self.inner is not None:
                document["holds_within"] = self.inner.to_dict()
        return document

    def _turned_lines(self, turned: Verdict) -> Iterator[str]:
        """Yield the other data in lines."""
        for i, c in enumerate(contacts_of(turned.subject), 1):
            point, normal = (", ".join(number_text(x, 10) for x in v) for v in (c.point, c.normal))
            friction = number_text(c.friction)
            pull = f"  adhesion {number_text(c.adhesion)}" if c.adhesion else ""
            yield (
                f"    contact {i}  point ({point})  normal ({normal})  friction {friction}{pull}"
            )
        sizes = ", ".join(f"{k} by {near(x, 2)}" for k, x in self.change.items() if x)
        yield f"    largest changes of one number: {sizes}"
        yield "    found by search: a smaller change may turn it, too"
        yield from (f"    {line}" for line in turned.warnings)
        if self.inner is not None:
            document = self.inner.to_dict()
            yield f"{document['certificate']} for all {read_bounds(document)}: proved"


@dataclass(frozen=True, repr=False, kw_only=True)
class Robustness(_OtherData):
    """Whether a verdict holds within bounds; true when that is proved.

    Attributes:
        answer: "holds", "does not hold" or "undecided".
        bounds: of the grasps looked at.
    """

    repr_fields = ("answer", "verdict", "bounds")

    answer: str
    bounds: Bounds

    def __bool__(self) -> bool:
        return self.answer == HOLDS

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        document: dict[str, Any] = {"answer": self.answer, "bounds": self.bounds.to_dict()}
        if self.certificate is not None:
            document["certificate"] = self.certificate.to_dict()
        return document | self._found("counterexample")

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.answer == HOLDS:
            yield f"{self.verdict} for all {self.bounds}: proved"
        elif self.turned is None:
            reason = self.reason or "no proof and no counterexample was found"
            yield f"for all {self.bounds}: undecided; {reason}"
        else:
            yield f"not for all {self.bounds}: {self.turned.verdict} for"
            yield from self._turned_lines(self.turned)


@dataclass(frozen=True, repr=False, kw_only=True)
class WithinError(_OtherData):
    """What became of a verdict when data within the rounding error were asked about.

    It is firm where it is proved for all of them; friction, stiffness and preload that are 0 stay
    0, and no others are asked then. Otherwise it is a verdict for the data as rounded, or depends
    on the rounding.

    Attributes:
        asked: how many others were asked about; `open`: how many of them were undecided.
    """

    repr_fields = ("verdict", "asked", "open", "proved")

    asked: int = 0
    open: int = 0

    @property
    def proved(self) -> bool:
        """Whether the verdict is proved for all data within the error."""
        return self.certificate is not None

    @property
    def answer(self) -> str:
        """The verdict in words that are as strong as what is known."""
        if self.proved or self.verdict in (DEPENDS, OPEN):
            return self.verdict
        return f"{self.verdict} {AS_ROUNDED}"

    @property
    def words(self) -> str:
        """The answer in one line, with its proof or the other verdict."""
        if self.proved:
            return f"{self.verdict} for all data within the rounding error: proved"
        if self.turned is None:
            return self.answer
        return f"{DEPENDS}: {self.turned.verdict} for other data within the rounding error"

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        document: dict[str, Any] = {"verdict": self.verdict, "proved": self.proved}
        document |= {"answer": self.answer, "asked": self.asked, "undecided": self.open}
        return document | self._found("turned")

    def lines(self) -> Iterator[str]:
        """Yield the answer in words."""
        if self.turned is not None:
            yield f"{DEPENDS}: {self.turned.verdict} for, within the error of the data,"
            yield from self._turned_lines(self.turned)
        elif self.proved:
            yield self.words
        else:
            left = f", {self.open} of them undecided" if self.open else ""
            late = f"; {self.reason}" if self.reason else ""
            yield f"{self.words} ({self.asked} others tried{left}{late})"
