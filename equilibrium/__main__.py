"""`python -m equilibrium` is the same as the console script."""

from equilibrium.cli import main

if __name__ == "__main__":
    raise SystemExit(main())
