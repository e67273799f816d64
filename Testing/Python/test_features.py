# SPDX-License-Identifier: BSD-3-Clause
"""VTK's features, each in the same picture with our passes and without them, to the pixel.

    test_features.py TECHNIQUE [GROUP|ROW...]

GROUP is props, passes or windows. VERBOSE=1 says of each row how it went, OUT=FOLDER keeps pictures.

Shadows of attenuation 0 are not drawn at all, so that they alone would show little. Those of one too
small to change a float are: all is prepared, primed and looked up as ever, and every colour multiplied by
exactly 1.
"""

import argparse
import os
import sys
import time
import unittest

import numpy

from features.stage import ROWS, Stage, make, vtk
from features import look_rows, pass_rows, prop_rows, window_rows

GROUPS = {"props": (look_rows, prop_rows), "passes": (pass_rows,), "windows": (window_rows,)}
NO_CHANGE = 1e-9  # 1 - NO_CHANGE is 1 as a float
LEVELS = 1  # of 255
DEPTHS = 2.0 ** -22


def differences(seen, expected):
    """What is amiss, in words; nothing where all is as it should be."""
    found = []
    for key, picture in expected.items():
        other = seen[key]
        if other.shape != picture.shape:
            found.append(f"{key}: size {other.shape} instead of {picture.shape}")
            continue
        most = DEPTHS if key.startswith("depth") else LEVELS
        difference = abs(other.astype(float) - picture.astype(float)).max(axis=-1)
        if difference.max() > most:
            found.append(f"{key}: {(difference > most).sum()} pixels, "
                         f"by up to {difference.max():.6g}")
    return found


def keep(name, shown):
    """Pictures in the folder that OUT names, for those who look."""
    if "OUT" not in os.environ:
        return
    for key, picture in shown.items():
        if picture.dtype == numpy.uint8:
            image = make("vtkImageData", Dimensions=(picture.shape[1], picture.shape[0], 1))
            array = vtk.vtkUnsignedCharArray()
            array.SetNumberOfComponents(picture.shape[2])
            values = numpy.ascontiguousarray(picture)
            array.SetVoidArray(values, picture.size, 1)
            image.GetPointData().SetScalars(array)
            path = os.path.join(os.environ["OUT"], f"{name}-{key.replace(' ', '_')}.png")
            make("vtkPNGWriter", FileName=path, InputData=image).Write()


def check(name, technique):
    """All that is amiss with a row, in words."""
    stage = Stage()
    ROWS[name](stage)
    stage.without_shadows()
    stage.photograph()  # the first frame of some features is not as the rest
    expected = stage.photograph()
    keep(f"{name}-without", expected)
    found = []

    def compare(when):
        seen = stage.photograph()
        wrong = differences(seen, expected)
        if wrong:
            keep(f"{name}-{technique}-{when.replace(' ', '_')}", seen)
        found.extend(f"{when}: {what}" for what in wrong)

    stage.set_attenuation(NO_CHANGE)
    stage.with_shadows(technique)
    compare("at first")
    compare("once more")
    stage.set_attenuation(0)
    compare("attenuation 0")
    stage.without_shadows()
    compare("without again")
    stage.finish()
    return found


def rows_of(names):
    """With each group's rows in place of its name."""
    found = []
    for name in names:
        modules = [module.__name__ for module in GROUPS.get(name, ())]
        found += [row for row in ROWS if ROWS[row].__module__ in modules] if modules else [name]
    return found


class TestFeatures(unittest.TestCase):
    technique = None
    rows = ()

    def test_same_picture(self):
        for name in self.rows:
            with self.subTest(feature=name, technique=self.technique):
                if "VERBOSE" in os.environ:
                    print(f"{name}...", file=sys.stderr, flush=True)
                started = time.process_time()
                found = check(name, self.technique)
                if "VERBOSE" in os.environ:
                    print(f"{time.process_time() - started:5.1f} s  {name}: "
                          f"{'; '.join(found) or 'same'}", flush=True)
                self.assertEqual(found, [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("technique")
    parser.add_argument("rows", nargs="*")
    given = parser.parse_args()
    TestFeatures.technique = given.technique
    TestFeatures.rows = rows_of(given.rows or GROUPS)
    unittest.main(argv=sys.argv[:1])
