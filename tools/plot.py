#!/usr/bin/python3
"""Draw a formed sheet, coloured by a field, from results.h5, or the curves of history.csv."""

import argparse
import csv
import sys
from pathlib import Path

import h5py
import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

DPI = 160
OVERSAMPLING = 3  # drawn without antialiasing and averaged: no seams between triangles
VIEWS = {"iso": (-60.0, 35.0), "top": (-90.0, 90.0), "side": (-90.0, 0.0)}  # azimuth, elevation [deg]
DISPLAY = {"m": [("mm", 1e3)], "Pa": [("MPa", 1e-6), ("kPa", 1e-3)], "deg": [("°", 1.0)], "1": [("", 1.0)]}
COMPONENTS = {"x": 0, "y": 1, "z": 2, "1": 0, "2": 1}
PALETTE = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]  # Okabe and Ito
USAGE, FILES = 2, 4


class PlotError(Exception):
    """What the user sees, and what the shell gets."""

    def __init__(self, message, code=USAGE):
        super().__init__(message)
        self.code = code


# --- reading ---------------------------------------------------------------------------------------------------


def open_results(path):
    path = path / "results.h5" if path.is_dir() else path
    if not path.exists():
        raise PlotError(f"{path}: no such file", FILES)
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        raise PlotError(f"{path}: not a readable HDF5 file ({error})", FILES) from None
    if "mesh/triangles" not in file or "frames" not in file:
        raise PlotError(f"{path}: not a towform results file", FILES)
    return file


def pick_frame(file, number):
    names = sorted(file["frames"], key=lambda name: (len(name), name))
    if not names:
        raise PlotError(f"{file.filename}: has no frame yet", FILES)
    if not -len(names) <= number < len(names):
        raise PlotError(f"frame {number} is out of range: there are {len(names)}, 0 to {len(names) - 1}")
    name = names[number]
    return name, file["frames"][name]


def pick_field(frame, wanted, triangles, absolute):
    """Values per triangle, label and units; a vector without a component is its magnitude."""
    name, _, component = wanted.partition(".")
    if name not in frame:
        raise PlotError(f"no field {wanted}; there are {', '.join(sorted(frame))}")
    data = frame[name][...].astype(float)
    label = name.replace("_", " ")
    if data.ndim == 2:
        if not component:
            data = np.linalg.norm(data, axis=1) if data.shape[1] == 3 else np.abs(data).max(axis=1)
            label = f"|{label}|"
        elif COMPONENTS.get(component, 9) < data.shape[1]:
            data = data[:, COMPONENTS[component]]
            label = f"{label} {component}"
        else:
            raise PlotError(f"{name} has no component {component}; there are {data.shape[1]}, as in {name}.1")
    elif component:
        raise PlotError(f"{name} is a scalar and has no component {component}")
    if absolute and not label.startswith("|"):
        data, label = np.abs(data), f"|{label}|"
    if len(data) != len(triangles):
        data = data[triangles].mean(axis=1)
    return data, label, frame[name].attrs.get("units", "1")


def display_units(values, units):
    """The prefix that keeps the largest value at 1 or more."""
    largest = np.nanmax(np.abs(values), initial=0.0)
    for shown, factor in DISPLAY.get(units, []):
        if largest * factor >= 1.0 or len(DISPLAY[units]) == 1:
            return values * factor, shown
    return values, units


# --- drawing the sheet -----------------------------------------------------------------------------------------


def turned_up(points):
    """A sheet pressed downwards is turned over about x, so that the dome and not the hole is seen."""
    z = points[:, 2]
    pressed_down = z.max() - np.median(z) < np.median(z) - z.min()
    return points * [1, -1, -1] if pressed_down else points


def projected(points, view):
    """Orthographic: x to the right, y up, z to the viewer."""
    azimuth, elevation = np.radians(VIEWS[view])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    to_viewer = np.array([np.cos(azimuth) * np.cos(elevation), np.sin(azimuth) * np.cos(elevation), np.sin(elevation)])
    return points @ np.column_stack([right, np.cross(to_viewer, right), to_viewer])


