"""One question put to every method, a table of verdicts; and two models in one plane."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from arrangement.console.progress import watched
from arrangement.hints import HintsMixin, hints_on_arguments
from arrangement.numbers import budget
from arrangement.numbers.exact import RationalVector, shown, to_text
from equilibrium.core.contacts import FloatContacts
from equilibrium.model.assembly import Assembly, Wrenches
from equilibrium.model.contact import pyramid_edges
from equilibrium.model.errors import GraspError, UndecidedError
from equilibrium.model.grasp import Grasp
from equilibrium.model.rows import ContactRows
from equilibrium.model.subject import check_subject, texts
from equilibrium.model.synonyms import ARGUMENTS
from equilibrium.wrench_sets.slice import FORCES, resisted_region

from .grasp_wrench_space import GraspWrenchSpace
from .method import BODIES, PLANE, SPACE, kind_of
from .registry import DECIDING, DECIDING_ASSEMBLIES, DECIDING_IN_SPACE, METHODS, method_named

_WORDS = {True: "yes", False: "no", None: "-"}
#: What a mark of the comparison means, for those that it has.
_MARKS = {
    "-": "the method has no verdict on this wrench",
    "!": "another verdict than that of the full model",
}


@dataclass(frozen=True)
class Answer(HintsMixin):
    """The verdict of one method.

    Attributes:
        method: a key of `METHODS`.
        title: what it is, in words.
        accepts: whether it says that the wrench is resisted; None if it says nothing.
        remark: what the answer rests on.
    """

    method: str
    title: str
    accepts: bool | None
    remark: str

    def __bool__(self) -> bool:
        if self.accepts is None:
            raise GraspError(
                f"{self.method} gives neither yes nor no for this wrench ({self.remark}); "
                "ask for .accepts, which is None"
            )
        return self.accepts


@dataclass(frozen=True)
class Comparison(HintsMixin):
    """The verdicts of all methods on one question; the full model comes first.

    Attributes:
        pyramid: edges of the friction pyramids asked for; None for round cones, or in the plane.
    """

    grasp: Grasp | Assembly
    wrench: RationalVector | Wrenches
    answers: tuple[Answer, ...]
    pyramid: int | None = None

    @property
    def stable(self) -> bool:
        """The verdict of the full model.

        Raises:
            UndecidedError: in space it may be undecided.
        """
        if self.answers[0].accepts is None:
            raise UndecidedError(f"the full model: {self.answers[0].remark}")
        return self.answers[0].accepts

    def __bool__(self) -> bool:
        """Return the verdict of the full model."""
        return self.stable

    @property
    def disagreeing(self) -> tuple[str, ...]:
        """The methods with another verdict than the full model; none where it has none."""
        complete = self.answers[0].accepts
        return tuple(
            answer.method
            for answer in self.answers
            if None not in (complete, answer.accepts) and answer.accepts is not complete
        )

    def __getitem__(self, method: str) -> Answer:
        return next(answer for answer in self.answers if answer.method == method)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; `agrees` is null where it or the full model says nothing."""
        cones = {} if self.pyramid is None else {"pyramid": self.pyramid}
        return cones | {
            "stable": self.answers[0].accepts,
            "methods": [
                {
                    "method": answer.method,
                    "title": answer.title,
                    "accepts": answer.accepts,
                    "agrees": None
                    if None in (answer.accepts, self.answers[0].accepts)
                    else answer.method not in self.disagreeing,
                    "remark": answer.remark,
                }
                for answer in self.answers
            ],
            "wrench": texts(self.wrench),
            "assembly" if isinstance(self.grasp, Assembly) else "grasp": self.grasp.to_dict(),
        }

    def lines(self) -> Iterator[str]:
        """Yield a line for each method, then what its marks mean."""
        marks: set[str] = set()
        for answer in self.answers:
            mark = "!" if answer.method in self.disagreeing else " "
            word = _WORDS[answer.accepts]
            yield f"{mark} {word:<4}{answer.title:<60}{answer.remark}"
            marks |= {mark, word[0]}
        yield from (f"{mark}  {text}" for mark, text in _MARKS.items() if mark in marks)


def predict(method: str, grasp: Grasp, wrench: RationalVector) -> bool | None:
    """Return one method's verdict, by its key in `METHODS`."""
    return method_named(method).outcome(grasp, wrench)[0]


def check_cost(grasp: Grasp | Assembly) -> None:
    """Refuse more contacts than all methods can take."""
    rows = grasp.rows if isinstance(grasp, Assembly) else ContactRows.of_grasp(grasp)
    # Programs with huge or tiny numbers are solved without floats.
    each = 1 if FloatContacts(rows).moderate else 100
    budget.check_cost(
        f"all methods on {len(grasp)} contacts",
        "ask the full model (solve)",
        steps=each * len(grasp) ** 3,
    )


@hints_on_arguments(ARGUMENTS)
def compare(
    grasp: Grasp | Assembly,
    wrench: Iterable[Any] | Mapping[str, Iterable[Any]],
    *,
    methods: Iterable[str] | None = None,
    pyramid: int | None = None,
) -> Comparison:
    """Decide one wrench by the full model and by other methods.

    Args:
        grasp: contacts; or an assembly, for which the full model and those for rigid bodies answer.
        wrench: applied, ``(f_x, f_y, tau)``, or six numbers in space, where fewer methods answer;
            for an assembly one for each body, by name.
        methods: keys of `METHODS`, besides the full model; all that answer if omitted.
        pyramid: in space, edges of friction pyramids in place of the round cones, for the complete
            model and all methods with friction; see `equilibrium.model.contact`.

    Raises:
        GraspError: an unknown method, a wrench of the wrong length, or a pyramid in the plane or of
            no such number.

    Returns:
        All verdicts. The compliance methods start from tangential forces that balance the
        preloads where such forces exist, and their tangential springs are as stiff as the normal
        ones.

    >>> from equilibrium import read_grasp
    >>> compare(read_grasp("paper-three-contacts"), [0, -1, 0]).disagreeing
    ('linear-compliance',)
    """
    check_subject(grasp)
    check_cost(grasp)
    applied: Any
    if isinstance(grasp, Assembly):
        applied = grasp.read_wrenches(wrench)
        if pyramid is not None:
            raise GraspError("an assembly takes no pyramid; leave it out")
    else:
        applied = grasp.read_wrench(wrench)
        if pyramid is not None:
            pyramid_edges(pyramid, grasp.dimension)
    answers = [
        Answer(key, METHODS[key].title, *METHODS[key].outcome(grasp, applied, pyramid))
        for key in watched(_chosen(grasp, methods), "methods")
    ]
    return Comparison(grasp, applied, tuple(answers), pyramid)


def _chosen(grasp: Grasp | Assembly, methods: Iterable[str] | None) -> list[str]:
    """Return the methods in the order of the table, the full model first."""
    answering = {PLANE: DECIDING, SPACE: DECIDING_IN_SPACE, BODIES: DECIDING_ASSEMBLIES}[
        kind_of(grasp)
    ]
    wanted = answering if methods is None else (answering[0], *methods)
    for name in wanted:
        if name not in answering:
            where = "" if name not in METHODS else " for one wrench of such a grasp"
            known = ", ".join(answering)
            raise GraspError(f"there is no method {shown(name)}{where}; expected one of {known}")
    return [name for name in answering if name in wanted]


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
