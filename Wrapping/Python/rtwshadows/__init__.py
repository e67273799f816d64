# SPDX-License-Identifier: BSD-3-Clause
"""Fast, accurate hard shadows for VTK.

    import rtwshadows
    rtwshadows.enable_shadows(renderer)                       # the default technique, "rtw"
    rtwshadows.enable_shadows(renderer, light="sun")          # with a light, for a scene with none
    rtwshadows.enable_shadows(plotter, "uniform", 2048)       # PyVista, vedo, with all subplots
    rtwshadows.enable_shadows(window)                         # all its renderers; lists are taken
    rtwshadows.disable_shadows(renderer)                      # as it was before

Every class of the C++ module vtkRTWShadows is in this package too. Where there is no display,
importing it makes VTK's default window a headless one: see use_headless_window().
"""

# The base classes must be there before the derived ones, and the OpenGL factories with them.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from .vtkRTWShadows import *  # noqa: F401,F403
from .headless import use_headless_window
from .switch import disable_shadows, enable_shadows
from .techniques import available_techniques
from .version import __version__

from .headless import _use_headless_window_without_display

_use_headless_window_without_display()
del _use_headless_window_without_display
