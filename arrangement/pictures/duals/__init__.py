"""Duals and graphs of regions, and solids as model files."""
