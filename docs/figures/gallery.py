"""Every picture of the gallery, made by the very command that its page shows beside it.

Of a picture in SVG that the page offers as TikZ too, the command makes this as well, and where
pdflatex is installed it is set: all are pages of one document.
"""

import re
import shlex
import shutil
import subprocess
from pathlib import Path

import matplotlib.pyplot as plt

import arrangement.cli
import equilibrium.cli

MAIN = {"arrangement": arrangement.cli.main, "equilibrium": equilibrium.cli.main}
PAGES = sorted((Path(__file__).parents[1] / "gallery").glob("*.rst"))
TEXT = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
#: The width and height of its paper, and what a file in TikZ draws.
TIKZ = re.compile(
    r"paperwidth=([\d.]+bp),paperheight=([\d.]+bp).*?"
    r"\\begin\{document\}\n(.*)\\end\{document\}",
    re.DOTALL,
)


def set_in_latex(sources: list[Path]) -> None:
    """Write NAME-tikz.png: what pdflatex makes of NAME.tex, or a word that it is missing."""
    if not (shutil.which("pdflatex") and shutil.which("pdftoppm")):
        for source in sources:
            figure = plt.figure(figsize=(4, 0.6))
            words = f"pdflatex {source.name}\n(LaTeX is not installed here)"
            figure.text(0.5, 0.5, words, ha="center", va="center")
            figure.savefig(f"{source.stem}-tikz.png")
            plt.close(figure)
        return
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


drawn = []
for command in re.findall(r"^ *\$ (\w+ (?:make|draw|lab) (?:.*\\\n)*.*)$", TEXT, re.MULTILINE):
    name, *words = shlex.split(command.replace("\\\n", " "))
    made = words[-1]
    for path in (made, *{made.replace(".svg", ".tex")} - {made}):
        if path in TEXT and MAIN[name]([*words[:-1], path]):
            raise RuntimeError(f"the gallery shows a command that fails: {command}")
        if path in TEXT and path.endswith(".tex"):
            drawn.append(Path(path))
set_in_latex(drawn)
