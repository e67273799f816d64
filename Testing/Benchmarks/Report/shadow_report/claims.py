# SPDX-License-Identifier: BSD-3-Clause
"""What is said of the technique rtw, with whether it is so."""

from .markdown import percent, table, times
from .results import pick, values_of
from .variants import stage_sum

_HEADING = """## Claims

Of the technique rtw with its default importance, the square root of demand.

"""
_ANALYSIS = ("focus", "light images", "warp")
_SHARES = {
    "analysis and warp beside the whole frame, 1024²": _ANALYSIS,
    "the same, with the view samples, which the mask needs too":
        _ANALYSIS + ("view samples", "resampling"),
}


def _row(claim, scene, own, other, bound, may_equal):
    allowed = bound * other
    met = own <= allowed if may_equal else own < allowed
    return [claim, scene, percent(own) + " %", percent(other) + " %",
            times(own / other) if other > 0 else "-", ("≤ " if may_equal else "< ") + times(bound),
            "yes" if met else "**no**"]


def _missing(claim, scene):
    return [claim, scene, "-", "-", "-", "-", "not measured"]


def _compared(claim, scene, own, other, counter, bound, may_equal):
    if own and other and own.has(counter) and other.has(counter):
        return _row(claim, scene, own.value(counter), other.value(counter), bound, may_equal)
    return _missing(claim, scene)


def _errors(lines):
    claim = "error of 512² beside uniform 2048² of the whole scene: less"
    for scene in values_of(lines, "scene"):
        own = pick(lines, claim="error", scene=scene, technique="rtw", map="512")
        other = pick(lines, claim="error", scene=scene, technique="uniform", map="2048")
        yield _compared(claim, scene, own, other, "wrong_percent", 1, False)


def _flicker(lines):
    for size, variant in (("1024", ""), ("1024", "snapping"), ("2048", "")):
        claim = f"flicker of {size}²" + (f", {variant}," if variant else "") + " beside uniform 4096²"
        for scene in values_of(lines, "scene"):
            own = pick(lines, claim="flicker", scene=scene, technique="rtw", map=size, variant=variant)
            other = pick(lines, claim="flicker", scene=scene, technique="uniform", map="4096")
            yield _compared(claim, scene, own, other, "flicker_percent", 1.5, True)


# Of the GPU's frame.
def _shares(lines):
    line = pick(lines, claim="flicker", scene="town", technique="rtw", map="1024")
    frame = line.value("gpu_ms") if line else 0
    for claim, stages in _SHARES.items():
        taken = stage_sum(line, stages) if line else 0
        yield (_row(claim, "town", 100 * taken / frame, 100, 0.15, True) if frame > 0 and taken > 0
               else _missing(claim, "town"))


def claims_table(results):
    """The table alone; empty without lines of the family."""
    lines = results.family("claims")
    if not lines:
        return ""
    return table(["claim", "scene", "rtw", "beside it", "factor", "bound", "met"],
                 [*_errors(lines), *_flicker(lines), *_shares(lines)])


def claims_section(results):
    text = claims_table(results)
    return text and _HEADING + text
