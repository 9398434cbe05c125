"""The JSON Schema of arrangement files (draft 2020-12), published with the package."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any


def arrangement_schema() -> dict[str, Any]:
    """Return the schema.

    >>> arrangement_schema()["title"]
    'Arrangement'
    """
    text = files(__name__).joinpath("arrangement.schema.json").read_text(encoding="utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema
