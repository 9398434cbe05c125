"""`python -m proofs_check` is the same as the console script."""

from proofs_check.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
