"""Mutation testing: changes the code in one place at a time, and lists what no test notices.

    python tests/mutants.py                   all targets
    python tests/mutants.py checker law       some of them
    python tests/mutants.py --seed 5          another sample of the targets that are sampled
    python tests/mutants.py --sample 4        four of each target at most
    python tests/mutants.py --jobs 1          one target at a time
    python tests/mutants.py law --first 20    from the 20th mutant on
    python tests/mutants.py law --record      write how many survive to mutants_survivors.txt

A mutant has one comparison, constant, sign, "and" or "or" of the syntax tree changed, a condition
or an entry dropped, or one function or end of an interval taken for its opposite. The tests of its
target run in a process of their own, to the first that fails, or takes more than `LIMIT`: it has
killed the mutant. First the code of functions is exchanged after all is imported, and tests that
killed mutants nearby run first; what survives, or is not code of a function, is there from the
import on. All that survive are listed. Many change no answer (the first node of a tie, a choice of
floats that an exact program checks), so their number is compared with the one recorded: exit 1 if
more survive.
"""

from __future__ import annotations

import argparse
import ast
import copy
import gc
import importlib
import importlib.abc
import importlib.util
import os
import re
import resource
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import chain
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.sharedctypes import RawArray
from pathlib import Path
from random import Random
from types import CodeType, FunctionType
from typing import Any, NamedTuple

if __package__ is None:
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from tests.mutant_targets import ROOT, TARGETS, Target

#: CPU seconds after which a test has killed a mutant. No test takes half of it.
LIMIT = 10
#: Bytes that they may take: without its limit on depth the checker would follow any document.
MEMORY = 4 * 2**30


#: For each target that has any: how many mutants survived, of how many, when last recorded.
SURVIVORS = ROOT / "tests" / "mutants_survivors.txt"
_RECORD = re.compile(r"(.+): (\d+) of (\d+)")


def recorded() -> dict[str, tuple[int, int]]:
    """Return how many mutants of each target survived, and of how many, when last recorded."""
    lines = SURVIVORS.read_text(encoding="utf-8").splitlines()
    entries = (match for line in lines if (match := _RECORD.fullmatch(line)))
    return {entry[1]: (int(entry[2]), int(entry[3])) for entry in entries}


def record(counts: dict[str, tuple[int, int]]) -> None:
    """Write the numbers of survivors of some targets; those of the others stay."""
    kept = {name: count for name, count in recorded().items() if name in TARGETS} | counts
    lines = [f"{name}: {alive} of {of}" for name, (alive, of) in sorted(kept.items()) if alive]
    SURVIVORS.write_text("\n".join(lines) + "\n", encoding="utf-8")


_COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
_OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Add,
    ast.FloorDiv: ast.Mult,
    ast.Div: ast.Mult,
    ast.Pow: ast.Mult,
}
#: Names of functions, methods and ends of intervals that are easily taken for one another.
_NAMES = {"max": "min", "any": "all", "low": "high", "floor": "ceil"}
_NAMES |= {other: name for name, other in _NAMES.items()}


#: Texts of messages, and annotations of types.
_SILENT = (ast.JoinedStr, ast.AnnAssign, ast.arg, ast.Raise)


class Mutant(NamedTuple):
    """A mutant of a source text: the line, its text, what is changed, the changed tree."""

    line: int
    text: str
    change: str
    tree: Callable[[], ast.Module]


def mutants(source: str) -> Iterator[Mutant]:
    """Yield every mutant of a source text."""
    tree, lines, seen = ast.parse(source), source.splitlines(), Counter[tuple[int, str]]()
    nodes = list(ast.walk(tree))
    silent = [getattr(n, "annotation", None) or n for n in nodes if isinstance(n, _SILENT)]
    skipped = {id(n) for top in silent for n in ast.walk(top)}
    for place, node in enumerate(nodes):
        if id(node) in skipped:
            continue
        for change, alter in chain(_alterations(node), _omissions(node)):

            def mutated(place: int = place, alter: Any = alter) -> ast.Module:
                changed = copy.deepcopy(tree)
                alter(list(ast.walk(changed))[place])
                return ast.fix_missing_locations(changed)

            line = getattr(node, "lineno", 0)
            seen[line, change] += 1
            again = f" ({seen[line, change]})" if seen[line, change] > 1 else ""
            yield Mutant(line, lines[line - 1].strip(), change + again, mutated)


