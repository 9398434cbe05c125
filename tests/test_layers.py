"""The direction of imports, between the packages and inside each of them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

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


def test_imports_point_one_way() -> None:
    result = lint_imports(ROOT)
    assert result.returncode == 0, result.stdout + result.stderr


PLANTED = [
    ("arrangement/exact.py", "import equilibrium.grasp", "Planes know no forces"),
    ("equilibrium/errors.py", "import proofs_check.claim", "Planes know no forces"),
    ("arrangement/errors.py", "import arrangement.planes", "Inside arrangement"),
    ("arrangement/faces.py", "import arrangement.counts", "counts, faces"),
    ("arrangement/counts/planted.py", "import arrangement.faces", "counts, faces"),
    ("arrangement/counts/planted.py", "import arrangement.linprog", "counts, linprog"),
    ("arrangement/counts/planted.py", "import arrangement.sphere", "counts, sphere"),
    ("arrangement/counts/planted.py", "import arrangement.space", "counts, space"),
    ("arrangement/counts/planted.py", "import arrangement.linear", "their own linear algebra"),
    ("equilibrium/grasp.py", "import equilibrium.cli", "Inside equilibrium"),
    ("equilibrium/certificate.py", "import equilibrium.passive", "Inside equilibrium"),
    ("equilibrium/checker.py", "import equilibrium.cells", "Inside equilibrium"),
    ("equilibrium/cells.py", "import equilibrium.coverage", "takes nothing from the checker"),
    ("equilibrium/systems.py", "import equilibrium.conditions", "takes nothing from the checker"),
    ("equilibrium/checker.py", "import arrangement.linprog", "with the solver: linprog"),
    ("equilibrium/checker.py", "import arrangement.faces", "with the solver: faces"),
    ("equilibrium/checker.py", "import arrangement.space", "with the solver: space"),
    ("proofs_check/oracle.py", "import equilibrium.passive", "brute-force route"),
    ("proofs_check/oracle.py", "import arrangement.counts", "brute-force route"),
    ("proofs_check/claim.py", "import proofs_check.report", "Inside proofs_check"),
]


@pytest.mark.parametrize(("module", "statement", "contract"), PLANTED)
def test_a_planted_import_is_caught(
    tmp_path: Path, module: str, statement: str, contract: str
) -> None:
    copy_packages(tmp_path)
    target = tmp_path.joinpath(*statement.split()[1].split(".")).with_suffix(".py")
    if not (target.exists() or target.with_suffix("").exists()):
        target.write_text('"""Stands for a module not written yet."""\n')
    module_path = planted_path(tmp_path / module)
    with module_path.open("a", encoding="utf-8") as stream:
        stream.write(f"\n{statement}\n")

    result = lint_imports(tmp_path)

    assert result.returncode == 1, result.stdout + result.stderr
    _, _, broken = result.stdout.partition("Broken contracts")
    assert contract in broken, result.stdout


@pytest.mark.parametrize("package", PACKAGES)
def test_a_module_without_a_layer_is_caught(tmp_path: Path, package: str) -> None:
    copy_packages(tmp_path)
    (tmp_path / package / "planted.py").write_text('"""In no layer."""\n', encoding="utf-8")

    result = lint_imports(tmp_path)

    assert result.returncode == 1, result.stdout + result.stderr
    assert f"- {package}.planted" in result.stdout


def copy_packages(folder: Path) -> None:
    ignore = shutil.ignore_patterns("__pycache__")
    for package in PACKAGES:
        shutil.copytree(ROOT / package, folder / package, ignore=ignore)
    shutil.copy(ROOT / "pyproject.toml", folder)


def planted_path(module: Path) -> Path:
    """A module may be one file or, when it has grown, a package of the same name."""
    package = module.with_suffix("")
    return package / "__init__.py" if package.is_dir() else module


def test_counts_work_with_the_enumerators_out_of_reach() -> None:
    """Three generic planes have (1, 6, 12, 8) faces: eight octants and what bounds them."""
    program = """
import sys
for name in ("certify", "faces", "linprog", "published", "space", "sphere"):
    sys.modules["arrangement." + name] = None
from arrangement import Arrangement
from arrangement.counts import f_vector
assert tuple(f_vector(Arrangement([[1, 0, 0], [0, 1, 0], [0, 0, 1]]))) == (1, 6, 12, 8)
"""
    subprocess.run([sys.executable, "-c", program], check=True, timeout=60)
