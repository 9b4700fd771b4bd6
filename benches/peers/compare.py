"""This program beside its peers on the same data in the same run: `make bench-peers`.

Every case is exported once; then this program, on one thread and on all, and the peers take turns,
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


@dataclass
class Case:
    """What is exported, and what is run on it."""

    name: str
    export: list[str]
    own: list[list[str]]
    peers: list[list[str]]
    turns: int


def reconstruction(name: str, turns: int = 3) -> Case:
    sart = ["astra_sart.py"]
    return Case(name, ["export-views"], [["reconstruct"]], [sart, [*sart, "--active"]], turns)


def correlation(name: str, *options: str) -> Case:
    own = [["correlate", "--passes", passes] for passes in ("3", "4")]
    return Case(name, ["export-volumes", *options], own, [["openpiv_correlation.py"]], turns=3)


CASES = [
    correlation("ring"),
    correlation("abc", "--reconstructed"),
    reconstruction("paper-50"),
    reconstruction("few-views"),
    reconstruction("paper-100", turns=1),  # minutes a turn
]


class Bench:
    """Runs the programs on exported cases."""

    def __init__(self, lfpiv: Path, folder: Path):
        self.lfpiv = lfpiv
        self.folder = folder

    def export(self, case: Case) -> None:
        config = HERE / "cases" / f"{case.name}.toml"
        where = ["--config", config, "--out", self.folder / case.name]
        subprocess.run([self.lfpiv, "peers", *case.export, *where], check=True)

    def rows(self, case: Case) -> list[dict]:
        """One turn of all programs."""
        folder = self.folder / case.name
        rows = []
        for work in case.own:
            for threads in sorted({1, os.cpu_count() or 1}):
                environment = os.environ | {"RAYON_NUM_THREADS": str(threads)}
                command = [self.lfpiv, "peers", work[0], folder, "--repeats", "1", *work[1:]]
                rows.append(row_of(command, environment))
        for script, *options in case.peers:
            rows.append(row_of([sys.executable, HERE / script, folder, *options], os.environ))
        return rows


def row_of(command: list, environment: dict) -> dict:
    """The row that a command prints."""
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout)


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
            bench.export(case)
            turns = arguments.turns or case.turns
            print(f"{case.name}: {turns} turn(s)", file=sys.stderr)
            rows += median_rows([bench.rows(case) for _ in range(turns)])
            path.write_text(json.dumps(rows, indent=1) + "\n")
    print(rows_table(rows), ratios_table(rows), f"Rows in {path}", sep="\n\n")


if __name__ == "__main__":
    main()
