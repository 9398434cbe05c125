"""Build the source archive and the wheel; see that they are whole and work where little else is.

For each Python that is found, the wheel goes into an empty environment, without any extra. There
every command must do its work, or name the extra that it needs, and answer ``--help`` quickly. Then
the extra ``all`` is installed, and what needed an extra must work.

    python tests/check_package.py             with the Pythons 3.11, 3.12 and 3.13 that are found,
                                              or else with the one that runs this
    python tests/check_package.py --python P  with these only (may be repeated)
    python tests/check_package.py --archive   also `make verify` and `make test` in the unpacked
                                              source archive (long)
    python tests/check_package.py --release   also what a release needs: a second build from a clone
                                              has the same bytes, the tag is the version, citation
                                              and recipe are valid

Exit code 1 when something is wrong.
"""

import argparse
import math
import os
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile
from collections.abc import Iterable, Sequence
from pathlib import Path

# Run as a script, this file finds its own folder only.
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from tests.package_commands import COMMANDS, INPUTS, PROBE, PROGRAMS, WITH_ALL, Command

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("arrangement", "equilibrium", "proofs_check")
PYTHONS = ("python3.11", "python3.12", "python3.13")
RECIPE = ".github/conda/recipe.yaml"
#: What must be in the source archive beside the packages, the tests and the documentation.
FILES = {
    ".zenodo.json",
    "CHANGELOG.md",
    "CITATION.cff",
    "CONTRIBUTING.md",
    "LICENSE",
    "Makefile",
    "README.md",
    RECIPE,
    "constraints.txt",
}
#: What the wheel has in another place than the source archive.
MOVED = {"proofs_check/slipstates.py": "slipstates.py"}
RUBBISH = re.compile(
    r"(^|/)(__pycache__|_build|_generated|names|build|dist|report|counterexamples|\.(?!github|gitignore|zenodo)"
    r"[^/]*)(/|$)|\.(pyc|sqlite|egg-info)$"
)
#: Programs of other packages, each in an environment of its own.
UV_RUN = (sys.executable, "-m", "uv", "tool", "run")
UV_PIP = (sys.executable, "-m", "uv", "pip")
#: CPU seconds for --help: of the first run that is within it, or of the fastest of so many.
HELP_LIMIT, HELP_RUNS = 1.0, 3

Done = subprocess.CompletedProcess[str]


def run(command: Sequence[str | Path], folder: Path, **variables: str) -> Done:
    """Run a program in a folder; nothing of the caller's Python reaches it."""
    hidden = ("PYTHON", "VIRTUAL_ENV", "COVERAGE", "PYTEST", "MAKE", "MFLAGS")
    environment = {k: v for k, v in os.environ.items() if not k.startswith(hidden)}
    return subprocess.run(
        [str(word) for word in command],
        cwd=folder,
        env={**environment, **variables},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )


def build(folder: Path, source: Path = ROOT) -> tuple[Path, Path]:
    """Build the source archive, and the wheel from it."""
    done = run([sys.executable, "-m", "build", "--outdir", folder, source], folder)
    if done.returncode:
        raise SystemExit(f"error: the build failed\n{done.stdout}{done.stderr}")
    return next(folder.glob("*.tar.gz")), next(folder.glob("*.whl"))


def wrong_files(archived: set[str], wheel: set[str], tracked: set[str]) -> list[str]:
    """Compare what is in the source archive, in the wheel and, where known, under version control.

    Args:
        archived: paths in the source archive, without its first folder.
        wheel: paths in the wheel, without its metadata.
        tracked: paths under version control; empty when there is none.
    """
    archived = {MOVED.get(path, path) for path in archived}
    wanted = {
        MOVED.get(path, path) for path in tracked if path.startswith((*PACKAGES, "tests/", "docs/"))
    }
    packages = {path for path in archived if path.startswith(tuple(f"{p}/" for p in PACKAGES))}
    packages |= archived & set(MOVED.values())
    return [
        *(f"rubbish in the source archive: {p}" for p in sorted(archived) if RUBBISH.search(p)),
        *(f"not in the source archive: {p}" for p in sorted((wanted | FILES) - archived)),
        *(f"in the source archive, not in the wheel: {p}" for p in sorted(packages - wheel)),
        *(f"in the wheel, not in the source archive: {p}" for p in sorted(wheel - packages)),
    ]


def _contents(archive: Path, wheel: Path) -> list[str]:
    with tarfile.open(archive) as tar:
        archived = {m.name.partition("/")[2] for m in tar.getmembers() if m.isfile()}
    with zipfile.ZipFile(wheel) as packed:
        names = {name for name in packed.namelist() if ".dist-info/" not in name}
    versioned = (ROOT / ".git").exists() and shutil.which("git")
    listed = run(["git", "ls-files"], ROOT).stdout.splitlines() if versioned else []
    return wrong_files(archived, names, set(listed))


