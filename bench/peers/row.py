"""One line of the comparison, as `lfpiv peers` prints its own."""

import json
import resource
import time
from collections.abc import Callable
from dataclasses import dataclass


@dataclass
class Cost:
    """Wall-clock and processor seconds of some work."""

    seconds: float
    cpu_seconds: float

    def __add__(self, more: "Cost") -> "Cost":
        return Cost(self.seconds + more.seconds, self.cpu_seconds + more.cpu_seconds)

    @property
    def threads(self) -> int:
        """Threads that worked at a time, as seen from outside."""
        return max(1, round(self.cpu_seconds / self.seconds))


def timed(work: Callable[[], object]) -> tuple[object, Cost]:
    """The result of `work` and what it cost."""
    wall, cpu = time.perf_counter(), time.process_time()
    result = work()
    return result, Cost(time.perf_counter() - wall, time.process_time() - cpu)


def peak_mb() -> float:
    """Largest resident memory of this process so far, in MB of 10⁶ bytes."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6


def print_row(**row) -> None:
    """Prints a row as one line of JSON."""
    print(json.dumps(row))
