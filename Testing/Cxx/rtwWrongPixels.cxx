// SPDX-License-Identifier: BSD-3-Clause
#include "rtwWrongPixels.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

namespace
{
constexpr double SameDepth = 1e-6;
constexpr double SameSurface = 1e-5; // of depth, in the pixel
constexpr int Directions = 32;
// In pixels. A corner on the lattice is up to 1/362 off.
constexpr double Nearest = 1.0 / 1024;
constexpr double OtherWithin = 1.0 / 256;
constexpr double EdgeWithin = 1.0 / 128;
constexpr double Clearances[] = { 0.5, 0.25, 0.1, 1.5, 2, 3, 4, 6, 8 };

bool IsWrong(unsigned char is, unsigned char exact)
{
  return (exact == rtw::MASK_LIT && is < rtw::MASK_AVERTED) ||
    (exact == rtw::MASK_SHADOW && is > rtw::MASK_AVERTED);
}

std::vector<float> DrawnDepths(vtkRenderWindow* window, const rtw::Truth& truth)
{
  const std::unique_ptr<float[]> depths(
    window->GetZbufferData(0, 0, truth.Width - 1, truth.Height - 1));
  return std::vector<float>(depths.get(), depths.get() + truth.Mask.size());
}

class Sorter
{
public:
  Sorter(const rtw::Truth& truth, const rtw::ShadowReference& reference, vtkLight* light)
    : Truth(truth)
    , Reference(reference)
    , Light(light)
  {
  }

  void Sort(std::size_t pixel, bool isDark, rtwWrongPixels& sorted)
  {
    this->Pixel = pixel;
    this->Mask = isDark ? rtw::MASK_SHADOW : rtw::MASK_LIT;
    if (this->IsOtherSurface())
    {
      ++sorted.OtherSurface;
    }
    else if (this->IsAtEdge())
    {
      ++sorted.AtEdge;
    }
    else if (this->IsNearSurface())
    {
      ++sorted.NearSurface;
    }
    else
    {
      ++sorted.Unexplained;
    }
  }

private:
  // Whether it is so of any of the rays around the pixel's centre, up to so far off.
  template <class Condition>
  bool IsSoAround(double farthest, Condition isSo) const
  {
    for (double radius = Nearest; radius <= farthest; radius *= 2)
    {
      for (int k = 0; k < Directions; ++k)
      {
        const double angle = 2 * vtkMath::Pi() * k / Directions;
        const glm::dvec2 aside(radius * std::cos(angle), radius * std::sin(angle));
        if (isSo(this->At(aside, 1)))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool IsOtherSurface() const
  {
    return this->IsSoAround(OtherWithin, [this](const rtw::Look& look) {
      return !this->IsSameSurface(look) &&
        (look.Mask == this->Mask || look.Mask == rtw::MASK_AVERTED);
    });
  }

  bool IsAtEdge() const
  {
    return this->IsSoAround(EdgeWithin, [this](const rtw::Look& look) {
      return this->IsSameSurface(look) && look.Mask == this->Mask;
    });
  }

  bool IsNearSurface() const
  {
    return std::any_of(std::begin(Clearances), std::end(Clearances),
      [this](double clearance) { return this->At(glm::dvec2(0), clearance).Mask == this->Mask; });
  }

  bool IsSameSurface(const rtw::Look& look) const
  {
    return std::abs(look.Depth - this->Truth.Depth[this->Pixel]) < SameSurface;
  }

  rtw::Look At(const glm::dvec2& aside, double clearance) const
  {
    const glm::dvec2 centre(
      double(this->Pixel % this->Truth.Width) + 0.5, double(this->Pixel / this->Truth.Width) + 0.5);
    return this->Reference.At(
      this->Light, this->Truth.Width, this->Truth.Height, centre + aside, clearance);
  }

  const rtw::Truth& Truth;
  const rtw::ShadowReference& Reference;
  vtkLight* Light;
  std::size_t Pixel = 0;
  rtw::MaskValue Mask = rtw::MASK_LIT;
};
}

int rtwCountOtherSurfaces(
  vtkRenderWindow* window, const std::vector<unsigned char>& mask, const rtw::Truth& truth)
{
  const std::vector<float> drawn = DrawnDepths(window, truth);
  int others = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    others += IsWrong(mask[i], truth.Mask[i]) && std::abs(drawn[i] - truth.Depth[i]) > SameDepth;
  }
  return others;
}

rtwWrongPixels rtwSortWrongPixels(const std::vector<unsigned char>& mask, const rtw::Truth& truth,
  const rtw::ShadowReference& reference, vtkLight* light)
{
  rtwWrongPixels sorted;
  Sorter sorter(truth, reference, light);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (IsWrong(mask[i], truth.Mask[i]))
    {
      sorter.Sort(i, mask[i] < rtw::MASK_AVERTED, sorted);
    }
  }
  return sorted;
}
