// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMapTexels.h"

#include "Warp/NonOrthogonal/rtwNonOrthogonalWarp.h"

#include <vtkAdaptiveShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <glm/glm.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace rtw
{
namespace
{
WarpingFunction FunctionOf(vtkImageData* warp, int line, int slice)
{
  std::vector<double> values;
  for (int i = 0; i < warp->GetDimensions()[0]; ++i)
  {
    values.push_back(*static_cast<float*>(warp->GetScalarPointer(i, line, slice)));
  }
  return WarpingFunction::FromValues(values);
}

WarpingGrid GridOf(vtkImageData* warp, int slice)
{
  std::vector<WarpingFunction> lines;
  for (int line = 0; line < warp->GetDimensions()[1]; ++line)
  {
    lines.push_back(FunctionOf(warp, line, slice));
  }
  return WarpingGrid::FromFunctions(std::move(lines));
}

std::function<glm::dvec2(const glm::dvec2&)> HomographyOf(vtkImageData* warp)
{
  glm::dmat3 homography;
  for (int i = 0; i < 9; ++i)
  {
    homography[i % 3][i / 3] = *static_cast<float*>(warp->GetScalarPointer(i % 3, i / 3, 0));
  }
  return [=](const glm::dvec2& q) {
    const glm::dvec3 u = homography * glm::dvec3(q, 1);
    return u.z > 0 ? glm::dvec2(u) / u.z : glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  };
}

std::function<glm::dvec2(const glm::dvec2&)> TwinOf(vtkImageData* warp)
{
  if (warp->GetDimensions()[1] == 3)
  {
    return HomographyOf(warp);
  }
  if (warp->GetDimensions()[2] > 1)
  {
    const auto twin = std::make_shared<NonOrthogonalWarp>(
      NonOrthogonalWarp{ {}, GridOf(warp, 0), GridOf(warp, 1) });
    return [=](const glm::dvec2& q) { return twin->Forward(q); };
  }
  const RectilinearWarp twin{ {}, FunctionOf(warp, 0, 0), FunctionOf(warp, 1, 0) };
  return [=](const glm::dvec2& q) { return twin.Forward(q); };
}
}

TexelFunction TexelsOf(vtkAdaptiveShadowMapPass* pass, int light, int layer)
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkImageData* warp = pass->GetWarpImage(light, layer);
  vtkImageData* map = pass->GetShadowMapImage(light, layer);
  if (!warp || !map || !pass->GetLightPlaneMatrix(light, layer, matrix))
  {
    return {};
  }
  glm::dmat4 toPlane;
  for (int i = 0; i < 16; ++i)
  {
    toPlane[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
  }
  const glm::dvec2 size(map->GetDimensions()[0], map->GetDimensions()[1]);
  const auto twin = TwinOf(warp);
  return [=](const glm::dvec3& world) {
    const glm::dvec4 p = toPlane * glm::dvec4(world, 1);
    // Behind a spot there is no map.
    return p.w > 0 ? twin(glm::dvec2(p) / p.w) * size
                   : glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  };
}
}
