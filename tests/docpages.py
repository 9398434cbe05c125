"""The pages of the documentation as programs: their blocks of code, run from top to bottom.

A page may hold

* Python sessions (``>>>``), which share their names from the top of the page to its end;
* ``.. code-block:: console``: lines ``$ command`` with the output that a terminal shows;
* a code block or a literalinclude with a caption: a file of that name, for the blocks below it;
* ``.. code-block:: text``: diagrams, which are not code.

Everything on a page happens in one empty directory. In outputs, ``...`` stands for anything and
stretches of white space are equal.
"""

import contextlib
import doctest
import io
import re
import runpy
import shlex
import shutil
import socket
import subprocess
import sys
import textwrap
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import arrangement.cli
import equilibrium.cli
import proofs_check.cli

ROOT = Path(__file__).resolve().parent.parent
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
ENTRIES = {
    "arrangement": arrangement.cli.main,
    "equilibrium": equilibrium.cli.main,
    "proofs-check": proofs_check.cli.main,
}
_DIRECTIVE = re.compile(r"( *)\.\. (code-block|code|sourcecode|literalinclude):: *(\S*) *$")
_OPTION = re.compile(r" +:([\w-]+):(?: +(.*?))? *$")


_FENCED = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def _directive(fenced: re.Match[str]) -> str:
    """Return a console block of Markdown as one of reStructuredText, on the same lines."""
    return ".. code-block:: console\n" + textwrap.indent(fenced[1], "   ")


@dataclass(frozen=True)
class Block:
    """A block of code: its directive and argument, its first line, options and body."""

    directive: str
    argument: str
    line: int
    options: dict[str, str]
    body: str

    @property
    def caption(self) -> str | None:
        return self.options.get("caption")


def blocks(text: str) -> Iterator[Block]:
    """Yield the code blocks of a page, in order; of Markdown, the console blocks."""
    lines = _FENCED.sub(_directive, text).splitlines()
    for number, line in enumerate(lines):
        if not (found := _DIRECTIVE.match(line)):
            continue
        options, at = {}, number + 1
        while at < len(lines) and (option := _OPTION.match(lines[at])):
            options[option[1]] = option[2] or ""
            at += 1
        first, indent = at, len(found[1])
        while at < len(lines) and (
            not lines[at].strip() or len(lines[at]) - len(lines[at].lstrip()) > indent
        ):
            at += 1
        body = textwrap.dedent("\n".join(lines[first:at])).strip("\n") + "\n"
        yield Block(found[2], found[3], number + 1, options, body)


def with_free_port(text: str) -> str:
    """Return a page with a free port where it names one, so that two suites can run at once."""
    named = re.search(r"--port (\d+)", text)
    if not named:
        return text
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return text.replace(named[1], str(probe.getsockname()[1]))


def loose_literals(text: str) -> list[int]:
    """Return the lines that end with ``::``: literal blocks of no known language."""
    lines = enumerate(text.splitlines(), 1)
    return [n for n, line in lines if re.search(r"::\s*$", line) and ".. " not in line]


