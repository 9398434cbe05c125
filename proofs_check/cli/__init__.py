"""The command ``proofs-check``."""

from arrangement.console.entry import entry

main = entry("proofs_check.cli.program")
