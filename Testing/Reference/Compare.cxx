// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCompare.h"

#include <vtkImageData.h>

#include <algorithm>
#include <stdexcept>

namespace rtw
{
namespace
{
using Flags = std::vector<char>;

bool FacesLight(unsigned char truth)
{
  return truth == MASK_LIT || truth == MASK_SHADOW;
}

bool Differ(unsigned char a, unsigned char b)
{
  return FacesLight(a) && FacesLight(b) && a != b;
}

// The pixels on either side of each edge of a shadow.
Flags Edges(const Truth& truth)
{
  Flags edges(truth.Mask.size(), 0);
  const size_t width = truth.Width;
  const auto mark = [&](size_t i, size_t j) {
    if (Differ(truth.Mask[i], truth.Mask[j]))
    {
      edges[i] = edges[j] = 1;
    }
  };
  for (size_t i = 0; i < edges.size(); ++i)
  {
    if (i % width > 0)
    {
      mark(i - 1, i);
    }
    if (i >= width)
    {
      mark(i - width, i);
    }
  }
  return edges;
}

// Spreads flags by a number of pixels along one axis, in lines of `length` pixels.
Flags Spread(const Flags& flags, size_t stride, size_t length, int reach)
{
  Flags spread(flags.size(), 0);
  for (size_t i = 0; i < flags.size(); ++i)
  {
    if (flags[i])
    {
      const int at = int(i / stride % length);
      const int first = std::max(at - reach, 0), last = std::min(at + reach, int(length) - 1);
      for (int k = first; k <= last; ++k)
      {
        spread[i + size_t(k) * stride - size_t(at) * stride] = 1;
      }
    }
  }
  return spread;
}

void CheckSize(const std::vector<unsigned char>& mask, const Truth& truth)
{
  if (mask.size() != truth.Mask.size())
  {
    throw std::invalid_argument("the mask has " + std::to_string(mask.size()) +
      " pixels, but the truth has " + std::to_string(truth.Mask.size()));
  }
}
}

std::vector<char> NearEdges(const Truth& truth, int reach)
{
  return Spread(
    Spread(Edges(truth), 1, truth.Width, reach), size_t(truth.Width), truth.Height, reach);
}

ShadowErrors& ShadowErrors::operator+=(const ShadowErrors& other)
{
  this->LitFacing += other.LitFacing;
  this->Shadowed += other.Shadowed;
  this->WronglyDark += other.WronglyDark;
  this->WronglyLit += other.WronglyLit;
  this->NotComparable += other.NotComparable;
  this->FarFromEdge += other.FarFromEdge;
  this->DarkFarFromEdge += other.DarkFarFromEdge;
  this->AtEdge += other.AtEdge;
  return *this;
}

ShadowErrors Compare(const std::vector<unsigned char>& mask, const Truth& truth)
{
  CheckSize(mask, truth);
  const Flags edges = Edges(truth);
  const Flags nearEdge = NearEdges(truth, 2);
  ShadowErrors errors;
  for (size_t i = 0; i < mask.size(); ++i)
  {
    if (!FacesLight(truth.Mask[i]))
    {
      continue;
    }
    const bool isShadowed = truth.Mask[i] == MASK_SHADOW;
    const bool isWronglyDark = mask[i] < MASK_AVERTED && !isShadowed;
    const bool isWronglyLit = mask[i] > MASK_AVERTED && isShadowed;
    ++errors.LitFacing;
    errors.Shadowed += isShadowed;
    errors.WronglyDark += isWronglyDark;
    errors.WronglyLit += isWronglyLit;
    errors.NotComparable += mask[i] == MASK_AVERTED;
    errors.FarFromEdge += (isWronglyDark || isWronglyLit) && !nearEdge[i];
    errors.DarkFarFromEdge += isWronglyDark && !nearEdge[i];
    errors.AtEdge += edges[i] != 0;
  }
  return errors;
}

vtkSmartPointer<vtkImageData> DifferenceImage(
  const std::vector<unsigned char>& mask, const Truth& truth)
{
  CheckSize(mask, truth);
  struct Colour
  {
    unsigned char R, G, B;
  };
  const auto colour = [](unsigned char is, unsigned char shouldBe) -> Colour {
    switch (shouldBe)
    {
      case MASK_LIT:
        return is < MASK_AVERTED ? Colour{ 230, 0, 0 }
          : is == MASK_AVERTED   ? Colour{ 0, 90, 255 }
                                 : Colour{ 235, 235, 235 };
      case MASK_SHADOW:
        return is > MASK_AVERTED ? Colour{ 255, 150, 0 }
          : is == MASK_AVERTED   ? Colour{ 0, 90, 255 }
                                 : Colour{ 90, 90, 90 };
      case MASK_AVERTED:
        return { 160, 160, 160 };
      default:
        return { 190, 205, 225 };
    }
  };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(truth.Width, truth.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<Colour*>(image->GetScalarPointer());
  std::transform(mask.begin(), mask.end(), truth.Mask.begin(), pixels, colour);
  return image;
}

vtkSmartPointer<vtkImageData> MaskImage(
  const std::vector<unsigned char>& mask, int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::copy(mask.begin(), mask.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  return image;
}

std::vector<unsigned char> MaskOf(vtkImageData* image)
{
  const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
  const int components = image->GetNumberOfScalarComponents();
  std::vector<unsigned char> mask(size_t(image->GetNumberOfPoints()));
  for (size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = pixels[i * components];
  }
  return mask;
}
}
