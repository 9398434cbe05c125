"""Arrangements by name: families with parameters, built-in instances, and the census of types."""

from . import census as census, families as families
