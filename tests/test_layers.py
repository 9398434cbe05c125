"""The direction of imports, between the packages and inside each of them."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.import_graph import Arrow, ImportGraph, circles

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("arrangement", "equilibrium", "proofs_check")


def lint_imports(folder: Path) -> subprocess.CompletedProcess[str]:
    program = "import sys, importlinter.cli as cli; sys.exit(cli.lint_imports(no_cache=True))"
    environment = {**os.environ, "PYTHONPATH": str(folder), "NO_COLOR": "1", "COLUMNS": "200"}
    return subprocess.run(
        [sys.executable, "-c", program],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_imports_point_one_way():
    result = lint_imports(ROOT)
    assert result.returncode == 0, result.stdout + result.stderr


#: Arrows that would close a circle, from a module to a package, and why they stay.
EXCEPTIONS = {
    ("arrangement.console.entry", "arrangement.cli"): "the program of the console script",
    ("arrangement.console.options.parser", "arrangement"): "the version, which is in no module",
    ("arrangement.console.plugins", "arrangement.cli"): "the programs; any may be absent",
    ("arrangement.console.plugins", "proofs_check"): "the programs; any may be absent",
    ("arrangement.console.plugins", "arrangement.library"): "what packages add; any may be absent",
    ("arrangement.console.plugins", "equilibrium"): "what packages add; any may be absent",
    ("arrangement.counts.whitney", "arrangement.counts.orbits"): "may be absent",
}


def is_exception(arrow: Arrow, exceptions: Iterable[Arrow]) -> bool:
    """Return whether an arrow is named; one to the version is to the package alone."""
    module, target = arrow
    return any(
        module == one and (target == other or f"{target}.".startswith(f"{other}."))
        for one, other in exceptions
    )


GRAPH = ImportGraph(ROOT, PACKAGES)


def circles_without(
    exceptions: Iterable[Arrow] = EXCEPTIONS, planted: Iterable[Arrow] = ()
) -> list[set[str]]:
    exceptions = list(exceptions)
    return circles(x for x in GRAPH.arrows.union(planted) if not is_exception(x, exceptions))


def test_no_modules_or_packages_name_each_other_in_a_circle():
    assert circles_without() == []


@pytest.mark.parametrize("arrow", EXCEPTIONS, ids=" to ".join)
def test_each_exception_would_close_a_circle(arrow):
    assert circles_without(EXCEPTIONS.keys() - {arrow})


@pytest.mark.parametrize(
    ("module", "text", "circle"),
    [
        (
            "arrangement.planes.planes",
            "def draw():\n    from arrangement.pictures import views",
            {"arrangement.planes.planes", "arrangement.pictures.views"},
        ),
        (
            "arrangement.drawing.colours",
            "def draw():\n    from arrangement.drawing.solids import flat_polygons",
            {"arrangement.drawing.colours", "arrangement.drawing.solids"},
        ),
        (
            "equilibrium.model.contact",
            "def solve():\n    from equilibrium import solve",
            {"equilibrium.model.contact", "equilibrium.decide.solver"},
        ),
        (
            "equilibrium.model.contact",
            "import equilibrium\nequilibrium.solve",
            {"equilibrium.model.contact", "equilibrium.decide.solver"},
        ),
        (
            "equilibrium.certificate.law",
            "PLACE = 'equilibrium.decide.solver:solve'",
            {"equilibrium.certificate.law", "equilibrium.decide.solver"},
        ),
        (
            "equilibrium.certificate.law",
            "PLACE = 'equilibrium.certificate.checker'",
            {"equilibrium.certificate.law", "equilibrium.certificate.checker"},
        ),
        (
            "equilibrium.pictures.layout",
            "PLACE = 'proof:draw_proof'",
            {"equilibrium.pictures.layout", "equilibrium.pictures.proof"},
        ),
    ],
    ids=["function", "packages", "facade", "attribute", "place", "module", "relative place"],
)
def test_a_planted_circle_is_found(module, text, circle):
    planted = GRAPH.arrows_of(module, text)
    assert any(circle <= part for part in circles_without(planted=planted))


def test_methods_that_work_in_higher_layers_are_registered():
    """The packages are imported as by a user, and by the import of a class alone."""
    program = """
from equilibrium.model.grasp import Grasp
from arrangement.console import plugins
import arrangement, equilibrium
methods = plugins._ATTACHED
assert {"Arrangement.draw", "Grasp.draw", "Verdict._repr_html_"} <= methods.keys()
for method in methods:
    owner, name = method.split(".")
    package = arrangement if hasattr(arrangement, owner) else equilibrium
    assert callable(getattr(getattr(package, owner), name)), method
    plugins.method_code(method)
