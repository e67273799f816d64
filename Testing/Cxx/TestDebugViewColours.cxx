// SPDX-License-Identifier: BSD-3-Clause
// Each pixel of a debug view has the colour that what it shows asks for, by the pass's own images;
// in a context without compute shaders too, where maps are conventional.
#include "rtwDebugViews.h"

#include "rtwMapTexels.h"

#include "vtkImageData.h"
#include "vtkLightCollection.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Pass = vtkAdaptiveShadowMapPass;
using Colour = glm::dvec3;

// As rtwDebugColours.glsl has them.
const std::vector<Colour> ALIASING{ { 0.02, 0.05, 0.35 }, { 0.10, 0.25, 0.70 },
  { 0.25, 0.50, 0.90 }, { 0.65, 0.82, 1 }, { 1, 1, 1 }, { 1, 0.80, 0.40 }, { 0.98, 0.50, 0.15 },
  { 0.80, 0.08, 0.05 }, { 0.35, 0, 0.02 } };
const std::vector<Colour> DENSITY{ { 0.05, 0.02, 0.15 }, { 0.20, 0.05, 0.36 }, { 0.42, 0.09, 0.43 },
  { 0.62, 0.17, 0.39 }, { 0.80, 0.26, 0.30 }, { 0.93, 0.42, 0.18 }, { 0.98, 0.62, 0.05 },
  { 0.96, 0.82, 0.28 }, { 0.98, 0.99, 0.75 } };
const Colour LAYERS[4] = { { 0.30, 0.62, 0.85 }, { 0.95, 0.60, 0.20 }, { 0.40, 0.75, 0.35 },
  { 0.85, 0.35, 0.55 } };
const Colour DARK{ 0.08, 0.10, 0.28 }, BRIGHT{ 1, 0.95, 0.75 }, ACROSS_S{ 0.95, 0.45, 0.05 },
  ACROSS_T{ 0.05, 0.55, 0.95 };

Colour OnScale(const std::vector<Colour>& scale, double ratio)
{
  const double octave = std::clamp(std::log2(ratio), -4.0, 4.0) + 4;
  const int below = std::min(int(octave), 7);
  return glm::mix(scale[below], scale[below + 1], octave - below);
}

double Apart(const Colour& a, const Colour& b)
{
  const Colour d = glm::abs(a - b);
  return std::max({ d.x, d.y, d.z });
}

// A stage, its debug views, and what rays find of a light.
class Views
{
public:
  Views(rtwShadowStage& stage, int light)
    : Stage(stage)
    , Light(light)
  {
    stage.Pass->SetDebugLight(light);
    stage.Render();
    const int* size = stage.Renderer->GetSize();
    this->Width = size[0];
    auto* item = stage.Renderer->GetLights()->GetItemAsObject(light);
    this->Samples =
      rtw::ShadowReference(stage.Renderer).Samples(vtkLight::SafeDownCast(item), size[0], size[1]);
    RTW_CHECK(this->Samples.size() > 5000);
  }

  vtkSmartPointer<vtkImageData> Show(int view)
  {
    this->Stage.Pass->SetDebugView(view);
    this->Stage.Render();
    return rtwGrab(this->Stage.Window);
  }

  Colour At(vtkImageData* picture, std::size_t pixel) const
  {
    const auto rgb = rtwPixel(picture, int(pixel % this->Width), int(pixel / this->Width));
    return Colour(rgb[0], rgb[1], rgb[2]) / 255.0;
  }

  // Checks the colours of the samples; `expect` gives one for the sample of that number.
  template <class Expect>
  void Check(const std::string& name, int view, Expect expect)
  {
    const vtkSmartPointer<vtkImageData> picture = this->Show(view);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < this->Samples.size(); ++i)
    {
      wrong += Apart(this->At(picture, this->Samples[i].Pixel), expect(i)) > 0.03;
    }
    const double share = 100.0 * double(wrong) / double(this->Samples.size());
    std::cout << name << " of light " << this->Light << ": " << share << " % of the pixels differ"
              << std::endl;
    RTW_CHECK(share < 0.3);
  }

  rtwShadowStage& Stage;
  int Light;
  int Width = 0;
  std::vector<rtw::ViewSample> Samples;
};

