"""A run in the files of other programs, each read back by the program's own reader."""

import h5py
import numpy as np
import pandas
import pytest
import tifffile
import xarray
from conftest import RUN_SHOTS, lfpiv
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkTecplotReader

NAMES = ["u", "v", "w", "u_uncertainty", "v_uncertainty", "w_uncertainty"]


@pytest.fixture(scope="module")
def dataset(run):
    with xarray.open_mfdataset(str(run.folder / "velocity_*.nc")) as dataset:
        yield dataset.load()


@pytest.fixture(scope="module")
def export(run, tmp_path_factory):
    def exported(*arguments):
        out = tmp_path_factory.mktemp("export")
        lfpiv("export", run.folder, "--out", out, *arguments)
        return out

    return exported


def flat(variable):
    """A variable with x fastest, as files have it."""
    return variable.transpose("z", "y", "x").values.ravel()


def test_all_files_of_a_run_are_one_dataset(dataset):
    assert dataset["shot"].values.tolist() == list(range(RUN_SHOTS))
    assert dataset["u"].dims == ("shot", "z", "y", "x")
    assert dataset["dt"].dims == ("shot",)
    np.testing.assert_allclose(dataset["dt"], 1e-4)
    assert dataset["time"].dims == ("shot",) and dataset["time"].notnull().all()
    assert (dataset["time"].diff("shot") > np.timedelta64(0, "ns")).all()
    # The mean over the shots, of what is valid, in one line.
    mean = dataset["u"].where(dataset["valid"] == 1).mean("shot")
    assert mean.notnull().any()


def test_pairs_that_were_processed_are_one_dataset_too(measured):
    with xarray.open_mfdataset(str(measured.results / "*" / "velocity.nc")) as pairs:
        assert pairs["shot"].values.tolist() == [0, 1]
        assert pairs["u"].sizes["shot"] == 2


def test_pandas_reads_what_was_measured(dataset, export):
    tables = [pandas.read_csv(path) for path in sorted(export("--format", "csv").glob("*.csv"))]
    assert len(tables) == RUN_SHOTS
    for number, table in enumerate(tables):
        shot = dataset.sel(shot=number)
        assert (table["shot"] == number).all()
        np.testing.assert_allclose(table["dt_s"], 1e-4)
        seconds = (shot["time"].values - np.datetime64(0, "s")) / np.timedelta64(1, "s")
        np.testing.assert_allclose(table["time_s"], seconds, rtol=0, atol=1e-6)
        for axis in "xyz":
            places = flat(shot[axis].broadcast_like(shot["u"]))
            np.testing.assert_allclose(table[f"{axis}_mm"], places, atol=1e-6)
        for name in NAMES:
            np.testing.assert_allclose(table[f"{name}_m_s"], flat(shot[name]), rtol=1e-6)
        for name in ["valid", "replaced", "masked"]:
            np.testing.assert_array_equal(table[name], flat(shot[name]))
        divergence = table["divergence_per_s"]
        np.testing.assert_allclose(divergence, flat(shot["divergence"]), rtol=1e-6)


def test_vtk_reads_tecplots_files(dataset, export):
    files = sorted(export("--format", "tecplot", "--shots", "1").glob("*.dat"))
    assert [file.name for file in files] == ["shot_000001.dat"]
    reader = vtkTecplotReader()
    reader.SetFileName(str(files[0]))
    reader.Update()
    zone = reader.GetOutput().GetBlock(0)
    shot = dataset.sel(shot=1)
    extent = [shot.sizes[axis] for axis in "xyz"]
    found = [0, 0, 0]
    zone.GetDimensions(found)
    assert found == extent
    points = vtk_to_numpy(zone.GetPoints().GetData())
    for column, axis in enumerate("xyz"):
        places = flat(shot[axis].broadcast_like(shot["u"]))
        np.testing.assert_allclose(1e3 * points[:, column], places, atol=1e-5)
    data = zone.GetPointData()
    has_value = flat(shot["valid"] + shot["replaced"]) == 1
    for name in [*NAMES, "peak_ratio", "vorticity_z"]:
        found = vtk_to_numpy(data.GetArray(name))
        expected = np.nan_to_num(flat(shot[name]))
        np.testing.assert_allclose(found, expected, rtol=1e-6, err_msg=name)
    flags = vtk_to_numpy(data.GetArray("valid")) + vtk_to_numpy(data.GetArray("replaced"))
    np.testing.assert_array_equal(flags == 1, has_value)


def test_h5py_reads_plain_arrays(dataset, export):
    [path] = export("--format", "hdf5").glob("*.h5")
    with h5py.File(path) as file:
        assert file["shot"][:].tolist() == list(range(RUN_SHOTS))
        assert file["velocity"].shape == (*dataset["u"].shape, 3)
        assert file["velocity"].attrs["units"] in ("m s-1", b"m s-1")
        for column, name in enumerate("uvw"):
            np.testing.assert_array_equal(file["velocity"][..., column], dataset[name].values)
            doubt = dataset[f"{name}_uncertainty"].values
            np.testing.assert_array_equal(file["velocity_uncertainty"][..., column], doubt)
        np.testing.assert_array_equal(file["valid"][:], dataset["valid"].values)
        for axis in "xyz":
            np.testing.assert_allclose(file[axis][:], dataset[axis].values)


def test_tifffile_reads_the_images_that_were_recorded(run, export):
    out = export("--format", "tiff", "--shots", "0..1")
    folders = sorted(folder for folder in out.iterdir() if folder.is_dir())
    assert [folder.name for folder in folders] == ["shot_000000", "shot_000001"]
    for folder in folders:
        images = {path.name: tifffile.imread(path) for path in folder.glob("*.tif")}
        assert sorted(images) == ["cam1_a.tif", "cam1_b.tif", "cam2_a.tif", "cam2_b.tif"]
        for image in images.values():
            assert image.dtype == np.uint16 and image.shape == (748, 748)
            # Twelve bits with light, above the black level of the simulated sensor.
            assert 64 < image.max() < 4096 and np.median(image) > 32


def test_a_merged_run_is_what_it_was(run, dataset):
    said = lfpiv("merge", run.folder)
    assert f"{RUN_SHOTS} shots in 1 file" in said
    with xarray.open_mfdataset(str(run.folder / "velocity_*.nc")) as merged:
        xarray.testing.assert_identical(merged[["u", "time", "dt"]].load(), dataset[["u", "time", "dt"]])
