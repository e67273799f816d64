# SPDX-License-Identifier: BSD-3-Clause
"""What windows show, headless: to be imported before the package and VTK's windows."""

import os

os.environ.pop("DISPLAY", None)
os.environ.pop("WAYLAND_DISPLAY", None)

import rtwshadows  # noqa: E402,F401  (makes the default window a headless one)
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter  # noqa: E402


def grab(window):
    """The window's pixels as they are now: rows from the bottom, columns, and red, green and blue."""
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    width, height, _ = image.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[..., :3].astype(int)
