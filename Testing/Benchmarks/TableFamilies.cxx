// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

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
  return settings.Get("view-samples") == "previous-frame" ||
    settings.Get("importance").find("edges") != std::string::npos;
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
  uniform.Settings.Set("focus", "off");
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
  for (const std::string& name : rtw::FindSetting("rasterization").Choices)
  {
    Variant variant{ name, settings };
    variant.Settings.Set("rasterization", name);
    if (name != "tessellated")
    {
      variants.push_back(variant);
      continue;
    }
    for (const auto& [length, percent] : { std::pair("0.05", "5"), { "0.025", "2.5" }, { "0.01", "1" } })
    {
      variant.Name = name + "-" + percent;
      variant.Settings.Set("edge-length", length);
      variants.push_back(variant);
    }
  }
  return variants;
}

Variant Function(const std::string& analysis, const std::string& importance)
{
  Variant variant{ analysis + "+" + importance, {} };
  variant.Settings.Set("analysis", analysis);
  variant.Settings.Set("importance", importance);
  if (importance == "user")
  {
    variant.Settings.Set("user-function", "luminance");
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
      const std::string how = variant.Settings.Get("rasterization");
      if (how == "linear" || how == "tessellated")
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
  const Strings& single = rtw::FindSetting("importance").Choices;
  products.insert(products.end(), single.begin(), single.end());
  std::vector<Variant> variants;
  for (const std::string& analysis : rtw::FindSetting("analysis").Choices)
  {
    for (const std::string& product : products)
    {
      // Without edges a hybrid analysis is the backward one.
      if (analysis != "hybrid" || product.find("edges") != std::string::npos)
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
  const auto add = [&](const std::string& filter, const std::string& radius) {
    Variant variant{ filter + (radius.empty() ? "" : "-" + radius), {} };
    variant.Settings.Set("filter", filter);
    if (!radius.empty())
    {
      variant.Settings.Set("filter-radius", radius);
    }
    variants.push_back(variant);
  };
  add("nearest", "");
  add("bilinear", "");
  for (const char* radius : { "1", "2", "4", "8" })
  {
    add("pcf", radius);
  }
  add("soft", "0.1");
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
  for (const std::string& source : rtw::FindSetting("view-samples").Choices)
  {
    variants.push_back({ source, {} });
    variants.back().Settings.Set("view-samples", source);
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
  snapping.Settings.Set("snapping", "on");
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
