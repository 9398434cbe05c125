"""Plants small faults in the code, one at a time, and lists those that no test notices.

    python tests/mutants.py                   all targets
    python tests/mutants.py checker law       some of them
    python tests/mutants.py --seed 5          another sample of the targets that are sampled
    python tests/mutants.py --jobs 1          one process
    python tests/mutants.py law --first 20    from the 20th fault on

A fault changes one comparison, constant, sign, "and" or "or" of the syntax tree, drops a condition
or an entry, or takes one function or end of an interval for its opposite. The tests of its target
run in a process of their own; one that fails, or that takes too long, has found the fault. First
the code of functions is exchanged after all is imported, and tests that found a fault nearby run
first; what survives that, or is no code of a function, is there from the import on.
Exit 1 if faults survive that are not among `EQUIVALENT`.
"""

from __future__ import annotations

import argparse
import ast
import copy
import gc
import importlib
import importlib.abc
import importlib.util
import json
import os
import resource
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import chain
from pathlib import Path
from random import Random
from types import CodeType, FunctionType
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent.parent
#: Seconds of processor time after which the tests of one fault are stopped; that counts as found.
#: Without a fault they take less than half of it.
LIMIT = 90
#: Bytes that they may take: without its limit on depth the checker would follow any document.
MEMORY = 4 * 2**30


class Target(NamedTuple):
    """A module, the tests that cover it, fast ones first, and how many faults to plant (0: all)."""

    module: str
    tests: tuple[str, ...]
    sample: int = 0


CHECKER = ("tests/equilibrium/test_checker.py",)
SOLVER = ("tests/equilibrium/test_verdict.py",)
SEARCH = ("tests/equilibrium/test_leaves.py", "tests/equilibrium/test_resistance.py")
SPACE = ("tests/equilibrium/test_space_checker.py", "tests/equilibrium/test_space.py")
MODULAR = ("tests/arrangement/test_counts_symmetric.py", "tests/arrangement/test_number_field.py")
CIRCLES = (
    "tests/arrangement/test_great_circles_exactness.py",
    "tests/arrangement/test_number_field.py",
)
TARGETS = {
    "checker": Target("equilibrium.certificate.checker", CHECKER),
    "law": Target("equilibrium.certificate.law", CHECKER),
    "reading": Target("equilibrium.certificate.reading", CHECKER),
    "space": Target("equilibrium.certificate.space", SPACE),
    "enclosure": Target("equilibrium.certificate.enclosure", SPACE),
    "robust": Target("equilibrium.certificate.robust", ("tests/equilibrium/test_robustness.py",)),
    "plane": Target("equilibrium.model.plane", ("tests/equilibrium/test_space.py",)),
    "loads": Target("equilibrium.wrench_sets.spatial", ("tests/equilibrium/test_space.py",)),
    "final": Target(
        "arrangement.library.census.final_polynomials",
        ("tests/arrangement/test_identify.py",),
    ),
    "modular": Target("arrangement.counts.modular", MODULAR),
    "lowrank": Target("arrangement.counts.low_rank", ("tests/arrangement/test_counts.py",)),
    "field": Target(
        "arrangement.numbers.number_field", ("tests/arrangement/test_number_field.py",)
    ),
    "circles": Target("arrangement.enumeration.great_circles.predicates", CIRCLES),
    "crossings": Target("arrangement.enumeration.great_circles.crossings", CIRCLES),
    "predicates": Target(
        "arrangement.enumeration.affine_space.predicates",
        ("tests/arrangement/test_affine_space.py",),
        24,
    ),
    "states": Target("equilibrium.plane.states.state_system", SOLVER, 12),
    "elimination": Target("arrangement.numbers.linear.rank", SOLVER, 12),
    "pieces": Target("equilibrium.plane.states.equilibrium", SOLVER, 12),
    "leaves": Target("equilibrium.plane.search.virtual_motions", SEARCH, 12),
    "guess": Target("equilibrium.plane.search.state_equilibrium", SEARCH, 12),
    "splits": Target("equilibrium.plane.search.state_splits", SEARCH, 12),
    "program": Target("equilibrium.plane.search.part_program", SEARCH, 12),
    "oracle": Target("proofs_check.routes.oracle", ("tests/proofs_check/test_oracle.py",), 12),
}

