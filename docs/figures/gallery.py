"""Every picture of the gallery, made by the very command that its page shows beside it.

Of a picture in SVG that the page offers as TikZ too, the command makes this as well, and where
pdflatex is installed it is set.
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


def set_in_latex(source: Path) -> None:
    """Write NAME-tikz.png: what pdflatex makes of NAME.tex, or a word that it is missing."""
    name, target = source.stem, f"{source.stem}-tikz"
    if shutil.which("pdflatex") and shutil.which("pdftoppm"):
        for words in (
            ["pdflatex", "-interaction=batchmode", "-halt-on-error", source.name],
            ["pdftoppm", "-png", "-r", "150", "-singlefile", f"{name}.pdf", target],
        ):
            subprocess.run(words, check=True, capture_output=True)
        for suffix in (".pdf", ".aux", ".log"):
            Path(name + suffix).unlink()
        return
    figure = plt.figure(figsize=(4, 0.6))
    figure.text(
        0.5, 0.5, f"pdflatex {source.name}\n(LaTeX is not installed here)", ha="center", va="center"
    )
    figure.savefig(f"{target}.png")
    plt.close(figure)


for command in re.findall(r"^ *\$ (\w+ (?:make|draw|lab) (?:.*\\\n)*.*)$", TEXT, re.MULTILINE):
    name, *words = shlex.split(command.replace("\\\n", " "))
    made = words[-1]
    for path in (made, *{made.replace(".svg", ".tex")} - {made}):
        if path in TEXT and MAIN[name]([*words[:-1], path]):
            raise RuntimeError(f"the gallery shows a command that fails: {command}")
        if path in TEXT and path.endswith(".tex"):
            set_in_latex(Path(path))
