// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Techniques.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace
{
[[noreturn]] void Refuse(
  const std::string& option, const std::string& value, const std::string& expected)
{
  throw UsageError(option + " " + value + ": expected " + expected);
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

std::optional<double> ToNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isAll = !text.empty() && *end == '\0' && std::isfinite(value);
  return isAll ? std::optional<double>(value) : std::nullopt;
}

std::optional<int> ToWhole(const std::string& text, int least, int most)
{
  const std::optional<double> value = ToNumber(text);
  const bool fits = value && *value >= least && *value <= most && *value == std::floor(*value);
  return fits ? std::optional<int>(int(*value)) : std::nullopt;
}

int ReadWhole(const std::string& option, const std::string& text, int least, int most)
{
  const std::optional<int> value = ToWhole(text, least, most);
  if (!value)
  {
    Refuse(
      option, text, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *value;
}

// `count` numbers between commas; empty if they are not that.
std::vector<double> Numbers(const std::string& text, size_t count)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(text, ','))
  {
    const std::optional<double> number = ToNumber(part);
    if (!number)
    {
      return {};
    }
    numbers.push_back(*number);
  }
  return numbers.size() == count ? numbers : std::vector<double>();
}

std::string Join(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

template <class Value>
Value Choose(const std::string& option, const std::string& text,
  const std::vector<std::pair<std::string, Value>>& choices)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : choices)
  {
    if (name == text)
    {
      return value;
    }
    names.push_back(name);
  }
  Refuse(option, text, "one of " + Join(names));
}

void ReadTechniques(const std::string& text, Options& options)
{
  options.Techniques.clear();
  const std::vector<std::string> known = TechniqueNames();
  for (const std::string& name : Split(text, ','))
  {
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      Refuse("--technique", text, "some of " + Join(known));
    }
    options.Techniques.push_back(name);
  }
}

void ReadResolutions(const std::string& text, Options& options)
{
  options.Resolutions.clear();
  for (const std::string& part : Split(text, ','))
  {
    options.Resolutions.push_back(ReadWhole("--resolution", part, 16, 16384));
  }
}

void ReadSize(const std::string& text, Options& options)
{
  const std::vector<std::string> parts = Split(text, 'x');
  const auto width = ToWhole(parts.front(), 16, 16384), height = ToWhole(parts.back(), 16, 16384);
  if (parts.size() != 2 || !width || !height)
  {
    Refuse("--size", text, "WIDTHxHEIGHT, each from 16 to 16384");
  }
  options.Size = { *width, *height };
}

void ReadLight(const std::string& text, Options& options)
{
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string values = colon == std::string::npos ? "" : text.substr(colon + 1);
  const std::vector<double> sun = Numbers(values, 3), spot = Numbers(values, 7);
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
    Refuse("--light", text, "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE with CONE from 0 to 180");
  }
  if (!(glm::length(light.Direction) > 0))
  {
    Refuse("--light", text, "a direction that is longer than zero");
  }
  light.Direction = glm::normalize(light.Direction);
  options.Light = light;
}

void ReadCamera(const std::string& text, Options& options)
{
  const std::vector<double> n = Numbers(text, 7);
  if (n.empty() || !(n[6] > 0 && n[6] < 180))
  {
    Refuse("--camera", text, "PX,PY,PZ,FX,FY,FZ,ANGLE with ANGLE between 0 and 180");
  }
  options.Camera = { { n[0], n[1], n[2] }, { n[3], n[4], n[5] }, n[6] };
  if (options.Camera->Position == options.Camera->Focal)
  {
    Refuse("--camera", text, "a focal point that is not the position");
  }
}

void ReadScale(const std::string& text, Options& options)
{
  const std::optional<double> scale = ToNumber(text);
  if (!scale || *scale < 0.01 || *scale > 100)
  {
    Refuse("--scale", text, "a number from 0.01 to 100");
  }
  options.Scale = *scale;
}

struct Entry
{
  const char* Name;
  const char* Value; // what follows it; empty if nothing does
  const char* Help;
  void (*Read)(const std::string& value, Options& options);
};

