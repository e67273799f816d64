# SPDX-License-Identifier: BSD-3-Clause
"""Charts with logarithmic axes, by matplotlib; none where there is no matplotlib."""

import math
from dataclasses import dataclass, field

from .curves import fit, interpolate
from .results import values_of

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator
except ImportError:
    plt = None

MIB = 1048576
# Memory, in MiB, at which techniques are marked beside each other.
EQUAL_MEMORY = (2, 8, 32, 128, 512)
# The families in which a number grows, with that number's name in words.
GROWTH = {"triangles": "triangles", "actors": "actors", "lights": "lights", "window": "pixels",
          "outside": "triangles, most behind the camera"}

_MARKERS = "osDx+"
# Greys for what others are compared with; the rest can be told apart by the colour-blind (Okabe and
# Ito).
_YARDSTICKS = {"none": "#bebebe", "vtk": "#282828", "vtk-kept": "#828282"}
_PALETTE = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#966e3c")
_given = {}


def _colour(technique):
    if technique in _YARDSTICKS:
        return _YARDSTICKS[technique]
    return _given.setdefault(technique, _PALETTE[len(_given) % len(_PALETTE)])


@dataclass
class _Chart:
    title: str
    x_title: str
    y_title: str = "wrong pixels, % of those that face the light"
    lines: list = field(default_factory=list)   # (technique, name, xs, ys), and how: keywords of plot()
    marks: list = field(default_factory=list)   # (name, xs, ys)
    labels: list = field(default_factory=list)  # (text, x, y)


def _tick(value, _position=None):
    if value >= 1e6:
        return f"{value / 1e6:g} M"
    return f"{value / 1e3:g} k" if value >= 1e4 else f"{value:g}"


# 1, 2, 5 of each decade, or less where that is too many, more where it is too few.
def _set_ticks(axis, low, high):
    decades = math.log10(high / low)
    steps = (1,) if decades > 3.5 else (1, 2, 5) if decades > 0.9 else (
        1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9)
    axis.set_major_locator(LogLocator(base=10, subs=steps, numticks=50))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(_tick))


# Names of points stand in a column at the right, one below the other, each with a line to its point.
def _put_labels(axes, labels):
    ordered = sorted(labels, key=lambda label: label[2])
    step, heights = 0.03, []
    for _, x, y in ordered:
        own = axes.transAxes.inverted().transform(axes.transData.transform((x, y)))[1]
        heights.append(max(own, heights[-1] + step) if heights else own)
    limit = 1 - step
    for i in reversed(range(len(heights))):
        heights[i] = limit = min(heights[i], limit)
        limit -= step
    for (text, x, y), height in zip(ordered, heights):
        axes.annotate(text, (x, y), (0.78, height), textcoords="axes fraction", fontsize=8,
                      va="center", arrowprops={"arrowstyle": "-", "color": "#aaaaaa", "lw": 0.8,
                                               "shrinkA": 1, "shrinkB": 0})


def _range(values, room=0.0):
    logs = [math.log10(value) for value in values if value > 0] or [0.0]
    low, high = min(logs), max(logs)
    margin = max(0.06 * (high - low), 0.02)
    return 10 ** (low - margin), 10 ** (high + margin + room * (high - low))


def write(chart, path):
    """Draw it into a PNG file, if matplotlib is there."""
    if plt is None:
        return
    figure, axes = plt.subplots(figsize=(9, 5.6))
    axes.set(title=chart.title, xlabel=chart.x_title, ylabel=chart.y_title, xscale="log",
             yscale="log")
    xs = [x for line in chart.lines for x in line[2]]
    ys = [y for line in chart.lines for y in line[3]]
    limits = _range(xs, 0.5 if chart.labels else 0.0), _range(ys)
    axes.set(xlim=limits[0], ylim=limits[1])
    for axis, (low, high) in zip((axes.xaxis, axes.yaxis), limits):
        _set_ticks(axis, low, high)
    for technique, name, line_xs, line_ys, how in chart.lines:
        axes.plot(line_xs, line_ys, **{"color": _colour(technique), "label": name, "lw": 2.2, **how})
    for (name, mark_xs, mark_ys), marker in zip(chart.marks, _MARKERS):
        axes.plot(mark_xs, mark_ys, marker, color="#141414", fillstyle="none", label=name)
    _put_labels(axes, chart.labels)
    axes.grid(color="#e4e4e4")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False, fontsize=9)
    figure.savefig(path, dpi=100, bbox_inches="tight", metadata={"Software": None})
    plt.close(figure)


