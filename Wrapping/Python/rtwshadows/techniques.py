# SPDX-License-Identifier: BSD-3-Clause
"""The shadow techniques, by name. A new one is one line here."""

from . import vtkRTWShadows as _module

_CLASSES = {
    "uniform": "vtkUniformShadowMapPass",
    "rtw": "vtkRTWShadowMapPass",
    "notw": "vtkNoTWShadowMapPass",
    "perspective": "vtkPerspectiveShadowMapPass",
    "cascades": "vtkCascadedShadowMapPass",
    "resolution_matched": "vtkResolutionMatchedShadowMapPass",
    "exact": "vtkExactShadowMapPass",
    "automatic": "vtkAutomaticShadowMapPass",
}


def available_techniques():
    """The names that enable_shadows takes in this build, as a tuple."""
    return tuple(name for name, class_name in _CLASSES.items() if hasattr(_module, class_name))


def make_pass(technique):
    """A new shadow map pass of the technique of that name; ValueError if there is none."""
    class_name = _CLASSES.get(technique) if isinstance(technique, str) else None
    if class_name is None or not hasattr(_module, class_name):
        known = ", ".join(repr(name) for name in available_techniques()) or "none"
        state = "is not in this build" if class_name else "is not known"
        raise ValueError(f"technique {technique!r} {state}; available: {known}")
    return getattr(_module, class_name)()
