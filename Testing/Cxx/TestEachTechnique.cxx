// SPDX-License-Identifier: BSD-3-Clause
// TestEachTechnique --technique <name>: what each has to stand.
#include "rtwEachTechnique.h"

int TestEachTechnique(int argc, char* argv[])
{
  const rtwShadowBounds maps, exact{ 0.01, 0.005, 0.1, 0.02, 2.0 };
  const auto make = [](rtwTechnique technique) { return [=] { return rtwMakePass(technique); }; };
  const rtwTechniqueCase cases[] = { { "unfocused", make(rtwTechnique::Unfocused), maps },
    { "uniform", make(rtwTechnique::Uniform), maps }, { "rtw", make(rtwTechnique::RTW), maps },
    { "notw", make(rtwTechnique::NoTW), maps },
    { "perspective", make(rtwTechnique::Perspective), maps },
    { "cascades", make(rtwTechnique::Cascades), maps, false, 4 },
    { "exact", make(rtwTechnique::Exact), exact, true } };
  const std::string name = rtwGetArgument(argc, argv, "--technique");
  bool any = false;
  for (const rtwTechniqueCase& technique : cases)
  {
    if (name.empty() || name == technique.Name)
    {
      rtwCheckTechnique(technique);
      any = true;
    }
  }
  RTW_CHECK(any);
  return rtwTestResult();
}
