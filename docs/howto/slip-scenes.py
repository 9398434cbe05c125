"""Writes the sixty scenes of physics-engines.rst as one archive, the same bytes each time."""

from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from equilibrium.scenes import benchmark, document_text

with ZipFile(Path(__file__).with_suffix(".zip"), "w") as archive:
    for name, scene in benchmark():
        # An entry without a date of its own is of 1980.
        text = document_text(scene.document())
        archive.writestr(ZipInfo(f"slip-scenes/{name}.json"), text, ZIP_DEFLATED)