def _alterations(node: ast.AST) -> Iterator[tuple[str, Any]]:
    """Yield what can be changed in one node: a name, and a function that does it."""
    if isinstance(node, ast.Compare):
        for i, old in enumerate(node.ops):
            for new in _COMPARISONS[type(old)]:
                yield f"{type(old).__name__} -> {new.__name__}", _setter("ops", i, new())
    elif isinstance(node, ast.BoolOp):
        new_op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield f"{type(node.op).__name__} -> {type(new_op).__name__}", _setter("op", None, new_op)
    elif isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        new = _OPERATORS[type(node.op)]
        yield f"{type(node.op).__name__} -> {new.__name__}", _setter("op", None, new())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield "minus dropped", _setter("op", None, ast.UAdd())
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield "not dropped", _setter("operand", None, ast.UnaryOp(ast.Not(), node.operand))
    elif isinstance(node, ast.Constant) and type(node.value) is int:
        for value in (node.value + 1, node.value - 1):
            yield f"{node.value} -> {value}", _setter("value", None, value)


def _omissions(node: ast.AST) -> Iterator[tuple[str, Any]]:
    """Yield the same for what can be left out, or taken for its opposite."""
    if isinstance(node, (ast.BoolOp, ast.List)):
        field = "values" if isinstance(node, ast.BoolOp) else "elts"
        values = getattr(node, field)
        for i, value in enumerate(values if len(values) > 1 else ()):
            yield f"dropped: {ast.unparse(value)}", _remover(field, i)
    field = {ast.Name: "id", ast.Attribute: "attr"}.get(type(node), "")
    name = getattr(node, field, "")
    if name in _NAMES and isinstance(node.ctx, ast.Load):
        yield f"{name} -> {_NAMES[name]}", _setter(field, None, _NAMES[name])


def _setter(field: str, index: int | None, value: Any) -> Any:
    def alter(node: Any) -> None:
        if index is None:
            setattr(node, field, value)
        else:
            getattr(node, field)[index] = value

    return alter


def _remover(field: str, index: int) -> Any:
    def alter(node: Any) -> None:
        values = getattr(node, field)
        del values[index]
        if isinstance(node, ast.BoolOp) and len(values) == 1:
            values *= 2  # "x and x" is x

    return alter


