"""A scene as TikZ: points, paths and items.

One unit of the picture is a printer's point. The styles ``/slipstates/circle`` and so on stand at
the top, one for each role (`scene.ROLES`) that occurs, with what most items of the role have; an
item says only what is its own. Neighbours on the sheet with one role are a scope. Labels are LaTeX:
signs, numbers, vectors and Greek letters are maths, words are text.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from itertools import groupby
from textwrap import fill
from typing import Any, TypeAlias
from unicodedata import normalize

import numpy as np

from arrangement.drawing.scene import (
    LIGHT,
    SHADES,
    Ball,
    Box,
    Floats,
    Item,
    Label,
    Mark,
    Path,
    Place,
    Scene,
)
from arrangement.drawing.themes import rgba

_GREEK = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho"
#: Signs with the commands for them.
_COMMANDS = (
    "\u2248approx \u00d7times \u00b7cdot \u2264le \u2265ge \u2208in \u221einfty \u2192to \u00b1pm "
    "\u2260ne \u25cfbullet \u25cbcirc \u2205emptyset \u03a3Sigma \u0394Delta \u03a6Phi \u03c3sigma "
    "\u03c4tau \u03c5upsilon \u03c6varphi \u03c7chi \u03c8psi \u03c9omega"
)
#: Signs as mathematics.
SIGNS = {
    **{sign: sign for sign in "+=<>/"},
    "\u2212": "-",
    "\u00b0": r"^\circ ",
    "\u211d": r"\mathbb{R}",
    **{word[0]: f"\\{word[1:]} " for word in _COMMANDS.split()},
    **{chr(0x3B1 + k): f"\\{name} " for k, name in enumerate(_GREEK.split())},
}
_RAISED = {sign: str(k) for k, sign in enumerate("\u2070\u00b9\u00b2\u00b3")}
_RAISED |= {chr(0x2070 + k): str(k) for k in range(4, 10)} | {"\u207b": "-"}
_LOWERED = {chr(0x2080 + k): str(k) for k in range(10)}
_TEXT = {
    **{sign: f"\\{sign}" for sign in "{}#$%&_"},
    "\\": r"\textbackslash{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "\u2013": "--",
    "\u2014": "---",
    "\u2026": r"\dots{}",
    "\u2019": "'",
    "\u200a": r"\kern.06em ",
    "\u2007": r"\phantom{0}",
}
_ACCENTS = {
    **{chr(0x300 + k): f"\\{sign}" for k, sign in enumerate("`'^~=")},
    **{chr(0x306 + k): f"\\{sign}" for k, sign in enumerate(("u ", ".", '"'))},
    **{chr(0x30A + k): f"\\{sign} " for k, sign in enumerate("rHv")},
    "\u0327": r"\c ",
}
_SIGNS = {"+": "{+}", "\u2212": "{-}", "0": "{0}", "\u25cf": r"{\bullet}", "\u25cb": r"{\circ}"}

#: After these a minus is one of a number anyway.
_BEFORE_MINUS = set("(,=<>/+\u2248\u2264\u2265\u00d7\u00b7")
_TOKEN = re.compile(
    r"(?P<given>\$[^$]*\$)"
    r"|(?P<norm>\bL(?:\d|\u221e))"
    r"|(?P<indexed>(?<!\w)[A-Za-z]_[A-Za-z0-9](?!\w))"
    r"|(?P<power>\d+\^\d+|[\d.]+e[+-]?\d+)"
    r"|(?P<signs>[+\u22120\u25cf\u25cb](?:\u200a[+\u22120\u25cf\u25cb])+)"
    r"|(?P<number>\d+(?:\.\d+)?)"
    rf"|(?P<maths>[{re.escape(''.join(SIGNS))}]|[{''.join(_RAISED)}]+|[{''.join(_LOWERED)}]+)"
    r"|(?P<variable>(?<![\w(])[cfmnrtwxyz](?![A-Za-z0-9_)]))"
    r"|(?P<soft>[\s,()\u200a]|(?<!\w)[a-z](?!\w))"
    r"|(?P<word>[A-Za-z\u00c0-\u024f]+)"
    r"|(?P<other>.)",
    re.DOTALL,
)


def tex_text(text: str) -> str:
    r"""Return a label, of one or several lines, as LaTeX.

    >>> print(tex_text("w = (0, −1/2, x)"), tex_text("100 % of ℝ³"), tex_text("+\u200a−"))
    $w=(0,-1/2,x)$ 100 \% of $\mathbb{R}^{3}$ ${+}{-}$
    """
    return r" \\ ".join(map(_line, text.split("\n")))


def _line(line: str) -> str:
    bare = line.replace("\u200a", "")
    if bare and set(bare) <= set(_SIGNS) and bare != "0":
        return "$" + "".join(_SIGNS[sign] for sign in bare) + "$"
    tokens = [(str(match.lastgroup), match.group()) for match in _TOKEN.finditer(line)]
    wordless = all(kind != "word" for kind, _ in tokens)
    depth, kinds = 0, []
    for kind, text in tokens:
        depth += (text == "(") - (text == ")")
        apart = text == "," and not depth and not wordless
        kinds.append("other" if apart else kind)
    tokens = [(kind, text) for kind, (_, text) in zip(kinds, tokens, strict=True)]
    runs = groupby(tokens, key=lambda token: token[0] in ("word", "other", "given"))
    parts = [(is_text, list(run)) for is_text, run in runs]
    return "".join(_words(run) if is_text else _mix(run, wordless) for is_text, run in parts)


def _mix(tokens: list[tuple[str, str]], wordless: bool) -> str:
    """Return tokens without words: maths if one of them says so, but for what is around it."""
    hard = {"norm", "indexed", "power", "signs", "maths", "variable"} | (
        {"number"} if wordless else set()
    )
    if not any(kind in hard for kind, _ in tokens):
        return _words(tokens)
    start, stop = 0, len(tokens)
    while tokens[start][1].isspace() or tokens[start][1] in ",)":
        start += 1
    while tokens[stop - 1][1].isspace() or tokens[stop - 1][1] in ",(":
        stop -= 1
    inside = "".join(text for _, text in tokens[start:stop])
    if inside.count("(") != inside.count(")"):
        # A parenthesis of the sentence: maths begins or ends there.
        cut = inside.rfind("(") if inside.count("(") > inside.count(")") else inside.find(")")
        k = next(k for k in range(start, stop) if sum(len(t) for _, t in tokens[start:k]) == cut)
        return _mix(tokens[:k], wordless) + tokens[k][1] + _mix(tokens[k + 1 :], wordless)
    before, after = _words(tokens[:start]), _words(tokens[stop:])
    return f"{before}${_maths(tokens[start:stop])}${after}"


def _maths(tokens: list[tuple[str, str]]) -> str:
    formula = ""
    for k, (kind, text) in enumerate(tokens):
        if kind == "norm":
            formula += f"L_{SIGNS.get(text[1:], text[1:]).strip()}"
        elif kind == "power":
            base, mark, power = text.partition("^") if "^" in text else text.partition("e")
            formula += (f"{base}\\cdot 10" if mark == "e" else base) + f"^{{{int(power)}}}"
        elif kind == "signs":
            formula += "".join(_SIGNS.get(sign, "") for sign in text)
        elif text[0] in _RAISED:
            formula += "^{" + "".join(_RAISED[x] for x in text) + "}"
        elif text[0] in _LOWERED:
            formula += "_{" + "".join(_LOWERED[x] for x in text) + "}"
        elif text.isspace():
            ends = (tokens[k - 1], tokens[k + 1])
            apart = all(kind in ("number", "variable", "power", "signs") for kind, _ in ends)
            formula += (r"\;" if ends[1][0] == "signs" else r"\,") if apart else ""
        elif text == "\u2212" and _begins_number(tokens, k):
            formula += r"\;{-}"
        elif text == "," and k + 1 < len(tokens) and not tokens[k + 1][1].isspace():
            formula += "{,}"
        else:
            formula += SIGNS.get(text, text)
    return formula.strip()


def _begins_number(tokens: list[tuple[str, str]], k: int) -> bool:
    """Return whether a minus after a space and a non-operator belongs to the number after."""
    if k < 2 or k + 1 == len(tokens) or not tokens[k - 1][1].isspace():
        return False
    return tokens[k + 1][0] == "number" and tokens[k - 2][1] not in _BEFORE_MINUS


def _words(tokens: list[tuple[str, str]]) -> str:
    return "".join(text if kind == "given" else escape_latex(text) for kind, text in tokens)


def escape_latex(text: str) -> str:
    r"""Return text that LaTeX prints as it is.

    >>> print(escape_latex("Möbius_1"))
    M\"{o}bius\_1
    """
    safe = ""
    for sign in text:
        letters = normalize("NFD", sign)
        if len(letters) == 2 and letters[1] in _ACCENTS:
            safe += f"{_ACCENTS[letters[1]]}{{{letters[0]}}}"
        else:
            safe += _TEXT.get(sign, sign)
    return safe


#: Lines a x + b y = (k + c / 2) d, for each sign (a, b), d in points and c; this many signs stand
#: this many times closer.
_LINES = {
    "/": [((1, -1), 24.0, 0)],
    "\\": [((1, 1), 24.0, 0)],
    "-": [((0, 1), 12.0, 1)],
    "|": [((1, 0), 12.0, 1)],
    "x": [((1, -1), 24.0, 0), ((1, 1), 24.0, 0)],
    "+": [((0, 1), 12.0, 1), ((1, 0), 12.0, 1)],
}
#: Radius of circles as a share of their distance.
_CIRCLES = {".": 0.1, "o": 0.2, "O": 0.35}
#: The width of its lines, in points.
WIDTH = 0.35


def _lines(hatch: str, low: Floats, high: Floats, top: float) -> Iterator[tuple[Floats, Floats]]:
    corners = np.array([low, (low[0], high[1]), (high[0], low[1]), high])
    middle, reach = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
    for normal, step, shift in _LINES[hatch[0]]:
        across, apart = np.array(normal), step / len(hatch)
        along = reach * np.array([-across[1], across[0]]) / np.linalg.norm(across)
        zero = top * across[1] + shift * apart / 2
        heights = (corners @ across - zero) / apart
        for k in range(math.ceil(heights.min()), math.floor(heights.max()) + 1):
            missing = zero + k * apart - float(middle @ across)
            foot = middle + missing * across / float(across @ across)
            yield foot - along, foot + along


def _circles(
    low: Floats, high: Floats, apart: float, share: float, top: float
) -> Iterator[tuple[Floats, float]]:
    """Yield circles in rows, in every other row half-way between those of its neighbours."""
    for row in range(math.floor((top - high[1]) / apart), math.ceil((top - low[1]) / apart) + 1):
        shift = (row % 2) / 2
        first, last = math.floor(low[0] / apart - shift), math.ceil(high[0] / apart - shift)
        for k in range(first, last + 1):
            yield np.array([(k + shift) * apart, top - row * apart]), share * apart


def outline(item: Path) -> str:
    """Return the path of a line or a shape."""
    if item.kind == "circle":
        return disc(item.points, item.radius)
    if item.kind == "curve":
        start, *rest = map(point, item.points)
        pieces = [start]
        for p, q, end in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
            straight = {p, q} <= {start, end}
            pieces.append(f"-- {end}" if straight else f".. controls {p} and {q} .. {end}")
            start = end
        return " ".join(pieces)
    return " -- ".join([*map(point, item.points), *["cycle"] * (item.kind == "polygon")])


def clip_path(clip: Box | tuple[Place, float]) -> str:
    """Return the box or disc to which an item is cut."""
    if len(clip) == 2:
        return disc(*clip)
    left, low, right, high = clip
    return f"{point((left, low))} rectangle {point((right, high))}"


def disc(centre: Place, radius: float) -> str:
    """Return a circle."""
    return f"{point(centre)} circle[radius={number(radius)}]"


def cut(shape: str) -> str:
    """Return the command that cuts what follows to a path."""
    return rf"\clip {shape};"


def point(place: Place) -> str:
    """Return a point of the picture."""
    return f"({number(place[0])},{number(place[1])})"


def number(value: float, digits: int = 2) -> str:
    """Return a number with few digits, and no negative zero."""
    return f"{round(float(value), digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")


#: Keys of TikZ and their values; an empty value for keys that stand alone.
Options: TypeAlias = dict[str, str]

#: What an item says when it lacks a key that its role has.
_NEUTRAL = {
    **{key: f"{key}=none" for key in ("fill", "draw", "align")},
    **{f"{kind}opacity": f"{kind}opacity=1" for kind in ("", "fill ", "draw ", "text ")},
    "dash pattern": "solid",
    "rounded corners": "sharp corners",
    "line cap": "line cap=butt",
    "line join": "line join=miter",
}
#: Text twice, first as a thick line in the colour of the halo; without it where TeX has no way.
_HALO = r"""\providecommand\slipstateshalo[3]{% width, colour, text
  \ifdefined\pdfliteral\rlap{\pdfliteral{2 Tr 1 j #1 w}\color{#2}#3\pdfliteral{0 Tr}}\fi#3}"""
#: Middle of a line of text above its base, in its size: of letters, of capitals.
_MIDDLES = {"center": 0.28, "center_baseline": 0.33, "top": 0.7, "bottom": -0.22, "baseline": 0.0}


@dataclass(frozen=True)
class _Written:
    """A path or a node: what it has of its own, what it is, and the commands that cut it."""

    item: Item
    options: Options
    body: str
    cuts: tuple[str, ...] = ()


def tikz(scene: Scene, *, fragment: bool = False) -> str:
    r"""Return a scene as TikZ.

    Args:
        fragment: the picture alone, for ``\input``, instead of a document that pdflatex compiles.
    """
    picture = _Writer(scene).picture()
    needs = [r"\usepackage{tikz}"]
    if r"\mathbb" in picture:
        needs.append(r"\usepackage{amssymb}")
    if fragment:
        return "% The preamble needs: " + " ".join(needs) + "\n" + picture
    paper = f"paperwidth={number(scene.width)}bp,paperheight={number(scene.height)}bp"
    return "\n".join(
        [
            r"\RequirePackage{fix-cm}",
            r"\documentclass{article}",
            rf"\usepackage[{paper},margin=0bp]{{geometry}}",
            *needs,
            r"\setlength{\parindent}{0pt}\pagestyle{empty}",
            r"\begin{document}",
            picture + r"\end{document}",
            "",
        ]
    )


class _Writer:
    """One picture: its items in the order of painting, its colours by number, its shadings."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.colours: dict[str, str] = {"000000": "black", "FFFFFF": "white"}
        self.shadings: list[str] = []
        items = sorted(scene.items, key=lambda item: item.height)
        self.written = [written for item in items for written in self._item(item)]
        self.styles = self._styles()

    def picture(self) -> str:
        """Return the environment."""
        scopes = list(self._scopes())
        width, height = number(self.scene.width), number(self.scene.height)
        layers = "/slipstates/layer/.style={every path/.style={/slipstates/#1}}"
        labels = "/slipstates/labels/.style={every node/.style={/slipstates/label}}"
        styles = [
            f"/slipstates/{role}/.style={{{_option_list(style)}}}"
            for role, style in self.styles.items()
        ]
        colours = [
            rf"\definecolor{{{name}}}{{HTML}}{{{code}}}"
            for code, name in self.colours.items()
            if name not in ("black", "white")
        ]
        body = "\n".join(scopes)
        return "\n".join(
            [
                *self.shadings,
                r"\begin{tikzpicture}[",
                "  x=1bp, y=1bp,",
                *(f"  {style}," for style in [layers, labels, *styles]),
                "]",
                *colours,
                *[_HALO] * (r"\slipstateshalo" in body),
                rf"\path[use as bounding box] (0,0) rectangle ({width},{height});",
                body,
                r"\end{tikzpicture}",
                "",
            ]
        )

    def _styles(self) -> dict[str, Options]:
        """Return for each role the options that most of its items have."""
        styles: dict[str, Counter[tuple[tuple[str, str], ...]]] = {}
        for written in self.written:
            # A rotation cannot be taken back.
            shared = tuple((key, x) for key, x in written.options.items() if key != "rotate")
            styles.setdefault(written.item.role, Counter())[shared] += 1
        return {role: dict(counts.most_common(1)[0][0]) for role, counts in sorted(styles.items())}

    def _scopes(self) -> Iterator[str]:
        """Yield the scopes of neighbours with one role and one clip."""
        for (role, cuts), group in groupby(self.written, key=lambda w: (w.item.role, w.cuts)):
            layer = "labels" if role == "label" else f"layer={role}"
            lines = [rf"\begin{{scope}}[/slipstates/{layer}]"]
            for written in group:
                command = r"\node" if written.body.startswith("at ") else r"\path"
                own = _option_list(written.options, self.styles[role])
                text = f"{command}{f'[{own}]' if own else ''} {written.body};"
                lines.append(fill(text, 98, subsequent_indent="  ", **_UNBROKEN))
                lines[-1] += f" % {written.item.name}" if written.item.name else ""
            lines.append(r"\end{scope}")
            if cuts:
                lines = [r"\begin{scope}", *cuts, *lines, r"\end{scope}"]
            yield "\n".join(lines)

    def _item(self, item: Item) -> Iterator[_Written]:
        if isinstance(item, Label):
            yield _Written(item, *self._label(item))
            return
        cuts = () if item.clip is None else (cut(clip_path(item.clip)),)
        if isinstance(item, Mark):
            yield _Written(item, *self._mark(item), cuts)
        elif isinstance(item, Ball):
            yield self._ball(item)
        elif isinstance(item, Path):
            body = outline(item)
            yield _Written(item, self._path_options(item.style, item.kind != "line"), body, cuts)
            if hatch := item.style.get("hatch"):
                options, lines = self._hatching(item, hatch)
                yield _Written(item, options, lines, (*cuts, cut(body)))

    def _hatching(self, item: Path, hatch: str) -> tuple[Options, str]:
        """Return lines across the box of a shape, in the colour of its edge."""
        extent = np.full(2, item.radius)
        corners = np.atleast_2d(item.points)
        low, high = corners.min(axis=0) - extent, corners.max(axis=0) + extent
        top = self.scene.height  # hatching is counted from the left upper corner of the sheet
        if share := _CIRCLES.get(hatch[0]):
            circles = _circles(low, high, 12 / len(hatch), share, top)
            discs = [disc(*circle) for circle in circles]
        else:
            lines = _lines(hatch, low, high, top)
            discs = [f"{point(start)} -- {point(end)}" for start, end in lines]
        line = {"ec": item.style.get("ec", "black"), "lw": WIDTH}
        line |= {"fc": line["ec"]} if hatch[0] == "." else {}
        return self._path_options(line, filled=hatch[0] == "."), " ".join(discs)

    def _path_options(self, style: Mapping[str, Any], filled: bool) -> Options:
        filled = filled and style.get("fill", True)
        face = style.get("fc") if filled else None
        edge = style.get("ec", None if filled else "black")
        alpha = style.get("alpha")
        options: Options = {}
        self._colour(options, "fill", face, alpha)
        width = style.get("lw", 1.0)
        if width:
            self._colour(options, "draw", edge, alpha)
        if "draw" in options:
            self._line(options, style, width)
        return options

    def _line(self, options: Options, style: Mapping[str, Any], width: float) -> None:
        options["line width"] = f"{number(width)}bp"
        if isinstance(dashes := style.get("ls"), tuple):
            lengths = [number(x * width) for x in dashes[1]]
            options["dash pattern"] = " ".join(
                f"{'off' if k % 2 else 'on'} {x}bp" for k, x in enumerate(lengths)
            )
        ends = {"round": "round", "projecting": "rect"}.get(style.get("capstyle", ""))
        joint = style.get("joinstyle", "miter")
        options |= {"line cap": ends} if ends else {}
        options |= {"line join": joint} if joint != "miter" else {}

    def _mark(self, item: Mark) -> tuple[Options, str]:
        """Return a sign as matplotlib has it: its size is that without the line around it."""
        style, (x, y) = item.style, item.place
        half = item.size / 2
        edge = style.get("mec", style["color"])
        line = {"ec": edge, "lw": style.get("mew", 1.0), "alpha": style.get("alpha")}
        if item.sign == "o":
            line["fc"] = style["color"]
            return self._path_options(line, filled=True), disc(item.place, half)
        strokes = {"x": [(-1, -1, 1, 1), (-1, 1, 1, -1)], "_": [(-1, 0, 1, 0)]}[item.sign]
        body = " ".join(
            f"{point((x + half * a, y + half * b))} -- {point((x + half * c, y + half * d))}"
            for a, b, c, d in strokes
        )
        return self._path_options(line, filled=False), body

    def _ball(self, item: Ball) -> _Written:
        """Declare a shading a little larger than the ball, which cuts it smoothly."""
        near, far = (np.array(rgba(colour)) for colour in (item.near, item.far))
        name = self._shading(item, near[:3], far[:3])
        cuts, options = [cut(disc(item.centre, item.radius))], {"inner sep": "0pt"}
        if near[3] != far[3]:
            fading = self._shading(item, near[[3, 3, 3]], far[[3, 3, 3]])
            self.shadings.append(rf"\pgfdeclarefading{{{fading}}}{{\pgfuseshading{{{fading}}}}}")
            x, y = map(number, item.centre)
            shift = rf"\pgftransformshift{{\pgfpointxy{{{x}}}{{{y}}}}}"
            cuts.append(rf"\pgfsetfading{{{fading}}}{{{shift}}}")
        elif near[3] < 1:
            options["opacity"] = number(near[3], 3)
        body = rf"at {point(item.centre)} {{\pgfuseshading{{{name}}}}}"
        return _Written(item, options, body, tuple(cuts))

    def _shading(self, item: Ball, near: Floats, far: Floats) -> str:
        """Declare a radial shading from one colour to another; return its name.

        It is that of its content: two pictures in one document do not take each other's.
        """
        r, stops = item.radius, []
        for size, share in (*SHADES, (1.02, 1.0)):
            colour = ",".join(number(x, 3) for x in near + share * (far - near))
            stops.append(f"rgb({number(size * r)}bp)=({colour})")
        focus = "".join(f"{{{number(x * r)}bp}}" for x in LIGHT)
        content = rf"{{\pgfpoint{focus}}}{{{'; '.join(stops)}}}"
        name = f"slipstates-ball-{sha256(content.encode()).hexdigest()[:12]}"
        self.shadings.append(rf"\pgfdeclareradialshading{{{name}}}{content}")
        return name

    def _label(self, item: Label) -> tuple[Options, str]:
        style, size = item.style, item.size
        text, rows = tex_text(item.text), item.text.count("\n")
        # Small signs of Computer Modern are wider than ours.
        letters = size * min(1.0, 0.55 + 0.065 * size) if "}{-}" in text or "}{+}" in text else size
        font = rf"\fontsize{{{number(letters)}}}{{{number(size)}}}\selectfont"
        font += r"\bfseries\boldmath" if style.get("weight") == "bold" else ""
        font += r"\itshape" if style.get("style") == "italic" else ""
        options: Options = {"font": font}
        self._colour(options, "text", style.get("color", "black"), style.get("alpha"))
        along, down = item.ha, item.va
        turned = math.radians(item.rotation)
        if round(item.rotation) % 360 == 90:
            along, down = {"bottom": "left", "top": "right"}.get(item.va, "center"), "center"
        if style.get("style") == "italic":
            text = _NUMBER.sub(r"$\\mathit{\1}$", text)
        side = {"left": "west", "right": "east"}.get(along, "")
        drop = 0.0 if rows else _MIDDLES[down] * size
        if rows:
            options["align"] = style.get("multialignment", "center")
        options["anchor"] = side or "center" if rows else f"base {side}".strip()
        options["inner sep"] = "0pt"
        if item.rotation:
            options["rotate"] = number(item.rotation)
        self._plate(options, style.get("plate"), size)
        place = np.array(item.place) + drop * np.array([math.sin(turned), -math.cos(turned)])
        if style.get("halo"):
            width, colour = style["halo"]
            shade: Options = {}
            self._colour(shade, "halo", colour, None)
            rows_of = [
                rf"\slipstateshalo{{{number(width)}}}{{{shade['halo']}}}{{{row}}}"
                for row in text.split(r" \\ ")
            ]
            text = r" \\ ".join(rows_of)
        return options, f"at {point(place)} {{{text}}}"

    def _plate(self, options: Options, plate: Mapping[str, Any] | None, size: float) -> None:
        """Add a box behind the text, as the keys of matplotlib describe it."""
        if plate is None:
            return
        shape, *details = plate.get("boxstyle", "square").split(",")
        sizes = dict(detail.split("=") for detail in details)
        pad = float(sizes["pad"]) * size if "pad" in sizes else plate.get("pad", 0.3 * size)
        options["inner sep"] = f"{number(pad)}bp"
        self._colour(options, "fill", plate.get("fc"), plate.get("alpha"))
        if shape == "round":
            options["rounded corners"] = f"{number(float(sizes['rounding_size']) * size)}bp"

    def _colour(self, options: Options, key: str, colour: Any, alpha: float | None) -> None:
        """Add a colour under a key, and how much it covers; nothing for no colour."""
        if colour is None or (isinstance(colour, str) and colour == "none"):
            return
        red, green, blue, own = rgba(colour)
        code = "".join(f"{round(255 * x):02X}" for x in (red, green, blue))
        options[key] = self.colours.setdefault(code, f"slipstates{len(self.colours) - 1}")
        cover = own if alpha is None else alpha
        if cover < 1:
            options[f"{key} opacity" if alpha is None else "opacity"] = number(cover, 3)


_NUMBER = re.compile(r"\$([0-9{},]+)\$")
_UNBROKEN: dict[str, Any] = {"break_long_words": False, "break_on_hyphens": False}


def _option_list(options: Options, known: Options | None = None) -> str:
    """Return options as a list, without what is known, and against what is known too much."""
    known = known or {}
    stated = [f"{key}={value}" for key, value in options.items() if known.get(key) != value]
    unsaid = [_NEUTRAL[key] for key in known if key in _NEUTRAL and key not in options]
    return ", ".join([*unsaid, *stated])