"""
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, timeout=120, check=False)
    assert run.returncode == 0


#: A module, what it must not import, and the contract that says so.
PLANTED = [
    ("arrangement/numbers/exact", "equilibrium.model.grasp", "Import order"),
    ("equilibrium/model/errors", "proofs_check.statements.statement", "Import order"),
    ("arrangement/errors", "arrangement.planes.planes", "Inside arrangement"),
    ("arrangement/enumeration/any_dimension", "arrangement.counts", "Inside arrangement"),
    ("arrangement/counts/whitney", "arrangement.numbers.linear.programs", "import no enum"),
    ("arrangement/counts/whitney", "arrangement.enumeration.great_circles", "enumerators"),
    ("equilibrium/model/grasp", "equilibrium.cli", "Inside equilibrium"),
    ("equilibrium/certificate/document", "equilibrium.decide.verdict", "Inside equilibrium"),
    (
        "equilibrium/certificate/checker",
        "equilibrium.plane.search.motion_regions",
        "The checker of cert",
    ),
    (
        "equilibrium/plane/search/virtual_motions",
        "equilibrium.certificate.checker",
        "Inside equilibrium",
    ),
    (
        "equilibrium/certificate/checker",
        "arrangement.numbers.linear.programs",
        "The checker of cert",
    ),
    ("equilibrium/certificate/checker", "arrangement.enumeration", "The checker of cert"),
    ("proofs_check/routes/oracle", "equilibrium.decide.verdict", "brute-force implementation"),
    ("proofs_check/routes/oracle", "arrangement.counts", "brute-force implementation"),
    ("proofs_check/statements/statement", "proofs_check.reports.report", "Inside proofs_check"),
    ("proofs_check/routes/rivin", "proofs_check.statements.evidence", "Inside proofs_check"),
    ("proofs_check/routes/rivin", "arrangement.duals.inscribed", "Independent impl"),
    ("proofs_check/routes/dual_graph", "arrangement.enumeration", "Independent impl"),
    ("proofs_check/routes/oracle", "arrangement.numbers.exact", "brute-force implementation"),
]


def test_a_planted_import_is_caught(tmp_path):
    """All at once: each stands in the report of its contract."""
    copy_packages(tmp_path)
    for module, imported, _ in PLANTED:
        with planted_path(tmp_path / f"{module}.py").open("a", encoding="utf-8") as stream:
            stream.write(f"\nimport {imported}\n")
    report = lint_imports(tmp_path).stdout.partition("Broken contracts")[2]
    contracts = re.split(r"\n(?=[^\n]+\n-+\n)", report)
    for module, imported, contract in PLANTED:
        chain = f"{module.replace('/', '.')} -> {imported}"
        told = [text for text in contracts if contract in text.strip().partition("\n")[0]]
        assert told, (contract, report)
        assert any(chain in text for text in told), (chain, report)


def test_a_module_without_a_layer_is_caught(tmp_path):
    copy_packages(tmp_path)
    for package in PACKAGES:
        (tmp_path / package / "planted.py").write_text('"""In no layer."""\n', encoding="utf-8")
    result = lint_imports(tmp_path)
    assert result.returncode == 1, result.stdout + result.stderr
    assert all(f"- {package}.planted" in result.stdout for package in PACKAGES), result.stdout


@pytest.mark.parametrize("module", ["equilibrium/certificate", "proofs_check/routes/oracle.py"])
def test_a_renamed_module_is_caught(tmp_path, module):
    copy_packages(tmp_path)
    old = tmp_path / module
    old.rename(old.with_stem("renamed"))
    assert lint_imports(tmp_path).returncode == 1


def test_every_cross_check_of_the_table_has_a_test():
    page = (ROOT / "docs" / "architecture.rst").read_text(encoding="utf-8")
    _, _, table = page.partition("\nCross-checks\n")
    table, _, _ = table.removeprefix("-" * len("Cross-checks")).partition("\n-----")
    rows = table.count("   * - ") - 1
    named = re.findall(r"``(tests/\S+\.py)::(\w+)``", table)
    assert len(named) == rows > 0
    for path, test in named:
        assert f"def {test}(" in (ROOT / path).read_text(encoding="utf-8"), f"{path}::{test}"


def copy_packages(folder: Path) -> None:
    """With what is compiled: it is used only where its source is, unchanged."""
    ignore = shutil.ignore_patterns("_build")
    for package in PACKAGES:
        shutil.copytree(ROOT / package, folder / package, ignore=ignore)
    shutil.copy(ROOT / "pyproject.toml", folder)


def planted_path(module: Path) -> Path:
    """A module may be one file or, when it has grown, a package of the same name."""
    package = module.with_suffix("")
    return package / "__init__.py" if package.is_dir() else module


def test_counts_work_with_the_enumerators_out_of_reach():
    """Three generic planes have (1, 6, 12, 8) faces: eight octants and what bounds them."""
    program = """
import sys
for name in ("arrangement", "counts.completeness", "enumeration", "numbers.linear.programs"):
    sys.modules["arrangement." + name] = None
