"""Velocity and volumes as xarray reads them."""

import numpy as np
import pytest
import xarray

UNITS = {
    "u": "m s-1",
    "v": "m s-1",
    "w": "m s-1",
    "u_uncertainty": "m s-1",
    "v_uncertainty": "m s-1",
    "w_uncertainty": "m s-1",
    "valid": "1",
    "replaced": "1",
    "peak_ratio": "1",
    "vorticity_x": "s-1",
    "vorticity_y": "s-1",
    "vorticity_z": "s-1",
    "divergence": "s-1",
}
STAGES = ["decode_seconds", "reconstruct_seconds", "correlate_seconds"]


@pytest.fixture
def velocity(measured):
    with xarray.open_dataset(measured.file(0, "velocity.nc")) as dataset:
        yield dataset


@pytest.fixture
def volumes(measured):
    with xarray.open_dataset(measured.file(0, "volumes.nc")) as dataset:
        yield dataset


def test_every_variable_has_its_dimensions_and_units(velocity):
    for name, units in UNITS.items():
        assert velocity[name].dims == ("shot", "z", "y", "x"), name
        assert velocity[name].attrs["units"] == units, name
        assert velocity[name].attrs["long_name"], name
    for name in STAGES:
        assert velocity[name].dims == ("shot",), name
        assert velocity[name].attrs["units"] == "s", name
        assert (velocity[name] > 0).all(), name
    for axis in "xyz":
        assert velocity[axis].attrs["units"] == "mm", axis
    assert float(velocity["dt"]) == 1e-4
    assert velocity["dt"].attrs["units"] == "s"


def test_windows_lie_in_the_volume_half_a_window_apart(velocity):
    half_edges_mm = {"x": 1.2, "y": 1.0, "z": 0.8}
    for axis, half_edge_mm in half_edges_mm.items():
        centres_mm = velocity[axis].values
        assert len(centres_mm) > 1, axis
        assert np.abs(centres_mm).max() <= half_edge_mm, axis
        np.testing.assert_allclose(np.diff(centres_mm), 0.4, rtol=1e-6)


def test_nothing_is_nan_and_flags_are_zero_or_one(velocity):
    for name in UNITS:
        assert np.isfinite(velocity[name].values).all(), name
    for name in ["valid", "replaced"]:
        assert np.issubdtype(velocity[name].dtype, np.integer), name
        assert set(np.unique(velocity[name])) <= {0, 1}, name
    assert not (velocity["valid"] & velocity["replaced"]).any()


def test_the_simulated_flow_is_measured(velocity, measured):
    expected = measured.truth(0)["flow"]["velocity_m_s"]
    valid = velocity["valid"].values == 1
    assert valid.mean() > 0.5
    for name, speed in zip("uvw", expected):
        # One voxel between the pulses is 1 m/s.
        assert abs(np.median(velocity[name].values[valid]) - speed) < 0.15, name


def test_the_file_says_how_it_was_made(velocity, configuration):
    assert velocity.attrs["Conventions"].startswith("CF-")
    assert velocity.attrs["configuration"] == configuration
    assert velocity.attrs["code_version"].startswith("lfpiv ")
    assert "lfpiv" in velocity.attrs["history"]


def test_volumes_have_the_voxels_of_the_configuration(volumes):
    assert dict(volumes.sizes) == {"z": 16, "y": 20, "x": 24}
    for name in ["a", "b"]:
        assert volumes[name].dims == ("z", "y", "x")
        assert np.isfinite(volumes[name].values).all()
        assert (volumes[name] >= 0).all()
    np.testing.assert_allclose(volumes["x"].values, (np.arange(24) - 11.5) * 0.1, atol=1e-9)
    assert volumes["z"].attrs["units"] == "mm"


@pytest.mark.parametrize("frame", ["a", "b"])
def test_there_is_light_where_the_particles_are(volumes, measured, frame):
    lit = [p for p in measured.truth(0)["particles"] if p[f"visible_{frame}"]]
    x, y, z = np.array([p[f"{frame}_mm"] for p in lit]).T
    at = {axis: xarray.DataArray(mm, dims="particle") for axis, mm in zip("xyz", (x, y, z))}
    there = volumes[frame].sel(at, method="nearest").mean()
    assert there > 3 * volumes[frame].mean()
