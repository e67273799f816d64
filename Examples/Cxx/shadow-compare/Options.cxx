// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <CLI/CLI.hpp>

#include <glm/glm.hpp>

namespace
{
void ReadLight(const std::string& text, Options& options)
{
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string values = colon == std::string::npos ? "" : text.substr(colon + 1);
  const std::vector<double> sun = rtw::ToNumbers(values, 3), spot = rtw::ToNumbers(values, 7);
  rtw::SceneLight light;
  if (kind == "sun" && !sun.empty())
  {
    light.Direction = { sun[0], sun[1], sun[2] };
  }
  else if (kind == "spot" && !spot.empty() && spot[6] > 0 && spot[6] <= 180)
  {
    light.IsSpot = true;
    light.Position = { spot[0], spot[1], spot[2] };
    light.Direction = glm::dvec3(spot[3], spot[4], spot[5]) - light.Position;
    light.Cone = spot[6];
  }
  else
  {
    rtw::Refuse(
      "--light", text, "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE with CONE from 0 to 180");
  }
  if (!(glm::length(light.Direction) > 0))
  {
    rtw::Refuse("--light", text, "a direction that is longer than zero");
  }
  light.Direction = glm::normalize(light.Direction);
  options.Light = light;
}

void ReadCamera(const std::string& text, Options& options)
{
  const std::vector<double> n = rtw::ToNumbers(text, 7);
  if (n.empty() || !(n[6] > 0 && n[6] < 180))
  {
    rtw::Refuse("--camera", text, "PX,PY,PZ,FX,FY,FZ,ANGLE with ANGLE between 0 and 180");
  }
  options.Camera = { { n[0], n[1], n[2] }, { n[3], n[4], n[5] }, n[6] };
  if (options.Camera->Position == options.Camera->Focal)
  {
    rtw::Refuse("--camera", text, "a focal point that is not the position");
  }
}

void AddSettings(CLI::App& app, rtw::TechniqueSettings& settings)
{
  for (const rtw::Setting& setting : rtw::AllSettings())
  {
    rtw::AddOption(app, "--" + setting.Name, setting.Value, setting.Help,
      [&settings, name = setting.Name](const std::string& value) { settings.Set(name, value); });
  }
}

void AddTechniques(
  CLI::App& app, std::vector<std::string>& techniques, std::vector<int>& resolutions)
{
  rtw::AddOption(app, "--technique", "NAME,...", "techniques to compare; default vtk,uniform,rtw",
    [&](const std::string& value) {
      techniques = rtw::ReadNames("--technique", value, rtw::TechniqueNames());
    });
  rtw::AddOption(app, "--resolution", "N,...", "texels a side of a shadow map; default 1024",
    [&](const std::string& value) {
      resolutions = rtw::ReadWholes("--resolution", value, 16, 16384);
    });
}

// Options between blanks.
Case ReadCase(const std::string& text)
{
  const Options defaults;
  Case read{ text, defaults.Techniques, defaults.Resolutions, {} };
  std::vector<std::string> words;
  for (const std::string& word : rtw::Split(text, ' '))
  {
    if (!word.empty())
    {
      words.push_back(word);
    }
  }
  CLI::App app;
  AddTechniques(app, read.Techniques, read.Resolutions);
  AddSettings(app, read.Settings);
  rtw::ParseCommandLine(
    app, words, [](const std::string& word) { rtw::Refuse("--case", word, "options only"); });
  return read;
}

void ReadDebugViews(const std::string& text, Options& options)
{
  options.DebugViews = rtw::Split(text, ',');
  for (const std::string& name : options.DebugViews)
  {
    ToDebugPicture(name);
  }
}

void AddScene(CLI::App& app, Options& options)
{
  using namespace rtw;
  AddOption(app, "--size", "WxH", "of the picture in pixels; default the scene's, 1024x1024",
    [&](const std::string& value) { options.Size = ReadSize("--size", value); });
  AddOption(app, "--light", "LIGHT",
    "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE (half angle); 90 and more is a point light",
    [&](const std::string& value) { ReadLight(value, options); });
  AddOption(app, "--camera", "CAMERA",
    "PX,PY,PZ,FX,FY,FZ,ANGLE: position, focal point, vertical angle",
    [&](const std::string& value) { ReadCamera(value, options); });
  AddOption(app, "--scale", "S", "times the triangles of town, playground and terrain",
    [&](const std::string& value) { options.Scale = ReadNumber("--scale", value, 0.01, 100); });
  AddOption(app, "--pieces", "N", "actors that the mesh is split into; default 1",
    [&](const std::string& value) { options.Pieces = ReadWhole("--pieces", value, 1, 100000); });
  AddOption(app, "--sharp-rays", "on|off",
    "whether exact rays start at the surface itself, not a little off it; default off",
    [&](const std::string& value) {
      options.SharpRays =
        Choose<bool>("--sharp-rays", value, { { "on", true }, { "off", false } });
    });
  AddOption(app, "--frames", "N", "that are timed, of each kind; default 10",
    [&](const std::string& value) { options.Frames = ReadWhole("--frames", value, 1, 100000); });
}

void AddOutput(CLI::App& app, Options& options)
{
  using namespace rtw;
  AddFlag(app, "--stages", options.Settings.Stages, "time the stages on the GPU");
  AddOption(app, "--out", "DIR", "write pictures, masks and differences there",
    [&](const std::string& value) { options.OutputFolder = value; });
  AddOption(app, "--debug-view", "V,...",
    "write to --out what maps look like inside: shadow, aliasing, importance, grid, layers; of "
    "exact lists",
    [&](const std::string& value) { ReadDebugViews(value, options); });
  AddOption(app, "--json", "FILE", "write the numbers there",
    [&](const std::string& value) { options.JsonFile = value; });
}

std::string Description()
{
  return "Renders a scene with shadows by each technique, without a display, compares every pixel\n"
         "with an exact shadow ray, and takes the time.\n\nSCENE is one of " +
    rtw::Join(rtw::SceneNames()) +
    ",\nor a file: .obj, .ply, .stl, .vtp, .glb, .gltf. Default: town.\n";
}

std::string Techniques()
{
  std::string text = "Techniques:\n";
  for (const std::string& name : rtw::TechniqueNames())
  {
    text += rtw::HelpLine(name, rtw::TechniqueDescription(name));
  }
  return text;
}
}

