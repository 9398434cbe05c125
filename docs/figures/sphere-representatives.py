"""One point of the unit sphere in each region: the edges of their hull are not the adjacencies."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing

planes = read_arrangement("cube-diagonals")
write_drawing(planes, "sphere-representatives.svg", "dual", hull=True)
