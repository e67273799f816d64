// SPDX-License-Identifier: BSD-3-Clause
// Casters behind all that is seen are left out of a map with a non-orthogonal warp: of the map
// much, of the shadows nothing, whatever the filter. Nothing is where shadows are looked up that
// have no view samples.
#include "rtwShadowStage.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkImageData.h"
#include "vtkProperty.h"

#include <iostream>
#include <vector>

namespace
{
using Depths = std::vector<float>;
using Mask = std::vector<unsigned char>;

struct Drawn
{
  Depths Map;
  Mask Shadow;
};

Drawn Draw(rtwShadowStage& stage, int light, bool culling)
{
  stage.Pass->SetCullCasters(culling);
  stage.Render();
  const vtkSmartPointer<vtkImageData> map = stage.Pass->GetShadowMapImage(light);
  const auto* depths = static_cast<float*>(map->GetScalarPointer());
  return { { depths, depths + map->GetNumberOfPoints() },
    rtw::MaskOf(stage.Pass->GetShadowMask(light)) };
}

// The texels that are left out; says how many pixels differ for it.
int LeftOut(rtwShadowStage& stage, const char* name, int light)
{
  const Drawn all = Draw(stage, light, false), culled = Draw(stage, light, true);
  int leftOut = 0, nearer = 0, differing = 0;
  for (std::size_t i = 0; i < all.Map.size(); ++i)
  {
    leftOut += culled.Map[i] > all.Map[i];
    nearer += culled.Map[i] < all.Map[i];
  }
  for (std::size_t i = 0; i < all.Shadow.size(); ++i)
  {
    differing += all.Shadow[i] != culled.Shadow[i];
  }
  std::cout << name << ", light " << light << ": " << leftOut << " texels of " << all.Map.size()
            << " left out, " << nearer << " nearer, " << differing << " pixels of "
            << all.Shadow.size() << " differ" << std::endl;
  RTW_CHECK_EQUAL(nearer, 0);
  RTW_CHECK(differing < 1e-4 * double(all.Shadow.size())); // at the rim of an acne's tolerance
  return leftOut;
}

void TestFilters()
{
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.AddSpot(3, 7, 2, 40);
  stage.Pass->SetResolution(1024);
  const int texels = 1024 * 1024;
  for (int light = 0; light < 2; ++light)
  {
    stage.Pass->SetFilterToNearest();
    RTW_CHECK(LeftOut(stage, "nearest", light) > texels / 50);
    stage.Pass->SetFilterToBilinear();
    RTW_CHECK(LeftOut(stage, "bilinear", light) > texels / 50);
    stage.Pass->SetFilterToPCF();
    for (const double radius : { 1.0, 2.5, 8.0 })
    {
      stage.Pass->SetFilterRadius(radius);
      RTW_CHECK(LeftOut(stage, "PCF", light) > texels / 200);
    }
  }
  // Which may see anything.
  stage.Pass->SetFilterToSoft();
  stage.Pass->SetFilterRadius(0.1);
  RTW_CHECK_EQUAL(LeftOut(stage, "soft", 0), 0);
}

// A pane's shadows, and all behind it, are looked up while it is shaded.
void TestTranslucent()
{
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  RTW_CHECK(LeftOut(stage, "opaque", 0) > 0);
  stage.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.5);
  RTW_CHECK_EQUAL(LeftOut(stage, "translucent", 0), 0);
}
}

int TestNoTWCulling(int, char*[])
{
  TestFilters();
  TestTranslucent();
  return rtwTestResult();
}
