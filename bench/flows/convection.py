#!/usr/bin/env python3
"""A flow with walls and small scales for the benchmark: direct numerical simulation of Rayleigh-Benard convection.

The Boussinesq equations between two plates with no slip and fixed temperatures, at Rayleigh number 3e6 and Prandtl
number 0.7, in a box of 2 x 2 x 1 plate distances that is periodic along x and y. Lengths are in plate distances,
velocities in free-fall velocities. Second-order differences on a staggered grid (Harlow and Welch, Phys. Fluids 8,
1965), Adams-Bashforth steps, and a pressure that makes the velocity free of divergence on the grid. The flow develops
on a grid of half the resolution first. Some five minutes on one core.

Usage: convection.py FILE.npy. Writes u, v, w with shape (3, x, y, z), at points on both plates and between them.
"""

import sys

import numpy as np

RAYLEIGH, PRANDTL = 3e6, 0.7
VISCOSITY = (PRANDTL / RAYLEIGH) ** 0.5
DIFFUSIVITY = (PRANDTL * RAYLEIGH) ** -0.5
# Temperatures of the lower and the upper plate.
WARM, COLD = 0.5, -0.5
# Cells between the plates on the final grid, and times on the first and the final grid.
CELLS = 64
TIMES = 60.0, 6.0
# Longest time step, as a share of the time in which the flow crosses a cell and of that in which viscosity does.
COURANT, DIFFUSION = 0.25, 0.1
# Number of steps after which their length is chosen again.
STEADY_STEPS = 20

X, Y = 0, 1


def after(field, axis):
    return np.roll(field, -1, axis)


def before(field, axis):
    return np.roll(field, 1, axis)


def between_plates(field, lower, upper):
    """The field with one more layer beyond each plate, so that the mean at a plate is the plate's value."""
    return np.concatenate([2 * lower - field[..., :1], field, 2 * upper - field[..., -1:]], axis=2)


def along_z(field):
    """Difference from each layer to the next."""
    return field[..., 1:] - field[..., :-1]


def mean_along_z(field):
    return (field[..., 1:] + field[..., :-1]) / 2


class Pressure:
    """Makes a velocity free of divergence: Fourier modes along x and y, cosine modes along z."""

    def __init__(self, cells):
        self.step = 1.0 / cells
        wide = 2 * cells
        periodic = 2 - 2 * np.cos(2 * np.pi * np.arange(wide) / wide)
        modes = np.arange(cells)
        bounded = 2 - 2 * np.cos(np.pi * modes / cells)
        total = periodic[: cells + 1, None, None] + periodic[None, :, None] + bounded
        # The mean pressure changes nothing.
        total[0, 0, 0] = 1
        self.inverse = (-self.step**2 / total).astype(np.float32)
        cosines = np.cos(np.pi * np.outer(modes, modes + 0.5) / cells) * (2.0 / cells) ** 0.5
        cosines[0] /= 2**0.5
        self.cosines = cosines.astype(np.float32)

    def remove_divergence(self, u, v, w):
        divergence = (u - before(u, X) + v - before(v, Y) + along_z(w)) / self.step
        # The last of the axes is the one with half of the modes.
        modes = np.fft.rfftn(divergence @ self.cosines.T, axes=(Y, X)) * self.inverse
        pressure = np.fft.irfftn(modes, s=divergence.shape[1::-1], axes=(Y, X))
        pressure = pressure.astype(np.float32) @ self.cosines
        u -= (after(pressure, X) - pressure) / self.step
        v -= (after(pressure, Y) - pressure) / self.step
        w[..., 1:-1] -= along_z(pressure) / self.step


