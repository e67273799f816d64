# SPDX-License-Identifier: BSD-3-Clause
"""Tables 1 to 3 of the paper on rectilinear texture warping, beside its own numbers."""

from .markdown import milliseconds, percent, table, times
from .paper_numbers import FRAME_TIMES, SCENES, STAGE_TIMES, paper_ratio
from .results import pick, select, values_of
from .variants import stage_sum, time_ratio

_HEADING = """## The paper's tables

P. Rosen, *Rectilinear Texture Warping for Fast Adaptive Shadow Mapping*, 2012: its tables, with times in \
times of the conventional map's frame (*×*), here and in the *paper*, whose ranges stand for their middle. \
The conventional map is a uniform one of the whole scene; importance is what the paper describes, with \
shadow edges where there is a light's image; scenes are those that bear its scenes' names; wrong % is \
against exact rays.

"""
_STAGES = """### Table 2: stages

Stages of the GPU: *(a)* is drawing view samples and light's images, and the focus; *(b)* collecting \
importance, which is a part of the paper's (a), and the warping maps; *(c)* the light pass; *(d)* what is \
left of the frame, the mask among it, and of the conventional map, whose view samples serve the mask \
alone, those too. × is in times of the conventional map's whole frame.

"""
# Name, whether of the tessellated variant, our stage, the paper's.
_STAGE_ROWS = (
    ("(a) Importance Map Calculation", False, "importance_map", "importance_map"),
    ("(b) Warping Map Calculation", False, "warping_map", "warping_map"),
    ("(c) Shadow Map Rendering", False, "shadow_map", "shadow_map"),
    ("(w/ tessellation)", True, "shadow_map", "tessellated_shadow_map"),
    ("(d) Output rendering or compositing", False, "output", "output"),
    ("Total", False, "total", "total"),
    ("(w/ tessellation)", True, "total", "tessellated_total"))


# Two cells: what is measured, and the paper's ratio.
def _cells(lines, number, variant, scene):
    line = pick(lines, scene=scene, variant=variant)
    base = pick(lines, scene=scene, variant="conventional")
    ratio = paper_ratio(number, variant, scene)
    measured = [percent(line.value("wrong_percent")), milliseconds(line.value("ms")),
                times(time_ratio(line, base))] if line and base else ["-"]
    return [" · ".join(measured), "-" if ratio is None else times(ratio)]


def _header(corner, names, unit):
    return [corner] + [cell for name in names for cell in (f"{name} {unit}", "paper ×")]


def _table1(lines):
    rows = [[row.name] + [cell for scene in SCENES for cell in _cells(lines, 1, row.variant, scene)]
            for row in FRAME_TIMES if row.table == 1]
    return ("### Table 1: frames\n\nTessellated to 2.5 % of the map's side.\n\n" +
            table(_header("", SCENES, "wrong % · ms · ×"), rows))


def _stages_of(line):
    stages = {"total": line.value("gpu_ms"), "shadow_map": stage_sum(line, ("geometry", "light pass")),
              "importance_map": 0.0, "warping_map": 0.0}
    if line.key("technique") != "uniform":
        stages["importance_map"] = stage_sum(
            line, ("view samples", "resampling", "focus", "light images"))
        stages["warping_map"] = stage_sum(line, ("warp",))
    # Medians of noisy frames need not add up.
    rest = stages["total"] - sum(value for stage, value in stages.items() if stage != "total")
    return {**stages, "output": max(rest, 0.0)}


def _stage_cells(lines, base, column, tessellated, own, papers):
    variant = column.tessellated if tessellated else column.variant
    line = pick(lines, scene=SCENES[0], variant=variant) if variant else None
    taken = _stages_of(line)[own] if line else 0
    paper = getattr(column, papers)
    return [milliseconds(taken) + " · " + times(taken / base.value("gpu_ms"))
            if line and (taken > 0 or own == "output") else "-",
            times(paper / STAGE_TIMES[0].total) if paper > 0 else "-"]


def _table2(lines):
    base = pick(lines, scene=SCENES[0], variant="conventional")
    if base is None:
        return ""
    rows = [[name] + [cell for column in STAGE_TIMES
                      for cell in _stage_cells(lines, base, column, tessellated, own, papers)]
            for name, tessellated, own, papers in _STAGE_ROWS]
    return _STAGES + table(_header(SCENES[0], [column.name for column in STAGE_TIMES], "ms · ×"), rows)


def _table3(lines, analysis):
    columns = [row for row in FRAME_TIMES if row.table == 3]

    def variant(column):
        return analysis + column.variant[column.variant.index("+"):]
    rows = [[scene] + [cell for column in columns for cell in _cells(lines, 3, variant(column), scene)]
            for scene in SCENES]
    return table(_header(analysis, [column.name for column in columns], "wrong % · ms · ×"), rows)


def paper_section(results):
    """Empty where the results have nothing of it."""
    every = results.family("paper")
    text = _HEADING if every else ""
    for size in values_of(every, "map"):
        lines = select(every, map=size)
        text += (f"Maps have {size} × {size} texels.\n\n" + _table1(lines) + _table2(lines) +
                 "### Table 3: tessellation\n\nThe paper's are of the backward analysis.\n\n" +
                 "".join(_table3(lines, analysis) for analysis in ("backward", "forward", "hybrid")))
    return text