#: Faults that change no answer, by target, line of code and fault, with the reason.
EQUIVALENT: dict[tuple[str, str, str], str] = {}
for _target, _text, _changes, _reason in (
    (
        "checker",
        "MAX_DEPTH = 300",
        ("300 -> 301", "300 -> 299"),
        "a limit that was chosen; the tests follow it",
    ),
    (
        "checker",
        'if given is None and (state == "detached" or (state is None and max(e) <= 0)):',
        ("LtE -> Lt", "0 -> -1"),
        "where the largest e is 0, kappa max(0, e) is 0 as well: the test saves time only",
    ),
    (
        "checker",
        "elif kappa < 0:",
        ("Lt -> LtE", "0 -> 1"),
        "kappa is an integer, and kappa = 0 adds 0",
    ),
    (
        "checker",
        'contact, due = split.at[0], "attached" if split.kind == "slip" else "undecided"',
        ("0 -> -1",),
        "the tuple has one entry",
    ),
    (
        "checker",
        "corners = product(region[1:3], region[3:5], region[5:7])",
        ("7 -> 8",),
        "the half space has seven generators",
    ),
    (
        "leaves",
        "_WORD = 2**62",
        ("2 -> 1",),
        "all products are then taken with integers of Python, which are right too",
    ),
    (
        "leaves",
        "spring = product(generators.reshape(-1, 4), contacts.spring.T).reshape(count, 4, m)",
        ("1 -> 2",),
        "numpy takes any negative length as the one to work out",
    ),
    (
        "leaves",
        "slip = product(generators[:, :, 1:].reshape(-1, 3), contacts.tangent.T)"
        ".reshape(count, 4, m)",
        ("1 -> 2",),
        "numpy takes any negative length as the one to work out",
    ),
    (
        "guess",
        "if not size[best] > 1e-9 * np.linalg.norm(tangents[best]) * (spare[best] + 1e-9):",
        ("Add -> Sub",),
        "a threshold in floating point that was chosen; the rank is then found exactly",
    ),
    (
        "guess",
        "spare = 1.0 - np.abs(np.array(guess.shares)[sticking]) / (_SHARES + 1)",
        ("1 -> 2",),
        "a share in floating point that orders contacts; any order is then solved exactly",
    ),
    (
        "guess",
        "_COARSE = 16",
        ("16 -> 17", "16 -> 15"),
        "how finely guessed motions are rounded was chosen",
    ),
    (
        "guess",
        "point = [0] * size",
        ("0 -> 1", "0 -> -1"),
        "every entry is set below before it is read",
    ),
    (
        "splits",
        "_SIZES = (1, 2, 3, 4, 5, 7, 10, 20, 50, 100, 1000, 10**4, 10**6)",
        ("1 -> 0", "1 -> 2", "10 -> 9", "10 -> 11"),
        "how multipliers are rounded was chosen; what they close is tested exactly",
    ),
    (
        "splits",
        "low, high = self.spring.min(axis=0, initial=0), self.spring.max(axis=0, initial=0)",
        ("0 -> 1",),
        "a contact without force in the whole region gets no row either",
    ),
    (
        "space",
        "if isinstance(state, tuple) and not isinstance(state, Face):",
        ("dropped: not isinstance(state, Face)",),
        "faces are states of pyramids, which return before",
    ),
    (
        "space",
        "if square < 0:",
        ("Lt -> LtE",),
        "where the square is 0 both bounds ask for room >= 0",
    ),
    (
        "space",
        "contact, ends = split.at[0], list(split.directions)",
        ("0 -> -1",),
        "the tuple has one entry",
    ),
    ("space", "work, rest = dot(question.load, motion), [0] * 6", ("6 -> 7",), "one more 0"),
    (
        "space",
        "if isinstance(state, tuple) and not (turn(state[0], b) >= 0 and turn(b, state[1]) >= 0):",
        ("GtE -> Gt",),
        "along an end the product with its unit vector is the length",
    ),
    (
        "space",
        'return "" if room >= 0 or room * room * size <= friction**2 * -square else _LARGE',
        ("GtE -> Gt", "0 -> 1"),
        "rooms of 0 obey the second bound; in (0, 1) there is no integer",
    ),
    (
        "plane",
        "height = heights.pop() if heights else Fraction(0)",
        ("0 -> 1", "0 -> -1"),
        "a grasp without contacts is one in the plane",
    ),
    (
        "enclosure",
        "if square.low <= 0:",
        ("0 -> 1",),
        "slips below 2^-96 are refused too: fewer enclosures hold",
    ),
    (
        "enclosure",
        "Interval(interval(m - r).low, interval(m + r).high)",
        ("low -> high", "high -> low"),
        "any box serves into which the map takes it",
    ),
    (
        "enclosure",
        "0 if self.low < 0 < self.high else low * low >> _BITS, -(-high * high >> _BITS)",
        ("Lt -> LtE", "0 -> 1", "0 -> -1"),
        "the square of an end 0, 1 or -1 is rounded down to 0 as well",
    ),
    (
        "enclosure",
        "return Interval(_ONE * _ONE // (math.isqrt(high) + 1), "
        "_ONE * _ONE // math.isqrt(low) + 1)",
        ("1 -> 2",),
        "the interval is wider by a unit",
    ),
    (
        "lowrank",
        "return _keep(_flats_only(_concatenate(groups), m), lambda g: g.first > g.row)",
        ("Gt -> GtE",),
        "a plane is in no group of its own row",
    ),
    (
        "lowrank",
        "counted = group.first > lines.first[group.row]",
        ("Gt -> GtE",),
        "a plane of the line is in no group beside it",
    ),
    (
        "field",
        "_BITS = 128",
        ("128 -> 129", "128 -> 127"),
        "how many bits are tried first was chosen; `_SMALLEST` follows",
    ),
    (
        "field",
        "_LARGEST = 2**200",
        ("Pow -> Mult", "2 -> 3", "2 -> 1", "200 -> 201", "200 -> 199"),
        "sums beyond floats are infinite or none, and are then taken with integers",
    ),
    (
        "field",
        "_SMALLEST = 2.0 ** (64 - _BITS)",
        ("64 -> 65", "64 -> 63"),
        "any bits well beyond 53 will do",
    ),
    (
        "field",
        "self._rising = value_at(integers, self._high) > 0",
        ("Gt -> GtE",),
        "an irreducible polynomial is not 0 at a rational number",
    ),
    (
        "field",
        "def interval(self, bits: int = 10) -> tuple[Fraction, Fraction]:",
        ("10 -> 11", "10 -> 9"),
        "how short an interval is if nothing is asked was chosen",
    ),
    (
        "field",
        "while (self._high - self._low) * (1 << bits) > 1:",
        ("Gt -> GtE",),
        "the interval is half as long at most",
    ),
    (
        "field",
        "while len(rows) < self.degree - 1:",
        ("Lt -> LtE",),
        "one more power, which no product has",
    ),
    ("field", "j, bits = 0, 64", ("64 -> 65", "64 -> 63"), "more bits are taken where needed"),
    (
        "law",
        "if slip and tangential != (-limit if slip > 0 else limit):",
        ("Gt -> GtE",),
        "the slip is not 0 there",
    ),
    (
        "law",
        "return number_text(value, digits=30, longest=60)",
        ("30 -> 31", "30 -> 29", "60 -> 61", "60 -> 59"),
        "how long numbers of messages are was chosen",
    ),
):
    EQUIVALENT |= {(_target, _text, change): _reason for change in _changes}

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


