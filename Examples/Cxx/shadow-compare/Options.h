// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "rtwScene.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A command line that cannot be obeyed. The message is one line.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct ViewOption
{
  glm::dvec3 Position, Focal;
  double Angle;
};

enum class Filter
{
  NEAREST,
  BILINEAR
};

enum class DepthTest
{
  DUAL,
  RECEIVER_PLANE,
  CONSTANT_BIAS
};

enum class Importance
{
  SQRT_DEMAND,
  PUBLISHED
};

/// What is measured. Settings that are not given stay what the technique has by itself.
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
  std::string JsonFile;
  std::string OutputFolder;
  std::optional<Filter> Filtering;
  std::optional<DepthTest> Test;
  std::optional<bool> Focus;
  std::optional<Importance> ImportanceKind;
  bool Stages = false;
  bool Help = false;
};

/// Throws UsageError.
Options ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
