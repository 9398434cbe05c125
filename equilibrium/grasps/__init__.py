"""Where grasps come from: files, schemas, built-in instances, shapes and float data."""

from arrangement.console.plugins import lazy_names

__getattr__, __dir__ = lazy_names(__name__, __file__)
