// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include "rtwCommandLine.h"
#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{
using rtw::StorageScheme;
using rtw::StoredView;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Quarter = 0.78539816339744831; // of half a turn
const glm::dvec3 Overhead(0, -1, 0);
const glm::dvec3 Behind(0, 0, -1);

double Factor(const StoredView& view, const Scheme& scheme, const glm::dvec3& direction)
{
  return rtw::StorageFactor(view, scheme.Of, direction).Factor;
}

// From a place of the light: azimuth from behind the viewer, elevation.
glm::dvec3 DirectionFrom(double azimuth, double elevation)
{
  return -glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
    std::cos(elevation) * std::cos(azimuth));
}

// How errors lie along the view (Equations 7 and 8), without what they share.
std::string ErrorsAlongTheView(const StoredView& view)
{
  std::ostringstream text;
  text << "eta,z,across,along\n";
  const double n = view.Near, f = view.Far;
  for (const double eta : { -1.0, -0.5, 0.0, 0.5, 1.0 })
  {
    const double strength =
      (f - n) * rtw::InverseOfNear({ rtw::PerspectiveChoice::Eta, eta }, n, f);
    for (int i = 0; i <= 100; ++i)
    {
      const double z = n + (f - n) * i / 100;
      // z' and f', in n'
      const double away = 1 + strength * i / 100;
      text << eta << ',' << z << ',' << away / (z * (1 + strength)) << ','
           << away * away / (z * (1 + strength)) << '\n';
    }
  }
  return text.str();
}

std::string ErrorsByEta(const StoredView& view)
{
  std::ostringstream text;
  text << "eta,near,across,along,storage\n";
  for (int i = -100; i <= 100; ++i)
  {
    const double nearDistance = rtw::NearOfEta(0.01 * i, view.Near, view.Far);
    text << 0.01 * i << ',' << nearDistance << ',' << rtw::LargestErrorAcross(view, nearDistance)
         << ',' << rtw::LargestErrorAlong(view, nearDistance) << ','
         << rtw::StorageOverhead(view, nearDistance) << '\n';
  }
  return text.str();
}

std::string Hemisphere(const StoredView& view)
{
  constexpr int steps = 45;
  std::ostringstream text;
  text << "scheme,partitions,azimuth,elevation,storage\n";
  for (const int partitions : { 1, 4 })
  {
    for (const Scheme& scheme : Schemes(partitions))
    {
      for (int a = 0; a <= 4 * steps; ++a)
      {
        for (int e = 0; e <= steps; ++e)
        {
          const double azimuth = 90.0 * a / steps, elevation = 90.0 * e / steps;
          const double storage =
            Factor(view, scheme, DirectionFrom(azimuth * Quarter / 45, elevation * Quarter / 45));
          text << scheme.Name << ',' << partitions << ',' << azimuth << ',' << elevation << ','
               << storage << '\n';
        }
      }
    }
  }
  return text.str();
}

std::string ByPartitions(const StoredView& view)
{
  std::ostringstream text;
  text << "ratio,partitions,warped,unwarped,optimal\n";
  for (int i = 1; i <= 100; ++i)
  {
    StoredView each = view;
    each.Far = view.Near * std::pow(10, 0.04 * i);
    for (const int k : { 1, 2, 3, 4, 6, 8, 16 })
    {
      text << each.Far / each.Near << ',' << k << ',' << rtw::StorageOverheadZPW(each, k) << ','
           << rtw::StorageOverheadZP(each, k) << ',' << rtw::StorageOptimal(each) << '\n';
    }
  }
  return text.str();
}

std::string ByMaps(const StoredView& view)
{
  std::ostringstream text;
  text << "maps,light,scheme,storage\n";
  for (int maps = 1; maps <= 40; ++maps)
  {
    text << maps << ",overhead,ZP," << rtw::StorageOverheadZP(view, maps) << '\n'
         << maps << ",overhead,ZP+W," << rtw::StorageOverheadZPW(view, maps) << '\n'
         << maps << ",behind,ZP," << rtw::StorageBehindZP(view, maps) << '\n';
    // Four sides, and the near plane.
    if (maps % 4 == 1 && maps > 1)
    {
      text << maps << ",overhead,FP+ZP+W," << rtw::StorageOverheadZPW(view, maps / 4) << '\n'
           << maps << ",behind,FP+ZP+W," << rtw::StorageBehindFPZPW(view, maps / 4) << '\n';
    }
  }
  return text.str();
}

