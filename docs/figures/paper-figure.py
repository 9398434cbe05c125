"""The pictures that the guide to figures makes by command."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing as draw_planes
from equilibrium import read_grasp
from equilibrium.pictures import write_drawing as draw_grasp

grasp = read_grasp("paper-three-contacts-preload-1")
draw_grasp(grasp, "paper-figure-grasp.svg", "grasp", wrench=(0, 1, 0))
draw_grasp(grasp, "paper-figure-resist.svg", "resist")
draw_planes(grasp.tangential_arrangement(), "paper-figure-circles.svg", "sphere")
draw_planes(
    read_arrangement("cube-diagonals"),
    "paper-figure-orbits.svg",
    colour="orbits:gold,white",
    labels="1=A,++-+=B",
)
