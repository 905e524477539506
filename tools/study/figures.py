"""Pictures of a study's report: SVG texts whose points lead to their runs."""

import html
import io
import itertools
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter  # noqa: E402

STYLE = {"svg.fonttype": "none", "svg.hashsalt": "towform", "font.family": "sans-serif", "font.size": 9, "axes.spines.top": False,
         "axes.spines.right": False, "axes.edgecolor": "#8a93a0", "axes.labelcolor": "#333c47", "xtick.color": "#5b6572",
         "ytick.color": "#5b6572", "axes.grid": True, "grid.color": "#e8ebef", "axes.axisbelow": True, "figure.facecolor": "none",
         "legend.frameon": False}
GOOD, BEYOND, BEST = "#2a6fb0", "#b9c0c9", "#d1495b"


def _svg(figure, links=()):
    """The figure as text; every link of a point gets its run's number as a tip."""
    text = io.StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None}, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)
    svg = text.getvalue()
    svg = svg[svg.index("<svg"):]
    tips = dict(links)
    return re.sub(r'<a xlink:href="([^"]+)">',
                  lambda m: f'<a xlink:href="{m[1]}" target="_blank"><title>{html.escape(tips.get(m[1], ""))}</title>', svg)


def _drawn(function):
    def draw(*arguments, **named):
        with plt.rc_context(STYLE):
            return function(*arguments, **named)
    return draw


def _points(axes, x, y, colours, urls, size=22):
    upwards = np.argsort([colour != BEYOND for colour in colours], kind="stable")  # the good ones on top
    order = [i for i in upwards if np.isfinite(y[i])]
    if order:
        axes.scatter(x[order], y[order], s=size, c=[colours[i] for i in order], linewidths=0.4, edgecolors="white",
                     zorder=3).set_urls([urls[i] for i in order])


def _parameter_axis(axes, parameter, values):
    """Positions of the parameter's values on an axis, which is made for them."""
    if parameter.quantitative:
        present = np.unique([v for v in values])
        if parameter.log or (len(present) > 2 and present.min() > 0 and present.max() / present.min() >= 8):
            axes.set_xscale("log")
            ticks = present if len(present) <= 8 else None
            if ticks is not None:
                axes.set_xticks(ticks)
            elif present.max() / present.min() < 300:
                axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axes.xaxis.set_minor_formatter(NullFormatter())
        else:
            axes.xaxis.set_major_locator(MaxNLocator(5))
        return np.array(values, float)
    names = list(dict.fromkeys(parameter.shown(v) for v in values))
    axes.set_xticks(range(len(names)), names)
    axes.set_xlim(-0.5, len(names) - 0.5)
    return np.array([names.index(parameter.shown(v)) for v in values], float)


@_drawn
def against_parameters(study):
    """Every response against every parameter."""
    rows, columns = len(study.responses), len(study.parameters)
    figure, grid = plt.subplots(rows, columns, figsize=(min(10.5, 3.4 * columns + 0.6), 2.2 * rows), squeeze=False, sharey="row")
    for r, response in enumerate(study.responses):
        y = study.numbers(response.name)
        for c, parameter in enumerate(study.parameters):
            axes = grid[r][c]
            x = _parameter_axis(axes, parameter, study.values(parameter))
            _points(axes, x, y, study.colours, study.urls)
            for limit in (response.low, response.high):
                if limit is not None:
                    axes.axhline(limit, color=BEST, lw=0.8, ls="--")
            if c == 0:
                axes.set_ylabel(_wrapped(response.heading))
            if r == rows - 1:
                axes.set_xlabel(parameter.heading)
    figure.align_ylabels()
    figure.tight_layout()
    return _svg(figure, study.tips)


def _wrapped(text, width=26):
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + len(word) + 1 > width:
            lines.append(word)
        else:
            lines[-1] = f"{lines[-1]} {word}".strip()
    return "\n".join(lines)


