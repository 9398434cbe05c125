"""Arrangements by name: families with parameters, built-in instances, and the census of types."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
