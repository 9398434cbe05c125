"""What an installed package must answer without any extra, and with all of them."""

from typing import NamedTuple

#: Files that the commands read, written before them.
INPUTS = {
    "fingers.csv": "x,y,normal_x,normal_y,friction\n-1,0,1,0,0.5\n1,0,-1,0,0.5\n",
    "disc.json": '{"schema_version": 1, "friction": 1, "bodies": [{"name": "a", "circle": '
    '{"centre": [0, 1], "radius": 1}}], "ground": [{"segments": [[[-4, 0], [4, 0]]]}]}',
    "wedge.json": '{"schema_version": 1, "polygon": [["0", "0"], ["4", "0"], ["0", "3"]], '
    '"places": [{"edge": 0, "at": "1/2", "friction": "1/4"}]}',
    "triangle.json": '{"schema_version": 1, "polygon": [[0, 0], [4, 0], [0, 3]]}',
    "segments.json": '{"schema_version": 1, "segments": [[[0, 0], [4, 0]], [[0, 3], [4, 0]]]}',
    "corner.obj": "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    "lecture.py": "from proofs_check import exercise\n"
    "@exercise('Twice 7?')\ndef twice(answer):\n    return answer == 14\n",
    "five.chi": "++++++++++\n+++0++++++\n",
    "printed.csv": "arrangement,quantity,printed\nbraid-a3,f-vector,1 14 36 24\n",
    "answers.json": '{"schema_version": 1, "answers": {"twice": 14}}',
}


class Command(NamedTuple):
    """A command line, its exit code, and a part of what it prints (or a file that it writes)."""

    line: str
    code: int
    prints: str = ""
    writes: str = ""


def _needs(extra: str, line: str) -> Command:
    return Command(line, 2, f"(the extra {extra}): pip install ")


_G = "paper-three-contacts"
#: In this order: later lines read what earlier ones wrote.
COMMANDS = (
    Command("arrangement list", 0, "braid-a3"),
    Command("arrangement list --json", 0, "braid-a3"),
    Command("equilibrium list", 0, "paper-three-contacts"),
    Command("arrangement count braid-a3", 0, "states           75"),
    Command(f"arrangement count {_G}", 0, "states           27"),
    Command("arrangement faces coordinate-planes --json", 0, '"witness"'),
    Command("arrangement count segments.json", 0, "vertices         3"),
    Command("arrangement count generic-lines-affine --inside triangle.json", 0, "inside: cells"),
    Command("arrangement make shi --type D4 -o d4.json", 0, writes="d4.json"),
    Command("arrangement count d4.json", 0, "(t - 6)**4"),
    Command("arrangement identify braid-a3", 0, "6.3, braid A3"),
    Command("arrangement list --classes 7", 0, "143"),
    Command("arrangement convert braid-a3 -o braid.m2", 0, writes="braid.m2"),
    Command("arrangement identify braid.m2", 0, "6.3, braid A3"),
    Command("arrangement list five.chi --from chirotope", 0, "type 5.3"),
    Command("proofs-check run printed.csv", 0, "agree"),
    Command("arrangement list --families", 0, "threshold-functions"),
    Command("arrangement draw braid-a3 -o braid.html", 0, writes="braid.html"),
    _needs("mesh", "arrangement draw braid-a3 -o no.stl"),
    _needs("mesh", "arrangement draw braid-a3 --model cells -o no.glb"),
    *(
        _needs("figures", f"arrangement draw braid-a3 --view {view} -o no.svg")
        for view in ("sphere", "planes", "stereographic", "gnomonic", "dual", "graph", "lattice")
    ),
    *(_needs("figures", f"arrangement draw braid-a3 -o no.{kind}") for kind in ("pdf", "png")),
    Command(f"equilibrium solve {_G}-preload-1 --wrench 0 1 0", 0, "resisted"),
    Command(f"equilibrium solve {_G} --wrench 0 1 0 --certificate proof.json", 1, "not resisted"),
    Command("equilibrium verify proof.json", 0, "valid"),
    Command("equilibrium lab -o lab.html", 0, writes="lab.html"),
    Command("arrangement lab braid-a3 -o lines.html", 0, writes="lines.html"),
    Command(f"equilibrium resisted {_G} --wrench 0 -1 0", 0, "oo"),
    Command(f"equilibrium resisted {_G} --slice fx fy", 0, "polygons"),
    Command("equilibrium resisted opposed-contacts", 0, "polyhedra"),
    Command(f"equilibrium resisted {_G} --wrench 0 -1 0 --margin", 0, "resisted: yes"),
    Command("equilibrium resisted single-contact --search --rays 4", 0, "4 directions"),
    Command(f"equilibrium draw {_G} --view slice -o slice.json", 0, writes="slice.json"),
    Command(f"equilibrium solve {_G} --wrench 0 1 0 --methods", 1, "full model"),
    Command(f"equilibrium info {_G} --force-closure", 0, "force closure"),
    Command("equilibrium info box-1-wall --modes --count", 0, "196"),
    Command("equilibrium draw ladder --model scene -o ladder.xml", 0, writes="ladder.xml"),
    Command("equilibrium make csv fingers.csv", 0, '"contacts"'),
    Command("equilibrium make floats fingers.csv", 0, '"contacts"'),
    Command("equilibrium make polygon wedge.json", 0, '"contacts"'),
    Command("equilibrium make shapes disc.json", 0, '"contacts"'),
    _needs("mesh", "equilibrium make mesh corner.obj --at 1 1 0 --friction 1/2"),
    _needs("space", "equilibrium solve three-fingers-on-a-ball --wrench 0 0 -1 0 0 0"),
    _needs("search", f"equilibrium solve {_G} --wrench 0 -1 0 --robust friction=1%"),
    Command("equilibrium make circle --angles 0 120 --friction 1/2", 0, '"contacts"'),
    Command("equilibrium make random --contacts 3", 0, '"contacts"'),
    *(
        Command(f"equilibrium make {name}", 0, '"bodies"')
        for name in ("stack", "wall", "arch", "ramp", "wedge", "cylinders", "ladder", "tongs")
    ),
    Command(f"equilibrium draw {_G} -o grasp.html", 0, writes="grasp.html"),
    *(
        _needs("figures", f"equilibrium draw {_G} {more} -o no.pdf")
        for more in ("", "--wrench 0 -1 0", "--view resist", "--view compare")
    ),
    Command("proofs-check list", 0, "single-solution"),
    Command("proofs-check list euler", 0, "statement"),
    Command("proofs-check run euler --output euler.md", 0, "as expected", "euler.md"),
    _needs("report", "proofs-check run euler --output no.html"),
    Command("proofs-check run table-three-contacts --json", 0, '"verdict"'),
    Command('proofs-check try "m >= 3" --samples 2 --classes 3..3', 0, "no counterexample found"),
    Command("proofs-check fit regions --of generic(m=2..6)", 0, "m**2 - m + 2"),
    Command("proofs-check extreme regions --of lines --classes 3..3", 0, "largest regions"),
    Command("proofs-check new mine", 0, writes="mine.py"),
    _needs("report", "proofs-check paper -o paper"),
    Command("proofs-check grade lecture.py answers.json", 0, "1 of 1"),
    Command("proofs-check sweep euler --elements 3..4 --samples 9 --store s.sqlite", 0, "euler"),
    Command("proofs-check sweep --store s.sqlite --status", 0, "euler"),
    Command("proofs-check report s.sqlite --output s.md", 0, writes="s.md"),
    _needs("completion", "arrangement --print-completion bash"),
    Command("proofs-check sweep --store all.sqlite --merge s.sqlite", 0, "chunks"),
    _needs(
        "dask",
        "proofs-check sweep euler --elements 3..4 --samples 9 --store t.sqlite "
        "--dask tcp://127.0.0.1:1",
    ),
)

