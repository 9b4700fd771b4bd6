"""One line of the comparison, as `lfpiv peers` prints its own."""

import json
import resource
import time
from collections.abc import Callable
from dataclasses import dataclass


@dataclass
class Stopwatch:
    """Wall-clock seconds of some work, and the threads that worked at a time."""

    seconds: float
    threads: int


def timed(work: Callable[[], object]) -> tuple[object, Stopwatch]:
    """The result of `work` and what it took."""
    wall, cpu = time.perf_counter(), time.process_time()
    result = work()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    return result, Stopwatch(wall, max(1, round(cpu / wall)))


def peak_mb() -> float:
    """Largest resident memory of this process so far, in MB of 10⁶ bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6


def print_row(**row) -> None:
    """Prints a row as one line of JSON."""
    print(json.dumps(row))
