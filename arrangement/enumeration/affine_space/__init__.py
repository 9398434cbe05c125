"""The engine for planes of rank 3: fast at scale, always exact."""

from .faces import list_faces

__all__ = ["list_faces"]
