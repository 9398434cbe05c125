"""The JSON Schema of grasp files (draft 2020-12), published with the package."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any


def grasp_schema() -> dict[str, Any]:
    """Return the schema.

    >>> grasp_schema()["title"]
    'Grasp'
    """
    text = files(__name__).joinpath("grasp.schema.json").read_text(encoding="utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema
