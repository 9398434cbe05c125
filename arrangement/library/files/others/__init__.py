"""The formats of other programs; `formats` is the entry point."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec

from arrangement.library.files.documents import Format

from . import graphs, matrix, polymake, source_texts as texts

_GRAPH = "the planes themselves; it cannot be read back"


def formats() -> Iterator[Format]:
    """Yield the formats, in the order in which a text is tried.

    Chirotopes need the census, and that the families; without these packages they are left out.
    """
    yield Format("polymake", (".hyar",), polymake.RECOGNISED.match, polymake.read, polymake.write)
    yield Format(
        "oscar", (".mrdi",), polymake.OSCAR.match, polymake.read_oscar, polymake.write_oscar
    )
    sage = texts.SAGE.search, texts.read_sage, texts.write_sage
    yield Format("sage", (".sage",), *sage, loses=texts.loses_in_sage)
    macaulay2 = texts.ARRANGEMENT.search, texts.read_macaulay2, texts.write_macaulay2
    yield Format("macaulay2", (".m2",), *macaulay2)
    if all(find_spec(f"arrangement.library.{part}") for part in ("census", "families")):
        from . import chirotope

        yield Format(
            "chirotope",
            (".chi",),
            chirotope.recognises,
            chirotope.read,
            chirotope.write,
            chirotope.split,
            chirotope.loses,
        )
        yield Format(
            "topcom",
            (),
            chirotope.TOPCOM.fullmatch,
            chirotope.read_topcom,
            chirotope.write_topcom,
            loses=chirotope.loses,
        )
        yield Format(
            "christ",
            (),
            chirotope.recognises_christ,
            chirotope.read_christ,
            split=chirotope.split_christ,
        )
    yield Format(
        "equations",
        (".eqn",),
        matrix.recognises_equations,
        matrix.read_equations,
        matrix.write_equations,
    )
    yield Format("matrix", (".txt", ".csv"), matrix.recognises, matrix.read, matrix.write)
    yield from (
        Format(name, endings, write=write, loses=lambda _: _GRAPH)
        for name, endings, write in (
            ("off", (".off",), graphs.off),
            ("dot", (".dot", ".gv"), lambda planes: graphs.dot(graphs.dual(planes))),
            ("graphml", (".graphml",), lambda planes: graphs.graphml(graphs.dual(planes))),
            ("lattice-dot", (), lambda planes: graphs.dot(graphs.lattice(planes))),
            ("lattice-graphml", (), lambda planes: graphs.graphml(graphs.lattice(planes))),
        )
    )
