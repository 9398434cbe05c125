"""One of three answers to a question about equilibria: resisted, not resisted or undecided."""

from __future__ import annotations

from typing import Any

from arrangement.errors import HintsMixin
from equilibrium.certificate.document import Certificate
from equilibrium.model.errors import UndecidedError

from . import RESISTED, UNDECIDED


def undecided(reason: object) -> dict[str, str]:
    """Return the JSON form of what is not known, and why."""
    return {"verdict": UNDECIDED, "reason": str(reason)}


class AnswerMixin(HintsMixin):
    """What verdicts on grasps and on assemblies have in common.

    Attributes:
        verdict: the answer in words.
        reason: why it is undecided, if it is.
    """

    verdict: str
    reason: str

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
