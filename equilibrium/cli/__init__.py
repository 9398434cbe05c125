"""The command ``equilibrium``."""

from arrangement.entry import entry

main = entry("equilibrium.cli.program")
