"""Verdicts: the search and the proof that the checker accepts, put together."""

#: The answers in words.
RESISTED, NOT_RESISTED, UNDECIDED = "resisted", "not resisted", "undecided"
