"""The folder that `proofs-check paper` writes, and its pictures for the pages."""

import shutil
from pathlib import Path

from proofs_check.cli.program import main

if main(["paper", "-o", "the-paper"]):
    raise RuntimeError("the pictures of the paper were not written")
for picture in Path("the-paper").glob("*.svg"):
    shutil.copy(picture, f"the-paper-{picture.name}")
