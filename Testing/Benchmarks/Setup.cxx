// SPDX-License-Identifier: BSD-3-Clause
#include "Families.h"

#include "rtwScene.h"

#include <algorithm>
#include <iterator>

namespace
{
std::vector<int> Values(const Options& options, std::vector<int> all, std::vector<int> quick)
{
  return Chosen<int>(options, {}, std::move(all), std::move(quick));
}

Setups Maps(const Options& options)
{
  const std::vector<std::string> scenes =
    Chosen(options, options.Scenes, rtw::SceneNames(), { "sandbox", "town" });
  const std::vector<int> resolutions =
    Chosen(options, options.Resolutions, { 256, 512, 1024, 2048, 4096 }, { 256, 1024 });
  Setups setups;
  for (const std::string& scene : scenes)
  {
    for (const int resolution : resolutions)
    {
      Setup setup = StartSetup("maps", options);
      setup.Scene = scene;
      setup.Resolution = resolution;
      setup.IsHeavy = resolution > 2048;
      setup.Flickers = !options.Quick;
      setups.push_back(setup);
    }
  }
  return setups;
}

// A family in which one number grows.
Setups Growth(const char* family, const char* scene, const Options& options,
  const std::vector<int>& values, void (*apply)(int value, Setup& setup))
{
  Setups setups;
  for (const int value : values)
  {
    Setup setup = StartSetup(family, options);
    setup.Scene = scene;
    setup.Variable = std::string(family) + ":" + std::to_string(value);
    apply(value, setup);
    setups.push_back(setup);
  }
  return setups;
}

Setups Moving(const Options& options)
{
  const std::pair<const char*, Motion> motions[] = { { "nothing", Motion::NOTHING },
    { "camera", Motion::CAMERA }, { "light", Motion::LIGHT }, { "actor", Motion::ACTOR } };
  Setups setups;
  for (const auto& [name, motion] : motions)
  {
    Setup setup = StartSetup("moving", options);
    setup.Variable = std::string("moving:") + name;
    setup.Moves = motion;
    setup.Actors = 64;
    setups.push_back(setup);
  }
  return setups;
}

Setups Lights(const Options& options)
{
  return Growth("lights", "robot", options, Values(options, { 1, 2, 4, 8 }, { 1, 4 }),
    [](int value, Setup& setup) { setup.Lights = value; });
}

Setups Actors(const Options& options)
{
  return Growth("actors", "town", options,
    Values(options, { 1, 10, 100, 1000, 5000 }, { 1, 100, 1000 }), [](int value, Setup& setup) {
      setup.Actors = value;
      setup.IsHeavy = value > 1000;
      setup.Triangles = setup.Triangles > 0 ? setup.Triangles : 250000;
    });
}

Setups Outside(const Options& options)
{
  return Growth("outside", "town", options, Values(options, { 0, 1, 4, 16 }, { 0, 4 }),
    [](int value, Setup& setup) {
      setup.Outside = value;
      setup.Triangles = setup.Triangles > 0 ? setup.Triangles : 50000;
    });
}

Setups Windows(const Options& options)
{
  Setups setups = Growth("window", "town", options,
    Values(options, { 256, 512, 1024, 2048, 3840 }, { 128, 256, 512 }),
    [](int value, Setup& setup) {
      setup.Width = value;
      setup.Height = value == 3840 ? 2160 : value;
      setup.IsHeavy = value > 2048;
    });
  return setups;
}

Setups Triangles(const Options& options)
{
  return Growth("triangles", "terrain", options,
    Values(options, { 10000, 100000, 1000000, 5000000 }, { 10000, 100000 }),
    [](int value, Setup& setup) {
      setup.Triangles = std::size_t(value);
      setup.IsHeavy = value > 1000000;
    });
}

enum class Runs
{
  BY_DEFAULT,
  WHEN_NAMED
};

struct FamilyEntry
{
  const char* Name;
  const char* Description;
  Setups (*Make)(const Options& options);
  Runs When = Runs::BY_DEFAULT;
};

// From light to heavy, since time that one family leaves goes to those after it.
const FamilyEntry FAMILIES[] = {
  { "maps", "each scene by maps of 256 to 4096 texels a side", Maps },
  { "moving", "nothing, the camera, the light, or one actor of 64 moves", Moving },
  { "lights", "1 to 8 lights with shadows", Lights },
  { "actors", "250 000 triangles in 1 to 5000 actors", Actors },
  { "outside", "0 to 16 times as many casters behind the camera as in front", Outside },
  { "window", "256 x 256 to 3840 x 2160 pixels", Windows },
  { "triangles", "10 000 to 5 000 000 triangles", Triangles },
  { "paper", "tables 1 to 3 of the paper on RTW: analyses, and tessellation", MakePaper,
    Runs::WHEN_NAMED },
  { "functions", "every analysis and importance function", MakeFunctions, Runs::WHEN_NAMED },
  { "rasterizations", "ways to draw edges that a warp bends", MakeRasterizations,
    Runs::WHEN_NAMED },
  { "filters", "while the camera moves, and while nothing does", MakeFilters, Runs::WHEN_NAMED },
  { "view-samples", "of a prepass, and of the previous frame", MakeViewSamples, Runs::WHEN_NAMED },
  { "claims", "small maps of rtw beside large uniform ones: error, flicker, analysis", MakeClaims,
    Runs::WHEN_NAMED },
};

const FamilyEntry& Find(const std::string& name)
{
  return *std::find_if(std::begin(FAMILIES), std::end(FAMILIES) - 1,
    [&](const FamilyEntry& entry) { return name == entry.Name; });
}

bool IsAsked(const FamilyEntry& family, const std::vector<std::string>& asked)
{
  return asked.empty() ? family.When == Runs::BY_DEFAULT
                       : std::find(asked.begin(), asked.end(), family.Name) != asked.end();
}

const char* NameOf(Motion motion)
{
  switch (motion)
  {
    case Motion::NOTHING:
      return "nothing";
    case Motion::LIGHT:
      return "light";
    case Motion::ACTOR:
      return "actor";
    default:
      return "camera";
  }
}
}

