from . import counts as counts
from .algebraic_number import AlgebraicNumber as AlgebraicNumber
from .arrangement import Arrangement as Arrangement
from .completeness import (
    CompletenessEvidence as CompletenessEvidence,
    certify_complete as certify_complete,
)
from .enumeration.great_circles import (
    Incidence as Incidence,
    SphereArrangement as SphereArrangement,
    sphere_arrangement as sphere_arrangement,
)
from .enumeration.paper_steps import (
    PublishedEnumeration as PublishedEnumeration,
    published_enumeration as published_enumeration,
)
from .errors import (
    ArrangementError as ArrangementError,
    InputError as InputError,
    MissingExtraError as MissingExtraError,
)
from .exact import (
    from_floats as from_floats,
    primitive as primitive,
    rational as rational,
    to_text as to_text,
)
from .faces import Face as Face
from .formats.table import read_arrangement as read_arrangement
from .io.writing import write_text_atomically as write_text_atomically
from .library import census as census, families as families
from .library.census import Identification as Identification, identify as identify
from .number_field import NumberField as NumberField
from .planes import Planes as Planes
from .polyhedra.dual import (
    DualPolygon as DualPolygon,
    DualPolyhedron as DualPolyhedron,
    DualSegment as DualSegment,
    dual_polygon as dual_polygon,
    dual_polyhedron as dual_polyhedron,
    dual_segment as dual_segment,
    dual_zonotope as dual_zonotope,
)
from .polyhedra.inscribed import (
    Inscribability as Inscribability,
    inscribability as inscribability,
    representative_hull as representative_hull,
)
from .symbolic import to_sympy as to_sympy

__version__: str
