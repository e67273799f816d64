# SPDX-License-Identifier: BSD-3-Clause
"""Rendering where there is no display."""

from .vtkRTWShadows import vtkRTWEGLRenderWindow


def use_headless_window():
    """Make vtkRenderWindow() give a headless window that draws by EGL, from now on.

    Importing rtwshadows calls it where no display is named (by DISPLAY or WAYLAND_DISPLAY).
    vtkRTWEGLRenderWindow.UninstallAsDefault() undoes it. Returns whether the headless window is
    the default; it is not where the build has no EGL.
    """
    return vtkRTWEGLRenderWindow.InstallAsDefault(False)


def _use_headless_window_without_display():
    return vtkRTWEGLRenderWindow.InstallAsDefault(True)