def shaded(colours, points, triangles):
    """Light from over the viewer's left shoulder on normals smoothed over the nodes; both faces are lit."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    facet = np.cross(b - a, c - a)
    nodal = np.zeros_like(points)
    for k in range(3):
        np.add.at(nodal, triangles[:, k], facet)
    normal = nodal[triangles].sum(axis=1)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    normal *= np.where(normal[:, 2:] < 0.0, -1.0, 1.0)
    light = np.array([-0.45, 0.55, 0.70]) / np.linalg.norm([-0.45, 0.55, 0.70])
    half = (light + [0, 0, 1]) / np.linalg.norm(light + [0, 0, 1])
    diffuse = np.clip(normal @ light, 0.0, 1.0)[:, None]
    gloss = np.clip(normal @ half, 0.0, 1.0)[:, None] ** 30
    return np.clip(colours * (0.62 + 0.43 * diffuse) + 0.08 * gloss, 0.0, 1.0)


def sheet_image(points, triangles, colours, centre, metres_per_pixel, width, height):
    """The sheet alone as RGBA pixels."""
    order = np.argsort(points[triangles, 2].mean(axis=1), kind="stable")
    figure = Figure(figsize=(width * OVERSAMPLING / 100, height * OVERSAMPLING / 100), dpi=100)
    figure.patch.set_alpha(0.0)
    axes = figure.add_axes([0, 0, 1, 1])
    axes.axis("off")
    half = 0.5 * metres_per_pixel * np.array([width, height])
    axes.set(xlim=(centre[0] - half[0], centre[0] + half[0]), ylim=(centre[1] - half[1], centre[1] + half[1]))
    axes.add_collection(PolyCollection(points[triangles[order], :2], facecolors=colours[order], linewidths=0,
                                       antialiaseds=False))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba(), dtype=float) / 255.0
    pixels = pixels[: height * OVERSAMPLING, : width * OVERSAMPLING]
    pixels[..., :3] *= pixels[..., 3:]
    pixels = pixels.reshape(height, OVERSAMPLING, width, OVERSAMPLING, 4).mean(axis=(1, 3))
    pixels[..., :3] /= np.maximum(pixels[..., 3:], 1e-9)
    return np.clip(pixels, 0.0, 1.0)


def scale_bar(figure, metres_per_pixel, size):
    """A round length of about a tenth of the picture, in its lower left corner."""
    wanted = 0.12 * size[0] * metres_per_pixel
    length = max(s * 10.0**e for e in range(-6, 3) for s in (1, 2, 5) if s * 10.0**e <= wanted)
    x0, y0 = 0.04, 0.06
    x1 = x0 + length / metres_per_pixel / size[0]
    figure.add_artist(matplotlib.lines.Line2D([x0, x1], [y0, y0], color="0.25", linewidth=1.6, solid_capstyle="butt"))
    figure.text(0.5 * (x0 + x1), y0 + 0.012, f"{1e3 * length:g} mm", ha="center", va="bottom", color="0.25", fontsize=9)


def draw_sheet(options):
    with open_results(options.results) as file:
        frame_name, frame = pick_frame(file, options.frame)
        triangles = file["mesh/triangles"][...]
        points = frame["position"][...]
        values, label, units = pick_field(frame, options.field, triangles, options.abs)
        title, time = str(file.attrs.get("title", "")), float(frame.attrs["time"])
        output = options.output or Path(file.filename).with_name(f"{options.field}_{frame_name}.png")
    values, units = display_units(values, units)
    low, high = options.range or (np.nanmin(values), np.nanmax(values))
    if high - low <= 1e-9 * max(abs(low), abs(high), 1e-9):  # one value everywhere: no false patches from rounding
        low, high = low - 0.5, high + 0.5
    scale = ScalarMappable(Normalize(low, high), options.cmap)

    view = projected(turned_up(points) if options.view == "iso" else points, options.view)
    width, height = options.size
    colours = shaded(scale.to_rgba(values)[:, :3], view, triangles)
    lowest, highest = view[:, :2].min(axis=0), view[:, :2].max(axis=0)
    area = np.array([0.80 * width, 0.84 * height])  # the colour bar and the title keep the rest
    metres_per_pixel = max((highest - lowest) / (0.94 * area))
    # The sheet's middle goes to the middle of that area, which is left of and below the picture's.
    centre = 0.5 * (lowest + highest) + metres_per_pixel * np.array([0.07 * width, 0.035 * height])

    figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    figure.figimage(sheet_image(view, triangles, colours, centre, metres_per_pixel, width, height), zorder=0)
    figure.text(0.04, 0.945, title, fontsize=13, weight="bold", color="0.1", va="center")
    figure.text(0.04, 0.895, f"{label}, t = {1e3 * time:.4g} ms", fontsize=10.5, color="0.35", va="center")
    axes = figure.add_axes([0.875, 0.2, 0.017, 0.6])
    ends = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
    bar = figure.colorbar(scale, cax=axes, extend=ends[bool(np.nanmin(values) < low), bool(np.nanmax(values) > high)])
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=0, labelsize=9, labelcolor="0.25")
    bar.ax.set_title(f"{label}\n[{units}]" if units else label, fontsize=9.5, color="0.25", pad=10, loc="center")
    scale_bar(figure, metres_per_pixel, (width, height))
    save(figure, output)


# --- drawing the history ---------------------------------------------------------------------------------------


def read_history(path):
    path = path if path.suffix == ".csv" else (path if path.is_dir() else path.parent) / "history.csv"
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        data = np.array([[float(cell) for cell in row] for row in rows[1:]])
    except (OSError, ValueError) as error:
        raise PlotError(f"{path}: {getattr(error, 'strerror', None) or error}", FILES) from None
    if data.ndim != 2 or "time_s" not in rows[0] or data.shape[1] != len(rows[0]):
        raise PlotError(f"{path}: not a history: a column time_s and a row are needed", FILES)
    return path, dict(zip(rows[0], data.T))


def draw_history(options):
    path, columns = read_history(options.results)
    time = 1e3 * columns["time_s"]

    def chosen(prefix, suffix):
        return {name[len(prefix): -len(suffix)].replace("_", " "): values for name, values in columns.items()
                if name.startswith(prefix) and name.endswith(suffix)}

    panels = [("force [N]", chosen("force_", "_N"), 1.0), ("energy [J]", chosen("energy_", "_J"), 1.0),
              ("energy error [%]", {"": columns["energy_error"]} if "energy_error" in columns else {}, 100.0)]
    panels = [panel for panel in panels if panel[1]]
    if not panels:
        raise PlotError(f"{path}: no force, energy or energy_error column", FILES)
    width, height = options.size
    figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor="white", layout="constrained")
    FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.12, h_pad=0.08)
    ratios = [1 if label.startswith("energy error") else 2 for label, _, _ in panels]
    for axes, (label, curves, factor) in zip(
            figure.subplots(len(panels), 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": ratios})[:, 0], panels):
        for number, (name, values) in enumerate(curves.items()):
            axes.plot(time, factor * values, color=PALETTE[number % len(PALETTE)], linewidth=1.6, label=name,
                      linestyle=["-", "--", ":"][number // len(PALETTE) % 3])
        axes.set_ylabel(label)
        axes.grid(color="0.92")
        axes.spines[["top", "right"]].set_visible(False)
        axes.margins(x=0.01)
        if list(curves) != [""]:
            axes.legend(frameon=False, fontsize=9, loc="center left", bbox_to_anchor=(1.0, 0.5))
    axes.set_xlabel("time [ms]")
    figure.align_ylabels()
    save(figure, options.output or path.with_suffix(".png"))


# --- command line ----------------------------------------------------------------------------------------------


def save(figure, path):
    try:
        figure.savefig(path, dpi=DPI)
    except (OSError, ValueError) as error:
        raise PlotError(f"{path}: cannot be written: {getattr(error, 'strerror', None) or error}", FILES) from None
    print(path)


def numbers(separator, kind, check):
    def parse(text):
        try:
            first, second = (kind(part) for part in text.split(separator))
        except ValueError:
            first = second = None
        if first is None or not check(first, second):
            raise argparse.ArgumentTypeError(f"{text!r} is not two numbers with {separator!r} between that make sense")
        return first, second

    return parse


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="examples:\n"
               "  tools/plot.py out/double_dome/results.h5\n"
               "  tools/plot.py out/double_dome --field contact_pressure --frame 10 --view top -o pressure.png\n"
               "  tools/plot.py out/double_dome --field fibre_strain.1 --range=-0.01,0.01\n"
               "  tools/plot.py out/double_dome --history\n\n"
               "exit codes: 0 done, 2 wrong arguments, 4 a file cannot be read or written")
    parser.add_argument("results", type=Path, metavar="RESULTS", help="results.h5, or the directory it is in")
    parser.add_argument("--field", default="shear_angle",
                        help="element or node field, a component as in velocity.z or fibre_strain.1 (default: shear_angle)")
    parser.add_argument("--frame", type=int, default=-1, help="number of the frame, negative from the end (default: -1)")
    parser.add_argument("--view", choices=VIEWS, default="iso",
                        help="iso turns a sheet that was pressed down over (default: iso)")
    parser.add_argument("--abs", action="store_true", help="colour by the absolute value")
    parser.add_argument("--range", type=numbers(",", float, lambda low, high: low < high), metavar="LOW,HIGH",
                        help="ends of the colour scale, in the units shown (default: those of the values)")
    parser.add_argument("--cmap", default="viridis", help="a colour map of matplotlib (default: viridis)")
    parser.add_argument("--size", type=numbers("x", int, lambda w, h: 200 <= w <= 10000 and 200 <= h <= 10000),
                        default=(1600, 1000), metavar="WxH", help="of the picture in pixels (default: 1600x1000)")
    parser.add_argument("--history", action="store_true", help="draw history.csv: forces, energies and energy error in time")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="default: FIELD_FRAME.png or history.png beside the results")
    options = parser.parse_args(arguments)
    if options.cmap not in matplotlib.colormaps:
        parser.error(f"no colour map {options.cmap}; good ones are viridis, cividis, plasma, coolwarm")
    return options


def main(arguments=None):
    options = parse_arguments(arguments)
    try:
        draw_history(options) if options.history else draw_sheet(options)
    except PlotError as error:
        print(f"plot.py: {error}", file=sys.stderr)
        return error.code
    return 0


if __name__ == "__main__":
    sys.exit(main())
