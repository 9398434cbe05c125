"""Speed and memory, ours beside the peers', in one run: ``make bench``.

Each number comes from a process of its own, in CPU seconds. Missing programs are reported. A loaded
machine changes the times; quote the ratios within one run.

    run.py             ours at all sizes, and the peers that are quick
    run.py --peers     the slow peers too (minutes; several gigabytes for CGAL at 2000)
    run.py --install   first create .bench-venv with the peers that pip can install
    run.py --only grasps [--contacts 10,20]        verdicts alone; see grasps.py
    run.py --only space [--contacts 3,4]           verdicts in space; see space.py
    run.py --only planes                          arrangements alone
    run.py --only pictures                        pictures and pages alone
    run.py --only targets                         measured times and targets
    run.py --only simulators [--every 6]          physics engines; needs .[simulators], an hour
"""

import argparse
import json
import math
import resource
import sys
from collections.abc import Iterable

from grasps import LIMIT, grasp_tables, shown
from job import COUNTED, FIELD_QUESTIONS, random_normals
from peers import Measured, cgal, install_peers, ours, peer, polymake
from pictures import picture_table
from simulators import simulator_table
from space import SIZES as SPATIAL, space_tables
from targets import target_table

from arrangement import Arrangement
from arrangement.errors import InputError
from arrangement.library import families
from arrangement.planes.proved import ask_proved

