"""The parts of an assembly that are decided apart: its contact graph, cut at its cut vertices.

Bodies and the ground are vertices, each pair in contact is an edge. *Theorem.* Let C be a
2-connected part and v its vertex next to the ground, or the ground. Add up the balances of a body
of C and of all bodies that hang on it, about the one origin: forces between these cancel. So the
contacts of C balance the loads of its bodies, each with all that hangs on it, and their law depends
on motions relative to v alone. Conversely the relative motions of all parts together are
coordinates of R^(3b), so equilibria of the parts make one of the assembly. In a forest each part
has one body. What touches no ground may move as a whole: there is an equilibrium only if its loads
add up to 0, and then one of its bodies may be held.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from arrangement.numbers.exact import RationalVector
from equilibrium.model.assembly import SIZE, Assembly, BodyContact, Wrenches

#: The ground as a vertex; bodies are their names.
_GROUND = 0


class AssemblyPart(NamedTuple):
    """A 2-connected part.

    Attributes:
        root: the body that is held, the vertex next to the ground; None for the ground.
        bodies: the others.
        contacts: numbers of those among them and with the root.
        wrenches: on each of the bodies, with those of all that hangs on it.
        hanging: for each of the bodies it and all that hang on it; these move with it.
    """

    root: str | None
    bodies: tuple[str, ...]
    contacts: tuple[int, ...]
    wrenches: Wrenches
    hanging: dict[str, tuple[str, ...]]


class Floating(NamedTuple):
    """Bodies that touch no ground, directly or through others, and the sum of their wrenches."""

    bodies: tuple[str, ...]
    total: RationalVector


def parts_of(assembly: Assembly, wrenches: Wrenches) -> tuple[list[AssemblyPart], list[Floating]]:
    """Return the parts, those nearer to the ground first, and what floats."""
    import networkx as nx

    graph: Any = nx.Graph()
    graph.add_nodes_from([_GROUND, *assembly.names])
    graph.add_edges_from((c.body_a, c.body_b or _GROUND) for c in assembly.contacts)
    parts: list[AssemblyPart] = []
    floating: list[Floating] = []
    seen: set[Any] = set()
    for root in (_GROUND, *assembly.names):
        if root in seen:
            continue
        together = nx.node_connected_component(graph, root)
        seen |= together
        if root != _GROUND:
            bodies = tuple(name for name in assembly.names if name in together)
            floating.append(Floating(bodies, _total(wrenches[name] for name in bodies)))
        parts += _hung_on(graph.subgraph(together), root, assembly, wrenches)
    return parts, floating


def with_root_as_ground(assembly: Assembly, part: AssemblyPart) -> Assembly:
    """Return the bodies of a part, with its root in the place of the ground."""
    contacts = []
    for i in part.contacts:
        c = assembly.contacts[i]
        if c.body_a == part.root:
            c = c.reversed
        body_b = None if c.body_b == part.root else c.body_b
        contacts.append(BodyContact(c.body_a, body_b, c.contact))
    return Assembly(part.bodies, contacts)


def _hung_on(
    graph: Any, root: Any, assembly: Assembly, wrenches: Wrenches
) -> Iterator[AssemblyPart]:
    """Yield the parts of what is connected with a vertex, those nearer to it first."""
    import networkx as nx

    blocks_at: dict[Any, list[set[Any]]] = {vertex: [] for vertex in graph}
    for block in nx.biconnected_components(graph):
        for vertex in block:
            blocks_at[vertex].append(block)
    rooted: list[tuple[Any, list[str]]] = []
    waiting: list[tuple[Any, Any]] = [(root, None)]
    while waiting:
        vertex, above = waiting.pop(0)
        for block in blocks_at[vertex]:
            if block is not above:
                bodies = [name for name in assembly.names if name in block and name != vertex]
                rooted.append((vertex, bodies))
                waiting += [(body, block) for body in bodies]
    hanging: dict[Any, tuple[str, ...]] = {vertex: (vertex,) for vertex in graph}
    for vertex, bodies in reversed(rooted):
        hanging[vertex] += tuple(name for body in bodies for name in hanging[body])
    for vertex, bodies in rooted:
        inside = {vertex, *bodies}
        contacts = tuple(
            i for i, c in enumerate(assembly.contacts) if {c.body_a, c.body_b or _GROUND} <= inside
        )
        loads = {body: _total(wrenches[name] for name in hanging[body]) for body in bodies}
        held = None if vertex == _GROUND else vertex
        below = {body: hanging[body] for body in bodies}
        yield AssemblyPart(held, tuple(bodies), contacts, loads, below)


def _total(wrenches: Iterable[RationalVector]) -> RationalVector:
    zero = (Fraction(0),) * SIZE
    return tuple(map(sum, zip(zero, *wrenches, strict=True)))  # type: ignore[arg-type]
