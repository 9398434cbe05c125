from .claim import (
    Case as Case,
    Claim as Claim,
    Evidence as Evidence,
    Hypothesis as Hypothesis,
    Kind as Kind,
    Record as Record,
    Registry as Registry,
    Result as Result,
    Route as Route,
    Verdict as Verdict,
    check as check,
    evaluate as evaluate,
    verdict_of as verdict_of,
)
from .claims import registry as registry
from .errors import ClaimError as ClaimError, UnknownClaimError as UnknownClaimError

__version__: str
