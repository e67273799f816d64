// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "rtwTechniqueNames.h"

#include <glm/glm.hpp>

#include <sstream>

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

void ReadInterest(const std::string& text, rtw::TechniqueSettings& settings)
{
  const std::vector<double> n = rtw::ToNumbers(text, 4);
  if (n.empty() || !(n[3] > 0))
  {
    rtw::Refuse("--interest", text, "X,Y,Z,R with R above 0");
  }
  settings.Interest = { n[0], n[1], n[2], n[3] };
}

std::vector<rtw::CommandLineOption> Entries(Options& options);

// Options between blanks.
Case ReadCase(const std::string& text)
{
  Options options;
  std::vector<std::string> words{ "--case" };
  for (const std::string& word : rtw::Split(text, ' '))
  {
    if (!word.empty())
    {
      words.push_back(word);
    }
  }
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  rtw::ParseCommandLine(static_cast<int>(arguments.size()), arguments.data(), Entries(options),
    [&](const std::string& word) { rtw::Refuse("--case", word, "options only"); });
  return { text, options.Techniques, options.Resolutions, options.Settings };
}

void ReadDebugViews(const std::string& text, Options& options)
{
  options.DebugViews = rtw::Split(text, ',');
  for (const std::string& name : options.DebugViews)
  {
    ToDebugPicture(name);
  }
}

