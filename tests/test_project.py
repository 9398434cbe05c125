"""What must stay true of the project as a whole."""

import importlib
import importlib.metadata
import json
import pydoc
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import arrangement
from proofs_check import slipstates
from proofs_check.claims import registry
from proofs_check.reports.text import summary
from tests import mutant_targets

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("arrangement", "equilibrium", "proofs_check")
SLOW = ("dask", "igraph", "joblib", "matplotlib", "networkx", "numpy", "scipy", "sympy", "trimesh")


@pytest.mark.parametrize("package", PACKAGES)
def test_every_exported_name_loads(package):
    module = importlib.import_module(package)
    names = [*dir(module)]
    assert [name for name in names if getattr(module, name, None) is None] == []
    assert [name for name in names if name not in (module.__doc__ or "")] == []
    assert len(pydoc.render_doc(module).splitlines()) <= 80


@pytest.mark.parametrize("package", PACKAGES)
def test_star_import_gives_the_public_names(package):
    module, names = importlib.import_module(package), dict[str, object]()
    exec(f"from {package} import *", names)  # noqa: S102
    assert names.items() >= {name: getattr(module, name) for name in dir(module)}.items()


def test_name_of_the_distribution_says_where_things_are():
    assert slipstates.arrangement is arrangement
    for name, package in (("Arrangement", "arrangement"), ("Grasp", "equilibrium")):
        with pytest.raises(AttributeError, match=f"from {package} import {name}"):
            getattr(slipstates, name)
        with pytest.raises(ImportError, match=f"from {package} import {name}"):
            exec(f"from {slipstates.__name__} import {name}")  # noqa: S102
    with pytest.raises(AttributeError, match="says where things are"):
        slipstates.nothing  # noqa: B018
    # Where the package is installed, it is the module `slipstates`.
    included = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]
    (source,) = included["targets"]["wheel"]["force-include"]
    assert (ROOT / source).samefile(slipstates.__file__)


@pytest.mark.parametrize("package", PACKAGES)
def test_every_package_says_that_it_is_typed(package):
    assert (ROOT / package / "py.typed").is_file()


@pytest.mark.parametrize("package", PACKAGES)
def test_help_and_version_need_no_slow_import(package):
    program = f"""
import sys
sys.argv[0] = {package!r}
from {package}.cli import main
try:
    main()
except SystemExit:
    pass
print("loaded:", *sorted(set({SLOW!r}) & set(sys.modules)))
"""
    deeper = ["count --help"] if package == "arrangement" else []
    for words in ["--help", "--version", *deeper]:
        result = subprocess.run(
            [sys.executable, "-c", program, *words.split()],
            capture_output=True,
            text=True,
            check=True,
        )
        assert result.stdout.splitlines()[-1].split() == ["loaded:"], result.stdout


