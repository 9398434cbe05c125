"""Where grasps come from: files, schemas, built-in instances, shapes and float data."""

from arrangement.console.entry import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
