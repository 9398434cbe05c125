"""Claims about slip states, each checked by two routes that share no code.

The names below are loaded when first used; `__init__.pyi` is their one list.
"""

from arrangement import __version__ as __version__
from arrangement.console.entry import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
