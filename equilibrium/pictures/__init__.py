"""Pictures of grasps and of what they resist, made with matplotlib (the extra ``figures``).

Every verdict, force and polygon is exact; only coordinates on paper are floats. A picture made
twice is the same byte for byte. Contacts are numbered from 1, as in the paper.
"""

from arrangement.console.plugins import lazy_names

__getattr__, __dir__ = lazy_names(__name__, __file__)
