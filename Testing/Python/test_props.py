# SPDX-License-Identifier: BSD-3-Clause
"""Each prop of VTK casts and receives as its picture says, or does neither and changes nothing.

docs/PROPS.md lists them all; these are those that can be made without data or devices.
"""

import unittest

import prop_stage
from prop_stage import CENTRE, HALF, actor_of, box, make, vtk

TECHNIQUES = ("rtw", "exact")
HERE = box((0, 0, 0))  # to be placed


def points_at(*places):
    data = vtk.vtkPolyData()
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for place in places:
        cells.InsertNextCell(1)
        cells.InsertCellPoint(points.InsertNextPoint(*place))
    data.SetPoints(points)
    data.SetVerts(cells)
    return data


def ball(place=CENTRE, **settings):
    """An imposter: only its own mapper knows how to draw it."""
    mapper = make("vtkOpenGLSphereMapper", InputDataObject=points_at(place), Radius=HALF)
    actor = make("vtkActor", Mapper=mapper, **settings)
    actor.GetProperty().SetColor(0, 1, 0)
    return actor


def assembly(kind, *parts, **settings):
    whole = make(kind, **settings)
    for part in parts:
        whole.AddPart(part)
    return whole


def following(renderer, kind, **settings):
    return actor_of(HERE, kind, Camera=renderer.GetActiveCamera(), **settings)


def levels(*data, chosen):
    prop = vtk.vtkLODProp3D()
    ids = [prop.AddLOD(make("vtkPolyDataMapper", InputDataObject=d), make("vtkProperty", Color=(0, 1, 0)), 0.0)
           for d in data]
    prop.AutomaticLODSelectionOff()
    prop.SetSelectedLODID(ids[chosen])
    return prop


def lod_actor():
    actor = actor_of(box(), "vtkLODActor")
    actor.AddLODMapper(make("vtkPolyDataMapper", InputDataObject=box(half=(0.5, 0.5, 0.5))))
    return actor


def prop_follower(renderer, part):
    follower = make("vtkProp3DFollower", Position=CENTRE, Camera=renderer.GetActiveCamera())
    follower.SetProp3D(part)
    return follower


def axis_follower(renderer):
    follower = following(renderer, "vtkAxisFollower", Position=CENTRE)
    renderer.axis = make("vtkAxisActor", Point1=(0, 0, 0), Point2=(1, 0, 0))  # which nobody else keeps
    follower.SetAxis(renderer.axis)
    return follower


def placed_axes():
    transform = vtk.vtkTransform()
    transform.Translate(*CENTRE)
    return make("vtkAxesActor", UserTransform=transform, AxisLabels=False)


def axis(renderer):
    actor = make("vtkAxisActor", Point1=(-HALF, -3.7, 0.2), Point2=(HALF, -3.7, 1.2), Title="axis",
                 Camera=renderer.GetActiveCamera(), Bounds=(-HALF, HALF, -4.4, -3, 0.1, 1.5))
    actor.GetAxisLinesProperty().SetLineWidth(6)
    return actor


def billboard():
    return make("vtkBillboardTextActor3D", Input="XXX", Position=CENTRE)


def image():
    data = make("vtkImageData", Dimensions=(15, 1, 15), Origin=(-HALF, -3.7, 0.1), Spacing=(0.1, 1, 0.1))
    data.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
    data.GetPointData().GetScalars().Fill(50)
    return data


def graph():
    data = vtk.vtkMutableUndirectedGraph()
    data.AddEdge(data.AddVertex(), data.AddVertex())
    points = vtk.vtkPoints()
    points.InsertNextPoint(-HALF, -3.7, 0.1)
    points.InsertNextPoint(HALF, -3.7, 1.5)
    data.SetPoints(points)
    return make("vtkActor", Mapper=make("vtkGraphMapper", InputData=data, EdgeLineWidth=10))


def blocks():
    data = vtk.vtkMultiBlockDataSet()
    data.SetBlock(0, box())
    return data


def glyph():
    mapper = make("vtkGlyph3DMapper", InputDataObject=points_at(CENTRE), Scaling=False)
    mapper.SetSourceData(HERE)
    actor = make("vtkActor", Mapper=mapper)
    actor.GetProperty().SetColor(0, 1, 0)
    return actor


def widget(kind, renderer):
    shape = make(kind, PlaceFactor=1, Renderer=renderer)
    shape.PlaceWidget((-HALF, HALF, -4.4, -3, 0.1, 1.5))
    shape.VisibilityOn()
    shape.BuildRepresentation()
    return shape


