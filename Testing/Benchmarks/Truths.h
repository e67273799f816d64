// SPDX-License-Identifier: BSD-3-Clause
#ifndef Truths_h
#define Truths_h

#include "Setup.h"

#include "rtwReference.h"

#include <memory>
#include <vector>

class vtkRenderer;

/// The exact shadows of the first light where a setup's pixels are compared.
struct Truths
{
  std::vector<double> Places; // on the way, 0 to 1
  std::vector<rtw::Truth> Views;
  std::vector<rtw::ViewSample> Samples; // of the first of them
  std::vector<rtw::Truth> Steps;        // of the smallest moves of the camera, to see flicker
};

/// Those of the last setup are kept, since the next may differ in nothing that matters to them.
std::shared_ptr<const Truths> TruthsOf(const Setup& setup, int views);

#endif
