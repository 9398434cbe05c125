"""Verify counting claims about arrangements and grasps, by implementations that share no code.

>>> from proofs_check import evaluate, registry
>>> evaluate(registry()["fukuda-bound-attained"]).verdict
<ClaimVerdict.HOLDS: 'holds'>

Write claims
    claim         make a claim of a function (a decorator)
    family        a family of instances with parameters
    exercise      make a self-grading exercise of a function (a decorator)
    load          read the claims of a file

Run
    registry      return the claims of the paper, by id: registry()["fukuda-bound-attained"]
    Registry      claims by id; iterating gives claims
    evaluate      check a claim on its instances; returns a Result

What a claim is
    Claim, Case, Source, Route, Hypothesis, Domain, Kind, View

What checking it returns
    Result        the claim with its Evidence
    Evidence      counterexample, parts and verdict
    Part, Record  what was checked, source by source and case by case
    ClaimVerdict  holds, holds under a hypothesis, refuted
    ClaimError    base class of all errors
"""

from arrangement import __version__ as __version__
from arrangement.console.plugins import lazy_names
from arrangement.synonyms import by_word

#: Other words for the names, each with what to write here.
_SYNONYMS = {
    "extreme": "from proofs_check.own_claims.extreme import extremes; "
    "extremes(quantity, of, low, high)",
    **dict.fromkeys(
        ("one_line_claim", "try_", "try_claim"),
        "from proofs_check import evaluate; "
        "from proofs_check.own_claims.one_line import one_line_claim; "
        "evaluate(one_line_claim('regions <= m^2', of='lines'))",
    ),
    **by_word("""
        Exercise -> exercise
        get get_claim -> registry()[id]
        check run verify -> evaluate(claim)
        all_claims claims get_claims paper_claims -> registry()
        list_claims -> list(registry())
        load_claims read -> load(path)
    """),
}

__getattr__, __dir__ = lazy_names(__name__, __file__, _SYNONYMS)
