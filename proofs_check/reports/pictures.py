"""Pictures of a result for a page: its views, or else the counterexample, as SVG text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from arrangement.drawing.output import require_matplotlib
from arrangement.errors import MissingExtraError
from arrangement.library.files.table import read_arrangement
from arrangement.pictures.views import DRAWINGS as OF_PLANES
from equilibrium.decide.verdict import solve
from equilibrium.model.grasp import Grasp
from equilibrium.pictures.views import DRAWINGS as OF_GRASPS

#: What a page says where pictures are missing.
WITHOUT = "Pictures need matplotlib: pip install 'slipstates[figures]', then make the report again."


def available() -> bool:
    """Return whether pictures can be drawn."""
    try:
        require_matplotlib()
    except MissingExtraError:
        return False
    return True


def pictures(result: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the pictures of a result as SVG for a page, and their captions.

    Without views it is the counterexample: central planes with their dual; a grasp with its
    equilibrium, or with the proof that there is none.
    """
    counterexample = (result.get("counterexample") or {}).get("instance")
    views = result.get("views") or [{"name": "", "caption": "", "options": {}, "instance": None}]
    for k, view in enumerate(views):
        instance = view["instance"] or counterexample
        svg = _svg(instance, view["name"], view["options"]) if instance else None
        if svg is not None:
            yield _for_page(svg, f"{result['id']}-{k}"), view["caption"]


def _svg(instance: Mapping[str, Any], name: str, options: Mapping[str, Any]) -> str | None:
    if instance.get("planes"):
        known = {key: instance[key] for key in ("planes", "offsets") if key in instance}
        planes = read_arrangement({"schema_version": 1, **known})
        if not name and (planes.dimension != 3 or not planes.is_central):
            return None
        return OF_PLANES.svg(planes, name or "dual", **options)
    if instance.get("contacts"):
        grasp = Grasp.from_dict({k: v for k, v in instance.items() if k != "wrench"})
        if not name and "wrench" in instance:
            wrench = instance["wrench"]
            name = "grasp" if solve(grasp, wrench).stable else "proof"
            options = {"wrench": wrench}
        return OF_GRASPS.svg(grasp, name or "grasp", **options)
    return None


def _for_page(svg: str, name: str) -> str:
    """Return SVG that can stand in a page beside others: its names are its own."""
    opening, body = svg[svg.index("<svg") :].split(">", 1)
    opening = re.sub(r' (xmlns(:\w+)?|height|version)="[^"]*"', "", opening)
    body = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>", "", body, flags=re.DOTALL)
    body = re.sub(r' d="[^"]*"', _shorter, body)
    prefix = re.sub(r"[^a-z0-9-]", "", name)
    body = re.sub(r'( id="|url\(#|href="#)', rf"\g<1>{prefix}-", body)
    return f"{opening}>{body}"


def _shorter(path: re.Match[str]) -> str:
    """Return the data of a path with two digits after the point, on fewer lines."""
    return re.sub(r"(\.\d\d)\d+", r"\1", path[0]).replace("\n", "")
