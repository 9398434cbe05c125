"""The two pictures of the first page: a grasp under a load, and planes with their dual."""

from arrangement import read_arrangement
from arrangement.pictures import write_drawing as draw_planes
from equilibrium import read_grasp
from equilibrium.pictures import write_drawing as draw_grasp

grasp = read_grasp("paper-three-contacts-preload-1")
draw_grasp(grasp, "first-page-grasp.svg", "grasp", wrench=(0, 1, 0))
draw_grasp(grasp, "first-page-slice.svg", "slice")
draw_planes(read_arrangement("cube-diagonals"), "first-page-dual.svg", "dual")
