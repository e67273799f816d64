// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "rtwTechniqueNames.h"

#include <algorithm>

namespace
{
using Strings = std::vector<std::string>;

struct Variant
{
  std::string Name;
  rtw::TechniqueSettings Settings;
};

// Whether it takes something of the last frame: its samples, or, at shadow edges, its mask.
bool LooksBack(const rtw::TechniqueSettings& settings)
{
  const auto& kinds = settings.ImportanceKinds;
  return settings.Samples == rtw::SampleSource::PREVIOUS_FRAME ||
    std::find(kinds.begin(), kinds.end(), rtw::Importance::SHADOW_EDGE) != kinds.end();
}

// Yardsticks, and variants of rtw.
std::vector<Contestant> Beside(const std::vector<Variant>& variants)
{
  std::vector<Contestant> who = Yardsticks();
  for (const Variant& variant : variants)
  {
    who.push_back({ "rtw", false, "", variant.Name, variant.Settings });
    who.back().LeadsIn = LooksBack(variant.Settings);
  }
  return who;
}

Contestant WholeScene(const char* variant, std::optional<int> resolution = {})
{
  Contestant uniform = { "uniform", false, "", variant, {}, resolution };
  uniform.Settings.Focus = false;
  return uniform;
}

// On each scene with each resolution.
Setups Grid(const char* family, const Options& options, const Strings& scenes,
  const std::vector<int>& resolutions, const std::vector<Contestant>& who)
{
  Setups setups;
  for (const std::string& scene : scenes)
  {
    for (const int resolution : resolutions)
    {
      Setup setup = StartSetup(family, options);
      setup.Scene = scene;
      setup.Resolution = resolution;
      setup.Who = who;
      setups.push_back(setup);
    }
  }
  return setups;
}

std::vector<int> Resolutions(const Options& options, int all, int quick)
{
  return Chosen<int>(options, options.Resolutions, { all }, { quick });
}

// All ways to draw edges, tessellated as in the paper's table 3.
std::vector<Variant> Rasterizations(const rtw::TechniqueSettings& settings)
{
  std::vector<Variant> variants;
  for (const auto& [name, rasterization] : rtw::RasterizationNames())
  {
    Variant variant{ name, settings };
    variant.Settings.Rasterizing = rasterization;
    if (rasterization != rtw::Rasterization::TESSELLATED)
    {
      variants.push_back(variant);
      continue;
    }
    for (const auto& [length, percent] : { std::pair(0.05, "5"), { 0.025, "2.5" }, { 0.01, "1" } })
    {
      variant.Name = name + "-" + percent;
      variant.Settings.EdgeLength = length;
      variants.push_back(variant);
    }
  }
  return variants;
}

Variant Function(const std::string& analysis, const std::string& importance)
{
  Variant variant{ analysis + "+" + importance, {} };
  for (const auto& [name, value] : rtw::AnalysisNames())
  {
    if (name == analysis)
    {
      variant.Settings.AnalysisKind = value;
    }
  }
  variant.Settings.ImportanceKinds = rtw::ReadImportance("importance", importance);
  if (importance == "user")
  {
    variant.Settings.UserFunction = "luminance";
  }
  return variant;
}
}

Setups MakePaper(const Options& options)
{
  std::vector<Variant> variants;
  // Edges are known to what looks at a light's image only (section 5.3).
  for (const auto& [analysis, importance] : { std::pair("forward", "published+edges"),
         { "backward", "published" }, { "hybrid", "published+edges" } })
  {
    for (Variant& variant : Rasterizations(Function(analysis, importance).Settings))
    {
      const auto how = *variant.Settings.Rasterizing;
      if (how == rtw::Rasterization::LINEAR || how == rtw::Rasterization::TESSELLATED)
      {
        variant.Name = analysis + ("+" + variant.Name);
        variants.push_back(variant);
      }
    }
  }
  std::vector<Contestant> who = Beside(variants);
  who.insert(who.begin() + std::ptrdiff_t(Yardsticks().size()), WholeScene("conventional"));
  Setups setups = Grid("paper", options,
    Chosen<std::string>(
      options, options.Scenes, { "playground", "sandbox", "town" }, { "sandbox" }),
    Resolutions(options, 2048, 512), who);
  for (Setup& setup : setups)
  {
    setup.Places = 1;
    setup.MostLaps = 2;
  }
  return setups;
}

