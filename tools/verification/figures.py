"""The paper's Figures 8, 9, 10, 11 and 13 from towform's own results, and the laws beside the surface."""

import csv
import subprocess

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from plot import PALETTE, projected, shaded, sheet_image, turned_up
from towform_results import Results
from verification import law_checks, paper_checks
from verification.runs import PROGRAM, ROOT
from verification.specimen_checks import FRAME_INCREMENTAL
from verification.specimens import Specimen, frame_kinematics

IMAGES = ROOT / "docs/images"
DPI = 110


def new_figure(width, height, **options):
    figure = Figure(figsize=(width, height), dpi=DPI, facecolor="white", **options)
    FigureCanvasAgg(figure)
    return figure


def save(figure, name):
    IMAGES.mkdir(exist_ok=True)
    figure.savefig(IMAGES / name, dpi=DPI)
    return name


def tidy(axes, x, y):
    axes.set(xlabel=x, ylabel=y)
    axes.grid(color="0.92")
    axes.spines[["top", "right"]].set_visible(False)


# --- Figure 8 ------------------------------------------------------------------------------------------------


def predicted(workshop):
    """N_s from `towform material predict`: rates, angles, forces, and the five curves of its curve file."""
    angles, rates = np.linspace(0.5, 70, 60), np.linspace(0.02, 1.1, 40)
    table, curves = workshop.directory / "figure_08.csv", workshop.directory / "figure_08.txt"
    subprocess.run([PROGRAM, "material", "predict", ROOT / "cases/double_dome.toml", "--table", table, "-o", curves,
                    "--rates", *(f"{r:.6g}" for r in rates), "--angles", *(f"{a:.6g}" for a in angles),
                    "--set", "material.curve_rate_min=0.2", "--set", "material.curve_rate_max=1",
                    "--set", "material.curve_count=5"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    with open(table, newline="") as file:
        forces = np.array([float(row["shear_force_N_per_m"]) for row in csv.DictReader(file)])
    return angles, rates, forces.reshape(len(rates), len(angles)), read_curves(curves)


def read_curves(path):
    """Rates and polynomial coefficients of a curve file, and the angle up to which they hold [rad]."""
    curves, limit = [], None
    for line in path.read_text().splitlines():
        words = line.split()
        if line.startswith("max_angle"):
            limit = np.radians(float(words[1]))
        elif line[:1].isdigit():  # rate, fit error, coefficients
            curves.append((float(words[0]), np.array([float(w) for w in words[2:]])))
    return limit, curves


def figure_8(workshop):
    angles, rates, forces, (limit, curves) = predicted(workshop)
    figure = new_figure(8.2, 5.6)
    axes = figure.add_axes([0.0, 0.02, 0.86, 0.98], projection="3d", computed_zorder=False)
    x, y = np.meshgrid(angles, rates)
    greys = LinearSegmentedColormap.from_list("greys", ["0.88", "0.05"])
    surface = axes.plot_surface(x, y, forces, cmap=greys, vmin=0, rstride=1, cstride=1, linewidth=0,
                                antialiased=False, alpha=1.0)
    for rate, coefficients in curves:
        theta = np.radians(angles)
        force = np.polynomial.polynomial.polyval(2 * theta / limit - 1, coefficients)
        axes.plot(angles, np.full_like(angles, rate), force + 0.005 * forces.max(), color=PALETTE[1], linewidth=2.2)
    axes.set(xlabel="shear angle [deg]", ylabel="angular rate [rad/s]", zlabel="shear force [N/m]")
    axes.view_init(28, -128)
    figure.colorbar(surface, cax=figure.add_axes([0.9, 0.25, 0.018, 0.5]), label="shear force [N/m]")
    return save(figure, "figure_08.png")


# --- Figures 9, 10, 11: picture frame ------------------------------------------------------------------------


def figure_9(directory):
    results, specimen = Results(directory), Specimen(directory)
    figure = new_figure(9.0, 7.6)
    scale, cmap = Normalize(1, 50), colormaps["viridis"]
    for number, angle in enumerate((19, 38, 55, 76)):
        frame = results.frame(int(np.argmin(np.abs(specimen.angle - angle))))
        row, column = divmod(number, 2)
        axes = figure.add_axes([0.03 + 0.43 * column, 0.52 - 0.48 * row, 0.40, 0.42])
        corners = 1e3 * frame.position[results.triangles][:, :, :2]
        axes.add_collection(PolyCollection(corners, facecolors=cmap(scale(frame.curve_index)), edgecolors="none"))
        axes.add_collection(PolyCollection(square_outlines(corners), facecolors="none", edgecolors="white", linewidths=0.6))
        axes.set_aspect("equal")
        axes.autoscale_view()
        axes.axis("off")
        axes.set_title(f"({'abcd'[number]}) {np.abs(frame.shear_angle).mean():.0f} deg", fontsize=11)
    figure.colorbar(ScalarMappable(scale, cmap), cax=figure.add_axes([0.9, 0.25, 0.02, 0.5]), label="curve indicator")
    return save(figure, "figure_09.png")


def square_outlines(corners):
    """Quadrilaterals from pairs of triangles that share their diagonal, in the order of the file."""
    outlines = []
    for first, second in zip(corners[0::2], corners[1::2]):
        points = np.unique(np.round(np.concatenate((first, second)), 9), axis=0)
        middle = points.mean(axis=0)
        outlines.append(points[np.argsort(np.arctan2(*(points - middle).T[::-1]))])
    return outlines


def figure_10(specimen):
    theta, rate = frame_kinematics(specimen.size[0], specimen.travel, specimen.speed)
    figure = new_figure(10.0, 4.0, layout="constrained")
    left, right = figure.subplots(1, 2)
    for axes, exact, ours, label in ((left, np.degrees(theta), specimen.angle, "shear angle [deg]"),
                                     (right, np.degrees(rate), np.degrees(specimen.rate), "angular rate [deg/s]")):
        axes.plot(specimen.time, exact, color="black", linewidth=3.2, label="ideal")
        axes.plot(specimen.time[1:], ours[1:], color="0.7", linewidth=1.4, label="towform, middle element")
        tidy(axes, "time [s]", label)
    left.legend(frameon=False)
    return save(figure, "figure_10.png")


def figure_11(directory):
    results, specimen = Results(directory), Specimen(directory)
    middle = int(np.argmin(np.hypot(*results.centres.T)))
    index = [results.frame(i).curve_index[middle] for i in range(len(results))]
    figure = new_figure(6.4, 4.0, layout="constrained")
    axes = figure.subplots()
    axes.step(specimen.angle[1:], index[1:], color=PALETTE[0], where="mid")
    tidy(axes, "shear angle [deg]", "curve indicator")
    return save(figure, "figure_11.png")


def specimens(workshop):
    directory = workshop.form(FRAME_INCREMENTAL)
    return ((figure_8(workshop), "Figure 8: shear force over angle and rate at 190 degC, with five of the curves that "
                                 "replace it (rates 0.2 to 1 rad/s)."),
            (figure_9(directory), "Figure 9: the picture frame at 19, 38, 55 and 76 degrees; colour is the curve in use."),
            (figure_10(Specimen(directory)), "Figure 10: shear angle and rate of the frame's middle, ideal and computed."),
            (figure_11(directory), "Figure 11: the curve in use in the frame's middle over its shear angle."))


# --- the laws ------------------------------------------------------------------------------------------------


def laws(workshop):
    figure = new_figure(9.0, 4.4, layout="constrained")
    axes = figure.subplots()
    for number, law in enumerate(law_checks.LAWS):
        history = law_checks.frame_history(workshop.form(law_checks.frame_run(law)))
        if number == 0:
            axes.plot(1e3 * history.time, history.exact, color="0.75", linewidth=5, label="surface N(angle, rate)")
        axes.plot(1e3 * history.time, history.force, color=PALETTE[number], linewidth=1.5, label=law)
    tidy(axes, "time [ms]", "shear force [N/m]")
    axes.legend(frameon=False)
    return ((save(figure, "laws.png"), "A frame opened at 10 rad/s, at 1 rad/s, held and closed at 10 rad/s."),)


# --- Figure 13 -----------------------------------------------------------------------------------------------


def dome_panel(figure, place, frame, triangles, values, scale, cmap, width):
    """A formed sheet seen obliquely, in a part of the figure (fractions: left, bottom, width, height) `width` m wide."""
    pixels = [int(round(p * DPI * s)) for p, s in zip(place[2:], figure.get_size_inches())]
    view = projected(turned_up(frame.position), "iso")
    colours = shaded(cmap(scale(values))[:, :3], view, triangles)
    low, high = view[:, :2].min(axis=0), view[:, :2].max(axis=0)
    image = sheet_image(view, triangles, colours, 0.5 * (low + high), width / pixels[0], *pixels)
    axes = figure.add_axes(place)
    axes.imshow(image, interpolation="none")
    axes.axis("off")


def figure_13(directory, name):
    results = Results(directory)
    figure = new_figure(9.0, 12.6)
    width = 1.03 * np.ptp(projected(results.reference, "iso")[:, 0])  # the flat blank is the widest
    shear, index = (Normalize(0, 40), colormaps["viridis"]), (Normalize(1, 20), colormaps["cividis"])
    for row, time in enumerate((0.0, *paper_checks.TIMES)):
        frame, bottom = results.at(time), 0.765 - 0.235 * row
        for column, (values, (scale, cmap)) in enumerate(((np.abs(frame.shear_angle), shear), (frame.curve_index, index))):
            dome_panel(figure, (0.04 + 0.48 * column, bottom, 0.46, 0.22), frame, results.triangles, values, scale, cmap, width)
        figure.text(0.02, bottom + 0.20, f"{time:g} s", fontsize=11)
    for left, (scale, cmap), label in ((0.1, shear, "shear angle [deg]"), (0.58, index, "curve indicator")):
        figure.colorbar(ScalarMappable(scale, cmap), cax=figure.add_axes([left, 0.035, 0.34, 0.01]),
                        orientation="horizontal", label=label)
    return save(figure, name)


def paper(workshop):
    return ((figure_13(workshop.form(paper_checks.PAPER), "figure_13_incremental.png"),
             "Figure 13 with the paper's law: shear angle and curve indicator at 0, 0.02, 0.04 and 0.06 s."),
            (figure_13(workshop.form(paper_checks.VISCOUS), "figure_13_viscous.png"),
             "The same press with the viscous law."))
