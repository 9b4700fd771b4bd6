"""`lfpiv statistics` beside numpy, on the vectors of the same run."""

import numpy as np
import pytest
import xarray
from conftest import RUN_SHOTS, lfpiv

COMPONENTS = "uvw"


@pytest.fixture(scope="module")
def statistics(run, tmp_path_factory):
    path = tmp_path_factory.mktemp("statistics") / "statistics.nc"
    said = lfpiv("statistics", run.folder, "--out", path)
    assert f"{RUN_SHOTS} shots" in said and "standard uncertainty" in said
    with xarray.open_dataset(path) as dataset:
        yield dataset


@pytest.fixture(scope="module")
def valid(run):
    with xarray.open_mfdataset(str(run.folder / "velocity_*.nc")) as dataset:
        yield dataset.load().where(dataset["valid"] == 1)


def test_only_valid_vectors_are_counted(statistics, valid):
    np.testing.assert_array_equal(statistics["samples"], valid["u"].notnull().sum("shot"))
    assert statistics["samples"].max() == statistics["shots"] == RUN_SHOTS


def test_means_and_stresses_are_those_of_numpy(statistics, valid):
    enough = statistics["samples"].values >= 2
    assert enough.any()
    for name in COMPONENTS:
        mean = valid[name].mean("shot").values[enough]
        np.testing.assert_allclose(statistics[f"{name}_mean"].values[enough], mean, rtol=1e-5)
    # A stress has an interval where it has a value without each of the shots.
    enough = statistics["samples"].values >= 3
    assert enough.any()
    for one, other in ["uu", "vv", "ww", "uv", "uw", "vw"]:
        apart = [valid[c] - valid[c].mean("shot") for c in (one, other)]
        expected = (apart[0] * apart[1]).sum("shot") / (statistics["samples"].values - 1)
        if one == other:
            expected = expected - (valid[f"{one}_uncertainty"] ** 2).mean("shot")
        found = statistics[one + other].values[enough]
        np.testing.assert_allclose(found, expected.values[enough], rtol=1e-4, atol=1e-9)


def test_intervals_hold_both_parts(statistics):
    mean, interval = statistics["u_mean"], statistics["u_mean_interval"]
    known = mean.notnull().values
    assert (interval.isel(bound=0) <= mean).values[known].all()
    assert (interval.isel(bound=1) >= mean).values[known].all()
    parts = [statistics[f"u_mean_uncertainty_{part}"] for part in ["flow", "measurement"]]
    whole = np.hypot(*parts).values[known]
    np.testing.assert_allclose(statistics["u_mean_uncertainty"].values[known], whole, rtol=1e-5)


def test_spectra_and_correlations_have_their_axes(statistics):
    for axis in "xyz":
        lags = statistics[f"separation_{axis}"]
        assert lags.sizes[f"separation_{axis}"] == statistics.sizes[axis]
        assert statistics[f"spectrum_{axis}"].attrs["units"] == "m2 s-2 mm rad-1"
        assert np.isfinite(statistics[f"spectrum_{axis}"]).all()
