"""Sweeps that are killed, or lose a worker, end as if nothing had happened."""

import importlib.util
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from arrangement import counts, families
from arrangement.counts.orbits import in_parts
from proofs_check.errors import SweepError
from proofs_check.sweep import report as sweepreport, store

from .test_sweep import report

#: Git is kept out, so that an edit of the checkout between two runs cannot make reports differ.
ENVIRONMENT = {**os.environ, "GIT_DIR": os.devnull}


def numbers(path: Path) -> int:
    """Chunks in a store; 0 while there is none."""
    try:
        with store.read(str(path)) as opened:
            found = sweepreport.status(opened)
    except SweepError:
        return 0
    assert found["samples"] == sum(found["outcomes"].values())
    return int(found["chunks"])


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "proofs_check", *arguments]


def swept(path: Path, samples: int, *more: str) -> list[str]:
    options = ["--elements", "3..4", "--samples", str(samples), "--chunk", "10", "--seed", "5"]
    return command("sweep", "great-circle-regions", *options, "--store", str(path), *more)


def run(arguments: list[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(arguments, env=ENVIRONMENT, capture_output=True, text=True, check=False)


def wait_for(condition: Callable[[], bool], seconds: float = 60) -> None:
    limit = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < limit, "nothing happened in time"
        time.sleep(0.01)


@pytest.mark.slow
def test_killed_sweep_has_the_same_report(tmp_path):
    whole, killed = tmp_path / "whole.sqlite", tmp_path / "killed.sqlite"
    assert run(swept(whole, 800)).returncode == 0
    seen = 0
    rng = random.Random()
    for jobs in ("1", "2", "1"):
        arguments = swept(killed, 800, "--jobs", jobs)
        process = subprocess.Popen(arguments, env=ENVIRONMENT, stdout=subprocess.DEVNULL)
        wait_for(lambda: numbers(killed) > seen or process.poll() is not None)  # noqa: B023
        time.sleep(rng.random() * 0.05)
        process.kill()
        process.wait()
        there = numbers(killed)
        assert there > seen, "what was done before the kill is there"
        seen = there
    assert seen < 80, "the sweep was killed before its end"
    assert run(swept(killed, 800)).returncode == 0
    texts = []
    for path in (whole, killed):
        output = path.with_suffix(".json")
        assert run(command("report", str(path), "--output", str(output))).returncode == 0
        texts.append(output.read_bytes())
    assert texts[0] == texts[1]
    assert json.loads(texts[0])["results"][0]["complete"] is True


@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="reads the children from /proc")
def test_workers_end_with_their_parent_however_it_ends(tmp_path):
    path = tmp_path / "s.sqlite"
    process = subprocess.Popen(
        swept(path, 100_000, "--jobs", "2"), env=ENVIRONMENT, stdout=subprocess.DEVNULL
    )
    try:
        wait_for(lambda: numbers(path) > 2)
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    finally:
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert len(children) >= 2
    wait_for(lambda: not any(_alive(int(child)) for child in children), 20)


def _alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[Path, list[subprocess.Popen[bytes]]]]:
    """A scheduler and two workers, each a process of its own."""
    if not all(map(importlib.util.find_spec, ("distributed", "joblib"))):
        pytest.skip("needs the extra dask")
    place = tmp_path / "scheduler.json"
    quiet = {"env": ENVIRONMENT, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    dask = [sys.executable, "-m", "dask"]
    file = ["--scheduler-file", str(place)]
    options = ["--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--no-show"]
    processes = [subprocess.Popen([*dask, "scheduler", *options, *file], **quiet)]
    try:
        wait_for(place.exists)
        for name in ("one", "two"):
            own = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--name", name]
            folder = ["--local-directory", str(tmp_path / name)]
            worker = [*dask, "worker", *file, *own, *folder]
            processes.append(subprocess.Popen(worker, **quiet))
        yield place, processes
    finally:
        for process in processes:
            process.kill()
            process.wait()


@pytest.mark.slow
def test_a_cluster_counts_flats_in_parts(tmp_path, cluster, monkeypatch):
    monkeypatch.setattr(in_parts, "_FEW", 0)
    address = json.loads(cluster[0].read_text(encoding="utf-8"))["address"]
    for planes in (families.resonance(5), families.h4()):
        folder = tmp_path / str(len(planes))
        spread = in_parts.first_whitney_numbers_in_parts(planes, folder, dask=address)
        assert spread == counts.first_whitney_numbers(planes)


@pytest.mark.slow
def test_cluster_without_a_worker_equals_one_process(tmp_path, cluster):
    place, (_, first, second) = cluster
    whole, spread = tmp_path / "whole.sqlite", tmp_path / "spread.sqlite"
    assert run(swept(whole, 800)).returncode == 0
    address = json.loads(place.read_text(encoding="utf-8"))["address"]
    log = tmp_path / "log"
    with log.open("wb") as stream:
        process = subprocess.Popen(
            swept(spread, 800, "--dask", address), env=ENVIRONMENT, stdout=stream, stderr=stream
        )
        wait_for(lambda: numbers(spread) > 5 or process.poll() is not None)
        second.kill()
        at_kill = numbers(spread)
        assert process.wait(120) == 0, log.read_text(encoding="utf-8")
    assert first.poll() is None
    assert 5 < at_kill < 80, "the worker was killed mid-run"
    assert report(spread) == report(whole)
