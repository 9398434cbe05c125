"""Verdicts: the search and the proof that the checker accepts, put together."""

#: The answers in words.
RESISTED = "resisted"
NOT_RESISTED = "not resisted"
UNDECIDED = "undecided"


def undecided(reason: object) -> dict[str, str]:
    """Return the JSON form of what is not known, and why."""
    return {"verdict": UNDECIDED, "reason": str(reason)}
