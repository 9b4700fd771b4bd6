"""Particles placed in the images, as xarray and VTK read them, beside those that were simulated."""

import shutil

import numpy as np
import pytest
import pyvista
import xarray

from conftest import CONFIG, lfpiv
from test_conventions import mistakes


SHOTS = 3


@pytest.fixture(scope="module")
def configuration(tmp_path_factory):
    root = tmp_path_factory.mktemp("placed")
    text = CONFIG.read_text()
    for old, new in [
        ("place_particles = false", "place_particles = true"),
        ('dir = "results"', f'dir = "{root / "runs"}"'),
        # Placing takes longer than the time between shots: none shall be shed.
        ("rate_hz = 10.0", "rate_hz = 1.0"),
    ]:
        assert old in text
        text = text.replace(old, new)
    path = root / "placed.toml"
    path.write_text(text)
    return path


@pytest.fixture(scope="module")
def run(configuration):
    lfpiv("run", "--config", configuration, "--shots", SHOTS)
    [folder] = (configuration.parent / "runs").iterdir()
    return folder


def particles_of(run):
    """All particles of a run, as docs/commands.md reads them."""
    files = sorted(run.glob("particles_*.nc"))
    with xarray.open_mfdataset(
        files, combine="nested", concat_dim="particle", drop_variables=["record_shot", "row_size"]
    ) as dataset:
        return dataset.load()


@pytest.fixture(scope="module")
def placed(configuration, measured):
    root = configuration.parent
    pair = measured.pairs / "shot_0000"
    said = lfpiv("process", "--config", configuration, "--out", root / "results", pair)
    [file] = (root / "results").rglob("particles.nc")
    with xarray.open_dataset(file) as dataset:
        assert f"through {dataset.sizes['particle']} particles in the images" in said
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


def test_a_run_keeps_the_particles_of_its_shots_beside_its_vectors(run):
    names = [path.name.replace("velocity", "particles") for path in sorted(run.glob("velocity_*.nc"))]
    assert [path.name for path in sorted(run.glob("particles_*.nc"))] == names
    dataset = particles_of(run)
    assert dataset.attrs["featureType"] == "point"
    assert sorted(set(dataset["shot"].values)) == list(range(SHOTS))
    assert dataset["time"].dims == ("particle",) and dataset["time"].notnull().all()
    assert {"time", "x", "y", "z"} <= set(dataset["u"].coords)
    with xarray.open_mfdataset(str(run / "velocity_*.nc")) as vectors:
        for shot, of_shot in dataset.groupby("shot"):
            assert (of_shot["time"] == vectors["time"].sel(shot=shot)).all()
    # The flow is uniform. The median of one shot, all of it near a focal plane, is off by up to 0.1 m/s along v or w.
    valid = dataset.isel(particle=dataset["valid"].values == 1)
    for name, speed in zip("uvw", [1.0, -0.5, 0.25]):
        assert abs(float(valid[name].median()) - speed) < 0.05
    for path in run.glob("particles_*.nc"):
        with xarray.open_dataset(path) as one:
            rows = one["shot"].values
            np.testing.assert_array_equal(np.repeat(one["record_shot"], one["row_size"]), rows)


def test_files_of_particles_keep_the_conventions(run, placed, tmp_path):
    # Those of a run have times, those of imported images none.
    for path in [*run.glob("particles_*.nc"), placed]:
        assert mistakes(path, tmp_path) == [], path


def without_results(run, to):
    """A copy of a run that has its record only."""
    results = shutil.ignore_patterns("velocity*", "particles*", "shot_*")
    return shutil.copytree(run, to, ignore=results)


def test_particles_measured_later_are_the_same(run, tmp_path):
    again = without_results(run, tmp_path / "again")
    lfpiv("process", again)
    in_parts = without_results(run, tmp_path / "in_parts")
    for part in [1, 2]:
        lfpiv("process", in_parts, "--part", f"{part}/2", "--out", in_parts / "parts" / str(part))
    lfpiv("process", in_parts, "--merge")
    lfpiv("replay", run, "--out", tmp_path / "replayed")
    [replayed] = (tmp_path / "replayed").iterdir()
    expected = particles_of(run).sortby("shot")
    for other in [again, in_parts, replayed]:
        xarray.testing.assert_equal(particles_of(other).sortby("shot"), expected)
        assert "0 different" in lfpiv("compare", run, other)


def test_paraview_opens_the_particles_of_a_run_as_an_animation(run, tmp_path):
    lfpiv("export", run, "--format", "paraview", "--out", tmp_path)
    reader = pyvista.get_reader(tmp_path / "particles.pvd")
    assert reader.number_time_points == SHOTS
    dataset = particles_of(run)
    times = np.unique(dataset["time"])
    for number, shot in enumerate(sorted(set(dataset["shot"].values))):
        seconds = (times[number] - np.datetime64(0, "s")) / np.timedelta64(1, "s")
        assert abs(reader.time_values[number] - seconds) < 1e-5
        reader.set_active_time_point(number)
        [points] = reader.read()
        of_shot = dataset.isel(particle=dataset["shot"].values == shot)
        assert points.n_points == of_shot.sizes["particle"] > 0
        for column, (place, speed) in enumerate(zip("xyz", "uvw")):
            np.testing.assert_allclose(1e3 * points.points[:, column], of_shot[place], atol=1e-5)
            np.testing.assert_allclose(points["velocity"][:, column], of_shot[speed], rtol=1e-5, atol=1e-6)
    # Its vectors as well, as the run itself has them.
    for path in run.glob("shot_*.vti"):
        own, exported = pyvista.read(path), pyvista.read(tmp_path / path.name)
        for name in ["valid", "replaced"]:
            np.testing.assert_array_equal(exported[name], own[name])
        np.testing.assert_allclose(exported["velocity"], own["velocity"], rtol=1e-5, atol=1e-6)
