"""Exact linear algebra: ranks, linear programs, cones and polyhedra."""
