"""A wall of nine bricks with its contact forces, as the guide to several bodies makes it."""

from equilibrium import solve
from equilibrium.grasps.textbook import wall
from equilibrium.pictures import OF_ASSEMBLIES

verdict = solve(*wall(courses=3, bricks=3, friction="1/10", overhang=True))
OF_ASSEMBLIES.write(verdict, "wall.svg", width=150, font_size="5pt")
