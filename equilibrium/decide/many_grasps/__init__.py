"""Many grasps at once: float arrays in, arrays of proved answers out.

* `check`: the function `check_grasps` and its result.
* `tables`: files of grasps, loads and answers.
* `arrays`: reads the arrays; `questions`: all numbers of questions, with bounds of their errors.
* `equilibria`: equilibria found in floats, and proofs that one is near.
* `refutations`: proofs in floats that there is none.
"""

from .check import CheckedGrasps as CheckedGrasps, check_grasps as check_grasps
