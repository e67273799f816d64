// SPDX-License-Identifier: BSD-3-Clause
// Debug views change no maps and no shaders; bad values, multisampling, and what else a
// frame can be.
#include "rtwDebugViews.h"

#include "vtkAxesActor.h"
#include "vtkImageData.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowMapWarp.h"
#include "vtkTransform.h"

#include <algorithm>

namespace
{
using Pass = vtkAdaptiveShadowMapPass;
const int VIEWS[] = { Pass::SHADOW, Pass::ALIASING_ERROR, Pass::IMPORTANCE, Pass::WARP_GRID,
  Pass::LAYERS };

vtkSmartPointer<vtkImageData> Draw(rtwShadowStage& stage)
{
  stage.Render();
  return rtwGrab(stage.Window);
}

// Of the pixels, in percent.
double Differ(vtkImageData* a, vtkImageData* b, int channel = 6)
{
  const int* size = a->GetDimensions();
  int differ = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto p = rtwPixel(a, x, y), q = rtwPixel(b, x, y);
      int most = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(p[c] - q[c]));
      }
      differ += most > channel;
    }
  }
  return 100.0 * differ / (double(size[0]) * size[1]);
}

// A steady frame draws no map again and builds no shader, whatever is viewed.
void TestSteadyFrames(rtwTechnique technique, rtwChain chain)
{
  rtwShadowStage stage(technique, chain);
  rtwFillForDebugViews(stage);
  stage.Pass->SetResolution(256);
  const vtkSmartPointer<vtkImageData> before = Draw(stage);
  const int builds = stage.Pass->GetNumberOfShaderBuilds();
  const vtkTypeInt64 memory = stage.Pass->GetShadowMemory();
  RTW_CHECK(builds > 0);
  for (const int view : VIEWS)
  {
    stage.Pass->SetDebugView(view);
    vtkSmartPointer<vtkImageData> first;
    for (int light = 0; light < 2; ++light)
    {
      stage.Pass->SetDebugLight(light);
      const vtkSmartPointer<vtkImageData> picture = Draw(stage);
      RTW_CHECK(Differ(picture, before) > 5);
      RTW_CHECK(!first || Differ(picture, first) > 5);
      first = picture;
      RTW_CHECK_EQUAL(Differ(Draw(stage), picture, 0), 0);
      RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0);
      RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 2);
    }
  }
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShaderBuilds(), builds);
  RTW_CHECK_EQUAL(stage.Pass->GetShadowMemory(), memory);
  stage.Pass->SetDebugViewToNone();
  RTW_CHECK_EQUAL(Differ(Draw(stage), before, 0), 0);
}

std::vector<float> ValuesOf(vtkImageData* image)
{
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  return { values, values + image->GetNumberOfPoints() * image->GetNumberOfScalarComponents() };
}

// The same frames of two stages, one with debug views.
class Twins
{
public:
  Twins(int samples, int source)
  {
    for (rtwShadowStage* stage : { &this->Plain, &this->Viewed })
    {
      rtwFillForDebugViews(*stage);
      stage->Window->SetMultiSamples(samples);
      stage->Pass->SetViewSampleSource(source);
      stage->Pass->SetResolution(256);
      stage->Pass->CachingOff();
      auto* warped = vtkRTWShadowMapPass::SafeDownCast(stage->Pass);
      warped->SetImportance(vtkRTWShadowMapPass::SQRT_DEMAND | vtkRTWShadowMapPass::SHADOW_EDGE);
    }
  }

  rtwShadowStage Plain, Viewed;
};

// Not even where a view needs a mask that the picture doesn't, and importance would look at it.
void TestMapsStay(int samples, int source)
{
  Twins twins(samples, source);
  for (const int view : VIEWS)
  {
    twins.Viewed.Pass->SetDebugView(view);
    twins.Plain.Render();
    twins.Viewed.Render();
    const bool same =
      ValuesOf(twins.Plain.Pass->GetWarpImage(1)) == ValuesOf(twins.Viewed.Pass->GetWarpImage(1));
    RTW_CHECK(same);
  }
}

// In a window with several samples a pixel only what is seen of the edges of receivers differs.
void TestMultiSamples()
{
  rtwShadowStage stage;
  rtwFillForDebugViews(stage);
  vtkSmartPointer<vtkImageData> single[5];
  for (int i = 0; i < 5; ++i)
  {
    stage.Pass->SetDebugView(VIEWS[i]);
    single[i] = Draw(stage);
  }
  stage.Window->SetMultiSamples(4);
  for (int i = 0; i < 5; ++i)
  {
    stage.Pass->SetDebugView(VIEWS[i]);
    const double differ = Differ(Draw(stage), single[i], 40);
    std::cout << "view " << VIEWS[i] << ", multisampled: " << differ << " % of the pixels differ"
              << std::endl;
    RTW_CHECK(differ < 1.5);
  }
  std::cout << "samples: " << stage.Window->GetMultiSamples() << std::endl;
}