void CheckShadow(Views& views)
{
  const std::vector<unsigned char> mask = views.Stage.GetMask(views.Light);
  views.Check("shadow", Pass::SHADOW, [&](std::size_t i) {
    const int value = mask[views.Samples[i].Pixel];
    const double visible = value < 128 ? value / 254.0 : 0.5 + (value - 129) / 252.0;
    return value == 128 ? Colour(0.5) : glm::mix(DARK, BRIGHT, visible);
  });
}

void CheckAliasing(Views& views)
{
  const vtkSmartPointer<vtkImageData> image = views.Stage.Pass->GetAliasingErrorImage(views.Light);
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  views.Check("aliasing error", Pass::ALIASING_ERROR, [&](std::size_t i) {
    const float* m = values + 2 * views.Samples[i].Pixel;
    return OnScale(ALIASING, std::max(m[0], m[1]));
  });
}

// Texels over the focus, of a map with one texel a side where it is uniform.
glm::dvec2 MovesOnMap(
  const rtw::TexelFunction& texels, const glm::dvec3& at, const glm::dvec3& step)
{
  return (texels(at + 1e-4 * step) - texels(at - 1e-4 * step)) / 2e-4;
}

void CheckImportance(Views& views)
{
  const vtkSmartPointer<vtkImageData> warp = views.Stage.Pass->GetWarpImage(views.Light);
  const int cells = warp->GetDimensions()[0] - 1;
  const auto* values = static_cast<float*>(warp->GetScalarPointer());
  const rtw::TexelFunction texels = rtw::TexelsOf(views.Stage.Pass, views.Light);
  const double side = views.Stage.Pass->GetResolution();
  views.Check("importance", Pass::IMPORTANCE, [&](std::size_t i) {
    const glm::dvec2 at = texels(views.Samples[i].Position) / side;
    double area = 1;
    for (int axis = 0; axis < 2; ++axis)
    {
      const float* row = values + axis * (cells + 1);
      const auto above = std::upper_bound(row, row + cells, float(at[axis]));
      const auto cell = std::max<std::ptrdiff_t>(above - row, 1) - 1;
      area *= cells * double(row[cell + 1] - row[cell]);
    }
    return OnScale(DENSITY, std::sqrt(area));
  });
}

void CheckLayers(Views& views, int lights)
{
  const vtkSmartPointer<vtkImageData> picture = views.Show(Pass::LAYERS);
  std::size_t counts[3] = { 0, 0, 0 };
  for (const rtw::ViewSample& sample : views.Samples)
  {
    const Colour colour = views.At(picture, sample.Pixel);
    int found = 2;
    for (const int which : { 0, 1 })
    {
      // As bright as the surface faces the viewer.
      const Colour& layer = LAYERS[views.Light + which * lights];
      const double shade = glm::dot(colour, layer) / glm::dot(layer, layer);
      found = shade > 0.38 && shade < 1.02 && Apart(colour, shade * layer) < 0.01 ? which : found;
    }
    ++counts[found];
  }
  const double pixels = double(views.Samples.size());
  std::cout << "layers of light " << views.Light << ": " << counts[0] << " own, " << counts[1]
            << " of other casters, " << counts[2] << " neither" << std::endl;
  // Without a warp there is one layer for all casters.
  const bool warped = views.Stage.Pass->GetImportanceImage(views.Light) != nullptr;
  RTW_CHECK_NEAR(double(counts[0]) / pixels, warped ? 0.5 : 1.0, 0.03);
  RTW_CHECK_NEAR(double(counts[1]) / pixels, warped ? 0.5 : 0.0, 0.03);
  RTW_CHECK(double(counts[2]) < 0.005 * pixels);
}

// How far, in pixels, a sample is from the nearest line of so many, across s and t, and how dense
// those are.
struct Lines
{
  glm::dvec2 Away, Pixel;
};

