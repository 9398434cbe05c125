"""The command ``proofs-check``."""

from .program import main as main
