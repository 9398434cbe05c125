"""The interactive page of an arrangement."""
