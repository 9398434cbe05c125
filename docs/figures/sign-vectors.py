"""Three lines and their 19 faces, each with its sign vector."""

from arrangement import Arrangement
from arrangement.pictures import write_drawing

LINES = Arrangement([[0, 1], [-4, -3], [4, -3]], [0, -12, -12])
write_drawing(LINES, "sign-vectors.svg", "lines", faces="all", sides=True)
