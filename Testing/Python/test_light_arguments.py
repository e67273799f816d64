# SPDX-License-Identifier: BSD-3-Clause
"""A vtkLight wherever a pass takes a light's number."""

import gc
import sys
import unittest

import rtwshadows
from stage import add_sun, make_renderer, make_window, picture
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkLight


def pixels(image):
    return None if image is None else (
        image.GetDimensions(), vtk_to_numpy(image.GetPointData().GetScalars()).tobytes())


def depth_range(shadows, light, layer):
    into = [7.0, 7.0]
    return shadows.GetLayerDepthRange(light, layer, into), into


def matrix(shadows, light, layer):
    into = vtkMatrix4x4()
    found = shadows.GetLightPlaneMatrix(light, layer, into)
    return found, [into.GetElement(row, column) for row in range(4) for column in range(4)]


# All that is said of a light.
QUESTIONS = {
    "mask": lambda shadows, light: pixels(shadows.GetShadowMask(light)),
    "map": lambda shadows, light: pixels(shadows.GetShadowMapImage(light)),
    "map of layer": lambda shadows, light: pixels(shadows.GetShadowMapImage(light, 0)),
    "warp": lambda shadows, light: pixels(shadows.GetWarpImage(light)),
    "warp of layer": lambda shadows, light: pixels(shadows.GetWarpImage(light, 0)),
    "importance": lambda shadows, light: pixels(shadows.GetImportanceImage(light)),
    "importance of layer": lambda shadows, light: pixels(shadows.GetImportanceImage(light, 0)),
    "aliasing": lambda shadows, light: pixels(shadows.GetAliasingErrorImage(light)),
    "predicted": lambda shadows, light: shadows.GetPredictedError(light),
    "layers": lambda shadows, light: shadows.GetNumberOfLightLayers(light),
    "depths": lambda shadows, light: depth_range(shadows, light, 0),
    "matrix": lambda shadows, light: matrix(shadows, light, 0),
    "effective": lambda shadows, light: shadows.GetMaximumEffectiveResolution(light, 1),
    "drawn": lambda shadows, light: shadows.GetNumberOfCastersDrawn(light),
    "drawn in layer": lambda shadows, light: shadows.GetNumberOfCastersDrawn(light, 0),
    "culled": lambda shadows, light: shadows.GetNumberOfCastersCulled(light),
    "culled in layer": lambda shadows, light: shadows.GetNumberOfCastersCulled(light, 0),
}


class TestLightArguments(unittest.TestCase):
    def setUp(self):
        """A headlight, a sun, one that is off, one whose shadows weigh nothing, a spot."""
        self.renderer = make_renderer(sun=False)
        self.headlight = vtkLight()
        self.headlight.SetLightTypeToHeadlight()
        self.headlight.SetIntensity(0.3)
        self.renderer.AddLight(self.headlight)
        self.sun = add_sun(self.renderer)
        self.off = add_sun(self.renderer)
        self.off.SwitchOff()
        self.weightless = add_sun(self.renderer)
        self.weightless.SetShadowAttenuation(0)
        self.spot = add_sun(self.renderer)
        self.spot.PositionalOn()
        self.spot.SetConeAngle(40)
        self.spot.SetPosition(-4, 1, 5)
        self.window = make_window(self.renderer, size=(80, 60))

    def without_shadows(self):
        return (self.headlight, self.off, self.weightless, vtkLight(), None)

    def test_index(self):
        shadows = rtwshadows.enable_shadows(self.renderer)
        self.assertEqual(shadows.GetShadowLightIndex(self.sun), -1)  # no frame yet
        picture(self.window)
        self.assertEqual(shadows.GetShadowLightIndex(self.sun), 0)
        self.assertEqual(shadows.GetShadowLightIndex(self.spot), 1)
        for light in self.without_shadows():
            self.assertEqual(shadows.GetShadowLightIndex(light), -1)

    def test_index_follows_the_lights(self):
        shadows = rtwshadows.enable_shadows(self.renderer)
        picture(self.window)
        self.sun.SwitchOff()
        self.assertEqual(shadows.GetShadowLightIndex(self.spot), 1)  # of the last frame
        picture(self.window)
        self.assertEqual(shadows.GetShadowLightIndex(self.spot), 0)
        self.assertEqual(shadows.GetShadowLightIndex(self.sun), -1)

    def test_lights_that_are_gone(self):
        """A new one in a freed one's place is another light."""
        shadows = rtwshadows.enable_shadows(self.renderer)
        picture(self.window)
        for name in ("sun", "spot"):
            self.renderer.RemoveLight(getattr(self, name))
            delattr(self, name)
        gc.collect()
        for light in [vtkLight() for _ in range(200)]:
            self.assertEqual(shadows.GetShadowLightIndex(light), -1)
        self.assertIsNone(shadows.GetShadowMask(vtkLight()))

    def test_all_questions(self):
        """A light gets its number's answer; one without shadows that of a number there isn't."""
        for technique in rtwshadows.available_techniques():
            shadows = rtwshadows.enable_shadows(self.renderer, technique, 128)
            picture(self.window)
            for name, ask in QUESTIONS.items():
                with self.subTest(technique=technique, question=name):
                    for number, light in enumerate((self.sun, self.spot)):
                        self.assertEqual(ask(shadows, light), ask(shadows, number))
                    for light in self.without_shadows():
                        self.assertEqual(ask(shadows, light), ask(shadows, -1))
            self.assertNotEqual(
                pixels(shadows.GetShadowMask(self.sun)), pixels(shadows.GetShadowMask(self.spot)))

    def test_debug_light(self):
        """Stays the one that is viewed when others come and go."""
        shadows = rtwshadows.enable_shadows(
            self.renderer, debug_view="shadow", debug_light=self.spot)
        named = picture(self.window)
        self.assertEqual(shadows.GetDebugLight(), 1)
        shadows.SetDebugLight(1)
        self.assertTrue((picture(self.window) == named).all())
        shadows.SetDebugLight(0)
        self.assertFalse((picture(self.window) == named).all())
        shadows.SetDebugLight(self.spot)
        self.sun.SwitchOff()
        self.assertTrue((picture(self.window) == named).all())
        self.assertEqual(shadows.GetDebugLight(), 0)

    def test_debug_light_that_casts_nothing(self):
        shadows = rtwshadows.enable_shadows(self.renderer, debug_view="shadow", debug_light=1)
        second = picture(self.window)
        said = []
        shadows.AddObserver("WarningEvent", lambda *_: said.append(1))
        for _ in range(3):
            shadows.SetDebugLight(self.headlight)
            self.assertTrue((picture(self.window) == second).all())
        self.assertEqual(len(said), 1)
        with self.assertRaisesRegex(ValueError, "debug_light=None .*a vtkLight"):
            rtwshadows.enable_shadows(self.renderer, debug_light=None)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
