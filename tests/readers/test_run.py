"""What `lfpiv run` leaves behind: sealed NetCDF segments, a file per shot, the configuration."""

import json

import numpy as np
import pytest
import pyvista
import xarray
from conftest import CONFIG, lfpiv

SHOTS = 2


@pytest.fixture(scope="module")
def configuration(tmp_path_factory):
    folder = tmp_path_factory.mktemp("run")
    text = CONFIG.read_text()
    assert 'dir = "results"' in text
    path = folder / "run.toml"
    path.write_text(text.replace('dir = "results"', f'dir = "{folder / "results"}"'))
    return path


@pytest.fixture(scope="module")
def folder(configuration):
    lfpiv("run", "--config", configuration, "--shots", SHOTS)
    [series] = (configuration.parent / "results").rglob("velocity.vti.series")
    return series.parent


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
    assert sorted(entry["time"] for entry in listed) == sorted(speeds)
    for entry in listed:
        image = pyvista.read(folder / entry["name"])
        expected = speeds[entry["time"]]
        np.testing.assert_allclose(image["velocity"][:, 0], expected, rtol=1e-5, atol=1e-7)
