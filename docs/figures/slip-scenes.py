"""The sixty scenes of howto/physics-engines.rst as one archive, the same bytes each time."""

from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from equilibrium.scenes import benchmark, document_text

with ZipFile("slip-scenes.zip", "w") as archive:
    for name, scene in benchmark():
        # An entry without a date of its own is of 1980.
        text = document_text(scene.document())
        archive.writestr(ZipInfo(f"slip-scenes/{name}.json"), text, ZIP_DEFLATED)
