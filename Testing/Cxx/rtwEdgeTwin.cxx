// SPDX-License-Identifier: BSD-3-Clause
#include "rtwEdgeTwin.h"

#include "rtwCompare.h"
#include "rtwMapTexels.h"
#include "rtwReference.h"

#include "vtkAdaptiveShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
constexpr double WrongPerPixel = 0.148; // as in rtwErrorPrediction.cxx

class MaskEdges
{
public:
  explicit MaskEdges(vtkImageData* mask)
    : Width(mask->GetDimensions()[0])
    , Height(mask->GetDimensions()[1])
    , Values(MaskOf(mask))
  {
  }

  // 0 in shadow, 1 lit, 0.5 neither.
  double Decision(int x, int y) const
  {
    const int inside =
      std::clamp(y, 0, this->Height - 1) * this->Width + std::clamp(x, 0, this->Width - 1);
    const unsigned char value = this->Values[std::size_t(inside)];
    return value < 128 ? 0.0 : value > 128 ? 1.0 : 0.5;
  }

  bool IsBeside(int x, int y) const
  {
    const auto differs = [&](int u, int v) {
      return std::abs(this->Decision(x + u, y + v) - this->Decision(x, y)) == 1;
    };
    return differs(1, 0) || differs(-1, 0) || differs(0, 1) || differs(0, -1);
  }

  glm::dvec2 Normal(int x, int y) const
  {
    glm::dvec2 gradient(0);
    for (int v = -2; v <= 2; ++v)
    {
      for (int u = -2; u <= 2; ++u)
      {
        const double there = this->Decision(x + u, y + v);
        gradient += glm::dvec2(u, v) * (there == 0.5 ? this->Decision(x, y) : there) *
          std::exp(-0.5 * (u * u + v * v));
      }
    }
    const double size = glm::length(gradient);
    return size > 1e-4 ? gradient / size : glm::dvec2(0);
  }

  int CountDecided() const
  {
    return int(std::count_if(
      this->Values.begin(), this->Values.end(), [](unsigned char value) { return value != 128; }));
  }

  const int Width, Height;

private:
  const std::vector<unsigned char> Values;
};

// By place, a function of the world, and that of the steps to the next pixels, over a fraction of
// them.
template <class Function>
std::vector<TurnSample> SamplesOf(
  vtkRenderer* renderer, vtkLight* light, const MaskEdges& edges, const Function& place)
{
  constexpr double fraction = 1.0 / 64;
  std::vector<TurnSample> samples;
  for (const ViewSample& s : ShadowReference(renderer).Samples(light, edges.Width, edges.Height))
  {
    const int x = int(s.Pixel) % edges.Width, y = int(s.Pixel) / edges.Width;
    const auto step = [&](const glm::dvec3& by) {
      return (place(s.Position + fraction * by) - place(s.Position - fraction * by)) /
        (2 * fraction);
    };
    TurnSample sample{ place(s.Position), step(s.ToRight), step(s.ToAbove) };
    sample.AtEdge = edges.IsBeside(x, y);
    sample.Normal = sample.AtEdge ? edges.Normal(x, y) : glm::dvec2(0);
    samples.push_back(sample);
  }
  return samples;
}
}

double PredictedErrorTwin(
  vtkRenderer* renderer, vtkAdaptiveShadowMapPass* pass, vtkLight* light, int index)
{
  const MaskEdges edges(pass->GetShadowMask(index));
  double error = 0;
  for (const TurnSample& s : SamplesOf(renderer, light, edges, TexelsOf(pass, index)))
  {
    error += s.AtEdge ? Misplacement(s, glm::dvec2(1)) : 0.0;
  }
  return std::min(WrongPerPixel * error / edges.CountDecided(), 1.0);
}

std::vector<TurnSample> TurnSamplesOf(
  vtkRenderer* renderer, vtkAdaptiveShadowMapPass* pass, vtkLight* light, int index)
{
  vtkNew<vtkMatrix4x4> matrix;
  pass->GetLightPlaneMatrix(index, 0, matrix);
  const auto row = [&](int i) {
    return glm::dvec3(matrix->GetElement(i, 0), matrix->GetElement(i, 1), matrix->GetElement(i, 2));
  };
  // The focus has another extent along each axis; the light plane is the same along both. The last
  // row is a spot's axis.
  const auto across = [&](
                        int i) { return glm::length(row(i) - glm::dot(row(i), row(3)) * row(3)); };
  const double t = across(0) / across(1);
  return SamplesOf(
    renderer, light, MaskEdges(pass->GetShadowMask(index)), [&](const glm::dvec3& world) {
      const double p[4] = { world.x, world.y, world.z, 1 };
      double q[4];
      matrix->MultiplyPoint(p, q);
      return glm::dvec2(q[0], t * q[1]) / q[3];
    });
}
}
