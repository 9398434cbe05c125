"""Four planes in general position and their dual, the rhombic dodecahedron."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing

write_drawing(read_arrangement("cube-diagonals"), "great-circles-and-dual.svg", "dual")
