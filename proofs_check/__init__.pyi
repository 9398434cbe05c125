from .claims import registry as registry
from .course.exercise import exercise as exercise
from .errors import ClaimError as ClaimError
from .instances.families import family as family
from .own_claims.claim_file import load as load
from .own_claims.user_claim import claim as claim
from .statements.evidence import (
    Evidence as Evidence,
    Part as Part,
    Record as Record,
    Result as Result,
    evaluate as evaluate,
)
from .statements.statement import (
    Case as Case,
    Claim as Claim,
    ClaimVerdict as ClaimVerdict,
    Domain as Domain,
    Hypothesis as Hypothesis,
    Kind as Kind,
    Registry as Registry,
    Route as Route,
    Source as Source,
    View as View,
)

__version__: str
