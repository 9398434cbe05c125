"""Run the tests with the lowest and with the newest versions that pyproject.toml declares.

For each Python that is found, each of the two goes into an empty environment in a temporary folder;
two run at once.

    python tests/check_versions.py                    with the Pythons 3.11 and 3.13 that are found
    python tests/check_versions.py --python P         with these only (may be repeated)
    python tests/check_versions.py --versions lowest  or newest (may be repeated)
    python tests/check_versions.py -- tests/arrangement -x
                                                      what is after -- goes to pytest; else the
                                                      whole suite without its extended tests runs

It needs uv, which the extra `package` installs. Exit code 1 when something is wrong.
"""

import argparse
import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

# Run as a script, this file finds its own folder only.
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from tests.check_package import ROOT, Done, found_pythons, run

PYTHONS = ("python3.11", "python3.13")
VERSIONS = {"lowest": "lowest-direct", "newest": "highest"}
#: The lowest versions warn of what newer ones, which they bring themselves, no longer like.
WARNINGS = {
    "lowest": ("-W", "default::DeprecationWarning", "-W", "default::ImportWarning"),
    "newest": (),
}


def environment(python: str, versions: str, folder: Path) -> Path | Done:
    """Make an environment with the test tools; return its Python, or what failed."""
    uv = (sys.executable, "-m", "uv")
    here = folder / "bin" / "python"
    resolution = ("--resolution", VERSIONS[versions])
    for command in (
        (*uv, "venv", "--quiet", "--python", python, folder),
        (
            *uv,
            "pip",
            "install",
            "--quiet",
            "--compile-bytecode",
            "--python",
            here,
            *resolution,
            "-e",
            f"{ROOT}[test]",
        ),
    ):
        done = run(command, ROOT)
        if done.returncode:
            return done
    return here


def tested(python: str, versions: str, tests: Sequence[str]) -> Done:
    """Run the tests in a new environment; return how they end, or what failed before."""
    with tempfile.TemporaryDirectory() as name:
        made = environment(python, versions, Path(name))
        if isinstance(made, subprocess.CompletedProcess):
            return made
        options = ("-q", "-p", "no:cacheprovider", *WARNINGS[versions])
        return run((made, "-m", "pytest", *options, *tests), ROOT)


def main(arguments: Sequence[str]) -> int:
    """Run the tests in each environment; print how they end."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--python", action="append", metavar="P", help="an interpreter to try")
    parser.add_argument("--versions", action="append", choices=VERSIONS)
    parser.add_argument("tests", nargs="*", help="arguments of pytest, after --")
    options = parser.parse_args(arguments)
    pythons = found_pythons(options.python or PYTHONS)
    failed = not pythons or len(pythons) < len(options.python or ())
    asked = list(product(pythons, options.versions or VERSIONS))
    with ThreadPoolExecutor(max_workers=2) as pool:
        ended = pool.map(lambda one: tested(*one, options.tests), asked)
        for (python, versions), done in zip(asked, ended, strict=True):
            said = done.stdout + done.stderr
            last = re.findall(r"^.*\b(?:passed|failed|errors?)\b.* in .*$", said, re.MULTILINE)
            print(f"{python}, {versions} versions: {last[-1] if last else 'no tests'}", flush=True)
            if done.returncode or not last:
                failed = True
                print(said, file=sys.stderr)
    return int(failed)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
