"""Errors of the package: each message says the value, the rule it broke, and the remedy."""

from arrangement.errors import InputError


class ClaimError(ValueError):
    """Base class of every error that this package raises on purpose."""


class UnknownClaimError(ClaimError, InputError):
    """An id that no claim has; the command line turns it into exit code 2."""


class UnknownDomainError(ClaimError, InputError):
    """A name that no domain of instances has."""


class OwnClaimError(ClaimError, InputError):
    """A file with own claims that cannot be run, or a claim in it that is not well formed."""


class SweepError(ClaimError, InputError):
    """A sweep that cannot be started, continued or read."""


class DamagedStoreError(SweepError):
    """A store of a sweep whose file has been changed by something else.

    Attributes:
        damage: what is damaged.
    """

    def __init__(self, damage: str, remedy: str) -> None:
        super().__init__(f"{damage}. {remedy}")
        self.damage = damage
