"""A wedge that just locks itself, and an arch near the least friction at which it stands."""

from fractions import Fraction

from equilibrium import Assembly, solve
from equilibrium.grasps.textbook import wedge
from equilibrium.pictures import OF_ASSEMBLIES

OF_ASSEMBLIES.write(solve(*wedge()), "two-bodies-wedge.svg")

RAYS = [
    ("-1", "0"),
    ("-4/5", "3/5"),
    ("-7/25", "24/25"),
    ("7/25", "24/25"),
    ("4/5", "3/5"),
    ("1", "0"),
]
inner, outer = ([tuple(radius * Fraction(x) for x in ray) for ray in RAYS] for radius in (4, 5))
stones = {f"stone {k + 1}": [inner[k], outer[k], outer[k + 1], inner[k + 1]] for k in range(5)}
floor = [(-6, -1), (6, -1), (6, 0), (-6, 0)]
arch = Assembly.from_polygons(stones, "31/100", ground=[floor])
weights = {name: (0, -1, -sum(x for x, _ in row) / 4) for name, row in stones.items()}
OF_ASSEMBLIES.write(solve(arch, weights), "two-bodies-arch.svg")
large = {"font_size": 20, "legend": "none", "width": 174}
OF_ASSEMBLIES.write(solve(arch, weights), "two-bodies-arch-slide.svg", **large)
