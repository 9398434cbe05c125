"""The package `equilibrium.grasps.inputs` by its public name, which an import may write."""

import sys

from equilibrium.grasps import inputs as package
from equilibrium.grasps.inputs import *  # noqa: F403

sys.modules[__name__] = package
