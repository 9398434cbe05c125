"""Files with claims, to run with ``proofs-check run`` and to copy from."""