class Convection:
    """u, v, w on the cells' faces towards larger x, y, z (w on both plates, too), and temperature in the cells."""

    def __init__(self, cells, fields):
        self.step = 1.0 / cells
        self.u, self.v, self.w, self.temperature = fields
        self.pressure = Pressure(cells)
        self.pressure.remove_divergence(self.u, self.v, self.w)

    def laplacian(self, field, padded):
        sides = after(field, X) + before(field, X) + after(field, Y) + before(field, Y)
        return (sides + padded[..., 2:] + padded[..., :-2] - 6 * field) / self.step**2

    def rates(self):
        """Rates of change without the pressure's."""
        u, v, w, temperature = self.u, self.v, self.w, self.temperature
        padded_u, padded_v = between_plates(u, 0, 0), between_plates(v, 0, 0)
        padded_t = between_plates(temperature, WARM, COLD)
        uu = ((u + before(u, X)) / 2) ** 2
        vv = ((v + before(v, Y)) / 2) ** 2
        ww = mean_along_z(w) ** 2
        uv = (u + after(u, Y)) * (v + after(v, X)) / 4
        uw = mean_along_z(padded_u) * (w + after(w, X)) / 2
        vw = mean_along_z(padded_v) * (w + after(w, Y)) / 2
        of_u = -(after(uu, X) - uu + uv - before(uv, Y) + along_z(uw)) / self.step
        of_v = -(uv - before(uv, X) + after(vv, Y) - vv + along_z(vw)) / self.step
        uw, vw = uw[..., 1:-1], vw[..., 1:-1]
        of_w = -(uw - before(uw, X) + vw - before(vw, Y) + along_z(ww)) / self.step
        flux_x = u * (temperature + after(temperature, X)) / 2
        flux_y = v * (temperature + after(temperature, Y)) / 2
        flux_z = w * mean_along_z(padded_t)
        of_t = flux_x - before(flux_x, X) + flux_y - before(flux_y, Y) + along_z(flux_z)
        return (
            of_u + VISCOSITY * self.laplacian(u, padded_u),
            of_v + VISCOSITY * self.laplacian(v, padded_v),
            of_w + VISCOSITY * self.laplacian(w[..., 1:-1], w) + mean_along_z(temperature),
            -of_t / self.step + DIFFUSIVITY * self.laplacian(temperature, padded_t),
        )

    def run(self, until):
        time, steps, length, old = 0.0, 0, None, None
        while time < until:
            if steps % STEADY_STEPS == 0:
                speed = max(np.abs(field).max() for field in (self.u, self.v, self.w))
                allowed = min(COURANT * self.step / max(speed, 0.2), DIFFUSION * self.step**2 / VISCOSITY)
                if length is None or not length / 1.3 < allowed < length:
                    # A step of another length begins without a rate from before.
                    length, old = allowed, None
            new = self.rates()
            old = old or new
            for field, now, then in zip((self.u, self.v, self.w[..., 1:-1], self.temperature), new, old):
                field += np.float32(length) * (1.5 * now - 0.5 * then)
            self.pressure.remove_divergence(self.u, self.v, self.w)
            old, time, steps = new, time + length, steps + 1

    def nusselt(self):
        """Heat that passes the cell over that without a flow."""
        return 1 + (mean_along_z(self.w) * self.temperature).mean() / DIFFUSIVITY


def at_rest(cells):
    """Warm below and cold above, with random differences that let it overturn."""
    random = np.random.default_rng(1)
    shape = (2 * cells, 2 * cells, cells)
    z = (np.arange(cells) + 0.5) / cells
    temperature = WARM + (COLD - WARM) * z + 0.1 * random.standard_normal(shape) * np.sin(np.pi * z)
    fields = np.zeros(shape), np.zeros(shape), np.zeros((*shape[:2], cells + 1)), temperature
    return [field.astype(np.float32) for field in fields]


def on_half_cells(flow):
    """The fields of `flow` on cells of half the size; removing the divergence smooths what repeats."""
    doubled = [flow.u, flow.v, flow.w, flow.temperature]
    doubled = [field.repeat(2, X).repeat(2, Y) for field in doubled]
    faces = np.empty((*doubled[2].shape[:2], 2 * flow.w.shape[2] - 1), np.float32)
    faces[..., ::2], faces[..., 1::2] = doubled[2], mean_along_z(doubled[2])
    return [doubled[0].repeat(2, 2), doubled[1].repeat(2, 2), faces, doubled[3].repeat(2, 2)]


def on_points(flow):
    """u, v, w in the middles of the cells along x and y, on the plates and the faces between them along z."""
    u = mean_along_z(between_plates((flow.u + before(flow.u, X)) / 2, 0, 0))
    v = mean_along_z(between_plates((flow.v + before(flow.v, Y)) / 2, 0, 0))
    return np.stack([u, v, flow.w]).astype(np.float32)


def main():
    [file] = sys.argv[1:]
    flow = Convection(CELLS // 2, at_rest(CELLS // 2))
    flow.run(TIMES[0])
    flow = Convection(CELLS, on_half_cells(flow))
    flow.run(TIMES[1])
    velocities = on_points(flow)
    # Measured in a wide cell: 0.124 Ra^0.309, 12.4 here (Niemela et al., Nature 404, 2000).
    print(f"Nusselt number {flow.nusselt():.1f}, rms velocities {velocities.std(axis=(1, 2, 3)).round(3)}")
    np.save(file, velocities)


main()
