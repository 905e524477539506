"""Compares the results of a picture frame or bias extension with theory.

    python3 tools/specimen_tests.py DIR

DIR holds results.h5, history.csv and case.resolved.toml of a run. Prints a table over the stroke:

picture frame    shear angle theta = pi/2 - 2 acos(1/sqrt 2 + d/(2L))                             (Eq. 13)
                 rate d'/(L sin(pi/4 - theta/2))                                                  (Eq. 14)
                 axial force 2 N_s L cos(pi/4 - theta/2)
bias extension   central shear angle theta = pi/2 - 2 acos((D + d)/(sqrt 2 D)), D = L - W
                 force from the power of the three regions, per reference area: full shear on
                 W L - 3 W^2/2, half the angle at half the rate on W^2, none under the grips;
                 F d' = sum of A N_s(theta, rate) rate cos(theta)

                 and, beside it, an inextensible net that shears with the least power: each warp (weft)
                 has one direction all along, phi(u) (phi(v)), shear is phi(u) + phi(v) in the middle and
                 phi where the other family is held. At L/W = 2 that is the three regions; at L/W = 3
                 yarns near the middle cross more of the full shear and turn less.

The rate is that of the kinematics; the surface N_s(theta, rate) is evaluated here from the constituents of
the case, apart from the program's own. Exit codes: 0 done, 2 usage, 4 files.
"""

import sys
import tomllib
from pathlib import Path

import h5py
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


class Net:
    """The bias-extension net of least power at each displacement, by Newton's method over the yarns' rates."""

    def __init__(self, surface, width, length, duration, cells=20):
        free = (length - width) / np.sqrt(8)  # half width of the yarns that no grip holds
        self.du = du = 2 * free / cells
        at = (np.arange(cells) + 0.5) * du - free
        beyond = np.arange(free, free + 1.5 * width, du) + 0.5 * du
        fine = du * ((np.arange(8) + 0.5) / 8 - 0.5)

        def area(u, v):  # of the cell that lies within the width
            return du**2 * np.mean(np.abs(u + fine[:, None] - v - fine) < width / np.sqrt(2))

        self.full = np.array([[area(u, v) for v in at] for u in at])
        self.half = np.array([sum(area(u, v) for v in np.concatenate((beyond, -beyond))) for u in at])
        self.angles = np.radians(np.linspace(0, 80, 81))
        self.rates = np.concatenate(([0], np.geomspace(1e-3, 20, 60) / duration))
        self.table = np.array([[surface.force(a, r) * np.cos(a) for r in self.rates] for a in self.angles])
        self.phi, self.rate = np.zeros(cells), np.full(cells, 0.1 / duration)

    def torque(self, angle, rate):
        """N_s cos(theta) and its slope over the rate."""
        i = np.clip(np.searchsorted(self.angles, angle) - 1, 0, len(self.angles) - 2)
        j = np.clip(np.searchsorted(self.rates, np.abs(rate)) - 1, 0, len(self.rates) - 2)
        w = (angle - self.angles[i]) / (self.angles[i + 1] - self.angles[i])
        low, high = ((1 - w) * self.table[i, k] + w * self.table[i + 1, k] for k in (j, j + 1))
        slope = (high - low) / (self.rates[j + 1] - self.rates[j])
        return np.sign(rate) * (low + slope * (np.abs(rate) - self.rates[j])), slope

    def shear(self, phi, speed):
        """The yarns' rates at the least power and the force."""
        along = 2 * self.du * np.cos(np.pi / 4 + phi)  # displacement of the grip over phi
        for _ in range(100):
            full, full_slope = self.torque(phi[:, None] + phi, self.rate[:, None] + self.rate)
            half, half_slope = self.torque(phi, self.rate)
            residual = 2 * ((self.full * full).sum(1) + self.half * half)
            curved = 2 * self.full * full_slope
            matrix = curved + np.diag(curved.sum(1) + 2 * self.half * half_slope)
            system = np.block([[matrix, along[:, None]], [along[None], np.zeros((1, 1))]])
            step = np.linalg.solve(system, np.append(-residual, speed - along @ self.rate))[:-1]
            self.rate = self.rate + step
            if np.abs(step).max() < 1e-9 * np.abs(self.rate).max():
                break
        return residual @ self.rate / speed

    def advance(self, travel, speed, parts=20):
        """To a displacement later by `travel`; returns the force there and the shear angle in the middle."""
        dt = travel / speed / parts
        for _ in range(parts):
            self.shear(self.phi, speed)
            self.shear(self.phi + 0.5 * dt * self.rate, speed)
            self.phi = self.phi + dt * self.rate
        middle = len(self.phi) // 2
        return self.shear(self.phi, speed), 2 * np.mean(self.phi[middle - 1:middle + 1])


