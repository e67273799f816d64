// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"

#include <stdexcept>

namespace rtw
{
namespace
{
struct Entry
{
  const char* Name;
  Scene (*Make)(double scale);
};

const Entry SCENES[] = {
  { "town", MakeTown },
  { "sandbox", MakeSandbox },
  { "furball", MakeFurball },
  { "playground", MakePlayground },
  { "duel", MakeDuel },
  { "robot", MakeRobot },
  { "terrain", MakeTerrain },
};
}

std::vector<std::string> SceneNames()
{
  std::vector<std::string> names;
  for (const Entry& entry : SCENES)
  {
    names.push_back(entry.Name);
  }
  return names;
}

Scene MakeScene(const std::string& name, double scale)
{
  if (!(scale > 0))
  {
    throw std::invalid_argument("the scale of a scene must be above zero");
  }
  for (const Entry& entry : SCENES)
  {
    if (name == entry.Name)
    {
      Scene scene = entry.Make(scale);
      scene.Name = name;
      return scene;
    }
  }
  throw std::invalid_argument("no scene is called \"" + name + "\"");
}
}
