"""Velocity and volumes as xarray reads them."""

import numpy as np
import pytest
import xarray
from conftest import CONFIG, lfpiv

UNITS = {
    "u": "m s-1",
    "v": "m s-1",
    "w": "m s-1",
    "u_uncertainty": "m s-1",
    "v_uncertainty": "m s-1",
    "w_uncertainty": "m s-1",
    "valid": "1",
    "replaced": "1",
    "masked": "1",
    "peak_ratio": "1",
    "vorticity_x": "s-1",
    "vorticity_y": "s-1",
    "vorticity_z": "s-1",
    "divergence": "s-1",
}
STAGES = ["decode_seconds", "reconstruct_seconds", "correlate_seconds", "judge_seconds"]


@pytest.fixture
def velocity(measured):
    with xarray.open_dataset(measured.file(0, "velocity.nc")) as dataset:
        yield dataset


@pytest.fixture
def volumes(measured):
    with xarray.open_dataset(measured.file(0, "volumes.nc")) as dataset:
        yield dataset


@pytest.fixture(scope="module")
def half_dark(measured, tmp_path_factory):
    """A shot whose volumes have light on one side only, correlated again."""
    folder = tmp_path_factory.mktemp("half_dark")
    with xarray.open_dataset(measured.file(0, "volumes.nc")) as volumes:
        volumes.where(volumes["x"] < 0, 0.0).to_netcdf(folder / "volumes.nc")
    lfpiv("correlate", "--config", CONFIG, "--out", folder / "out", folder / "volumes.nc")
    with xarray.open_dataset(folder / "out" / "velocity.nc") as dataset:
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
    assert velocity["dt"].dims == ("shot",)
    assert velocity["dt"].values.tolist() == [1e-4]
    assert velocity["dt"].attrs["units"] == "s"


def test_windows_lie_in_the_volume_half_a_window_apart(velocity):
    half_edges_mm = {"x": 1.2, "y": 1.0, "z": 0.8}
    for axis, half_edge_mm in half_edges_mm.items():
        centres_mm = velocity[axis].values
        assert len(centres_mm) > 1, axis
        assert np.abs(centres_mm).max() <= half_edge_mm, axis
        np.testing.assert_allclose(np.diff(centres_mm), 0.4, rtol=1e-6)


def test_what_is_missing_is_nan_and_nothing_else(velocity):
    has_value = (velocity["valid"] + velocity["replaced"]).values == 1
    for name in [f"{c}{kind}" for c in "uvw" for kind in ["", "_uncertainty"]]:
        assert np.isnan(velocity[name].encoding["_FillValue"]), name
        np.testing.assert_array_equal(np.isfinite(velocity[name].values), has_value, name)
    known = np.isfinite(velocity["divergence"].values)
    for axis in "xyz":
        spin = velocity[f"vorticity_{axis}"].values
        np.testing.assert_array_equal(np.isfinite(spin), known, axis)
    assert not (known & ~has_value).any()
    assert np.isfinite(velocity["peak_ratio"].values).all()


def test_a_mean_leaves_out_what_is_missing(half_dark):
    for name in "uvw":
        values = half_dark[name].values
        missing = np.isnan(values)
        assert 0.2 < missing.mean() < 0.8, name
        expected = values[~missing].mean()
        np.testing.assert_allclose(float(half_dark[name].mean()), expected, rtol=1e-5)


def test_flags_are_zero_or_one(velocity):
    for name in ["valid", "replaced", "masked"]:
        assert np.issubdtype(velocity[name].dtype, np.integer), name
        assert set(np.unique(velocity[name])) <= {0, 1}, name
    assert not (velocity["valid"] & velocity["replaced"]).any()
    assert not velocity["masked"].any(), "there is no mask"


def test_the_simulated_flow_is_measured(velocity, measured):
    expected = measured.truth(0)["flow"]["velocity_m_s"]
    valid = velocity["valid"].values == 1
    assert valid.mean() > 0.5
    for name, speed in zip("uvw", expected):
        # One voxel between the pulses is 1 m/s.
        assert abs(np.median(velocity[name].values[valid]) - speed) < 0.15, name


def test_an_imported_pair_has_a_time_that_is_missing(velocity):
    assert velocity["time"].dims == ("shot",)
    assert np.issubdtype(velocity["time"].dtype, np.datetime64)
    assert np.isnat(velocity["time"].values).all()
    assert np.isnan(velocity["time_uncertainty"].values).all()
    assert velocity["time"].attrs["standard_name"] == "time"
    # A coordinate that is missing would take its data with it.
    assert "time" not in velocity["u"].coords


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
