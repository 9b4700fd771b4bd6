"""Pairs saved by other programs: the same pixels in every common kind of TIFF give one result."""

import numpy as np
import pytest
import xarray
from conftest import CONFIG, lfpiv
from PIL import Image

KINDS = {
    "lzw": {"compression": "tiff_lzw"},
    "deflate": {"compression": "tiff_adobe_deflate"},
    "packbits": {"compression": "packbits"},
    "big_endian": {},
}


def save_as(kind, source, target):
    """Saves a 16-bit grey image again, as another program would."""
    with Image.open(source) as image:
        counts = np.asarray(image, dtype=np.uint16)
    if kind == "big_endian":
        size = (counts.shape[1], counts.shape[0])
        image = Image.frombytes("I;16B", size, counts.astype(">u2").tobytes())
    else:
        image = Image.fromarray(counts)
    image.save(target, **KINDS[kind])


@pytest.mark.parametrize("kind", KINDS)
def test_the_result_does_not_depend_on_the_kind_of_tiff(kind, measured, tmp_path):
    pair = tmp_path / "shot_0000"
    pair.mkdir()
    for image in (measured.pairs / "shot_0000").glob("*.tif"):
        save_as(kind, image, pair / image.name)
        assert (pair / image.name).read_bytes() != image.read_bytes()
    lfpiv("process", "--config", CONFIG, "--out", tmp_path / "out", pair)
    with (
        xarray.open_dataset(measured.file(0, "velocity.nc")) as expected,
        xarray.open_dataset(tmp_path / "out" / "shot_0000" / "velocity.nc") as found,
    ):
        for name in ["u", "v", "w", "valid"]:
            np.testing.assert_allclose(found[name].values, expected[name].values, atol=1e-6)
