"""Results of the real binary: simulated pairs of a uniform flow, measured, and a recorded run."""

import json
import os
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
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


RUN_SHOTS = 3


@dataclass(frozen=True)
class Run:
    """A run's folder and configuration, and when it was under way."""

    folder: Path
    configuration: Path
    began: np.datetime64
    ended: np.datetime64


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    root = tmp_path_factory.mktemp("run")
    text = CONFIG.read_text()
    assert 'dir = "results"' in text
    configuration = root / "run.toml"
    configuration.write_text(text.replace('dir = "results"', f'dir = "{root / "results"}"'))
    began = np.datetime64(time.time_ns(), "ns")
    lfpiv("run", "--config", configuration, "--shots", RUN_SHOTS)
    ended = np.datetime64(time.time_ns(), "ns")
    [series] = (root / "results").rglob("velocity.vti.series")
    return Run(series.parent, configuration, began, ended)