from arrangement.planes.planes import Planes
from arrangement.counts import f_vector
assert tuple(f_vector(Planes([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))) == (1, 6, 12, 8)
"""
    assert subprocess.run([sys.executable, "-c", program], timeout=60, check=False).returncode == 0


def test_certificates_are_read_and_checked_without_numpy():
    program = (
        "import sys; from equilibrium import Certificate, read_certificate, verify\n"
        "assert not {'numpy', 'sympy', 'scipy'} & set(sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, timeout=120, check=False)
    assert run.returncode == 0


#: In a copy of the process for each part: its modules are gone, the rest counts and decides.
REST = """
import contextlib, importlib, io, json, os, sys
import numpy, scipy.optimize, sympy

class Without:
    def __init__(self, finder, names):
        self.finder, self.names = finder, names
    def find_spec(self, name, path=None, target=None):
        if not any(f"{name}.".startswith(f"{gone}.") for gone in self.names):
            return self.finder.find_spec(name, path, target)

def rest():
    from arrangement import Arrangement
    from arrangement.cli import main
    from arrangement.counts import f_vector, region_count
    from equilibrium import read_grasp, solve
    planes = Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    assert tuple(f_vector(planes)) == tuple(planes.f_vector) == (1, 6, 12, 8)
    five = Arrangement([[int(i == j) for i in range(5)] for j in range(5)] + [[1] * 5])
    assert tuple(f_vector(five)) == tuple(five.f_vector) and region_count(five) == 62
    with contextlib.redirect_stdout(io.StringIO()):
        assert main(["count", "braid-a3"]) == 0
    grasp = read_grasp("paper-three-contacts-preload-1")
    assert solve(grasp, (0, 1, 0)) and not solve(grasp, (0, 50, 0))
    assert solve(grasp, (0, 50, 0)).certificate.verify()

assert not [name for name in sys.modules if name.startswith(("arrangement", "equilibrium"))]
for part, names in json.loads(sys.argv[1]).items():
    print("without", part, file=sys.stderr, flush=True)
    child = os.fork()
    if not child:
        sys.meta_path[:] = [Without(finder, names) for finder in sys.meta_path]
        rest()
        for name in names:
            with contextlib.suppress(ModuleNotFoundError):
                importlib.import_module(name)
                sys.exit(f"{name} was within reach")
        sys.exit()
    if os.waitpid(child, 0)[1]:
        sys.exit(1)
"""
#: What the paper does not need, each with the modules by which it is used.
OPTIONAL = {
    "space": (
        "equilibrium.core.relaxation",
        "equilibrium.core.tree",
        "equilibrium.pictures.space_grasp",
        "equilibrium.pictures.space_slice",
        "equilibrium.wrench_sets.along_in_space",
    ),
    "several bodies": ("equilibrium.decide.assemblies", "equilibrium.pictures.assemblies"),
    "contact modes": ("equilibrium.modes",),
    "scenes of engines": ("equilibrium.scenes",),
    "census": ("arrangement.library.census",),
    "counting by orbits": ("arrangement.counts.orbits",),
    "families": ("arrangement.library.families",),
    "irrational entries": ("arrangement.numbers.fields",),
    "formats of others": ("arrangement.library.files.others",),
    "labs": ("arrangement.pictures.lab", "equilibrium.pictures.lab"),
    "pictures": ("arrangement.pictures", "arrangement.drawing", "equilibrium.pictures"),
}


@pytest.mark.slow
def test_the_rest_counts_and_decides_without_each_part():
    for name in {name for names in OPTIONAL.values() for name in names}:
        path = ROOT / name.replace(".", "/")
        assert path.is_dir() or path.with_suffix(".py").is_file(), name
    command = [sys.executable, "-c", REST, json.dumps(OPTIONAL)]
    result = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, timeout=240, check=False
    )
    assert result.returncode == 0, result.stderr


def test_the_kit_draws_what_is_neither_planes_nor_a_grasp(tmp_path):
    """A triangle with its name, as a picture and as TikZ, where nothing but the kit is in reach."""
    pytest.importorskip("matplotlib")
    program = """
import sys
packages = ("planes", "counts", "enumeration", "duals", "arrangement", "library", "pictures")
for name in packages:
    sys.modules["arrangement." + name] = None
sys.modules["equilibrium"] = None
from arrangement.drawing.path_artist import write_scene
from arrangement.drawing.scene import Scene
def triangle():
    scene = Scene(60, 40)
    scene.polygon([(-50, -30), (50, -30), (0, 30)], gid="triangle", ec="#000000")
    scene.write((0, 0), "a triangle")
    return scene
for ending in ("svg", "tex"):
    write_scene("triangle." + ending, triangle, letters=True)
"""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", program]
    subprocess.run(command, cwd=tmp_path, env=environment, timeout=120, check=True)
    for ending in ("svg", "tex"):
        assert "triangle" in (tmp_path / f"triangle.{ending}").read_text(encoding="utf-8"), ending
