"""A ladder, a block on a slope and a picture on a nail, each under its weight."""

from equilibrium import read_grasp
from equilibrium.pictures import write_drawing

for name, weight in (("ladder", 12), ("block-on-a-slope", 5), ("hanging-picture", 32)):
    grasp, path = read_grasp(name), f"three-objects-{name}.svg"
    write_drawing(grasp, path, "grasp", wrench=(0, -weight, 0), width=85)
