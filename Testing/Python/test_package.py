# SPDX-License-Identifier: BSD-3-Clause
"""The package imports, has every class, and draws with no display."""

import os
import subprocess
import sys
import unittest

import rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import (
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
    vtkWindowToImageFilter,
)


def run(code, **environment):
    """Standard output of a Python of its own, with other environment variables."""
    variables = {**os.environ, **environment}
    variables = {name: value for name, value in variables.items() if value is not None}
    done = subprocess.run(
        [sys.executable, "-c", code], env=variables, capture_output=True, text=True, timeout=120
    )
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)
    return done.stdout.strip()


class TestPackage(unittest.TestCase):
    def test_names(self):
        self.assertRegex(rtwshadows.__version__, r"^\d+\.\d+\.\d+$")
        self.assertTrue(issubclass(rtwshadows.vtkRTWEGLRenderWindow, vtkRenderWindow))
        for name in rtwshadows.available_techniques():
            self.assertIsInstance(name, str)
        for name in ("enable_shadows", "disable_shadows", "use_headless_window"):
            self.assertTrue(getattr(rtwshadows, name).__doc__)

    def test_headless_window_by_default_without_display(self):
        code = (
            "import rtwshadows\n"
            "from vtkmodules.vtkRenderingCore import vtkRenderWindow\n"
            "f = rtwshadows.vtkRTWEGLRenderWindow\n"
            "print(vtkRenderWindow().IsA('vtkRTWEGLRenderWindow'))\n"
            "f.UninstallAsDefault()\n"
            "print(rtwshadows.use_headless_window())\n"
            "print(vtkRenderWindow().IsA('vtkRTWEGLRenderWindow'))\n"
        )
        self.assertEqual(run(code, DISPLAY=None, WAYLAND_DISPLAY=None).split(), ["1", "True", "1"])

    def test_native_window_with_display(self):
        code = (
            "import rtwshadows\n"
            "print(rtwshadows.vtkRTWEGLRenderWindow.InstallAsDefault(True))\n"
        )
        self.assertEqual(run(code, DISPLAY=":77"), "False")
        self.assertEqual(run(code, DISPLAY=None, WAYLAND_DISPLAY="wayland-0"), "False")

    def test_any_order_of_imports(self):
        code = (
            "import vtkmodules.vtkInteractionStyle, vtkmodules.vtkRenderingUI\n"
            "import vtkmodules.vtkRenderingOpenGL2\n"
            "import rtwshadows\n"
            "from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor\n"
            "print(vtkRenderWindow().IsA('vtkRTWEGLRenderWindow'))\n"
            "print(vtkRenderWindowInteractor().IsA('vtkGenericRenderWindowInteractor'))\n"
        )
        self.assertEqual(run(code, DISPLAY=None, WAYLAND_DISPLAY=None).split(), ["1", "1"])

    def test_draws(self):
        rtwshadows.use_headless_window()
        window = vtkRenderWindow()
        window.SetSize(40, 20)
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 0.0, 0.2)
        window.AddRenderer(renderer)
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.Update()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
        self.assertEqual(pixels.shape, (800, 3))
        self.assertEqual(pixels.min(axis=0).tolist(), [255, 0, 51])
        self.assertEqual(pixels.max(axis=0).tolist(), [255, 0, 51])

    def test_interactor_returns(self):
        rtwshadows.use_headless_window()
        window = vtkRenderWindow()
        interactor = vtkRenderWindowInteractor()
        interactor.SetInteractorStyle(None)
        interactor.SetRenderWindow(window)
        interactor.Initialize()
        interactor.Start()


if __name__ == "__main__":
    unittest.main()
