// SPDX-License-Identifier: BSD-3-Clause
// How many view samples the texels of exact shadows' grids hold, by the grid's warp: a warp evens
// them out, and changes nothing of what is seen. Two scenes at 1024 × 1024 pixels; all six with the
// argument `all`.
#include "rtwTest.h"

#include "rtwCompare.h"
#include "rtwScene.h"

#include "vtkExactShadowMapPass.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkNew.h"
#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkRectilinearShadowMapWarp.h"
#include "vtkRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkShadowRenderStepsPass.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{
struct Lists
{
  int Longest;
  int Percentile99;
  int Samples;
  std::vector<unsigned char> Mask;
};

class Stage
{
public:
  explicit Stage(const std::string& scene)
    : Name(scene)
  {
    this->Window->SetSize(1024, 1024);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    rtw::AddToRenderer(rtw::MakeScene(scene), this->Renderer);
    this->Steps->SetShadowMapPass(this->Pass);
    this->Renderer->SetPass(this->Steps);
    this->Pass->CountListsOn();
  }

  Lists Count(vtkShadowMapWarp* warp, const char* grid)
  {
    this->Pass->SetWarp(warp);
    this->Window->Render();
    const Lists lists{ this->Pass->GetLongestList(0), this->Pass->GetListPercentile99(0),
      this->Pass->GetNumberOfListedSamples(0), rtw::MaskOf(this->Pass->GetShadowMask(0)) };
    std::cout << this->Name << ", " << grid << ": of " << lists.Samples << " samples at most "
              << lists.Longest << " on a texel, on 99 in a hundred " << lists.Percentile99
              << std::endl;
    return lists;
  }

private:
  std::string Name;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkExactShadowMapPass> Pass;
  vtkNew<vtkShadowRenderStepsPass> Steps;
};

// `evener`: how many times shorter the lists of 99 in a hundred texels are by each warp, at least.
void TestScene(const char* scene, double rectilinearEvener, double nonOrthogonalEvener)
{
  Stage stage(scene);
  vtkNew<vtkIdentityShadowMapWarp> identity;
  vtkNew<vtkRectilinearShadowMapWarp> rectilinear;
  vtkNew<vtkNonOrthogonalShadowMapWarp> nonOrthogonal;
  const Lists uniform = stage.Count(identity, "uniform");
  const Lists rtw = stage.Count(rectilinear, "rectilinear");
  const Lists notw = stage.Count(nonOrthogonal, "non-orthogonal");
  RTW_CHECK(uniform.Samples > 100000);
  RTW_CHECK_EQUAL(rtw.Samples, uniform.Samples);
  RTW_CHECK_EQUAL(notw.Samples, uniform.Samples);
  RTW_CHECK(rtw.Mask == uniform.Mask);
  RTW_CHECK(notw.Mask == uniform.Mask);
  RTW_CHECK(uniform.Percentile99 >= rectilinearEvener * rtw.Percentile99);
  RTW_CHECK(uniform.Percentile99 >= nonOrthogonalEvener * notw.Percentile99);
}
}

int TestExactLists(int argc, char* argv[])
{
  TestScene("town", 30, 70);
  TestScene("duel", 50, 90);
  if (argc > 1 && std::string(argv[1]) == "all")
  {
    for (const char* scene : { "sandbox", "furball", "playground", "robot" })
    {
      TestScene(scene, 1.2, 1.5);
    }
  }
  return rtwTestResult();
}
