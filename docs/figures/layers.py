"""The layers of each package, from the contracts in pyproject.toml and the imports themselves.

An arrow means "imports". Arrows that follow from others are left out.
"""

import ast
import pathlib
import tomllib

import matplotlib.pyplot as plt
import networkx as nx
from matplotlib.patches import FancyArrowPatch
from matplotlib.path import Path

from arrangement.pictures import save_figure

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROW, GAP, RIGHT, WIDTH = 6.5, 2.0, 142.0, 178.0  # mm: a module, between layers, their end, all


def contracts():
    """Return the layers of each package, highest first; "|" divides independent modules."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = [c for c in settings["tool"]["importlinter"]["contracts"] if "containers" in c]
    return {
        contract["containers"][0]: [row.replace(":", " ").split() for row in contract["layers"]]
        for contract in layers
    }


def imports(package):
    """Return the graph of the modules of a package; an edge points to what is imported."""
    graph = nx.DiGraph()
    for path in sorted((ROOT / package).rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        home = list(parts[:-1])
        part = parts[1]
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for_types = {
            node
            for branch in ast.walk(tree)
            if isinstance(branch, ast.If) and getattr(branch.test, "id", "") == "TYPE_CHECKING"
            for node in ast.walk(branch)
        }
        for node in ast.walk(tree):
            if not isinstance(node, ast.ImportFrom) or node in for_types:
                continue
            base = home[: len(home) - node.level + 1] if node.level else []
            base = [*base, *(node.module or "").split(".")]
            names = [[*filter(None, base), alias.name] for alias in node.names]
            for name in names:
                if name[0] == package and len(name) > 1 and name[1] != part:
                    graph.add_edge(part, name[1])
    return graph


def sentence(package, part):
    """Return the first sentence of the docstring of a module."""
    path = ROOT / package / part
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8")))
    return text.split("\n\n")[0].replace("\n", " ").replace("``", "").replace("`", "").rstrip(".")


def draw_layers(package, rows):
    """Draw the modules of one package, high layers on top, and their imports as arcs beside."""
    bands = [[part for part in row if part != "|"] for row in rows]
    order = [part for band in bands for part in band]
    graph = nx.transitive_reduction(nx.DiGraph(imports(package).subgraph(order).edges))
    height = GAP + sum(len(band) * ROW + GAP for band in bands)
    figure = plt.figure(figsize=(WIDTH / 25.4, height / 25.4))
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, WIDTH), ylim=(height, 0))
    axes.axis("off")
    middle, top = {}, GAP
    for row, band in zip(rows, bands, strict=True):
        shape = (1, top), RIGHT - 1, len(band) * ROW
        axes.add_patch(plt.Rectangle(*shape, facecolor="#eef3f8", edgecolor="#5b7083", lw=0.6))
        for k, part in enumerate(band):
            middle[part] = y = top + (k + 0.5) * ROW
            axes.text(3, y, part, va="center", family="monospace", fontsize=8, weight="bold")
            axes.text(30, y, sentence(package, part), va="center", fontsize=6.5, color="#333333")
            if k:
                border = (
                    {"lw": 2.5, "color": "black"} if "|" in row else {"lw": 0.3, "color": "gray"}
                )
                axes.plot([1, RIGHT], [y - ROW / 2] * 2, solid_capstyle="butt", **border)
        top += len(band) * ROW + GAP
    for above, below in sorted(graph.edges):
        y, v = middle[above] + 0.7, middle[below] - 0.7
        reach = RIGHT + 4 + 0.36 * abs(v - y)
        curve = Path([(RIGHT, y), (reach, y), (reach, v), (RIGHT, v)], [1, 4, 4, 4])
        style = {"arrowstyle": "-|>,head_length=2.5,head_width=1.2", "color": "#8a3b12", "lw": 0.7}
        axes.add_patch(FancyArrowPatch(path=curve, shrinkA=0, shrinkB=0, **style))
    return figure


for name, layers in contracts().items():
    save_figure(f"layers-{name.replace('_', '-')}.svg", lambda n=name, r=layers: draw_layers(n, r))