def _metadata(*archives: Path) -> list[str]:
    """An index takes the metadata, and renders the long description."""
    twine = (*UV_RUN, "--with", "readme-renderer[md]", "twine", "check", "--strict")
    done = run([*twine, *archives], ROOT)
    return [f"twine check: {done.stdout}{done.stderr}"] if done.returncode else []


def _release(archives: Sequence[Path], folder: Path) -> list[str]:
    """Return what a release lacks, in a clone of the last commit."""
    clone, again = folder / "clone", folder / "again"
    again.mkdir()
    done = run(["git", "clone", "--quiet", "--depth", "1", ROOT.as_uri(), clone], folder)
    if done.returncode:
        return [f"no clone for a second build: {done.stderr}"]
    wrong = [
        f"{one.name}: a build from a clone has other bytes (are all changes committed?)"
        for one, other in zip(archives, build(again, clone), strict=True)
        if one.read_bytes() != other.read_bytes()
    ]
    tags = run(["git", "tag", "--points-at", "HEAD"], ROOT).stdout.split()
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    wrong += wrong_tags(tags, archives[-1].name.split("-")[1], changelog)
    for command in (
        (*UV_RUN, "cffconvert", "--validate", "-i", "CITATION.cff"),
        (*UV_RUN, "--from", "py-rattler-build", "python", "-c", RENDER, RECIPE),
    ):
        done = run(command, ROOT)
        print(f"  {command[-1]}: {(done.stdout.splitlines() or ['-'])[-1]}", flush=True)
        if done.returncode:
            wrong.append(f"{command[-1]}: {done.stdout}{done.stderr}")
    return wrong


#: What the builder of conda packages makes of a recipe; it refuses unknown fields.
RENDER = """
import sys
from pathlib import Path
from rattler_build import RenderConfig, Stage0Recipe, VariantConfig
recipe = Stage0Recipe.from_yaml(Path(sys.argv[1]).read_text(encoding="utf-8"))
print(*recipe.render(VariantConfig(), RenderConfig()))
"""


def wrong_tags(tags: Iterable[str], version: str, changelog: str) -> list[str]:
    """Compare the tags of a commit with its version, and with the section of the changelog."""
    [heading] = re.findall(rf"^## \[{re.escape(version)}\] - (.*)$", changelog, re.MULTILINE)
    dated = re.fullmatch(r"\d{4}-\d\d-\d\d", heading)
    releases = [tag for tag in tags if tag.startswith("v")]
    wrong = [
        f"the tag is {tag}; the version is {version}" for tag in releases if tag[1:] != version
    ]
    if releases and not dated:
        wrong.append(f"the changelog dates the release {heading!r}; expected a day")
    return wrong


class Installed:
    """The wheel in an empty environment, and an empty folder to work in."""

    def __init__(self, python: str, wheel: Path, folder: Path) -> None:
        self.bin = folder / "environment" / "bin"
        self.work = folder / "work"
        self.work.mkdir(parents=True)
        created = run([python, "-m", "venv", "--without-pip", folder / "environment"], folder)
        if created.returncode:
            raise SystemExit(f"error: {python} makes no environment\n{created.stderr}")
        self.wheel = wheel
        self.install()

    def install(self, extras: str = "") -> None:
        """Install the wheel, with extras such as ``[all]``; print how long it takes."""
        where = ("--quiet", "--python", str(self.bin / "python"))
        asked = ("--constraint", "constraints.txt", f"{self.wheel}{extras}")
        start = time.monotonic()
        for command in ((*UV_PIP, "install", *where, *asked), (*UV_PIP, "check", *where)):
            done = run(command, ROOT)
            if done.returncode:
                raise SystemExit(f"error: {' '.join(command)}\n{done.stdout}{done.stderr}")
        seconds = time.monotonic() - start
        size = sum(p.stat().st_size for p in self.bin.parent.rglob("*") if p.is_file())
        what = extras or "no extra"
        print(f"  installed with {what} in {seconds:.0f} s: {size // 10**6} MB", flush=True)

    def run(self, *words: str) -> Done:
        return run([self.bin / words[0], *words[1:]], self.work)

    def check(self) -> list[str]:
        """Return what is wrong: data, commands, times of ``--help``."""
        probe = self.run("python", "-W", "error", "-c", PROBE)
        programs = [line.split() for line in self.run("python", "-c", PROGRAMS).stdout.splitlines()]
        wrong = [f"import: {probe.stderr}"] if probe.returncode else []
        wrong += untried(programs)
        for name, text in INPUTS.items():
            (self.work / name).write_text(text, encoding="utf-8")
        wrong += self.tried(COMMANDS) + self.slow(programs)
        self.install("[all]")
        return wrong + self.tried(WITH_ALL)

    def tried(self, commands: Iterable[Command]) -> list[str]:
        """Return what is wrong with the outcomes of commands."""
        done = ((command, self.run(*shlex.split(command.line))) for command in commands)
        return [text for command, one in done for text in complaints(command, one, self.work)]

    def slow(self, programs: list[list[str]]) -> list[str]:
        """Time ``--help`` of every program and subcommand, again where the machine may be busy."""
        wrong, times = [], {}
        for words in programs:
            seconds = math.inf
            for _ in range(HELP_RUNS):
                seconds = min(seconds, self.seconds(*words))
                if seconds <= HELP_LIMIT:
                    break
            times[" ".join(words)] = seconds
            if seconds > HELP_LIMIT:
                wrong.append(f"{' '.join(words)} --help: {seconds:.2f} CPU seconds")
        for name in ("arrangement", "equilibrium", "proofs-check"):
            print(f"  {name} --help: {1000 * times[name]:.0f} ms")
        worst = max(times, key=lambda name: times[name])
        print(f"  slowest of {len(times)}: {worst} --help: {1000 * times[worst]:.0f} ms")
        return wrong

    def seconds(self, *words: str) -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = self.run(*words, "--help")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode or not done.stdout.startswith("usage: "):
            return float("inf")
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def untried(programs: Iterable[Sequence[str]]) -> list[str]:
    """Every subcommand that has no subcommands of its own is among the commands tried."""
    known = {tuple(words) for words in programs}
    leaves = {words for words in known if not any(o[:-1] == words for o in known)}
    tried = [tuple(shlex.split(command.line)) for command in COMMANDS]
    return [
        f"no command here tries {' '.join(words)}"
        for words in sorted(leaves)
        if not any(line[: len(words)] == words for line in tried)
    ] + ([] if leaves else ["the programs list no commands"])


