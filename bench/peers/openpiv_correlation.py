"""OpenPIV's 3-D correlation of an exported pair of volumes: prints one row as JSON.

One pass of `extended_search_area_piv3D` over windows of the case's size. OpenPIV has no multi-pass
correlation of volumes. With `--unseen` the error is that of its field between the vectors, cubically
interpolated.
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
from scipy.interpolate import RegularGridInterpolator


def displacement(a: np.ndarray, b: np.ndarray, edge: int, step: int, search: int) -> np.ndarray:
    """Displacement in every window along x, y, z, in voxels; shape (z, y, x, 3).

    The volumes are stored z, y, x. OpenPIV's components are those along -axis 1, +axis 0 and
    +axis 2. Beyond the volume, where search areas reach, it is dark.

    Every window is handed over by itself: given the whole volume, OpenPIV 0.26 counts the windows
    by the step of the search areas and leaves most of them out where these are larger.
    """
    rim = (search - edge) // 2
    a, b = np.pad(a, rim), np.pad(b, rim)
    counts = [(n - search) // step + 1 for n in a.shape]
    found = np.zeros((*counts, 3))
    for window in np.ndindex(*counts):
        area = tuple(slice(n * step, n * step + search) for n in window)
        against_1, along_0, along_2 = extended_search_area_piv3D(
            a[area],
            b[area],
            window_size=(edge,) * 3,
            overlap=(0,) * 3,
            search_area_size=(search,) * 3,
        )
        found[window] = along_2.item(), -against_1.item(), along_0.item()
    return found


def check_components(search: int) -> None:
    """Shifts a volume by a known way: the order of components is nowhere documented."""
    a = np.zeros((16, 16, 16))
    a[4:12, 4:12, 4:12] = np.random.default_rng(1).random((8, 8, 8))
    moved = displacement(a, np.roll(a, (1, -2, 3), axis=(0, 1, 2)), 16, 8, search)[0, 0, 0]
    if np.abs(moved - [3, -2, 1]).max() > 0.5:
        raise SystemExit(f"OpenPIV's components have another order: {moved} for (3, -2, 1)")


def search_area(edge: int, truth: np.ndarray) -> int:
    """Edge of search areas that reach twice as far as the largest motion, in voxels."""
    return edge + 4 * int(np.ceil(np.abs(truth).max()))


def between(found: np.ndarray, edge: int, step: int, places: np.ndarray) -> np.ndarray:
    """The field at places (n, 3) as x, y, z, in voxels, from vectors at the windows' centres."""
    axes = [(edge - 1) / 2 + step * np.arange(n) for n in found.shape[:3]]
    return RegularGridInterpolator(axes, found, method="cubic")(places[:, ::-1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("case", type=Path)
    parser.add_argument("--extended", action="store_true", help="search areas beyond the motion")
    parser.add_argument("--unseen", action="store_true", help="errors between the vectors")
    arguments = parser.parse_args()
    case = Case(arguments.case)
    windows = case.description["windows"]
    a, b, truth = case.array("a"), case.array("b"), case.array("displacement_vox")
    edge, step = windows["edge_vox"], windows["step_vox"]
    search = search_area(edge, truth) if arguments.extended else edge
    check_components(search)
    found, work = timed(lambda: displacement(a, b, edge, step, search))
    found = np.nan_to_num(found)
    method = "single pass"
    if arguments.unseen:
        method = "vectors of a single pass, interpolated"
        found = between(found, edge, step, case.array("unseen_vox"))
        truth = case.array("unseen_moved_vox")
    error = np.abs(found - truth).reshape(-1, 3)
    print_row(
        case=case.name,
        method=f"{method}, search area {search}",
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
