"""Planes and their faces: the value types."""