def maps_of(results, scene, technique):
    """Of a scene of the family maps, by one technique, from small maps to large ones."""
    maps = [line for line in results.family("maps") if line.key("scene") == scene and
            line.key("technique") == technique and line.has("wrong_percent")]
    return sorted(maps, key=lambda line: line.value("resolution"))


def at_memory(maps, mebibytes):
    """Milliseconds and wrong % of a technique where its maps take that much memory, between the
    nearest two resolutions; None where no resolution takes as much, or as little."""
    memory = [line.value("memory_bytes") / MIB for line in maps]
    found = [interpolate(memory, [line.value(counter) for line in maps], mebibytes)
             for counter in ("ms", "wrong_percent")]
    return None if None in found else found


def error_chart(results, scene):
    """Error against milliseconds, a curve a technique, along the resolutions."""
    chart = _Chart(f"{scene}: wrong pixels against time", "milliseconds a frame, camera moving")
    places = {memory: ([], []) for memory in EQUAL_MEMORY}
    for technique in values_of(results.family("maps"), "technique"):
        maps = maps_of(results, scene, technique)
        if maps:
            xs = [line.value("ms") for line in maps]
            ys = [line.value("wrong_percent") for line in maps]
            chart.lines.append((technique, technique, xs, ys, {"marker": "."}))
        for memory, (xs, ys) in places.items():
            at = at_memory(maps, memory)
            if at:
                xs.append(at[0])
                ys.append(at[1])
    chart.marks = [(f"{memory} MiB", xs, ys) for memory, (xs, ys) in places.items() if xs]
    return chart


def growth_points(results, family, technique):
    """A technique's milliseconds over what grows; of the window, over its pixels."""
    lines = [line for line in results.family(family) if line.key("technique") == technique]

    def grown(line):
        if family == "window":
            return line.value("width") * line.value("height")
        return line.value("triangles" if family == "outside" else family)
    return [grown(line) for line in lines], [line.value("ms") for line in lines]


def growth_chart(results, family):
    """Milliseconds over what grows, with a power fitted to each technique's."""
    lines = results.family(family)
    scene = values_of(lines, "scene")[0]
    chart = _Chart(f"{scene}: time against {GROWTH[family]}", GROWTH[family],
                   "milliseconds a frame, camera moving")
    for technique in values_of(lines, "technique"):
        xs, ys = growth_points(results, family, technique)
        law = fit(xs, ys)
        name = technique + (f"  ~ n^{law.exponent:.2f}" if law else "")
        if law:
            ends = [xs[0], xs[-1]]
            chart.lines.append((technique, None, ends, [law(x) for x in ends],
                                {"ls": "--", "lw": 1, "label": "_fitted"}))
        chart.lines.append((technique, name, xs, ys, {"marker": "o"}))
    return chart


def function_chart(lines, scene):
    """Error against milliseconds of importance functions in a scene, a colour an analysis."""
    chart = _Chart(f"{scene}: wrong pixels against time of importance functions",
                   "milliseconds a frame, camera moving")
    points = {}
    for line in lines:
        analysis, _, function = line.key("variant").partition("+")
        name = analysis or line.key("technique")
        if line.key("scene") != scene or name in ("none", "vtk"):
            continue
        xs, ys = points.setdefault(name, ([], []))
        xs.append(line.value("ms"))
        ys.append(line.value("wrong_percent"))
        chart.labels.append((function or name, xs[-1], ys[-1]))
    chart.labels = [label for label in chart.labels if label[1] > 0 and label[2] > 0]
    chart.lines = [(name, name, xs, ys, {"ls": "", "marker": "o"})
                   for name, (xs, ys) in points.items()]
    return chart
