# SPDX-License-Identifier: BSD-3-Clause
"""Values that a pass refuses, or would take for others: a ValueError that says what it takes."""

import math
import sys
import unittest

import rtwshadows
from rtwshadows.properties import set_properties
from stage import make_renderer
from vtkmodules.vtkRenderingCore import vtkProperty

NAN, INF = math.nan, math.inf

# By technique: what is refused, and the words that say so.
REFUSED = (
    ("uniform", {"resolution": 0}, "resolution=0 .*at least 1 texel"),
    ("uniform", {"resolution": -1}, "resolution=-1 .*at least 1 texel"),
    ("uniform", {"resolution": NAN}, "resolution=nan .*at least 1 texel"),
    ("uniform", {"resolution": 2**40}, "resolution=1099511627776 .*out of range"),
    ("rtw", {"filter_radius": -1}, "filter_radius=-1 .*from 0 to 1e30"),
    ("rtw", {"FilterRadius": NAN}, "FilterRadius=nan .*from 0 to 1e30"),
    ("rtw", {"filter_radius": INF}, "filter_radius=inf .*from 0 to 1e30"),
    ("rtw", {"filter": 9}, "filter=9 .*NEAREST.*SOFT"),
    ("rtw", {"depth_test": -1}, "depth_test=-1 .*DUAL"),
    ("rtw", {"constant_bias": 5}, "constant_bias=5 .*from 0 to 1"),
    ("rtw", {"maximum_edge_length": 0}, "maximum_edge_length=0 .*from 0.001 to 1"),
    ("rtw", {"view_sample_stride": 0}, "view_sample_stride=0 .*from 1 to 64"),
    ("rtw", {"view_sample_stride": 65}, "view_sample_stride=65 .*from 1 to 64"),
    ("rtw", {"importance_resolution": 3}, "importance_resolution=3 .*from 16 to 2048"),
    ("rtw", {"importance": -1}, "importance=-1 .*a sum of DESIRED_VIEW"),
    ("rtw", {"blur_sigma": 1000}, "blur_sigma=1000 .*from 0 to 64"),
    ("rtw", {"interest_centre": (NAN, 0, 0)}, "interest_centre="),
    ("rtw", {"debug_light": -1}, "debug_light=-1 .*from 0 on"),
    ("rtw", {"debug_view": 99}, "debug_view=99 .*NONE.*LAYERS"),
    ("rtw", {"warp": None}, "warp=None .*a vtkShadowMapWarp"),
    ("cascades", {"number_of_layers": 99}, "number_of_layers=99 .*from 1 to 8"),
    ("cascades", {"lambda": 2}, "lambda=2 .*from 0 to 1"),
    ("cascades", {"split_scheme": 7}, "split_scheme=7 .*UNIFORM.*SAMPLE_DISTRIBUTION"),
    ("perspective", {"eta": 5}, "eta=5 .*from -1.* to 1"),
    ("perspective", {"near_distance": -1}, "near_distance=-1 .*above 0"),
    ("exact", {"samples_per_pixel": 3}, "samples_per_pixel=3 .*1, 4 or 8"),
)


class TestRefusedValues(unittest.TestCase):
    def test_raise_and_change_nothing(self):
        """Neither a printed error, which fails the test in ctest, nor another value."""
        renderer = make_renderer()
        for technique, properties, words in REFUSED:
            if technique in rtwshadows.available_techniques():
                with self.subTest(properties):
                    with self.assertRaisesRegex(ValueError, words):
                        rtwshadows.enable_shadows(
                            renderer, technique, light="sun", **properties)
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(renderer.GetLights().GetNumberOfItems(), 1)

    def test_shadows_there_are_stay(self):
        renderer = make_renderer()
        shadows = rtwshadows.enable_shadows(renderer)
        steps = renderer.GetPass()
        with self.assertRaises(ValueError):
            rtwshadows.enable_shadows(renderer, resolution=0)
        self.assertIs(renderer.GetPass(), steps)
        self.assertIs(steps.GetShadowMapPass(), shadows)

    def test_other_types_are_type_errors(self):
        for properties in ({"resolution": 0.5}, {"resolution": None}, {"filter_radius": [1, 2]},
                           {"interest_centre": (1, 2)}, {"partition": 3}):
            with self.assertRaisesRegex(TypeError, next(iter(properties))):
                rtwshadows.enable_shadows(make_renderer(), **properties)

    def test_ends_of_ranges_are_taken(self):
        for properties in ({"resolution": 1}, {"filter_radius": 0}, {"constant_bias": 1},
                           {"view_sample_stride": 64}, {"importance_resolution": 2048},
                           {"interest_centre": (1, 2.5, -3)}, {"caching": False},
                           {"focus_on_view": 0}, {"maximum_edge_length": 0.001}):
            shadows = rtwshadows.enable_shadows(make_renderer(), "rtw", **properties)
            ((name, value),) = properties.items()
            got = getattr(shadows, "Get" + name.title().replace("_", ""))()
            self.assertEqual(got, value)

    def test_an_object_is_set_back(self):
        """Of several values those that came before the refused one too."""
        target = rtwshadows.vtkRTWShadowMapPass()
        for bad in ({"constant_bias": 5}, {"view_sample_stride": 99}, {"filter_radius": NAN},
                    {"resolution": 0.5}):
            with self.assertRaises((TypeError, ValueError)):
                set_properties(target, {"filter": "pcf", "snapping": True, **bad})
            fresh = rtwshadows.vtkRTWShadowMapPass()
            for name in ("Filter", "FilterRadius", "ConstantBias", "ViewSampleStride", "Snapping",
                         "Resolution"):
                self.assertEqual(getattr(target, "Get" + name)(), getattr(fresh, "Get" + name)())

    def test_classes_of_vtk(self):
        target = vtkProperty()
        with self.assertRaisesRegex(ValueError, "opacity=2 is refused: .*from 0 to 1"):
            set_properties(target, {"opacity": 2})
        self.assertEqual(target.GetOpacity(), 1)
        set_properties(target, {"opacity": 0.1, "line_width": 0.3})  # which is kept as a float


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