Setups MakeFunctions(const Options& options)
{
  Strings products = { "published", "published+edges", "sqrt-demand+edges" };
  for (const auto& [name, importance] : rtw::ImportanceNames())
  {
    products.push_back(name);
  }
  std::vector<Variant> variants;
  for (const auto& [analysis, kind] : rtw::AnalysisNames())
  {
    for (const std::string& product : products)
    {
      // Without edges a hybrid analysis is the backward one.
      if (kind != rtw::Analysis::HYBRID || product.find("edges") != std::string::npos)
      {
        variants.push_back(Function(analysis, product));
      }
    }
  }
  std::vector<Contestant> who = Beside(variants);
  who.insert(who.begin() + std::ptrdiff_t(Yardsticks().size()), { "uniform" });
  Setups setups = Grid("functions", options,
    Chosen<std::string>(options, options.Scenes,
      { "town", "sandbox", "furball", "playground", "duel", "robot" }, { "robot" }),
    Resolutions(options, 1024, 256), who);
  for (Setup& setup : setups)
  {
    setup.Places = 1;
    setup.MostLaps = 2;
  }
  return setups;
}

Setups MakeRasterizations(const Options& options)
{
  Setups setups = Grid("rasterizations", options,
    Chosen<std::string>(options, options.Scenes, { "town", "playground", "floor" }, { "floor" }),
    Resolutions(options, 1024, 256), Beside(Rasterizations({})));
  for (Setup& setup : setups)
  {
    setup.Places = 1;
  }
  return setups;
}

Setups MakeFilters(const Options& options)
{
  std::vector<Variant> variants;
  const auto add = [&](const std::string& name, rtw::Filter filter, std::optional<double> radius) {
    rtw::TechniqueSettings settings;
    settings.Filtering = filter;
    settings.FilterRadius = radius;
    variants.push_back({ name, settings });
  };
  add("nearest", rtw::Filter::NEAREST, {});
  add("bilinear", rtw::Filter::BILINEAR, {});
  for (const int radius : { 1, 2, 4, 8 })
  {
    add("pcf-" + std::to_string(radius), rtw::Filter::PCF, radius);
  }
  add("soft-0.1", rtw::Filter::SOFT, 0.1);
  Setups setups;
  for (const auto& [name, motion] :
    { std::pair("camera", Motion::CAMERA), { "nothing", Motion::NOTHING } })
  {
    for (Setup& setup : Grid("filters", options,
           Chosen<std::string>(options, options.Scenes, { "town", "playground" }, { "robot" }),
           Resolutions(options, 1024, 256), Beside(variants)))
    {
      setup.Variable = std::string("moving:") + name;
      setup.Moves = motion;
      setups.push_back(setup);
    }
  }
  return setups;
}

Setups MakeViewSamples(const Options& options)
{
  std::vector<Variant> variants;
  for (const auto& [name, source] : rtw::SampleSourceNames())
  {
    variants.push_back({ name, {} });
    variants.back().Settings.Samples = source;
  }
  Setups setups = Grid("view-samples", options,
    Chosen<std::string>(options, options.Scenes, { "town", "playground" }, { "robot" }),
    Resolutions(options, 1024, 256), Beside(variants));
  for (Setup& setup : setups)
  {
    setup.Flickers = true;
  }
  return setups;
}

Setups MakeClaims(const Options& options)
{
  const Strings scenes = Chosen<std::string>(
    options, options.Scenes, { "town", "playground", "duel", "robot" }, { "robot" });
  const Contestant rtw = { "rtw" };
  const auto at = [](Contestant contestant, int resolution) {
    contestant.Resolution = resolution;
    return contestant;
  };
  std::vector<Contestant> error = Yardsticks(), flicker = error;
  error.insert(error.end(), { at(rtw, 512), WholeScene("whole-scene", 2048) });
  Contestant snapping = at(rtw, 1024);
  snapping.Variant = "snapping";
  snapping.Settings.Snapping = true;
  snapping.LeadsIn = true;
  flicker.insert(
    flicker.end(), { at(rtw, 1024), snapping, at(rtw, 2048), at({ "uniform" }, 4096) });
  Setups setups = Grid("claims", options, scenes, { 1024 }, error);
  for (Setup& setup : setups)
  {
    setup.Variable = "claim:error";
  }
  for (Setup& setup : Grid("claims", options, scenes, { 1024 }, flicker))
  {
    setup.Variable = "claim:flicker";
    setup.Flickers = true;
    setup.Places = 4;
    setups.push_back(setup);
  }
  return setups;
}
