"""One measurement in a process of its own: ``python job.py NAME PLANES`` prints one JSON line.

The same random planes for everybody: integer normals in [-1000, 1000], seeded by their number.
Libraries are imported before the clock starts, and only those of the job. The clock counts
CPU time, user and system together: all jobs are single-threaded, and other work on the
machine matters less. "first" is the first run, "seconds" the median of the later ones (or the
first, if it is the only one), "peak_mb" the largest resident memory of the process, "count" a
number that others must reproduce (regions where nothing else is said).
"""

import contextlib
import io
import json
import random
import resource
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from copy import copy
from functools import cache, partial
from pathlib import Path
from typing import Any

Normals = list[list[int]]
Work = Callable[[], int]


def random_normals(planes: int, largest: int = 1000, dimension: int = 3) -> Normals:
    generator = random.Random(planes)
    return [[generator.randint(-largest, largest) for _ in range(dimension)] for _ in range(planes)]


def incidence(planes: int) -> Work:
    """Ours: normals to vertices, arcs, regions and half-edges."""
    return _sphere(random_normals(planes), lambda made: None)


def bare_sort(planes: int) -> Work:
    """The least of any such method: NumPy's order of random numbers, a row for each circle."""
    import numpy as np

    from arrangement.enumeration.great_circles.incidence import BLOCK

    rows = np.random.default_rng(planes).standard_normal((max(1, BLOCK // planes), planes - 1))

    def work() -> int:
        for _ in range(-(-planes // len(rows))):
            np.argsort(rows, axis=1)
        return planes

    return work


def region_signs(planes: int) -> Work:
    """Ours: the same, and packed sign vectors of all regions."""
    return _sphere(random_normals(planes), lambda made: made.packed_region_signs)


def all_signs(planes: int) -> Work:
    """Ours: the same, and packed sign vectors of all vertices, arcs and regions."""

    def ask(made: Any) -> Any:
        return made.packed_region_signs, made.packed_arc_signs, made.packed_vertex_signs

    return _sphere(random_normals(planes), ask)


def thirty_digits(planes: int) -> Work:
    """Ours: entries of 30 digits, with packed sign vectors of all regions."""
    return _sphere(random_normals(planes, 10**30), lambda made: made.packed_region_signs)


def _sphere(normals: Normals, ask: Callable[[Any], Any]) -> Work:
    from arrangement import Arrangement
    from arrangement.enumeration.great_circles import sphere_arrangement

    def work() -> int:
        made = sphere_arrangement(Arrangement(normals))
        ask(made)
        return made.region_count

    return work


def facade_count(planes: int) -> Work:
    """Ours: `Arrangement.f_vector`; the number of regions."""
    from arrangement import Arrangement

    normals = random_normals(planes)
    return lambda: Arrangement(normals).f_vector[-1]


def facade_faces(planes: int) -> Work:
    """Ours: `Arrangement.faces` as a sequence; the number of faces."""
    from arrangement import Arrangement

    normals = random_normals(planes)
    return lambda: len(Arrangement(normals).faces())


def facade_signs(planes: int) -> Work:
    """Ours: one pass over the sign vectors of all faces as arrays; the number of faces."""
    from arrangement import Arrangement

    normals = random_normals(planes)
    return lambda: int(Arrangement(normals).faces().signs.any(axis=1).sum()) + 1


def count_command(planes: int) -> Work:
    """Ours: ``arrangement count FILE --json`` without Python's start; the number of regions."""
    from arrangement.cli import main

    with tempfile.NamedTemporaryFile("w", suffix=".json", delete=False) as stream:
        json.dump({"schema_version": 1, "planes": random_normals(planes)}, stream)

    def work() -> int:
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            main(["count", stream.name, "--json"])
        return int(json.loads(printed.getvalue())["f_vector"][-1])

    return work


def lines_in_the_plane(planes: int) -> Work:
    """Ours: all faces of lines in R^2 that miss the origin; their number."""
    from arrangement import Arrangement

    rows = random_normals(planes)
    return lambda: len(Arrangement([row[:2] for row in rows], [row[2] for row in rows]).faces())


def six_dimensions(planes: int) -> Work:
    """Ours: all faces with witnesses of planes in R^6; their number."""
    from arrangement import Arrangement

    normals = random_normals(planes, 9, 6)
    return lambda: len(Arrangement(normals).faces())


def affine_faces(planes: int) -> Work:
    """Ours: all faces of as many central as affine planes in R^3; their number."""
    return _affine(planes, None)


def affine_faces_any_dimension(planes: int) -> Work:
    """The same by the engine for any dimension."""
    return _affine(planes, "any-dimension")


def _affine(planes: int, engine: str | None) -> Work:
    from arrangement import Arrangement

    normals = random_normals(2 * planes)
    offsets = [0] * planes + [row[0] for row in random_normals(planes)]
    return lambda: len(Arrangement(normals, offsets).faces(engine=engine))


def counting(planes: int) -> Work:
    """Ours: characteristic polynomial, Whitney numbers and Moebius values; |chi(-1)|."""
    from arrangement import Arrangement
    from arrangement.counts import characteristic_polynomial, moebius, whitney_numbers

    def work() -> int:
        made = Arrangement(random_normals(planes))
        moebius(made)
        whitney_numbers(made)
        return abs(int(characteristic_polynomial(made).eval(-1)))

    return work


def polynomial(planes: int) -> Work:
    """Ours: the characteristic polynomial alone; |chi(-1)|."""
    from arrangement import Arrangement
    from arrangement.counts import characteristic_polynomial

    normals = random_normals(planes)
    return lambda: abs(int(characteristic_polynomial(Arrangement(normals)).eval(-1)))


def _asked(question: str, square: int, planes: int) -> Work:
    """Ours: a question of `FIELD_QUESTIONS` to planes over Q, or over the field of a root."""
    import sympy  # noqa: F401

    from arrangement import Arrangement, NumberField
    from arrangement.counts import characteristic_polynomial

    root: Any = NumberField([-square, 0, 1], [0, square]).root if square else 0
    pairs = zip(random_normals(planes, 9), random_normals(planes + 1, 9), strict=False)
    normals = [[x + y * root for x, y in zip(*pair, strict=True)] for pair in pairs]
    ask: dict[str, Callable[[Any], int]] = {
        "great circles": lambda made: int(made.f_vector[-1]),
        "all faces": lambda made: sum(1 for _ in made.faces()),
        "any dimension": lambda made: len(made.faces(engine="any-dimension")),
        "polynomial": lambda made: abs(int(characteristic_polynomial(made).eval(-1))),
    }
    return lambda: ask[question](Arrangement(normals))


FIELD_QUESTIONS = ("great circles", "all faces", "any dimension", "polynomial")


def _in_print(label: str) -> tuple[Any, int | None]:
    from arrangement.library.published import published_counts

    entry = next(entry for entry in published_counts() if entry.label == label)
    return entry.planes(), entry.regions


def _random_planes() -> tuple[Any, int | None]:
    from arrangement import Arrangement

    return Arrangement(random_normals(24, dimension=6)), None


#: What `counted` counts: planes in rank 5 to 8, and the regions in print.
COUNTED: dict[str, Callable[[], tuple[Any, int | None]]] = {
    label: partial(_in_print, label)
    for label in (
        *(f"resonance({n})" for n in (6, 7, 8)),
        *(f"threshold_functions({n})" for n in (6, 7, 8)),
        "coxeter('E8')",
        "shi('E6')",
        "shi('B4', 3)",
    )
} | {"24 random planes in R^6": _random_planes}


def counted(place: int) -> Work:
    """Ours: regions by classes of flats, of the entry of `COUNTED` at a place; from the planes."""
    import sympy  # noqa: F401

    from arrangement.counts import region_count

    planes, printed = list(COUNTED.values())[place]()

    def work() -> int:
        found = region_count(copy(planes))
        if printed is not None and found != printed:
            raise AssertionError(f"{found} regions; {printed} are printed")
        return found

    return work


def foretold(n: int) -> Work:
    """Ours: the forecast of a count, of the resonance arrangement in R^n; its steps."""
    import sympy  # noqa: F401

    from arrangement.counts.orbits.symmetric import forecast
    from arrangement.library.families import resonance

    planes = resonance(n)
    return lambda: round(sum(entry.steps for entry in forecast(planes)))


def loads_in_the_plane(loads: int) -> Work:
    """Ours: the verdicts of many loads on eight contacts; how many are resisted."""
    return _loads(8, 2, loads)


def loads_in_space(loads: int) -> Work:
    """Ours: the same on four contacts in space, a quarter of the loads on each of four grasps."""
    return _loads(4, 3, loads)


def _loads(contacts: int, dimension: int, loads: int) -> Work:
    from equilibrium.decide.solver import Solver
    from equilibrium.grasps.inputs.random import random_grasp, random_wrench

    given = [random_wrench(1000 + k, dimension=dimension, bound=1) for k in range(loads)]
    grasps = [random_grasp(contacts, seed, dimension=dimension) for seed in range(4)]
    parts = [(grasp, given[k::4]) for k, grasp in enumerate(grasps)]
    return lambda: sum(
        verdict.stable for grasp, part in parts for verdict in Solver(grasp).solve_many(part)
    )


def loads_as_arrays(loads: int) -> Work:
    """Ours: many loads on eight preloaded contacts as arrays; how many are resisted."""
    import numpy as np

    from equilibrium import ResistedSet
    from equilibrium.grasps.inputs import from_float_data as made
    from equilibrium.grasps.inputs.random import random_grasp

    grasp = random_grasp(8, 1)
    data = [np.array([getattr(c, name) for c in grasp], float) for name in ("point", "normal")]
    given = np.random.default_rng(1).normal(size=(loads, 3))
    return lambda: int(ResistedSet(made(*data, 0.5, preload=1.0).grasp).check(given).resisted.sum())


def _many_grasps(dimension: int, alone: bool, number: int) -> Work:
    """Ours: grasps of 3 to 8 contacts as arrays, or one by one; how many resist a load."""
    import numpy as np

    from equilibrium import check_grasps, solve
    from equilibrium.grasps.inputs.random import random_grasp, random_wrench

    grasps = [random_grasp(3 + k % 6, k, dimension=dimension) for k in range(number)]
    loads = [random_wrench(k, dimension=dimension) for k in range(number)]
    if alone:
        return lambda: sum(
            verdict.decided and bool(verdict.stable) for verdict in map(solve, grasps, loads)
        )
    points, normals = np.full((2, number, 8, dimension), np.nan)
    values = np.full((3, number, 8), np.nan)
    for i, grasp in enumerate(grasps):
        for j, c in enumerate(grasp):
            points[i, j], normals[i, j] = np.array([c.point, c.normal], float)
            values[:, i, j] = c.friction, c.stiffness, c.preload
    friction, stiffness, preload = values
    given = points, normals, friction, np.array(loads, float)[:, None]
    return lambda: int(check_grasps(*given, preload=preload, stiffness=stiffness).resisted.sum())


def inscribed_types(number: int) -> Work:
    """Ours: whether types of nine planes with weights are inscribable; microseconds for a type."""
    import numpy as np

    from arrangement.duals.inscribed.report import inscribability
    from arrangement.library.census import PUBLISHED, catalogue, census
    from proofs_check.routes.many_types import have_weights

    chosen = np.random.default_rng(9).permutation(PUBLISHED[9])[: 4 * number]
    weighty = chosen[have_weights(catalogue.chirotopes(9, chosen), 9)][:number].tolist()
    types = [census(9)[k] for k in weighty]

    def ask(planes: Any) -> Any:
        return inscribability(planes).certificate

    ask(census(8)[-1])  # loads modules
    return _each(ask, types)


def measured_limits(number: int) -> Work:
    """Ours: limits of grasps in space from float data; microseconds for one direction."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
    from equilibrium.wrench_sets.along_in_space import spatial_magnitudes
    from tests.equilibrium.converted_grasps import converted, original

    asked = []
    for seed in range(number):
        grasp, load = original("ball", seed)
        given = converted(grasp, seed).grasp
        asked.append((given, load if any(load) else (0, 0, -1, 0, 0, 0)))
    return _each(lambda question: spatial_magnitudes(*question), asked)


def _each(ask: Callable[[Any], Any], questions: Sequence[Any]) -> Work:
    """Return the work of asking one after another, once; it counts the median microseconds."""

    @cache
    def work() -> int:
        times = []
        for question in questions:
            start = time.process_time()
            ask(question)
            times.append(time.process_time() - start)
        return round(1e6 * statistics.median(times))

    return work


def published(planes: int) -> Work:
    """The published Steps 1 to 3; the number of regions."""
    from arrangement import Arrangement
    from arrangement.enumeration.paper_steps import published_enumeration

    normals = random_normals(planes)
    return lambda: len(published_enumeration(Arrangement(normals)).regions)


def published_step_1(planes: int) -> Work:
    """Step 1 alone, regions plane by plane; the number of regions."""
    from arrangement.enumeration.paper_steps import _regions

    normals = [tuple(row) for row in random_normals(planes)]
    return lambda: len(_regions(normals))


def published_step_2(planes: int) -> Work:
    """Step 2 alone, all pairs of regions; the number of facets."""
    from arrangement.enumeration.paper_steps import _graph, _regions

    regions = _regions([tuple(row) for row in random_normals(planes)])
    return lambda: _graph(regions).number_of_edges()


def published_step_3(planes: int) -> Work:
    """Step 3 alone, a minimum cycle basis and its sum; the number of faces."""
    from arrangement.enumeration.paper_steps import _cycles, _graph, _regions

    graph = _graph(_regions([tuple(row) for row in random_normals(planes)]))
    return lambda: len(_cycles(graph))


def _dual_edges(planes: int) -> tuple[int, list[tuple[int, int]]]:
    from arrangement import Arrangement
    from arrangement.enumeration.great_circles import sphere_arrangement

    made = sphere_arrangement(Arrangement(random_normals(planes))).incidence
    return made.region_count, list(zip(*made.region.reshape(-1, 2).T.tolist(), strict=True))


def networkx_cycle_basis(planes: int) -> Work:
    """networkx's minimum cycle basis of the dual graph; its number of cycles, plus one."""
    import networkx as nx

    graph = nx.Graph(_dual_edges(planes)[1])
    return lambda: len(nx.minimum_cycle_basis(graph)) + 1


def igraph_cycle_basis(planes: int) -> Work:
    """igraph's minimum cycle basis of the dual graph; its number of cycles, plus one."""
    import igraph

    graph = igraph.Graph(*_dual_edges(planes))
    return lambda: len(graph.minimum_cycle_basis()) + 1


def sage_regions(planes: int) -> Work:
    """Sage's list of regions, as polyhedra."""
    made = _sage(planes)
    return lambda: len(made().regions())


def sage_polynomial(planes: int) -> Work:
    """Sage's characteristic polynomial; |chi(-1)|."""
    made = _sage(planes)
    return lambda: abs(int(made().characteristic_polynomial()(-1)))


def _sage(planes: int) -> Callable[[], Any]:
    import sage.all__sagemath_polyhedra  # noqa: F401
    from sage.geometry.hyperplane_arrangement.arrangement import HyperplaneArrangements
    from sage.rings.rational_field import QQ

    space = HyperplaneArrangements(QQ, names=("x", "y", "z"))
    rows = [[normal, 0] for normal in random_normals(planes)]
    return lambda: space(rows)


def sign_vectors_topes(planes: int) -> Work:
    """The topes of the sign-vectors package."""
    import sage.all__sagemath_symbolics  # noqa: F401
    from sage.matrix.constructor import matrix
    from sage.rings.rational_field import QQ
    from sign_vectors import OrientedMatroid

    columns = matrix(QQ, random_normals(planes)).transpose()
    return lambda: len(OrientedMatroid(columns).topes())


#: The public functions above, the questions over fields, and many grasps.
JOBS: dict[str, Callable[[int], Work]] = (
    {
        name: job
        for name, job in list(globals().items())
        if name.islower()
        and name[0] != "_"
        and getattr(job, "__annotations__", {}).get("return") == Work
    }
    | {
        f"{question} {square}": partial(_asked, question, square)
        for question in FIELD_QUESTIONS
        for square in (0, 5)
    }
    | {
        f"grasps_in_{place}{way}": partial(_many_grasps, dimension, bool(way))
        for place, dimension in (("the_plane", 2), ("space", 3))
        for way in ("", "_alone")
    }
)


def measure(work: Work, budget: float = 5.0, most: int = 15) -> dict[str, float]:
    """Repeat until the budget of seconds is spent, once at least."""
    times: list[float] = []
    count = 0
    while not times or (sum(times) < budget and len(times) < most):
        start = time.process_time()
        count = work()
        times.append(time.process_time() - start)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    warm = statistics.median(times[1:] or times)
    return {"first": times[0], "seconds": warm, "peak_mb": peak, "count": count}


if __name__ == "__main__":
    name, planes = sys.argv[1:]
    print(json.dumps(measure(JOBS[name](int(planes)))))
