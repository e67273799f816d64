// SPDX-License-Identifier: BSD-3-Clause
#include "Contestant.h"

std::string Contestant::Name() const
{
  const std::string& label = this->Label.empty() ? this->Technique : this->Label;
  return "technique:" + label + (this->Variant.empty() ? "" : "/variant:" + this->Variant);
}

std::vector<Contestant> Yardsticks()
{
  return { { "", false, "none" }, { "vtk", true } };
}

std::vector<Contestant> AllTechniques()
{
  std::vector<Contestant> all = Yardsticks();
  all.push_back({ "vtk", false, "vtk-kept" });
  for (const std::string& name : rtw::TechniqueNames())
  {
    if (name != "vtk")
    {
      all.push_back({ name });
    }
  }
  return all;
}
