"""How other methods agree with the full model of springs, friction cones and detachment.

Each method is asked about random grasps and wrenches, half of the grasps with preload. Methods
that drop a condition of the model never refuse what it accepts; but all of them accept too much.

Change the numbers below for other questions. Run time: about 10 seconds.
"""

from arrangement.numbers.exact import RationalVector
from equilibrium import Grasp
from equilibrium.grasps.inputs.random import random_grasp, random_wrench
from equilibrium.methods import predict
from proofs_check import claim

SEED = 0
QUESTIONS = 20
CONTACTS = (2, 3)
#: The first drops dissipation, the others ask only whether forces in the cones exist.
RELAXED = ("cones", "wrench-space", "weak")

Question = tuple[Grasp, RationalVector]
QUESTIONS_ASKED: dict[str, Question] = {
    f"question {k}": (random_grasp(CONTACTS[k // 2 % len(CONTACTS)], k), random_wrench(k))
    for k in range(SEED, SEED + QUESTIONS)
}


def _wrong(question: Question, verdict: bool, methods: tuple[str, ...]) -> bool | str:
    """Return which methods give a verdict that the full model does not give; else True."""
    grasp, wrench = question
    if predict("complete", grasp, wrench) is verdict:
        return True
    wrong = [name for name in methods if predict(name, grasp, wrench) is verdict]
    word = "accept" if verdict else "refuse"
    contacts = "; ".join(contact.words for contact in grasp)
    load = ", ".join(map(str, wrench))
    return not wrong or f"{', '.join(wrong)} {word} the wrench ({load}) on contacts {contacts}"


@claim(
    "Methods that drop a condition of the full model accept every wrench that it accepts.",
    of=QUESTIONS_ASKED,
)
def relaxed_methods_never_refuse_wrongly(question: Question) -> bool | str:
    """Compare their refusals with the full model."""
    return _wrong(question, False, RELAXED)


@claim(
    "The full model accepts every wrench that these methods accept.",
    of=QUESTIONS_ASKED,
    expected="refuted",
)
def relaxed_methods_never_accept_wrongly(question: Question) -> bool | str:
    """Compare what they accept with the full model."""
    return _wrong(question, True, RELAXED)
