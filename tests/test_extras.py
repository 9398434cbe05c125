"""The extras: what is needed only for meshes, space, reports or pictures is imported when used."""

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from arrangement.errors import EXTRAS, MissingExtraError, extra

ROOT = Path(__file__).resolve().parent.parent
#: Nothing that decides in the plane, counts or enumerates needs these.
OPTIONAL = sorted({library for libraries in EXTRAS.values() for library in libraries})
PLANAR = f"""
import sys
for name in {OPTIONAL!r}:
    sys.modules[name] = None
from arrangement import Arrangement, read_arrangement
from equilibrium import read_grasp, solve
from proofs_check import evaluate, registry
braid = read_arrangement("braid-a3")
assert braid.f_vector == (1, 14, 36, 24) and braid.region_count() == 24
braid.sphere().validate()
assert not solve(read_grasp("paper-three-contacts"), [0, 1, 0])
assert evaluate(registry()["table-three-contacts"]).as_expected
"""


def test_extras_are_those_of_the_distribution():
    with (ROOT / "pyproject.toml").open("rb") as stream:
        project = tomllib.load(stream)["project"]
    declared = project["optional-dependencies"]
    libraries = {
        name: tuple(entry.partition(">")[0] for entry in declared[name]) for name in EXTRAS
    }
    assert libraries == EXTRAS
    everything = [name for name in EXTRAS if name not in ("dask", "notebook")]
    assert declared["all"] == [f"slipstates[{','.join(everything)}]"]
    needed = {entry.partition(">")[0] for entry in project["dependencies"]}
    assert needed == {"lazy_loader", "networkx", "numpy", "python-flint", "sympy"}


def test_planar_answers_need_no_extra():
    run = subprocess.run([sys.executable, "-c", PLANAR], check=False, cwd=ROOT)
    assert run.returncode == 0


@pytest.mark.parametrize("name", EXTRAS)
def test_absent_library_names_its_extra(name):
    with pytest.raises(MissingExtraError) as caught, extra(name):
        raise ModuleNotFoundError("No module named 'one.two'", name="one.two")
    libraries = " ".join(EXTRAS[name])
    text = f"one is not installed (the extra {name}): pip install {libraries}"
    assert str(caught.value) == text
