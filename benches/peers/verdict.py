"""What the rows say: medians, and how often faster at what error."""

from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median

OWN = "lfpiv"

SECONDS = ("seconds", "cpu_seconds", "assembly_seconds")

# Of a peer's method, how often faster this program has to be.
FASTER = {
    ("ASTRA", "SART, full volume"): 15.0,
    ("ASTRA", "SART, active voxels"): 4.0,
    ("OpenPIV", "single pass"): 10.0,
}

# The share of a peer's error that is allowed.
ERROR_SHARE = 0.5


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
    def needed(self) -> float:
        return FASTER[self.peer["peer"], self.peer["method"]]

    @property
    def good_enough(self) -> bool:
        """Q at least the peer's, or at most half of its error."""
        if "q" in self.peer:
            return self.own["q"] >= self.peer["q"]
        return mean_error(self.own) <= ERROR_SHARE * mean_error(self.peer)

    @property
    def verdict(self) -> str:
        """What the bar says; it holds for one thread each, where processor seconds are fair."""
        if self.own["threads"] != 1 or self.peer["threads"] != 1:
            return ""
        short = [] if (self.faster_cpu or self.faster) >= self.needed else ["speed"]
        short += [] if self.good_enough else ["Q" if "q" in self.peer else "error"]
        return f"short of {' and '.join(short)}" if short else "reached"


def ratios(rows: list[dict]) -> Iterator[Ratio]:
    """Every peer's row with each of this program's on the same case."""
    for peer in rows:
        if peer["peer"] != OWN:
            for own in rows:
                if own["peer"] == OWN and own["case"] == peer["case"]:
                    yield Ratio(own, peer)
