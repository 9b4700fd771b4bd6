"""A pair of volumes that no part of lfpiv has rendered: Gaussian particles by NumPy alone.

The flow, the particles' paths and the volumes are this file's own. Of the configuration it takes the
voxels, the windows and the time between the pulses; it writes the case as `lfpiv peers` does.
"""

import argparse
import json
import shutil
import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

SEED = 1
# Standard deviation of a particle's light, in voxels.
SIGMA_VOX = 0.8
# Its light is evaluated on so many voxels about it: beyond, it is under 2e-4 of the peak.
REACH_VOX = 4
# Particles per voxel: 10 per mm³ on voxels of 0.1 mm.
DENSITY = 0.01
# Steps of the integration between the middle of the pair and either frame.
STEPS = 8


@dataclass
class Vortices:
    """Counter-rotating columns with an axial wave: divergence-free, each component up to the peak."""

    wavelength_vox: float = 100.0
    peak_vox: float = 3.0

    def velocity(self, at: np.ndarray) -> np.ndarray:
        """Displacement per pair at positions (n, 3) as x, y, z, in voxels."""
        x, y, _ = (2 * np.pi * at / self.wavelength_vox).T
        u = self.peak_vox * np.sin(x) * np.cos(y)
        v = -self.peak_vox * np.cos(x) * np.sin(y)
        w = self.peak_vox * np.sin(x + y)
        return np.stack([u, v, w], axis=-1)

    def carried(self, at: np.ndarray, pairs: float) -> np.ndarray:
        """Where particles at `at` are after so many pulse separations: midpoint rule, small steps."""
        step = pairs / STEPS
        for _ in range(STEPS):
            half = at + step / 2 * self.velocity(at)
            at = at + step * self.velocity(half)
        return at


def rendered(at: np.ndarray, light: np.ndarray, shape: tuple[int, int, int]) -> np.ndarray:
    """The particles' light on voxels (z, y, x); voxel n is centred at n."""
    volume = np.zeros(shape, np.float64)
    near = np.arange(-REACH_VOX, REACH_VOX + 1)
    for place, brightness in zip(at[:, ::-1], light, strict=True):
        middle = np.rint(place).astype(int)
        spans = [middle[axis] + near for axis in range(3)]
        spans = [s[(s >= 0) & (s < n)] for s, n in zip(spans, shape, strict=True)]
        profiles = [
            np.exp(-((s - place[axis]) ** 2) / (2 * SIGMA_VOX**2)) for axis, s in enumerate(spans)
        ]
        volume[np.ix_(*spans)] += brightness * np.einsum("i,j,k", *profiles)
    return volume.astype(np.float32)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--config", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    config = tomllib.loads(arguments.config.read_text())
    voxels = config["volume"]["voxels"]
    edge = round(config["velocimetry"]["window_mm"] / config["volume"]["voxel_mm"])
    step = round(edge * (1 - config["velocimetry"]["overlap"]))

    rng = np.random.default_rng(SEED)
    flow, size = Vortices(), np.array(voxels, float)
    margin = flow.peak_vox + REACH_VOX
    count = round(DENSITY * np.prod(size + 2 * margin))
    middle = rng.uniform(-margin, size + margin, (count, 3))
    light = rng.uniform(0.6, 1.0, count)
    shape = tuple(reversed(voxels))
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name, pairs in (("a", -0.5), ("b", 0.5)):
        np.save(arguments.out / f"{name}.npy", rendered(flow.carried(middle, pairs), light, shape))

    # Windows of `edge` voxels from the corner on; their centres lie between voxels.
    axes = [np.arange(0, n - edge + 1, step) + (edge - 1) / 2 for n in voxels]
    z, y, x = np.meshgrid(*reversed(axes), indexing="ij")
    centres = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    moved = flow.carried(centres, 0.5) - flow.carried(centres, -0.5)
    np.save(arguments.out / "displacement_vox.npy", moved.reshape(*x.shape, 3).astype(np.float32))
    windows = {"edge_vox": edge, "step_vox": step, "vectors": [len(axis) for axis in axes]}
    description = {"kind": "correlation", "voxels": voxels, "windows": windows}
    (arguments.out / "case.json").write_text(json.dumps(description, indent=1) + "\n")
    shutil.copy(arguments.config, arguments.out / "configuration.toml")


if __name__ == "__main__":
    main()