def complaints(command: Command, done: Done, folder: Path) -> list[str]:
    """Return what is wrong with the outcome of one command."""
    said = done.stdout + done.stderr
    wrong = []
    if "Traceback" in said:
        wrong.append("a traceback")
    if done.returncode != command.code:
        wrong.append(f"exit code {done.returncode}, not {command.code}")
    if command.prints not in said:
        wrong.append(f"does not say {command.prints!r}")
    written = folder / command.writes
    if command.writes and not (written.is_file() and written.stat().st_size):
        wrong.append(f"does not write {command.writes}")
    if any(folder.glob("no.*")):
        wrong.append("leaves a file of a picture that it cannot draw")
    return [f"{command.line}: {text}\n{said}" for text in wrong]


def found_pythons(names: Sequence[str]) -> list[str]:
    """Return the interpreters that run and can make environments."""
    found = []
    for name in names:
        path = shutil.which(name)
        ready = path and run([path, "-c", "import ensurepip, venv"], ROOT).returncode == 0
        if ready and path:
            found.append(path)
        else:
            print(f"{name}: not found; not checked here")
    return found


def _unpacked(archive: Path, folder: Path) -> list[str]:
    """Run the two commands of the README in the unpacked source archive."""
    with tarfile.open(archive) as tar:
        tar.extractall(folder, filter="data")
    [top] = folder.iterdir()
    done = (run(["make", target], top) for target in ("verify", "test"))
    return [f"{d.args}:\n{d.stdout}{d.stderr}" for d in done if d.returncode]


def main(arguments: Sequence[str]) -> int:
    """Build and check; print what is wrong."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--python", action="append", metavar="P", help="an interpreter to check")
    parser.add_argument("--archive", action="store_true", help="also run the suite from the sdist")
    parser.add_argument("--release", action="store_true", help="also what a release needs")
    options = parser.parse_args(arguments)
    pythons = found_pythons(options.python or PYTHONS)
    if len(pythons) < len(options.python or ()):
        return 1
    pythons = pythons or [sys.executable]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        archive, wheel = build(folder)
        for path in (archive, wheel):
            print(f"{path.name}: {path.stat().st_size // 1000} kB")
        wrong = [*_contents(archive, wheel), *_metadata(archive, wheel)]
        if options.release:
            wrong += _release((archive, wheel), folder)
        for number, python in enumerate(pythons):
            start = time.monotonic()
            print(f"{python}: the wheel in an empty environment", flush=True)
            here = folder / str(number)
            here.mkdir()
            wrong += [f"{python}: {text}" for text in Installed(python, wheel, here).check()]
            tried, seconds = len(COMMANDS) + len(WITH_ALL), time.monotonic() - start
            print(f"  {tried} commands tried, {seconds:.0f} s", flush=True)
        if options.archive:
            wrong += _unpacked(archive, folder / "unpacked")
    for text in wrong:
        print(text, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
