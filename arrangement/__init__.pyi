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
from .planes import Arrangement as Arrangement, Face as Face

__version__: str
