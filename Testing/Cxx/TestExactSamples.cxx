// SPDX-License-Identifier: BSD-3-Clause
// Exact shadows in windows with several samples a pixel: each sample has its own surface and its
// own shadow, and each surface takes the shadows of its samples. Beside one exact ray a sample.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkExactShadowMapPass.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
// Rasterizers put four samples into the pixel's sixteenths so that each is the centre of a pixel of
// a picture that is four times as wide: its column, for each row from one side. Drivers count rows
// from either.
constexpr int Finer = 4;
constexpr int Columns[] = { 1, 3, 0, 2 };

struct Stage : rtwShadowStage
{
  explicit Stage(const char* name, rtwChain chain = rtwChain::Steps)
    : rtwShadowStage(rtwTechnique::Exact, chain)
  {
    this->Name = name;
    this->Options.Sharp = true;
    this->Window->SetMultiSamples(4);
  }

  // What light 0's exact mask is with those samples.
  rtw::Truth TraceFinely(vtkLight* light)
  {
    const int* size = this->Renderer->GetSize();
    return rtw::ShadowReference(this->Renderer, this->Options)
      .Trace(light, Finer * size[0], Finer * size[1]);
  }
};

struct Place
{
  int X, Y;
};

Place SampleOf(int x, int y, int row, bool flipped)
{
  return { Finer * x + Columns[row], Finer * y + (flipped ? Finer - 1 - row : row) };
}

// Pixels whose share of samples in the light isn't that of the rays, in percent of those that have
// any that faces the light.
double WrongPercent(const std::vector<unsigned char>& mask, const rtw::Truth& truth, bool flipped)
{
  const int width = truth.Width / Finer, height = truth.Height / Finer;
  int facing = 0, wrong = 0;
  for (int i = 0; i < width * height; ++i)
  {
    int lit = 0, seen = 0;
    for (int row = 0; row < Finer; ++row)
    {
      const Place at = SampleOf(i % width, i / width, row, flipped);
      const unsigned char exact = truth.Mask[std::size_t(at.Y) * truth.Width + at.X];
      lit += exact == rtw::MASK_LIT;
      seen += exact == rtw::MASK_LIT || exact == rtw::MASK_SHADOW;
    }
    facing += seen > 0;
    const double expected = seen > 0 ? double(lit) / seen : 0;
    wrong += seen > 0 && std::abs(mask[i] / 255.0 - expected) > 0.03;
  }
  return 100.0 * wrong / std::max(facing, 1);
}

// The picture without shadows, sample by sample, each as bright as its ray says.
std::vector<double> ExpectedPicture(Stage& stage, vtkLight* light, bool flipped)
{
  const rtw::Truth truth = stage.TraceFinely(light);
  const int width = truth.Width / Finer, height = truth.Height / Finer;
  stage.UsePass(false);
  stage.Window->SetMultiSamples(0);
  stage.Window->SetSize(truth.Width, truth.Height);
  stage.Window->Render();
  const vtkSmartPointer<vtkImageData> fine = rtwGrab(stage.Window);
  stage.Window->SetSize(width, height);
  stage.Window->SetMultiSamples(4);
  stage.UsePass(true);
  std::vector<double> expected;
  for (int i = 0; i < width * height; ++i)
  {
    double sum[3] = {};
    for (int row = 0; row < Finer; ++row)
    {
      const Place at = SampleOf(i % width, i / width, row, flipped);
      const bool dark = truth.Mask[std::size_t(at.Y) * truth.Width + at.X] == rtw::MASK_SHADOW;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += dark ? 0 : rtwPixel(fine, at.X, at.Y)[c] / double(Finer);
      }
    }
    expected.insert(expected.end(), sum, sum + 3);
  }
  return expected;
}

// Percent of the pixels that differ by more than shading at another place of the pixel may.
double DifferingPercent(vtkImageData* picture, const std::vector<double>& expected)
{
  const int width = picture->GetDimensions()[0];
  const int pixels = static_cast<int>(expected.size() / 3);
  int differing = 0;
  for (int i = 0; i < pixels; ++i)
  {
    const std::array<int, 3> actual = rtwPixel(picture, i % width, i / width);
    double most = 0;
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(most, std::abs(actual[c] - expected[3 * i + c]));
    }
    differing += most > 16;
  }
  return 100.0 * differing / pixels;
}

// Which way the driver counts: the other way round a quarter of the edge is wrong.
bool IsFlipped(const std::vector<unsigned char>& mask, const rtw::Truth& truth)
{
  return WrongPercent(mask, truth, true) < WrongPercent(mask, truth, false);
}

void CheckMask(Stage& stage, vtkLight* light, int index, double most)
{
  const rtw::Truth truth = stage.TraceFinely(light);
  const std::vector<unsigned char> mask = stage.GetMask(index);
  const double wrong = WrongPercent(mask, truth, IsFlipped(mask, truth));
  std::cout << stage.Name << ", light " << index << ": " << wrong << " % of the pixels wrong"
            << std::endl;
  RTW_CHECK(wrong < most);
}

void CheckPicture(Stage& stage, vtkLight* light, double most)
{
  const rtw::Truth truth = stage.TraceFinely(light);
  const bool flipped = IsFlipped(stage.GetMask(0), truth);
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(stage.Window);
  const double differ = DifferingPercent(picture, ExpectedPicture(stage, light, flipped));
  std::cout << stage.Name << ": " << differ << " % of the picture's pixels differ" << std::endl;
  RTW_CHECK(differ < most);
}