class Run:
    """What a run left behind, at its frames."""

    def __init__(self, directory):
        self.case = tomllib.loads((directory / "case.resolved.toml").read_text())
        self.size = [si(v) for v in self.case["blank"]["size"]]
        self.boundary = next(b for b in self.case.get("boundary", []) if "motion" in b)
        history = np.genfromtxt(directory / "history.csv", delimiter=",", names=True, deletechars="")
        name = self.boundary["name"]
        with h5py.File(directory / "results.h5") as file:
            triangles, flat = file["mesh/triangles"][:], file["mesh/reference"][:]
            middle = flat[triangles].mean(axis=1)[:, :2]
            distance = np.hypot(*middle.T)
            ring = np.flatnonzero(distance < distance.min() + 1e-9)
            self.time, self.angle, self.rate, self.scatter, self.fields = [], [], [], [], []
            for key in sorted(file["frames"]):
                frame = file["frames"][key]
                angle = frame["shear_angle"][:]
                self.time.append(frame.attrs["time"])
                self.angle.append(angle[ring].mean())
                self.rate.append(frame["shear_rate"][:][ring].mean())
                self.scatter.append(np.abs(angle - angle[ring].mean()).max())
                self.fields.append(angle)
            self.middle = middle
        self.time, self.angle, self.rate = map(np.array, (self.time, self.angle, self.rate))
        self.force = np.interp(self.time, history["time_s"], history[f"force_{name}_N"])
        self.travel = np.interp(self.time, history["time_s"], history[f"position_{name}_m"])
        pace = np.diff(self.travel) / np.diff(self.time)
        self.speed = np.concatenate(([pace[0]], 0.5 * (pace[1:] + pace[:-1]), [pace[-1]]))
        # While the speed changes, frames are too far apart to say what it is.
        change = np.concatenate(([0], np.abs(np.diff(pace)), [0]))
        change[0] = change[1]
        self.steady = change < 1e-3 * np.abs(pace).max()
        self.kinetic = np.zeros_like(self.time)  # a quasi-static run has none
        if "kinetic_to_internal" in history.dtype.names:
            self.kinetic = np.interp(self.time, history["time_s"], history["kinetic_to_internal"])
        self.error = history["energy_error"][-1]


def of(value, exact):
    return 100 * (value / exact - 1)


def picture_frame(run):
    surface, arm = Surface(run.case), run.size[0]
    print("    d [mm]  theta [deg] exact    error   rate [deg/s] exact   error %    P [N]   theory   error %"
          "  scatter [deg]")
    worst = np.zeros(3)
    for i in range(1, len(run.time)):
        theta = np.pi / 2 - 2 * np.arccos(1 / np.sqrt(2) + run.travel[i] / (2 * arm))
        rate = run.speed[i] / (arm * np.sin(np.pi / 4 - theta / 2))
        axial = 2 * surface.force(theta, rate) * arm * np.cos(np.pi / 4 - theta / 2)
        errors = (run.angle[i] - np.degrees(theta), of(run.rate[i], rate), of(run.force[i], axial))
        if run.steady[i]:
            worst = np.maximum(worst, np.abs(errors))
        print(f"{1e3 * run.travel[i]:10.3f} {run.angle[i]:9.3f} {np.degrees(theta):9.3f} {errors[0]:8.4f}"
              f" {np.degrees(run.rate[i]):10.3f} {np.degrees(rate):9.3f} {errors[1]:8.3f}"
              f" {run.force[i]:9.4f} {axial:9.4f} {errors[2]:8.3f} {run.scatter[i]:10.2e}{'' if run.steady[i] else '  (speed changes)'}")
    print(f"largest errors at steady speed: angle {worst[0]:.4f} deg, rate {worst[1]:.3f} %, axial force {worst[2]:.3f} %;"
          f" energy account {100 * run.error:.4f} %, kinetic over internal at the end {run.kinetic[-1]:.1e}")


