# SPDX-License-Identifier: BSD-3-Clause
"""A run against an earlier one on the same machine."""

import math
from dataclasses import dataclass, field

from .results import quantile

# A change is noise if it is within three standard deviations of a difference of two means, or
# within what two runs of one build were seen to differ by.
_DEVIATIONS = 3
_LEAST_TIME_NOISE = 0.08
# Shadows are the same in each lap, so their noise is none; but a few pixels on edges may go either
# way when a formula is only written otherwise.
_PIXEL_SHARE = 0.005
_PIXELS = 3
_MEMORY_SHARE = 0.01
_SETUP = ("width", "height", "triangles", "actors", "lights", "pixels")


@dataclass
class Comparison:
    flags: list = field(default_factory=list)   # of what has become worse by more than noise, in words
    compared: int = 0                           # lines that both have, measured alike
    with_pixels: int = 0                        # of those, with pixels compared
    equal_pixels: int = 0                       # of those, with exactly as many wrong ones
    ratios: list = field(default_factory=list)  # of times in times of VTK's pass, either way
    unlike: list = field(default_factory=list)  # measured otherwise, so that they cannot be compared
    missing: list = field(default_factory=list)  # lines that the later run has not

    def flag_if(self, before, after, counter, what, unit, tolerance):
        old, now = before.value(counter), after.value(counter)
        if before.has(counter) and after.has(counter) and now > old + tolerance:
            self.flags.append(f"**{what}**: {after.name}: {now:.6g} instead of {old:.6g} {unit} "
                              f"(noise: {tolerance:.2g})")

    def tell(self):
        """In Markdown."""
        largest, middle = max([1.0, *self.ratios]), quantile(self.ratios or [1.0], 0.5)
        text = (f"{self.compared} lines are in both. Wrong pixels are exactly as many in "
                f"{self.equal_pixels} of {self.with_pixels}. Ratios to VTK's pass differ by "
                f"{100 * (middle - 1):.1f} % in the middle and {100 * (largest - 1):.1f} % at most.\n\n")
        found = self.flags or ["No line has become slower, less accurate or larger by more than noise."]
        found = found + [f"not comparable, measured on something else: {name}" for name in self.unlike]
        if self.missing:
            found.append(f"{len(self.missing)} lines are not measured any more, {self.missing[0]} first")
        return text + "".join(f"- {line}\n" for line in found)


def _standard_error(line, counter):
    return line.noise(counter) / math.sqrt(len(line.counters.get(counter, (0,))))


# Times in times of VTK's pass, which the machine's load does not change; that pass itself in times of
# a frame without shadows.
def _compare_times(before, after, comparison):
    technique = after.key("technique")
    if technique == "none":
        return
    counter, unit = (("to_none", "times a frame without shadows") if technique == "vtk" else
                     ("to_vtk", "times VTK's own pass"))
    noise = _DEVIATIONS * math.hypot(_standard_error(before, counter), _standard_error(after, counter))
    comparison.flag_if(before, after, counter, "slower", unit,
                       before.value(counter) * max(noise, _LEAST_TIME_NOISE))
    old, now = before.value("to_vtk"), after.value("to_vtk")
    if old > 0 and now > 0:
        comparison.ratios.append(max(now / old, old / now))


def _compare_pixels(before, after, comparison):
    if not (before.has("wrong_pixels") and after.has("wrong_pixels")):
        return
    old = before.value("wrong_pixels")
    comparison.with_pixels += 1
    comparison.equal_pixels += old == after.value("wrong_pixels")
    comparison.flag_if(before, after, "wrong_pixels", "less accurate", "wrong pixels",
                       max(_PIXEL_SHARE * old, _PIXELS))


def compare(before, after):
    """What became of the lines of one run in another."""
    comparison = Comparison()
    for old in before.lines:
        now = after.find(old.name)
        if now is None:
            comparison.missing.append(old.name)
        elif any(old.value(counter) != now.value(counter) for counter in _SETUP):
            comparison.unlike.append(old.name)
        else:
            comparison.compared += 1
            _compare_times(old, now, comparison)
            _compare_pixels(old, now, comparison)
            comparison.flag_if(old, now, "memory_bytes", "more memory", "bytes",
                               _MEMORY_SHARE * old.value("memory_bytes"))
    return comparison
