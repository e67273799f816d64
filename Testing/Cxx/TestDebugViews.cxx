// SPDX-License-Identifier: BSD-3-Clause
#include "rtwDebugViews.h"

int TestDebugViews(int argc, char* argv[])
{
  rtwCheckDebugViews(0, rtwChain::Steps, argc, argv);
  return rtwTestResult();
}
