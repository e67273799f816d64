# SPDX-License-Identifier: BSD-3-Clause
"""Still frames of glyphs, imposters, assemblies, and all else that a frame depends on."""

import unittest

from still_frames import StillFrames, stretch, write

import rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkInformation, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkPiecewiseFunction,
    vtkPlane,
    vtkPolyData,
)
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import (
    vtkAssembly,
    vtkDataSetMapper,
    vtkGlyph3DMapper,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper

SCENES = []


def case(scene):
    """Of a function that adds to a stage and returns what changes something in it."""
    SCENES.append(scene)
    return scene


def places():
    points = vtkPoints()
    vertices = vtkCellArray()
    for i, place in enumerate(((-2, 0, 1), (0, 1, 1), (2, 0, 1))):
        points.InsertNextPoint(*place)
        vertices.InsertNextCell(1)
        vertices.InsertCellPoint(i)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(vertices)
    return data


def named(data, name, values, components=1):
    array = vtkFloatArray()
    array.SetName(name)
    array.SetNumberOfComponents(components)
    array.SetNumberOfTuples(data.GetNumberOfPoints())
    vtk_to_numpy(array)[:] = values
    data.GetPointData().AddArray(array)
    return array


@case
def source(s):
    ball = s.ball()
    s.add(s.surface(ball))
    return lambda: ball.SetRadius(1.4)


@case
def source_of_dataset(s):
    ball, grid = s.ball(), vtkAppendFilter()
    grid.AddInputConnection(ball.GetOutputPort())
    s.add(s.surface(grid, vtkDataSetMapper))
    return lambda: ball.SetRadius(1.4)


@case
def points(s):
    ball = s.ball()
    ball.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(ball.GetOutput())
    s.add(mapper)
    return write(ball.GetOutput().GetPoints().GetData(), stretch)


def imposters(s):
    data = places()
    mapper = vtkOpenGLSphereMapper()
    mapper.SetInputData(data)
    mapper.SetRadius(0.6)
    return data, mapper, s.add(mapper)


@case
def imposter_points(s):
    return write(imposters(s)[0].GetPoints().GetData(), stretch)


@case
def imposter_scales(s):
    data, mapper, _ = imposters(s)
    mapper.SetScaleArray("r")
    return write(named(data, "r", (0.3, 0.5, 0.7)), lambda values: values.put((0, 1), (0.7, 0.2)))


def glyphs(s):
    data, cone, mapper = places(), vtkConeSource(), vtkGlyph3DMapper()
    cone.SetHeight(1.5)
    directions = named(data, "o", (1, 0, 0), 3)
    scales = named(data, "s", 1)
    mapper.SetInputData(data)
    mapper.SetSourceConnection(cone.GetOutputPort())
    mapper.SetOrientationArray("o")
    mapper.SetOrientationModeToDirection()
    mapper.SetScaleArray("s")
    mapper.SetScaleModeToScaleByMagnitude()
    s.kept.append(cone)
    s.add(mapper)
    return mapper, cone, directions, scales


@case
def glyph_source(s):
    cone = glyphs(s)[1]
    return lambda: cone.SetHeight(2.5)


@case
def glyph_source_points(s):
    mapper, cone, _, _ = glyphs(s)
    cone.Update()
    data = vtkPolyData()
    data.DeepCopy(cone.GetOutput())
    mapper.SetSourceData(data)
    return write(data.GetPoints().GetData(), stretch)


@case
def glyph_directions(s):
    return write(glyphs(s)[2], lambda values: values.__setitem__(slice(None), (0, 1, 0.3)))


@case
def glyph_scales(s):
    return write(glyphs(s)[3], lambda values: values.put((0, 1, 2), (0.4, 1.4, 2)))


@case
def glyph_clipping_plane(s):
    plane = vtkPlane()
    plane.SetOrigin(-1, 0, 0)
    plane.SetNormal(1, 0, 0)
    glyphs(s)[0].AddClippingPlane(plane)
    return lambda: plane.SetOrigin(0.5, 0, 0)


@case
def gaussian_scale_function(s):
    data, mapper, scales = places(), vtkPointGaussianMapper(), vtkPiecewiseFunction()
    named(data, "r", (0.3, 0.5, 0.7))
    scales.AddPoint(0, 1)
    scales.AddPoint(1, 1)
    mapper.SetInputData(data)
    mapper.EmissiveOff()
    mapper.SetScaleFactor(0.6)
    mapper.SetScaleArray("r")
    mapper.SetScaleFunction(scales)
    s.add(mapper)
    return lambda: scales.AddPoint(1, 3)


@case
def user_matrix(s):
    matrix = vtkMatrix4x4()
    s.clipped()[2].SetUserMatrix(matrix)
    return lambda: matrix.SetElement(2, 2, 1.3)


@case
def user_transform_input(s):
    outer, inner = vtkTransform(), vtkTransform()
    outer.SetInput(inner)
    s.add(s.surface(s.ball())).SetUserTransform(outer)
    return lambda: inner.Translate(1, 0, 0)


def assembled(s, prop):
    s.renderer.RemoveActor(prop)
    inner, outer = vtkAssembly(), vtkAssembly()
    inner.AddPart(prop)
    outer.AddPart(inner)
    s.renderer.AddActor(outer)
    return inner


@case
def assembly_of_assembly(s):
    inner = assembled(s, s.add(s.surface(s.ball())))
    return lambda: inner.AddPosition(1, 0, 0)


@case
def assembly_of_imposters(s):
    inner = assembled(s, imposters(s)[2])
    return lambda: inner.AddPosition(1, 0, 0)


@case
def part_of_assembly(s):
    part = imposters(s)[2]
    assembled(s, part)
    return lambda: part.AddPosition(1, 0, 0)


@case
def culling(s):
    actor = s.clipped()[2]
    return actor.GetProperty().FrontfaceCullingOn


@case
def representation(s):
    return s.add(s.surface(s.ball())).GetProperty().SetRepresentationToWireframe


@case
def line_width(s):
    look = s.add(s.surface(s.ball())).GetProperty()
    look.SetRepresentationToWireframe()
    return lambda: look.SetLineWidth(6)


@case
def point_size(s):
    look = s.add(s.surface(s.ball())).GetProperty()
    look.SetRepresentationToPoints()
    return lambda: look.SetPointSize(8)


@case
def light_transform(s):
    s.add(s.surface(s.ball()))
    matrix = vtkMatrix4x4()
    s.light.SetTransformMatrix(matrix)

    def turn():
        for i, value in enumerate((0, -1, 1, 0)):
            matrix.SetElement(i // 2, i % 2, value)

    return turn


@case
def near_plane(s):
    s.add(s.surface(s.ball()))
    return lambda: s.camera.SetClippingRange(11.5, 30)


@case
def window_centre(s):
    s.add(s.surface(s.ball()))
    return lambda: s.camera.SetWindowCenter(0.3, 0.1)


@case
def casts_shadow(s):
    keys = vtkInformation()
    s.clipped()[2].SetPropertyKeys(keys)
    return lambda: keys.Set(rtwshadows.vtkAdaptiveShadowMapPass.CASTS_SHADOW(), 0)


@case
def viewport(s):
    s.add(s.surface(s.ball()))
    s.renderer.SetViewport(0, 0, 0.5, 1)
    return lambda: s.renderer.SetViewport(0.5, 0, 1, 1)


class TestStillProps(StillFrames):
    SCENES = SCENES


del StillFrames

if __name__ == "__main__":
    unittest.main()
