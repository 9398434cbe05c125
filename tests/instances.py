"""The built-in instances by the space that their contacts or planes are in."""

from __future__ import annotations

import json

from arrangement.io.files import instances


def is_in_space(name: str) -> bool:
    """Whether a built-in instance is a grasp in space, whose planes are no arrangement in R^3."""
    contacts = json.loads(instances()[name].read_bytes()).get("contacts")
    return contacts is not None and len(contacts[0]["point"]) == 3


#: Arrangements, and grasps in the plane.
PLANAR = [name for name in instances() if not is_in_space(name)]
