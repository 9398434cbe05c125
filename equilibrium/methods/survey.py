"""How often each method disagrees with the complete model, with a smallest example of each kind.

The counts are over seeded random grasps. The examples are found by search: grasps with few
contacts and small numbers are drawn until some disagree, and each find is then made smaller, by
leaving out contacts and by putting simpler numbers in, as long as it still disagrees the same way.
What no single such step can make smaller is reported; a still smaller one may exist.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from random import Random
from typing import Any

from arrangement.console.number_form import Documented
from arrangement.console.progress import watched
from arrangement.numbers.exact import RationalVector, to_text
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.methods.compare import ask
from equilibrium.methods.grasp_wrench_space import GraspWrenchSpace
from equilibrium.methods.registry import DECIDING
from equilibrium.model.contact import Contact
from equilibrium.model.grasp import Grasp
from equilibrium.wrench_sets.plane import FORCES, resisted_region

OTHERS = DECIDING[1:]


@dataclass(frozen=True)
class Example(Documented):
    """A question on which a method and the complete model disagree.

    Attributes:
        method: a key of `METHODS`.
        accepts: what the method says; the complete model says the opposite.
    """

    in_document = ("method", "accepts", "wrench", "grasp")

    method: str
    accepts: bool
    grasp: Grasp
    wrench: RationalVector


@dataclass
class Count:
    """How a method compares: numbers of questions (`silent`: it says nothing)."""

    both_accept: int = 0
    both_refuse: int = 0
    accepts_wrongly: int = 0
    refuses_wrongly: int = 0
    silent: int = 0

    def add(self, ours: bool, theirs: bool | None) -> None:
        """Count one question."""
        if theirs is None:
            self.silent += 1
        elif theirs:
            self.both_accept += ours
            self.accepts_wrongly += not ours
        else:
            self.refuses_wrongly += ours
            self.both_refuse += not ours


@dataclass
class Survey:
    """The counts of every method over the same questions."""

    questions: int = 0
    stable: int = 0
    counts: dict[str, Count] = field(default_factory=lambda: {name: Count() for name in OTHERS})

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form."""
        return {
            "questions": self.questions,
            "stable": self.stable,
            "methods": {name: vars(count).copy() for name, count in self.counts.items()},
        }


