"""N_s(theta, rate) of the energy model (Eqs. 1-6), evaluated from a case's constituents apart from the program's own."""

import sys

import numpy as np

GAS_CONSTANT = 8.31446261815324
# Transverse viscosity of a hexagonal cell over the fibre fraction.
CELL = np.array([(0.20, 1.5055), (0.35, 2.1711), (0.40, 2.5238), (0.50, 3.6613), (0.55, 4.6255),
                 (0.60, 6.0980), (0.65, 8.4898), (0.70, 12.714), (0.75, 21.149), (0.80, 41.82)])


def si(value):
    """A number of the resolved case: SI, with or without its unit."""
    return float(value.split()[0]) if isinstance(value, str) else float(value)


def pchip(x, y, at):
    """Monotone piecewise cubic through (x, y), inside its range."""
    h, d = np.diff(x), np.diff(y) / np.diff(x)
    slope = np.zeros_like(x)
    w0, w1 = 2 * h[1:] + h[:-1], h[1:] + 2 * h[:-1]
    slope[1:-1] = (w0 + w1) / (w0 / d[:-1] + w1 / d[1:])
    slope[0] = ((2 * h[0] + h[1]) * d[0] - h[0] * d[1]) / (h[0] + h[1])
    slope[-1] = ((2 * h[-1] + h[-2]) * d[-1] - h[-1] * d[-2]) / (h[-1] + h[-2])
    i = min(max(np.searchsorted(x, at) - 1, 0), len(h) - 1)
    t = (at - x[i]) / h[i]
    return (y[i] * (1 + 2 * t) * (1 - t) ** 2 + y[i + 1] * t * t * (3 - 2 * t)
            + h[i] * t * (1 - t) * (slope[i] * (1 - t) - slope[i + 1] * t))


class Surface:
    """N_s(theta, rate) of the sheet's energy model (Eqs. 1-6), Cross matrix."""

    def __init__(self, case):
        m = case["material"]
        if m["matrix"]["model"] != "cross":
            sys.exit("only the Cross matrix is known here")
        self.h = si(case["blank"]["thickness"])
        self.width, self.gap = si(m["tow_width"]), si(m["tow_gap"])
        self.pitch = self.width + self.gap
        self.tow, self.between = self.width / self.pitch, self.gap / self.pitch
        fraction = si(m["fibre_volume_fraction"]) / self.tow
        limit = np.pi / (2 * np.sqrt(3)) if m["fibre_packing"] == "hexagonal" else np.pi / 4
        self.kappa = np.sqrt(fraction / limit)
        self.film = si(m["fibre_diameter"]) * (1 / self.kappa - 1)
        if m["tow_viscosity"] == "coffin":
            self.longitudinal = 0.5 * (1 + 1 / (1 - self.kappa))
            self.transverse = 1 / (1 - self.kappa) ** 2
        else:
            f6 = fraction**6
            self.longitudinal = 1 + 2 * fraction / (
                1 - fraction - 0.075422 * f6 / (1 - 1.060283 * f6**2) - 0.000076 * f6**2)
            self.transverse = np.exp(pchip(CELL[:, 0], np.log(CELL[:, 1]), fraction))
        self.weave = si(m["weave_factor"])
        self.sign = 1.0 if m["crossover_field"] == "derived" else -1.0
        x = m["matrix"]
        shift = np.exp(si(x["activation_energy"]) / GAS_CONSTANT
                       * (1 / si(m["temperature"]) - 1 / si(x["reference_temperature"])))
        self.eta0, self.time, self.n = (si(x["zero_shear_viscosity"]) * shift,
                                        si(x["time_constant"]) * shift, si(x["exponent"]))

    def viscosity(self, rate):
        return self.eta0 / (1 + (self.time * np.abs(rate)) ** (1 - self.n))

    def crossover(self, theta, rate, tow_rate):
        """Power in one film: squares of 40 x 40 over the rhombus's own coordinates."""
        s = np.sin(theta)
        p = (np.arange(40) + 0.5) / 40 - 0.5
        u, v = np.meshgrid(p, p)  # along the rhombus's sides
        x = self.width * (u + v) * np.sqrt(0.5 * (1 + s))
        y = self.width * (u - v) * np.sqrt(0.5 * (1 - s))
        speed = np.abs(tow_rate - rate) * np.hypot((1 + self.sign * s) * y, (1 - s) * x)
        density = self.viscosity(speed / self.film) * speed**2 / self.film
        return density.mean() * self.width**2 * np.cos(theta)

    def force(self, theta, rate):
        if rate <= 0:
            return 0.0
        t = np.degrees(theta)
        chi = np.radians(((1.72e-4 * t - 1.72e-2) * t + 0.7701) * t + 0.2311)
        slope = (3 * 1.72e-4 * t - 2 * 1.72e-2) * t + 0.7701
        tow_rate = rate * (slope / np.cos(chi) ** 2 - np.tan(theta) * np.tan(chi)) if self.gap > 0 else rate
        spin, near = 2 * rate * np.tan(theta), 1 / (1 - self.kappa)
        power = self.h * self.tow * (
            self.transverse * self.viscosity(spin * near) * spin**2
            + self.longitudinal * self.viscosity(tow_rate * near) * tow_rate**2)
        if self.gap > 0:
            matrix_rate = (rate - self.tow * tow_rate) / self.between
            square = spin**2 + matrix_rate**2
            power += self.h * self.between * self.weave * self.viscosity(np.sqrt(square)) * square
        power += self.crossover(theta, rate, tow_rate) / self.pitch**2
        return power / (rate * np.cos(theta))

    def table(self, angles, rates):
        """N_s at every angle and rate, (angles, rates) [N/m]."""
        return np.array([[self.force(theta, rate) for rate in rates] for theta in angles])


class SurfaceTable:
    """The surface between the points of a grid: fields of a whole sheet at once."""

    def __init__(self, surface):
        self.angles = np.radians(np.linspace(0.0, 85.0, 171))
        self.rates = np.concatenate(([0.0], np.geomspace(1e-3, 300.0, 111)))
        self.forces = surface.table(self.angles, self.rates)

    def __call__(self, theta, rate):
        """N_s(|theta|, |rate|), bilinear [N/m]."""
        theta, rate = np.abs(theta), np.abs(rate)
        i = np.clip(np.searchsorted(self.angles, theta) - 1, 0, len(self.angles) - 2)
        j = np.clip(np.searchsorted(self.rates, rate) - 1, 0, len(self.rates) - 2)
        u = (theta - self.angles[i]) / (self.angles[i + 1] - self.angles[i])
        v = (rate - self.rates[j]) / (self.rates[j + 1] - self.rates[j])
        f = self.forces
        return ((1 - u) * ((1 - v) * f[i, j] + v * f[i, j + 1])
                + u * ((1 - v) * f[i + 1, j] + v * f[i + 1, j + 1]))
