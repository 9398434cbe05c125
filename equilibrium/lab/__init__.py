"""The slip lab: an interactive page for grasps."""

from arrangement.lazy_names import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
