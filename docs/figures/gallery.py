"""Every picture of the gallery, made by the very command that its page shows beside it.

Of a picture in SVG that the page offers as TikZ too, the command makes this as well, and where
pdflatex is installed it is set: all are pages of one document. The first picture of a page is drawn
without a legend, too, as its thumbnail.
"""

import re
import shlex
import shutil
import subprocess
from pathlib import Path

import arrangement.cli
import equilibrium.cli

MAIN = {"arrangement": arrangement.cli.main, "equilibrium": equilibrium.cli.main}
PAGES = sorted((Path(__file__).parents[1] / "gallery").glob("*.rst"))
#: The width and height of its paper, and what a file in TikZ draws.
TIKZ = re.compile(
    r"paperwidth=([\d.]+bp),paperheight=([\d.]+bp).*?"
    r"\\begin\{document\}\n(.*)\\end\{document\}",
    re.DOTALL,
)


def set_in_latex(sources: list[Path]) -> None:
    """Write NAME-tikz.png, what pdflatex makes of NAME.tex."""
    lines = [
        r"\RequirePackage{fix-cm}\documentclass{article}",
        r"\usepackage[paperwidth=100cm,paperheight=100cm,margin=0bp]{geometry}",
        r"\usepackage{tikz,amssymb}\setlength{\parindent}{0pt}\pagestyle{empty}",
        r"\begin{document}",
    ]
    for source in sources:
        width, height, body = TIKZ.search(source.read_text(encoding="utf-8")).groups()
        lines.append(rf"\pdfpagewidth={width}\pdfpageheight={height}")
        lines.append(body + r"\newpage")
    document = Path("gallery-all.tex")
    document.write_text("\n".join([*lines, r"\end{document}"]), encoding="utf-8")
    for words in (
        ["pdflatex", "-interaction=batchmode", "-halt-on-error", document.name],
        ["pdftoppm", "-png", "-r", "150", "gallery-all.pdf", "gallery-all"],
    ):
        subprocess.run(words, check=True, capture_output=True)
    pages = sorted(Path().glob("gallery-all-*.png"))
    for source, page in zip(sources, pages, strict=True):
        page.replace(f"{source.stem}-tikz.png")
    for suffix in (".tex", ".pdf", ".aux", ".log"):
        document.with_suffix(suffix).unlink()


def draw(words: list[str]) -> None:
    """Run a command, or end the build."""
    name, *rest = words
    if MAIN[name](rest):
        raise RuntimeError(f"the gallery shows a command that fails: {shlex.join(words)}")


def draw_page(page: Path) -> list[Path]:
    """Make what the commands of a page make; return the files in TikZ."""
    text = page.read_text(encoding="utf-8")
    offered, first = [], True
    for command in re.findall(r"^ *\$ (\w+ (?:make|draw|lab) (?:.*\\\n)*.*)$", text, re.MULTILINE):
        *words, made = shlex.split(command.replace("\\\n", " "))
        draw([*words, made])
        name, suffix = made.rsplit(".", 1)
        if suffix == "svg" and f".. tikz:: {name}\n" in text:
            draw([*words, f"{name}.tex"])
            offered.append(Path(f"{name}.tex"))
        if first and words[1] == "draw" and suffix == "svg":
            draw([*words, f"gallery-thumbnail-{page.stem}.svg", "--legend", "none"])
            first = False
    return offered


drawn = [path for page in PAGES for path in draw_page(page)]
if shutil.which("pdflatex") and shutil.which("pdftoppm"):
    set_in_latex(drawn)
