"""Every NetCDF file against the CF conventions that it names, by the IOOS compliance checker."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import lfpiv


def mistakes(path, tmp_path):
    """What the checker finds fault with, requirement or recommendation."""
    report = tmp_path / "report.json"
    checker = Path(sys.executable).with_name("compliance-checker")
    command = [checker, "--test", "cf:1.11"]
    command += ["--format", "json", "--output", str(report), str(path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert report.exists(), done.stdout + done.stderr
    [results] = json.loads(report.read_text()).values()
    return [message for entry in results["all_priorities"] for message in entry["msgs"]]


@pytest.mark.parametrize("name", ["velocity.nc", "volumes.nc"])
def test_the_files_of_a_pair_keep_the_conventions(name, measured, tmp_path):
    assert mistakes(measured.file(0, name), tmp_path) == []


def test_the_segments_of_a_run_keep_the_conventions(run, tmp_path):
    segments = list(run.folder.glob("velocity_*.nc"))
    assert segments
    for segment in segments:
        assert mistakes(segment, tmp_path) == [], segment


def test_statistics_keep_the_conventions(run, tmp_path):
    lfpiv("statistics", run.folder, "--out", tmp_path / "statistics.nc")
    assert mistakes(tmp_path / "statistics.nc", tmp_path) == []
