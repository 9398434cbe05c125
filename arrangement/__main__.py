"""`python -m arrangement` is the same as the console script."""

from .console.entry import main

if __name__ == "__main__":
    raise SystemExit(main())