# What stands in for a vtkActor of the same mesh casts as large a shadow.
AS_AN_ACTOR = {
    "vtkActor": lambda r: actor_of(box()),
    "vtkAssembly": lambda r: assembly("vtkAssembly", actor_of(HERE), Position=CENTRE),
    "vtkAssembly in vtkAssembly": lambda r: assembly(
        "vtkAssembly", assembly("vtkAssembly", actor_of(HERE, Position=(0, 0, HALF)), Scale=0.5), Scale=2,
        Position=(0, -3.7, 0.8 - HALF)),
    "vtkAssembly in vtkPropAssembly": lambda r: assembly(
        "vtkPropAssembly", assembly("vtkAssembly", actor_of(HERE), Position=CENTRE)),
    "vtkCompositePolyDataMapper": lambda r: actor_of(blocks(), mapper="vtkCompositePolyDataMapper2"),
    "vtkDataSetMapper": lambda r: actor_of(box(), mapper="vtkDataSetMapper"),
    "vtkGlyph3DMapper": lambda r: glyph(),
    "vtkLODActor": lambda r: lod_actor(),
    "vtkLODActor in vtkAssembly": lambda r: assembly(
        "vtkAssembly", actor_of(HERE, "vtkLODActor"), Position=CENTRE),
    "vtkLODProp3D": lambda r: levels(box(), box(half=(0.4, 0.4, 0.4)), chosen=0),
    "vtkLODProp3D, its last": lambda r: levels(box(half=(0.4, 0.4, 0.4)), box(), chosen=1),
    "vtkLODProp3D in vtkAssembly": lambda r: assembly(
        "vtkAssembly", levels(HERE, chosen=0), Position=CENTRE),
    "vtkLODActor beside text": lambda r: assembly(
        "vtkPropAssembly", lod_actor(), make("vtkBillboardTextActor3D", Input="XXX", Position=(0, 0, -5))),
    "vtkPropAssembly": lambda r: assembly("vtkPropAssembly", actor_of(HERE, Position=CENTRE)),
    "vtkPropAssembly in vtkPropAssembly": lambda r: assembly(
        "vtkPropAssembly", assembly("vtkPropAssembly", actor_of(HERE, Position=CENTRE))),
    "vtkQuadricLODActor": lambda r: actor_of(box(), "vtkQuadricLODActor"),
}

# Of another shape; the share of its pixels that the roof darkens at least.
CASTING = {
    "vtkFollower": (lambda r: following(r, "vtkFollower", Position=CENTRE), 0.6),
    "vtkFollower in vtkAssembly": (
        lambda r: assembly("vtkAssembly", following(r, "vtkFollower"), Position=CENTRE), 0.4),
    "vtkMoleculeMapper": (lambda r: molecule(), 0.4),
    "vtkOpenGLSphereMapper": (lambda r: ball(), 0.5),
    "vtkOpenGLSphereMapper in vtkAssembly": (
        lambda r: assembly("vtkAssembly", ball((0, 0, 0)), Position=CENTRE), 0.5),
    "vtkProp3DFollower": (lambda r: prop_follower(r, actor_of(HERE)), 0.6),
    "vtkProp3DFollower of an imposter": (lambda r: prop_follower(r, ball((0, 0, 0))), 0.5),
    "vtkPropAssembly with annotations": (
        lambda r: assembly("vtkPropAssembly", ball(), billboard(), placed_axes(), axis(r)), 0.3),
}

NEITHER = {
    "vtkActor2D": lambda r: make(
        "vtkActor2D", Mapper=make("vtkLabeledDataMapper", InputDataObject=points_at(CENTRE))),
    "vtkAnnotatedCubeActor": lambda r: make("vtkAnnotatedCubeActor", Position=CENTRE),
    "vtkAxesActor": lambda r: placed_axes(),
    "vtkAxisActor": axis,
    "vtkAxisFollower": axis_follower,
    "vtkBillboardTextActor3D": lambda r: billboard(),
    "vtkBoxRepresentation": lambda r: widget("vtkBoxRepresentation", r),
    "vtkCaptionActor2D": lambda r: make("vtkCaptionActor2D", Caption="here", AttachmentPoint=CENTRE),
    "vtkCubeAxesActor": lambda r: make(
        "vtkCubeAxesActor", Bounds=(-HALF, HALF, -4.4, -3, 0.1, 1.5), Camera=r.GetActiveCamera()),
    "vtkGraphMapper": lambda r: graph(),
    "vtkImageActor": lambda r: make("vtkImageActor", InputData=image(), DisplayExtent=(0, 14, 0, 0, 0, 14)),
    "vtkImplicitPlaneRepresentation": lambda r: widget("vtkImplicitPlaneRepresentation", r),
    "vtkLegendScaleActor": lambda r: vtk.vtkLegendScaleActor(),
    "vtkPolarAxesActor": lambda r: make(
        "vtkPolarAxesActor", Bounds=(-HALF, HALF, -4.4, -3, 0.1, 1.5), Pole=CENTRE, MaximumRadius=1,
        Camera=r.GetActiveCamera()),
    "vtkSphereRepresentation": lambda r: widget("vtkSphereRepresentation", r),
    "vtkTextActor3D": lambda r: make("vtkTextActor3D", Input="XX", Position=CENTRE, Scale=0.02),
}
# Some of their pixels show the floor behind, and its shadow.
SEE_THROUGH = {
    "vtkActor2D", "vtkBillboardTextActor3D", "vtkCaptionActor2D", "vtkLegendScaleActor",
    "vtkPropAssembly with annotations",
    "vtkSphereRepresentation", "vtkTextActor3D"}


