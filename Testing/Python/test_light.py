# SPDX-License-Identifier: BSD-3-Clause
"""The light that enable_shadows adds, and what it says where none casts a shadow."""

import math
import sys
import unittest
import warnings

import rtwshadows
from stage import add_actor, ball, darker, make_renderer, make_window, picture
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

LIGHTS = ("sun", "lamp", "camera-left", (1, -0.5, 2))


def every_light(renderer):
    lights = renderer.GetLights()
    return [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]


def facts(light):
    return (light.__this__, light.GetIntensity(), light.GetPosition(), light.GetFocalPoint(),
            light.GetSwitch(), light.GetLightType())


def all_facts(renderer):
    return [facts(light) for light in every_light(renderer)]


def warnings_of(call):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    return [one for one in caught if issubclass(one.category, UserWarning)]


def shadow_of(shadows, light):
    """The pixels in its shadow, by the mask, from the bottom."""
    image = shadows.GetShadowMask(light)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width) < 64


class TestLight(unittest.TestCase):
    def test_says_that_nothing_casts(self):
        """Of no light, of VTK's own headlight, of one that is off and of one that is black: once
        a call, at the caller's line, with the remedy."""
        def none(renderer):
            pass

        def headlight(renderer):
            make_window(renderer).Render()
            self.assertEqual(len(every_light(renderer)), 1)

        def off(renderer):
            light = vtkLight()
            light.SwitchOff()
            renderer.AddLight(light)

        def black(renderer):
            light = vtkLight()
            light.SetIntensity(0)
            renderer.AddLight(light)

        for prepare in (none, headlight, off, black):
            renderer = make_renderer(sun=False)
            prepare(renderer)
            said = warnings_of(lambda: rtwshadows.enable_shadows(renderer))
            self.assertEqual(len(said), 1, prepare.__name__)
            self.assertRegex(str(said[0].message), 'headlight.*light="sun".*"lamp".*vtkLight')
            self.assertEqual(said[0].filename, __file__)
            lights = every_light(renderer)
            for light in LIGHTS:
                self.assertEqual(
                    warnings_of(lambda: rtwshadows.enable_shadows(renderer, light=light)), [])
            rtwshadows.disable_shadows(renderer)
            self.assertEqual(every_light(renderer), lights)

    def test_says_it_once_for_several(self):
        renderers = [make_renderer(sun=False), make_renderer(), make_renderer(sun=False)]
        said = warnings_of(lambda: rtwshadows.enable_shadows(renderers))
        self.assertEqual(len(said), 1)
        self.assertRegex(str(said[0].message), "2 of 3 renderers")

    def test_says_nothing_where_a_light_casts(self):
        self.assertEqual(warnings_of(lambda: rtwshadows.enable_shadows(make_renderer())), [])

    def test_each_casts_a_shadow(self):
        """Of the ball on the floor, which is a good part darker there, and the picture is neither
        dark nor burnt out; switched off all is as before."""
        for light in LIGHTS:
            with self.subTest(light=light):
                renderer = make_renderer(sun=False)
                window = make_window(renderer)
                plain = picture(window)
                before = all_facts(renderer)
                shadows = rtwshadows.enable_shadows(renderer, light=light)
                with_shadows = picture(window)
                self.assertEqual(shadows.GetNumberOfShadowLights(), 1)
                shadow = shadow_of(shadows, 0)
                self.assertTrue(0.005 < shadow.mean() < 0.1, shadow.mean())
                for other in every_light(renderer):
                    other.SetShadowAttenuation(0)
                lit = picture(window)
                ratio = with_shadows[shadow].mean() / lit[shadow].mean()
                self.assertTrue(0.1 < ratio < 0.6, ratio)
                brightness = lit[plain > 0].mean() / plain[plain > 0].mean()
                self.assertTrue(0.7 < brightness < 1.3, brightness)
                rtwshadows.disable_shadows(renderer)
                self.assertEqual(all_facts(renderer), before)
                self.assertTrue((picture(window) == plain).all())

    def test_before_the_first_frame(self):
        """No light is left behind that would keep VTK from making its own."""
        renderer = make_renderer(sun=False)
        rtwshadows.enable_shadows(renderer, light="sun")
        self.assertEqual(len(every_light(renderer)), 2)
        rtwshadows.disable_shadows(renderer)
        self.assertEqual(every_light(renderer), [])
        window = make_window(renderer)
        other = make_window(make_renderer(sun=False))
        self.assertEqual(picture(window).max(), picture(other).max())
        self.assertEqual(len(every_light(renderer)), 1)

    def test_the_scene_comes_later(self):
        """A scene and a view that come after enabling are what the first frame fits to."""
        renderer = vtkRenderer()
        window = make_window(renderer)
        shadows = rtwshadows.enable_shadows(renderer, light="lamp")
        add_actor(renderer, ball((100, 200, 300), 50))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(100, -400, 600)
        camera.SetFocalPoint(100, 200, 300)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCameraClippingRange()
        picture(window)
        self.assertEqual(shadows.GetNumberOfShadowLights(), 1)
        (lamp,) = [light for light in every_light(renderer) if light.GetPositional()]
        for got, centre in zip(lamp.GetFocalPoint(), (100, 200, 300)):
            self.assertAlmostEqual(got, centre, delta=1)
        radius = 50 * math.sqrt(3)
        distance = math.dist(lamp.GetPosition(), lamp.GetFocalPoint())
        self.assertAlmostEqual(distance, 3 * radius, delta=3)
        self.assertGreater(lamp.GetPosition()[2], 300 + 2 * radius)
        position = lamp.GetPosition()
        add_actor(renderer, ball((900, 0, 0), 5))
        picture(window)
        self.assertEqual(lamp.GetPosition(), position)

    def test_the_scene_comes_later_into_a_window_in_use(self):
        renderer = vtkRenderer()
        window = make_window(make_renderer())
        picture(window)
        window.AddRenderer(renderer)
        rtwshadows.enable_shadows(renderer, light="lamp")
        add_actor(renderer, ball((100, 200, 300), 50))
        picture(window)
        lamp = every_light(renderer)[-1]
        for got, centre in zip(lamp.GetFocalPoint(), (100, 200, 300)):
            self.assertAlmostEqual(got, centre, delta=1)

    def test_sun_stands_where_its_name_says(self):
        """Left of the view, above in the scene and on the viewer's side, in z-up and y-up scenes,
        and however the camera is inclined."""
        for up, position in (((0, 0, 1), (0, -8, 3)), ((0, 0, 1), (0, -8, 30)),
                             ((0, 1, 0), (0, 3, 8)), ((0, 0.9, 0.3), (0, 0, 5))):
            renderer = make_renderer(sun=False)
            camera = renderer.GetActiveCamera()
            camera.SetPosition(position)
            camera.SetViewUp(up)
            rtwshadows.enable_shadows(renderer, light="sun")
            sun = every_light(renderer)[-1]
            towards = [p - f for p, f in zip(sun.GetPosition(), sun.GetFocalPoint())]
            axis = 2 if up[2] > up[1] else 1
            length = math.sqrt(sum(t * t for t in towards))
            self.assertGreater(towards[axis], 0.7 * length)
            self.assertLess(towards[0], -0.3 * length)  # the camera's right is x
            self.assertGreater(towards[3 - axis] * (-1 if axis == 2 else 1), 0)
            self.assertTrue(sun.LightTypeIsSceneLight() and not sun.GetPositional())

    def test_lamp_covers_the_scene(self):
        renderer = make_renderer(sun=False)
        rtwshadows.enable_shadows(renderer, light="lamp")
        lamp = every_light(renderer)[-1]
        self.assertTrue(lamp.GetPositional() and lamp.GetConeAngle() < 90)
        axis = [f - p for p, f in zip(lamp.GetPosition(), lamp.GetFocalPoint())]
        for x in (-3, 3):
            for y in (-3, 3):
                to = [c - p for p, c in zip(lamp.GetPosition(), (x, y, 0))]
                cosine = sum(a * b for a, b in zip(axis, to)) / (
                    math.hypot(*axis) * math.hypot(*to))
                self.assertLess(math.degrees(math.acos(cosine)), lamp.GetConeAngle())

    def test_direction_is_towards_the_light(self):
        """As a vtkLight's position is, whose focal point is the origin: from +x the shadow falls to
        -x, the left of the picture."""
        for x, side in ((2, -1), (-2, 1)):
            renderer = make_renderer(sun=False)
            window = make_window(renderer)
            shadows = rtwshadows.enable_shadows(renderer, light=(x, 0, 2))
            picture(window)
            shadow = shadow_of(shadows, 0)
            self.assertEqual(math.copysign(1, shadow.nonzero()[1].mean() - 79.5), side)

    def test_camera_left_moves_along(self):
        """From every side the shadow falls to the right of the picture."""
        renderer = make_renderer(sun=False)
        window = make_window(renderer)
        shadows = rtwshadows.enable_shadows(renderer, light="camera-left")
        for _ in range(3):
            picture(window)
            shadow = shadow_of(shadows, 0)
            self.assertGreater(shadow.nonzero()[1].mean(), 82)
            renderer.GetActiveCamera().Azimuth(120)
            renderer.ResetCameraClippingRange()

    def test_headlights_are_dimmed_and_scene_lights_are_not(self):
        renderer = make_renderer()
        headlight, own = vtkLight(), every_light(renderer)[0]
        headlight.SetLightTypeToHeadlight()
        headlight.SetIntensity(0.9)
        side = vtkLight()
        side.SetLightTypeToCameraLight()
        side.SetIntensity(0.6)
        for light in (headlight, side):
            renderer.AddLight(light)
        before = all_facts(renderer)
        rtwshadows.enable_shadows(renderer, light="sun")
        self.assertAlmostEqual(headlight.GetIntensity(), 0.18)
        self.assertAlmostEqual(side.GetIntensity(), 0.12)
        self.assertEqual(own.GetIntensity(), 1)
        self.assertEqual(len(every_light(renderer)), 4)
        rtwshadows.enable_shadows(renderer, "uniform")
        self.assertEqual(len(every_light(renderer)), 4)
        self.assertAlmostEqual(headlight.GetIntensity(), 0.18)
        rtwshadows.disable_shadows(renderer)
        self.assertEqual(all_facts(renderer), before)

    def test_what_others_changed_stays(self):
        renderer = make_renderer(sun=False)
        headlight = vtkLight()
        headlight.SetLightTypeToHeadlight()
        renderer.AddLight(headlight)
        rtwshadows.enable_shadows(renderer, light="sun")
        headlight.SetIntensity(0.7)
        mine = vtkLight()
        renderer.AddLight(mine)
        rtwshadows.disable_shadows(renderer)
        self.assertEqual(every_light(renderer), [headlight, mine])
        self.assertEqual(headlight.GetIntensity(), 0.7)

    def test_another_replaces_it(self):
        renderer = make_renderer(sun=False)
        window = make_window(renderer)
        picture(window)
        (headlight,) = every_light(renderer)
        mine = vtkLight()
        mine.SetPosition(1, 0, 1)
        for light in LIGHTS + (mine, "lamp"):
            rtwshadows.enable_shadows(renderer, light=light)
            picture(window)
            self.assertEqual(len(every_light(renderer)), 2)
            self.assertAlmostEqual(headlight.GetIntensity(), 0.3)
        self.assertNotIn(mine, every_light(renderer))
        renderer.SetPass(None)
        rtwshadows.disable_shadows(renderer)
        self.assertEqual(every_light(renderer), [headlight])
        self.assertEqual(headlight.GetIntensity(), 1)

    def test_a_light_of_the_users(self):
        """Is added as it is, and stays where it was in the renderer before."""
        light = vtkLight()
        light.SetPosition(3, 0, 3)
        light.SetIntensity(0.5)
        before = facts(light)
        renderer = make_renderer(sun=False)
        window = make_window(renderer)
        without = picture(window)
        rtwshadows.enable_shadows(renderer, light=light)
        self.assertIn(light, every_light(renderer))
        self.assertTrue(0.003 < darker(without, picture(window)).mean() < 0.2)
        self.assertEqual(facts(light), before)
        rtwshadows.disable_shadows(renderer)
        self.assertNotIn(light, every_light(renderer))
        renderer.AddLight(light)
        rtwshadows.enable_shadows(renderer, light=light)
        self.assertEqual(every_light(renderer).count(light), 1)
        rtwshadows.disable_shadows(renderer)
        self.assertIn(light, every_light(renderer))
        headlight = vtkLight()
        headlight.SetLightTypeToHeadlight()
        other = make_renderer(sun=False)
        self.assertEqual(
            len(warnings_of(lambda: rtwshadows.enable_shadows(other, light=headlight))), 1)

    def test_bad_lights_change_nothing(self):
        renderer = make_renderer()
        before = all_facts(renderer)
        for light, error, text in (
                ("moon", ValueError, "'moon' is not known; among: 'sun', 'lamp', 'camera-left'"),
                ((0, 0, 0), ValueError, "three finite numbers, not all 0"),
                ((1, 2), ValueError, "three finite numbers"),
                ((1, 2, math.nan), ValueError, "three finite numbers"),
                ((1, 2, math.inf), ValueError, "three finite numbers"),
                (7, TypeError, "expected one of 'sun'"),
                (("a", "b", "c"), TypeError, "expected one of 'sun'"),
                (renderer, TypeError, "expected one of 'sun'")):
            with self.assertRaisesRegex(error, text):
                rtwshadows.enable_shadows(renderer, light=light)
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(all_facts(renderer), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
