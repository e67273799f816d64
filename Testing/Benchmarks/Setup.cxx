// SPDX-License-Identifier: BSD-3-Clause
#include "Setup.h"

#include "rtwScene.h"

#include <algorithm>
#include <iterator>

namespace
{
using Setups = std::vector<Setup>;

std::vector<int> Values(const Options& options, std::vector<int> all, std::vector<int> quick)
{
  return options.Quick ? std::move(quick) : std::move(all);
}

Setup Start(const char* family, const Options& options)
{
  Setup setup;
  setup.Family = family;
  setup.Width = options.Size.first;
  setup.Height = options.Size.second;
  setup.Triangles = options.Quick ? 20000 : 0;
  return setup;
}

Setups Maps(const Options& options)
{
  const std::vector<std::string> few = { "sandbox", "town" };
  const std::vector<std::string> scenes = !options.Scenes.empty() ? options.Scenes
    : options.Quick                                               ? few
                                                                  : rtw::SceneNames();
  const std::vector<int> resolutions = !options.Resolutions.empty()
    ? options.Resolutions
    : Values(options, { 256, 512, 1024, 2048, 4096 }, { 256, 1024 });
  Setups setups;
  for (const std::string& scene : scenes)
  {
    for (const int resolution : resolutions)
    {
      Setup setup = Start("maps", options);
      setup.Scene = scene;
      setup.Resolution = resolution;
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
    Setup setup = Start(family, options);
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
    Setup setup = Start("moving", options);
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

struct FamilyEntry
{
  const char* Name;
  const char* Description;
  Setups (*Make)(const Options& options);
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
};

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

std::string Setup::Name() const
{
  return this->Family + "/scene:" + this->Scene +
    (this->Variable.empty() ? "" : "/" + this->Variable) +
    "/map:" + std::to_string(this->Resolution);
}

int Setup::LeastPlaces(const Options& options) const
{
  return this->IsHeavy || this->Moves == Motion::NOTHING ? 1 : options.ErrorViews;
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

std::string FamilyDescription(const std::string& name)
{
  const auto family = std::find_if(std::begin(FAMILIES), std::end(FAMILIES),
    [&](const FamilyEntry& entry) { return name == entry.Name; });
  return family == std::end(FAMILIES) ? "" : family->Description;
}

std::vector<Setup> MakeSetups(const Options& options)
{
  Setups all;
  for (const FamilyEntry& family : FAMILIES)
  {
    const auto& asked = options.Families;
    if (asked.empty() || std::find(asked.begin(), asked.end(), family.Name) != asked.end())
    {
      const Setups setups = family.Make(options);
      all.insert(all.end(), setups.begin(), setups.end());
    }
  }
  return all;
}
