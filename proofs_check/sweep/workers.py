"""Where chunks are done: processes on this machine, or a Dask cluster by way of joblib.

Results come as they are done, in any order. A worker that dies takes nothing with it but the
chunk it was at, which is then done again.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from importlib import import_module
from typing import Any, TypeVar

from arrangement.errors import MissingExtraError
from proofs_check.errors import SweepError

Result = TypeVar("Result")
#: How often in a row workers may die without any result before the sweep gives up.
_MOST_DEATHS = 3


def on_processes(
    function: Callable[[Any, int], Result], plan: Any, numbers: Sequence[int], jobs: int
) -> Iterator[Result]:
    """Yield ``function(plan, number)`` for all numbers, from processes of their own.

    The processes end when this one ends, however it ends.

    Raises:
        SweepError: workers die again and again without a result.
    """
    left = list(reversed(numbers))
    deaths = 0
    while left:
        pool = ProcessPoolExecutor(
            jobs, mp_context=multiprocessing.get_context("spawn"), initializer=_follow_parent
        )
        running: dict[Future[Result], int] = {}
        try:
            while left or running:
                while left and len(running) < 2 * jobs:
                    running[pool.submit(function, plan, left[-1])] = left[-1]
                    left.pop()
                done, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in done:
                    result = future.result()
                    del running[future]
                    deaths = 0
                    yield result
        except BrokenProcessPool:
            left += running.values()
            deaths += 1
            if deaths > _MOST_DEATHS:
                raise SweepError(
                    f"workers died {deaths} times in a row (is memory short?); "
                    "what is done is kept: run the same command again, with fewer --jobs"
                ) from None
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def _follow_parent() -> None:
    """End this process as soon as its parent is gone, even by ``kill -9``; leave Ctrl-C to it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is None:
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def on_dask(
    function: Callable[[Any, int], Result], plan: Any, numbers: Sequence[int], address: str
) -> Iterator[Result]:
    """Yield ``function(plan, number)`` for all numbers, from the workers of a Dask cluster.

    Raises:
        MissingExtraError: joblib or distributed is not installed.
        SweepError: no scheduler answers at the address.
    """
    try:
        joblib, distributed = (import_module(name) for name in ("joblib", "distributed"))
    except ImportError as error:
        raise MissingExtraError(
            f"{error.name} is not installed; pip install 'slipstates[dask]', here and on workers"
        ) from None
    try:
        client = distributed.Client(address, timeout="20s")
    except (OSError, ValueError) as error:
        raise SweepError(f"no Dask scheduler answers at {address}: {error}") from None
    with client, joblib.parallel_config(backend="dask"):
        parallel = joblib.Parallel(n_jobs=-1, batch_size=1, return_as="generator_unordered")
        yield from parallel(joblib.delayed(function)(plan, number) for number in numbers)
