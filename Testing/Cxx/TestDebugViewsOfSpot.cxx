// SPDX-License-Identifier: BSD-3-Clause
#include "rtwDebugViews.h"

int TestDebugViewsOfSpot(int argc, char* argv[])
{
  rtwCheckDebugViews(1, rtwChain::Classic, argc, argv);
  return rtwTestResult();
}
