// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"

#include <cmath>
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
  { "room", MakeRoom },
  { "assembly", MakeAssembly },
  { "molecule", MakeMolecule },
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

// Triangles are about linear in the scale, with a part that stays: secants find the scale quickly.
Scene MakeSceneWithBudget(const std::string& name, std::size_t triangles)
{
  if (triangles == 0)
  {
    throw std::invalid_argument("the budget of a scene must be above zero");
  }
  const double budget = double(triangles);
  const auto isNear = [&](double count) { return std::abs(count / budget - 1) < 0.02; };
  const auto error = [&](double count) { return std::abs(std::log(count / budget)); };
  double lastScale = 0, lastCount = 0, scale = 1;
  Scene best = MakeScene(name, scale);
  double count = double(NumberOfTriangles(best)), bestCount = count;
  for (int attempt = 0; attempt < 12 && !isNear(bestCount); ++attempt)
  {
    const double slope = (count - lastCount) / (scale - lastScale);
    const double wanted = slope > 0 ? scale + (budget - count) / slope : scale * budget / count;
    lastScale = scale;
    lastCount = count;
    scale = std::clamp(wanted, std::max(scale / 8, 1e-4), scale * 64);
    if (scale == lastScale)
    {
      break;
    }
    Scene scene = MakeScene(name, scale);
    count = double(NumberOfTriangles(scene));
    if (error(count) < error(bestCount))
    {
      best = std::move(scene);
      bestCount = count;
    }
  }
  return best;
}
}
