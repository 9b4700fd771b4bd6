"""Particles placed in the images, as xarray and VTK read them, beside those that were simulated."""

import numpy as np
import pytest
import pyvista
import xarray

from conftest import CONFIG, lfpiv


@pytest.fixture(scope="module")
def placed(tmp_path_factory, measured):
    root = tmp_path_factory.mktemp("placed")
    text = CONFIG.read_text()
    assert "[velocimetry]\n" in text
    configuration = root / "placed.toml"
    configuration.write_text(text.replace("[velocimetry]\n", "[velocimetry]\nplace_particles = true\n"))
    pair = measured.pairs / "shot_0000"
    lfpiv("process", "--config", configuration, "--out", root / "results", pair)
    [file] = (root / "results").rglob("particles.nc")
    return file


def test_particles_are_near_those_that_were_simulated(placed, measured):
    truth = measured.truth(0)["particles"]
    lit = [p for p in truth if p["visible_a"] and p["visible_b"]]
    places = np.array([(np.array(p["a_mm"]) + p["b_mm"]) / 2 for p in lit])
    with xarray.open_dataset(placed) as dataset:
        assert dataset.attrs["featureType"] == "point"
        valid = dataset.isel(particle=dataset["valid"].values == 1)
        found = np.stack([valid[axis].values for axis in "xyz"], axis=1)
        assert len(found) > 0.5 * len(lit)
        near = np.linalg.norm(found[:, None] - places, axis=2).min(axis=1)
        # Voxels of 0.1 mm. All of so small a volume is near a focal plane.
        assert np.median(near) < 0.05
        for name in ["x", "y", "z", "u", "v", "w"]:
            assert (dataset[f"{name}_uncertainty"] > 0).all()
            assert dataset[name].attrs["ancillary_variables"] == f"{name}_uncertainty"
        assert dataset["light"].dims == ("particle", "camera")


def test_paraview_reads_the_same_particles(placed):
    points = pyvista.read(placed.with_suffix(".vtp"))
    with xarray.open_dataset(placed) as dataset:
        assert points.n_points == points.n_verts == dataset.sizes["particle"]
        for column, (place, speed) in enumerate(zip("xyz", "uvw")):
            np.testing.assert_allclose(1e3 * points.points[:, column], dataset[place], atol=1e-5)
            np.testing.assert_allclose(points["velocity"][:, column], dataset[speed], rtol=1e-5, atol=1e-6)
        np.testing.assert_array_equal(points["valid"], dataset["valid"])
