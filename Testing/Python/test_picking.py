# SPDX-License-Identifier: BSD-3-Clause
"""A selector finds what it finds without our passes: those of VTK that have no selection are no measure."""

import sys
import unittest

from ball_on_floor import TECHNIQUES, Stage, rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPiecewiseFunction,
    vtkSelectionNode,
)
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkHardwareSelector,
    vtkPropPicker,
    vtkRenderedAreaPicker,
    vtkRenderer,
    vtkVolume,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkSSAOPass
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper
except ImportError:
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper

POINTS = vtkDataObject.FIELD_ASSOCIATION_POINTS
CELLS = vtkDataObject.FIELD_ASSOCIATION_CELLS
SIZE = (120, 90)
BLOCKS, VOLUME = 4, 5  # among the props


def add_blocks(stage):
    blocks = vtkMultiBlockDataSet()
    for block in range(3):
        ball = vtkSphereSource()
        ball.SetCenter(block - 1, -2, 0.5)
        ball.SetRadius(0.4)
        ball.Update()
        blocks.SetBlock(block, ball.GetOutput())
    mapper = CompositeMapper()
    mapper.SetInputDataObject(blocks)
    actor = vtkActor()
    actor.SetMapper(mapper)
    stage.renderer.AddActor(actor)
    return actor


def add_volume(stage):
    image = vtkImageData()
    image.SetDimensions(6, 6, 6)
    image.SetSpacing(0.2, 0.2, 0.2)
    image.SetOrigin(1.2, 1, 0.2)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(200)
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputData(image)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1)
    opacity.AddPoint(255, 1)
    volume.GetProperty().SetScalarOpacity(opacity)
    stage.renderer.AddVolume(volume)
    return volume


class Picks(Stage):
    """With one prop of each kind that a selector treats in its own way."""

    def __init__(self, samples=0):
        super().__init__(SIZE, samples)
        glass = self.add_ball(-1.5, 0, 1, 0.5)
        glass.GetProperty().SetOpacity(0.4)
        unpickable = self.add_ball(1.5, -1, 0.5, 0.3)
        unpickable.PickableOff()
        self.props = [self.floor, self.ball, glass, unpickable, add_blocks(self), add_volume(self)]

    def select(self, association, area=None):
        selector = vtkHardwareSelector()
        selector.SetRenderer(self.renderer)
        selector.SetFieldAssociation(association)
        selector.SetArea(*(area or (0, 0, SIZE[0] - 1, SIZE[1] - 1)))
        selection = selector.Select()
        found = []
        for i in range(selection.GetNumberOfNodes()):
            node = selection.GetNode(i)
            keys = node.GetProperties()
            prop = keys.Get(vtkSelectionNode.PROP())
            prop = self.props.index(prop) if prop in self.props else -1
            block = keys.Get(vtkSelectionNode.COMPOSITE_INDEX())
            ids = sorted(vtk_to_numpy(node.GetSelectionList()).tolist())
            pixels = keys.Get(vtkSelectionNode.PIXEL_COUNT())
            # Only blocks have a number, and VTK draws them in any order: which of two points at a place is seen is
            # chance.
            found.append((prop, block, None, ids) if prop == BLOCKS else (prop, None, pixels, ids))
        return sorted(found, key=str)

    def pick_props(self):
        """On a grid of 10 × 9 places: the prop, and where on it."""
        found = []
        for x in range(6, 120, 12):
            for y in range(5, 90, 10):
                picker = vtkPropPicker()
                hit = picker.Pick(x, y, 0, self.renderer)
                prop = picker.GetViewProp()
                place = tuple(round(c, 2) for c in picker.GetPickPosition())
                found.append((hit, self.props.index(prop) if prop else None, place))
        return found

    def pick_listed(self):
        picker = vtkPropPicker()
        picker.PickFromListOn()
        picker.AddPickList(self.floor)
        hit = picker.Pick(60, 45, 0, self.renderer)
        return hit, picker.GetViewProp() is self.floor

    def pick_area(self):
        picker = vtkRenderedAreaPicker()
        picker.AreaPick(30, 20, 90, 70, self.renderer)
        props = picker.GetProp3Ds()
        return sorted(self.props.index(p) for p in props)

    def everything(self):
        return {
            "cells": self.select(CELLS),
            "points": self.select(POINTS),
            "cells in an area": self.select(CELLS, (30, 20, 70, 60)),
            "one pixel": self.select(CELLS, (60, 45, 60, 45)),
            "props": self.pick_props(),
            "listed": self.pick_listed(),
            "area": self.pick_area(),
        }


