"""Exact polyhedra: cones, polygons and solids, cells of an arrangement, and its dual."""
