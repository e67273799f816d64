# SPDX-License-Identifier: BSD-3-Clause
"""Properties by keyword: on VTK's own classes, which show every kind of setter."""

import unittest

from rtwshadows.properties import set_properties
from vtkmodules.vtkRenderingCore import vtkFXAAOptions, vtkProperty


class TestProperties(unittest.TestCase):
    def test_spellings(self):
        for name in ("line_width", "LineWidth", "linewidth"):
            target = vtkProperty()
            set_properties(target, {name: 3.0})
            self.assertEqual(target.GetLineWidth(), 3.0)

    def test_values(self):
        target = vtkProperty()
        set_properties(target, {"lighting": False, "color": (0.1, 0.2, 0.3), "opacity": 0.5})
        self.assertFalse(target.GetLighting())
        self.assertEqual(target.GetColor(), (0.1, 0.2, 0.3))
        self.assertEqual(target.GetOpacity(), 0.5)

    def test_words(self):
        target = vtkProperty()
        for word, value in (("flat", 0), ("GOURAUD", 1), ("Phong", 2)):
            set_properties(target, {"interpolation": word})
            self.assertEqual(target.GetInterpolation(), value)
        set_properties(target, {"material_name": "glass"})
        self.assertEqual(target.GetMaterialName(), "glass")

    def test_enumerators(self):
        target = vtkFXAAOptions()
        set_properties(target, {"debug_option_value": "fxaa_debug_edge_num_steps"})
        self.assertEqual(target.GetDebugOptionValue(), target.FXAA_DEBUG_EDGE_NUM_STEPS)

    def test_unknown_word(self):
        with self.assertRaisesRegex(ValueError, "interpolation='blinn'.*flat, gouraud"):
            set_properties(vtkProperty(), {"interpolation": "blinn"})
        with self.assertRaisesRegex(ValueError, "debug_option_value='x'.*fxaa_no_debug"):
            set_properties(vtkFXAAOptions(), {"debug_option_value": "x"})

    def test_unknown_name_sets_nothing(self):
        target = vtkProperty()
        with self.assertRaisesRegex(TypeError, "Property has no property 'line_wide'.*line_width"):
            set_properties(target, {"line_width": 7.0, "line_wide": 3.0})
        self.assertEqual(target.GetLineWidth(), vtkProperty().GetLineWidth())
        with self.assertRaises(TypeError):
            set_properties(target, {"debug": True})  # every vtkObject's, not a property of this one

    def test_bad_value(self):
        with self.assertRaisesRegex(TypeError, "line_width="):
            set_properties(vtkProperty(), {"line_width": [1, 2]})


if __name__ == "__main__":
    unittest.main()
