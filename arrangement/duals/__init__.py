"""Solids of an arrangement: its dual, its cells, and what is inscribed in the sphere."""
