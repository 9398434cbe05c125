"""Errors of the package; bad input is also an `arrangement.errors.InputError` (exit code 2)."""

from arrangement.errors import InputError


class EquilibriumError(ValueError):
    """Base class of every error that this package raises on purpose."""


class GraspError(EquilibriumError, InputError):
    """A contact, grasp, wrench or option breaks a rule; the message says value, rule, remedy."""


class CertificateError(EquilibriumError, InputError):
    """A certificate document has no readable form (this is not the same as a wrong proof)."""


class TimeLimitError(EquilibriumError, InputError):
    """The time allowed has passed before an answer was found; the message says what is open."""


class UndecidedError(EquilibriumError):
    """An undecided verdict was asked for yes or no; the message says why it is open."""
