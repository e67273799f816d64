# SPDX-License-Identifier: BSD-3-Clause
"""The command line of shadow-report."""

import argparse
import pathlib
import re
import sys
from dataclasses import dataclass, field

from .claims import claims_table
from .comparison import compare
from .page import summary, write_page
from .results import UsageError, read_results

_DESCRIPTION = """\
Makes tables and plots of what shadow-benchmark wrote: RESULTS.md, and for each OpenGL renderer
RESULTS-renderer.md, since times on different ones have nothing to do with each other. Files of one
renderer that have no line in common are one run, such as of several families. Of several runs the last
is shown, and compared with the first: lines that have become slower or less accurate by more than noise
are told. Plots need matplotlib; without it the tables are made all the same.
"""
# Families that run only when they are named, in the order of their sections.
_NAMED_FAMILIES = ("paper", "functions", "rasterizations", "filters", "view-samples", "claims")
_WORSE = 3  # exit code


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(message)


def _parse(arguments):
    parser = _Parser(prog="shadow-report", description=_DESCRIPTION, add_help=False, allow_abbrev=False,
                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="FILE.json",
                        help="what shadow-benchmark --benchmark_out wrote")
    parser.add_argument("--out", metavar="DIR", default=".", type=pathlib.Path,
                        help="for RESULTS.md and what it shows; default this folder")
    parser.add_argument("--check", action="store_true", help="exit code 3 if a line has become worse")
    parser.add_argument("--help", action="help", help="print this")
    options, unknown = parser.parse_known_args(arguments)
    if unknown:
        raise UsageError(f"{unknown[0]}: there is no such option")
    if not options.files:
        raise UsageError("no file is given: expected what shadow-benchmark --benchmark_out wrote")
    return options


@dataclass
class _Renderer:
    name: str        # in the OpenGL driver's words
    short_name: str
    runs: list = field(default_factory=list)

    def changes(self):
        first, last = self.runs[0], self.runs[-1]
        return [(first.file, compare(first, last))] if len(self.runs) > 1 else []


# "llvmpipe (LLVM 15.0.6, 256 bits)" becomes "llvmpipe", "NVIDIA H200/PCIe/SSE2" "nvidia-h200".
def _short_name(renderer):
    words = re.findall(r"[a-z0-9]+", re.split(r"[(/,]", renderer, maxsplit=1)[0].lower())
    return "-".join(words) or "unknown"


# Never two renderers under one name, even if they are shortened alike.
def _sort(files):
    renderers, used = {}, {}
    for file in files:
        results = read_results(file)
        if results.renderer not in renderers:
            brief = _short_name(results.renderer)
            used[brief] = used.get(brief, 0) + 1
            name = brief if used[brief] == 1 else f"{brief}-{used[brief]}"
            renderers[results.renderer] = _Renderer(results.renderer, name)
        runs = renderers[results.renderer].runs
        if not runs or not runs[-1].join(results):
            runs.append(results)
    return list(renderers.values())


# By which the runs that are shown are made again.
def _commands(renderers):
    shown = {line.family for renderer in renderers for line in renderer.runs[-1].lines}
    named = [family for family in _NAMED_FAMILIES if family in shown]
    measure, files = "", ""
    if shown - set(named):
        measure += "    shadow-benchmark --benchmark_out results.json\n"
        files += " results.json"
    if named:
        measure += f"    shadow-benchmark --family {','.join(named)} --benchmark_out tables.json\n"
        files += " tables.json"
    return measure + f"    shadow-report{files} --out Testing/Benchmarks\n\n"


def _run(options):
    renderers = _sort(options.files)
    index = ("# Results\n\nBy `shadow-report`, from what `shadow-benchmark` measured; a page for each OpenGL "
             "renderer. The tables here are at 1024 × 1024 texels, camera moving.\n\n" + _commands(renderers))
    worse = False
    for renderer in renderers:
        plots = "plots-" + renderer.short_name
        try:
            (options.out / plots).mkdir(parents=True, exist_ok=True)
        except OSError:
            raise UsageError(f"--out {options.out}: the folder cannot be made") from None
        changes, results = renderer.changes(), renderer.runs[-1]
        for file, found in changes:
            print(f"{renderer.name}, since {file}:\n{found.tell()}", end="")
            worse = worse or bool(found.flags)
        page = f"RESULTS-{renderer.short_name}.md"
        (options.out / page).write_text(write_page(results, changes, options.out, plots), encoding="utf-8")
        index += f"## [{renderer.name}]({page})\n\n" + summary(results) + claims_table(results)
    (options.out / "RESULTS.md").write_text(index, encoding="utf-8")
    return _WORSE if options.check and worse else 0


def main(arguments=None):
    """Exit code: 0, 2 and one line on stderr for what cannot be obeyed, 3 with --check if a line has
    become worse."""
    try:
        return _run(_parse(sys.argv[1:] if arguments is None else arguments))
    except UsageError as error:
        print(f"shadow-report: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"shadow-report: {error.filename}: cannot be written", file=sys.stderr)
        return 1
