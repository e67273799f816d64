// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "rtwCommandLine.h"

#include <CLI/CLI.hpp>

#include <glm/glm.hpp>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace
{
struct Options
{
  rtw::StoredView View;
  int Partitions = 4;
  std::optional<int> Figure;
  std::optional<glm::dvec3> Light;
};

glm::dvec3 ReadLight(const std::string& text)
{
  if (text == "overhead")
  {
    return { 0, -1, 0 };
  }
  if (text == "behind")
  {
    return { 0, 0, -1 };
  }
  const std::vector<double> n = rtw::ToNumbers(text, 3);
  if (n.empty() || !(glm::length(glm::dvec3(n[0], n[1], n[2])) > 0))
  {
    rtw::Refuse("--light", text, "overhead, behind, or DX,DY,DZ that is longer than zero");
  }
  return { n[0], n[1], n[2] };
}

void AddOptions(CLI::App& app, Options& options)
{
  using namespace rtw;
  AddOption(app, "--near", "N", "distance of the view's near plane; default 1",
    [&](const std::string& value) { options.View.Near = ReadNumber("--near", value, 1e-6, 1e9); });
  AddOption(app, "--far", "F", "and of the far one; default 1000",
    [&](const std::string& value) { options.View.Far = ReadNumber("--far", value, 1e-6, 1e9); });
  AddOption(app, "--half-angle", "A", "half of the field of view, in degrees; default 30",
    [&](const std::string& value) {
      options.View.HalfAngle = glm::radians(ReadNumber("--half-angle", value, 1, 80));
    });
  AddOption(app, "--partitions", "K", "depth partitions, at most; default 4",
    [&](const std::string& value) {
      options.Partitions = ReadWhole("--partitions", value, 1, 64);
    });
  AddOption(app, "--light", "LIGHT",
    "overhead, behind, or the way that light goes, DX,DY,DZ, in a view along -z with y up; "
    "default: the first two, and the direction that needs most",
    [&](const std::string& value) { options.Light = ReadLight(value); });
  AddOption(app, "--figure", "N",
    "the numbers of a figure of the paper instead: 5, 6, 7, 10, 12 or 13",
    [&](const std::string& value) { options.Figure = ReadWhole("--figure", value, 1, 15); });
}

std::string Run(const Options& options)
{
  if (!(options.View.Far > options.View.Near))
  {
    throw rtw::UsageError("--far: expected more than --near");
  }
  if (options.Figure)
  {
    return FigureText(*options.Figure, options.View);
  }
  return options.Light ? LightText(options.View, options.Partitions, *options.Light)
                       : TableText(options.View, options.Partitions);
}
}

int main(int argc, char* argv[])
{
  return rtw::RunProgram("shadow-storage", [&] {
    Options options;
    CLI::App app(
      "How many times the texels of the image shadow maps of a directional light need, so that\n"
      "none is wider than a pixel (the storage factor: Lloyd et al., Warping and Partitioning\n"
      "for Low Error Shadow Maps, 2006), with partitions by depth (ZP) and faces (FP) and with\n"
      "warping (W), as comma-separated values.\n",
      "shadow-storage");
    AddOptions(app, options);
    const bool runs = rtw::ParseCommandLine(app, argc, argv, [](const std::string& argument) {
      throw rtw::UsageError(argument + ": expected an option; --help tells all");
    });
    if (runs)
    {
      std::fputs(Run(options).c_str(), stdout);
    }
    return 0;
  });
}
