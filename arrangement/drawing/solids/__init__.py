"""Solids as they are drawn: surfaces, their order in depth, meshes."""
