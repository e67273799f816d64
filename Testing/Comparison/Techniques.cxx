// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTechnique.h"

#include <stdexcept>

namespace rtw
{
namespace
{
struct Entry
{
  const char* Name;
  const char* Description;
  std::unique_ptr<Technique> (*Make)(const TechniqueSettings& settings);
};

// All there are: a technique is one line here.
const Entry ENTRIES[] = {
  { "vtk", "VTK's own vtkShadowMapPass", MakeVtkTechnique },
  { "uniform", "vtkUniformShadowMapPass, the conventional map", MakeUniformTechnique },
  { "rtw", "vtkRTWShadowMapPass, rectilinear texture warping", MakeRTWTechnique },
  { "notw", "vtkNoTWShadowMapPass, non-orthogonal texture warping", MakeNoTWTechnique },
  { "perspective", "vtkPerspectiveShadowMapPass, LiSPSM or as --perspective says",
    MakePerspectiveTechnique },
  { "exact", "vtkExactShadowMapPass, exact hard shadows", MakeExactTechnique },
  { "cascades", "vtkCascadedShadowMapPass, layers by depth", MakeCascadesTechnique },
};

const Entry& Find(const std::string& name)
{
  for (const Entry& entry : ENTRIES)
  {
    if (name == entry.Name)
    {
      return entry;
    }
  }
  throw std::invalid_argument(name + ": there is no such technique");
}
}

std::vector<std::string> TechniqueNames()
{
  std::vector<std::string> names;
  for (const Entry& entry : ENTRIES)
  {
    names.push_back(entry.Name);
  }
  return names;
}

std::string TechniqueDescription(const std::string& name)
{
  return Find(name).Description;
}

std::unique_ptr<Technique> MakeTechnique(const std::string& name, const TechniqueSettings& settings)
{
  return Find(name).Make(settings);
}
}
