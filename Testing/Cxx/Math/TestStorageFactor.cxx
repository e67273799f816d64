// SPDX-License-Identifier: BSD-3-Clause
// The closed forms of Lloyd et al. 2006 beside numbers from the corners of the frustum.
#include "Partition/rtwStorageFactor.h"

#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using rtw::StorageScheme;
using rtw::StoredView;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;
const glm::dvec3 Overhead(0, -1, 0);
const glm::dvec3 Behind(0, 0, -1);

double Factor(const StoredView& view, int warp, int partitions, bool faces, const glm::dvec3& light)
{
  return rtw::StorageFactor(view, { warp, partitions, faces }, light).Factor;
}

void ExpectNear(double actual, double expected, double share = 1e-9)
{
  EXPECT_NEAR(actual / expected, 1, share) << actual << " beside " << expected;
}

const StoredView Views[] = { { 1, 100, Pi / 6 }, { 1, 1000, Pi / 6 }, { 0.1, 3, Pi / 5 },
  { 2, 20000, Pi / 12 } };

TEST(StorageFactor, OfEquation12IsTheSameFromPSMToLiSPSM)
{
  for (const StoredView& view : Views)
  {
    const double n = view.Near, f = view.Far;
    const double least = (f / n - 1) / (2 * std::tan(view.HalfAngle));
    for (const double eta : { 0.0, 0.1, 0.5, 0.9, 1.0 })
    {
      ExpectNear(rtw::StorageOverhead(view, rtw::NearOfEta(eta, n, f)), least);
    }
    // One of a farther focus point is not in the range: the paper's "some TSMs".
    const double focus = 4 / (4 + std::sqrt(f / n)); // that of LiSPSM
    ExpectNear(rtw::StorageOverhead(view, rtw::NearOfFocusPoint(0.5 * focus, n, f)), least);
    EXPECT_GT(
      rtw::StorageOverhead(view, rtw::NearOfFocusPoint(0.5 * (focus + 0.8), n, f)), least * 1.01);
    ExpectNear(rtw::StorageOverhead(view, Infinity), f / n * least);
    double last = least;
    for (double eta = -0.05; eta > -1; eta -= 0.05)
    {
      const double nearDistance = rtw::NearOfEta(eta, n, f), root = nearDistance + f - n;
      const double storage = rtw::StorageOverhead(view, nearDistance);
      ExpectNear(storage, least * nearDistance * nearDistance * f / (n * root * root));
      EXPECT_GT(storage, last);
      last = storage;
    }
  }
}

TEST(StorageFactor, OfEquation12IsTheProductOfTheErrorsMaxima)
{
  const StoredView view{ 1, 100, Pi / 6 };
  for (const double nearDistance : { 1.0, 4.0, 11.0, 30.0, 1000.0 })
  {
    double across = 0, along = 0;
    for (int i = 0; i <= 10000; ++i)
    {
      // Equations 7 and 8.
      const double z = 1 + 99 * i / 10000.0, away = nearDistance + z - 1, end = nearDistance + 99;
      across = std::max(across, 100 * away / (z * end));
      along = std::max(along, 99 / (2 * std::tan(Pi / 6)) * away * away / (z * nearDistance * end));
    }
    ExpectNear(rtw::LargestErrorAcross(view, nearDistance), across);
    ExpectNear(rtw::LargestErrorAlong(view, nearDistance), along);
  }
}

TEST(StorageFactor, OfALightOverheadIsThatOfTheClosedForms)
{
  for (const StoredView& view : Views)
  {
    for (const int k : { 1, 2, 3, 4, 8, 16 })
    {
      ExpectNear(
        Factor(view, StorageScheme::None, k, false, Overhead), rtw::StorageOverheadZP(view, k));
      for (const int warp : { StorageScheme::LiSPSM, StorageScheme::Best })
      {
        ExpectNear(Factor(view, warp, k, false, Overhead), rtw::StorageOverheadZPW(view, k), 1e-6);
        ExpectNear(Factor(view, warp, k, true, Overhead), rtw::StorageOverheadZPW(view, k), 1e-6);
      }
    }
  }
}

TEST(StorageFactor, OfALightBehindIsThatOfTheClosedForms)
{
  for (StoredView view : Views)
  {
    for (const int k : { 1, 2, 4, 8 })
    {
      for (const int warp : { StorageScheme::None, StorageScheme::LiSPSM, StorageScheme::Best })
      {
        ExpectNear(Factor(view, warp, k, false, Behind), rtw::StorageBehindZP(view, k), 1e-6);
        ExpectNear(Factor(view, warp, k, false, -Behind), rtw::StorageBehindZP(view, k), 1e-6);
      }
      // A square image's sides are 45 degrees from its middle, whatever its field of view.
      for (const int warp : { StorageScheme::LiSPSM, StorageScheme::Best })
      {
        const rtw::Storage storage = rtw::StorageFactor(view, { warp, k, true }, Behind);
        ExpectNear(storage.Factor, rtw::StorageBehindFPZPW(view, k), 1e-6);
        EXPECT_EQ(storage.Maps, 4 * k + 1);
        EXPECT_EQ(rtw::StorageFactor(view, { warp, k, true }, Overhead).Maps, k);
      }
    }
  }
}

