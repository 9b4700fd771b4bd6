"""OpenPIV's 3-D correlation of an exported pair of volumes: prints one row as JSON.

One pass of `extended_search_area_piv3D` over windows of the case's size. OpenPIV has no multi-pass
correlation of volumes.
"""

import argparse
import os
from importlib.metadata import version
from pathlib import Path

os.environ["TQDM_DISABLE"] = "1"  # OpenPIV draws a progress bar

import numpy as np
from case import Case
from openpiv.pyprocess3D import extended_search_area_piv3D, get_coordinates
from row import peak_mb, print_row, timed


def displacement(a: np.ndarray, b: np.ndarray, edge: int, step: int) -> np.ndarray:
    """Displacement in every window along x, y, z, in voxels; shape (z, y, x, 3).

    The volumes are stored z, y, x. OpenPIV's components are those along -axis 1, +axis 0 and
    +axis 2.
    """
    against_1, along_0, along_2 = extended_search_area_piv3D(
        a, b, window_size=(edge,) * 3, overlap=(edge - step,) * 3, search_area_size=(edge,) * 3
    )
    return np.stack([along_2, -against_1, along_0], axis=-1)


def check_components() -> None:
    """Shifts a volume by a known way: the order of components is nowhere documented."""
    a = np.random.default_rng(1).random((16, 16, 16))
    moved = displacement(a, np.roll(a, (1, -2, 3), axis=(0, 1, 2)), 16, 8)[0, 0, 0]
    if np.abs(moved - [3, -2, 1]).max() > 0.5:
        raise SystemExit(f"OpenPIV's components have another order: {moved} for (3, -2, 1)")


def check_windows(case: Case) -> None:
    """OpenPIV centres its windows in the volume; the case's start in the corner."""
    windows = case.description["windows"]
    edge, step = windows["edge_vox"], windows["step_vox"]
    shape = tuple(reversed(case.description["voxels"]))
    centres = get_coordinates(shape, (edge,) * 3, (edge,) * 3, (edge - step,) * 3)
    if any(axis.min() != (edge - 1) / 2 for axis in centres):
        raise SystemExit(f"OpenPIV shifts its windows: take a volume of whole {step} voxels")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    case = Case(parser.parse_args().case)
    check_components()
    check_windows(case)
    windows = case.description["windows"]
    a, b, truth = case.array("a"), case.array("b"), case.array("displacement_vox")
    found, work = timed(lambda: displacement(a, b, windows["edge_vox"], windows["step_vox"]))
    error = np.abs(np.nan_to_num(found) - truth).reshape(-1, 3)
    print_row(
        case=case.name,
        method="single pass",
        peer="OpenPIV",
        version=version("openpiv"),
        threads=work.threads,
        seconds=work.seconds,
        cpu_seconds=work.cpu_seconds,
        seconds_of="volumes to vectors",
        assembly_seconds=0.0,
        iterations=1,
        vectors=len(error),
        mean_abs_error_vox=error.mean(axis=0).tolist(),
        peak_mb=peak_mb(),
    )


if __name__ == "__main__":
    main()
