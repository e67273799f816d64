// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Faults.h"
#include "Setup.h"
#include "SetupScene.h"

#include "rtwTechnique.h"

#include <regex>
#include <sstream>

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

std::vector<rtw::CommandLineOption> Entries(Options& options)
{
  using namespace rtw;
  return {
    { "--quick", "", "a small choice of all, in less than three minutes",
      [&](const std::string&) { options.Quick = true; } },
    { "--family", "NAME,...", "of measurements, see below; default those that need not be named",
      [&](const std::string& value) {
        options.Families = ReadNames("--family", value, FamilyNames());
      } },
    { "--scene", "NAME,...", "of maps and the families that run when named; default their own",
      [&](const std::string& value) {
        options.Scenes = ReadNames("--scene", value, SetupSceneNames());
      } },
    { "--technique", "NAME,...",
      "besides VTK's own; default uniform and rtw; notw,\n"
      "perspective, cascades and exact take part where they are named",
      [&](const std::string& value) {
        options.Techniques = ReadNames("--technique", value, TechniqueNames());
      } },
    { "--resolution", "N,...",
      "of the same, but for claims, texels a side; default 256 to 4096 of maps,\n"
      "2048 of paper, else 1024",
      [&](const std::string& value) {
        options.Resolutions = ReadWholes("--resolution", value, 16, 16384);
      } },
    { "--size", "WxH", "of the picture in pixels; default 512x512, quick 256x256",
      [&](const std::string& value) { options.Size = ReadSize("--size", value); } },
    { "--triangles", "N",
      "of a scene, about, where the family has no number; default the scene's own,\n"
      "quick 20000",
      [&](const std::string& value) {
        options.Triangles = ReadWhole("--triangles", value, 1, 10000000);
      } },
    { "--minutes", "M",
      "to take in all, where what is least takes no longer; default 9, quick 2.4,\n"
      "and 3, quick 0.8, for each family that runs when named",
      [&](const std::string& value) {
        options.Minutes = ReadNumber("--minutes", value, 0.01, 10000);
      } },
    { "--frames", "N",
      "places along the path at most, those of --error-views among them; default 60",
      [&](const std::string& value) { options.Frames = ReadWhole("--frames", value, 1, 100000); } },
    { "--laps", "N",
      "frames a tiny step apart at each place, which tell noise and flicker; default 3;\n"
      "2 at most of paper and functions",
      [&](const std::string& value) { options.Laps = ReadWhole("--laps", value, 1, 1000); } },
    { "--error-views", "N", "places on the path, whose pixels are compared; default 2",
      [&](const std::string& value) {
        options.ErrorViews = ReadWhole("--error-views", value, 1, 1000);
      } },
    { "--benchmark_filter", "REGEX", "only lines whose name it matches",
      [&](const std::string& value) { ReadFilter(value, options); } },
    { "--benchmark_out", "FILE", "write the numbers there, in Google Benchmark's JSON",
      [&](const std::string& value) { options.OutputFile = value; } },
    { "--benchmark_list_tests", "", "print the names, measure nothing",
      [&](const std::string&) { options.List = true; } },
    { "--fault", "NAME", "make rtw wrong or slow on purpose: see below",
      [&](const std::string& value) {
        options.Fault = ReadNames("--fault", value, FaultNames()).front();
      } },
    { "--help", "", "print this", [&](const std::string&) { options.Help = true; } },
  };
}
}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  rtw::ParseCommandLine(argc, argv, Entries(options), [](const std::string& argument) {
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
  return options;
}

std::string HelpText()
{
  Options options;
  std::ostringstream text;
  text
    << "shadow-benchmark [OPTION ...]\n\n"
       "Measures shadow techniques, without a display: time, memory, and pixels whose shadow is\n"
       "not that of an exact ray. VTK's own pass is measured beside each of them, frame by frame\n"
       "in turn, with new maps for each frame (vtk) and as it does it by itself (vtk-kept).\n\n"
    << rtw::OptionsHelp(Entries(options));
  for (const bool byDefault : { true, false })
  {
    text << (byDefault ? "\nFamilies:\n" : "\nFamilies that run only when --family names them:\n");
    for (const std::string& name : FamilyNames())
    {
      if (IsByDefault(name) == byDefault)
      {
        text << rtw::HelpLine("  " + name, FamilyDescription(name));
      }
    }
  }
  text << "\nTechniques:\n";
  for (const std::string& name : rtw::TechniqueNames())
  {
    text << rtw::HelpLine("  " + name, rtw::TechniqueDescription(name));
  }
  text << "\nFaults, to see whether they are noticed:\n";
  for (const std::string& name : FaultNames())
  {
    text << rtw::HelpLine("  " + name, FaultDescription(name));
  }
  return text.str();
}
