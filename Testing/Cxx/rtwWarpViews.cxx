// SPDX-License-Identifier: BSD-3-Clause
#include "rtwWarpViews.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <vector>

std::array<glm::dvec2, 2> rtwEndsIn(const rtwWarp& other, const rtwWarp& of)
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Invert(of.ToPlane, matrix);
  vtkMatrix4x4::Multiply4x4(other.ToPlane, matrix, matrix);
  std::array<glm::dvec2, 2> ends;
  for (int end = 0; end < 2; ++end)
  {
    double at[4] = { double(end), double(end), 0.5, 1 };
    matrix->MultiplyPoint(at, at);
    ends[0][end] = at[0] / at[3];
    ends[1][end] = at[1] / at[3];
  }
  return ends;
}

double rtwDifference(const rtw::WarpingFunction& a, const rtw::WarpingFunction& b)
{
  double most = a.GetCells() == b.GetCells() ? 0 : 1e9;
  for (int i = 0; i <= std::min(a.GetCells(), b.GetCells()); ++i)
  {
    most = std::max(most, std::abs(a.GetValues()[i] - b.GetValues()[i]));
  }
  return most;
}

double rtwDifference(const rtwWarp& a, const rtwWarp& b)
{
  return std::max(rtwDifference(a.Along[0], b.Along[0]), rtwDifference(a.Along[1], b.Along[1]));
}

rtwWarpViews::rtwWarpViews()
  : Following(vtkRTWShadowMapPass::SafeDownCast(this->Pass))
{
  this->AddObjects();
  this->Sun = this->AddSun(3, 5, 2);
  this->Spot = this->AddSpot(-2, 7, 3, 40);
  this->Plain->CachingOff();
  this->PlainSteps->SetShadowMapPass(this->Plain);
  this->Following->CachingOff();
  this->Camera = this->Renderer->GetActiveCamera();
}

rtwWarp rtwWarpViews::WarpOf(vtkRTWShadowMapPass* pass, int light)
{
  rtwWarp warp;
  vtkImageData* table = pass->GetWarpImage(light);
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<double> values;
    for (int i = 0; i < table->GetDimensions()[0]; ++i)
    {
      values.push_back(*static_cast<float*>(table->GetScalarPointer(i, axis, 0)));
    }
    warp.Along[axis] = rtw::WarpingFunction::FromValues(values);
  }
  pass->GetLightPlaneMatrix(light, 0, warp.ToPlane);
  return warp;
}

rtwWarp rtwWarpViews::Follow(int light)
{
  this->Render();
  return this->WarpOf(this->Following, light);
}

rtwWarp rtwWarpViews::Forget(int light)
{
  this->Renderer->SetPass(this->PlainSteps);
  this->Render();
  this->UsePass(true);
  return this->WarpOf(this->Plain, light);
}
