"""One question put to every method: a table of verdicts."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from arrangement.exact import RationalVector, to_text
from arrangement.progress import watched
from equilibrium.model.grasp import Grasp, read_wrench
from equilibrium.verdict import solve

from .cones import cones
from .form_closure import form_closure
from .frictionless_slip import frictionless_slip
from .grasp_wrench_space import GraspWrenchSpace
from .linear_compliance import linear_compliance
from .printed_model import OPTIONS, solve_literal
from .springs import balancing_friction
from .weak_strong import weak_strong

#: Up to here the 3^m choices of `frictionless_slip` are tried in a comparison.
MOST_FOR_ALL_CHOICES = 8


@dataclass(frozen=True)
class Answer:
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


@dataclass(frozen=True)
class Comparison:
    """The verdicts of all methods on one question; the complete model comes first."""

    grasp: Grasp
    wrench: RationalVector
    answers: tuple[Answer, ...]

    @property
    def stable(self) -> bool:
        """The verdict of the complete model."""
        return bool(self.answers[0].accepts)

    @property
    def disagreeing(self) -> tuple[str, ...]:
        """The methods with another verdict than the complete model."""
        return tuple(
            answer.method for answer in self.answers if answer.accepts is (not self.stable)
        )

    def __getitem__(self, method: str) -> Answer:
        return next(answer for answer in self.answers if answer.method == method)

    def to_dict(self) -> dict[str, Any]:
        """Return a JSON form; `agrees` is null where a method says nothing."""
        return {
            "stable": self.stable,
            "methods": [
                {
                    "method": answer.method,
                    "title": answer.title,
                    "accepts": answer.accepts,
                    "agrees": None if answer.accepts is None else answer.accepts is self.stable,
                    "remark": answer.remark,
                }
                for answer in self.answers
            ],
            "wrench": [to_text(x) for x in self.wrench],
            "grasp": self.grasp.to_dict(),
        }


Outcome = tuple[bool | None, str]


def _complete(grasp: Grasp, wrench: RationalVector) -> Outcome:
    pieces = solve(grasp, wrench).equilibria
    return bool(pieces), f"{len(pieces)} maximal pieces of solutions"


def _printed(grasp: Grasp, wrench: RationalVector) -> Outcome:
    return solve_literal(grasp, wrench, OPTIONS).stable, "all deviations of the text at once"


def _cones(grasp: Grasp, wrench: RationalVector) -> Outcome:
    found = cones(grasp, wrench)
    return found.accepts, f"{found.tried} choices of attached contacts tried"


def _wrench_space(grasp: Grasp, wrench: RationalVector) -> Outcome:
    found = GraspWrenchSpace(grasp).verdict(wrench)
    if found.least_force is None:
        return False, "no forces inside the cones balance it"
    return True, f"total normal force at least {to_text(found.least_force)}"


def _form_closure(grasp: Grasp, _: RationalVector) -> Outcome:
    closed = form_closure(grasp).accepts
    return closed, "every wrench" if closed else "no form closure: nothing follows for one wrench"


def _weak(grasp: Grasp, wrench: RationalVector) -> Outcome:
    return weak_strong(grasp, wrench).weak, "forces inside the cones exist"


def _strong(grasp: Grasp, wrench: RationalVector) -> Outcome:
    found = weak_strong(grasp, wrench)
    if found.acceleration is None:
        return found.strong, "unit mass and inertia about the origin"
    return False, f"may start with acceleration ({', '.join(map(to_text, found.acceleration))})"


def _frictionless(grasp: Grasp, wrench: RationalVector) -> Outcome:
    return weak_strong(grasp, wrench).frictionless, "normal forces alone"


def _rest(grasp: Grasp) -> tuple[RationalVector | None, str]:
    found = balancing_friction(grasp)
    if found is None:
        return None, "no friction at rest, as none would balance the preloads"
    return found, "friction at rest balances the preloads" if any(found) else "no friction at rest"


def _compliance(grasp: Grasp, wrench: RationalVector) -> Outcome:
    rest, remark = _rest(grasp)
    return linear_compliance(grasp, wrench, rest_friction=rest).accepts, remark


def _slip(grasp: Grasp, wrench: RationalVector) -> Outcome:
    if len(grasp) > MOST_FOR_ALL_CHOICES:
        return None, f"not tried: 3^{len(grasp)} choices"
    rest, remark = _rest(grasp)
    return frictionless_slip(grasp, wrench, rest_friction=rest).accepts, remark


#: Every method: key, title, and how to ask it. The first one is the measure of the others.
METHODS: dict[str, tuple[str, Callable[[Grasp, RationalVector], Outcome]]] = {
    "complete": ("complete model (springs, cones, dissipation, detachment)", _complete),
    "printed": ("the paper as printed", _printed),
    "cones": ("springs and cones without dissipation", _cones),
    "wrench-space": ("Grasp Wrench Space (Ferrari, Canny 1992)", _wrench_space),
    "form-closure": ("form closure (Liu 1999)", _form_closure),
    "weak": ("weakly stable (Pang, Trinkle 2000)", _weak),
    "strong": ("strongly stable (Pang, Trinkle 2000)", _strong),
    "frictionless": ("frictionless stable (Pang, Trinkle 2000)", _frictionless),
    "linear-compliance": ("linear compliance (Bicchi 1993-95; Cutkosky, Kao 1989)", _compliance),
    "frictionless-slip": ("stick, frictionless slip, detached (Prattichizzo 1997)", _slip),
}


def ask(method: str, grasp: Grasp, wrench: RationalVector) -> bool | None:
    """Return one method's verdict, by its key in `METHODS`."""
    return METHODS[method][1](grasp, wrench)[0]


def compare(grasp: Grasp, wrench: Iterable[Any]) -> Comparison:
    """Put one question to every method.

    Args:
        grasp: contacts.
        wrench: applied force x, force y and torque.

    Returns:
        All verdicts. The compliance methods start from tangential forces that balance the
        preloads where such forces exist, and their tangential springs are as stiff as the normal
        ones.

    >>> from equilibrium.io.files import read_grasp
    >>> compare(read_grasp("paper-three-contacts"), [0, -1, 0]).disagreeing
    ('linear-compliance',)
    """
    applied = read_wrench(wrench)
    answers = [
        Answer(method, title, *decide(grasp, applied))
        for method, (title, decide) in watched(METHODS.items(), "methods")
    ]
    return Comparison(grasp, applied, tuple(answers))
