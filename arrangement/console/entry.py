"""What the console scripts start: a program whose fault, even at import, is never a "no"."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib import import_module

#: EX_SOFTWARE of sysexits.h: a fault must never look like a "no".
FAULT = 70
#: What a shell reports for a program that SIGINT ended (128 + the signal's number).
INTERRUPTED = 130


def entry(module: str) -> Callable[..., int]:
    """Return the function ``main`` of a module, which is imported when it is called."""

    def main(argv: Sequence[str] | None = None) -> int:
        # Before numpy is imported: on a busy machine threads for small matrices wait for each
        # other a hundred times as long as they work. For more cores there is --jobs.
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
        try:
            program = import_module(module).main
        except KeyboardInterrupt:
            return INTERRUPTED
        except Exception as error:
            return fault(error, argv)
        code: int = program(argv)
        return code

    return main


def fault(error: BaseException, argv: Sequence[str] | None) -> int:
    """Report an unexpected error on stderr, with ``--traceback`` in full; return 70."""
    what = "".join(c if c.isprintable() else " " for c in str(error)[:120])
    text = (
        f"error: internal error, no answer: {type(error).__name__}: {what}; please report "
        "it with the command, see CONTRIBUTING.md (--traceback shows where)"
    )
    if isinstance(error, ModuleNotFoundError):
        text = f"error: no answer: the module {error.name} is missing; install slipstates again"
    if sys.stderr is not None:
        with suppress(OSError):  # it is full or closed
            if "--traceback" in (sys.argv if argv is None else argv):
                import traceback

                traceback.print_exc()
            print(text, file=sys.stderr)
    return FAULT


main = entry("arrangement.cli")
