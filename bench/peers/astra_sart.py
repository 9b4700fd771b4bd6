"""ASTRA's SART on an exported matrix, in its own process: prints a row as JSON after every so many
sweeps.

The matrix is ASTRA's projector of kind `sparse_matrix`. ASTRA has it in two dimensions only, and
does not care what an image means: a view is a "projection" of as many "detectors" as a view has
pixels, and the volume a picture of one line. SART then corrects view by view, which is the
ordered-subset SART with one view per subset.
"""

import argparse
from itertools import pairwise
from pathlib import Path

import astra
import numpy as np
import scipy.sparse
from case import Case
from row import Cost, peak_mb, print_row, timed


def quality_factor(reconstructed: np.ndarray, truth: np.ndarray) -> float:
    """Q = Σ E E₀ / √(Σ E² · Σ E₀²), 0 for a dark volume."""
    e, e0 = reconstructed.astype(np.float64), truth.astype(np.float64)
    norm = np.sqrt(np.sum(e * e) * np.sum(e0 * e0))
    return float(np.sum(e * e0) / norm) if norm > 0 else 0.0


class Sart:
    """ASTRA's SART, ready to run."""

    def __init__(
        self, matrix: scipy.sparse.csr_matrix, views: int, measured: np.ndarray, options: dict
    ):
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
        settings["option"] = options
        self.algorithm = astra.algorithm.create(settings)

    def sweep(self, sweeps: int) -> None:
        """Runs over all views so many times more."""
        astra.algorithm.run(self.algorithm, sweeps * self.views)

    def light(self) -> np.ndarray:
        """The volume now."""
        return astra.data2d.get(self.volume).ravel()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--sweeps", type=int, nargs="+", default=[1, 2, 5, 10, 20, 40])
    parser.add_argument("--active", action="store_true", help="only the photo-hull's voxels")
    parser.add_argument("--order", default="random", help="order of the views in a sweep")
    parser.add_argument("--relaxation", type=float, default=1.0)
    parser.add_argument("--signed", action="store_true", help="light may turn negative")
    arguments = parser.parse_args()
    options = {"ProjectionOrder": arguments.order, "Relaxation": arguments.relaxation}
    if not arguments.signed:
        options["MinConstraint"] = 0.0

    np.random.seed(1)
    case = Case(arguments.case)
    size = case.description["matrix"]
    measured, truth = case.array("views"), case.array("truth")
    voxels = case.array("active") if arguments.active else np.arange(truth.size)
    whole = case.matrix()

    def prepare() -> Sart:
        matrix = whole[:, voxels] if arguments.active else whole
        return Sart(matrix, size["views"], measured, options)

    sart, preparation = timed(prepare)
    done = Cost(0.0, 0.0)
    for before, sweeps in pairwise([0, *sorted(arguments.sweeps)]):
        _, work = timed(lambda more=sweeps - before: sart.sweep(more))
        done += work
        volume = np.zeros_like(truth)
        volume[voxels] = sart.light()
        print_row(
            case=case.name,
            method=method(arguments),
            peer="ASTRA",
            version=astra.__version__,
            threads=done.threads,
            seconds=done.seconds,
            cpu_seconds=done.cpu_seconds,
            seconds_of="sweeps only",
            assembly_seconds=size["assembly_seconds"] + preparation.seconds,
            q=quality_factor(volume, truth),
            iterations=sweeps,
            peak_mb=peak_mb(),
        )


def method(arguments: argparse.Namespace) -> str:
    """What is asked of SART, in words."""
    words = ["SART, active voxels" if arguments.active else "SART, full volume"]
    words += [f"{arguments.order} order"] if arguments.order != "random" else []
    words += [f"relaxation {arguments.relaxation:g}"] if arguments.relaxation != 1 else []
    words += ["signed"] if arguments.signed else []
    return ", ".join(words)


if __name__ == "__main__":
    main()
