# SPDX-License-Identifier: BSD-3-Clause
"""Features of windows: viewports, layers, stereo, screenshots, picks."""

from .look_rows import translucent
from .prop_rows import volumes
from .stage import actor_of, ball, floor, make, pixels_of, row, vtk, vtk_to_numpy


@row
def multisampling(stage):
    stage.window.SetMultiSamples(4)


@row
def multisampling_with_translucent(stage):
    multisampling(stage)
    translucent(stage)


@row
def multisampling_with_volumes(stage):
    multisampling(stage)
    volumes(stage)


def before_each(stage, *changes):
    """Photographs once after each change, and returns all that was seen."""
    once = stage.photograph

    def photograph():
        shown = {}
        for i, change in enumerate(changes):
            change()
            shown.update({f"{key} {i}": value for key, value in once().items()})
        return shown
    stage.photograph = photograph


@row
def multisampling_changed(stage):
    before_each(stage, *(lambda n=n: stage.window.SetMultiSamples(n) for n in (0, 4, 0)))


@row
def resized(stage):
    before_each(stage, *(lambda s=s: stage.window.SetSize(*s)
                         for s in ((160, 120), (90, 130), (200, 60))))


@row
def off_screen(stage):
    stage.window.SetOffScreenRendering(1)


@row
def shown_again_off_screen(stage):
    before_each(stage, *(lambda on=on: stage.window.SetOffScreenRendering(on) for on in (0, 1, 0)))


@row
def front_buffer(stage):
    def photograph():
        stage.window.Render()
        return {"front": pixels_of(stage.window, ReadFrontBuffer=True),
                "back": pixels_of(stage.window)}
    stage.photograph = photograph


@row
def unswapped(stage):
    stage.window.SwapBuffersOff()


@row
def double_buffer_off(stage):
    stage.window.DoubleBufferOff()


@row
def viewports(stage):
    other = stage.copy_of()
    stage.window.AddRenderer(other)
    stage.renderer.SetViewport(0, 0, 0.45, 1)
    other.SetViewport(0.45, 0, 1, 1)
    other.SetBackground(0.3, 0.1, 0.1)
    stage.shadowed.append(other)


@row
def viewports_of_which_one_has_shadows(stage):
    viewports(stage)
    stage.shadowed.pop()


@row
def viewports_with_multisampling(stage):
    viewports(stage)
    multisampling(stage)


@row
def layers(stage):
    """A renderer above the other, which shows through where it draws nothing."""
    above = make("vtkRenderer", Layer=1, AutomaticLightCreation=False)
    for x, opacity in ((-1, 1), (1, 0.5)):
        above.AddActor(stage.add(ball((x, -1, 1.5), 0.7), (0, 1, 1), Opacity=opacity))
        stage.renderer.RemoveActor(stage.renderer.GetActors().GetLastActor())
    above.AddActor(stage.floor)
    above.AddLight(stage.sun)
    above.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.window.SetNumberOfLayers(2)
    stage.window.AddRenderer(above)
    stage.shadowed.append(above)


@row
def layers_that_keep_depths(stage):
    layers(stage)
    stage.shadowed[1].PreserveDepthBufferOn()


@row
def two_windows(stage):
    other = stage.copy_of()
    second = make("vtkRenderWindow", MultiSamples=0, Size=(100, 80))
    # A prop's shaders live in one window.
    other.RemoveAllViewProps()
    for source in (floor(), ball((0, 0, 1.5))):
        other.AddActor(actor_of(source))
    second.AddRenderer(other)
    stage.shadowed.append(other)
    stage.kept.append(second)

    def photograph():
        shown = {}
        for i, window in enumerate((stage.window, second, stage.window)):
            window.Render()
            shown[f"window {i}"] = pixels_of(window)
        return shown
    stage.photograph = photograph


def stereo(kind):
    def change(stage):
        stage.window.SetStereoCapableWindow(1)
        stage.window.SetStereoType(kind)
        stage.window.StereoRenderOn()
    return change


def add_stereo_rows():
    for name in ("RED_BLUE", "ANAGLYPH", "INTERLACED", "LEFT", "RIGHT", "DRESDEN", "CHECKERBOARD",
                 "SPLITVIEWPORT_HORIZONTAL", "FAKE", "EMULATE"):
        change = stereo(getattr(vtk, "VTK_STEREO_" + name))
        change.__name__ = "stereo_" + name.lower()
        row(change)


