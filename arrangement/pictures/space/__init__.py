"""Planes and their cells in space."""