#: With the extra all.
WITH_ALL = (
    Command("arrangement draw braid-a3 -o dual.stl", 0, writes="dual.stl"),
    Command("arrangement draw braid-a3 --model cells -o cells.glb", 0, writes="cells.glb"),
    Command("arrangement draw braid-a3 -o dual.obj", 0, writes="dual.obj"),
    Command("arrangement draw braid-a3 -o sphere.svg", 0, writes="sphere.svg"),
    Command("arrangement --print-completion bash", 0, "complete -o"),
    Command("equilibrium make mesh corner.obj --at 1 1 0 --friction 1/2", 0, '"contacts"'),
    Command("equilibrium solve three-fingers-on-a-ball --wrench 0 0 -1 0 0 0", 0, "resisted"),
    Command(f"equilibrium solve {_G} --wrench 0 -1 0 --robust friction=1%", 3, "for all"),
    Command("proofs-check run euler --output euler.html", 0, "as expected", "euler.html"),
    Command("proofs-check paper -o paper", 0, "single files", "paper/index.html"),
)

#: Run in the environment: all modules import, all data files are read, rich display does not fail.
PROBE = """
import importlib, importlib.util, pkgutil
import arrangement.errors, slipstates
from importlib.resources import files
for absent in ("matplotlib", "scipy", "trimesh", "clarabel", "jinja2", "igraph", "dask", "pytest"):
    assert importlib.util.find_spec(absent) is None, absent + " is not a dependency"
for name in ("arrangement", "equilibrium", "proofs_check"):
    package = importlib.import_module(name)
    assert (files(package) / "py.typed").is_file(), name + "/py.typed"
    assert (files(package) / "__init__.pyi").is_file(), name + "/__init__.pyi"
    for exported in dir(package):
        getattr(package, exported)
    for module in pkgutil.walk_packages(package.__path__, name + "."):
        if not module.name.endswith("__main__"):
            try:
                importlib.import_module(module.name)
            except arrangement.errors.MissingExtraError as error:
                assert "(the extra " in str(error)
from arrangement.library.census import census
from arrangement.library.files.table import read_arrangement
from arrangement.library.instances import paths as arrangements
from importlib.resources import files
from equilibrium.grasps.inputs.documents import read_grasp
from equilibrium.grasps.instances import paths as grasps
from equilibrium.grasps.schemas import grasp_schema
assert (files("arrangement.library.files") / "arrangement.schema.json").is_file()
assert len(census(5)) > 1 and grasp_schema()
assert arrangements() and grasps()
for name in arrangements():
    planes = read_arrangement(name)
    planes._repr_svg_(), planes._repr_html_()
for name in grasps():
    grasp = read_grasp(name)
    grasp._repr_svg_()
    if grasp.dimension == 2:
        read_arrangement(name)
"""

#: Prints every command line that answers --help.
PROGRAMS = """
import argparse, importlib
def walk(words, parser):
    print(*words)
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, inner in action.choices.items():
                walk([*words, name], inner)
for program in ("arrangement", "equilibrium", "proofs-check"):
    package = program.replace("-", "_")
    module = package + (".cli" if package == "arrangement" else ".cli.program")
    walk([program], importlib.import_module(module)._parser())
"""