add_stereo_rows()


def screenshot(scale, **settings):
    def photograph(stage):
        stage.window.Render()
        grab = make("vtkWindowToImageFilter", Input=stage.window, Scale=(scale, scale),
                    ReadFrontBuffer=False, **settings)
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        scalars = vtk_to_numpy(image.GetPointData().GetScalars())
        return {"shot": scalars.reshape(height, width, -1).copy()}
    return photograph


@row
def twice_as_large(stage):
    stage.photograph = lambda: screenshot(2)(stage)


@row
def three_times_as_large(stage):
    stage.photograph = lambda: screenshot(3, FixBoundary=True)(stage)


@row
def twice_as_large_with_translucent_viewports(stage):
    translucent(stage)
    viewports(stage)
    twice_as_large(stage)


@row
def tiles(stage):
    """A window that shows the middle of a picture of four by four."""
    stage.window.SetTileScale(2, 2)
    before_each(stage, *(lambda v=v: stage.window.SetTileViewport(*v)
                         for v in ((0, 0, 0.5, 0.5), (0.5, 0, 1, 0.5), (0.25, 0.25, 0.75, 0.75))))


@row
def resolution_doubled(stage):
    """As vtkRenderLargeImage takes it."""
    def photograph():
        large = make("vtkRenderLargeImage", Input=stage.renderer, Magnification=2)
        stage.window.Render()
        large.Update()
        image = large.GetOutput()
        width, height, _ = image.GetDimensions()
        scalars = vtk_to_numpy(image.GetPointData().GetScalars())
        return {"large": scalars.reshape(height, width, -1).copy()}
    stage.photograph = photograph


def picks(stage, pick):
    """What is under each tenth pixel, as a picture of numbers."""
    import numpy
    width, height = stage.window.GetSize()
    props = [stage.floor, stage.ball, stage.box, stage.pole]

    def number(x, y):
        prop = pick(x, y)
        return props.index(prop) + 1 if prop in props else 0

    stage.window.Render()
    found = [[number(x, y) for x in range(5, width, 15)] for y in range(5, height, 15)]
    return 100 * numpy.array(found)[:, :, None]


@row
def picks_by_ray(stage):
    def photograph():
        picker = vtk.vtkCellPicker()

        def pick(x, y):
            picker.Pick(x, y, 0, stage.renderer)
            return picker.GetActor()
        return {"picks": picks(stage, pick), **stage.photograph_window()}
    stage.photograph = photograph


@row
def picks_by_hardware(stage):
    def photograph():
        stage.window.Render()
        selector = make("vtkHardwareSelector", Renderer=stage.renderer)
        width, height = stage.window.GetSize()
        selector.SetArea(0, 0, width - 1, height - 1)
        selector.SetFieldAssociation(vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS)
        selector.CaptureBuffers()

        def pick(x, y):
            found = selector.GenerateSelection(x, y, x, y)
            node = found.GetNode(0) if found.GetNumberOfNodes() else None
            return node.GetProperties().Get(vtk.vtkSelectionNode.PROP()) if node else None
        shown = {"picks": picks(stage, pick)}
        selector.ClearBuffers()
        return {**shown, **stage.photograph_window()}
    stage.photograph = photograph


@row
def picks_by_prop(stage):
    def photograph():
        picker = vtk.vtkPropPicker()

        def pick(x, y):
            picker.Pick(x, y, 0, stage.renderer)
            return picker.GetActor()
        return {"picks": picks(stage, pick), **stage.photograph_window()}
    stage.photograph = photograph


@row
def depths_at_pixels(stage):
    """As world point pickers ask for."""
    import numpy

    def photograph():
        stage.window.Render()
        picker = vtk.vtkWorldPointPicker()
        found = []
        for x in range(5, 160, 15):
            picker.Pick(x, 60, 0, stage.renderer)
            found.append(picker.GetPickPosition())
        return {"places": numpy.array(found)[:, None, :] * 255}
    stage.photograph = photograph


@row
def interrupted(stage):
    """A program that watches for an abort, and aborts every other frame."""
    frames = []

    def check(window, _):
        frames.append(0)
    stage.window.AddObserver("AbortCheckEvent", check)


@row
def aborted_in_between(stage):
    once = stage.photograph

    def photograph():
        stage.window.SetAbortRender(1)
        stage.window.Render()
        stage.window.SetAbortRender(0)
        return once()
    stage.photograph = photograph