// Edges of receivers where both sides face the light and each has another shadow: lit boxes and a
// ball before their shadows on the floor, and boxes in shadow before a lit floor.
void AddEdges(Stage& stage)
{
  stage.AddFloor();
  stage.AddBall(-1.2, 1.1, 0, 1, 60)->GetProperty()->SetColor(1, 0.6, 0.3);
  stage.AddBox(1.8, 0.6, -0.5, 1.2)->GetProperty()->SetColor(0.4, 0.7, 1);
  stage.AddBox(0.4, 0.3, 1.6, 0.6)->GetProperty()->SetColor(0.5, 0.9, 0.5);
  stage.AddBox(1, 1.4, 2.6, 0.8)->GetProperty()->SetColor(1, 0.9, 0.4);
}

vtkLight* AddLight(Stage& stage)
{
  return stage.AddSun(2, 4, 3.5);
}

bool HasFourSamples(Stage& stage)
{
  return stage.Window->GetMultiSamples() == 4;
}

void TestLights(rtwChain chain, int argc, char* argv[])
{
  Stage stage(chain == rtwChain::Classic ? "lights classic" : "lights steps", chain);
  AddEdges(stage);
  vtkLight* sun = AddLight(stage);
  stage.Render();
  RTW_CHECK(stage.Pass->GetShadowMapImage(0) == nullptr);
  CheckMask(stage, sun, 0, 0.05);
  rtwCompareWithBaseline(stage.Window, argc, argv);
  CheckPicture(stage, sun, 0.05);
  stage.Render();
  CheckMask(stage, sun, 0, 0.05);
  vtkLight* spot = stage.AddSpot(3, 7, 2, 40);
  stage.Render();
  CheckMask(stage, sun, 0, 0.05);
  CheckMask(stage, spot, 1, 0.05);
}

void TestParallel()
{
  Stage stage("parallel");
  AddEdges(stage);
  vtkLight* sun = AddLight(stage);
  stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
  stage.Renderer->GetActiveCamera()->SetParallelScale(3);
  stage.Render();
  CheckMask(stage, sun, 0, 0.05);
  CheckPicture(stage, sun, 0.05);
}

// What mappers draw has its samples too, and casts by a map; exact rays see as many boxes.
void TestGlyphs()
{
  Stage stage("glyphs");
  AddEdges(stage);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-2.6, 0.3, 2);
  points->InsertNextPoint(2.6, 0.3, 1.5);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkCubeSource> cube;
  cube->SetYLength(0.6);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceConnection(cube->GetOutputPort());
  vtkNew<vtkActor> boxes;
  boxes->SetMapper(glyphs);
  stage.Renderer->AddActor(boxes);
  vtkLight* sun = AddLight(stage);
  stage.Render();
  CheckMask(stage, sun, 0, 0.5);
  CheckPicture(stage, sun, 0.1);
}

// Translucent receivers look up maps.
void TestTranslucent()
{
  Stage stage("translucent");
  AddEdges(stage);
  stage.AddBox(-1.5, 0.5, 1.5, 1)->GetProperty()->SetOpacity(0.5);
  vtkLight* sun = AddLight(stage);
  stage.Render();
  CheckMask(stage, sun, 0, 0.05);
  RTW_CHECK(stage.Pass->GetShadowMapImage(0) != nullptr);
}

// A frame that outgrows its memory takes the mask's word for all of a pixel.
void TestMemoryBound()
{
  Stage stage("memory bound");
  stage.AddFloor();
  stage.AddBall(0, 1.5, 0, 1.2, 420);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwMessageCatcher messages(stage.Pass);
  vtkExactShadowMapPass::SafeDownCast(stage.Pass)->SetMemoryBound(0);
  stage.Render();
  CheckPicture(stage, sun, 0.5);
  for (int frame = 0; frame < 10; ++frame)
  {
    stage.Render();
  }
  CheckMask(stage, sun, 0, 0.05);
  CheckPicture(stage, sun, 0.05);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
}

// To one sample a pixel and back.
void TestSwitching()
{
  Stage stage("switching");
  AddEdges(stage);
  vtkLight* sun = AddLight(stage);
  stage.Render();
  const std::vector<unsigned char> many = stage.GetMask(0);
  stage.Window->SetMultiSamples(0);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, (rtwShadowBounds{ 0.01, 0.005, 0.1, 0.02, 2.0 }));
  RTW_CHECK_PICTURE(stage);
  stage.Window->SetMultiSamples(4);
  stage.Render();
  RTW_CHECK(stage.GetMask(0) == many);
  stage.Pass->SetDebugViewToListLengths();
  stage.Render();
  CheckMask(stage, sun, 0, 0.05);
}
}

int TestExactSamples(int argc, char* argv[])
{
  Stage first("samples");
  first.AddFloor();
  first.Render();
  if (!HasFourSamples(first))
  {
    std::cout << first.Window->GetMultiSamples() << " samples" << std::endl;
    return rtwTestSkipped;
  }
  TestLights(rtwChain::Steps, argc, argv);
  TestLights(rtwChain::Classic, argc, argv);
  TestParallel();
  TestGlyphs();
  TestTranslucent();
  TestMemoryBound();
  TestSwitching();
  return rtwTestResult();
}
