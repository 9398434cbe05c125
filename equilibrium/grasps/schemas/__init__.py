"""The JSON Schemas of grasp files and certificates (draft 2020-12), published with the package."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any


def grasp_schema() -> dict[str, Any]:
    """Return the schema of grasp files.

    >>> grasp_schema()["title"]
    'Grasp'
    """
    return _schema("grasp")


def certificate_schema() -> dict[str, Any]:
    """Return the schema of certificates, with that of grasps among its definitions.

    >>> certificate_schema()["title"]
    'Certificate'
    """
    schema = _schema("certificate")
    schema["$defs"]["grasp"] = grasp_schema()
    return schema


def _schema(name: str) -> dict[str, Any]:
    text = files(__name__).joinpath(f"{name}.schema.json").read_text(encoding="utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema
