"""The formally verified program (`proofs_check/formal`), which `make formal` builds: an own route.

It checks certificates; and it gets planes as text and counts by recursion, one plane at a time.
Nothing of the counts and the enumerators here takes part.
"""

from __future__ import annotations

import json
import math
import os
import shutil
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from random import Random
from statistics import fmean, stdev
from typing import Any

from arrangement.console import progress
from arrangement.errors import InputError
from arrangement.numbers import budget
from arrangement.numbers.exact import IntegerVector, sign_text, to_text, unoriented

from .faces import Face
from .planes import Planes

#: Beside the Python that runs, where `make formal` puts it, or on the PATH.
PROGRAM = "proved-checker"
#: Branches that a forecast follows, the longest list that it takes, and what a step of them takes.
_PROBES, _LARGEST, _STEP = 100, 2000, 0.2
#: More steps than these are named before they are taken; this many take about a second.
_MANY = 10_000_000


def program() -> str | None:
    """Return where the program is, if it is built."""
    folders = [str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)]
    return shutil.which(PROGRAM, path=os.pathsep.join(folders))


def ask_proved(
    *arguments: str,
    text: str | None = None,
    error: type[InputError] = InputError,
    seconds: float = 0,
) -> tuple[str, str]:
    """Run the program on one file; return the word that it answers and what comes after it.

    Args:
        arguments: an option, and a path, or ``"-"`` (stdin).
        text: what it reads as stdin; if omitted, our own.
        error: what is raised.
        seconds: that it may take, for the line with how many have passed.

    Raises:
        InputError: there is no such program, or it cannot read the file.
    """
    code, output = _run(arguments, text, error, seconds)
    answer, _, rest = output.strip().partition(": ")
    if (code, answer) not in ((0, "accepted"), (0, "counted"), (1, "refused")):
        raise error(f"the verified checker cannot read {arguments[-1]!r}: {rest or answer}")
    return answer, rest


def ask_proved_each(option: str, documents: Iterable[str]) -> list[str]:
    """Return what one run of the program counts in each of many documents, each of one line."""
    _, output = _run(("--lines", option, "-"), "\n".join(documents), InputError)
    return [line.removeprefix("counted: ") for line in output.splitlines()]


def _run(
    arguments: Iterable[str], text: str | None, error: type[InputError], seconds: float = 0
) -> tuple[int, str]:
    """Return exit code and output."""
    import subprocess  # slow to load, and few commands need it

    path = program()
    if path is None:
        raise error(
            f"the verified checker is not built: no program {PROGRAM}; run `make formal` in "
            "a checkout of the project, or omit --verified"
        )
    stdin = None if text is None else subprocess.PIPE
    with subprocess.Popen(
        [path, *arguments], stdin=stdin, stdout=subprocess.PIPE, text=True, errors="replace"
    ) as process:
        output = None
        try:
            for _ in progress.watched(range(round(seconds)), "seconds"):
                with suppress(subprocess.TimeoutExpired):
                    output, _ = process.communicate(text, timeout=1)
                    break
                text = None  # it has been sent
            if output is None:
                output, _ = process.communicate(text)
        except BaseException:
            process.kill()
            raise
    return process.returncode, output


def proved_f_vector(planes: Planes) -> tuple[int, ...]:
    """Return the numbers of faces of dimension 0, ..., d, counted by the verified program.

    Raises:
        InputError: the program is not built, or entries are irrational.
        OutOfReachError: it would take too long.
    """
    return _numbers("--faces", planes, planes.dimension, planes.rank)[::-1]


def proved_f_vectors(many: Iterable[Planes]) -> list[tuple[int, ...]]:
    """Return `proved_f_vector` of each of many short arrangements, from one run of the program."""
    listed = list(many)
    outputs = ask_proved_each("--faces", (json.dumps(_document(planes)) for planes in listed))
    pairs = zip(outputs, listed, strict=True)
    return [_pad(text, planes.dimension)[::-1] for text, planes in pairs]


def proved_whitney_numbers(planes: Planes) -> tuple[int, ...]:
    """Return the coefficients of t^d, ..., t^(d - rank) in the characteristic polynomial.

    Their absolute values add up to the number of regions; that is the theorem.
    """
    return _numbers("--polynomial", planes, planes.rank, 0)


def proved_complete(planes: Planes, faces: Iterable[Face]) -> bool:
    """Return whether these are all faces, each once and with a point that has its signs.

    Raises:
        InputError: as `proved_f_vector`; or a witness in another space.
    """
    steps = _forecast(planes, planes.rank)
    listed = [[sign_text(face.signs), list(map(to_text, face.witness))] for face in faces]
    document = {"certificate": "all faces", "planes": _document(planes), "faces": listed}
    text = json.dumps({"schema_version": 1, **document})
    return ask_proved("-", text=text, seconds=steps / _MANY) == ("accepted", "all faces")