// As from a prepass, but for the focus' margin.
void TestPreviousFrame()
{
  rtwShadowStage stage;
  rtwFillForDebugViews(stage);
  stage.Pass->SetDebugViewToShadow();
  const vtkSmartPointer<vtkImageData> picture = Draw(stage);
  stage.Pass->SetViewSampleSourceToPreviousFrame();
  stage.Pass->CachingOff();
  for (int frame = 0; frame < 3; ++frame)
  {
    const double differ = Differ(Draw(stage), picture);
    std::cout << "of the previous frame: " << differ << " % of the pixels differ" << std::endl;
    RTW_CHECK(differ < 1);
  }
}

void TestBadValues()
{
  rtwShadowStage stage;
  {
    rtwMessageCatcher messages(stage.Pass);
    stage.Pass->SetDebugViewToWarpGrid();
    stage.Pass->SetDebugView(7);
    stage.Pass->SetDebugView(-1);
    RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 2);
    RTW_CHECK(messages.GetText().find("SetDebugView(7): expected NONE") != std::string::npos);
    RTW_CHECK_EQUAL(stage.Pass->GetDebugView(), int(Pass::WARP_GRID));
    stage.Pass->SetDebugLight(1);
    stage.Pass->SetDebugLight(-1);
    RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 3);
    RTW_CHECK(messages.GetText().find("SetDebugLight(-1): expected a light") != std::string::npos);
    RTW_CHECK_EQUAL(stage.Pass->GetDebugLight(), 1);
  }
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(0) == nullptr);
  rtwMessageCatcher messages(stage.Pass);
  stage.Render(); // nothing there
  rtwFillForDebugViews(stage);
  stage.Pass->SetDebugViewToAliasingError();
  const vtkSmartPointer<vtkImageData> last = Draw(stage);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 0);
  stage.Pass->SetDebugLight(7);
  RTW_CHECK_EQUAL(Differ(Draw(stage), last, 0), 0);
  stage.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK(messages.GetText().find("DebugLight 7 is more") != std::string::npos);
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(1) != nullptr);
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(2) == nullptr);
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(-1) == nullptr);
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(0) == nullptr);
  RTW_CHECK_EQUAL(Differ(Draw(stage), last, 0), 0);
  stage.Renderer->RemoveAllLights();
  stage.Render();
  RTW_CHECK(stage.Pass->GetAliasingErrorImage(0) == nullptr);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
}

// What no view sample knows of, and hides receivers, stays as it is.
void TestForeignProps()
{
  rtwShadowStage stage;
  rtwFillForDebugViews(stage);
  const vtkSmartPointer<vtkImageData> without = Draw(stage);
  vtkNew<vtkAxesActor> axes;
  vtkNew<vtkTransform> above; // all else
  above->Translate(-1, 2.5, 1);
  axes->SetUserTransform(above);
  axes->SetTotalLength(3, 3, 3);
  axes->SetShaftTypeToCylinder();
  axes->AxisLabelsOff();
  stage.Renderer->AddActor(axes);
  const vtkSmartPointer<vtkImageData> with = Draw(stage);
  stage.Pass->SetDebugViewToShadow();
  const vtkSmartPointer<vtkImageData> viewed = Draw(stage);
  int ofAxes = 0, painted = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 300; ++x)
    {
      const auto p = rtwPixel(with, x, y), q = rtwPixel(viewed, x, y);
      // They alone have colours, but for the cones, which are not as bright.
      const auto range = std::minmax({ p[0], p[1], p[2] });
      const bool isAxis = range.second > 100 && range.first == 0 && p != rtwPixel(without, x, y);
      ofAxes += isAxis;
      painted += isAxis && p != q;
    }
  }
  std::cout << painted << " of " << ofAxes << " pixels of axes are painted over" << std::endl;
  RTW_CHECK(ofAxes > 300);
  RTW_CHECK_EQUAL(painted, 0);
}

// Each of two warps has a program of its own.
void TestWarpChanges()
{
  rtwShadowStage rtw, uniform(rtwTechnique::Uniform);
  rtwFillForDebugViews(rtw);
  rtwFillForDebugViews(uniform);
  rtw.Pass->SetDebugViewToAliasingError();
  uniform.Pass->SetDebugViewToAliasingError();
  const vtkSmartPointer<vtkImageData> warped = Draw(rtw), plain = Draw(uniform);
  vtkSmartPointer<vtkShadowMapWarp> warp = rtw.Pass->GetWarp();
  rtw.Pass->SetWarp(uniform.Pass->GetWarp());
  RTW_CHECK_EQUAL(Differ(Draw(rtw), plain, 2), 0);
  RTW_CHECK(Differ(warped, plain) > 20);
  rtw.Pass->SetWarp(warp);
  RTW_CHECK_EQUAL(Differ(Draw(rtw), warped, 2), 0);
}
}

int TestDebugViewFrames(int, char*[])
{
  TestSteadyFrames(rtwTechnique::RTW, rtwChain::Steps);
  TestSteadyFrames(rtwTechnique::Uniform, rtwChain::Classic);
  TestMapsStay(0, Pass::PREPASS);
  TestMapsStay(4, Pass::PREPASS);
  TestMapsStay(0, Pass::PREVIOUS_FRAME);
  TestMultiSamples();
  TestPreviousFrame();
  TestBadValues();
  TestForeignProps();
  TestWarpChanges();
  return rtwTestResult();
}
