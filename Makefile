# Each target creates .venv on first use and installs again when pyproject.toml or
# constraints.txt change. `make help` lists the targets and variables.

.PHONY: help install verify test test-extended lint types scripts check check-code mutants census bench docs pdf atlas docs-check notebooks lite package-check versions-check release-check formal clean
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:

VENV := .venv
BIN := $(VENV)/bin
JOBS ?= 2
CORES ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
ARGS ?=

# The first interpreter that is new enough, runs, and can make an environment.
USABLE := import ensurepip, sys; sys.exit(sys.version_info < (3, 11))
FOUND = $(shell for p in python3.13 python3.12 python3.11 python3; do \
  if $$p -c '$(USABLE)' >/dev/null 2>&1; then echo $$p; break; fi; done)
PYTHON ?= $(FOUND)

help:
	@echo "make install         create .venv with the three commands and all that they need"
	@echo "make verify          check the claims of the paper; print the verdicts, write report/verdicts.html"
	@echo "make test            run the tests, doctests included"
	@echo "make test-extended   run the slow tests: thousands of random cases, every picture"
	@echo "make check           run all checks of a commit: lint, types, scripts, test, docs-check"
	@echo "make check-code      run those of them that depend on the version of Python"
	@echo "make lint            check style and format with ruff"
	@echo "make types           check types with mypy"
	@echo "make scripts         check the JavaScript of the interactive pages with tools from npm"
	@echo "make docs            build the documentation in docs/_build/html"
	@echo "make docs-check      build it and open every page in headless Chromium"
	@echo "make pdf             print its slides, exercise sheets and solutions as PDF, with Chromium"
	@echo "make notebooks       write the lessons as notebooks in docs/_build/notebooks and run each"
	@echo "make lite            add to it what runs lessons and gallery in a browser: docs/_build/html/lite"
	@echo "make atlas           write pages of 305 arrangements in docs/_build/atlas"
	@echo "make bench           measure speed; ARGS='--only targets' compares it with the targets"
	@echo "make mutants         run mutation tests; list the mutants that survive"
	@echo "make census          compute the lists of isomorphism classes again: ARGS='9 -o types9.npz'"
	@echo "make formal          compile the Coq proofs, extract the checker and compare it with Python"
	@echo "make package-check   build the packages and install them in empty environments"
	@echo "make release-check   check all that a release needs, the suite in the source archive too"
	@echo "make versions-check  run the tests with the lowest and the newest versions of the requirements"
	@echo "make clean           remove all that the targets made"
	@echo "PYTHON=python3.12 picks the interpreter, ARGS='-k faces' goes to pytest, JOBS=4 sets the"
	@echo "number of processes. BROWSER_TESTS=1, TEX_TESTS=1 and JAVASCRIPT_CHECKS=1 require"
	@echo "Chromium, pdflatex and npm; BROWSER_TESTS=0 and TEX_TESTS=0 skip what needs them."

$(BIN)/python:
	@python="$(PYTHON)"; \
	if [ -z "$$python" ]; then \
	  echo "error: no Python >= 3.11 with ensurepip found; install one, or run make PYTHON=/path/to/python" >&2; exit 1; fi; \
	if ! "$$python" -c '$(USABLE)' >/dev/null 2>&1; then \
	  echo "error: $$python does not run, is older than 3.11, or lacks ensurepip (Debian: python3-venv)" >&2; exit 1; fi; \
	echo "creating $(VENV) with $$("$$python" --version)"; \
	"$$python" -m venv --clear $(VENV)
	@$(PIP) uv || echo "uv cannot be installed: pip installs all" >&2

# With PYTHONDONTWRITEBYTECODE, set in many containers, every program that a test starts would
# compile its imports again.
unexport PYTHONDONTWRITEBYTECODE
# Compiling all modules takes most of pip's time; Python compiles each on first import instead.
PIP = $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --constraint constraints.txt
# uv takes a quarter of that time, but it does not read the indexes of pip's own configuration.
UV = $(BIN)/uv pip install --quiet --python $(BIN)/python --constraint constraints.txt
INSTALL = $(UV) --editable '.$(EXTRAS)' || $(PIP) --editable '.$(EXTRAS)'

$(VENV)/.stamp-run: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package"
	@$(INSTALL)
	@touch $@

$(VENV)/.stamp-install: EXTRAS = [all]
$(VENV)/.stamp-install: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package with its extras"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run

$(VENV)/.stamp-test: EXTRAS = [test]
$(VENV)/.stamp-test: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and its test tools"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run

