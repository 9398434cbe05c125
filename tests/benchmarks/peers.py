"""Who is measured beside us: how each is found, started, and said to be absent."""

import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ENVIRONMENT = ROOT / ".bench-venv"
BUILD = ROOT / "build" / "benchmarks"
#: The second line is what sign-vectors imports without saying so.
PEER_PACKAGES = (
    ("numpy", "igraph", "passagemath-polyhedra", "sign-vectors"),
    ("passagemath-symbolics", "passagemath-combinat", "passagemath-graphs"),
)


@dataclass(frozen=True)
class Measured:
    """Processor seconds (first run, later runs), megabytes, a count; or why there are none."""

    first: float = 0.0
    seconds: float = 0.0
    peak_mb: float = 0.0
    count: int = 0
    absent: str = ""


def ours(job: str, planes: int, timeout: float = 900) -> Measured:
    """Run a job of `job.py` with this interpreter."""
    return _run_job(Path(sys.executable), job, planes, timeout)


def peer(job: str, planes: int, timeout: float = 900) -> Measured:
    """Run a job of `job.py` in the peers' environment."""
    python = ENVIRONMENT / "bin" / "python"
    if not python.exists():
        return Measured(absent="no .bench-venv (run with --install)")
    return _run_job(python, job, planes, timeout)


def _run_job(python: Path, job: str, planes: int, timeout: float) -> Measured:
    done = _run([str(python), str(HERE / "job.py"), job, str(planes)], timeout)
    return done if isinstance(done, Measured) else Measured(**json.loads(done.splitlines()[-1]))


def _run(command: list[str], timeout: float, text: str | None = None) -> str | Measured:
    """Return what a program prints, or why it is absent."""
    try:
        done = subprocess.run(
            command,
            input=text,
            capture_output=True,
            text=True,
            timeout=timeout,
            cwd=ROOT,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Measured(absent=f"not finished in {timeout:.0f} s")
    if done.returncode:
        reason = (done.stderr.strip().splitlines() or [f"code {done.returncode}"])[-1]
        return Measured(absent=f"does not run here: {reason[:90]}")
    return done.stdout


def install_peers() -> str:
    """Create the peers' environment; return an empty text, or why it could not be done."""
    if not (ENVIRONMENT / "bin" / "python").exists():
        subprocess.run([sys.executable, "-m", "venv", str(ENVIRONMENT)], check=True)
    pip = [str(ENVIRONMENT / "bin" / "python"), "-m", "pip", "install", "--quiet"]
    for packages in PEER_PACKAGES:
        done = subprocess.run([*pip, *packages], capture_output=True, text=True, check=False)
        if done.returncode:
            return (done.stderr.strip().splitlines() or ["pip failed"])[-1]
    return ""


def build_cgal() -> str:
    """Compile the CGAL program; return an empty text, or why it is absent."""
    program = BUILD / "cgal_arrangement"
    source = HERE / "cgal_arrangement.cpp"
    if program.exists() and program.stat().st_mtime >= source.stat().st_mtime:
        return ""
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        return "no C++ compiler"
    BUILD.mkdir(parents=True, exist_ok=True)
    command = [compiler, "-O2", "-DNDEBUG", "-std=c++17", str(source), "-o", str(program)]
    done = subprocess.run(
        [*command, "-lgmp", "-lmpfr"], capture_output=True, text=True, check=False
    )
    return "libcgal-dev is not installed" if done.returncode else ""


def cgal(mode: str, rows: Sequence[Sequence[int]], timeout: float = 900) -> Measured:
    """Run the CGAL program on normals in one of its modes; the count is its number of faces."""
    absent = build_cgal()
    if absent:
        return Measured(absent=absent)
    text = "\n".join([str(len(rows)), *(" ".join(map(str, row)) for row in rows)])
    done = _run([str(BUILD / "cgal_arrangement"), mode], timeout, text)
    if isinstance(done, Measured):
        return done
    seconds, peak, _, _, faces = done.split()
    return Measured(float(seconds), float(seconds), float(peak), int(faces))


def polymake(rows: Sequence[Sequence[int]], timeout: float = 900) -> Measured:
    """Run polymake's chambers with signatures; the clock starts after the program has loaded."""
    program = shutil.which("polymake")
    if program is None:
        return Measured(absent="polymake is not installed")
    BUILD.mkdir(parents=True, exist_ok=True)
    script = BUILD / "chambers.pl"
    planes = ",".join(f"[{','.join(map(str, row))}]" for row in rows)
    script.write_text(
        'use application "fan";\n'
        f"my $h = new HyperplaneArrangement<Rational>(HYPERPLANES => [{planes}]);\n"
        "my $start = (times)[0] + (times)[1];\n"
        "my $count = $h->CHAMBER_SIGNATURES->rows();\n"
        'print((times)[0] + (times)[1] - $start, " ", $count, "\\n");\n',
        encoding="utf-8",
    )
    done = _run([program, "--script", str(script)], timeout)
    if isinstance(done, Measured):
        return done
    seconds, count = done.split()[-2:]
    return Measured(float(seconds), float(seconds), count=int(count))
