"""Does one more finger ever harm? A starting file for a claim about grasps.

Run it, look at the counterexample if there is one, and find a hypothesis that makes the claim true:
no friction, no preload, a finger that touches only. Then prove it.
"""

from equilibrium import Grasp, solve
from proofs_check import claim

WRENCH = (0, 1, 0)


@claim(
    "A grasp that resists a pull of 1 upwards without its last contact resists it with it too.",
    of="grasp",
    when=lambda grasp: len(grasp) > 1 and solve(Grasp(grasp.contacts[:-1]), WRENCH).stable,
    hypotheses=["it resists the pull without its last contact"],
    planes=(2, 4),
    samples=80,
    expected="refuted",
)
def one_more_finger(grasp: Grasp) -> bool | str:
    """Friction at the other contacts may not be able to take what the new finger pushes."""
    return solve(grasp, WRENCH).stable or "with the last contact it is not resisted"
