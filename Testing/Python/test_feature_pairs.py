# SPDX-License-Identifier: BSD-3-Clause
"""Peeling, SSAO, FXAA, multisampling, tone mapping and volumes in any combination: the picture is as without our
passes where shadows change nothing, and has the same shadows where they do, in a viewport too.

    test_feature_pairs.py TECHNIQUE [all]
"""

import argparse
import itertools
import os
import sys
import time
import unittest

import numpy

from features.combinations import FEATURES, PROPS, STEPS, combine, draw_opaque_by
from features.stage import Stage, vtk_to_numpy
from test_features import NO_CHANGE, differences, keep

DARKER = 4  # levels: what counts as in shadow
SURELY = 16  # levels: what does so however translucent things and tones weaken it
CONTRAST = 24  # levels: what makes an edge
NEAR = 3  # pixels from an edge, where smoothing may decide either way
MOST_WRONG = 0.0005  # of the pixels
WINDOW = (200, 150)
VIEWPORT = (0.2, 0.2, 1, 1)
CORNER = (40, 30)


def grown(shape, by):
    """What lies within so many pixels."""
    padded = numpy.pad(shape, by)
    result = numpy.zeros_like(shape)
    height, width = shape.shape
    for dy, dx in itertools.product(range(2 * by + 1), repeat=2):
        result |= padded[dy:dy + height, dx:dx + width]
    return result


def edges_of(picture):
    """What lies near to where neighbours differ."""
    edges = numpy.zeros(picture.shape[:2], bool)
    for axis in (0, 1):
        steps = abs(numpy.diff(picture.astype(int), axis=axis)).max(axis=-1) > CONTRAST
        edges |= numpy.pad(steps, [(0, int(axis == 0)), (0, int(axis == 1))])
    return grown(edges, NEAR)


class Shaded:
    """What shadows do to a stage's picture, and the mask of its sun."""

    def __init__(self, stage, technique):
        stage.set_attenuation(1)
        stage.without_shadows()
        self.lit = stage.photograph()["colour"][..., :3]
        passes = stage.with_shadows(technique)
        self.dark = stage.photograph()["colour"][..., :3]
        mask = passes[0].GetShadowMask(0)
        width, height, _ = mask.GetDimensions()
        scalars = vtk_to_numpy(mask.GetPointData().GetScalars())
        self.mask = scalars.reshape(height, width, 1).copy()
        self.drop = (self.lit.astype(int) - self.dark.astype(int)).max(axis=-1)

    def share_wrong(self, plain, corner=(0, 0)):
        """Of the pixels of which the plain picture is sure, whose lower left one lies there."""
        x, y = corner
        height, width = plain.drop.shape
        shadow = self.drop[y:y + height, x:x + width] >= DARKER
        sure = (plain.drop == 0) | (plain.drop >= SURELY)
        sure &= ~(edges_of(plain.lit) | edges_of(plain.dark))
        return (sure & (shadow != (plain.drop >= SURELY))).mean()

    def share_masked_wrong(self, plain):
        sure = ~(edges_of(plain.mask) | edges_of(plain.lit))
        return (sure & (self.mask != plain.mask)[..., 0]).mean()


def shade(names, technique, plainly, viewport=None):
    stage = Stage()
    if viewport:
        stage.window.SetSize(*WINDOW)
        stage.renderer.SetViewport(*viewport)
    combine(stage, [name for name in names if name in FEATURES], plainly)
    for name in set(names) & set(STEPS):
        draw_opaque_by(stage, name)
    stage.photograph()
    shaded = Shaded(stage, technique)
    keep("_".join(("pair", technique, "viewport" if viewport else "whole",
                   "plain" if plainly else "full", *names)), {"colour": shaded.dark})
    stage.finish()
    return shaded


class TestPairs(unittest.TestCase):
    technique = None
    combinations = ()

    def same_picture(self, names):
        stage = Stage()
        combine(stage, names)
        stage.without_shadows()
        stage.photograph()
        expected = stage.photograph()
        stage.set_attenuation(NO_CHANGE)
        stage.with_shadows(self.technique)
        found = differences(stage.photograph(), expected)
        stage.finish()
        return found

    def same_shadows(self, names, plain):
        shaded = shade(names, self.technique, False)
        found = []
        # VTK's FXAA draws nothing from a multisampled target.
        if not {"fxaa", "multisampling"} <= set(names) and shaded.share_wrong(plain) > MOST_WRONG:
            found.append(f"{100 * shaded.share_wrong(plain):.2f} % of the pixels are wrong")
        if shaded.share_masked_wrong(plain) > MOST_WRONG:
            found.append(f"{100 * shaded.share_masked_wrong(plain):.2f} % of the mask is wrong")
        return found

    def check(self, names, find, *arguments):
        with self.subTest(features=names, technique=self.technique):
            started = time.process_time()
            found = find(names, *arguments)
            if "VERBOSE" in os.environ:
                print(f"{time.process_time() - started:5.1f} s  {find.__name__} {' + '.join(names)}: "
                      f"{'; '.join(found) or 'same'}", flush=True)
            self.assertEqual(found, [])

    def test_pairs(self):
        plain = {}
        for names in self.combinations:
            props = tuple(name for name in names if name in PROPS)
            if props not in plain:
                plain[props] = shade(props, self.technique, True)
                self.assertGreater((plain[props].drop >= SURELY).mean(), 0.02)
            self.check(names, self.same_picture)
            self.check(names, self.same_shadows, plain[props])

    def in_a_viewport(self, names):
        props = tuple(name for name in names if name in PROPS)
        plain = shade(props, self.technique, True)
        wrong = shade(names, self.technique, False, VIEWPORT).share_wrong(plain, CORNER)
        return [f"{100 * wrong:.2f} % of the pixels are wrong"] if wrong > MOST_WRONG else []

    def in_a_target_of_its_own(self, names):
        wrong = shade(names, self.technique, False).share_wrong(shade((), self.technique, True))
        return [f"{100 * wrong:.2f} % of the pixels are wrong"] if wrong > MOST_WRONG else []

    def test_opaque_steps(self):
        for name in STEPS:
            self.check((name,), self.in_a_target_of_its_own)

    def test_in_a_viewport(self):
        # Of VTK's passes these two draw elsewhere than in the viewport.
        for name in (set(FEATURES) | set(STEPS)) - {"ssao", "vtkGaussianBlurPass"}:
            self.check((name,), self.in_a_viewport)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("technique")
    parser.add_argument("which", nargs="?", default="some", choices=("some", "all"))
    given = parser.parse_args()
    TestPairs.technique = given.technique
    every = [tuple(itertools.compress(FEATURES, bits))
             for bits in itertools.product((0, 1), repeat=len(FEATURES))]
    TestPairs.combinations = every if given.which == "all" else [
        names for names in every if len(names) in (2, len(FEATURES))]
    unittest.main(argv=sys.argv[:1])
