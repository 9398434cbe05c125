"""The command ``equilibrium``."""

from .program import main

__all__ = ["main"]