def bias_extension(run):
    surface = Surface(run.case)
    upright = run.boundary["edge"] in ("top", "bottom")
    width, length = run.size if upright else run.size[::-1]
    across, along = run.middle.T if upright else run.middle.T[::-1]
    inner = length - width
    # Well inside each region: the central hexagon (a diamond at L/W = 2) and the four half-sheared triangles.
    def inside(margin):
        full = np.abs(across) + np.abs(along) < length / 2 - width / 2 - margin
        half = ((np.abs(across) + np.abs(along) > length / 2 - width / 2 + margin)
                & (length / 2 - np.abs(along) + np.abs(across) > width / 2 + margin)
                & (np.abs(along) - np.abs(across) < length / 2 - width / 2 - margin))
        return full, half
    full, half = inside(0.05 * width)
    print(f"L/W = {length / width:.3g}, {full.sum()} elements in full shear, {half.sum()} in half")
    print("    d [mm]  theta [deg] theory   error    full    half    F [N]   theory   F/W [N/m]   over theory   net: theta  force/net")
    angle_error, net_error, net_force = [], [], []
    net = Net(surface, width, length, run.time[-1])
    for i in range(1, len(run.time)):
        cosine = (inner + run.travel[i]) / (np.sqrt(2) * inner)
        if cosine >= 1:
            break
        theta = np.pi / 2 - 2 * np.arccos(cosine)
        rate = 2 * run.speed[i] / (np.sqrt(2) * inner * np.sin(np.pi / 4 - theta / 2))
        power = ((width * length - 1.5 * width**2) * surface.force(theta, rate) * rate * np.cos(theta)
                 + width**2 * surface.force(theta / 2, rate / 2) * rate / 2 * np.cos(theta / 2))
        force = power / run.speed[i]
        net_axial, net_angle = net.advance(run.travel[i] - run.travel[i - 1], run.speed[i])
        angle_error.append(run.angle[i] - np.degrees(theta))
        net_error.append(run.angle[i] - np.degrees(net_angle))
        net_force.append(of(run.force[i], net_axial))
        print(f"{1e3 * run.travel[i]:10.3f} {run.angle[i]:9.3f} {np.degrees(theta):8.3f} {angle_error[-1]:8.3f}"
              f" {run.fields[i][full].mean():7.2f} {run.fields[i][half].mean():7.2f} {run.force[i]:9.3f}"
              f" {force:8.3f} {run.force[i] / width:10.3f} {run.force[i] / force:10.3f} {np.degrees(net_angle):12.3f} {run.force[i] / net_axial:10.3f}")
    # The first tenth of the stroke still rings from the sudden start.
    angle_error, net_error, net_force = (
        np.array(e)[run.travel[1:len(e) + 1] >= 0.1 * run.travel[-1]] for e in (angle_error, net_error, net_force))
    print(f"after a tenth of the stroke: central angle off by at most {np.abs(angle_error).max():.3f} deg, from the net"
          f" by {np.abs(net_error).max():.3f} deg, force by {np.abs(net_force).max():.2f} %;"
          f" energy account {100 * run.error:.4f} %, kinetic over internal at the end {run.kinetic[-1]:.1e}")


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        run = Run(Path(sys.argv[1]))
    except (OSError, KeyError, StopIteration) as error:
        print(f"{sys.argv[1]}: not the results of a specimen test ({error!r})", file=sys.stderr)
        return 4
    picture_frame(run) if run.boundary["kind"] == "picture_frame" else bias_extension(run)
    return 0


if __name__ == "__main__":
    sys.exit(main())
