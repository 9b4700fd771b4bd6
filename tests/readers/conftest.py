"""Results of the real binary: two simulated pairs of a uniform flow, measured."""

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CONFIG = ROOT / "tests" / "data" / "small.toml"
BINARY = ROOT / os.environ.get("LFPIV", "target/debug/lfpiv")


def lfpiv(*arguments):
    """Runs the binary and shows what it said when it fails."""
    done = subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


@dataclass(frozen=True)
class Measured:
    """Folders of the simulated pairs and of their results."""

    pairs: Path
    results: Path

    def truth(self, shot):
        """The simulated particles of one shot and their flow."""
        return json.loads((self.pairs / f"shot_{shot:04}" / "truth.json").read_text())

    def file(self, shot, name):
        """A result file of one shot."""
        return self.results / f"shot_{shot:04}" / name


@pytest.fixture(scope="session")
def measured(tmp_path_factory):
    root = tmp_path_factory.mktemp("measured")
    pairs, results = root / "pairs", root / "results"
    lfpiv("simulate", "--config", CONFIG, "--out", pairs, "--shots", 2, "--seed", 5)
    lfpiv("process", "--config", CONFIG, "--out", results, "--save-volumes", pairs)
    return Measured(pairs, results)


@pytest.fixture(scope="session")
def configuration():
    return CONFIG.read_text()