class TestPicking(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        stage = Picks()
        stage.window.Render()
        cls.right = stage.everything()

    def check(self, stage, what):
        for name, found in stage.everything().items():
            self.assertEqual(found, self.right[name], f"{what}: {name}")

    def test_without_shadows_there_is_much_to_find(self):
        self.assertGreater(sum(len(node[3]) for node in self.right["cells"]), 150)
        self.assertEqual({node[0] for node in self.right["cells"]}, {0, 1, 2, 4, 5})
        self.assertEqual(len({node[1] for node in self.right["cells"] if node[0] == BLOCKS}), 3)
        self.assertGreater(sum(1 for hit in self.right["props"] if hit[0]), 40)

    def test_every_technique(self):
        for technique in TECHNIQUES:
            stage = Picks()
            shadows = rtwshadows.enable_shadows(stage.renderer, technique, 256)
            before = stage.picture()
            stage.window.Render()
            self.check(stage, technique)
            self.assertTrue((stage.picture() == before).all(), technique)
            # The picture's shadows are still there: nothing of them was drawn again.
            self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0, technique)
            self.assertGreater(shadows.GetNumberOfLayersReused(), 0, technique)

    def test_the_classic_chain(self):
        stage = Picks()
        stage.set_classic_chain(rtwshadows.vtkRTWShadowMapPass())
        before = stage.picture()
        self.check(stage, "classic")
        self.assertTrue((stage.picture() == before).all())

    def test_inside_another_pass(self):
        """Whose shader code would write other colours, and whose target isn't the window."""
        stage = Picks()
        stage.props[VOLUME].VisibilityOff()  # VTK 9.1 draws none inside such a pass, until its shader is made anew
        right = stage.everything()
        rtwshadows.enable_shadows(stage.renderer, resolution=256)
        around = vtkSSAOPass()
        around.SetDelegatePass(stage.renderer.GetPass())
        stage.renderer.SetPass(around)
        before = stage.picture()
        for name, found in stage.everything().items():
            # That pass leaves its own depth in the window, where points and places of props are looked for.
            if name == "props":
                self.assertEqual([hit[:2] for hit in found], [hit[:2] for hit in right[name]])
            elif name != "points":
                self.assertEqual(found, right[name], name)
        self.assertTrue((stage.picture() == before).all())
        stage.renderer.SetPass(None)
        around.ReleaseGraphicsResources(stage.window)

    def test_multisampled(self):
        stage = Picks(samples=4)
        shadows = rtwshadows.enable_shadows(stage.renderer, resolution=256)
        before = stage.picture()
        stage.window.Render()
        self.assertEqual(stage.select(CELLS), self.right["cells"])
        self.assertTrue((stage.picture() == before).all())
        self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0)
        self.assertEqual(stage.select(POINTS), self.right["points"])
        self.assertTrue((stage.picture() == before).all())

    def test_another_renderer_of_the_window_is_left_alone(self):
        stage = Picks()
        stage.renderer.SetViewport(0, 0, 0.5, 1)
        beside = vtkRenderer()
        beside.SetViewport(0.5, 0, 1, 1)
        beside.SetActiveCamera(stage.camera)
        beside.AddLight(stage.light)
        ball = stage.add_ball(0, 0, 2, 0.3)
        stage.props.append(ball)
        beside.AddActor(stage.floor)
        beside.AddActor(ball)
        stage.window.AddRenderer(beside)
        stage.window.SetMultiSamples(4)
        stage.window.Render()
        right = stage.select(CELLS)
        rtwshadows.enable_shadows(stage.renderer, resolution=256)
        shadows = rtwshadows.enable_shadows(beside, resolution=256)
        before = stage.picture()
        stage.window.Render()
        self.assertEqual(stage.select(CELLS), right)
        self.assertTrue((stage.picture() == before).all())
        self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
