"""Exact hyperplane arrangements: enumerate, count, identify and draw them.

>>> from arrangement import Arrangement, read_arrangement
>>> planes = Arrangement([[1, 0, 0], [0, 1, 0], [1, 1, "1/2"]])   # normals of planes through 0
>>> planes.f_vector                                               # faces of dimension 0, 1, 2, 3
(1, 6, 12, 8)
>>> planes.region_at((1, 2, 3)).signs                             # sign vector (covector)
(1, 1, 1)
>>> figure = read_arrangement("braid-a3").draw("sphere")

Create
    Arrangement       hyperplanes n . x = b with exact coefficients, and all their methods
    read_arrangement  read a file, or a built-in arrangement by name
    Segments          segments in the plane: the vertices, edges and cells of their union
    read_segments     read a file of them
    families          Coxeter, braid, Shi, Catalan, graphical, generic, ... arrangements
    census            every isomorphism class of rank 3 with up to nine hyperplanes

Enumerate and count
    Face              a face: sign vector, dimension, exact witness
    Identification    an isomorphism class, as `Arrangement.identify` returns it
    counts            flats, characteristic polynomial, Zaslavsky's theorem, oriented matroids
    pictures          every picture, page and 3D-printable model

Exact numbers
    from_floats       rational numbers from floats, explicitly
    NumberField       the field of a real root of a polynomial
    AlgebraicNumber   an element of it

Limits and errors
    limit             scale the default limits on size and work
    ArrangementError  base class of all errors; InputError, OutOfReachError, MissingExtraError

``help(arrangement.Arrangement)`` lists the methods.
"""

from .console.plugins import attach, lazy_names
from .synonyms import PACKAGE

__version__ = "0.1.0"

attach(
    {
        "Arrangement.draw": "arrangement.pictures.views:DRAWINGS",
        "Segments.draw": "arrangement.pictures.views:SEGMENTS",
        "Arrangement.identify": "arrangement.library.census:identify",
        "Arrangement.save": "arrangement.library.files.table:save",
        "Arrangement.to_polymake": "arrangement.library.files.table:to_polymake",
        "Arrangement.to_sage": "arrangement.library.files.table:to_sage",
        "Arrangement.lab": "arrangement.pictures.lab.lines:lab_in_notebook",
        "Arrangement._repr_html_": "arrangement.pictures.views:arrangement_html",
        "Arrangement._repr_svg_": "arrangement.pictures.views:arrangement_svg",
    }
)

__getattr__, __dir__ = lazy_names(__name__, __file__, PACKAGE)
