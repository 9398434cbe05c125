"""The JSON Schemas of files and certificates (draft 2020-12), published with the package."""

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
    return _with("certificate", grasp=grasp_schema())


def assembly_schema() -> dict[str, Any]:
    """Return the schema of assembly files, with that of grasps among its definitions.

    >>> assembly_schema()["title"]
    'Assembly'
    """
    return _with("assembly", grasp=grasp_schema())


def assembly_certificate_schema() -> dict[str, Any]:
    """Return the schema of certificates about assemblies.

    >>> assembly_certificate_schema()["title"]
    'Certificate about an assembly'
    """
    known = {"assembly": assembly_schema(), "certificate": certificate_schema()}
    return _with("assembly-certificate", **known)


def shapes_schema() -> dict[str, Any]:
    """Return the schema of files of shapes, whose contacts follow.

    >>> shapes_schema()["title"]
    'Shapes'
    """
    return _with("shapes", grasp=grasp_schema())


def parameter_certificate_schema() -> dict[str, Any]:
    """Return the schema of certificates for all values of a parameter.

    >>> parameter_certificate_schema()["title"]
    'Certificate for all values of a parameter'
    """
    return _with("parameter-certificate", grasp=grasp_schema())


def _with(name: str, **definitions: dict[str, Any]) -> dict[str, Any]:
    schema = _schema(name)
    schema["$defs"] |= definitions
    return schema


def _schema(name: str) -> dict[str, Any]:
    text = files(__name__).joinpath(f"{name}.schema.json").read_text(encoding="utf-8")
    schema: dict[str, Any] = json.loads(text)
    return schema
