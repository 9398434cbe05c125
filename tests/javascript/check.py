"""Types and lint of the scripts of the pages: ``tsc --checkJs`` and eslint, from npm.

A page is one script: modules one after another. Types are checked file by file, all of a page
together; lint reads the whole, so that it knows every name, and its lines are reported by file.
Run from the top of the repository. Without npm it says so, and demands nothing; with
``JAVASCRIPT_CHECKS=1`` that is an error.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from arrangement.drawing.pages import BASE_SCRIPT, SOLID_SCRIPTS, Template, place
from arrangement.pictures.lab import arrangement_page as arrangement, lines
from arrangement.pictures.lab.page import SHARED
from equilibrium.pictures.lab import page as slip
from equilibrium.pictures.proof import SCRIPTS as PROOF

HERE = Path(__file__).parent
#: The modules of each page, in their order.
PAGES: dict[str, Sequence[Template]] = {
    "slip lab": [*slip.DECIDES, BASE_SCRIPT, *SHARED, *slip.SCRIPTS],
    "arrangement": arrangement.SCRIPTS,
    "solids": SOLID_SCRIPTS,
    "proof": PROOF,
    "arrangement lab": [BASE_SCRIPT, *SHARED, *lines.SCRIPTS],
}
OPTIONS = {
    "allowJs": True,
    "checkJs": True,
    "noEmit": True,
    "types": [],
    "target": "ESNext",
    "lib": ["ESNext", "DOM", "DOM.Iterable"],
    "strict": False,
}


def paths(templates: Iterable[Template]) -> list[Path]:
    """Return the files of templates."""
    return [place(template) for template in templates]


def node() -> bool:
    """Return whether there is a node that knows what the scripts use (20 or newer)."""
    program = shutil.which("node")
    if program is None:
        return False
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    return int(version.strip().lstrip("v").partition(".")[0] or 0) >= 20


def installed() -> bool:
    """Install what package-lock.json pins; return False where node or npm is missing."""
    if shutil.which("npm") is None or not node():
        return False
    lock, stamp = HERE / "package-lock.json", HERE / "node_modules" / ".package-lock.json"
    if not stamp.exists() or stamp.stat().st_mtime < lock.stat().st_mtime:
        subprocess.run(["npm", "ci", "--silent", "--no-audit", "--no-fund"], cwd=HERE, check=True)
        stamp.touch()
    return True


def types(modules: list[Path], folder: Path) -> list[str]:
    """Return what tsc says of the modules of a page."""
    config = folder / "tsconfig.json"
    config.write_text(json.dumps({"compilerOptions": OPTIONS, "files": list(map(str, modules))}))
    command = [HERE / "node_modules/.bin/tsc", "-p", config, "--pretty", "false"]
    done = subprocess.run(command, capture_output=True, text=True)
    return (done.stdout + done.stderr).splitlines() if done.returncode else []


def lint(modules: list[Path], folder: Path) -> list[str]:
    """Return what eslint says of a page, by file and line."""
    lines = ['"use strict";', "(() => {"]
    places: list[str] = ["start"] * len(lines)
    for module in modules:
        for number, line in enumerate(module.read_text(encoding="utf-8").splitlines(), 1):
            lines.append(line)
            places.append(f"{os.path.relpath(module)}:{number}")
    bundle = folder / "page.js"
    bundle.write_text("\n".join([*lines, "})();\n"]))
    config = HERE / "eslint.config.mjs"
    command = [HERE / "node_modules/.bin/eslint", "--config", config, "--format", "json", bundle]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    if done.returncode > 1 or not done.stdout:
        return done.stderr.splitlines()
    found: list[dict[str, Any]] = json.loads(done.stdout)[0]["messages"]
    places.append("end")
    return [f"{places[m['line'] - 1]}: {m['message']} ({m['ruleId']})" for m in found]


def main() -> int:
    """Check all pages; return 1 if something was found."""
    if not installed():
        text = "the scripts of the pages are not checked: node 20 or npm is missing"
        print(text, file=sys.stderr)
        return int(os.environ.get("JAVASCRIPT_CHECKS") == "1")
    found: dict[str, list[str]] = {}
    for name, templates in PAGES.items():
        with tempfile.TemporaryDirectory() as folder:
            modules, place = paths(templates), Path(folder)
            found[name] = types(modules, place) + lint(modules, place)
    real = dict.fromkeys(
        text for told in found.values() for text in told if not shared(text, found)
    )
    for text in real:
        print(text)
    print(f"{len(PAGES)} pages, {len(real)} problems")
    return int(bool(real))


def shared(text: str, found: dict[str, list[str]]) -> bool:
    """Return whether a name that one page does not use is used on another page."""
    holders = [
        name
        for name, templates in PAGES.items()
        if Path(text.partition(":")[0]).resolve() in paths(templates)
    ]
    return "no-unused-vars" in text and not all(text in found[name] for name in holders)


if __name__ == "__main__":
    sys.exit(main())
