"""The package `arrangement.library.families` by its public name, which an import may write."""

import sys

from arrangement.library import families as package
from arrangement.library.families import *  # noqa: F403

sys.modules[__name__] = package
