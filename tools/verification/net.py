"""The bias extension of an inextensible net, the answer that a sheet with stiff yarns has to approach."""

import numpy as np


class Net:
    """At each displacement the net shears with the least power: each warp (weft) yarn has one direction all along,
    phi(u) (phi(v)); shear is phi(u) + phi(v) in the middle and phi where the other family is held. At L/W = 2 that is
    the textbook's three regions; at L/W = 3 yarns near the middle cross more of the full shear and turn less. Newton's
    method over the yarns' rates."""

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
