"""Two fingers on a cube in space: an equilibrium, and why a larger load is not resisted."""

from equilibrium import read_grasp
from equilibrium.pictures import write_drawing

fingers = read_grasp("two-opposed-fingers")
for name, view, load in (("held", "grasp", (0, 0, -1)), ("lost", "proof", (0, 0, -3))):
    path, width = f"from-plane-to-space-{name}.svg", 85 if view == "grasp" else 170
    write_drawing(fingers, path, view, wrench=(*load, 0, 0, 0), width=width)
