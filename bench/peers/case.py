"""A case as `lfpiv peers` exports it: arrays of NumPy and a description in JSON."""

import json
from pathlib import Path

import numpy as np
import scipy.sparse


class Case:
    """One folder with `case.json` and the arrays that it describes."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.name = folder.name
        self.description = json.loads((folder / "case.json").read_text())

    def array(self, name: str) -> np.ndarray:
        """The array in `name.npy`, read as it is used: a matrix need not be in memory twice."""
        return np.load(self.folder / f"{name}.npy", mmap_mode="c")

    def matrix(self) -> scipy.sparse.csr_matrix:
        """The weights: one row per pixel, view after view, and one column per voxel."""
        size = self.description["matrix"]
        shape = (size["views"] * size["rows_per_view"], size["columns"])
        # ASTRA and SciPy count in 32 bits where that is enough.
        indices = self.array("matrix_indices").view(np.int32)
        indptr = self.array("matrix_indptr")
        if size["entries"] <= np.iinfo(np.int32).max:
            indptr = indptr.astype(np.int32)
        return scipy.sparse.csr_matrix((self.array("matrix_data"), indices, indptr), shape)
