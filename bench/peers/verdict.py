"""What the rows say: medians, and how often faster at what error."""

from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median

OWN = "lfpiv"

SECONDS = ("seconds", "cpu_seconds", "assembly_seconds")

# How often faster this program has to be than a peer's methods that begin like this; others are reported.
FASTER = {"SART, full volume": 15.0, "SART, active voxels": 4.0, "single pass": 10.0}

# The share of a peer's error that is allowed.
ERROR_SHARE = 0.5

# How near to its best Q a peer counts as arrived: the last hundredth may take most of the sweeps.
ARRIVED = 0.99


def median_rows(turns: list[list[dict]]) -> list[dict]:
    """One row per method from turns that list the same methods: the seconds are medians."""
    return [
        {
            **rows[0],
            **{kind: median(row[kind] for row in rows) for kind in SECONDS if kind in rows[0]},
            "runs": len(rows),
        }
        for rows in zip(*turns, strict=True)
    ]


def mean_error(row: dict) -> float:
    """Mean absolute error over the components, in voxels."""
    return sum(row["mean_abs_error_vox"]) / 3


@dataclass
class Ratio:
    """This program's row beside a peer's on the same case."""

    own: dict
    peer: dict

    @property
    def faster(self) -> float:
        return self.peer["seconds"] / self.own["seconds"]

    @property
    def faster_cpu(self) -> float | None:
        """The same in processor seconds, which a busy machine hardly changes."""
        if "cpu_seconds" in self.own:
            return self.peer["cpu_seconds"] / self.own["cpu_seconds"]
        return None

    @property
    def needed(self) -> float | None:
        return FASTER.get(kind(self.peer))

    @property
    def good_enough(self) -> bool:
        """Q at least the peer's, or at most half of its error."""
        if "q" in self.peer:
            return self.own["q"] >= self.peer["q"]
        return mean_error(self.own) <= ERROR_SHARE * mean_error(self.peer)

    @property
    def verdict(self) -> str:
        """What the bar says; it holds for one thread each, where processor seconds are fair."""
        if self.needed is None or self.own["threads"] != 1 or self.peer["threads"] != 1:
            return ""
        short = [] if (self.faster_cpu or self.faster) >= self.needed else ["speed"]
        short += [] if self.good_enough else ["Q" if "q" in self.peer else "error"]
        return f"short of {' and '.join(short)}" if short else "reached"


def kind(row: dict) -> str:
    """What a peer's method is, whatever its settings."""
    return next((kind for kind in FASTER if row["method"].startswith(kind)), row["method"])


def ratios(rows: list[dict]) -> Iterator[Ratio]:
    """Every peer at its best on a case, with each of this program's rows that it is held against.

    A peer that repeats has a curve, Q against seconds, for each of its settings. It stands there
    where it is nearly as good as it gets, over all of them, the soonest. Of this program's passes
    those count that are as good, the soonest on as many threads.
    """
    for peer in standing(rows):
        own = [row for row in rows if row["peer"] == OWN and row["case"] == peer["case"]]
        if "q" in peer:
            own = soonest_as_good(own, peer["q"])
        for row in own:
            yield Ratio(row, peer)


def standing(rows: list[dict]) -> Iterator[dict]:
    """The peers' rows that ratios are given for: without a bar, a program's setting of least error."""
    peers = [row for row in rows if row["peer"] != OWN]
    without_bar = {}
    for row in peers:
        if "q" not in row and kind(row) in FASTER:
            yield row
        elif "q" not in row:
            without_bar.setdefault((row["case"], row["peer"]), []).append(row)
    for settings in without_bar.values():
        yield min(settings, key=mean_error)
    curves = {(row["case"], kind(row)): [] for row in peers if "q" in row}
    for row in peers:
        if "q" in row:
            curves[row["case"], kind(row)].append(row)
    for curve in curves.values():
        best = max(row["q"] for row in curve)
        arrived = [row for row in curve if row["q"] >= ARRIVED * best]
        yield min(arrived, key=lambda row: row["cpu_seconds"])


def soonest_as_good(own: list[dict], q: float) -> list[dict]:
    """For every number of threads the fastest row with at least this Q; the best where none has."""
    rows = []
    for threads in sorted({row["threads"] for row in own}):
        same = [row for row in own if row["threads"] == threads]
        good = [row for row in same if row["q"] >= q]
        rows.append(
            min(good, key=lambda row: row["seconds"]) if good else max(same, key=lambda r: r["q"])
        )
    return rows