Setup StartSetup(const char* family, const Options& options)
{
  Setup setup;
  setup.Family = family;
  setup.Width = options.Size.first;
  setup.Height = options.Size.second;
  setup.Triangles = std::size_t(options.Triangles);
  return setup;
}

int Setup::ResolutionOf(const Contestant& contestant) const
{
  return contestant.Resolution.value_or(this->Resolution);
}

std::string Setup::LineName(const Contestant& contestant) const
{
  return this->Family + "/scene:" + this->Scene +
    (this->Variable.empty() ? "" : "/" + this->Variable) +
    "/map:" + std::to_string(this->ResolutionOf(contestant)) + "/" + contestant.Name();
}

int Setup::Laps(const Options& options) const
{
  return std::min(options.Laps, this->MostLaps);
}

int Setup::LeastPlaces(const Options& options) const
{
  const bool isOne = this->IsHeavy || this->Moves == Motion::NOTHING;
  const int places = isOne ? 1 : this->Places > 0 ? this->Places : options.ErrorViews;
  return std::min(places, options.Frames);
}

std::string Setup::Content() const
{
  std::string text = this->Scene;
  for (const std::size_t number : { std::size_t(this->Width), std::size_t(this->Height),
         this->Triangles, std::size_t(this->Actors), std::size_t(this->Lights),
         std::size_t(this->Outside), std::size_t(this->Flickers) })
  {
    text += " " + std::to_string(number);
  }
  return text + " " + NameOf(this->Moves);
}

std::vector<std::string> FamilyNames()
{
  std::vector<std::string> names;
  for (const FamilyEntry& family : FAMILIES)
  {
    names.push_back(family.Name);
  }
  return names;
}

std::string FamilyDescription(const std::string& family)
{
  return Find(family).Description;
}

bool IsByDefault(const std::string& family)
{
  return Find(family).When == Runs::BY_DEFAULT;
}

double DefaultMinutes(const std::vector<std::string>& families, bool quick)
{
  const auto asked = [&](Runs when) {
    return std::count_if(std::begin(FAMILIES), std::end(FAMILIES),
      [&](const FamilyEntry& family) { return family.When == when && IsAsked(family, families); });
  };
  const double minutes =
    (asked(Runs::BY_DEFAULT) > 0 ? 9 : 0) + 3 * double(asked(Runs::WHEN_NAMED));
  return quick ? 2.4 / 9 * minutes : minutes;
}

std::vector<Setup> MakeSetups(const Options& options)
{
  Setups all;
  for (const FamilyEntry& family : FAMILIES)
  {
    if (IsAsked(family, options.Families))
    {
      const Setups setups = family.Make(options);
      all.insert(all.end(), setups.begin(), setups.end());
    }
  }
  return all;
}
