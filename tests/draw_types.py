"""What type checkers know of the options of views: read by `make types`, never called.

Lines with `type: ignore` must be errors: mypy reports those that ignore nothing.
"""

from typing import assert_type

from arrangement import Arrangement
from arrangement.drawing.path_artist import Drawing
from equilibrium import Grasp


def drawings() -> None:
    lines = Arrangement([[1, 0], [0, 1]])
    assert_type(lines.draw("lines", projective=True, width=90), Drawing)
    assert_type(lines.draw("sphere,dual", camera=(1, 2, 3)), Drawing)
    assert_type(Grasp().draw(wrench=[0, 1, 0]), Drawing)
    lines.draw("lattice", colours="sides")  # type: ignore[call-overload]
    lines.draw("lines", projective="yes")  # type: ignore[call-overload]
    Grasp().draw("proof")
    Grasp().draw("grasp", load=[0, 1, 0])  # type: ignore[call-overload]