class Fault(NamedTuple):
    """A changed tree: the line, its text, what was changed."""

    line: int
    text: str
    change: str
    tree: ast.Module


def faults(source: str) -> Iterator[Fault]:
    """Yield every fault of a source text."""
    tree, lines = ast.parse(source), source.splitlines()
    nodes = list(ast.walk(tree))
    skipped = {id(n) for top in nodes for n in ast.walk(top) if isinstance(top, _SILENT)}
    for place, node in enumerate(nodes):
        if id(node) in skipped:
            continue
        for change, alter in chain(_alterations(node), _omissions(node)):
            changed = copy.deepcopy(tree)
            alter(list(ast.walk(changed))[place])
            ast.fix_missing_locations(changed)
            line = getattr(node, "lineno", 0)
            yield Fault(line, lines[line - 1].strip(), change, changed)


#: Texts of messages, and annotations of types.
_SILENT = (ast.JoinedStr, ast.AnnAssign, ast.arg, ast.Raise)


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


class _Planted(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Loads one module from a changed tree."""

    def __init__(self, module: str, path: Path, tree: ast.Module) -> None:
        self.module, self.path, self.code = module, path, compile(tree, str(path), "exec")

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        if name != self.module:
            return None
        return importlib.util.spec_from_loader(name, self, origin=str(self.path))

    def exec_module(self, module: Any) -> None:
        module.__file__ = str(self.path)
        exec(self.code, module.__dict__)  # noqa: S102


def survives(target: Target, path: Path, fault: Fault) -> bool:
    """Run the tests of a target with a fault, in a process of their own."""
    child = os.fork()
    if child == 0:
        status = 1
        try:
            _confine(LIMIT)
            sys.meta_path.insert(0, _Planted(target.module, path, fault.tree))
            # Now, for pytest itself would load a module that is called something_test.
            importlib.import_module(target.module)
            status = int(_tests(target))
        finally:
            os._exit(min(status, 1))
    return os.waitpid(child, 0)[1] == 0


def _tests(target: Target, *plugins: Any) -> int:
    import pytest

    options = ["-x", "-q", "-s", "--tb=no", "-p", "no:cacheprovider", "-W", "ignore"]
    return int(pytest.main([*options, *target.tests], plugins))


class _InPlace:
    """Runs the tests with one fault after the other, in children of a process that has them all."""

    def __init__(self, target: Target, path: Path, listed: Sequence[Fault], jobs: int) -> None:
        self.module, self.listed, self.jobs = target.module, listed, jobs
        self.code, self.path = _codes(compile(path.read_text(), str(path), "exec")), str(path)
        self.left, self.limit, self.lines = list[int](), LIMIT, dict[Any, list[int]]()

    def pytest_runtestloop(self, session: Any) -> bool:
        """Collect in `left` the faults that no test notices."""
        self.functions = [
            f for f in gc.get_objects() if type(f) is FunctionType and f.__module__ == self.module
        ]
        start = time.process_time() + sum(os.times()[2:4])
        if self._found(session, None):
            raise SystemExit(f"the tests of {self.module} fail without a fault")
        self.limit = int(3 + 2 * (time.process_time() + sum(os.times()[2:4]) - start))
        with ThreadPoolExecutor(self.jobs) as pool:
            found = list(pool.map(lambda fault: self._found(session, fault), self.listed))
        self.left = [k for k, one in enumerate(found) if not one]
        return True

    def _found(self, session: Any, fault: Fault | None) -> bool:
        items, changed = list(session.items), self.code
        if fault:  # First the tests that found a fault nearby.
            changed = _codes(compile(fault.tree, self.path, "exec"))
            if changed == self.code:
                return False
            items.sort(key=lambda x: min([abs(y - fault.line) for y in self.lines.get(x, [10**6])]))
        if not (child := os.fork()):
            status = 255
            try:
                _confine(self.limit)
                for f in self.functions:
                    key = f.__code__.co_qualname, f.__code__.co_firstlineno
                    if key in changed and changed[key] != self.code[key]:
                        f.__code__ = changed[key]
                for k, (one, after) in enumerate(zip(items, [*items[1:], None], strict=True), 1):
                    session.config.hook.pytest_runtest_protocol(item=one, nextitem=after)
                    if session.testsfailed:
                        os._exit(min(k, 255))
                status = 0
            finally:
                os._exit(status)
        status = os.waitpid(child, 0)[1]
        if fault and 0 < (k := os.waitstatus_to_exitcode(status)) < 255:
            self.lines.setdefault(items[k - 1], []).append(fault.line)
        return status != 0


def _survivors(target: Target, path: Path, listed: Sequence[Fault], jobs: int) -> list[Fault]:
    """Return the faults that survive in place, from a process that may import the module."""
    reading, writing = os.pipe()
    if not os.fork():
        loop = _InPlace(target, path, listed, jobs)
        try:
            _tests(target, loop)
            os.write(writing, json.dumps(loop.left).encode())
        finally:
            os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as stream:
        return [listed[k] for k in json.loads(stream.read() or "[]")]


def _codes(code: CodeType) -> dict[tuple[str, int], CodeType]:
    """Return the code of all functions."""
    inner = [x for x in code.co_consts if isinstance(x, CodeType)]
    found = {(x.co_qualname, x.co_firstlineno): x for x in inner}
    return found | {key: x for one in inner for key, x in _codes(one).items()}


def _confine(seconds: int) -> None:
    """Bound what a child may take, and take its output."""
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)


def _preload() -> None:
    """Import what the tests need from outside once, before processes are forked."""
    for name in ("hypothesis", "jsonschema", "networkx", "numpy", "scipy.optimize", "sympy"):
        importlib.import_module(name)


def plant(name: str, seed: int, jobs: int, first: int = 1) -> int:
    """Plant the faults of a target and print those that survive; return how many are unknown."""
    target = TARGETS[name]
    path = ROOT / Path(*target.module.split(".")).with_suffix(".py")
    listed = list(faults(path.read_text(encoding="utf-8")))
    if target.sample:
        listed = Random(f"mutants {seed}").sample(listed, min(target.sample, len(listed)))
    listed = listed[first - 1 :]
    start, alive, unknown = time.monotonic(), 0, 0
    left = _survivors(target, path, listed, jobs)
    reasons = [EQUIVALENT.get((name, fault.text, fault.change), "") for fault in left]
    with ThreadPoolExecutor(jobs) as pool:
        again = pool.map(lambda f, why: why or survives(target, path, f), left, reasons)
        for fault, reason, survived in zip(left, reasons, again, strict=True):
            if survived:
                alive, unknown = alive + 1, unknown + (not reason)
                note = f"changes nothing: {reason}" if reason else "SURVIVES"
                print(f"  line {fault.line}: {fault.text}\n    {fault.change}: {note}", flush=True)
    seconds = time.monotonic() - start
    print(f"{name}: {len(listed)} faults, {alive} survive, {seconds:.0f} s", flush=True)
    return unknown


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; return 1 if a fault survives that is not known to change nothing."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=", ".join(TARGETS))
    parser.add_argument("--seed", type=int, default=0, help="of the samples")
    parser.add_argument("--jobs", type=int, default=2, help="processes at a time")
    parser.add_argument("--first", type=int, default=1, help="begin with this one of each list")
    given = parser.parse_args(arguments)
    for name in given.targets:
        if name not in TARGETS:
            parser.error(f"{name!r} is no target; known are {', '.join(TARGETS)}")
    os.chdir(ROOT)
    sys.path.insert(0, str(ROOT))
    _preload()
    names = given.targets or TARGETS
    unknown = [plant(name, given.seed, given.jobs, given.first) for name in names]
    return 1 if any(unknown) else 0


if __name__ == "__main__":
    raise SystemExit(main())
