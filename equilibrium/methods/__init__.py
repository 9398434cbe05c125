"""The methods that the paper compares with, one file each, each with a verdict of its own.

Signs follow the package: the grasp resists the wrench w when contact forces c exist with
``sum_i (c_n N_i + c_t T_i) + w = 0``. What differs is which forces a method lets arise. `registry`
is their table, `compare` asks all of them, `survey` counts how often they disagree.
"""

from .compare import Answer, Comparison, ask, compare
from .friction_cones.grasp_wrench_space import GraspWrenchSpace
from .method import Method
from .registry import METHODS, method_named
from .survey import resistance_figure, smallest_examples, survey

__all__ = [
    "METHODS",
    "Answer",
    "Comparison",
    "GraspWrenchSpace",
    "Method",
    "ask",
    "compare",
    "method_named",
    "resistance_figure",
    "smallest_examples",
    "survey",
]
