"""This program beside its peers on the same data in the same run: `make bench-peers`.

Every case is made once; then this program, on one thread and on all, and the peers take turns,
each in a process of its own. Writes `peers.json` (one row per method, seconds as medians) and
prints the rows and the ratios. Peers may use as many threads as they like; a row says how many
worked.
"""

import argparse
import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from table import ratios_table, rows_table
from verdict import median_rows

HERE = Path(__file__).parent
# Stands for the program, whose place the command line tells.
LFPIV = "lfpiv"


@dataclass
class Case:
    """What is exported, and what is run on it."""

    name: str
    make: list[str | Path]
    own: list[list[str]]
    peers: list[list[str]]
    turns: int


# What SART is asked for on active voxels, where a sweep takes little; on the full volume as SART is.
SART_SETTINGS = [
    [],
    ["--relaxation", "0.5"],
    ["--relaxation", "0.25"],
    ["--relaxation", "0.1"],
    ["--order", "sequential"],
    ["--signed"],
]


# Smoothing of radial basis functions: displacements are exact, so that more of it only adds error.
SMOOTHING = ("0", "0.01")


def reconstruction(name: str, turns: int = 3) -> Case:
    own = [["reconstruct", "--passes", passes] for passes in ("1", "2", "4", "8")]
    sart = [["astra_sart.py"], ["astra_sart.py", "--relaxation", "0.25"]]
    sart += [["astra_sart.py", "--active", *settings] for settings in SART_SETTINGS]
    return Case(name, [LFPIV, "peers", "export-views"], own, sart, turns)


def correlation(name: str, *make: str | Path) -> Case:
    own = [["correlate", "--passes", passes] for passes in ("3", "4")]
    openpiv = [["openpiv_correlation.py"], ["openpiv_correlation.py", "--extended"]]
    return Case(name, list(make), own, openpiv, turns=3)


def field(name: str) -> Case:
    own = [["field"], ["field", "--incompressible"]]
    functions = [
        ["rbf_interpolation.py", "--kernel", kernel, "--neighbours", neighbours, "--smoothing", by]
        for kernel in ("thin_plate_spline", "quintic")
        for neighbours in ("50", "100", "200")
        for by in SMOOTHING
    ]
    openpiv = [["openpiv_correlation.py", "--extended", "--unseen"]]
    return Case(name, [LFPIV, "peers", "export-particles"], own, functions + openpiv, turns=3)


CASES = [
    correlation("gaussian", sys.executable, HERE / "gaussian_volumes.py"),
    correlation("ring", LFPIV, "peers", "export-volumes"),
    correlation("abc", LFPIV, "peers", "export-volumes", "--reconstructed"),
    field("turbulence"),
    field("turbulence-sparse"),
    reconstruction("paper-50"),
    reconstruction("few-views"),
    reconstruction("paper-100", turns=1),  # minutes a turn
]


class Bench:
    """Runs the programs on exported cases."""

    def __init__(self, lfpiv: Path, folder: Path):
        self.lfpiv = lfpiv
        self.folder = folder

    def make(self, case: Case) -> None:
        config = HERE / "cases" / f"{case.name}.toml"
        where = ["--config", config, "--out", self.folder / case.name]
        command = [self.lfpiv if word == LFPIV else word for word in case.make]
        subprocess.run([*command, *where], check=True)

    def rows(self, case: Case) -> list[dict]:
        """One turn of all programs."""
        folder = self.folder / case.name
        rows = []
        for work in case.own:
            for threads in sorted({1, os.cpu_count() or 1}):
                environment = os.environ | {"RAYON_NUM_THREADS": str(threads)}
                command = [self.lfpiv, "peers", work[0], folder, "--repeats", "1", *work[1:]]
                rows += rows_of(command, environment)
        for script, *options in case.peers:
            rows += rows_of([sys.executable, HERE / script, folder, *options], os.environ)
        return rows


def rows_of(command: list, environment: dict) -> list[dict]:
    """The rows that a command prints."""
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", help="names of cases; all when absent")
    parser.add_argument("--lfpiv", type=Path, default=Path("target/release/lfpiv"))
    parser.add_argument("--folder", type=Path, default=Path("target/peers"))
    parser.add_argument("--turns", type=int, help="runs of which medians are taken")
    arguments = parser.parse_args()
    unknown = set(arguments.cases) - {case.name for case in CASES}
    if unknown:
        parser.error(f"no case {', '.join(sorted(unknown))}")

    bench = Bench(arguments.lfpiv.absolute(), arguments.folder)
    path = arguments.folder / "peers.json"
    rows = []
    for case in CASES:
        if not arguments.cases or case.name in arguments.cases:
            bench.make(case)
            turns = arguments.turns or case.turns
            print(f"{case.name}: {turns} turn(s)", file=sys.stderr)
            rows += median_rows([bench.rows(case) for _ in range(turns)])
            path.write_text(json.dumps(rows, indent=1) + "\n")
    print(rows_table(rows), ratios_table(rows), f"Rows in {path}", sep="\n\n")


if __name__ == "__main__":
    main()
