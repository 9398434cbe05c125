"""Passive equilibrium of planar grasps with friction: exact verdicts, each with a certificate.

The names below are loaded when first used; `__init__.pyi` is their one list.
"""

import lazy_loader

from arrangement import __version__ as __version__

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
