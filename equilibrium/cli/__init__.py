"""The command ``equilibrium``."""

from arrangement.console.entry import entry

main = entry("equilibrium.cli.program")
