"""The engine for planes of rank 3, and central ones of rank 4: fast at scale, always exact."""

from .faces import list_faces as list_faces
