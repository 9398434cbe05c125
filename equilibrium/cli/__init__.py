"""The command ``equilibrium``."""

from .program import main as main
