"""Arrangements by name: families with parameters, built-in instances, and the census of types."""

from arrangement.console.plugins import lazy_names

__getattr__, __dir__ = lazy_names(__name__, __file__)
