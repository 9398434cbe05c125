"""A grasp all of whose contacts slip, with the forces that oppose the slip."""

from arrangement.drawing.output import save_figure
from equilibrium import read_grasp
from equilibrium.pictures import draw_grasp

save_figure(
    "slip-state.svg",
    lambda: draw_grasp(
        read_grasp("offset-three-contacts"),
        wrench=("3/4", "1/2", "3/2"),
        outline=[(-1, -1), (1, -1), (1, 1), (-1, 1)],
        width=110,
    ),
)
