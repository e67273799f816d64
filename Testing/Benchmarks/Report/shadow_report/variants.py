# SPDX-License-Identifier: BSD-3-Clause
"""Sections with a row for each variant of a technique: importance functions, ways to draw edges,
filters, and sources of view samples. Each is empty where the results have nothing of it."""

import math
import statistics

from . import charts
from .markdown import milliseconds, percent, table, times
from .results import pick, select, values_of

_FUNCTIONS = """## Importance functions

Every analysis and importance function. Hybrid is backward where there are no edges; *published* is \
desired-view, distance and normal; *user* is the luminance, *interest* the view's centre.

"""
_RASTERIZATIONS = """## Rasterization

Ways to draw the edges that the warp bends; tessellated to so many % of the map's side. *floor* has two \
triangles under a few boxes.

"""
_FILTERS = """## Filters

PCF of so many texels, SOFT of so many world units; frames rebuilt while the camera moves, and *still* \
ones, in times of nearest.

"""
_VIEW_SAMPLES = """## View samples

Of a prepass, and of the previous frame; *samples* is the GPU's time for them, in times of the frame with \
a prepass.

"""


def variant_name(line):
    """What a row is called: the variant, or the technique where there are none."""
    return line.key("variant") or line.key("technique")


def time_ratio(line, base):
    """In times of another line on the same setup, by what both take in times of VTK's pass."""
    divisor = base.value("to_vtk")
    return line.value("to_vtk") / divisor if divisor > 0 else 0.0


def stage_sum(line, stages):
    """Milliseconds of several of the GPU's stages."""
    return sum(line.value("gpu_ms:" + stage) for stage in stages)


def variant_table(lines, corner, columns, overall=()):
    """A table of variants: of each scene these columns, pairs of a title and of a function from a line
    to text, "-" where a line is missing; before them what is said of any of a variant's lines."""
    scenes = values_of(lines, "scene")
    first = {}
    for line in lines:
        first.setdefault(variant_name(line), line)
    first.pop("none", None)
    by_place = {}
    for line in lines:
        by_place.setdefault((variant_name(line), line.key("scene")), line)
    rows = []
    for name, line in first.items():
        places = [(by_place.get((name, scene)), show) for scene in scenes for _, show in columns]
        rows.append([name] + [show(line) for _, show in overall] +
                    ["-" if place is None else show(place) for place, show in places])
    header = [corner] + [title for title, _ in overall] + [
        f"{scene} {title}" for scene in scenes for title, _ in columns]
    return table(header, rows)


def _of(counter, show):
    return lambda line: show(line.value(counter)) if line.has(counter) else "-"


# In times of what `base` chooses on the same scene.
def _ratio_to(lines, **base):
    def show(line):
        other = pick(lines, scene=line.key("scene"), **base)
        return times(time_ratio(line, other)) if other else "-"
    return show


def _joined(*parts):
    return lambda line: " · ".join(part(line) for part in parts)


_WRONG, _FAR, _MS = _of("wrong_percent", percent), _of("far_percent", percent), _of("ms", milliseconds)


# Over all scenes of a variant: the mean error, and the geometric mean of times beside uniform.
def _means(lines):
    def show(any_line):
        measured = [(line.value("wrong_percent"), time_ratio(line, base)) for line in lines
                    for base in [pick(lines, scene=line.key("scene"), technique="uniform")]
                    if base and variant_name(line) == variant_name(any_line) and line.has("wrong_percent")]
        if not measured:
            return "-"
        logarithms = [math.log(ratio) for _, ratio in measured]
        return (percent(statistics.fmean(error for error, _ in measured)) + " · " +
                times(math.exp(statistics.fmean(logarithms))))
    return show


def _each_map(lines, heading, write):
    """What `write` says of the lines of each map's size, below a heading; nothing without lines."""
    return (heading if lines else "") + "".join(
        write(select(lines, map=size), f"{size} × {size} texels", size) for size in values_of(lines, "map"))


def _functions(results, folder, plots):
    def write(lines, title, size):
        text = f"### {title}\n\n" + variant_table(
            lines, "wrong % · ms · × uniform",
            [("", _joined(_WRONG, _MS, _ratio_to(lines, technique="uniform")))],
            [("means of wrong % · ×", _means(lines))])
        for scene in values_of(lines, "scene"):
            name = f"{plots}/functions-{scene}-{size}.png"
            charts.write(charts.function_chart(lines, scene), folder / name)
            text += f"![error against time of functions in {scene}]({name})\n\n"
        return text
    return _each_map(results.family("functions"), _FUNCTIONS, write)


def _rasterizations(results):
    def write(lines, title, _size):
        columns = [("wrong %", _WRONG), ("far %", _FAR), ("ms", _MS),
                   ("light pass ms", _of("gpu_ms:light pass", milliseconds)),
                   ("× linear", _ratio_to(lines, variant="linear"))]
        return "".join(variant_table(select(lines, scene=scene), title, columns)
                       for scene in values_of(lines, "scene"))
    return _each_map(results.family("rasterizations"), _RASTERIZATIONS, write)


def _filters(results):
    def write(all_lines, title, _size):
        still = select(all_lines, moving="nothing")
        lines = [line for line in all_lines if line.key("moving") != "nothing"]

        def kept(line):
            other = pick(still, **{key: line.key(key) for key in ("scene", "technique", "variant")})
            return milliseconds(other.value("ms")) if other else "-"
        return variant_table(lines, title, [
            ("wrong % · ms · ×", _joined(_WRONG, _MS, _ratio_to(lines, variant="nearest"))),
            ("mask ms", _of("gpu_ms:mask", milliseconds)), ("still ms", kept)])
    return _each_map(results.family("filters"), _FILTERS, write)


def _view_samples(results):
    def write(lines, title, _size):
        def samples(line):
            taken = stage_sum(line, ("view samples", "resampling"))
            return milliseconds(taken) if taken > 0 else "-"
        return variant_table(lines, title, [
            ("wrong % · ms · ×", _joined(_WRONG, _MS, _ratio_to(lines, variant="prepass"))),
            ("far %", _FAR), ("flicker %", _of("flicker_percent", percent)), ("samples ms", samples)])
    return _each_map(results.family("view-samples"), _VIEW_SAMPLES, write)


def variant_sections(results, folder, plots):
    """All of them; plots are written into `folder`/`plots`."""
    return (_functions(results, folder, plots) + _rasterizations(results) + _filters(results) +
            _view_samples(results))