class _Mutated(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Loads one module from a changed tree."""

    def __init__(self, target: Target, tree: ast.Module) -> None:
        self.target, self.code = target, compile(tree, str(target.path), "exec")

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        if name != self.target.module:
            return None
        return importlib.util.spec_from_loader(name, self, origin=str(self.target.path))

    def exec_module(self, module: Any) -> None:
        module.__file__ = str(self.target.path)
        exec(self.code, module.__dict__)  # noqa: S102


def survives(target: Target, mutant: Mutant) -> bool:
    """Run the tests of a target with a mutant from the import on, in a process of their own."""

    def run() -> int:
        sys.meta_path.insert(0, _Mutated(target, mutant.tree()))
        # Now, for pytest itself would load a module that is called something_test.
        importlib.import_module(target.module)
        return _tests(target, _Confined())

    return _in_child(run) == 0


def _in_child(run: Callable[[], int]) -> int:
    """Return what a function returns in a quiet process of its own: a number below 255."""
    if not (child := os.fork()):
        status = 255
        try:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            for stream in (1, 2):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
            _Confined().pytest_runtest_logstart()
            status = run()
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def _tests(target: Target, plugin: Any) -> int:
    import pytest

    options = ["-x", "-q", "-s", "--tb=no", "-p", "no:cacheprovider", "-W", "ignore"]
    return int(pytest.main([*options, "--hypothesis-profile=mutants", *target.tests], [plugin]))


class _Confined:
    """Ends the process when a test takes too long."""

    def pytest_runtest_logstart(self) -> None:
        """Count from here."""
        seconds, most = (
            int(time.process_time()) + 1 + LIMIT,
            resource.getrlimit(resource.RLIMIT_CPU),
        )
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, most[1]))


class _InPlace(_Confined):
    """Runs the tests with one mutant after another, in children of a process that has them all."""

    def __init__(self, target: Target, listed: Sequence[Mutant], asked: Connection) -> None:
        self.target, self.listed, self.asked = target, listed, asked
        self.lines, self.costs = dict[Any, list[int]](), dict[Any, float]()

    def pytest_runtestloop(self, session: Any) -> bool:
        """Answer for each number of a mutant whether a test kills it; -1 is none."""
        # Its children are confined; it makes as many mutants as there are.
        most = resource.getrlimit(resource.RLIMIT_CPU)[1]
        resource.setrlimit(resource.RLIMIT_CPU, (most, most))
        path, module = str(self.target.path), self.target.module
        code = _codes(compile(self.target.path.read_text(), path, "exec"))
        functions = [
            f for f in gc.get_objects() if type(f) is FunctionType and f.__module__ == module
        ]
        gc.freeze()
        for number in iter(self.asked.recv, None):
            changed, items = code, list(session.items)
            line = self.listed[number].line if number >= 0 else 0
            if number >= 0:
                changed = _codes(compile(self.listed[number].tree(), path, "exec"))
            # First those that killed a mutant nearby, and quick ones: a line is worth 0.01 s.
            far = {x: min([abs(y - line) for y in self.lines.get(x, [100])]) for x in items}
            items.sort(key=lambda x: 0.01 * far[x] + self.costs.get(x, 0))
            costs = RawArray("d", len(items))

            def run(items: Any = items, changed: Any = changed, costs: Any = costs) -> int:
                for f in functions:
                    key = f.__code__.co_qualname, f.__code__.co_firstlineno
                    if key in changed and changed[key] != code[key]:
                        f.__code__ = changed[key]
                for k, (one, after) in enumerate(zip(items, [*items[1:], None], strict=True), 1):
                    start = time.process_time()
                    session.config.hook.pytest_runtest_protocol(item=one, nextitem=after)
                    costs[k - 1] = time.process_time() - start
                    if session.testsfailed:
                        return min(k, 254)
                return 0

            status = _in_child(run) if number < 0 or changed != code else 0
            if number < 0:
                self.costs = dict(zip(items, costs, strict=True))
            elif 0 < status < 255:
                self.lines.setdefault(items[status - 1], []).append(line)
            self.asked.send(status != 0)
        return True


def _codes(code: CodeType) -> dict[tuple[str, int], CodeType]:
    """Return the code of all functions."""
    inner = [x for x in code.co_consts if isinstance(x, CodeType)]
    found = {(x.co_qualname, x.co_firstlineno): x for x in inner}
    return found | {key: x for one in inner for key, x in _codes(one).items()}


def _preload() -> None:
    """Import what the tests need from outside once, before processes are forked."""
    for name in ("jsonschema", "networkx", "numpy", "pytest", "scipy.optimize", "sympy"):
        importlib.import_module(name)
    from hypothesis import HealthCheck, Phase, settings

    settings.register_profile(  # That of tests/conftest.py, and what failed is not made smaller.
        "mutants",
        derandomize=True,
        deadline=None,
        database=None,
        suppress_health_check=[HealthCheck.too_slow],
        phases=[Phase.explicit, Phase.generate],
    )


def run_target(name: str, seed: int, first: int = 1, sample: int = 0) -> tuple[int, int]:
    """Run the mutants of a target and print those that survive; return how many, of how many."""
    target, start, alive = TARGETS[name], time.monotonic(), 0
    listed = list(mutants(target.path.read_text(encoding="utf-8")))
    if most := sample or target.sample:
        listed = Random(f"mutants {seed}").sample(listed, min(most, len(listed)))
    fork = get_context("fork")
    here, there = fork.Pipe()
    worker = fork.Process(
        target=_in_child, args=(lambda: _tests(target, _InPlace(target, listed, there)),)
    )
    worker.start()
    there.close()  # Else nothing would be heard of a worker that ends.

    def killed(number: int) -> bool:
        here.send(number)
        return bool(here.recv())

    if killed(-1):
        here.send(None)  # Else the worker would wait, and this process for it.
        raise SystemExit(f"the tests of {name} fail without a mutant, or take too long")
    for number, mutant in enumerate(listed[first - 1 :], first - 1):
        if not killed(number) and survives(target, mutant):
            alive += 1
            print(f"  {name} {number + 1}, line {mutant.line}: {mutant.text}")
            print(f"    {mutant.change}: SURVIVES", flush=True)
    here.send(None)
    worker.join()
    count = len(listed) - first + 1
    print(f"{name}: {count} mutants, {alive} survive, {time.monotonic() - start:.0f} s", flush=True)
    return alive, count


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; return 1 if more mutants of a target survive than recorded."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=", ".join(TARGETS))
    parser.add_argument("--seed", type=int, default=0, help="of the samples")
    parser.add_argument("--sample", type=int, default=0, help="at most N of each target")
    parser.add_argument("--jobs", type=int, default=2, help="targets at a time")
    parser.add_argument("--record", action="store_true", help=f"write {SURVIVORS.name}")
    parser.add_argument("--first", type=int, default=1, help="begin with this one of each list")
    options = parser.parse_args(arguments)
    for name in options.targets:
        if name not in TARGETS:
            parser.error(f"{name!r} is not a target; expected one of {', '.join(TARGETS)}")
    os.chdir(ROOT)
    _preload()
    names = options.targets or list(TARGETS)
    with ThreadPoolExecutor(options.jobs) as pool:
        counts = pool.map(
            lambda name: run_target(name, options.seed, options.first, options.sample), names
        )
        survivors = dict(zip(names, counts, strict=True))
    if options.record:
        record(survivors)
    before = recorded()
    more = {n: k for n, (k, _) in survivors.items() if k > before.get(n, (0, 0))[0]}
    for name, alive in more.items():
        print(f"{name}: {alive} survive; {before.get(name, (0, 0))[0]} are recorded")
    return 1 if more else 0


if __name__ == "__main__":
    raise SystemExit(main())
