# SPDX-License-Identifier: BSD-3-Clause
"""Any set of post-processing passes and of props that these have to do with."""

from .pass_rows import around, peeling, ssao_pass
from .prop_rows import volumes
from .stage import make, vtk

FEATURES = ("peeling", "ssao", "fxaa", "multisampling", "tone mapping", "volume")
PROPS = ("peeling", "volume")
# Passes that draw the opaque step into a target of their own, some of a larger view.
STEPS = ("vtkToneMappingPass", "vtkFramebufferPass", "vtkGaussianBlurPass", "vtkEDLShading")


def add_panes(stage):
    """Translucent panes, one behind the other."""
    for i, colour in enumerate(((0.2, 0.9, 0.9), (0.9, 0.9, 0.1))):
        x = -1.2 + 1.1 * i
        pane = make("vtkPlaneSource", Origin=(x, -2 + i, 0.1), Point1=(x + 1.6, -2 + i, 0.1),
                    Point2=(x, -2 + i, 1.4))
        stage.add(pane, colour, Opacity=0.5)


def combine(stage, names, plainly=False):
    """Puts features into a stage; plainly: their props alone."""
    if "peeling" in names:
        add_panes(stage)
    if "volume" in names:
        volumes(stage)
    if plainly:
        return
    if "multisampling" in names:
        stage.window.SetMultiSamples(4)

    def chain(steps):
        if "peeling" in names:
            peeling("vtkDualDepthPeelingPass", MaximumNumberOfPeels=6)(steps)
        if "ssao" in names:
            shaded = ssao_pass()
            shaded.SetDelegatePass(vtk.vtkOpaquePass())
            steps.SetOpaquePass(shaded)
        # VTK's FXAA reads no multisampled target, and tone mapping has one that isn't.
        for name, outer in (("fxaa", "vtkOpenGLFXAAPass"), ("tone mapping", "vtkToneMappingPass")):
            steps = around(outer)(steps) if name in names else steps
        return steps
    stage.chain = chain


def draw_opaque_by(stage, name):
    def chain(steps):
        outer = make(name)
        cleared = make("vtkCameraPass", DelegatePass=vtk.vtkOpaquePass())
        outer.SetDelegatePass(cleared)
        steps.SetOpaquePass(outer)
        return steps
    stage.chain = chain