@_drawn
def families(study, chosen=None):
    """Of a grid of two parameters: every response over the first, a line for each value of the second."""
    first, second = study.parameters
    responses = [r for r in study.responses if chosen is None or r.name in chosen]
    across = min(2, len(responses))
    down = -(-len(responses) // across)
    figure, grid = plt.subplots(down, across, figsize=(5.2 * across, 3.3 * down), squeeze=False)
    x_all, others = study.values(first), [second.shown(v) for v in study.values(second)]
    names = list(dict.fromkeys(others))
    colours = matplotlib.colormaps["viridis"](np.linspace(0.05, 0.9, len(names)))
    for axes in grid.ravel()[len(responses):]:
        axes.remove()
    for axes, response in zip(grid.ravel(), responses):
        x, y = _parameter_axis(axes, first, x_all), study.numbers(response.name)
        for name, colour in zip(names, colours):
            here = [i for i in np.argsort(x) if others[i] == name and np.isfinite(y[i])]
            if not here:
                continue
            axes.plot(x[here], y[here], "-", color=colour, lw=1.5, label=name)
            axes.scatter(x[here], y[here], s=18, color=[colour], zorder=3).set_urls([study.urls[i] for i in here])
        axes.set_xlabel(first.heading)
        axes.set_ylabel(_wrapped(response.heading, 32))
    grid[0][0].legend(title=second.label, fontsize=8, title_fontsize=8)
    figure.tight_layout()
    return _svg(figure, study.tips)


@_drawn
def sensitivities(parameters, measures):
    """Bars with intervals: measures is [(response heading, [(name of the measure, [Estimate])])]."""
    across = min(3, len(measures))
    down = -(-len(measures) // across)
    size = 3.5 * across, (0.55 * len(parameters) + 1.0) * down
    figure, grid = plt.subplots(down, across, figsize=size, squeeze=False, sharey=True)
    for axes in grid.ravel()[len(measures):]:
        axes.remove()
    for axes, (heading, pair) in zip(grid.ravel(), measures):
        for k, (name, estimates) in enumerate(pair):
            at = np.arange(len(parameters)) + (0.2 if k else -0.2)
            value = np.array([e.value for e in estimates])
            low, high = (np.array([getattr(e, end) for e in estimates]) for end in ("low", "high"))
            error = np.maximum(np.stack([value - low, high - value]), 0.0)
            axes.barh(at, value, 0.36, xerr=error, color=(GOOD, "#8fb8dc")[k], label=name,
                      error_kw={"ecolor": "#333c47", "lw": 0.9, "capsize": 2})
        axes.axvline(0.0, color="#8a93a0", lw=0.8)
        axes.set_yticks(range(len(parameters)), parameters)
        axes.set_title(_wrapped(heading, 34), fontsize=9)
    grid[0][0].invert_yaxis()
    grid[0][0].legend(fontsize=7.5, loc="best")
    figure.tight_layout()
    return _svg(figure)


@_drawn
def pareto(study):
    """Every pair of goals, the Pareto set marked."""
    pairs = list(itertools.combinations(study.goals, 2))[:6]
    across = min(3, len(pairs))
    down = -(-len(pairs) // across)
    figure, grid = plt.subplots(down, across, figsize=(3.6 * across + 0.6, 3.2 * down), squeeze=False)
    for axes in grid.ravel()[len(pairs):]:
        axes.remove()
    for axes, (a, b) in zip(grid.ravel(), pairs):
        x, y = study.numbers(a.name), study.numbers(b.name)
        _points(axes, x, y, study.colours, study.urls)
        if len(study.goals) == 2 and study.best.any():
            order = np.argsort(x[study.best])
            axes.plot(x[study.best][order], y[study.best][order], "-", color=BEST, lw=1.0, zorder=2)
        for response, line in ((a, axes.axvline), (b, axes.axhline)):
            for limit in (response.low, response.high):
                if limit is not None:
                    line(limit, color=BEST, lw=0.8, ls="--")
        axes.set_xlabel(f"{a.heading}, {a.goal}")
        axes.set_ylabel(f"{b.heading}, {b.goal}")
    figure.tight_layout()
    return _svg(figure, study.tips)


@_drawn
def search(study):
    """An optimisation's objective in the order of its runs, and the best so far within the limits."""
    goal = study.goals[0]
    y, order = study.numbers(goal.name), np.arange(1, len(study.runs) + 1)
    sign = 1.0 if goal.goal == "minimise" else -1.0
    within = np.where(study.within, sign * y, np.inf)
    so_far = sign * np.minimum.accumulate(np.where(np.isfinite(within), within, np.inf))
    figure, axes = plt.subplots(figsize=(7.5, 3.0))
    _points(axes, order, y, study.colours, study.urls)
    shown = np.isfinite(so_far)
    axes.step(order[shown], so_far[shown], where="post", color=BEST, lw=1.4, label="best within the limits")
    spread = sum(run.batch == 0 for run in study.runs)
    axes.axvspan(0.5, spread + 0.5, color="#f1f3f6", zorder=0, label="spread over the ranges")
    axes.set_xlim(0.5, len(order) + 0.5)
    axes.set_xlabel("run")
    axes.set_ylabel(_wrapped(goal.heading))
    axes.legend(fontsize=8)
    figure.tight_layout()
    return _svg(figure, study.tips)
