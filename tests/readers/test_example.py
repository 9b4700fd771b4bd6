"""The notebook in examples/, executed on a run."""

import nbformat
from conftest import BINARY, ROOT
from nbclient import NotebookClient
from PIL import Image


def test_the_notebook_draws_its_figure(run, tmp_path, monkeypatch):
    figure = tmp_path / "figure.png"
    monkeypatch.setenv("RUN", str(run.folder))
    monkeypatch.setenv("FIGURE", str(figure))
    monkeypatch.setenv("LFPIV", str(BINARY.resolve()))
    monkeypatch.setenv("MPLBACKEND", "agg")
    notebook = nbformat.read(ROOT / "examples" / "run-to-figure.ipynb", as_version=4)
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute(cwd=str(tmp_path))
    with Image.open(figure) as image:
        assert image.width > 800 and image.height > 600
        darkest, brightest = image.convert("L").getextrema()
    assert darkest < 64 and brightest > 192
    (run.folder / "statistics.nc").unlink()
