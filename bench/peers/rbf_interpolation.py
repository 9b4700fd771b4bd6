"""SciPy's radial basis functions through an exported case's particles: prints one row as JSON per setting.

`RBFInterpolator` with the nearest particles of each place. Which setting is best is known only to those who
know the flow.
"""

import argparse
from pathlib import Path

import numpy as np
import scipy
from case import Case
from row import peak_mb, print_row, timed
from scipy.interpolate import RBFInterpolator


def values(case: Case, kernel: str, neighbours: int, smoothing: float) -> np.ndarray:
    """Displacements at the unseen places, shape (n, 3), in voxels."""
    at, moved = case.array("particles_vox"), case.array("particles_moved_vox")
    field = RBFInterpolator(at, moved, neighbours, smoothing, kernel)
    return field(case.array("unseen_vox"))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--kernel", default="thin_plate_spline")
    parser.add_argument("--neighbours", type=int, default=50, help="particles about a place")
    parser.add_argument("--smoothing", type=float, default=0.0)
    arguments = parser.parse_args()
    case = Case(arguments.case)
    kernel, neighbours, smoothing = arguments.kernel, arguments.neighbours, arguments.smoothing
    found, work = timed(lambda: values(case, kernel, neighbours, smoothing))
    error = np.abs(found - case.array("unseen_moved_vox"))
    print_row(
        case=case.name,
        method=f"radial basis functions, {kernel} of {neighbours} particles, smoothing {smoothing:g}",
        peer="SciPy",
        version=scipy.__version__,
        threads=work.threads,
        seconds=work.seconds,
        cpu_seconds=work.cpu_seconds,
        seconds_of="particles to values at unseen places",
        assembly_seconds=0.0,
        vectors=len(error),
        mean_abs_error_vox=error.mean(axis=0).tolist(),
        peak_mb=peak_mb(),
    )


if __name__ == "__main__":
    main()
