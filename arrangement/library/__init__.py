"""Arrangements by name: families with parameters, built-in instances, and the census of types."""

from arrangement.lazy_names import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
