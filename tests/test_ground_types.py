"""The exact-number tests run on both kinds of SymPy's integers and rationals."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from sympy.external.gmpy import GROUND_TYPES

ROOT = Path(__file__).resolve().parents[1]
FILES = (
    Path(__file__),
    *(
        ROOT / "tests/arrangement" / f"test_{name}.py"
        for name in ("exact", "planes", "symbolic", "counts_operations")
    ),
)


@pytest.mark.slow
def test_exact_numbers_pass_on_both_ground_types_of_sympy():
    """The exact-number tests run again with the ground types that this process does not have."""
    ground_types = "python" if GROUND_TYPES == "flint" else "flint"
    check = f"import sympy.external.gmpy as g; assert g.GROUND_TYPES == {ground_types!r}"
    arguments = ["-q", "-n0", "-k", "not both_ground_types", *map(str, FILES)]
    run = f"import pytest, sys; sys.exit(pytest.main({arguments!r}))"
    done = subprocess.run(
        [sys.executable, "-c", f"{check}; {run}"],
        env={**os.environ, "SYMPY_GROUND_TYPES": ground_types},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