Lines LinesAt(
  const rtw::ViewSample& sample, const rtw::TexelFunction& texels, double side, int count)
{
  const double scale = count / side;
  const glm::dvec2 at = scale * texels(sample.Position);
  const glm::dvec2 right = scale * MovesOnMap(texels, sample.Position, sample.ToRight);
  const glm::dvec2 above = scale * MovesOnMap(texels, sample.Position, sample.ToAbove);
  const glm::dvec2 pixel(std::hypot(right.x, above.x), std::hypot(right.y, above.y));
  return { glm::abs(at - glm::round(at)) / pixel, pixel };
}

void CheckGrid(Views& views)
{
  const vtkSmartPointer<vtkImageData> plain = views.Show(Pass::NONE);
  const vtkSmartPointer<vtkImageData> picture = views.Show(Pass::WARP_GRID);
  const rtw::TexelFunction texels = rtw::TexelsOf(views.Stage.Pass, views.Light);
  const double side = views.Stage.Pass->GetResolution();
  std::size_t on[2] = { 0, 0 }, wrong[2] = { 0, 0 }, off = 0, painted = 0;
  for (const rtw::ViewSample& sample : views.Samples)
  {
    const Colour colour = views.At(picture, sample.Pixel);
    const Lines wide = LinesAt(sample, texels, side, 8), thin = LinesAt(sample, texels, side, 64);
    for (const int axis : { 0, 1 })
    {
      if (wide.Away[axis] < 0.7 && wide.Pixel[axis] < 0.2 && wide.Away[1 - axis] > 3 &&
        thin.Away[1 - axis] > 1.5)
      {
        ++on[axis];
        wrong[axis] += Apart(colour, axis == 0 ? ACROSS_S : ACROSS_T) > 0.03;
      }
    }
    if (thin.Away.x > 1.1 && thin.Away.y > 1.1 && wide.Away.x > 1.9 && wide.Away.y > 1.9)
    {
      ++off;
      painted += Apart(colour, views.At(plain, sample.Pixel)) > 0.02;
    }
  }
  std::cout << "grid of light " << views.Light << ": " << wrong[0] << " of " << on[0]
            << " pixels on wide lines across s are wrong, " << wrong[1] << " of " << on[1]
            << " across t, " << painted << " of " << off << " off them" << std::endl;
  for (const int axis : { 0, 1 })
  {
    RTW_CHECK(on[axis] > 100);
    RTW_CHECK(double(wrong[axis]) < 0.02 * double(on[axis]));
  }
  RTW_CHECK(off > 500);
  RTW_CHECK(double(painted) < 0.005 * double(off));
}

// What is turned away is grey, and what is no receiver has its colours.
void CheckOthers(Views& views)
{
  const vtkSmartPointer<vtkImageData> plain = views.Show(Pass::NONE);
  const std::vector<unsigned char> mask = views.Stage.GetMask(views.Light);
  for (const int view : { Pass::SHADOW, Pass::ALIASING_ERROR, Pass::IMPORTANCE, Pass::LAYERS })
  {
    const vtkSmartPointer<vtkImageData> picture = views.Show(view);
    std::size_t grey = 0, other = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      const Colour colour = views.At(picture, i);
      const bool isGrey = Apart(colour, Colour(0.5)) < 0.01;
      grey += mask[i] == rtw::MASK_AVERTED && isGrey;
      other += mask[i] == rtw::MASK_AVERTED && !isGrey && Apart(colour, views.At(plain, i)) > 0.01;
    }
    std::cout << "view " << view << " of light " << views.Light << ": " << grey
              << " averted pixels are grey, " << other << " are neither that nor as drawn"
              << std::endl;
    RTW_CHECK(grey > 200);
    RTW_CHECK(other < mask.size() / 1000);
  }
}
}

int TestDebugViewColours(int, char*[])
{
  rtwShadowStage stage;
  rtwFillForDebugViews(stage);
  stage.Renderer->GetActors()->GetLastActor()->VisibilityOff(); // the translucent ball
  stage.Window->SetSize(450, 300);
  for (const int light : { 0, 1 })
  {
    Views views(stage, light);
    CheckShadow(views);
    CheckAliasing(views);
    CheckImportance(views);
    CheckLayers(views, 2);
    CheckGrid(views);
    CheckOthers(views);
  }
  return rtwTestResult();
}
