// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "rtwCommandLine.h"
#include "rtwScene.h"
#include "rtwTechnique.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What is compared beside Options::Techniques, each with settings of its own.
struct Case
{
  std::string Text; // as the command line has it
  std::vector<std::string> Techniques;
  std::vector<int> Resolutions;
  rtw::TechniqueSettings Settings;
};

struct ViewOption
{
  glm::dvec3 Position, Focal;
  double Angle;
};

/// What is measured.
struct Options
{
  std::string Scene = "town"; // a name or a file
  double Scale = 1;
  std::vector<std::string> Techniques{ "vtk", "uniform", "rtw" };
  std::vector<int> Resolutions{ 1024 };
  std::optional<std::pair<int, int>> Size;
  std::optional<rtw::SceneLight> Light;
  std::optional<ViewOption> Camera;
  int Frames = 10;
  int Pieces = 1;
  bool SharpRays = false; // as in rtw::ReferenceOptions
  std::string JsonFile;
  std::string OutputFolder;
  std::vector<std::string> DebugViews; // as the command line has them
  rtw::TechniqueSettings Settings; // but for the resolution
  std::vector<Case> Cases;
};

/// None where only the help was asked for, which is printed then. Throws rtw::UsageError.
std::optional<Options> ParseOptions(int argc, char* argv[]);

/// Of one of DebugViews.
rtw::DebugPicture ToDebugPicture(const std::string& name);

#endif
