"""Errors of the package: each message says the value, the rule it broke, and the remedy."""


class ArrangementError(ValueError):
    """Base class of every error that this package raises on purpose."""


class InputError(ArrangementError):
    """A value from outside breaks a rule; the command line turns it into exit code 2."""


class MissingExtraError(ArrangementError, ImportError):
    """An optional library is absent; the message names the extra that installs it."""


class WorkerError(InputError):
    """Processes or machines that were to work, and cannot."""


class UnfinishedError(InputError):
    """A count that is not at its end.

    Attributes:
        known: the first Whitney numbers of the first kind, which are final.
    """

    def __init__(self, message: str, known: tuple[int, ...]) -> None:
        super().__init__(message)
        self.known = known


class TimeLimitError(UnfinishedError):
    """The time that was given is over."""
