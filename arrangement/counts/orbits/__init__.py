"""Counts by orbits of flats under the symmetries of the normals, also in parts."""
