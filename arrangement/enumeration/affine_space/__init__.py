"""The engine for planes in R^3: faces of dimension 1, 2 and 3 at scale, always exact."""

from .faces import SpaceFaces, space_faces

__all__ = ["SpaceFaces", "space_faces"]
