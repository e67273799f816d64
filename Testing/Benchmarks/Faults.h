// SPDX-License-Identifier: BSD-3-Clause
// Defects made on purpose, to see whether the benchmark and the report notice them.
#ifndef Faults_h
#define Faults_h

#include "rtwTechnique.h"

#include <memory>
#include <string>
#include <vector>

std::vector<std::string> FaultNames();
std::string FaultDescription(const std::string& fault);

/// The technique rtw with a defect.
std::unique_ptr<rtw::Technique> MakeFaulty(
  const std::string& fault, const rtw::TechniqueSettings& settings);

#endif