$(VENV)/.stamp-docs: EXTRAS = [docs]
$(VENV)/.stamp-docs: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and its documentation tools"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run

$(VENV)/.stamp-lite: EXTRAS = [lite]
$(VENV)/.stamp-lite: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and JupyterLite"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run $(VENV)/.stamp-docs

$(VENV)/.stamp-check: EXTRAS = [test,lint,docs,package]
$(VENV)/.stamp-check: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and all of its development tools"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run $(VENV)/.stamp-test $(VENV)/.stamp-docs $(VENV)/.stamp-package $(VENV)/.stamp-install

$(VENV)/.stamp-package: EXTRAS = [package]
$(VENV)/.stamp-package: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and its build tools"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run

$(VENV)/.stamp-bench: EXTRAS = [bench,simulators]
$(VENV)/.stamp-bench: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the package and what the benchmarks compare it with"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run $(VENV)/.stamp-simulators

$(VENV)/.stamp-simulators: EXTRAS = [simulators]
$(VENV)/.stamp-simulators: pyproject.toml constraints.txt | $(BIN)/python
	@echo "installing the physics engines that read scenes"
	@$(INSTALL)
	@touch $@ $(VENV)/.stamp-run

install: $(VENV)/.stamp-install
	@echo "installed; now type:  . $(BIN)/activate"

verify: $(VENV)/.stamp-install
	@mkdir -p report
	$(BIN)/proofs-check run --jobs $(CORES) --output report/verdicts.html

test: $(VENV)/.stamp-test
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal $(ARGS)

test-extended: $(VENV)/.stamp-test $(VENV)/.stamp-simulators
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m slow -o testpaths=tests $(ARGS)

lint: $(VENV)/.stamp-check
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(VENV)/.stamp-check
	$(BIN)/mypy

scripts: $(VENV)/.stamp-test
	$(BIN)/python tests/javascript/check.py

check: check-code scripts docs-check

check-code: lint types
	SYMPY_GROUND_TYPES=python $(BIN)/python -m pytest -n $(JOBS) --dist worksteal $(ARGS)
	SYMPY_GROUND_TYPES=flint $(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m ground_types $(ARGS)

mutants: $(VENV)/.stamp-test
	$(BIN)/python tests/mutants.py --jobs $(JOBS) $(ARGS)

census: $(VENV)/.stamp-test
	$(BIN)/python -m tests.census $(ARGS)

bench: $(VENV)/.stamp-bench
	$(BIN)/python tests/benchmarks/run.py $(ARGS)

docs: $(VENV)/.stamp-docs
	$(BIN)/python -m sphinx -q -W --keep-going -b html -d docs/_build/trees docs docs/_build/html
	@echo "docs/_build/html/index.html"

pdf: docs
	$(BIN)/python docs/handouts/pdf.py docs/_build/html

atlas: $(VENV)/.stamp-install
	$(BIN)/python docs/atlas/atlas.py docs/_build/atlas --jobs $(JOBS) $(ARGS)

docs-check: docs $(VENV)/.stamp-test
	$(BIN)/python -m pytest -q -m slow tests/test_handouts.py
	$(BIN)/python tests/check_site.py docs/_build/html

notebooks: docs
	$(BIN)/python docs/notebooks.py docs/_build/notebooks

lite: docs $(VENV)/.stamp-lite
	$(BIN)/python docs/lite.py docs/_build/html

package-check: $(VENV)/.stamp-package
	$(BIN)/python tests/check_package.py $(ARGS)

versions-check: $(VENV)/.stamp-package
	$(BIN)/python tests/check_versions.py $(ARGS)

release-check: $(VENV)/.stamp-package
	$(BIN)/python tests/check_package.py --release --archive $(ARGS)
	$(MAKE) versions-check

formal: $(VENV)/.stamp-test
	bash proofs_check/formal/build.sh
	$(BIN)/python tests/formal_agreement.py proofs_check/formal/_build/proved-checker $(ARGS)
	@cp proofs_check/formal/_build/proved-checker $(BIN)/proved-checker
	$(BIN)/python -m pytest -q tests/arrangement/test_proved.py tests/arrangement/test_proved_coordinates.py tests/equilibrium/test_proved_checker.py tests/proofs_check/test_formal.py
	@echo "$(BIN)/proved-checker"

clean:
	rm -rf $(VENV) build dist report proofs_check/formal/_build docs/_build docs/_generated docs/api/names .hypothesis .mypy_cache .pytest_cache .ruff_cache .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
