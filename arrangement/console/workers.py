"""Where work in numbered parts is done: processes here, or a Dask cluster by way of joblib.

Results come as they are done, in any order. A worker that dies takes nothing with it but the
part it was at, which is then done again.
"""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import Any, TypeVar

from arrangement.errors import InputError, WorkerError, extra

Part = TypeVar("Part")
Result = TypeVar("Result")
#: How often in a row workers may die without any result before all is given up.
_MOST_DEATHS = 3
#: Processes that are asked for at once, at most.
MOST_JOBS = 1024


def part_numbers(count: int, shard: tuple[int, int], jobs: int) -> range:
    """Return the numbers below a count that a shard (i, n) is to do: every n-th from the i-th.

    Raises:
        InputError: there is no such shard, or no job.
    """
    part, parts = shard
    if not 1 <= part <= parts:
        raise InputError(f"shard is {part}/{parts}; give i/n with i from 1 to n")
    if not 1 <= jobs <= MOST_JOBS:
        raise InputError(f"jobs is {jobs}; give 1 to {MOST_JOBS} processes of this machine")
    return range(part - 1, count, parts)


def run_parts(
    function: Callable[[Any, Part], Result],
    plan: Any,
    numbers: Sequence[Part],
    jobs: int = 1,
    dask: str | None = None,
) -> Iterator[Result]:
    """Yield ``function(plan, number)`` for all numbers: here, from processes, or from a cluster."""
    if not numbers:
        return iter(())
    if dask is not None:
        return on_dask(function, plan, numbers, dask)
    if jobs == 1:
        return (function(plan, number) for number in numbers)
    return on_processes(function, plan, numbers, jobs)


def on_processes(
    function: Callable[[Any, Part], Result], plan: Any, numbers: Sequence[Part], jobs: int
) -> Iterator[Result]:
    """Yield ``function(plan, number)`` for all numbers, from processes of their own.

    The processes end when this one ends, however it ends.

    Raises:
        WorkerError: workers die again and again without a result.
    """
    # Commands that need one process alone start sooner.
    from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import get_context

    left = list(reversed(numbers))
    deaths = 0
    while left:
        pool = ProcessPoolExecutor(
            jobs, mp_context=get_context("spawn"), initializer=_follow_parent
        )
        running: dict[Future[Result], Part] = {}
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
                raise WorkerError(
                    f"workers died {deaths} times in a row (is memory short?); "
                    "what is done is kept: run the same command again, with fewer --jobs"
                ) from None
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def _follow_parent() -> None:
    """End this process as soon as its parent is gone, even by ``kill -9``; leave Ctrl-C to it."""
    from multiprocessing import parent_process

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is None:
        return

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def on_dask(
    function: Callable[[Any, Part], Result], plan: Any, numbers: Sequence[Part], address: str
) -> Iterator[Result]:
    """Yield ``function(plan, number)`` for all numbers, from the workers of a Dask cluster.

    Raises:
        MissingExtraError: joblib or distributed is not installed.
        WorkerError: no scheduler answers at the address.
    """
    with extra("dask"):
        joblib, distributed = (import_module(name) for name in ("joblib", "distributed"))
    try:
        client = distributed.Client(address, timeout="20s")
    except (OSError, ValueError) as error:
        raise WorkerError(f"no Dask scheduler answers at {address}: {error}") from None
    with client, joblib.parallel_config(backend="dask"):
        parallel = joblib.Parallel(n_jobs=-1, batch_size=1, return_as="generator_unordered")
        yield from parallel(joblib.delayed(function)(plan, number) for number in numbers)
