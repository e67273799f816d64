# SPDX-License-Identifier: BSD-3-Clause
"""Still frames of surfaces that are clipped, cut out, coloured, and made of blocks."""

import unittest

from still_frames import StillFrames, stretch, write

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    VTK_UNSIGNED_CHAR,
    vtkInformation,
    vtkLookupTable,
    vtkUnsignedCharArray,
)
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPlane,
    vtkPolyData,
)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkCamera,
    vtkCompositeDataDisplayAttributes,
    vtkDataSetMapper,
    vtkFollower,
    vtkMapper,
    vtkPolyDataMapper,
    vtkProp,
    vtkTexture,
)

try:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper
except ImportError:  # from VTK 9.3 on one class does both
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper

SCENES = []


def case(scene):
    """Of a function that adds to a stage and returns what changes something in it."""
    SCENES.append(scene)
    return scene


@case
def clipping_plane_origin(s):
    plane = s.clipped()[1]
    return lambda: plane.SetOrigin(0.5, 0, 1.5)


@case
def clipping_plane_normal(s):
    plane = s.clipped()[1]
    return lambda: plane.SetNormal(0, 1, 0)


@case
def clipping_plane_of_dataset(s):
    plane = s.clipped(vtkDataSetMapper)[1]
    return lambda: plane.SetOrigin(0.5, 0, 1.5)


@case
def clipping_plane_added_to_dataset(s):
    mapper = s.surface(s.ball(), vtkDataSetMapper)
    s.add(mapper)
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 1.5)
    plane.SetNormal(1, 0, 0)
    return lambda: mapper.AddClippingPlane(plane)


def blocks(s, clip):
    data = vtkMultiBlockDataSet()
    for i in range(3):
        ball = vtkSphereSource()
        ball.SetCenter(2 * i - 2, 0, 1)
        ball.SetRadius(0.6)
        ball.Update()
        data.SetBlock(i, ball.GetOutput())
    mapper = CompositeMapper()
    mapper.SetInputDataObject(data)
    attributes = vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(attributes)
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 1)
    plane.SetNormal(0, 1, 0)
    if clip:
        mapper.AddClippingPlane(plane)
    s.add(mapper)
    return data, attributes, plane


@case
def clipping_plane_of_composite(s):
    plane = blocks(s, True)[2]
    return lambda: plane.SetOrigin(0, 0.3, 1)


@case
def block_visibility(s):
    data, attributes, _ = blocks(s, False)
    return lambda: attributes.SetBlockVisibility(data.GetBlock(1), False)


@case
def block_visibility_clipped(s):
    data, attributes, _ = blocks(s, True)
    return lambda: attributes.SetBlockVisibility(data.GetBlock(1), False)


@case
def block_opacity(s):
    data, attributes, _ = blocks(s, False)
    return lambda: attributes.SetBlockOpacity(data.GetBlock(1), 0.3)


@case
def block_points(s):
    return write(blocks(s, False)[0].GetBlock(1).GetPoints().GetData(), stretch)


@case
def block_points_clipped(s):
    return write(blocks(s, True)[0].GetBlock(1).GetPoints().GetData(), stretch)


def cut_out(columns):
    image = vtkImageData()
    image.SetDimensions(32, 32, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 4)
    scalars = image.GetPointData().GetScalars()
    pixels = vtk_to_numpy(scalars).reshape(32, 32, 4)
    pixels[:] = 255
    pixels[:, :columns, 3] = 0
    return image, scalars


def textured(s):
    texture = vtkTexture()
    image, scalars = cut_out(12)
    texture.SetInputData(image)
    actor = s.add(s.surface(s.square(1.5, 2)))
    actor.SetTexture(texture)
    return actor, texture, image, scalars


def clear_more(values):
    values.reshape(32, 32, 4)[:, :22, 3] = 0


@case
def texture_array(s):
    return write(textured(s)[3], clear_more)


@case
def texture_image(s):
    _, _, image, scalars = textured(s)
    return lambda: (clear_more(vtk_to_numpy(scalars)), image.Modified())


