"""Arrangements by name: families with parameters, built-in instances, and the census of types."""

from arrangement.console.entry import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
