"""The generator of the census: one-plane extensions, distinguished by canonical tope graphs.

*Extensions.* Adding a plane with normal v to a representative gives a type that depends only on
the signs of ``v . r`` over its rays r: on the face of another central arrangement, whose normals
are the rays, in which v lies. All faces of that arrangement are enumerated, each with a witness.

*Types.* The tope graph (regions, joined when they share a facet) determines an arrangement's sign
vectors up to relabelling and reorientation ([BjornerEdelmanZiegler1990]). So two arrangements
have the same type exactly when their tope graphs are isomorphic; igraph's canonical form (BLISS)
decides that.

One representative per type need not have every extension of its type. That the numbers reach the
published ones shows that up to 8 planes nothing is missing.

With a file for progress what is done is kept, and an interrupted run goes on from there.
"""

from __future__ import annotations

import itertools
import json
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np

from arrangement.arrangement import Arrangement
from arrangement.console.progress import watched
from arrangement.console.writing import write_text_atomically
from arrangement.enumeration.great_circles import sphere_arrangement
from arrangement.errors import MissingExtraError
from arrangement.library.census.catalogue import MOST_PLANES
from arrangement.numbers.exact import IntegerVector, primitive

from .build import box

Normals: TypeAlias = tuple[IntegerVector, ...]

_START: Normals = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
#: Small normals are tried before witnesses, so that the representatives have small entries.
_SMALL = 3


def canonical_form(arrangement: Arrangement) -> bytes:
    """Return a text of the isomorphism class: equal exactly for arrangements of one type.

    For central arrangements in R^3, up to relabelling of planes and exchange of sides.

    Raises:
        MissingExtraError: igraph is not installed.
    """
    try:
        import igraph
    except ImportError:
        raise MissingExtraError(
            "canonical forms of graphs need igraph (the extra test): pip install igraph"
        ) from None
    sphere = sphere_arrangement(arrangement)
    region = sphere.incidence.region
    edges = np.stack([region[0::2], region[1::2]], axis=1)
    graph = igraph.Graph(n=sphere.region_count, edges=edges.tolist())
    # The permutation is canonical only as igraph itself applies it.
    graph = graph.permute_vertices(graph.canonical_permutation())
    ends = np.sort(np.array(graph.get_edgelist(), dtype=np.uint32).reshape(-1, 2), axis=1)
    ordered = ends[np.lexsort((ends[:, 1], ends[:, 0]))]
    return sphere.region_count.to_bytes(4, "big") + ordered.astype(">u4").tobytes()


def extensions(normals: Normals) -> Iterator[IntegerVector]:
    """Yield one new normal for each way to add a distinct plane, up to the sign of the normal."""
    sphere = sphere_arrangement(Arrangement(normals))
    rays = [sphere.ray(vertex) for vertex in range(sphere.vertex_count // 2)]
    present = {primitive(v) for v in normals} | {primitive([-x for x in v]) for v in normals}
    seen: set[tuple[int, ...]] = set()
    faces = (face for face in Arrangement(rays).faces() if any(face.witness))
    witnesses = ((primitive(face.witness), face.signs) for face in faces)
    for vector, signs in itertools.chain(_small_vectors(rays), witnesses):
        if signs not in seen:
            seen.update((signs, tuple(-s for s in signs)))
            if vector not in present:
                yield vector


def _small_vectors(rays: Sequence[IntegerVector]) -> Iterator[tuple[IntegerVector, IntegerVector]]:
    """Yield small primitive vectors, smallest first, with their signs over the rays."""
    vectors = box(_SMALL)
    products = vectors.astype(object) @ np.array(rays, dtype=object).T
    signs = (products > 0).astype(int) - (products < 0).astype(int)
    return zip(map(tuple, vectors.tolist()), map(tuple, signs.tolist()), strict=True)


def _next_types(
    representatives: Sequence[Normals], progress: Path | None = None
) -> tuple[Normals, ...]:
    """Return a representative of every type with one plane more, in a fixed order.

    Args:
        representatives: one for each type.
        progress: a file that keeps what each representative gave; its lines are used again.
    """
    found: dict[bytes, tuple[int, Normals]] = {}
    done = _kept(progress)
    for normals in watched(representatives, "types"):
        key = json.dumps(normals)
        if key not in done:
            done[key] = _extended(normals)
            _keep(progress, key, done[key])
        for form, extended in done[key].items():
            size = max(map(abs, extended[-1]))
            if form not in found or (size, extended) < found[form]:
                found[form] = (size, extended)
    listed = [(form[:4], normals) for form, (_, normals) in found.items()]
    return tuple(normals for _, normals in sorted(listed))


def _extended(normals: Normals) -> dict[bytes, Normals]:
    """Return one extension of a representative for each type that they have."""
    types: dict[bytes, Normals] = {}
    for vector in extensions(normals):
        extended = (*normals, vector)
        types.setdefault(canonical_form(Arrangement(extended)), extended)
    return types


def _kept(progress: Path | None) -> dict[str, dict[bytes, Normals]]:
    """Read what an earlier run has kept; a last line that was cut off is done again."""
    kept: dict[str, dict[bytes, Normals]] = {}
    if progress is None or not progress.exists():
        return kept
    for line in progress.read_text(encoding="utf-8").splitlines(keepends=True):
        if line.endswith("\n"):
            key, types = json.loads(line)
            kept[key] = {bytes.fromhex(f): tuple(map(tuple, rows)) for f, rows in types.items()}
    text = "".join(_line(key, types) for key, types in kept.items())
    write_text_atomically(progress, text)
    return kept


def _keep(progress: Path | None, key: str, types: dict[bytes, Normals]) -> None:
    if progress is not None:
        with progress.open("a", encoding="utf-8") as stream:
            stream.write(_line(key, types))


def _line(key: str, types: dict[bytes, Normals]) -> str:
    return json.dumps([key, {form.hex(): rows for form, rows in types.items()}]) + "\n"


def generate(most: int = MOST_PLANES, progress: Path | None = None) -> str:
    """Return the text of the shipped list, from 3 planes up to `most`."""
    levels: dict[int, tuple[Normals, ...]] = {3: (_START,)}
    for planes in range(4, most + 1):
        levels[planes] = _next_types(levels[planes - 1], progress)
        if sys.stderr.isatty():
            print(f"{planes} planes: {len(levels[planes])} types", file=sys.stderr)
    return document(levels)


def document(levels: dict[int, tuple[Normals, ...]]) -> str:
    """Return the list as JSON, one type a line."""
    parts = []
    for planes, types in levels.items():
        rows = ",\n".join(json.dumps(normals, separators=(",", ":")) for normals in types)
        parts.append(f'"{planes}": [\n{rows}\n]')
    return '{"schema_version": 1, "types": {\n' + ",\n".join(parts) + "\n}}\n"
