"""The engine for planes in R^3: faces of dimension 1, 2 and 3 at scale, always exact."""

from .faces import SpaceFaces, space_faces
from .listing import list_faces

__all__ = ["SpaceFaces", "list_faces", "space_faces"]
