"""Errors of the package: each message says the value, the rule it broke, and the remedy."""

from arrangement.errors import InputError


class ClaimError(ValueError):
    """Base class of every error that this package raises on purpose."""


class UnknownClaimError(ClaimError, InputError):
    """An id that no claim has; the command line turns it into exit code 2."""
