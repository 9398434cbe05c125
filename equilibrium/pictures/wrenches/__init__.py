"""Wrenches that are resisted: slices, directions, solids, and methods side by side."""
