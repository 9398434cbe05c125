"""What the paths of a figure are."""

from __future__ import annotations

from typing import Any

from arrangement.drawing.scene.items import Path


def paths(figure: Any) -> list[Path]:
    """Return the paths of all artists of a figure; see `arrangement.drawing.figure`."""
    artists = [artist for axes in figure.axes for artist in axes.get_children()]
    return [item for artist in artists for item in getattr(artist, "items", ())]
