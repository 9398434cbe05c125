"""Validators of documents by the JSON schemas of the packages."""

from typing import Any

from jsonschema import Draft202012Validator
from referencing import Registry
from referencing.jsonschema import DRAFT202012


def validator(schema: dict[str, Any]) -> Draft202012Validator:
    """Return a validator that has looked for the parts of a schema already.

    Left to itself it looks through the whole schema again at each reference to a part of it.
    """
    resource = DRAFT202012.create_resource(schema)
    known = Registry().with_resource(resource.id() or "", resource).crawl()
    return Draft202012Validator(schema, registry=known)
