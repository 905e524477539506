"""Results of a picture frame or a bias extension beside their theory, frame by frame.

picture frame    shear angle theta = pi/2 - 2 acos(1/sqrt 2 + d/(2L))                             (Eq. 13)
                 rate d'/(L sin(pi/4 - theta/2))                                                  (Eq. 14)
                 axial force 2 N_s L cos(pi/4 - theta/2)
bias extension   central shear angle theta = pi/2 - 2 acos((D + d)/(sqrt 2 D)), D = L - W
                 force from the power of the three regions, per reference area: full shear on
                 W L - 3 W^2/2, half the angle at half the rate on W^2, none under the grips;
                 F d' = sum of A N_s(theta, rate) rate cos(theta); beside it, the net of least power (net.py)

The rate is that of the kinematics.
"""

from dataclasses import dataclass

import numpy as np

from towform_results import Results
from verification.net import Net
from verification.surface import Surface, si


class Specimen:
    """What a specimen test left behind, at its frames. Raises OSError, KeyError or StopIteration for other results."""

    def __init__(self, directory):
        results = Results(directory)
        self.case = results.case
        self.size = [si(v) for v in self.case["blank"]["size"]]
        self.boundary = next(b for b in self.case.get("boundary", []) if "motion" in b)
        self.kind = "picture frame" if self.boundary["kind"] == "picture_frame" else "bias extension"
        self.middle = results.centres
        distance = np.hypot(*self.middle.T)
        ring = np.flatnonzero(distance < distance.min() + 1e-9)
        frames = [results.frame(i) for i in range(len(results))]
        self.time = results.times
        self.fields = [frame.shear_angle for frame in frames]
        self.angle = np.array([field[ring].mean() for field in self.fields])  # [deg]
        self.rate = np.array([frame.shear_rate[ring].mean() for frame in frames])  # [rad/s]
        self.scatter = np.array([np.abs(f - a).max() for f, a in zip(self.fields, self.angle)])
        history, name = results.history, self.boundary["name"]
        self.force = np.interp(self.time, history["time_s"], history[f"force_{name}_N"])
        self.travel = np.interp(self.time, history["time_s"], history[f"position_{name}_m"])
        pace = np.diff(self.travel) / np.diff(self.time)
        self.speed = np.concatenate(([pace[0]], 0.5 * (pace[1:] + pace[:-1]), [pace[-1]]))
        # While the speed changes, frames are too far apart to say what it is.
        change = np.concatenate(([0], np.abs(np.diff(pace)), [0]))
        change[0] = change[1]
        self.steady = change < 1e-3 * np.abs(pace).max()
        self.energy_error = history["energy_error"][-1]


def percent(value, exact):
    return 100 * (value / exact - 1)


@dataclass
class FramePoint:
    travel: float  # [m]
    angle: float  # [deg]
    exact_angle: float
    rate: float  # [rad/s]
    exact_rate: float
    force: float  # [N]
    exact_force: float
    scatter: float  # element to element [deg]
    steady: bool


def frame_kinematics(arm, travel, speed):
    """Shear angle and rate of a picture frame (Eqs. 13 and 14) [rad, rad/s]."""
    theta = np.pi / 2 - 2 * np.arccos(1 / np.sqrt(2) + travel / (2 * arm))
    return theta, speed / (arm * np.sin(np.pi / 4 - theta / 2))


def picture_frame(run):
    surface, arm, points = Surface(run.case), run.size[0], []
    for i in range(1, len(run.time)):
        theta, rate = frame_kinematics(arm, run.travel[i], run.speed[i])
        axial = 2 * surface.force(theta, rate) * arm * np.cos(np.pi / 4 - theta / 2)
        points.append(FramePoint(run.travel[i], run.angle[i], np.degrees(theta), run.rate[i], rate, run.force[i], axial,
                                 run.scatter[i], run.steady[i]))
    return points


def frame_errors(points):
    """Largest errors at steady speed: angle [deg], rate [%], force [%]."""
    steady = [p for p in points if p.steady]
    return (max(abs(p.angle - p.exact_angle) for p in steady),
            max(abs(percent(p.rate, p.exact_rate)) for p in steady),
            max(abs(percent(p.force, p.exact_force)) for p in steady))


@dataclass
class BiasPoint:
    travel: float  # [m]
    angle: float  # in the middle [deg]
    exact_angle: float
    full: float  # mean over the region of full shear [deg]
    half: float
    force: float  # [N]
    exact_force: float
    net_angle: float  # [deg]
    net_force: float  # [N]
    width: float  # [m]


def bias_extension(run):
    surface = Surface(run.case)
    upright = run.boundary["edge"] in ("top", "bottom")
    width, length = run.size if upright else run.size[::-1]
    across, along = run.middle.T if upright else run.middle.T[::-1]
    inner, margin = length - width, 0.05 * width
    # Well inside each region: the central hexagon (a diamond at L/W = 2) and the four half-sheared triangles.
    reach = np.abs(across) + np.abs(along) - (length - width) / 2
    full = reach < -margin
    half = ((reach > margin) & (length / 2 - np.abs(along) + np.abs(across) > width / 2 + margin)
            & (np.abs(along) - np.abs(across) < length / 2 - width / 2 - margin))
    net, points = Net(surface, width, length, run.time[-1]), []
    for i in range(1, len(run.time)):
        cosine = (inner + run.travel[i]) / (np.sqrt(2) * inner)
        if cosine >= 1:
            break
        theta = np.pi / 2 - 2 * np.arccos(cosine)
        rate = 2 * run.speed[i] / (np.sqrt(2) * inner * np.sin(np.pi / 4 - theta / 2))
        power = ((width * length - 1.5 * width**2) * surface.force(theta, rate) * rate * np.cos(theta)
                 + width**2 * surface.force(theta / 2, rate / 2) * rate / 2 * np.cos(theta / 2))
        net_force, net_angle = net.advance(run.travel[i] - run.travel[i - 1], run.speed[i])
        points.append(BiasPoint(run.travel[i], run.angle[i], np.degrees(theta), run.fields[i][full].mean(),
                                run.fields[i][half].mean(), run.force[i], power / run.speed[i], np.degrees(net_angle),
                                net_force, width))
    return points


def bias_errors(points):
    """Largest errors after the first tenth of the stroke, which still rings from the sudden start: angle from the
    textbook and from the net [deg], force from the textbook and from the net [%]."""
    late = [p for p in points if p.travel >= 0.1 * points[-1].travel]
    return (max(abs(p.angle - p.exact_angle) for p in late), max(abs(p.angle - p.net_angle) for p in late),
            max(abs(percent(p.force, p.exact_force)) for p in late), max(abs(percent(p.force, p.net_force)) for p in late))
