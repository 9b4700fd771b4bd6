"""What `lfpiv run` leaves behind: sealed NetCDF segments, a file per shot, the configuration."""

import json

import numpy as np
import pytest
import pyvista
import xarray
from conftest import RUN_SHOTS as SHOTS


@pytest.fixture(scope="module")
def folder(run):
    return run.folder


@pytest.fixture(scope="module")
def configuration(run):
    return run.configuration


@pytest.fixture
def times(folder):
    """The time of each shot, from all segments."""
    found = {}
    for path in folder.glob("velocity_*.nc"):
        with xarray.open_dataset(path) as segment:
            shots = segment["shot"].values.tolist()
            found.update(zip(shots, segment["time"].values, strict=True))
    return found


def test_all_shots_are_in_sealed_segments(folder, configuration):
    assert not list(folder.glob("*.part"))
    shots = []
    for path in sorted(folder.glob("velocity_*.nc")):
        with xarray.open_dataset(path) as segment:
            assert segment["u"].dims == ("shot", "z", "y", "x")
            has_value = (segment["valid"] + segment["replaced"]).values == 1
            np.testing.assert_array_equal(np.isfinite(segment["u"].values), has_value)
            assert segment.attrs["configuration"] == configuration.read_text()
            shots += segment["shot"].values.tolist()
    assert len(shots) == len(set(shots)) == SHOTS


def test_the_series_names_the_shots_of_the_segments(folder):
    listed = json.loads((folder / "velocity.vti.series").read_text())["files"]
    speeds = {}
    for path in folder.glob("velocity_*.nc"):
        with xarray.open_dataset(path) as segment:
            for shot in segment["shot"].values.tolist():
                speeds[shot] = segment["u"].sel(shot=shot).values.ravel()
    assert len(listed) == len(speeds) == SHOTS
    for entry in listed:
        image = pyvista.read(folder / entry["name"])
        expected = speeds[int(entry["name"].removeprefix("shot_").removesuffix(".vti"))]
        np.testing.assert_allclose(image["velocity"][:, 0], expected, rtol=1e-5, atol=1e-7)


def test_every_shot_was_taken_during_the_run(folder, run, times):
    assert sorted(times) == list(range(SHOTS))
    ordered = [times[shot] for shot in sorted(times)]
    assert ordered == sorted(ordered)
    assert run.began < ordered[0] and ordered[-1] < run.ended
    for path in folder.glob("velocity_*.nc"):
        with xarray.open_dataset(path) as segment:
            assert (segment["time_uncertainty"] > 0).all()
            assert (segment["time_uncertainty"] < (run.ended - run.began) / np.timedelta64(1, "s")).all()
            assert "time" in segment["u"].coords
            assert segment["u"].swap_dims(shot="time").sel(time=segment["time"]).notnull().any()


def test_the_series_has_the_times_of_the_shots(folder, times):
    listed = json.loads((folder / "velocity.vti.series").read_text())["files"]
    for shot, entry in enumerate(listed):
        seconds = (times[shot] - np.datetime64(0, "s")) / np.timedelta64(1, "s")
        assert abs(entry["time"] - seconds) < 1e-6


def test_vtk_finds_the_time_of_each_shot(folder, times):
    for shot, expected in times.items():
        reader = pyvista.get_reader(folder / f"shot_{shot:06}.vti")
        [seconds] = reader.read().field_data["TimeValue"]
        expected = (expected - np.datetime64(0, "s")) / np.timedelta64(1, "s")
        assert abs(seconds - expected) < 1e-6


def test_the_ledger_has_the_time_of_what_went_wrong(folder):
    ledger = json.loads((folder / "ledger.json").read_text())
    assert all("time" in entry for entry in ledger["exceptions"])
