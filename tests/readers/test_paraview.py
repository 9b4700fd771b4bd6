"""ParaView's files as VTK reads them, beside the NetCDF of the same shot."""

import json

import numpy as np
import pytest
import pyvista
import xarray


@pytest.fixture(params=[0, 1])
def both(request, measured):
    image = pyvista.read(measured.file(request.param, "velocity.vti"))
    with xarray.open_dataset(measured.file(request.param, "velocity.nc")) as dataset:
        yield image, dataset.isel(shot=0)


def flat(variable):
    """A variable in VTK's order of points: x fastest."""
    return variable.transpose("z", "y", "x").values.ravel()


def test_points_are_the_window_centres(both):
    image, dataset = both
    assert image.dimensions == tuple(dataset.sizes[axis] for axis in "xyz")
    for column, axis in enumerate("xyz"):
        centres_mm = flat(dataset[axis].broadcast_like(dataset["u"]))
        np.testing.assert_allclose(1e3 * image.points[:, column], centres_mm, atol=1e-6)


def test_vectors_and_flags_are_those_of_the_netcdf_file(both):
    image, dataset = both
    for column, name in enumerate("uvw"):
        speeds = flat(dataset[name])
        np.testing.assert_allclose(image["velocity"][:, column], speeds, rtol=1e-5, atol=1e-7)
        doubt = flat(dataset[f"{name}_uncertainty"])
        assert (doubt[np.isfinite(doubt)] > 0).all()
        found = image["velocity_uncertainty"][:, column]
        np.testing.assert_allclose(found, doubt, rtol=1e-5)
        # Voxels of 0.1 mm, 100 us: 1 m/s is one voxel.
        displacement = image["displacement_vox"][:, column]
        np.testing.assert_allclose(displacement, speeds, rtol=1e-5, atol=1e-7)
        spin = flat(dataset[f"vorticity_{'xyz'[column]}"])
        np.testing.assert_allclose(image["vorticity_per_s"][:, column], spin, rtol=1e-4, atol=1e-3)
    for name in ["valid", "replaced", "masked", "peak_ratio"]:
        np.testing.assert_array_equal(image[name], flat(dataset[name]))


def test_invalid_vectors_are_hidden_and_nan(both):
    image, dataset = both
    invalid = flat(dataset["valid"] + dataset["replaced"]) == 0
    np.testing.assert_array_equal(image["vtkGhostType"] != 0, invalid)
    np.testing.assert_array_equal(np.isnan(image["velocity"]).all(axis=1), invalid)


def test_the_file_says_where_it_comes_from(both, configuration):
    image, dataset = both
    assert image.field_data["dt_s"][0] == dataset["dt"].item()
    assert image.field_data["source"][0] == dataset.attrs["source"]
    assert image.field_data["configuration"][0] == configuration


def test_the_series_opens_every_shot(measured):
    series = measured.results / "velocity.vti.series"
    listed = json.loads(series.read_text())
    assert listed["file-series-version"] == "1.0"
    assert [entry["time"] for entry in listed["files"]] == [0.0, 1.0]
    for entry in listed["files"]:
        image = pyvista.read(series.parent / entry["name"])
        assert image.n_points > 0