rtw::DebugPicture ToDebugPicture(const std::string& name)
{
  using rtw::DebugPicture;
  return rtw::Choose<DebugPicture>("--debug-view", name,
    { { "shadow", DebugPicture::SHADOW }, { "aliasing", DebugPicture::ALIASING_ERROR },
      { "importance", DebugPicture::IMPORTANCE }, { "grid", DebugPicture::WARP_GRID },
      { "layers", DebugPicture::LAYERS }, { "lists", DebugPicture::LIST_LENGTHS } });
}

std::optional<Options> ParseOptions(int argc, char* argv[])
{
  Options options;
  CLI::App app(Description(), "shadow-compare [SCENE]");
  AddTechniques(app, options.Techniques, options.Resolutions);
  app
    .add_option_function<std::vector<std::string>>(
      "--case",
      [&](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
        {
          options.Cases.push_back(ReadCase(text));
        }
      },
      "compare also what these options give: techniques, resolutions and their settings, as "
      "'--technique cascades --layers 2 --resolution 512'; any number of times")
    ->type_name("'O ...'")
    ->allow_extra_args(false);
  AddScene(app, options);
  AddSettings(app, options.Settings);
  AddOutput(app, options);
  app.footer(Techniques());
  bool hasScene = false;
  const bool runs = rtw::ParseCommandLine(app, argc, argv, [&](const std::string& argument) {
    if (hasScene)
    {
      throw rtw::UsageError(argument + ": one scene only; " + options.Scene + " is given already");
    }
    options.Scene = argument;
    hasScene = true;
  });
  for (Case& each : options.Cases)
  {
    each.Settings.Stages = options.Settings.Stages;
  }
  return runs ? std::make_optional(options) : std::nullopt;
}
