# SPDX-License-Identifier: BSD-3-Clause
"""The page of a renderer: errors, times and memory of a run."""

import math
import statistics

from . import charts
from .claims import claims_section
from .curves import fit
from .markdown import mebibytes, milliseconds, percent, table, times
from .paper import paper_section
from .results import pick, quantile, values_of
from .variants import variant_sections

_USUAL_MAP = "1024"
_WORDS = """Wrong are pixels that face the light and whose shadow is not the one that an exact ray finds; \
*dark*, *lit*: wrongly so; *far*: more than two pixels from a shadow's edge; *flicker*: pixels that change \
from one tiny move of the camera to the next though the truth does not; *aliasing*: how wide a texel is on \
a surface, in pixels, at the 95th percentile. Times are medians of whole frames until the GPU has finished; \
*× vtk*: in times of VTK's own pass with new maps for each frame (`vtk`), measured frame by frame in turn, \
by the CPU time of all threads where OpenGL is software and by whole frames elsewhere; `vtk-kept` is VTK's \
pass as it is by itself, `none` a frame without shadows. Where nothing else is said the picture has \
{width:g} × {height:g} pixels.

"""
_COLUMNS = (
    ("wrong %", "wrong_percent", percent), ("dark %", "wrongly_dark_percent", percent),
    ("lit %", "wrongly_lit_percent", percent), ("far %", "far_percent", percent),
    ("flicker %", "flicker_percent", percent), ("aliasing 95 %", "aliasing_p95", times),
    ("ms", "ms", milliseconds), ("95 % ms", "p95_ms", milliseconds), ("× vtk", "to_vtk", times),
    ("CPU ms", "cpu_ms", milliseconds), ("GPU ms", "gpu_ms", milliseconds),
    ("MiB", "memory_bytes", mebibytes))
_STAGE = "gpu_ms:"


def _machine(results):
    context = results.context
    rows = [(what, context.get(key, "unknown")) for what, key in (
        ("OpenGL renderer", "gl_renderer"), ("OpenGL version", "gl_version"), ("VTK", "vtk_version"),
        ("build", "build_type"))]
    rows += [("processor cores", str(context.get("num_cpus", 0))), ("date", context.get("date", ""))]
    if context.get("fault", "none") != "none":
        rows.append(("fault made on purpose", context["fault"]))
    return table(("", ""), rows)


def _noise(results):
    noise = [100 * line.noise("to_vtk") for line in results.lines
             if line.key("technique") not in ("vtk", "none")]
    return ("Noise: from lap to lap, a ratio to VTK's pass has a standard deviation of "
            f"{quantile(noise, 0.5):.1f} % in the middle of all lines and {quantile(noise, 0.95):.1f} % at "
            "the 95th percentile.\n\n")


def _image(title, plots, name):
    return f"![{title}]({plots}/{name}.png)\n\n"


def _error_and_time(line):
    if line is None:
        return "-"
    if line.key("technique") == "none":
        return milliseconds(line.value("ms"))
    return percent(line.value("wrong_percent")) + " · " + times(line.value("to_vtk"))


# Scenes in rows, techniques in columns, at the usual map.
def _overview(maps):
    techniques = values_of(maps, "technique")
    rows = [[scene] + [_error_and_time(pick(maps, scene=scene, technique=technique, map=_USUAL_MAP))
                       for technique in techniques] for scene in values_of(maps, "scene")]
    header = ["scene"] + [technique + (" ms" if technique == "none" else " wrong % · × vtk")
                          for technique in techniques]
    return "### At 1024 × 1024 texels\n\n" + table(header, rows)


def _line_table(first, lines):
    rows = [[line.key("technique"), "" if line.key("technique") == "none" else line.key("map")] +
            [show(line.value(counter)) if line.has(counter) else "" for _, counter, show in _COLUMNS]
            for line in lines]
    return table([first, "map"] + [title for title, _, _ in _COLUMNS], rows)


def _equal_memory(results, scene):
    techniques = [name for name in values_of(results.family("maps"), "technique") if name != "none"]
    rows = []
    for memory in charts.EQUAL_MEMORY:
        found = [charts.at_memory(charts.maps_of(results, scene, name), memory) for name in techniques]
        if any(found):
            rows.append([f"{memory} MiB"] + [percent(at[1]) + " · " + milliseconds(at[0]) if at else "-"
                                             for at in found])
    return table(["at equal memory"] + [name + " wrong % · ms" for name in techniques], rows)


