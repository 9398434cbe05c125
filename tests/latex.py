"""LaTeX for the tests of TikZ files: it compiles them, and what comes out is looked at as pixels.

``pdflatex`` and ``pdftoppm`` come from the system (Debian: ``texlive-latex-base``,
``texlive-latex-recommended``, ``texlive-pictures``, ``poppler-utils``). Where they are missing the
tests are left out, and the run says so. ``TEX_TESTS=1`` demands them: then a missing program is a
failure. ``TEX_TESTS=0`` leaves them out on purpose.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import numpy.typing as npt

PROGRAMS = ("pdflatex", "pdftoppm")
PACKAGES = "texlive-latex-base texlive-latex-recommended texlive-pictures poppler-utils"
MISSING = f"pdflatex or pdftoppm is missing (Debian: apt-get install {PACKAGES})"
#: Pixels to the inch: a prime number, so that hardly a line lies just between two pixels.
RESOLUTION = 127

Pixels = npt.NDArray[np.float32]


def not_compiled() -> str | None:
    """Return in one line why TikZ files are not compiled, or None when they are to be."""
    choice = os.environ.get("TEX_TESTS", "")
    if choice == "0":
        return "TikZ files are not compiled: TEX_TESTS=0"
    if not choice and not is_there():
        return f"TikZ files are not compiled: {MISSING}"
    return None


def is_there() -> bool:
    """Return whether all programs are installed."""
    return all(map(shutil.which, PROGRAMS))


def compiled(source: Path) -> Path:
    """Return the PDF that pdflatex makes; its log says nothing about letters or boxes."""
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", source.name]
    done = subprocess.run(
        command, cwd=source.parent, capture_output=True, text=True, errors="replace", timeout=300,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-3000:]
    words = ("Warning", "Overfull", "Missing character")
    assert [x for x in done.stdout.splitlines() if any(word in x for word in words)] == []
    return source.with_suffix(".pdf")


def page_count(pdf: Path) -> int:
    """Return how many pages there are."""
    done = subprocess.run(["pdfinfo", str(pdf)], check=True, capture_output=True, text=True)
    return int(re.search(r"^Pages:\s*(\d+)$", done.stdout, re.MULTILINE)[1])  # type: ignore[index]


def pages(pdf: Path) -> list[Pixels]:
    """Return the pages as arrays (rows, columns, 3) of numbers from 0 to 1."""
    from PIL import Image

    command = ["pdftoppm", "-r", str(RESOLUTION), str(pdf), str(pdf.with_suffix(""))]
    subprocess.run(command, check=True, timeout=300)
    found = sorted(pdf.parent.glob(f"{pdf.stem}-*.ppm"))
    return [np.asarray(Image.open(path), np.float32) / np.float32(255) for path in found]


def unlike(one: Pixels, other: Pixels, reach: int = 1, tolerance: float = 0.25) -> float:
    """Return how many pixels one picture has and the other has nowhere near, per pixel of an edge.

    Near is within `reach` pixels, alike is a colour within `tolerance`.
    """
    strange = sum(
        int(_strange(a, b, reach, tolerance).sum()) for a, b in ((one, other), (other, one))
    )
    steps = [np.abs(np.diff(one, axis=k)).max(axis=2) > tolerance for k in (0, 1)]
    return strange / max(1, sum(int(step.sum()) for step in steps))


def _strange(one: Pixels, other: Pixels, reach: int, tolerance: float) -> npt.NDArray[np.bool_]:
    """Return the pixels of one picture whose colour the other lacks nearby."""
    strange: npt.NDArray[np.bool_] = np.abs(one - other).max(axis=2) > tolerance
    padded = np.pad(other, ((reach, reach), (reach, reach), (0, 0)), mode="edge")
    for down in range(2 * reach + 1):
        for along in range(2 * reach + 1):
            at = np.nonzero(strange)
            there = padded[at[0] + down, at[1] + along]
            strange[at] = np.abs(one[at] - there).max(axis=1) > tolerance
    return strange
