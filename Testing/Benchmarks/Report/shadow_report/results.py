# SPDX-License-Identifier: BSD-3-Clause
"""What shadow-benchmark wrote, read again."""

import json
import pathlib
import statistics
from dataclasses import dataclass, field

# What Google Benchmark writes of its own accord about a line.
_OWN = {"real_time", "cpu_time", "family_index", "per_family_instance_index", "repetitions",
        "repetition_index", "iterations", "threads"}


class UsageError(Exception):
    """A command line or file that cannot be obeyed; the message is one line."""


@dataclass
class Line:
    """One setup by one technique.

    Counters have a value for each lap, "ms" too, which is a lap's median frame. Keys are what the
    name says: "family/key:value/key:value", where no value has a slash.
    """

    name: str
    counters: dict = field(default_factory=dict)

    def __post_init__(self):
        parts = self.name.split("/")
        self.family = parts[0]
        self.keys = dict(part.split(":", 1) for part in parts if ":" in part)

    def key(self, key):
        return self.keys.get(key, "")

    def has(self, counter):
        return counter in self.counters

    def value(self, counter):
        """The middle of the laps, or the mean of ratios of times, which another run comes closer
        to; 0 if the line has no such counter."""
        values = self.counters.get(counter)
        if not values:
            return 0.0
        return statistics.fmean(values) if counter.startswith("to_") else statistics.median(values)

    def noise(self, counter):
        """The standard deviation of a lap, as a share of the mean; 0 with less than two."""
        values = self.counters.get(counter, ())
        mean = statistics.fmean(values) if values else 0.0
        return statistics.stdev(values) / mean if len(values) > 1 and mean > 0 else 0.0


@dataclass
class Results:
    """A run of the benchmark, on one machine."""

    file: str  # without its folder
    context: dict
    lines: list

    @property
    def renderer(self):
        return self.context["gl_renderer"]

    def find(self, name):
        """The line of that name, or None."""
        return next((line for line in self.lines if line.name == name), None)

    def family(self, family):
        return [line for line in self.lines if line.family == family]

    def join(self, other):
        """Add the lines of another run, of other families, unless the two have one in common:
        then nothing changes, and False is returned."""
        names = {line.name for line in self.lines}
        if any(line.name in names for line in other.lines):
            return False
        self.file += ", " + other.file
        self.lines += other.lines
        return True


def values_of(lines, key):
    """The different values of a key, as they first come up."""
    return list(dict.fromkeys(line.key(key) for line in lines if line.key(key)))


def select(lines, **keys):
    """The lines of such values."""
    return [line for line in lines if all(line.key(key) == value for key, value in keys.items())]


def pick(lines, **keys):
    """The first line of such values, or None."""
    return next(iter(select(lines, **keys)), None)


def quantile(values, share):
    """Linear between the two values that are nearest; 0 of none."""
    if not values:
        return 0.0
    ordered = sorted(values)
    at = share * (len(ordered) - 1)
    low = int(at)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (at - low) * (ordered[high] - ordered[low])


def _is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _read_lines(entries):
    lines = []
    for entry in entries:
        if not (isinstance(entry, dict) and entry.get("run_type") == "iteration" and
                _is_number(entry.get("real_time"))):
            continue
        name = entry.get("run_name", entry.get("name"))
        if not lines or lines[-1].name != name:
            lines.append(Line(name))
        counters = {"ms": entry["real_time"]}
        counters.update((key, value) for key, value in entry.items()
                        if key not in _OWN and _is_number(value))
        for key, value in counters.items():
            lines[-1].counters.setdefault(key, []).append(float(value))
    return lines


def read_results(path):
    """The run in a file; UsageError, with a message that names the file, if it is no such run."""
    try:
        # Variations of what is zero are written as NaN, which Python's reader takes.
        root = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except OSError:
        raise UsageError(f"{path}: there is no such file") from None
    except ValueError:
        root = None
    if not (isinstance(root, dict) and isinstance(root.get("benchmarks"), list) and
            isinstance(root.get("context"), dict)):
        raise UsageError(f"{path}: expected JSON that shadow-benchmark wrote")
    results = Results(pathlib.Path(path).name, root["context"], _read_lines(root["benchmarks"]))
    if not results.lines or "gl_renderer" not in results.context:
        raise UsageError(f'{path}: expected lines and a "gl_renderer" of shadow-benchmark')
    return results