@case
def texture_input(s):
    texture = textured(s)[1]
    return lambda: texture.SetInputData(cut_out(25)[0])


@case
def texture_transform_input(s):
    texture = textured(s)[1]
    outer, inner = vtkTransform(), vtkTransform()
    outer.SetInput(inner)
    texture.SetTransform(outer)
    return lambda: inner.Translate(0.3, 0, 0)


@case
def texture_transform_of_keys(s):
    actor = textured(s)[0]
    keys = vtkInformation()
    actor.SetPropertyKeys(keys)
    matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    keys.Set(vtkProp.GeneralTextureTransform(), matrix, 16)
    moved = matrix[:3] + [0.3] + matrix[4:]
    return lambda: keys.Set(vtkProp.GeneralTextureTransform(), moved, 16)


@case
def texture_lookup_table(s):
    texture = textured(s)[1]
    image = vtkImageData()
    image.SetDimensions(32, 32, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 2)
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(32, 32, 2)
    pixels[:] = 255
    pixels[:, :12] = 0
    colours = vtkLookupTable()
    colours.SetNumberOfTableValues(2)
    colours.SetTableRange(0, 255)
    texture.SetInputData(image)
    texture.SetLookupTable(colours)
    texture.SetColorModeToMapScalars()

    def alphas(first, second):
        colours.SetTableValue(0, 1, 1, 1, first)
        colours.SetTableValue(1, 1, 1, 1, second)

    alphas(0, 1)
    return lambda: alphas(1, 0)


def coloured(s):
    heights = vtkElevationFilter()
    heights.SetInputConnection(s.ball().GetOutputPort())
    heights.SetLowPoint(0, 0, 0.5)
    heights.SetHighPoint(0, 0, 2.5)
    mapper = s.surface(heights)
    mapper.ScalarVisibilityOn()
    colours = vtkLookupTable()
    colours.SetAlphaRange(0, 1)
    colours.Build()
    mapper.SetLookupTable(colours)
    mapper.SetScalarRange(0, 1)
    s.add(mapper)
    return mapper, colours


@case
def lookup_table_alpha(s):
    colours = coloured(s)[1]
    return lambda: [colours.SetTableValue(i, 1, 0, 0, 1) for i in range(256)]


@case
def scalar_range(s):
    mapper = coloured(s)[0]
    return lambda: mapper.SetScalarRange(-5, -4)


@case
def opacity_array(s):
    ball = s.ball()
    ball.Update()
    data = vtkPolyData()
    data.ShallowCopy(ball.GetOutput())
    colours = vtkUnsignedCharArray()
    colours.SetNumberOfComponents(4)
    colours.SetNumberOfTuples(data.GetNumberOfPoints())
    vtk_to_numpy(colours)[:] = 100
    data.GetPointData().SetScalars(colours)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    s.add(mapper)
    return write(colours, lambda values: values.fill(255))


@case
def coincident_offset(s):
    mapper = s.clipped()[0]
    vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
    return lambda: mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(0, 40000)


@case
def uniform_of_user(s):
    shaders = s.add(s.surface(s.ball())).GetShaderProperty()
    shaders.AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", True,
        "vec4 plain = vertexMC;\n#define vertexMC (plain * vec4(1.0, 1.0, grow, 1.0))\n"
        "//VTK::PositionVC::Impl\n#undef vertexMC\n", False)
    uniforms = shaders.GetVertexCustomUniforms()
    uniforms.SetUniformf("grow", 1)
    return lambda: uniforms.SetUniformf("grow", 1.5)


@case
def camera_of_follower(s):
    follower = s.add(s.surface(s.square(1, 0)), vtkFollower)
    follower.SetPosition(0, 0, 2)
    camera = vtkCamera()
    camera.SetPosition(0, -5, 2)
    follower.SetCamera(camera)
    return lambda: camera.SetPosition(5, -1, 7)


class TestStillSurfaces(StillFrames):
    SCENES = SCENES


del StillFrames

if __name__ == "__main__":
    unittest.main()
