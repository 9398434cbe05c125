"""The built-in instances by the space that their contacts or planes are in."""

import json
from typing import Any

from arrangement.library.files.json_files import instances


def document(name: str) -> Any:
    return json.loads(instances()[name].read_bytes())


def contacts(name: str) -> Any:
    """Return the contacts of a built-in instance; None if it is an arrangement."""
    return document(name).get("contacts")


def is_in_space(name: str) -> bool:
    """Whether a built-in instance is a grasp in space, whose planes are not in R^3."""
    found = contacts(name)
    return found is not None and len(found[0]["point"]) == 3


#: Arrangements, and grasps; not contacts between several bodies.
ONE_BODY = [name for name in instances() if "normals" not in document(name)]
#: Arrangements, and grasps in the plane.
PLANAR = [name for name in ONE_BODY if not is_in_space(name)]
#: Arrangements alone.
ARRANGEMENTS = [name for name in PLANAR if contacts(name) is None]
