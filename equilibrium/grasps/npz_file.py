"""Arrays of contacts in NPZ files of NumPy."""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Sequence
from pathlib import Path
from shlex import quote
from typing import Any, TypeGuard

from arrangement.errors import InputError
from arrangement.library.files.json_files import read_bytes
from arrangement.numbers import budget
from arrangement.numbers.exact import shown
from equilibrium.model.contact import VALUES
from equilibrium.model.errors import GraspError

BYTES = "bytes of many grasps"
REQUIRED = ("points", "normals", VALUES[0])


def is_npz(path: object) -> TypeGuard[str | os.PathLike[str]]:
    """Return whether this is the path of an NPZ file."""
    return isinstance(path, (str, os.PathLike)) and os.fsdecode(path).lower().endswith(".npz")


def refuse_npz(source: object) -> None:
    """Raise an error for an NPZ file, with what makes an exact grasp of it."""
    if is_npz(source):
        path = os.fsdecode(source)
        line = f"equilibrium make floats {quote(path)} -o {quote(f'{path[:-4]}.json')}"
        raise GraspError(
            f"{path} has arrays of floats; write `{line}`, which rounds them to an exact grasp"
            + budget.by_caller(", or equilibrium.inputs.read_float_data(FILE).grasp", "")
        )


def read_npz(
    path: str | os.PathLike[str], known: Sequence[str], required: Sequence[str]
) -> dict[str, Any]:
    """Return the arrays of an NPZ file; nothing in it is run.

    Raises:
        InputError: it cannot be read; or it has not the arrays that are known, or required.
    """
    import numpy as np

    content = io.BytesIO(read_bytes(Path(path), shown(os.fspath(path)), BYTES))
    try:
        with zipfile.ZipFile(content) as archive:
            budget.check_size(sum(x.file_size for x in archive.infolist()), BYTES, str(path))
        with np.load(content, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
        if not all(isinstance(array, np.ndarray) for array in arrays.values()):
            raise ValueError  # NumPy returns the bytes of what has no header
    except (OverflowError, MemoryError):
        raise GraspError(f"{path} is damaged: an array claims more than is in the file") from None
    except InputError:
        raise
    except Exception:
        # zipfile, its decompressors and the parser of NumPy's headers raise errors of many kinds.
        raise GraspError(
            f"{path} is not an NPZ file of arrays of numbers, or damaged or encrypted; expected a "
            "file that numpy.savez writes"
        ) from None
    missing = ", ".join(name for name in required if name not in arrays)
    unknown = ", ".join(shown(name) for name in arrays if name not in known)
    lists = (("no array", missing), ("unknown arrays", unknown))
    if faults := [f"{fault} {names}" for fault, names in lists if names]:
        remedy = f"; such as numpy.savez({str(path)!r}, **numpy.load({str(path)!r}), friction=0.5)"
        raise GraspError(
            f"{path} has {' and '.join(faults)}; expected {', '.join(required)}"
            + f", and if wanted {', '.join(known[len(required) :])}" * (known != required)
            + remedy * (missing == VALUES[0] and not unknown)
        )
    return arrays