// The most maps with which depth partitions alone are as good.
std::string Crossing(const StoredView& view)
{
  std::ostringstream text;
  text << "ratio,maps\n";
  for (int i = 2; i <= 100; ++i)
  {
    StoredView each = view;
    each.Far = view.Near * std::pow(10, 0.05 * i);
    int maps = 1;
    while (maps < 100 &&
      (maps < 5 ||
        rtw::StorageBehindZP(each, maps) <= rtw::StorageBehindFPZPW(each, (maps - 1) / 4)))
    {
      ++maps;
    }
    text << each.Far / each.Near << ',' << maps - 1 << '\n';
  }
  return text.str();
}

struct Worst
{
  double Storage = 0;
  glm::dvec3 Direction{ 0 };
};

Worst WorstOf(const StoredView& view, const Scheme& scheme)
{
  Worst worst;
  for (int a = 0; a < 180; ++a)
  {
    for (int e = 0; e <= 45; ++e)
    {
      const glm::dvec3 direction = DirectionFrom(2 * a * Quarter / 45, 2 * e * Quarter / 45);
      const double storage = Factor(view, scheme, direction);
      worst = storage > worst.Storage ? Worst{ storage, direction } : worst;
    }
  }
  return worst;
}
}

std::vector<Scheme> Schemes(int partitions)
{
  const std::string zp = partitions > 1 ? "ZP" : "";
  const std::string plus = zp.empty() ? "" : "+";
  return { { zp.empty() ? "none" : zp, { StorageScheme::None, partitions, false } },
    { zp + plus + "W", { StorageScheme::LiSPSM, partitions, false } },
    { "FP+" + zp + plus + "W", { StorageScheme::LiSPSM, partitions, true } } };
}

std::string FigureText(int figure, const StoredView& view)
{
  switch (figure)
  {
    case 5:
      return ErrorsAlongTheView(view);
    case 6:
      return ErrorsByEta(view);
    case 7:
      return Hemisphere(view);
    case 10:
      return ByPartitions(view);
    case 12:
      return ByMaps(view);
    case 13:
      return Crossing(view);
    default:
      throw rtw::UsageError(
        "--figure " + std::to_string(figure) + ": expected one of 5, 6, 7, 10, 12, 13");
  }
}

std::string TableText(const StoredView& view, int partitions)
{
  std::ostringstream text;
  text << "scheme,partitions,overhead,overhead closed,behind,behind closed,worst,worst / behind "
          "closed\n";
  for (int k = 1; k <= partitions; ++k)
  {
    for (const Scheme& scheme : Schemes(k))
    {
      const bool warped = scheme.Of.Warp != StorageScheme::None;
      const double behind =
        scheme.Of.Faces ? rtw::StorageBehindFPZPW(view, k) : rtw::StorageBehindZP(view, k);
      const double worst = WorstOf(view, scheme).Storage;
      text << scheme.Name << ',' << k << ',' << Factor(view, scheme, Overhead) << ','
           << (warped ? rtw::StorageOverheadZPW(view, k) : rtw::StorageOverheadZP(view, k)) << ','
           << Factor(view, scheme, Behind) << ',' << behind << ',' << worst << ',' << worst / behind
           << '\n';
    }
  }
  text << "optimal,," << rtw::StorageOptimal(view) << ',' << rtw::StorageOptimal(view) << ",,,,\n";
  return text.str();
}

std::string LightText(const StoredView& view, int partitions, const glm::dvec3& direction)
{
  std::ostringstream text;
  text << "scheme,partitions,maps,storage\n";
  for (int k = 1; k <= partitions; ++k)
  {
    for (const Scheme& scheme : Schemes(k))
    {
      const rtw::Storage storage = rtw::StorageFactor(view, scheme.Of, direction);
      text << scheme.Name << ',' << k << ',' << storage.Maps << ',' << storage.Factor << '\n';
    }
  }
  return text.str();
}
