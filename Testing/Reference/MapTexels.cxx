// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMapTexels.h"

#include "rtwRectilinearWarp.h"

#include <vtkAdaptiveShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <glm/glm.hpp>

#include <limits>

namespace rtw
{
namespace
{
WarpingFunction FunctionOf(vtkImageData* warp, int axis)
{
  std::vector<double> values;
  for (int i = 0; i < warp->GetDimensions()[0]; ++i)
  {
    values.push_back(*static_cast<float*>(warp->GetScalarPointer(i, axis, 0)));
  }
  return WarpingFunction::FromValues(values);
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
  const double side = map->GetDimensions()[0];
  const RectilinearWarp twin{ {}, FunctionOf(warp, 0), FunctionOf(warp, 1) };
  return [=](const glm::dvec3& world) {
    const glm::dvec4 p = toPlane * glm::dvec4(world, 1);
    // Behind a spot there is no map.
    return p.w > 0 ? twin.Forward(glm::dvec2(p) / p.w) * side
                   : glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  };
}
}
