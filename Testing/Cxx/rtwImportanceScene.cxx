// SPDX-License-Identifier: BSD-3-Clause
#include "rtwImportanceScene.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
// 1e9 where there is nothing to compare.
double Difference(const rtwImportanceScene::Maps& a, const rtwImportanceScene::Maps& b)
{
  double most = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    if (a[axis].empty() || a[axis].size() != b[axis].size())
    {
      return 1e9;
    }
    for (std::size_t i = 0; i < a[axis].size(); ++i)
    {
      most = std::max(most, std::abs(a[axis][i] - b[axis][i]));
    }
  }
  return most;
}
}

rtwImportanceScene::rtwImportanceScene(bool ball)
  : Warped(vtkRTWShadowMapPass::SafeDownCast(this->Pass))
{
  this->AddFloor(12);
  if (ball)
  {
    this->AddBall(2, 1, -1, 0.5);
  }
  this->Warped->SetImportanceFloor(0.0001);
  this->Warped->CachingOff();
}

rtwImportanceScene::Maps rtwImportanceScene::MapsWith(int importance, int analysis, int light)
{
  this->Warped->SetImportance(importance);
  this->Warped->SetAnalysis(analysis);
  this->Render();
  return this->GetMaps(light);
}

rtwImportanceScene::Maps rtwImportanceScene::MapsOf(const std::string& code, int others)
{
  this->Warped->SetUserFunction(code.c_str());
  return this->MapsWith(vtkRTWShadowMapPass::USER_FUNCTION | others);
}

rtwImportanceScene::Maps rtwImportanceScene::GetMaps(int light)
{
  Maps maps;
  const vtkSmartPointer<vtkImageData> image = this->Warped->GetWarpImage(light);
  for (int axis = 0; image && axis < 2; ++axis)
  {
    for (int i = 0; i < image->GetDimensions()[0]; ++i)
    {
      maps[axis].push_back(*static_cast<float*>(image->GetScalarPointer(i, axis, 0)));
    }
  }
  return maps;
}

double rtwImportanceScene::DensityAt(const std::array<double, 3>& point, int axis, const Maps& maps)
{
  vtkNew<vtkMatrix4x4> toPlane;
  this->Warped->GetLightPlaneMatrix(0, 0, toPlane);
  double at[4] = { point[0], point[1], point[2], 1 };
  toPlane->MultiplyPoint(at, at);
  const std::vector<double>& map = maps[axis];
  const int cells = static_cast<int>(map.size()) - 1;
  const int cell = std::clamp(static_cast<int>(at[axis] / at[3] * cells), 0, cells - 1);
  return cells * (map[cell + 1] - map[cell]);
}

void rtwCheckAlike(const std::string& what, const rtwImportanceScene::Maps& a,
  const rtwImportanceScene::Maps& b, double most)
{
  const double difference = Difference(a, b);
  std::cout << what << ": maps differ by " << difference << std::endl;
  rtwCheck(difference <= most, __FILE__, __LINE__, what);
}

void rtwCheckApart(const std::string& what, const rtwImportanceScene::Maps& a,
  const rtwImportanceScene::Maps& b, double least)
{
  const double difference = Difference(a, b);
  std::cout << what << ": maps differ by " << difference << std::endl;
  rtwCheck(difference >= least && difference < 1e9, __FILE__, __LINE__, what);
}
