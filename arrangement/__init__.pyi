from . import counts as counts, pictures as pictures
from .arrangement import Arrangement as Arrangement
from .errors import (
    ArrangementError as ArrangementError,
    InputError as InputError,
    MissingExtraError as MissingExtraError,
    OutOfReachError as OutOfReachError,
)
from .library import census as census, families as families
from .library.files.table import (
    read_arrangement as read_arrangement,
    read_segments as read_segments,
)
from .numbers.budget import limit as limit
from .numbers.exact import from_floats as from_floats
from .numbers.fields import AlgebraicNumber as AlgebraicNumber, NumberField as NumberField
from .planes.faces import Face as Face
from .planes.identification import Identification as Identification
from .segments import Segments as Segments

__version__: str
