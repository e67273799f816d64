// SPDX-License-Identifier: BSD-3-Clause
// What of a technique's settings its warp has.
#include "rtwAdaptiveTechnique.h"

#include <vtkNonOrthogonalShadowMapWarp.h>
#include <vtkPerspectiveShadowMapWarp.h>
#include <vtkRectilinearShadowMapWarp.h>

namespace rtw
{
namespace
{
int ToBit(Importance importance)
{
  return 1 << static_cast<int>(importance); // vtkRectilinearShadowMapWarp has them in this order
}
}

void ConfigureImportance(vtkRectilinearShadowMapWarp* warp, const TechniqueSettings& settings)
{
  int functions = 0;
  for (const Importance importance : settings.ImportanceKinds)
  {
    functions |= ToBit(importance);
  }
  if (functions > 0)
  {
    warp->SetImportance(functions);
  }
  if (settings.AnalysisKind)
  {
    warp->SetAnalysis(static_cast<int>(*settings.AnalysisKind));
  }
  if (settings.EdgeThreshold)
  {
    warp->SetEdgeThreshold(*settings.EdgeThreshold);
  }
  if (settings.LightImage)
  {
    warp->SetLightImageResolution(*settings.LightImage);
  }
  if (settings.Interest)
  {
    warp->SetInterestToSphere();
    warp->SetInterestCentre(settings.Interest->data());
    warp->SetInterestRadius(settings.Interest->back());
  }
  if (settings.UserFunction)
  {
    warp->SetUserFunction(settings.UserFunction->c_str());
  }
  if (settings.CullEmptyCells)
  {
    warp->SetCullEmptyCells(*settings.CullEmptyCells);
  }
  if (settings.TemporalBlending)
  {
    warp->SetTemporalBlending(*settings.TemporalBlending);
  }
  if (settings.Snapping)
  {
    warp->SetSnapping(*settings.Snapping);
  }
}

void ConfigureNoTW(vtkNonOrthogonalShadowMapWarp* warp, const TechniqueSettings& settings)
{
  for (const Importance importance : settings.ImportanceKinds)
  {
    if (importance == Importance::SAMPLE_COUNT)
    {
      warp->SetWeightsToCount();
    }
  }
  if (settings.Smoothing)
  {
    warp->AutomaticSmoothingOff();
    warp->SetSmoothing(*settings.Smoothing);
  }
  if (settings.Cells)
  {
    warp->SetImportanceResolution(*settings.Cells);
  }
}

void ConfigurePerspective(vtkPerspectiveShadowMapWarp* warp, const TechniqueSettings& settings)
{
  if (settings.FocusPoint)
  {
    warp->SetFocusPoint(*settings.FocusPoint);
  }
  if (settings.Parameterization)
  {
    warp->SetParameterization(static_cast<int>(*settings.Parameterization));
  }
  if (settings.NearDistance)
  {
    warp->SetNearDistance(*settings.NearDistance);
  }
  if (settings.Eta)
  {
    warp->SetEta(*settings.Eta);
  }
  if (settings.Split)
  {
    warp->SetResolutionSplit(static_cast<int>(*settings.Split));
  }
  if (settings.SplitRatio)
  {
    warp->SetResolutionRatio(*settings.SplitRatio);
  }
}
}
