"""The pictures of README.md, kept in docs/static: run this there to draw them again.

The wide one has its three panels side by side. On a phone, they are stacked in the narrow one.
"""

from arrangement import read_arrangement
from arrangement.pictures import compose
from equilibrium import read_grasp

grasp = read_grasp("paper-three-contacts-preload-1")
panels = [
    read_arrangement("braid-a3").draw("sphere", labels="none", width=62),
    grasp.draw("grasp", wrench=("1/2", "-1/2", 0), width=62),
    grasp.draw("resist", width=76),
]
titles = ["hyperplane arrangement A3", "grasp, load, contact forces", ""]
for name, columns in (("strip", 3), ("strip-narrow", 1)):
    picture = compose(panels, columns=columns, titles=titles)
    for theme in ("light", "dark"):
        picture.write(f"{name}-{theme}.svg", theme=theme, legend="none")
