// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwLightCollector.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
bool IsBlack(vtkLight* light)
{
  const double* colour = light->GetDiffuseColor();
  const double* specular = light->GetSpecularColor();
  return !(light->GetIntensity() > 0) ||
    (colour[0] <= 0 && colour[1] <= 0 && colour[2] <= 0 && specular[0] <= 0 && specular[1] <= 0 &&
      specular[2] <= 0);
}

ShadowLight Read(vtkLight* light, int switched)
{
  double position[3], focus[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focus);
  ShadowLight result;
  result.Kind = light->GetPositional() ? LightKind::Spot : LightKind::Directional;
  result.Switched = switched;
  result.Position = { position[0], position[1], position[2] };
  result.Direction =
    glm::normalize(glm::dvec3(focus[0], focus[1], focus[2]) - result.Position);
  result.ConeAngle = light->GetConeAngle();
  result.Attenuation = light->GetShadowAttenuation();
  return result;
}

bool IsFinite(const ShadowLight& light)
{
  return std::isfinite(light.Direction.x + light.Direction.y + light.Direction.z) &&
    std::isfinite(light.Position.x + light.Position.y + light.Position.z) &&
    std::isfinite(light.ConeAngle);
}
}

LightCollection CollectLights(vtkRenderer* renderer)
{
  LightCollection result;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const int switched = result.Switched++;
    const ShadowLight shadowing = Read(light, switched);
    // A headlight needs no shadow: it shines from the eye, so that what it can't reach can't be
    // seen.
    if (light->LightTypeIsHeadlight() || IsBlack(light) || !(light->GetShadowAttenuation() > 0))
    {
      ++result.Skipped;
    }
    else if (light->GetPositional() && !(light->GetConeAngle() < 90))
    {
      ++result.Unsupported;
    }
    else if (!IsFinite(shadowing) || !(light->GetConeAngle() > 0 || !light->GetPositional()))
    {
      ++result.Broken;
    }
    else
    {
      result.Shadowing.push_back(shadowing);
      result.Sources.emplace_back(light);
    }
  }
  return result;
}

int FindLight(const LightCollection& lights, vtkLight* light)
{
  const auto& sources = lights.Sources;
  const auto found = std::find(sources.begin(), sources.end(), light);
  return light && found != sources.end() ? static_cast<int>(found - sources.begin()) : -1;
}
}
