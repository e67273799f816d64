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
  std::vector<std::vector<rtw::Truth>> Views; // for each place on the way, of its first steps
  std::vector<rtw::ViewSample> Samples;       // of the first of all

  /// Null if it is not known.
  const rtw::Truth* Find(int place, int step) const;
};

/// Those of the last setup are kept, since the next may differ in nothing that matters to them.
std::shared_ptr<const Truths> TruthsOf(const Setup& setup, const Options& options);

#endif
