// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "View.h"

#include "rtwCompare.h"

#include <cstdint>
#include <string>
#include <vector>

struct Result
{
  std::string Technique;
  std::string CaseText; // of --case; empty for what was asked for without
  int Resolution;
  rtw::ShadowErrors Errors;
  Times Milliseconds;
  int64_t Memory;   // bytes
  double Predicted = -1; // wrong, by the technique: a share of the pixels; negative if unknown
  double ToVtk = 0; // rebuilt, in times VTK's own pass at the same resolution; 0 if unknown
};

struct Report
{
  rtw::Scene Scene;
  size_t Primitives;
  Times Baseline; // without shadows
  rtw::ShadowErrors Truth;
  std::vector<Result> Results;
};

std::string ToTable(const Report& report);
std::string ToJson(const Report& report);

#endif
