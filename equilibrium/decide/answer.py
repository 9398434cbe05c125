"""One of three answers to a question about equilibria: resisted, not resisted or undecided."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any

from arrangement.console.plugins import attached
from arrangement.errors import HintsMixin
from arrangement.numbers.deadline import Deadline
from arrangement.numbers.exact import RationalVector
from equilibrium.certificate.document import Certificate
from equilibrium.certificate.uncertain import Bounds
from equilibrium.model.effort import Effort
from equilibrium.model.errors import UndecidedError
from equilibrium.model.labels import ROUNDED
from equilibrium.model.subject import Subject

from . import RESISTED, UNDECIDED, robustness
from .nearby import Robustness, WithinError


def undecided(reason: object) -> dict[str, str]:
    """Return the JSON form of what is not known, and why."""
    return {"verdict": UNDECIDED, "reason": str(reason)}


class AnswerMixin(HintsMixin):
    """What verdicts on grasps and on assemblies have in common.

    Attributes:
        verdict: the answer in words.
        reason: why it is undecided, if it is.
        max_displacement, pyramid: as the question has them, see `equilibrium.solve`.
    """

    verdict: str
    reason: str
    max_displacement: Fraction | None
    pyramid: int | None
    _deadline: Deadline

    @property
    def decided(self) -> bool:
        """Whether there is a proof."""
        return self.verdict != UNDECIDED

    @property
    def stable(self) -> bool:
        """Whether the load is resisted: at least one equilibrium exists.

        Raises:
            UndecidedError: that is not known.
        """
        if not self.decided:
            raise UndecidedError(
                f"whether {self._load()} resisted is undecided: {self.reason}; ask `verdict` for "
                "the three answers"
            )
        return self.verdict == RESISTED

    def __bool__(self) -> bool:
        """Return whether the load is resisted; an undecided verdict raises UndecidedError."""
        return self.stable

    @property
    def proof(self) -> dict[str, Any]:
        """The document of the certificate.

        Raises:
            UndecidedError: there is none.
        """
        if self.certificate is None:
            raise UndecidedError(f"an undecided verdict has no certificate: {self.reason}")
        return self.certificate.to_dict()

    @property
    def certificate(self) -> Certificate | None:
        """The proof, checkable without the solver; None when undecided."""
        raise NotImplementedError

    def _load(self) -> str:
        """Return the load as the subject of a sentence, with its verb."""
        raise NotImplementedError

    @property
    def subject(self) -> Subject:
        """The grasp or the assembly."""
        raise NotImplementedError

    @property
    def load(self) -> RationalVector:
        """The wrench; of an assembly those on its bodies in a row."""
        raise NotImplementedError

    @property
    def warnings(self) -> tuple[str, ...]:
        """Lines on displacements that are not small; none of assemblies."""
        return ()

    def flat(self, motion: Any) -> RationalVector:
        """Return a motion as it stands in a certificate, as one vector."""
        raise NotImplementedError

    def again(self, subject: Any, load: RationalVector, effort: Effort) -> Any:
        """Decide another question in the same way, with the effort that is left."""
        raise NotImplementedError

    @cached_property
    def rounding(self) -> WithinError | None:
        """What is known for all data within the error of converted ones; None of exact data."""
        if self.subject.data_error is None:
            return None
        return robustness.within_error(self, self._deadline)

    @property
    def answer(self) -> str:
        """The verdict, in words as strong as what is known.

        Of exact data, and where it is proved for all data within the rounding error, that is the
        verdict; else "depends on the rounding", or "... for the data as rounded; not proved for all
        within the rounding error".
        """
        return self.verdict if self.rounding is None else self.rounding.answer

    def _repr_svg_(self) -> str | None:
        """Return what a notebook shows: bodies, wrenches and the forces of an equilibrium."""
        picture: str | None = attached("AnswerMixin._repr_svg_")(self)
        return picture

    def _verdict_in_repr(self) -> str:
        """Return the verdict; of converted data, where others are not asked for this, as theirs."""
        rounded = self.decided and self.subject.data_error is not None
        return f"{self.verdict} {ROUNDED}" if rounded else self.verdict

    @property
    def depends(self) -> bool:
        """Whether other data within the rounding error have another verdict, as was found."""
        return self.rounding is not None and self.rounding.turned is not None

    @property
    def doubt(self) -> str:
        """What is added to a verdict that is not proved for all data within the rounding error."""
        if self.rounding is None or self.rounding.proved or not self.decided:
            return ""
        return self.rounding.words

    def robust(self, *, time_limit: float | None = None, **bounds: Any) -> Robustness:
        """Decide whether the verdict holds for all data within the given bounds.

        Args:
            time_limit: in seconds; none by default. It is undecided when that is over.
            bounds: of `Bounds`: degrees, length, friction, stiffness, preload.
        """
        return robustness.robust(self, Bounds(**bounds), Deadline(time_limit))

    def within_error(self) -> WithinError:
        """Decide other data within the error of those that this verdict was converted from.

        A time limit of `solve` counts for this, too.

        Raises:
            GraspError: they were not converted.
        """
        return self.rounding or robustness.within_error(self)
