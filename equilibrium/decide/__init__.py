"""Verdicts: the search and the proof that the checker accepts, put together."""

#: The answers in words.
RESISTED = "resisted"
NOT_RESISTED = "not resisted"
UNDECIDED = "undecided"
