# SPDX-License-Identifier: BSD-3-Clause
"""Import the installed package: import.py <prefix>. All of it must come from the prefix."""

import os
import sys

import rtwshadows

prefix = os.path.realpath(sys.argv[1])
loaded = {os.path.realpath(rtwshadows.__file__)}
if os.path.exists("/proc/self/maps"):
    with open("/proc/self/maps", encoding="utf-8") as maps:
        paths = {line.split(maxsplit=5)[5].strip() for line in maps if line.count("/")}
    libraries = {path for path in paths if "vtkRTWShadows" in os.path.basename(path)}
    assert len(libraries) == 2, libraries  # the library and its wrapping
    loaded |= libraries
for path in loaded:
    assert path.startswith(prefix), f"{path} is not of {prefix}"

window = rtwshadows.vtkRTWEGLRenderWindow()
window.SetSize(20, 20)
window.Render()
assert window.HasContext()
print(rtwshadows.__version__, rtwshadows.available_techniques(), sorted(loaded))
