// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

namespace
{
struct Entry
{
  const char* Name;
  const char* Description;
  std::unique_ptr<Technique> (*Make)(int resolution, const Options& options);
};

const Entry ENTRIES[] = {
  { "vtk", "VTK's own vtkShadowMapPass", MakeVtkTechnique },
  { "uniform", "vtkUniformShadowMapPass, the conventional map", MakeUniformTechnique },
  { "rtw", "vtkRTWShadowMapPass, rectilinear texture warping", MakeRTWTechnique },
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
  throw UsageError(name + ": there is no such technique");
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

std::unique_ptr<Technique> MakeTechnique(
  const std::string& name, int resolution, const Options& options)
{
  return Find(name).Make(resolution, options);
}
