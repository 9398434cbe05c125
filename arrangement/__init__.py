"""Exact arrangements of planes: the regions that they cut space into, counted, listed, drawn.

Planes have exact numbers; so has every answer. Three planes through the origin, and the number of
their faces of dimension 0, 1, 2 and 3:

>>> from arrangement import Arrangement, read_arrangement
>>> planes = Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, "1/2"]])
>>> planes.f_vector
(1, 6, 12, 8)
>>> planes.region_at((1, 2, 3)).signs
(1, 1, 1)
>>> figure = read_arrangement("braid-a3").draw("sphere")

`Arrangement` is where to look first: ``help(arrangement.Arrangement)``. `arrangement.counts` has
polynomials and lattices, `arrangement.library.families` named arrangements, `arrangement.pictures`
every picture. The names below are loaded when first used; `__init__.pyi` is their one list.
"""

from .console.entry import attach_stub

__version__ = "0.1.0"

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
