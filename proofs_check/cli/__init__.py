"""The command ``proofs-check``."""

from arrangement.entry import entry

main = entry("proofs_check.cli.program")