std::vector<rtw::CommandLineOption> Entries(Options& options)
{
  using namespace rtw;
  TechniqueSettings& settings = options.Settings;
  return {
    { "--technique", "NAME,...", "techniques to compare; default vtk,uniform,rtw",
      [&](const std::string& value) {
        options.Techniques = ReadNames("--technique", value, TechniqueNames());
      } },
    { "--resolution", "N,...", "texels a side of a shadow map; default 1024",
      [&](const std::string& value) {
        options.Resolutions = ReadWholes("--resolution", value, 16, 16384);
      } },
    { "--case", "'O ...'",
      "compare also what these options give: techniques, resolutions and their settings,\n"
      "as '--technique cascades --layers 2 --resolution 512'; any number of times",
      [&](const std::string& value) { options.Cases.push_back(ReadCase(value)); } },
    { "--size", "WxH", "of the picture in pixels; default the scene's, 1024x1024",
      [&](const std::string& value) { options.Size = ReadSize("--size", value); } },
    { "--light", "LIGHT",
      "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE (half angle); 90 and\n"
      "more is a point light",
      [&](const std::string& value) { ReadLight(value, options); } },
    { "--camera", "CAMERA", "PX,PY,PZ,FX,FY,FZ,ANGLE: position, focal point, vertical angle",
      [&](const std::string& value) { ReadCamera(value, options); } },
    { "--scale", "S", "times the triangles of town, playground and terrain",
      [&](const std::string& value) { options.Scale = ReadNumber("--scale", value, 0.01, 100); } },
    { "--pieces", "N", "actors that the mesh is split into; default 1",
      [&](const std::string& value) { options.Pieces = ReadWhole("--pieces", value, 1, 100000); } },
    { "--sharp-rays", "on|off",
      "whether exact rays start at the surface itself, not a little off it; default off",
      [&](const std::string& value) {
        options.SharpRays =
          Choose<bool>("--sharp-rays", value, { { "on", true }, { "off", false } });
      } },
    { "--frames", "N", "that are timed, of each kind; default 10",
      [&](const std::string& value) { options.Frames = ReadWhole("--frames", value, 1, 100000); } },
    { "--filter", "F", "nearest, bilinear, pcf or soft",
      [&](const std::string& value) {
        settings.Filtering = Choose("--filter", value, FilterNames());
      } },
    { "--filter-radius", "R", "texels of pcf, 0 to 8; world units of soft; default 2",
      [&](const std::string& value) {
        settings.FilterRadius = ReadNumber("--filter-radius", value, 0, 1e30);
      } },
    { "--filter-jitter", "on|off", "whether pcf and soft displace their taps from pixel to pixel",
      [&](const std::string& value) {
        settings.FilterJitter =
          Choose<bool>("--filter-jitter", value, { { "on", true }, { "off", false } });
      } },
    { "--rasterization", "R", "linear, tessellated, exact or automatic",
      [&](const std::string& value) {
        settings.Rasterizing = Choose("--rasterization", value, RasterizationNames());
      } },
    { "--edge-length", "L", "of tessellated triangles at most, of the map's side; default 0.025",
      [&](const std::string& value) {
        settings.EdgeLength = ReadNumber("--edge-length", value, 0.001, 1);
      } },
    { "--light-plane-turn", "T", "off, view-aligned, automatic or minimal-frustum",
      [&](const std::string& value) {
        settings.Turn = Choose("--light-plane-turn", value, LightPlaneTurnNames());
      } },
    { "--view-samples", "S", "prepass or previous-frame",
      [&](const std::string& value) {
        settings.Samples = Choose("--view-samples", value, SampleSourceNames());
      } },
    { "--sample-stride", "N",
      "pixels a side of a square that gives a view sample, 1 to 64; default 2",
      [&](const std::string& value) {
        settings.SampleStride = ReadWhole("--sample-stride", value, 1, 64);
      } },
    { "--cull-casters", "on|off", "whether what can shadow nothing in a layer is left out of it",
      [&](const std::string& value) {
        settings.CullCasters =
          Choose<bool>("--cull-casters", value, { { "on", true }, { "off", false } });
      } },
    { "--depth-test", "T", "dual, receiver-plane or constant-bias",
      [&](const std::string& value) {
        settings.Test = Choose("--depth-test", value, DepthTestNames());
      } },
    { "--focus", "on|off", "whether maps are fitted to what the camera sees",
      [&](const std::string& value) {
        settings.Focus = Choose<bool>("--focus", value, { { "on", true }, { "off", false } });
      } },
    { "--importance", "I+...",
      "of rtw, multiplied: desired-view, distance, normal, sqrt-demand, edges,\n"
      "interest, user, footprint, count; published stands for the first three",
      [&](const std::string& value) {
        settings.ImportanceKinds = ReadImportance("--importance", value);
      } },
    { "--analysis", "A", "of rtw: forward, backward or hybrid",
      [&](const std::string& value) {
        settings.AnalysisKind = Choose("--analysis", value, AnalysisNames());
      } },
    { "--light-image", "N", "texels a side of the depth image of a forward or hybrid analysis",
      [&](const std::string& value) {
        settings.LightImage = ReadWhole("--light-image", value, 16, 8192);
      } },
    { "--edge-threshold", "S", "least step of depth at an edge, as a share of the scene's diagonal",
      [&](const std::string& value) {
        settings.EdgeThreshold = ReadNumber("--edge-threshold", value, 0, 1);
      } },
    { "--interest", "X,Y,Z,R",
      "centre and radius of the sphere of interest; default the view's centre",
      [&](const std::string& value) { ReadInterest(value, settings); } },
    { "--user-function", "GLSL", "the user's own importance function",
      [&](const std::string& value) { settings.UserFunction = value; } },
    { "--cull-empty-cells", "on|off",
      "whether rtw gives columns and rows in which nothing is seen next to no texels",
      [&](const std::string& value) {
        settings.CullEmptyCells =
          Choose<bool>("--cull-empty-cells", value, { { "on", true }, { "off", false } });
      } },
    { "--blending", "B", "share of the last frame's warping functions that rtw keeps, 0 to 0.99",
      [&](const std::string& value) {
        settings.TemporalBlending = ReadNumber("--blending", value, 0, 0.99);
      } },
    { "--grid", "W", "of exact: the warp of its grid, identity, rectilinear or non-orthogonal",
      [&](const std::string& value) {
        settings.Grid = Choose<GridWarp>("--grid", value,
          { { "identity", GridWarp::IDENTITY }, { "rectilinear", GridWarp::RECTILINEAR },
            { "non-orthogonal", GridWarp::NON_ORTHOGONAL } });
      } },
    { "--pixel-samples", "N", "of exact: points of a pixel that are tested, 1, 4 or 8; default 1",
      [&](const std::string& value) {
        settings.PixelSamples =
          Choose<int>("--pixel-samples", value, { { "1", 1 }, { "4", 4 }, { "8", 8 } });
      } },
    { "--snapping", "on|off", "whether rtw keeps texels in place while the camera moves a little",
      [&](const std::string& value) {
        settings.Snapping = Choose<bool>("--snapping", value, { { "on", true }, { "off", false } });
      } },
    { "--smoothing", "S",
      "of notw: how far neighbouring lines are averaged, a share of the focus, 0 to 1;\n"
      "default: chosen by what least error is predicted for",
      [&](const std::string& value) {
        settings.Smoothing = ReadNumber("--smoothing", value, 0, 1);
      } },
    { "--cells", "N", "a side of the grid of notw, 64 to 2048; default 512",
      [&](const std::string& value) { settings.Cells = ReadWhole("--cells", value, 64, 2048); } },
    { "--perspective", "P",
      "of perspective, and of cascades warped so: psm, lispsm, tsm, none, or n' itself in world "
      "units; default lispsm",
      [&](const std::string& value) { ReadPerspective("--perspective", value, settings); } },
    { "--eta", "E", "likewise, instead: -1, no warp, over 0, LiSPSM, to 1, PSM",
      [&](const std::string& value) { settings.Eta = ReadNumber("--eta", value, -1, 1); } },
    { "--resolution-split", "S",
      "of perspective, between s and t: square, critical (Lloyd et al. 2006, equations 13, 14), "
      "automatic (least predicted error) or texels along s over those along t",
      [&](
        const std::string& value) { ReadResolutionSplit("--resolution-split", value, settings); } },
    { "--focus-point", "F",
      "of tsm, what 80 % of the map lie before, 0.001 to 1 of what is seen; default 0.1",
      [&](const std::string& value) {
        settings.FocusPoint = ReadNumber("--focus-point", value, 0.001, 1);
      } },
    { "--layers", "N", "of cascades, 1 to 8; default 4",
      [&](const std::string& value) { settings.Layers = ReadWhole("--layers", value, 1, 8); } },
    { "--splits", "S", "of cascades: uniform, logarithmic, practical or sample-distribution",
      [&](const std::string& value) {
        settings.Splitting = Choose("--splits", value, SplitsNames());
      } },
    { "--lambda", "L", "of practical splits, from 0, uniform, to 1, logarithmic; default 0.5",
      [&](const std::string& value) { settings.Lambda = ReadNumber("--lambda", value, 0, 1); } },
    { "--blend-width", "B", "of the band where a cascade gives way to the next, of its depths",
      [&](const std::string& value) {
        settings.BlendWidth = ReadNumber("--blend-width", value, 0, 1);
      } },
    { "--faces", "on|off", "whether cascades are divided among the sides of the view frustum",
      [&](const std::string& value) {
        settings.SplitFaces = Choose<bool>("--faces", value, { { "on", true }, { "off", false } });
      } },
    { "--stable", "on|off", "whether cascades keep texels in place while the camera moves",
      [&](const std::string& value) {
        settings.Stable = Choose<bool>("--stable", value, { { "on", true }, { "off", false } });
      } },
    { "--warp", "W", "of each cascade: identity, perspective, rtw or notw",
      [&](const std::string& value) {
        settings.Warping = Choose("--warp", value, LayerWarpNames());
      } },
    { "--stages", "", "print the milliseconds of each stage on the GPU",
      [&](const std::string&) { settings.Stages = true; } },
    { "--out", "DIR", "write pictures, masks and differences there",
      [&](const std::string& value) { options.OutputFolder = value; } },
    { "--debug-view", "V,...",
      "write to --out what maps look like inside: shadow, aliasing, importance,\n"
      "grid, layers; of exact lists",
      [&](const std::string& value) { ReadDebugViews(value, options); } },
    { "--json", "FILE", "write the numbers there",
      [&](const std::string& value) { options.JsonFile = value; } },
    { "--help", "", "print this", [&](const std::string&) { options.Help = true; } },
  };
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

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  bool hasScene = false;
  rtw::ParseCommandLine(argc, argv, Entries(options), [&](const std::string& argument) {
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
  return options;
}

std::string HelpText()
{
  Options options;
  std::ostringstream text;
  text
    << "shadow-compare [SCENE] [OPTION ...]\n\n"
       "Renders a scene with shadows by each technique, without a display, compares every pixel\n"
       "with an exact shadow ray, and takes the time.\n\n"
       "SCENE is one of "
    << rtw::Join(rtw::SceneNames())
    << ",\nor a file: .obj, .ply, .stl, .vtp, .glb, .gltf. Default: town.\n\n"
    << rtw::OptionsHelp(Entries(options)) << "\nTechniques:\n";
  for (const std::string& name : rtw::TechniqueNames())
  {
    text << rtw::HelpLine("  " + name, rtw::TechniqueDescription(name));
  }
  return text.str();
}
