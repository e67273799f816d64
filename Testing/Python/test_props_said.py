# SPDX-License-Identifier: BSD-3-Clause
"""What won't cast or receive is said once a prop, and only where somebody might expect that it does."""

import unittest

import prop_stage
from prop_stage import make, vtk
from test_props import NEITHER, actor_of, ball, billboard, box, graph, image, points_at


def volume():
    data = make("vtkImageData", Dimensions=(3, 3, 3))
    data.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    data.GetPointData().GetScalars().Fill(100)
    return make("vtkVolume", Mapper=make("vtkFixedPointVolumeRayCastMapper", InputData=data))


def gaussian():
    return make("vtkActor", Mapper=make("vtkPointGaussianMapper", InputDataObject=points_at((0, 0, 0))))


def keys(**values):
    information = vtk.vtkInformation()
    for name, value in values.items():
        information.Set(getattr(prop_stage.rtwshadows.vtkAdaptiveShadowMapPass, name)(), value)
    return information


class SaidTest(unittest.TestCase):
    def setUp(self):
        self.before = vtk.vtkOutputWindow.GetInstance()
        self.window = vtk.vtkStringOutputWindow()
        vtk.vtkOutputWindow.SetInstance(self.window)
        self.stage = prop_stage.Stage("rtw")
        self.stage.renderer.SetPass(self.stage.shadowed)

    def tearDown(self):
        vtk.vtkOutputWindow.SetInstance(self.before)

    def said(self):
        return [line for line in self.window.GetOutput().splitlines() if "ShadowMapPass" in line and "because" in line]

    def show(self, *props):
        for prop in props:
            self.stage.renderer.AddViewProp(prop)
        for _ in range(3):
            self.stage.shoot()

    def test_once(self):
        refused = {
            "a vtkGraphMapper": graph(),
            "casts shadows but receives none": gaussian(),
            "images": make("vtkImageActor", InputData=image()),
            "volumes": volume(),
        }
        self.show(*refused.values())
        self.assertEqual(len(self.said()), len(refused))
        for word in refused:
            self.assertEqual(sum(word in line for line in self.said()), 1, word)
        # Another of the same class is another prop.
        self.show(volume())
        self.assertEqual(len(self.said()), len(refused) + 1)
        # One that went and comes back isn't.
        back = refused["volumes"]
        self.stage.renderer.RemoveViewProp(back)
        self.stage.shoot()
        self.show(back)
        self.assertEqual(len(self.said()), len(refused) + 1)

    def test_parts(self):
        whole = vtk.vtkPropAssembly()
        for part in (ball(), volume(), billboard()):
            whole.AddPart(part)
        self.show(whole)
        self.assertEqual(len(self.said()), 1)
        self.assertIn("has a part, a vtkVolume, that neither casts", self.said()[0])
        self.assertIn("vtkPropAssembly", self.said()[0])

    def test_silent(self):
        expected = {"vtkGraphMapper", "vtkImageActor"}
        self.show(actor_of(box()), ball(), *(
            build(self.stage.renderer) for name, build in NEITHER.items() if name not in expected))
        # Nor of what isn't asked to.
        meant = volume()
        meant.SetPropertyKeys(keys(CASTS_SHADOW=0, RECEIVES_SHADOW=0))
        hidden = volume()
        hidden.VisibilityOff()
        self.show(meant, hidden)
        self.assertEqual(self.said(), [])


if __name__ == "__main__":
    unittest.main()
