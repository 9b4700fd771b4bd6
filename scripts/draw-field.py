"""Draws three slices of a velocity.nc, as in the README: draw-field.py VELOCITY.nc OUT.png"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import xarray as xr

source, target = sys.argv[1:]
field = xr.open_dataset(source).isel(shot=0)
fig, axes = plt.subplots(1, 3, figsize=(13, 4.2), layout="constrained")
limit = float(max(abs(field[name]).max() for name in "uvw"))
for axes_, across, (h, v), (a, b) in zip(
    axes, "zyx", (("x", "y"), ("x", "z"), ("y", "z")), (("u", "v"), ("u", "w"), ("v", "w"))
):
    plane = field.isel({across: field.sizes[across] // 2}).transpose(v, h)
    through = {"z": "w", "y": "v", "x": "u"}[across]
    image = axes_.pcolormesh(
        plane[h], plane[v], plane[through], cmap="RdBu_r", vmin=-limit, vmax=limit, shading="nearest"
    )
    valid = plane["valid"].values == 1
    arrows = [np.where(valid, plane[name].values, np.nan) for name in (a, b)]
    axes_.quiver(plane[h], plane[v], *arrows, scale=9 * limit, width=0.005)
    axes_.set(xlabel=f"{h} (mm)", ylabel=f"{v} (mm)", aspect="equal")
    axes_.set_title(f"{across} = {float(plane[across]):.1f} mm: arrows ({a}, {b}), colour {through}")
fig.colorbar(image, ax=axes, label="velocity through the plane (m/s)", shrink=0.85)
fig.savefig(target, dpi=110)