def _numbers(option: str, planes: Planes, last: int, deepest: int) -> tuple[int, ...]:
    text, seconds = json.dumps(_document(planes)), _forecast(planes, deepest) / _MANY
    return _pad(ask_proved(option, "-", text=text, seconds=seconds)[1], last)


def _pad(output: str, last: int) -> tuple[int, ...]:
    numbers = [int(word) for word in output.split()][: last + 1]
    return (*numbers, *[0] * (last + 1 - len(numbers)))


def _document(planes: Planes) -> dict[str, Any]:
    if planes.field is not None:
        raise InputError(
            f"the entries are in {planes.field!r}, but the verified program needs rational ones; "
            "omit --verified"
        )
    rows = [list(map(to_text, plane)) for plane in planes.integer_planes]
    return {
        "schema_version": 1,
        "dimension": planes.dimension,
        "planes": [row[:-1] for row in rows],
        "offsets": [row[-1] for row in rows],
    }


def _forecast(planes: Planes, deepest: int) -> float:
    """Refuse what takes too long; return how many steps the rest takes, and say it if many.

    Args:
        deepest: codimension of the faces that are counted.
    """
    m, rank, central = len(planes), planes.rank, planes.has_common_point
    rows = [unoriented(plane) for plane in reversed(planes.integer_planes)]
    bits = max((x.bit_length() for row in rows for x in row), default=0)
    # A face of planes in general position, and what is done on a plane.
    pace = 10 + bits * rank / 50
    faces = float(_most(0, m, rank, central) if deepest else _most(m, 0, rank, central))
    steps = faces * (1 + 0.1 * m) * pace
    if steps > _MANY and m * rank <= _LARGEST:
        source = Random(0)
        sizes = [_probe(rows, rank, central, deepest > 0, source) for _ in range(_PROBES)]
        likely = [fmean(n) + 2 * stdev(n) / math.sqrt(_PROBES) for n in zip(*sizes, strict=True)]
        faces, steps = min(faces, likely[0]), min(steps, likely[1] * _STEP * pace)
    budget.check_cost(
        f"counting {budget.about(faces)} faces by the verified program", long_steps=steps
    )
    if steps > _MANY:
        progress.note(
            f"the verified program counts about {budget.about(faces)} faces; it takes about "
            f"{budget.about(steps)} steps"
        )
    return steps


@lru_cache(maxsize=100_000)
def _most(apart: int, others: int, rank: int, central: bool) -> int:
    """Return how many faces planes in general position have that lie in none of the first ones."""
    total = 0
    for k in range(min(others, rank) + 1):
        n, r = apart + others - k, rank - k
        upto = 2 * sum(math.comb(n - 1, i) for i in range(r)) if central and n else 0
        regions = upto if central and n else sum(math.comb(n, i) for i in range(r + 1))
        total += math.comb(others, k) * regions
    return total


def _probe(
    rows: Sequence[IntegerVector], rank: int, central: bool, faces: bool, source: Random
) -> tuple[float, float]:
    """Follow one branch of the recursion to its end; return how many ends and steps that makes.

    Branches are chosen as often as planes in general position would have ends there; the averages
    are the numbers of the whole recursion.

    Source: D. Knuth, Estimating the efficiency of backtrack programs, Math. Comp. 29 (1975).
    """
    apart, others = ([], list(rows)) if faces else (list(rows), [])
    weight, steps = 1.0, 0.0
    while apart or others:
        home = others or apart
        plane, kept = home.pop(), home is others
        different = set(apart)
        further = len(set(others) - different - {plane})
        if plane in different:  # on it nothing is left, as is seen soon
            steps += weight
            apart += [plane] * kept
            continue
        steps += weight * (1 + len(apart) + len(others))
        off = _most(len(different) + kept, further, rank, central)
        on = _most(len(different), further, rank - 1, central)
        if source.random() * (off + on) < on:
            weight *= (off + on) / on
            apart, others, rank = _restrict(apart, plane), _restrict(others, plane), rank - 1
        else:
            weight *= (off + on) / off
            apart += [plane] * kept
    return weight, steps


def _restrict(rows: Iterable[IntegerVector], plane: IntegerVector) -> list[IntegerVector]:
    """Return the planes on one of them, but for those that do not meet it and those with all."""
    j = next(i for i, x in enumerate(plane) if x)
    p = plane[j]
    restricted = (
        unoriented([p * x - row[j] * y for x, y in zip(row, plane, strict=True)]) if row[j] else row
        for row in rows
    )
    return [row for row in restricted if any(row[:-1])]
