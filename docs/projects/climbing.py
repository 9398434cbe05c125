"""How the force at the foot of a ladder depends on how high somebody has climbed.

A starting file. It prints the friction at the foot for a smooth wall. Extend it: other walls, the
push at the wall, a picture of the curves, and where the ladder starts to slide (exactly).
"""

from fractions import Fraction

from equilibrium import Grasp, read_grasp, solve

WEIGHT = 12
FOOT, TOP = read_grasp("ladder")


def ladder(wall_friction):
    """The ladder against a wall of this friction."""
    wall = type(TOP)(TOP.point, TOP.normal, wall_friction)
    return Grasp([FOOT, wall])


def load(height):
    """The wrench of the weight at a height of the ladder, 0 at the foot and 1 at the top."""
    x = FOOT.point[0] + height * (TOP.point[0] - FOOT.point[0])
    return (0, -WEIGHT, -x * WEIGHT)


def forces(wall_friction, height):
    """The forces at foot and top, or None when nothing balances the weight there."""
    found = solve(ladder(wall_friction), load(height)).equilibria
    return found[0].forces if found else None


if __name__ == "__main__":
    for step in range(7):
        found = forces(0, Fraction(step, 6))
        print(f"{step}/6", found[0][1] if found else "slides")
