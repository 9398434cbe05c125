"""The strip of the first page: great circles, a grasp under a load, and the forces it resists."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing as draw_planes
from equilibrium import read_grasp
from equilibrium.pictures import write_drawing as draw_grasp

grasp = read_grasp("paper-three-contacts-preload-1")
paper = {"width": 60, "legend": "none"}
draw_planes(read_arrangement("cube-diagonals"), "first-page-sphere.svg", "sphere", **paper)
draw_grasp(grasp, "first-page-grasp.svg", "grasp", wrench=(0, 1, 0), **paper)
draw_grasp(grasp, "first-page-resist.svg", "resist", **paper)