def survey(
    number: int = 100,
    *,
    contacts: Iterable[int] = (2, 3, 4),
    seed: int = 0,
) -> Survey:
    """Count agreements over random grasps and wrenches.

    Args:
        number: of questions.
        contacts: numbers of contacts, taken in turn.
        seed: of the first question; the next ones follow, so odd ones have preload.
    """
    sizes = tuple(contacts)
    found = Survey()
    for k in watched(range(seed, seed + number), "questions"):
        # The size changes after both kinds of preload had their turn.
        grasp, wrench = random_grasp(sizes[k // 2 % len(sizes)], k), random_wrench(k)
        ours = bool(ask("complete", grasp, wrench))
        found.questions += 1
        found.stable += ours
        for name, count in found.counts.items():
            count.add(ours, ask(name, grasp, wrench))
    return found


def smallest_examples(
    *,
    methods: Iterable[str] = OTHERS,
    tries: int = 60,
    seed: int = 0,
) -> tuple[Example, ...]:
    """Return the smallest disagreement found of each method and kind.

    Args:
        methods: which ones, by their keys.
        tries: how many small random questions are asked of each number of contacts, 1 to 3.
        seed: of the search.
    """
    wanted = tuple(methods)
    kept: dict[tuple[str, bool], Example] = {}
    for k in watched(range(3 * tries), "tries"):
        grasp, wrench = _small_question(1 + k // tries, f"{seed} {k}")
        ours = bool(ask("complete", grasp, wrench))
        for name in wanted:
            if (name, not ours) in kept and len(kept[name, not ours].grasp) < len(grasp):
                continue
            if ask(name, grasp, wrench) is (not ours):
                example = shrunk(Example(name, not ours, grasp, wrench))
                best = kept.get((name, not ours))
                if best is None or size(example.grasp, example.wrench) < size(
                    best.grasp, best.wrench
                ):
                    kept[name, not ours] = example
    return tuple(kept[key] for key in sorted(kept, key=lambda k: (OTHERS.index(k[0]), k[1])))


def shrunk(example: Example) -> Example:
    """Return an example that no single simplification makes smaller."""
    grasp, wrench = example.grasp, example.wrench
    while True:
        limit = size(grasp, wrench)
        for smaller, load in _simpler(grasp, wrench):
            if size(smaller, load) < limit and _disagrees(example, smaller, load):
                grasp, wrench = smaller, load
                break
        else:
            return Example(example.method, example.accepts, grasp, wrench)


def size(grasp: Grasp, wrench: RationalVector) -> tuple[int, int]:
    """Return what "smaller" means: fewer contacts, then simpler numbers in all."""
    total = sum(map(_weight, wrench))
    for c in grasp:
        total += sum(map(_weight, (*c.point, c.friction, c.preload, c.stiffness - 1)))
        total += sum(map(_weight, c.normal))
    return len(grasp), total


def _weight(x: Fraction) -> int:
    """Return 0 for 0, 1 for 1, 2 for -1, more for larger numbers and finer fractions."""
    return 2 * abs(x.numerator) - (x > 0) + 2 * (x.denominator - 1)


def _disagrees(example: Example, grasp: Grasp, wrench: RationalVector) -> bool:
    return (
        ask(example.method, grasp, wrench) is example.accepts
        and ask("complete", grasp, wrench) is not example.accepts
    )


def _simpler(grasp: Grasp, wrench: RationalVector) -> Iterator[tuple[Grasp, RationalVector]]:
    """Yield the question with one contact fewer, then with one number changed."""
    contacts = list(grasp)
    for i in range(len(contacts)):
        yield Grasp(contacts[:i] + contacts[i + 1 :]), wrench
    for k in range(3):
        for x in _numbers(wrench[k]):
            yield grasp, (*wrench[:k], x, *wrench[k + 1 :])
    for i, contact in enumerate(contacts):
        for other in _simpler_contacts(contact):
            yield Grasp([*contacts[:i], other, *contacts[i + 1 :]]), wrench


def _simpler_contacts(c: Contact) -> list[Contact]:
    changes: list[dict[str, Any]] = [{"point": (0, 0)}]
    for k in range(2):
        found = _numbers(c.point[k])
        changes += [{"point": (*c.point[:k], x, *c.point[k + 1 :])} for x in found]
    changes += [{"normal": normal} for normal in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    changes += [{"friction": x} for x in _numbers(c.friction) if x >= 0]
    changes += [{"stiffness": 1}, *({"preload": x} for x in _numbers(c.preload) if x >= 0)]
    return [replace(c, **change) for change in changes]


def _numbers(x: Fraction) -> list[Fraction]:
    """Return simpler numbers than x, the simplest first."""
    near = [Fraction(n, d) for n in (0, 1, -1, 2, -2) for d in (1, 2)]
    return sorted({y for y in (*near, Fraction(round(x))) if _weight(y) < _weight(x)}, key=_weight)


def _small_question(contacts: int, seed: str) -> tuple[Grasp, RationalVector]:
    """Return a random question with small numbers."""
    source = Random(seed)
    half = Fraction(1, 2)

    def contact() -> Contact:
        normals = [(1, 0), (0, 1), (-1, 0), (0, -1), ("3/5", "4/5"), ("-4/5", "3/5")]
        return Contact(
            [source.randint(-2, 2), source.randint(-2, 2)],
            source.choice(normals),
            source.choice([Fraction(0), half, Fraction(1), Fraction(2)]),
            1,
            source.choice([0, 0, 1, 2]),
        )

    grasp = Grasp(contact() for _ in range(contacts))
    return grasp, tuple(Fraction(source.randint(-2, 2)) for _ in range(3))


def resistance_figure(
    grasp: Grasp, spans: Sequence[Iterable[Any]] = FORCES, origin: Iterable[Any] = (0, 0, 0)
) -> dict[str, Any]:
    """Return the wrench-space slice, and the resisted wrenches without preload and with preload 1.

    Returns:
        A JSON form. ``grasp_wrench_space``: the corners, counter-clockwise, of the slice of the
        space with normal forces that sum to at most 1; ``no_preload`` and ``preload_1``: as
        `Region.to_dict`, where the border is drawn only where resistance ends.

    Source: [HaasHeger2018], the figure with parts (a), (b), (c).
    """
    frame, start = [tuple(span) for span in spans], tuple(origin)
    corners = GraspWrenchSpace(grasp, "L1").slice(start, *frame)
    slice_of_space = {"norm": "L1", "corners": [[to_text(x) for x in p] for p in corners]}
    unloaded, loaded = (
        resisted_region(grasp.with_preload(preload), frame, start) for preload in (0, 1)
    )
    return {
        "grasp_wrench_space": slice_of_space,
        "no_preload": unloaded.to_dict(),
        "preload_1": loaded.to_dict(),
    }
