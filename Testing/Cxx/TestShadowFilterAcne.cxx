// SPDX-License-Identifier: BSD-3-Clause
// Wide filters need no bias: away from true edges, by the filter's radius and two pixels,
// everything is as lit, and as dark, as exact rays say. Texels are smaller than pixels here.
#include "rtwShadowStage.h"

#include "rtwScene.h"

#include "vtkLightCollection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
// Of the pixels that are not near an edge, in percent.
struct Errors
{
  size_t Looked = 0, Wrong = 0, Stained = 0;

  double Percent(size_t count) const { return 100.0 * double(count) / double(this->Looked); }
};

// Stained is what a tenth of the light is missing from, or too much for. What is averted lies in its
// own shadow: a wide filter meets an edge there too.
Errors Count(const std::vector<unsigned char>& mask, const rtw::Truth& truth, int reach)
{
  rtw::Truth shadows = truth;
  std::replace(shadows.Mask.begin(), shadows.Mask.end(), static_cast<unsigned char>(rtw::MASK_AVERTED),
    static_cast<unsigned char>(rtw::MASK_SHADOW));
  const std::vector<char> near = rtw::NearEdges(shadows, reach);
  Errors errors;
  for (size_t i = 0; i < mask.size(); ++i)
  {
    const bool isKnown = truth.Mask[i] == rtw::MASK_LIT || truth.Mask[i] == rtw::MASK_SHADOW;
    if (isKnown && !near[i] && mask[i] != rtw::MASK_AVERTED)
    {
      const int off = std::abs(int(mask[i]) - int(truth.Mask[i]));
      ++errors.Looked;
      errors.Wrong += off > 127;
      errors.Stained += off > 25;
    }
  }
  return errors;
}

struct Scene
{
  const char* Name;
  std::function<vtkLight*(rtwShadowStage&)> Fill;
  double SoftRadius;     // that is no more than ten pixels wide on what receives
  double Wrong, Stained; // at most, in percent
};

void Check(rtwShadowStage& stage, const Scene& scene, const rtw::Truth& truth, int reach)
{
  stage.Render();
  const Errors errors = Count(stage.GetMask(0), truth, reach + 2);
  std::ostringstream text;
  text << scene.Name << ", filter " << stage.Pass->GetFilter() << " of "
       << stage.Pass->GetFilterRadius() << ": of " << errors.Looked << " pixels "
       << errors.Percent(errors.Wrong) << " % wrong, " << errors.Percent(errors.Stained)
       << " % stained";
  std::cout << text.str() << std::endl;
  rtwCheck(errors.Looked > 1000 && errors.Percent(errors.Wrong) <= scene.Wrong &&
      errors.Percent(errors.Stained) <= scene.Stained,
    __FILE__, __LINE__, text.str());
}

void TestScene(const Scene& scene, rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  vtkLight* light = scene.Fill(stage);
  stage.Pass->SetResolution(2048);
  stage.Pass->SetFilterToPCF();
  stage.Render();
  const rtw::Truth truth = stage.Trace(light);
  for (const int radius : { 0, 1, 2, 4, 8 })
  {
    stage.Pass->SetFilterRadius(radius);
    Check(stage, scene, truth, radius);
  }
  stage.Pass->SetFilterToSoft();
  stage.Pass->SetFilterRadius(scene.SoftRadius);
  Check(stage, scene, truth, 10);
}

vtkLight* FillWithObjects(rtwShadowStage& stage)
{
  stage.AddObjects();
  return stage.AddSun(3, 5, 2);
}

vtkLight* FillUnderSpot(rtwShadowStage& stage)
{
  stage.AddObjects();
  return stage.AddSpot(3, 7, 2, 40);
}

// Lit at a grazing angle.
vtkLight* FillWithPlane(rtwShadowStage& stage)
{
  stage.AddFloor();
  stage.AddBox(3, 0.1, -3, 0.2);
  return stage.AddSun(8, 0.6, 3);
}

vtkLight* FillWithSpheres(rtwShadowStage& stage)
{
  stage.AddBall(-1.5, 0.5, 0, 2, 96);
  stage.AddBall(2.2, 0.5, 0, 1.2, 12);
  return stage.AddSun(5, 2, 1);
}

vtkLight* FillWithTerrain(rtwShadowStage& stage)
{
  rtw::AddToRenderer(rtw::MakeScene("terrain", 0.3), stage.Renderer);
  return vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
}
}

int TestShadowFilterAcne(int, char*[])
{
  const Scene scenes[] = { { "objects", FillWithObjects, 0.1, 0, 0.02 },
    { "spot", FillUnderSpot, 0.1, 0, 0.02 }, { "plane", FillWithPlane, 0.02, 0, 0.02 },
    { "spheres", FillWithSpheres, 0.1, 0, 0.02 }, { "terrain", FillWithTerrain, 1, 0.1, 2.5 } };
  for (const Scene& scene : scenes)
  {
    TestScene(scene, rtwTechnique::RTW);
  }
  TestScene(scenes[3], rtwTechnique::Uniform);
  return rtwTestResult();
}
