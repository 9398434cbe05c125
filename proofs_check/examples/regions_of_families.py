"""Numbers of regions of named families: the Shi arrangement, and the graphical ones.

J.-Y. Shi, Lecture Notes in Mathematics 1179, 1986: the Shi arrangement in R^n has (n + 1)^(n - 1)
regions. C. Greene and T. Zaslavsky, Transactions of the AMS 280, 1983, with R. Stanley, Discrete
Mathematics 5, 1973: the regions of the planes x_u = x_v for the edges uv of a graph are its acyclic
orientations, and there are |P(-1)| of them for the chromatic polynomial P.

Run time: about 2 seconds.
"""

from itertools import product

import networkx as nx

from arrangement import Arrangement, counts
from arrangement.library.families import graphical, shi
from proofs_check import claim


def enumerated(planes: Arrangement) -> int:
    """All regions, listed one by one."""
    return len(planes.regions())


def by_theorem(planes: Arrangement) -> int:
    """Zaslavsky's theorem on the intersection lattice."""
    return counts.region_count(planes)


@claim(
    "The Shi arrangement in R^n has (n + 1)^(n - 1) regions.",
    formula=r"r(S_n) = (n + 1)^{n - 1}",
    of={f"n = {n}": shi(n) for n in range(1, 5)},
    routes=[enumerated, by_theorem],
    locator="Shi 1986",
)
def shi_regions(planes: Arrangement, regions: int) -> bool:
    """Compare with the closed form."""
    n = planes.dimension
    closed_form: int = (n + 1) ** (n - 1)
    return regions == closed_form


def regions_of_graph(graph: nx.Graph) -> int:
    """Regions of the graphical arrangement, listed one by one."""
    return len(graphical(graph).regions())


def acyclic_orientations(graph: nx.Graph) -> int:
    """Orientations without a directed cycle, all 2^E tried."""
    ways = product(*(((u, v), (v, u)) for u, v in graph.edges))
    return sum(nx.is_directed_acyclic_graph(nx.DiGraph(way)) for way in ways)


#: All connected graphs of 2 to 5 vertices (the atlas of Read and Wilson lists them).
GRAPHS = {
    f"graph {k} of the atlas": graph
    for k, graph in enumerate(nx.graph_atlas_g())
    if 2 <= len(graph) <= 5 and nx.is_connected(graph)
}


@claim(
    "A graph has as many acyclic orientations as its arrangement has regions: |P(-1)| for its "
    "chromatic polynomial P.",
    formula=r"r(G) = |P(-1)|",
    of=GRAPHS,
    routes=[regions_of_graph, acyclic_orientations],
    locator="Greene, Zaslavsky 1983",
)
def graphical_regions(graph: nx.Graph, regions: int) -> bool:
    """Evaluate the chromatic polynomial of networkx at -1."""
    polynomial = nx.chromatic_polynomial(graph)
    (x,) = polynomial.free_symbols
    return regions == int(abs(polynomial.subs(x, -1)))
