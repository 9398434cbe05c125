"""The picture of README.md, kept in docs/static: run this there to draw it again."""

from arrangement import read_arrangement
from arrangement.pictures import compose
from equilibrium import read_grasp

grasp = read_grasp("paper-three-contacts-preload-1")
strip = compose(
    [
        read_arrangement("braid-a3").draw("sphere", labels="none", width=62),
        grasp.draw("grasp", wrench=("1/2", "-1/2", 0), width=62),
        grasp.draw("resist", width=76),
    ],
    columns=3,
    titles=["hyperplane arrangement A3", "grasp, load, contact forces", ""],
)
for theme in ("light", "dark"):
    strip.write(f"strip-{theme}.svg", theme=theme, legend="none")
