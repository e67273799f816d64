// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Faults.h"
#include "Setup.h"
#include "SetupScene.h"

#include "rtwTechnique.h"

#include <CLI/CLI.hpp>

#include <regex>

namespace
{
void ReadFilter(const std::string& value, Options& options)
{
  try
  {
    const std::regex tried(value);
    options.Filter = value;
  }
  catch (const std::regex_error&)
  {
    rtw::Refuse("--benchmark_filter", value, "a regular expression");
  }
}

void AddChoice(CLI::App& app, Options& options)
{
  using namespace rtw;
  AddFlag(app, "--quick", options.Quick, "a small choice of all, in less than three minutes");
  AddOption(app, "--family", "NAME,...",
    "of measurements, see below; default those that need not be named",
    [&](const std::string& value) {
      options.Families = ReadNames("--family", value, FamilyNames());
    });
  AddOption(app, "--scene", "NAME,...",
    "of maps and the families that run when named; default their own",
    [&](const std::string& value) {
      options.Scenes = ReadNames("--scene", value, SetupSceneNames());
    });
  AddOption(app, "--technique", "NAME,...",
    "besides VTK's own; default uniform and rtw; notw, perspective, cascades and exact take part "
    "where they are named",
    [&](const std::string& value) {
      options.Techniques = ReadNames("--technique", value, TechniqueNames());
    });
  AddOption(app, "--resolution", "N,...",
    "of the same, but for claims, texels a side; default 256 to 4096 of maps, 2048 of paper, else "
    "1024",
    [&](const std::string& value) {
      options.Resolutions = ReadWholes("--resolution", value, 16, 16384);
    });
  AddOption(app, "--size", "WxH", "of the picture in pixels; default 512x512, quick 256x256",
    [&](const std::string& value) { options.Size = ReadSize("--size", value); });
  AddOption(app, "--triangles", "N",
    "of a scene, about, where the family has no number; default the scene's own, quick 20000",
    [&](const std::string& value) {
      options.Triangles = ReadWhole("--triangles", value, 1, 10000000);
    });
}

void AddEffort(CLI::App& app, Options& options)
{
  using namespace rtw;
  AddOption(app, "--minutes", "M",
    "to take in all, where what is least takes no longer; default 9, quick 2.4, and 3, quick 0.8, "
    "for each family that runs when named",
    [&](const std::string& value) {
      options.Minutes = ReadNumber("--minutes", value, 0.01, 10000);
    });
  AddOption(app, "--frames", "N",
    "places along the path at most, those of --error-views among them; default 60",
    [&](const std::string& value) { options.Frames = ReadWhole("--frames", value, 1, 100000); });
  AddOption(app, "--laps", "N",
    "frames a tiny step apart at each place, which tell noise and flicker; default 3; 2 at most of "
    "paper and functions",
    [&](const std::string& value) { options.Laps = ReadWhole("--laps", value, 1, 1000); });
  AddOption(app, "--error-views", "N", "places on the path, whose pixels are compared; default 2",
    [&](const std::string& value) {
      options.ErrorViews = ReadWhole("--error-views", value, 1, 1000);
    });
  AddOption(app, "--benchmark_filter", "REGEX", "only lines whose name it matches",
    [&](const std::string& value) { ReadFilter(value, options); });
  AddOption(app, "--benchmark_out", "FILE", "write the numbers there, in Google Benchmark's JSON",
    [&](const std::string& value) { options.OutputFile = value; });
  AddFlag(app, "--benchmark_list_tests", options.List, "print the names, measure nothing");
  AddOption(app, "--fault", "NAME", "make rtw wrong or slow on purpose: see below",
    [&](const std::string& value) {
      options.Fault = ReadNames("--fault", value, FaultNames()).front();
    });
}

std::string Footer()
{
  std::string text;
  for (const bool byDefault : { true, false })
  {
    text += byDefault ? "Families:\n" : "\nFamilies that run only when --family names them:\n";
    for (const std::string& name : FamilyNames())
    {
      if (IsByDefault(name) == byDefault)
      {
        text += rtw::HelpLine(name, FamilyDescription(name));
      }
    }
  }
  text += "\nTechniques:\n";
  for (const std::string& name : rtw::TechniqueNames())
  {
    text += rtw::HelpLine(name, rtw::TechniqueDescription(name));
  }
  text += "\nFaults, to see whether they are noticed:\n";
  for (const std::string& name : FaultNames())
  {
    text += rtw::HelpLine(name, FaultDescription(name));
  }
  return text;
}
}

std::optional<Options> ParseOptions(int argc, char* argv[])
{
  Options options;
  CLI::App app(
    "Measures shadow techniques, without a display: time, memory, and pixels whose shadow is\n"
    "not that of an exact ray. VTK's own pass is measured beside each of them, frame by frame\n"
    "in turn, with new maps for each frame (vtk) and as it does it by itself (vtk-kept).\n",
    "shadow-benchmark");
  AddChoice(app, options);
  AddEffort(app, options);
  app.footer(Footer());
  const bool runs = rtw::ParseCommandLine(app, argc, argv, [](const std::string& argument) {
    throw rtw::UsageError(argument + ": only options are expected; --help tells all");
  });
  if (options.Size.first == 0)
  {
    options.Size = options.Quick ? std::make_pair(256, 256) : std::make_pair(512, 512);
  }
  if (options.Triangles == 0 && options.Quick)
  {
    options.Triangles = 20000;
  }
  if (options.Minutes == 0)
  {
    options.Minutes = DefaultMinutes(options.Families, options.Quick);
  }
  return runs ? std::make_optional(options) : std::nullopt;
}