@dataclass
class Page:
    """A page that is being run in a directory; `problems` says where it differs."""

    source: Path
    text: str
    names: dict[str, Any] = field(default_factory=lambda: {"__name__": "__main__"})
    problems: list[str] = field(default_factory=list)
    code: int = 0
    background: list[subprocess.Popen[bytes]] = field(default_factory=list)

    def run(self) -> int:
        """Run sessions and blocks in the order of the page; return how many there were."""
        text = with_free_port(self.text)
        parts: list[tuple[int, Any]] = [
            (example.lineno, example)
            for example in doctest.DocTestParser().get_examples(text, str(self.source))
        ]
        parts += [(b.line, b) for b in blocks(text) if b.argument == "console" or b.caption]
        try:
            for _, part in sorted(parts, key=lambda entry: entry[0]):
                self._step(part)
        finally:
            for process in self.background:
                process.terminate()
                process.wait()
        return len(parts)

    def _step(self, part: doctest.Example | Block) -> None:
        if isinstance(part, doctest.Example):
            self._example(part)
        elif part.caption:
            Path(part.caption).write_text(self._content(part), encoding="utf-8")
        else:
            for line, command, shown in commands(part):
                output = self._command(command)
                if not doctest.OutputChecker().check_output(shown, output, FLAGS):
                    self.problems.append(
                        f"{self.source}:{line}: $ {command}\nshown:\n{shown}\noutput:\n{output}"
                    )

    def _content(self, block: Block) -> str:
        if block.directive != "literalinclude":
            return block.body
        return (self.source.parent / block.argument).read_text(encoding="utf-8")

    def _example(self, example: doctest.Example) -> None:
        """Run one example; the names that it defines are there for the next."""
        test = doctest.DocTest([example], self.names, self.source.name, str(self.source), 0, None)
        said = io.StringIO()
        doctest.DocTestRunner(optionflags=FLAGS).run(test, out=said.write, clear_globs=False)
        self.names = test.globs
        if said.getvalue():
            self.problems.append(f"{self.source}:{example.lineno + 1}:\n{said.getvalue()}")

    def _command(self, command: str) -> str:
        """Run one command and return what a terminal shows of it."""
        words = shlex.split(command, comments=True)
        target = words[words.index(">") + 1] if ">" in words else None
        words = words[: words.index(">")] if target else words
        output, errors = io.StringIO(), io.StringIO()
        try:
            with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
                self.code = self._call(words)
        except SystemExit as stop:
            self.code = int(stop.code or 0)
        if self.code == 2 and not errors.getvalue():
            self.problems.append(f"{self.source}: {command}: exit code 2")
        if target:
            Path(target).write_text(output.getvalue(), encoding="utf-8")
            return errors.getvalue()
        return output.getvalue() + errors.getvalue()

    def _call(self, words: list[str]) -> int:
        match words:
            case [name, *rest] if name in ENTRIES:
                return ENTRIES[name](rest)
            case ["echo", "$?"]:
                print(self.code)
            case ["mkdir", name]:
                Path(name).mkdir()
            case ["cp", source, target]:
                shutil.copy(source, target)
            case ["cat", name]:
                print(Path(name).read_text(encoding="utf-8"), end="")
            case ["python", name]:
                runpy.run_path(name, run_name="__main__")
            case ["make", *targets]:
                # The suite cannot run itself; what is shown is a target that can be made.
                dry = ["make", "--dry-run", *targets]
                subprocess.run(dry, cwd=ROOT, check=True, capture_output=True)
            case [".", ".venv/bin/activate"]:
                pass  # the suite runs in it
            case ["pip", "install", what]:
                name, _, extras = what.rstrip("]").partition("[")
                project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
                known = project["project"]["optional-dependencies"]
                assert name in {"slipstates", "."}, f"{what} is another package"
                assert set(filter(None, extras.split(","))) <= set(known), f"{what}: {known}"
            case ["dask", *rest, "&"]:
                run = [sys.executable, "-m", "dask", *rest]
                quiet = subprocess.DEVNULL
                self.background.append(subprocess.Popen(run, stdout=quiet, stderr=quiet))
            case _:
                raise ValueError(f"{self.source}: no way to run {' '.join(words)!r}")
        return 0


def commands(block: Block) -> Iterator[tuple[int, str, str]]:
    """Yield (line, command, shown output) of a console block.

    Raises:
        ValueError: the block does not start with a command.
    """
    pieces = re.split(r"(?m)^\$ ", block.body)
    if pieces[0].strip() or len(pieces) < 2:
        raise ValueError(f"line {block.line}: a console block starts with '$ command'")
    line = block.line
    for piece in pieces[1:]:
        command, _, shown = piece.replace("\\\n", " ").partition("\n")
        line += 1
        yield line, command, shown
        line += piece.count("\n") - 1
