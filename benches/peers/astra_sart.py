"""ASTRA's SART on an exported matrix, in its own process: prints one row as JSON.

The matrix is ASTRA's projector of kind `sparse_matrix`. ASTRA has it in two dimensions only, and
does not care what an image means: a view is a "projection" of as many "detectors" as a view has
pixels, and the volume a picture of one line. SART then corrects view by view, which is the
ordered-subset SART with one view per subset.
"""

import argparse
from pathlib import Path

import astra
import numpy as np
import scipy.sparse
from case import Case
from row import peak_mb, print_row, timed


def quality_factor(reconstructed: np.ndarray, truth: np.ndarray) -> float:
    """Q = Σ E E₀ / √(Σ E² · Σ E₀²), 0 for a dark volume."""
    e, e0 = reconstructed.astype(np.float64), truth.astype(np.float64)
    norm = np.sqrt(np.sum(e * e) * np.sum(e0 * e0))
    return float(np.sum(e * e0) / norm) if norm > 0 else 0.0


class Sart:
    """ASTRA's SART, ready to run."""

    def __init__(self, matrix: scipy.sparse.csr_matrix, views: int, measured: np.ndarray):
        detectors = matrix.shape[0] // views
        angles = np.linspace(0, np.pi, views, endpoint=False)  # asked for, not used
        self.matrix = astra.matrix.create(matrix)
        lines = astra.create_proj_geom("sparse_matrix", 1.0, detectors, angles, self.matrix)
        picture = astra.create_vol_geom(1, matrix.shape[1])
        self.projector = astra.create_projector("sparse_matrix", lines, picture)
        self.volume = astra.data2d.create("-vol", picture, 0.0)
        self.views = views
        settings = astra.astra_dict("SART")
        settings["ProjectorId"] = self.projector
        settings["ProjectionDataId"] = astra.data2d.create(
            "-sino", lines, measured.reshape(views, detectors)
        )
        settings["ReconstructionDataId"] = self.volume
        settings["option"] = {"ProjectionOrder": "random", "MinConstraint": 0.0}
        self.algorithm = astra.algorithm.create(settings)

    def sweep(self, sweeps: int) -> np.ndarray:
        """Runs over all views so many times; the volume then."""
        astra.algorithm.run(self.algorithm, sweeps * self.views)
        return astra.data2d.get(self.volume).ravel()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--sweeps", type=int, default=20)
    parser.add_argument("--active", action="store_true", help="only the photo-hull's voxels")
    arguments = parser.parse_args()

    np.random.seed(1)
    case = Case(arguments.case)
    size = case.description["matrix"]
    measured, truth = case.array("views"), case.array("truth")
    voxels = case.array("active") if arguments.active else np.arange(truth.size)
    whole = case.matrix()

    def prepare() -> Sart:
        matrix = whole[:, voxels] if arguments.active else whole
        return Sart(matrix, size["views"], measured)

    sart, preparation = timed(prepare)
    light, work = timed(lambda: sart.sweep(arguments.sweeps))
    volume = np.zeros_like(truth)
    volume[voxels] = light
    print_row(
        case=case.name,
        method="SART, active voxels" if arguments.active else "SART, full volume",
        peer="ASTRA",
        version=astra.__version__,
        threads=work.threads,
        seconds=work.seconds,
        cpu_seconds=work.cpu_seconds,
        seconds_of="sweeps only",
        assembly_seconds=size["assembly_seconds"] + preparation.seconds,
        q=quality_factor(volume, truth),
        iterations=arguments.sweeps,
        peak_mb=peak_mb(),
    )


if __name__ == "__main__":
    main()
