"""The proof that the paper's three contacts without preload do not hold a force upwards."""

from equilibrium import read_grasp
from equilibrium.pictures import write_drawing

write_drawing(
    read_grasp("paper-three-contacts"), "proof-by-hand.svg", "proof", wrench=(0, 1, 0), width=150
)
