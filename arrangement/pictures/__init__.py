"""Pictures of arrangements, made with matplotlib (the extra ``figures``).

The topology of every picture is exact; only coordinates on paper are floats. A picture made twice
is the same byte for byte.
"""

from arrangement.console.plugins import lazy_names

__getattr__, __dir__ = lazy_names(__name__, __file__)
