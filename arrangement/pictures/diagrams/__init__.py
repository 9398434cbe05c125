"""Lines in the plane, the lattice of flats, and counts as charts."""