const Entry ENTRIES[] = {
  { "--technique", "NAME,...", "techniques to compare; default vtk,uniform,rtw", ReadTechniques },
  { "--resolution", "N,...", "texels a side of a shadow map; default 1024", ReadResolutions },
  { "--size", "WxH", "of the picture in pixels; default the scene's, 1024x1024", ReadSize },
  { "--light", "LIGHT",
    "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE (half angle); 90 and\n"
    "more is a point light",
    ReadLight },
  { "--camera", "CAMERA", "PX,PY,PZ,FX,FY,FZ,ANGLE: position, focal point, vertical angle",
    ReadCamera },
  { "--scale", "S", "times the triangles of town, playground and terrain", ReadScale },
  { "--pieces", "N", "actors that the mesh is split into; default 1",
    [](const std::string& value, Options& options) {
      options.Pieces = ReadWhole("--pieces", value, 1, 100000);
    } },
  { "--frames", "N", "that are timed, of each kind; default 10",
    [](const std::string& value, Options& options) {
      options.Frames = ReadWhole("--frames", value, 1, 100000);
    } },
  { "--filter", "F", "nearest or bilinear",
    [](const std::string& value, Options& options) {
      options.Filtering = Choose<Filter>(
        "--filter", value, { { "nearest", Filter::NEAREST }, { "bilinear", Filter::BILINEAR } });
    } },
  { "--depth-test", "T", "dual, receiver-plane or constant-bias",
    [](const std::string& value, Options& options) {
      options.Test = Choose<DepthTest>("--depth-test", value,
        { { "dual", DepthTest::DUAL }, { "receiver-plane", DepthTest::RECEIVER_PLANE },
          { "constant-bias", DepthTest::CONSTANT_BIAS } });
    } },
  { "--focus", "on|off", "whether maps are fitted to what the camera sees",
    [](const std::string& value, Options& options) {
      options.Focus = Choose<bool>("--focus", value, { { "on", true }, { "off", false } });
    } },
  { "--importance", "I", "of rtw: sqrt-demand or published",
    [](const std::string& value, Options& options) {
      options.ImportanceKind = Choose<Importance>("--importance", value,
        { { "sqrt-demand", Importance::SQRT_DEMAND }, { "published", Importance::PUBLISHED } });
    } },
  { "--stages", "", "print the milliseconds of each stage on the GPU",
    [](const std::string&, Options& options) { options.Stages = true; } },
  { "--out", "DIR", "write pictures, masks and differences there",
    [](const std::string& value, Options& options) { options.OutputFolder = value; } },
  { "--json", "FILE", "write the numbers there",
    [](const std::string& value, Options& options) { options.JsonFile = value; } },
  { "--help", "", "print this", [](const std::string&, Options& options) { options.Help = true; } },
};

const Entry& Find(const std::string& name)
{
  for (const Entry& entry : ENTRIES)
  {
    if (name == entry.Name)
    {
      return entry;
    }
  }
  throw UsageError(name + ": there is no such option; --help tells all");
}
}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  bool hasScene = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.empty() || argument[0] != '-')
    {
      if (hasScene)
      {
        throw UsageError(argument + ": one scene only; " + options.Scene + " is given already");
      }
      options.Scene = argument;
      hasScene = true;
      continue;
    }
    const size_t equals = argument.find('=');
    const Entry& entry = Find(argument.substr(0, equals));
    const bool needsValue = entry.Value[0] != '\0';
    if (!needsValue && equals != std::string::npos)
    {
      throw UsageError(std::string(entry.Name) + ": no value belongs to it");
    }
    std::string value = equals == std::string::npos ? "" : argument.substr(equals + 1);
    if (needsValue && equals == std::string::npos && i + 1 < argc)
    {
      value = argv[++i];
    }
    if (needsValue && value.empty())
    {
      throw UsageError(std::string(entry.Name) + ": " + entry.Value + " is missing");
    }
    entry.Read(value, options);
  }
  return options;
}

std::string HelpText()
{
  std::ostringstream text;
  text
    << "shadow-compare [SCENE] [OPTION ...]\n\n"
       "Renders a scene with shadows by each technique, without a display, compares every pixel\n"
       "with an exact shadow ray, and takes the time.\n\n"
       "SCENE is one of "
    << Join(rtw::SceneNames())
    << ",\nor a file: .obj, .ply, .stl, .vtp, .glb, .gltf. Default: town.\n\n";
  const auto pad = [](std::string column) { return column + std::string(24 - column.size(), ' '); };
  for (const Entry& entry : ENTRIES)
  {
    std::string left = std::string("  ") + entry.Name + " " + entry.Value;
    for (const std::string& line : Split(entry.Help, '\n'))
    {
      text << pad(left) << line << "\n";
      left.clear();
    }
  }
  text << "\nTechniques:\n";
  for (const std::string& name : TechniqueNames())
  {
    text << pad("  " + name) << TechniqueDescription(name) << "\n";
  }
  return text.str();
}
