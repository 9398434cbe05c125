"""The methods that the paper compares with, one file each, each with a verdict of its own.

Signs follow the package: the grasp resists the wrench w when contact forces c exist with
``sum_i (c_n N_i + c_t T_i) + w = 0``, with all adhesion in w. What differs is which forces a method
lets arise. `registry` is their table, `compare` asks all of them.
"""

from .closure_friction import (
    ClosureFriction as ClosureFriction,
    closure_friction as closure_friction,
)
from .compare import (
    Answer as Answer,
    Comparison as Comparison,
    compare as compare,
    predict as predict,
    resistance_figure as resistance_figure,
)
from .force_closure import ForceClosure as ForceClosure, force_closure as force_closure
from .grasp_robustness import (
    contact_robustness as contact_robustness,
    grasp_robustness as grasp_robustness,
)
from .grasp_wrench_space import GraspWrenchSpace as GraspWrenchSpace
from .method import Method as Method
from .registry import METHODS as METHODS, method_named as method_named