TEST(StorageFactor, NearsTheLogarithmicMapsWithMorePartitions)
{
  for (const StoredView& view : Views)
  {
    const double optimal = rtw::StorageOptimal(view);
    ExpectNear(optimal, std::log(view.Far / view.Near) / (2 * std::tan(view.HalfAngle)));
    double last = Infinity;
    for (const int k : { 1, 2, 4, 8, 16, 64, 256 })
    {
      const double storage = Factor(view, StorageScheme::LiSPSM, k, false, Overhead);
      EXPECT_GT(storage, optimal);
      EXPECT_LT(storage, last);
      last = storage;
    }
    ExpectNear(last, optimal, 0.03);
  }
}

TEST(StorageFactor, OfTheLogarithmicMapIsThatOfAnEvenError)
{
  // Appendix C, added up over thin slices: each as dense as its image beams.
  const StoredView view{ 1, 500, Pi / 6 };
  double sum = 0;
  constexpr int slices = 100000;
  for (int i = 0; i < slices; ++i)
  {
    const double from = std::pow(500, double(i) / slices), to = std::pow(500, (i + 1.0) / slices);
    sum += (to - from) / (2 * std::tan(view.HalfAngle) * std::sqrt(from * to));
  }
  ExpectNear(rtw::StorageOptimal(view), sum, 1e-6);
}

glm::dvec3 OnHemisphere(double azimuth, double elevation)
{
  return -glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
    std::cos(elevation) * std::cos(azimuth));
}

template <class Function>
double Greatest(const Function& of)
{
  double greatest = 0;
  for (int i = 0; i < 48; ++i)
  {
    for (int j = 0; j <= 24; ++j)
    {
      greatest = std::max(greatest, of(OnHemisphere(i * Pi / 24, j * Pi / 48)));
    }
  }
  return greatest;
}

// Section 5.3: over all directions of the light 2 to 3 times that of a light behind, at most.
TEST(StorageFactor, IsNowhereFarAboveThatOfALightBehind)
{
  for (const StoredView& view : { StoredView{ 1, 1000, Pi / 6 }, StoredView{ 1, 100, Pi / 4 } })
  {
    for (const int k : { 1, 2, 4, 8 })
    {
      for (const int warp : { StorageScheme::None, StorageScheme::LiSPSM, StorageScheme::Best })
      {
        for (const bool faces : { false, true })
        {
          if (faces && warp == StorageScheme::None)
          {
            continue; // the paper has none
          }
          const double behind =
            faces ? rtw::StorageBehindFPZPW(view, k) : rtw::StorageBehindZP(view, k);
          const double factor =
            Greatest([&](const glm::dvec3& light) { return Factor(view, warp, k, faces, light); }) /
            behind;
          EXPECT_GE(factor, 1 - 1e-9) << k << " partitions, faces " << faces;
          EXPECT_LE(factor, 3) << k << " partitions, faces " << faces;
        }
      }
    }
  }
}

TEST(StorageFactor, IsContinuousAndTheSameFromBothSides)
{
  const StoredView view{ 1, 1000, Pi / 6 };
  for (const int warp : { StorageScheme::None, StorageScheme::LiSPSM, StorageScheme::Best })
  {
    double last = 0;
    for (int i = -300; i <= 300; ++i)
    {
      const glm::dvec3 light(std::sin(1e-4 * i), 0, -std::cos(1e-4 * i));
      const double factor = Factor(view, warp, 1, false, light);
      EXPECT_TRUE(std::isfinite(factor));
      EXPECT_LT(i == -300 ? 0 : std::abs(factor / last - 1), 0.02);
      ExpectNear(Factor(view, warp, 1, false, -light), factor, 1e-6);
      last = factor;
    }
  }
}

// The search finds no worse than any warp on a grid.
TEST(StorageFactor, OfTheBestWarpIsNoMoreThanOfOthers)
{
  const StoredView view{ 1, 300, Pi / 7 };
  for (int i = 0; i < 12; ++i)
  {
    const glm::dvec3 light = OnHemisphere(i * 0.5, 0.1 + 0.1 * i);
    const double best = Factor(view, StorageScheme::Best, 2, i % 2 != 0, light);
    EXPECT_LE(best, Factor(view, StorageScheme::LiSPSM, 2, i % 2 != 0, light) * (1 + 1e-6));
    EXPECT_LE(best, Factor(view, StorageScheme::None, 2, i % 2 != 0, light) * (1 + 1e-6));
  }
}
}
