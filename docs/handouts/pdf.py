"""Print the slides, sheets and solutions of the lessons as PDF, each beside its page, by Chromium.

    python docs/handouts/pdf.py docs/_build/html

A slide is a page; sheets are on A4.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from arrangement.console.progress import Bar

_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FOLDERS = ("course", "lessons")
_FLAGS = ("--headless", "--disable-gpu", "--no-first-run", "--no-pdf-header-footer")


def main(site: Path) -> None:
    """Print what lies in the folders ``lessons`` and ``course`` of a site."""
    program = next(filter(None, map(shutil.which, _NAMES)), None)
    if program is None:
        sys.exit(f"printing needs one of: {', '.join(_NAMES)}; or print each page from a browser")
    kinds = ("slides", "exercises", "solutions")
    found = (site.glob(f"{folder}/*-{kind}.html") for folder in FOLDERS for kind in kinds)
    pages = sorted(page for pages in found for page in pages)
    if not pages:
        sys.exit(f"{site} has no lessons; make docs builds them")
    flags = [*_FLAGS, *(["--no-sandbox"] if os.geteuid() == 0 else [])]
    bar = Bar(len(pages), "pages")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        for done, page in enumerate(pages):
            bar.update(done, page.name)
            to = [f"--user-data-dir={profile}", f"--print-to-pdf={page.with_suffix('.pdf')}"]
            command = [program, *flags, *to, page.resolve().as_uri()]
            subprocess.run(command, check=True, capture_output=True)
    bar.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
