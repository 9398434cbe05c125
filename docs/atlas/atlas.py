"""An atlas of arrangements: python docs/atlas/atlas.py FOLDER [--only TEXT] [--jobs N].

A page each for the known simplicial arrangements, all isomorphism classes of three to seven planes,
and the
Coxeter arrangements with their deformations: pictures, TikZ, a model to print, numbers, and how to
make it. Pages need no network. Numbers come from the package, each time anew.
"""

import argparse
import re
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from arrangement import Arrangement, InputError, census, counts, families
from arrangement.library.census import identify
from arrangement.library.census.catalogue import PUBLISHED

TYPES = range(3, 8)
#: Coxeter types: of rank 3, and those with deformations.
MIRRORS, DEFORMED = ("A3", "B3", "H3"), ("A2", "B2", "G2", "A3")
DEFORMATIONS = ("shi", "catalan", "linial", "semiorder")
#: The views of a page, each with what it shows, the first one also as TikZ.
CIRCLES = {"sphere": "on the sphere", "gnomonic": "in the projective plane", "dual": "the dual"}
LINES = {"lines": "the lines"}
PLANES = {"planes": "the planes", "cells": "the cells"}
_PAGES = Environment(
    loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined
)


class Entry(NamedTuple):
    """A page: its part of the atlas, its title, the call and the command that make the planes."""

    part: str
    title: str
    function: str
    arguments: tuple[Any, ...]
    command: str = ""
    views: dict[str, str] = CIRCLES

    @property
    def name(self) -> str:
        """The name of its files."""
        return "-".join(re.findall(r"\w+", self.title.lower()))

    @property
    def call(self) -> str:
        """What Python makes it with."""
        if self.function == "census":
            return "census.census({})[{}]".format(*self.arguments)
        return f"families.{self.function}({', '.join(map(repr, self.arguments))})"

    def planes(self) -> Arrangement:
        """Return the arrangement itself."""
        if self.function == "census":
            return census.census(self.arguments[0])[self.arguments[1]]
        planes: Arrangement = getattr(families, self.function)(*self.arguments)
        return planes


def entries() -> Iterator[Entry]:
    """Yield what the atlas has, in its order."""
    for planes, number in families.simplicial_entries():
        title, command = f"A({planes}, {number})", f"simplicial --planes {planes} --number {number}"
        yield Entry("Simplicial arrangements", title, "simplicial", (planes, number), command)
    for m in TYPES:
        for k in range(PUBLISHED[m]):
            yield Entry(f"Types of {m} planes", f"Type {k + 1} of {m} planes", "census", (m, k))
    for name in MIRRORS:
        command = f"coxeter --type {name}"
        yield Entry("Mirrors", f"Mirrors of {name}", "coxeter", (name,), command)
    for family in DEFORMATIONS:
        for name in DEFORMED:
            title, command = (
                f"{family.capitalize()} arrangement of {name}",
                f"{family} --type {name}",
            )
            views = LINES if name.endswith("2") else PLANES
            yield Entry("Deformations", title, family, (name,), command, views)


def numbers(planes: Arrangement) -> list[tuple[str, str]]:
    """Return what is said of an arrangement, in words and numbers."""
    flat = planes.dimension == 2
    met = "points by number of lines" if flat or planes.is_central else "lines by number of planes"
    said = [
        ("lines" if flat else "planes", str(len(planes))),
        ("faces by dimension", ", ".join(map(str, planes.f_vector))),
        ("regions", f"{counts.region_count(planes):,}"),
        ("characteristic polynomial", polynomial(counts.characteristic_polynomial(planes))),
        (met, "; ".join(f"{n} on {k}" for k, n in counts.t_vector(planes).items())),
    ]
    if not planes.is_central:
        said.insert(3, ("bounded regions", f"{counts.bounded_region_count(planes):,}"))
        return said
    sides = "; ".join(f"{n} with {k}" for k, n in sorted(planes.p_vector.items()))
    kind = [word for word in ("simple", "simplicial") if getattr(planes, f"is_{word}")]
    said += [("regions by number of sides", sides), ("it is", ", ".join(kind) or "neither")]
    try:
        found = identify(planes)
    except InputError:  # more planes than the list of types has
        return said
    if found.type is not None:
        said.append(("type", f"{found.type} of {found.planes} planes"))
        said.append(("symmetries of the type", str(found.automorphisms)))
    if found.names:
        said.append(("also known as", ", ".join(found.names)))
    return said


def polynomial(found: Any) -> str:
    """Return a characteristic polynomial as text, factors over the integers apart."""
    import sympy

    return str(sympy.factor(found.as_expr())).replace("**", "^").replace("*", " ")


def make(entry: Entry, folder: Path) -> None:
    """Write the page of an entry with its files."""
    from arrangement.pictures import write_drawing

    planes = entry.planes()
    for k, view in enumerate(entry.views):
        for suffix in (".svg", ".tex") if not k else (".svg",):
            path = folder / f"{entry.name}-{view}{suffix}"
            write_drawing(planes, path, view, labels="none", legend="none")
    write_drawing(planes, folder / f"{entry.name}.stl")
    page = {"entry": entry, "numbers": numbers(planes)}
    text = _PAGES.get_template("page.html").render(page)
    (folder / f"{entry.name}.html").write_text(text, encoding="utf-8")


def made(chosen: list[Entry], folder: Path, jobs: int) -> Iterator[None]:
    """Make pages, in this many processes, and yield after each."""
    if jobs == 1:
        yield from (make(entry, folder) for entry in chosen)
        return
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        for work in as_completed([pool.submit(make, entry, folder) for entry in chosen]):
            yield work.result()


def main(words: list[str] | None = None) -> int:
    """Make the pages that were asked for, and the list of them."""
    parser = argparse.ArgumentParser(description="Make an atlas of arrangements.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="pages whose title has this text")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args(words)
    folder: Path = arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    chosen = [entry for entry in entries() if arguments.only.lower() in entry.title.lower()]
    if not chosen:
        parser.error(f"no page has {arguments.only!r} in its title")
    for done, _ in enumerate(made(chosen, folder, arguments.jobs), 1):
        print(f"\r{done}/{len(chosen)} pages", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    parts: dict[str, list[Entry]] = {}
    for entry in chosen:
        parts.setdefault(entry.part, []).append(entry)
    text = _PAGES.get_template("index.html").render(parts=parts, count=len(chosen))
    (folder / "index.html").write_text(text, encoding="utf-8")
    print(folder / "index.html")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
