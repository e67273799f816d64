// SPDX-License-Identifier: BSD-3-Clause
#ifndef View_h
#define View_h

#include "Options.h"

#include "rtwTechniqueView.h"

#include <memory>
#include <string>
#include <vector>

/// Medians, in milliseconds.
struct Times
{
  double Rebuilt = 0; // a frame with shadow maps made anew
  double Still = 0;   // a frame in which nothing has changed
  std::vector<rtw::Stage> Stages;
};

/// A window that shows the scene by one technique, or without shadows.
struct View
{
  View(const rtw::Scene& scene, const Options& options, const Case& settings, std::string technique,
    int resolution);

  std::string Technique; // empty for none
  std::string CaseText;
  int Resolution;
  rtw::TechniqueView Window;
};

using Views = std::vector<std::unique_ptr<View>>;

/// Times all views frame by frame in turn, so that what disturbs the machine disturbs them alike.
std::vector<Times> TakeTimes(Views& views, const Options& options);

#endif
