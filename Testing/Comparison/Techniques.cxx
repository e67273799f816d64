// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTechnique.h"

#include <vtkCascadedShadowMapPass.h>
#include <vtkExactShadowMapPass.h>
#include <vtkNew.h>
#include <vtkNoTWShadowMapPass.h>
#include <vtkPerspectiveShadowMapPass.h>
#include <vtkRTWShadowMapPass.h>
#include <vtkUniformShadowMapPass.h>

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

template <class Pass>
std::unique_ptr<Technique> Make(const TechniqueSettings& settings)
{
  return MakeAdaptiveTechnique(vtkNew<Pass>(), settings);
}

// All there are: a technique is one line here.
const Entry ENTRIES[] = {
  { "vtk", "VTK's own vtkShadowMapPass", MakeVtkTechnique },
  { "uniform", "vtkUniformShadowMapPass, the conventional map", Make<vtkUniformShadowMapPass> },
  { "rtw", "vtkRTWShadowMapPass, rectilinear texture warping", Make<vtkRTWShadowMapPass> },
  { "notw", "vtkNoTWShadowMapPass, non-orthogonal texture warping", Make<vtkNoTWShadowMapPass> },
  { "perspective", "vtkPerspectiveShadowMapPass, LiSPSM or as --perspective says",
    Make<vtkPerspectiveShadowMapPass> },
  { "exact", "vtkExactShadowMapPass, exact hard shadows", Make<vtkExactShadowMapPass> },
  { "cascades", "vtkCascadedShadowMapPass, layers by depth", Make<vtkCascadedShadowMapPass> },
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
