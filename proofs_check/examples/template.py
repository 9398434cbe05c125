"""Claims of my own.

Check them with ``proofs-check run FILE.py``; make a page of them with
``proofs-check report FILE.py -o report.html``. Change what is here, or begin with one of the
examples in the documentation ("Check your own claim").
"""

from arrangement import Arrangement, counts
from equilibrium import Grasp, solve
from proofs_check import claim

# A claim is a function. It gets an instance and returns True, or a text that says why not; when it
# returns a comparison that is false, the report shows both sides.
#
# `of` says which instances: "distinct" (different planes through the origin of R^3, rank 3),
# "simple" (in general position), "central", "affine(d=2)" (lines of the plane), "affine(d=3)",
# "dual" (the dual polyhedra), "grasp"; or a list of instances. Planes are tried on one arrangement
# of every isomorphism class of 3 to `classes` planes, on named families and on `samples` random
# ones, the same ones for the same --seed.


@claim(
    "Great circles in general position have twice as many arcs as crossing points.",
    formula=r"f_2 = 2 f_1",  # the same in TeX, for the report
    of="simple",
    when=lambda planes: len(planes) >= 3,  # a hypothesis: what does not satisfy it is skipped
    hypotheses=["at least three planes"],  # the same in words
    samples=50,
)
def arcs_and_points(planes: Arrangement) -> bool:
    """Compare facets with rays; faces are counted by their dimension."""
    _, rays, facets, _ = planes.f_vector
    return facets == 2 * rays


# With `routes`, a value is computed in several ways that must agree. The function gets the
# instance and the value, and says whether it is what the statement promises.


def enumerated(planes: Arrangement) -> int:
    """All regions, listed one by one."""
    return len(planes.regions())


def by_theorem(planes: Arrangement) -> int:
    """Zaslavsky's theorem, on the intersection lattice."""
    return counts.region_count(planes)


@claim(
    "Different planes through the origin of R^3 cut it into at most m^2 - m + 2 regions.",
    routes=[enumerated, by_theorem],
    classes=5,
    samples=50,
)
def at_most(planes: Arrangement, regions: int) -> bool:
    """Compare with the bound."""
    m = len(planes)
    return regions <= m * m - m + 2


# A wrong claim, for a look at what a counterexample is like: it is made small, and saved as a file
# that `equilibrium solve` and `equilibrium draw` read. `expected` decides the exit code only.


@claim(
    "A grasp that resists a pull of 1 upwards resists a pull of 2.",
    of="grasp",
    planes=(1, 3),  # numbers of contacts (or of planes) of the random instances
    samples=60,
    when=lambda grasp: bool(solve(grasp, (0, 1, 0))),
    hypotheses=["it resists a pull of 1"],
    expected="refuted",
)
def twice_the_pull(grasp: Grasp) -> bool | str:
    """Friction that comes from a preload does not grow with the load."""
    return bool(solve(grasp, (0, 2, 0))) or "a pull of 2 is not resisted"
