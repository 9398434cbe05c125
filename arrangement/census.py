"""The package `arrangement.library.census` by its public name, which an import may write."""

import sys

from arrangement.library import census as package
from arrangement.library.census import *  # noqa: F403

sys.modules[__name__] = package