def test_the_version_is_the_same_everywhere():
    version = arrangement.__version__
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert importlib.metadata.version("slipstates") == version
    recipe = (ROOT / ".github" / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    assert re.findall(r"^version: (.*)$", citation, re.MULTILINE) == [version]
    assert re.findall(r'^  version: "(.*)"$', recipe, re.MULTILINE) == [version]
    assert f"## [{version}]" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_citation_archive_and_recipe_agree_with_the_project():
    with (ROOT / "pyproject.toml").open("rb") as stream:
        project = tomllib.load(stream)["project"]
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    archive = json.loads((ROOT / ".zenodo.json").read_text(encoding="utf-8"))
    recipe = (ROOT / ".github" / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    assert archive["license"] == project["license"]
    assert archive["title"] == project["name"]
    assert [one["name"] for one in archive["creators"]] == [a["name"] for a in project["authors"]]
    assert archive["description"].rstrip(".") == project["description"]
    home = project["urls"]["Repository"]
    assert f"repository-code: {home}\n" in citation
    assert f"homepage: {home}\n" in recipe
    needed = re.search(r"\n  run:\n    - python .*\n((?:    - .*\n)+)", recipe)[1]
    assert re.findall(r"- (\S+) (\S+)", needed) == [
        (name, f">{rest}")
        for entry in project["dependencies"]
        for name, _, rest in [entry.partition(">")]
    ]
    for name, place in project["scripts"].items():
        assert f"- {name} = {place}\n" in recipe


def test_every_command_of_the_project_resolves():
    points = importlib.metadata.entry_points(group="console_scripts")
    own = [point for point in points if point.module.split(".")[0] in PACKAGES]
    assert len(own) == 3
    for point in own:
        point.load()


def test_built_in_names_need_no_installation(tmp_path):
    for package in PACKAGES:
        (tmp_path / package).symlink_to(ROOT / package)
    program = (
        "import importlib.metadata as m, sys; m.distribution = m.entry_points = None\n"
        "import arrangement.cli; sys.exit(arrangement.cli.main(['count', 'paper-four-contacts']))"
    )
    run = [sys.executable, "-c", program]
    ended = subprocess.run(run, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert ended.returncode == 0, ended.stderr
    assert "distinct planes  2" in ended.stdout


def test_every_cited_work_is_in_the_bibliography():
    key = re.compile(r"\[([A-Z][A-Za-z]+[12]\d{3}[a-z]?)\]")
    listed = set(key.findall((ROOT / "docs" / "bibliography.rst").read_text(encoding="utf-8")))
    assert "HaasHeger2018" in listed
    cited = {
        found: path
        for package in PACKAGES
        for path in (ROOT / package).rglob("*.py")
        for found in key.findall(path.read_text(encoding="utf-8"))
    }
    assert {found: path for found, path in cited.items() if found not in listed} == {}


def test_each_deciding_module_has_mutants_or_a_reason():
    modules = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts)
        for package in mutant_targets.DECIDING
        for path in (ROOT / package.replace(".", "/")).rglob("*.py")
        if path.name != "__init__.py"
    }
    targets = {target.module for target in mutant_targets.TARGETS.values()}
    exceptions = set(mutant_targets.EXCEPTIONS)
    assert modules - targets - exceptions == set()
    assert exceptions - modules == exceptions & targets == set()


def test_mutants_name_tests_and_targets_that_exist():
    for target in mutant_targets.TARGETS.values():
        assert target.path.is_file()
        for name in target.tests:
            file, *path = name.split("::")
            words = (ROOT / file).read_text(encoding="utf-8")
            assert all(re.search(rf"(def|class) {word}\b", words) for word in path), name


#: On pages for developers: what a build makes, and patterns of names.
_MADE = (".venv/bin", "docs/_generated", "docs/figures/NAME.py")
_ENDINGS = r"\.(css|csv|html|js|json|md|ml|mjs|py|pyi|rst|svg|toml|txt|v)$"


def paths_named(text: str) -> set[str]:
    """Return what stands between backticks, or is linked to, and has the form of a path."""
    quoted = re.findall(r"(?<!:doc:)`{1,2}([^`\s]+)`{1,2}|\]\(([^)\s]+)\)", text)
    words = ((word or link).partition("::")[0] for word, link in quoted)
    return {
        word
        for word in words
        if re.fullmatch(r"[\w./-]+", word) and ("/" in word or re.search(_ENDINGS, word))
    }


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md", "docs/architecture.rst"])
def test_every_path_on_a_page_for_developers_exists(page):
    folders = (ROOT / name for name in (".github", *PACKAGES, "docs", "tests"))
    known = [
        f"/{path.relative_to(ROOT).as_posix()}" for folder in folders for path in folder.rglob("*")
    ]
    known += [f"/{path.name}" for path in ROOT.iterdir()]
    named = paths_named((ROOT / page).read_text(encoding="utf-8")) - {*_MADE}
    ends = {name: f"/{name.strip('/')}" for name in named}
    assert named
    assert [n for n, end in ends.items() if not any(x.endswith(end) for x in known)] == []


def test_a_path_that_is_not_there_is_found():
    text = "a file in `equilibrium/methods/contact_laws/`, [why](docs/gone.rst), `x` and ``a.py``"
    assert paths_named(text) == {"equilibrium/methods/contact_laws/", "docs/gone.rst", "a.py"}


def test_readme_is_true():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    pictures = re.findall(r'(?:src|srcset)="([^"]+)"', text)
    assert len(pictures) == 4  # light and dark, wide and narrow
    assert all((ROOT / picture).is_file() for picture in pictures)
    results = []
    for claim in (claim for claim in registry() if not claim.large):
        verdict = claim.expected.value
        added = ["one"] if "under a hypothesis" in verdict else []
        results.append({"verdict": verdict, "added_hypotheses": added, "as_expected": True})
        results[-1]["evidence_kind"] = claim.kind.value
    printed = summary(results)
    assert printed in text
    counts = re.findall(r"\d+", re.sub(r" \([^)]*\)", "", printed))
    opening = " ".join(text.partition("<picture>")[0].split())
    claims, proved, complete, sampled, refuted = counts
    others = str(int(claims) - int(refuted))
    assert re.findall(r"\d+", opening)[:6] == [claims, refuted, others, proved, complete, sampled]
    assert sum(len(result["added_hypotheses"]) for result in results) == 9
    assert "nine of them need an added hypothesis" in opening


def test_files_of_an_hours_reading_are_short():
    """The path that opens the page on architecture: who lengthens a file of it divides it."""
    page = (ROOT / "docs" / "architecture.rst").read_text(encoding="utf-8")
    path = page.partition("An hour's reading")[2].partition("The packages\n")[0]
    files = re.findall(r"^   \* - ``(\S+\.py)``$", path, re.MULTILINE)
    assert len(files) == 12
    for file in files:
        text = (ROOT / file).read_text(encoding="utf-8")
        assert len(text.splitlines()) < 300, file
        assert text.startswith('"""'), file
    for name in re.findall(r"``(\w+)``", path):
        known = [ROOT / file for file in files] + list(ROOT.glob("proofs_check/formal/*/*.v"))
        assert any(re.search(rf"\b{name}\b", one.read_text(encoding="utf-8")) for one in known), (
            name
        )
