// SPDX-License-Identifier: BSD-3-Clause
// What shaders do with a mask's edges, in double precision, from exact view samples.
#ifndef rtwEdgeTwin_h
#define rtwEdgeTwin_h

#include "Light/rtwTurnChoice.h"

#include <vector>

class vtkAdaptiveShadowMapPass;
class vtkLight;
class vtkRenderer;

namespace rtw
{
/// Of vtkAdaptiveShadowMapPass::GetPredictedError, for casters that are warped.
double PredictedErrorTwin(
  vtkRenderer* renderer, vtkAdaptiveShadowMapPass* pass, vtkLight* light, int index);

/// The samples that a choice of the light plane's turn goes by, all of them, on the plane as it lay
/// in the last frame.
std::vector<TurnSample> TurnSamplesOf(
  vtkRenderer* renderer, vtkAdaptiveShadowMapPass* pass, vtkLight* light, int index);
}

#endif