def molecule():
    atoms = vtk.vtkMolecule()
    atoms.AppendAtom(6, *CENTRE)
    mapper = make("vtkMoleculeMapper", InputData=atoms, AtomicRadiusScaleFactor=HALF)
    mapper.SetAtomicRadiusTypeToUnitRadius()
    return make("vtkActor", Mapper=mapper)


class PropTest(unittest.TestCase):
    def each(self, props, check):
        for technique in TECHNIQUES:
            stage = prop_stage.Stage(technique)
            reference = stage.look(actor_of(box()))
            self.assertGreater(reference.casts, 50)
            for name, build in props.items():
                with self.subTest(prop=name, technique=technique):
                    seen = stage.look(build(stage.renderer))
                    self.assertGreater(seen.pixels, 0)
                    # Where nothing is taken from the light, the picture is the one without our passes.
                    self.assertLessEqual(seen.changed, 1)
                    self.assertEqual(seen.holes, 0)
                    # It stands in the sun.
                    if name not in SEE_THROUGH:
                        self.assertLess(seen.darkened, 0.02)
                    check(name, seen, reference)

    def test_as_an_actor(self):
        def check(_, seen, reference):
            self.assertAlmostEqual(seen.casts, reference.casts, delta=0.1 * reference.casts)
            self.assertAlmostEqual(seen.receives, reference.receives, delta=0.05)

        self.each(AS_AN_ACTOR, check)

    def test_casting(self):
        def check(name, seen, _):
            # The sun comes from behind and the right, so that most of the shadow is hidden.
            self.assertGreater(seen.casts, 0.01 * seen.pixels)
            self.assertGreater(seen.receives, CASTING[name][1])

        self.each({name: build for name, (build, _) in CASTING.items()}, check)

    def test_neither(self):
        def check(name, seen, _):
            self.assertEqual(seen.casts, 0)
            if name not in SEE_THROUGH:
                self.assertLess(seen.receives, 0.02)

        self.each(NEITHER, check)

    def test_coarse_level(self):
        """A level that an actor chose for speed has no holes, and shadows none of itself."""
        for kind, technique in ((k, t) for k in ("vtkLODActor", "vtkQuadricLODActor") for t in TECHNIQUES):
            stage = prop_stage.Stage(technique)
            actor = actor_of(sphere(120), kind)
            if kind == "vtkLODActor":
                actor.AddLODMapper(make("vtkPolyDataMapper", InputDataObject=sphere(8)))
            actor.SetProperty(make("vtkProperty", Color=(0, 1, 0), Ambient=1, Diffuse=0))
            stage.renderer.AddViewProp(actor)
            stage.window.SetDesiredUpdateRate(1e9)
            stage.interactor.SetDesiredUpdateRate(75)
            for _ in range(3):  # every level has been tried then
                plain = stage.shoot()
            stage.renderer.RemoveViewProp(actor)
            with self.subTest(prop=kind, technique=technique):
                seen = stage.look(actor)
                self.assertGreater(seen.casts, 20)
                self.assertLess(abs(seen.pixels - its(stage, plain)), 0.05 * seen.pixels)
                self.assertEqual(seen.holes, 0)
                self.assertLessEqual(seen.changed, 1)

    def test_shared_keys(self):
        """Copies share their property keys, in which passes are put."""
        stage = prop_stage.Stage("rtw")
        actor = actor_of(box((0, -3.7, 0.8)), PropertyKeys=vtk.vtkInformation())
        copy = vtk.vtkActor()
        copy.ShallowCopy(actor)
        copy.SetPosition(0, 0, 2)
        stage.renderer.AddViewProp(copy)
        seen = stage.look(actor)
        self.assertGreater(seen.casts, 20)
        self.assertFalse(actor.GetPropertyKeys().Has(vtk.vtkOpenGLRenderPass.RenderPasses()))


def sphere(resolution):
    source = make("vtkSphereSource", Center=CENTRE, Radius=HALF, ThetaResolution=resolution, PhiResolution=resolution)
    source.Update()
    return source.GetOutput()


def its(stage, plain):
    return (abs(plain - stage.bare_shadowless) > 30).any(-1).sum()


if __name__ == "__main__":
    unittest.main()