def _scenes(results, folder, plots):
    maps, text = results.family("maps"), ""
    for scene in values_of(maps, "scene"):
        charts.write(charts.error_chart(results, scene), folder / plots / f"{scene}.png")
        lines = [line for technique in values_of(maps, "technique") for line in maps
                 if line.key("scene") == scene and line.key("technique") == technique]
        text += (f"### {scene}\n\n" + _image(f"error against time in {scene}", plots, scene) +
                 _equal_memory(results, scene) + "<details><summary>All numbers</summary>\n\n" +
                 _line_table("technique", lines) + "</details>\n\n")
    return text


# Techniques in columns; exponents in the last row.
def _growth_table(results, family):
    lines = results.family(family)
    techniques = values_of(lines, "technique")
    laws = [fit(*charts.growth_points(results, family, technique)) for technique in techniques]
    rows = []
    for value in values_of(lines, family):
        found = [pick(lines, **{family: value, "technique": technique}) for technique in techniques]
        rows.append([value] + [milliseconds(line.value("ms")) + " · " + times(line.value("to_vtk"))
                               if line else "-" for line in found])
    rows.append(["exponent"] + [times(law.exponent) if law else "-" for law in laws])
    return table([family] + [technique + " ms · × vtk" for technique in techniques], rows)


def _growth(results, folder, plots):
    text = ""
    for family, what in charts.GROWTH.items():
        lines = results.family(family)
        if lines:
            name = "growth-" + family
            charts.write(charts.growth_chart(results, family), folder / plots / f"{name}.png")
            text += (f"### {family} ({lines[0].key('scene')})\n\n" +
                     _image(f"time against {what}", plots, name) + _growth_table(results, family))
    return text and ("## Growth\n\nFitted to powers: time ~ n^exponent, by least squares of the "
                     "logarithms.\n\n" + text)


def _moving(results):
    lines = results.family("moving")
    text = "".join(_line_table(f"{moving} moves", [line for line in lines if line.key("moving") == moving])
                   for moving in values_of(lines, "moving"))
    return "## What moves\n\n" + text if lines else ""


# Stages in rows, scenes in columns, of one technique.
def _stage_table(maps, technique):
    found = {scene: pick(maps, scene=scene, technique=technique, map=_USUAL_MAP)
             for scene in values_of(maps, "scene")}
    found = {scene: line for scene, line in found.items() if line}
    stages = dict.fromkeys(counter for line in found.values() for counter in sorted(line.counters)
                           if counter.startswith(_STAGE))
    rows = [[stage[len(_STAGE):]] + [milliseconds(line.value(stage)) if line.has(stage) else "-"
                                     for line in found.values()] for stage in stages]
    return table([technique, *found], rows) if rows else ""


def _stages(results):
    maps = results.family("maps")
    text = "".join(_stage_table(maps, technique) for technique in values_of(maps, "technique"))
    return text and ("## Stages\n\nMilliseconds of the GPU a frame, camera moving, at 1024 × 1024 "
                     "texels.\n\n" + text)


def write_page(results, changes, folder, plots):
    """The page in Markdown; `changes` are pairs of an earlier run's file and the comparison with it.
    Plots are written into `folder`/`plots`."""
    line = results.lines[0]
    text = (f"# Results on {results.renderer}\n\n" + _machine(results) +
            _WORDS.format(width=line.value("width"), height=line.value("height")) + _noise(results))
    for file, found in changes:
        text += f"## Since {file}\n\n{found.tell()}\n"
    maps = results.family("maps")
    if maps:
        text += "## Error, time and memory\n\n" + _overview(maps) + _scenes(results, folder, plots)
    return (text + _growth(results, folder, plots) + _moving(results) + _stages(results) +
            paper_section(results) + variant_sections(results, folder, plots) + claims_section(results))


def summary(results):
    """A row a technique: means over all scenes. Empty without lines of the family maps."""
    maps, rows = results.family("maps"), []
    for technique in values_of(maps, "technique"):
        lines = [line for line in maps
                 if line.key("technique") == technique and line.key("map") == _USUAL_MAP]
        if lines:
            ratio = math.exp(statistics.fmean(math.log(max(line.value("to_vtk"), 1e-6)) for line in lines))
            error = statistics.fmean(line.value("wrong_percent") for line in lines)
            rows.append([technique, "" if technique == "none" else percent(error), times(ratio)])
    header = ["technique", "wrong %, mean of the scenes", "× vtk, geometric mean"]
    return table(header, rows) if maps else ""
