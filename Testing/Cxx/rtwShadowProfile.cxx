// SPDX-License-Identifier: BSD-3-Clause
#include "rtwShadowProfile.h"

#include <algorithm>
#include <cmath>

namespace
{
// In pixels, centres at whole numbers.
std::array<double, 2> ToPixel(rtwShadowStage& stage, const double world[3])
{
  stage.Renderer->SetWorldPoint(world[0], world[1], world[2], 1);
  stage.Renderer->WorldToDisplay();
  const double* display = stage.Renderer->GetDisplayPoint();
  return { display[0] - 0.5, display[1] - 0.5 };
}

double Sample(
  const std::vector<unsigned char>& mask, int width, int height, const std::array<double, 2>& at)
{
  const int x = std::clamp(int(std::floor(at[0])), 0, width - 2);
  const int y = std::clamp(int(std::floor(at[1])), 0, height - 2);
  const double u = at[0] - x, v = at[1] - y;
  const auto value = [&](int i, int j) {
    return rtwVisibilityOf(mask[size_t(y + j) * width + x + i]);
  };
  return (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0)) +
    v * ((1 - u) * value(0, 1) + u * value(1, 1));
}
}

double rtwVisibilityOf(unsigned char value)
{
  return value < 128 ? value / 254.0 : value > 128 ? 0.5 + (value - 129) / 252.0 : 1.0;
}

std::vector<double> rtwProfile(
  rtwShadowStage& stage, const double from[3], const double to[3], int count)
{
  const std::vector<unsigned char> mask = stage.GetMask(0);
  const int* size = stage.Renderer->GetSize();
  std::vector<double> profile;
  for (int i = 0; i < count && !mask.empty(); ++i)
  {
    const double t = double(i) / (count - 1);
    const double world[] = { from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
      from[2] + t * (to[2] - from[2]) };
    profile.push_back(Sample(mask, size[0], size[1], ToPixel(stage, world)));
  }
  return profile;
}

bool rtwIsMonotone(const std::vector<double>& profile)
{
  for (size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] < profile[i - 1] - 0.006)
    {
      return false;
    }
  }
  return !profile.empty() && profile.front() < 0.02 && profile.back() > 0.98;
}

double rtwSteepest(const std::vector<double>& profile)
{
  double steepest = 0;
  for (size_t i = 1; i < profile.size(); ++i)
  {
    steepest = std::max(steepest, std::abs(profile[i] - profile[i - 1]));
  }
  return steepest;
}

double rtwWhere(const std::vector<double>& profile, double level)
{
  for (size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] >= level)
    {
      const double step = std::max(profile[i] - profile[i - 1], 1e-9);
      const double before = std::clamp((profile[i] - level) / step, 0.0, 1.0);
      return (double(i) - before) / double(profile.size() - 1);
    }
  }
  return -1;
}

double rtwWidth(const std::vector<double>& profile)
{
  return rtwWhere(profile, 0.9) - rtwWhere(profile, 0.1);
}

double rtwMeanVisibility(const std::vector<unsigned char>& mask)
{
  double sum = 0;
  size_t count = 0;
  for (const unsigned char value : mask)
  {
    count += value != rtw::MASK_AVERTED;
    sum += value != rtw::MASK_AVERTED ? rtwVisibilityOf(value) : 0;
  }
  return count ? sum / double(count) : 0;
}
