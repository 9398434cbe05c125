"""Exact arrangements of planes: faces, counts, dual polyhedra, and their pictures.

The names below are loaded when first used; `__init__.pyi` is their one list.
"""

from .console.entry import attach_stub

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
