from . import counts as counts
from .arrangement import Arrangement as Arrangement
from .console.writing import write_text_atomically as write_text_atomically
from .counts.completeness import (
    CompletenessEvidence as CompletenessEvidence,
    certify_complete as certify_complete,
)
from .duals.inscribed.hull import representative_hull as representative_hull
from .duals.inscribed.report import (
    Inscribability as Inscribability,
    inscribability as inscribability,
)
from .duals.zonohedron import (
    DualPolyhedron as DualPolyhedron,
    dual_polyhedron as dual_polyhedron,
    dual_zonotope as dual_zonotope,
)
from .duals.zonotope import (
    DualPolygon as DualPolygon,
    DualSegment as DualSegment,
    dual_polygon as dual_polygon,
    dual_segment as dual_segment,
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
    OutOfReachError as OutOfReachError,
)
from .library import census as census, families as families
from .library.census import Identification as Identification, identify as identify
from .library.files.table import read_arrangement as read_arrangement
from .numbers.budget import limit as limit
from .numbers.exact import (
    from_floats as from_floats,
    primitive as primitive,
    rational as rational,
    to_text as to_text,
)
from .numbers.fields import AlgebraicNumber as AlgebraicNumber, NumberField as NumberField
from .numbers.symbolic import to_sympy as to_sympy
from .planes.faces import Face as Face
from .planes.planes import Planes as Planes

__version__: str