TABLES = ("planes", "grasps", "space", "pictures", "targets", "simulators")
CONTACTS = (10, 20, 50, 100, 1000)
SIZES = (9, 50, 100, 200, 500, 1000, 2000)
B3 = (
    *((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    *((1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)),
)


#: Name, planes, what is counted, the target in seconds.
PROVED = (
    ("100 random planes of rank 3, faces", random_normals(100), "--faces", 8.0),
    ("14 random planes of rank 6, faces", random_normals(14, dimension=6), "--faces", 0.5),
    ("resonance 5, regions", families.resonance(5), "--regions", 0.05),
    ("resonance 6, regions", families.resonance(6), "--regions", 8.0),
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--peers", action="store_true", help="run the slow peers too")
    parser.add_argument("--install", action="store_true", help="create .bench-venv first")
    parser.add_argument("--only", choices=TABLES, help="some of the tables")
    parser.add_argument("--contacts", type=_sizes, help="sizes of the random grasps")
    parser.add_argument("--grasps", type=int, default=0, help="grasps of each size")
    parser.add_argument("--limit", type=float, default=LIMIT, help="seconds for grasps of one size")
    parser.add_argument("--every", type=int, default=1, help="only each such scene of simulators")
    parser.add_argument("--folder", help="write the slip loads of simulators here, as CSV files")
    options = parser.parse_args()
    if options.only == "simulators":
        simulator_table(options.every, options.folder)
        return
    if options.only in (None, "pictures", "targets"):
        picture_table()
    if options.only in (None, "grasps"):
        grasp_tables(options.contacts or CONTACTS, options.limit, options.grasps)
    if options.only in (None, "space"):
        space_tables(options.contacts or SPATIAL, options.grasps)
    if options.only in (None, "targets"):
        target_table()
    if options.only not in (None, "planes"):
        return
    if options.install and (reason := install_peers()):
        print(f"peers not installed: {reason}")
    proved_table()
    counting_table()
    own = own_table()
    against_cgal(own, (200, 1000, 2000) if options.peers else (200,))
    against_published(options.peers)
    against_sage(options.peers)
    against_polymake(options.peers)


def _sizes(text: str) -> list[int]:
    return [int(m) for m in text.split(",")]


def proved_table() -> None:
    """The formally verified program: CPU time and target."""
    head("Counted by the verified program (make formal): time, target, count")
    for label, family, option, target in PROVED:
        planes = Arrangement(family) if isinstance(family, list) else family
        document = json.dumps(
            {"schema_version": 1, "planes": [list(map(str, n)) for n in planes.normals]}
        )
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        try:
            _, counted = ask_proved(option, "-", text=document)
        except InputError as error:
            print(f"  {error}")
            return
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        print(f"  {label:<36} {shown(seconds):>10} {shown(target):>10}  [{counted}]", flush=True)


def counting_table() -> None:
    """Numbers of regions by classes of flats, each against the number in print."""
    head(
        "Regions counted by classes of flats, symmetries found by itself: first run, median, memory"
    )
    for place, label in enumerate(COUNTED):
        found = ours("counted", place)
        print(
            f"  {label:<28} {shown(found.first):>10} {shown(found.seconds):>10}"
            f" {megabytes(found):>8}  [{found.count}]",
            flush=True,
        )
    print("  Forecasts from samples; in brackets the seconds that are foretold")
    for n in (8, 9):
        found = ours("foretold", n)
        print(
            f"  {f'resonance({n})':<28} {shown(found.seconds):>21}"
            f" {megabytes(found):>8}  [{found.count}]",
            flush=True,
        )


def own_table() -> dict[tuple[str, int], Measured]:
    """Ours at all sizes, with the growth exponent between neighbouring sizes."""
    head("Great circles, random integer normals in [-1000, 1000], from normals to half-edges")
    print(
        f"{'planes':>7} {'regions':>9} {'first run':>10} {'warm':>10} {'growth':>7} {'peak':>8}"
        f" {'with region signs':>19} {'peak':>8}"
    )
    found: dict[tuple[str, int], Measured] = {}
    for place, planes in enumerate(SIZES):
        for job in ("incidence", "region_signs"):
            found[job, planes] = ours(job, planes)
        plain, signed = found["incidence", planes], found["region_signs", planes]
        growth = exponent(found, SIZES[place - 1], planes) if place else ""
        print(
            f"{planes:>7} {plain.count:>9} {shown(plain.first):>10} {shown(plain.seconds):>10}"
            f" {growth:>7} {megabytes(plain):>8} {shown(signed.seconds):>11}"
            f" ({signed.seconds / plain.seconds:.2f}x) {megabytes(signed):>8}",
            flush=True,
        )
    overall = exponent(found, 100, SIZES[-1])
    print(f"  growth from 100 to {SIZES[-1]} planes: {overall}")
    for planes in (1000, 2000):
        least = ours("bare_sort", planes).seconds
        times = found["incidence", planes].seconds / least
        print(f"  {planes} planes take {times:.0f} times what NumPy takes to sort as many numbers")
    line("great circles, incidence", 5000, ours("incidence", 5000))
    line("everything with all sign vectors", 9, ours("all_signs", 9))
    line("30-digit entries, with region signs", 100, ours("thirty_digits", 100))
    facade_table(found)
    field_table()
    return found


def facade_table(own: dict[tuple[str, int], Measured]) -> None:
    """The short calls, beside the engines behind them."""
    head("The facade: Arrangement(...) with the engine that it chooses")
    for planes in (50, 200, 1000):
        mine = own.get(("incidence", planes)) or ours("incidence", planes)
        line("great circles alone", planes, mine)
        line("Arrangement.f_vector", planes, ours("facade_count", planes), mine)
        line("arrangement count, in JSON", planes, ours("count_command", planes), mine)
    line("Arrangement.faces", 200, ours("facade_faces", 200))
    line("Arrangement.faces, all signs as one array", 200, ours("facade_signs", 200))
    line("lines in the plane: all faces", 200, ours("lines_in_the_plane", 200))
    mine = ours("affine_faces", 20)
    line("R^3, m central + m affine: all faces", 20, mine)
    line(
        "the same by the engine for any dimension", 20, ours("affine_faces_any_dimension", 20), mine
    )
    for planes in (12, 16):
        line("R^6: all faces with witnesses", planes, ours("six_dimensions", planes))


def field_table() -> None:
    """The same questions to planes over Q and over Q(sqrt(5))."""
    head("Irrational planes in R^3, from normals: over Q, then over Q(sqrt(5)) in times of Q")
    for question in FIELD_QUESTIONS:
        rational = ours(f"{question} 0", 60)
        line(f"{question}, over Q", 60, rational)
        line(f"{question}, over Q(sqrt(5))", 60, ours(f"{question} 5", 60), rational)


def exponent(found: dict[tuple[str, int], Measured], small: int, large: int) -> str:
    """Return by which power of the number of planes the warm incidence time grows."""
    ratio = found["incidence", large].seconds / found["incidence", small].seconds
    return f"m^{math.log(ratio) / math.log(large / small):.2f}"


def against_cgal(own: dict[tuple[str, int], Measured], sizes: Iterable[int]) -> None:
    head("CGAL (a sweep; on the sphere it cuts each circle at one meridian)")
    for planes in sizes:
        mine, normals = own["incidence", planes], random_normals(planes)
        line("ours, incidence", planes, mine)
        line("CGAL, geodesic arcs on the sphere", planes, cgal("sphere", normals), mine)
        line("CGAL, lines in one chart (half the sphere)", planes, cgal("chart", normals), mine)

    print("  The nine planes of B3 have 48 regions. In brackets: the faces that CGAL finds")
    line("CGAL, by a sweep", 9, cgal("sphere", B3))
    line("CGAL, one circle after another", 9, cgal("incremental", B3))


def against_published(slow: bool) -> None:
    head("The published steps, and minimum cycle bases of the dual graph")
    mine = ours("all_signs", 9)
    line("ours, all faces and all sign vectors", 9, mine)
    line("published Steps 1-3, exact", 9, ours("published", 9), mine)
    line("networkx minimum cycle basis alone", 9, ours("networkx_cycle_basis", 9), mine)
    line("igraph minimum cycle basis alone", 9, ours("igraph_cycle_basis", 9), mine)
    for step, bound in (("1", "m^3"), ("2", "m^4"), ("3", "E^3 + V E^2 log V, about m^6")):
        found = {m: ours(f"published_step_{step}", m) for m in (5, 10)}
        power = math.log2(found[10].seconds / found[5].seconds)
        line(f"published Step {step} alone", 10, found[10])
        print(f"    grows as m^{power:.2f} from 5 to 10 planes; the stated bound is {bound}")
    if slow:
        mine = ours("all_signs", 20)
        line("ours, all faces and all sign vectors", 20, mine)
        line("igraph minimum cycle basis alone", 20, ours("igraph_cycle_basis", 20), mine)


def against_sage(slow: bool) -> None:
    head("Sage (passagemath) and the sign-vectors package")
    planes = 50 if slow else 12
    mine = ours("region_signs", planes)
    line("ours, regions with packed signs", planes, mine)
    line("Sage, regions", planes, peer("sage_regions", planes), mine)
    line("sign-vectors, topes", planes, peer("sign_vectors_topes", planes), mine)
    planes = 100 if slow else 20
    mine = ours("counting", planes)
    line("ours, polynomial, Whitney, Moebius", planes, mine)
    only = ours("polynomial", planes)
    line("ours, characteristic polynomial", planes, only)
    line("Sage, characteristic polynomial", planes, peer("sage_polynomial", planes), only)


def against_polymake(slow: bool) -> None:
    head("polymake (its own process; memory not measured)")
    planes = 50 if slow else 12
    mine = ours("region_signs", planes)
    line("ours, regions with packed signs", planes, mine)
    line("polymake, chambers with signatures", planes, polymake(random_normals(planes)), mine)


def head(title: str) -> None:
    print(f"\n{title}", flush=True)


def line(what: str, planes: int, measured: Measured, reference: Measured | None = None) -> None:
    """Print one measurement, and how many times longer it took than the reference."""
    if measured.absent:
        print(f"  {what:<44} m={planes:<5} absent: {measured.absent}", flush=True)
        return
    text = f"  {what:<44} m={planes:<5} {shown(measured.seconds):>10} {megabytes(measured):>8}"
    if reference is not None and not reference.absent:
        text += f"  {measured.seconds / reference.seconds:>9.1f} times ours"
    print(f"{text}  [{measured.count}]", flush=True)


def megabytes(measured: Measured) -> str:
    return f"{measured.peak_mb:.0f} MB"


if __name__ == "__main__":
    sys.exit(main())
