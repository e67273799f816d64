// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowRenderStepsPass draws the whole frame: translucent props, volumes, overlays and what
// comes after.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkToneMappingPass.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace
{
vtkShadowRenderStepsPass* StepsOf(rtwShadowStage& stage)
{
  return vtkShadowRenderStepsPass::SafeDownCast(stage.Renderer->GetPass());
}

// The grey of a pixel of the last picture.
int Grey(rtwShadowStage& stage, int x, int y)
{
  return rtwPixel(rtwGrab(stage.Window), x, y)[0];
}

// Floor, ball that throws a shadow, and a translucent sheet that lies between the two. From above,
// so that places are known: the picture shows -3 to 3 in height.
void AddSheet(rtwShadowStage& stage)
{
  stage.AddFloor();
  stage.AddBall(0, 3, 0, 0.8);
  vtkNew<vtkPlaneSource> sheet; // covers the right half
  sheet->SetOrigin(0, 1, 3);
  sheet->SetPoint1(4, 1, 3);
  sheet->SetPoint2(0, 1, -3);
  vtkActor* actor = stage.Add(sheet);
  actor->GetProperty()->SetOpacity(0.5);
  actor->GetProperty()->SetColor(1, 0, 0);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAdaptiveShadowMapPass::CASTS_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0, 20, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, -1);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(3);
}

// Where x, z of the world are in such a picture.
std::array<int, 3> At(rtwShadowStage& stage, double x, double z)
{
  return rtwPixel(rtwGrab(stage.Window), int(150 + x * 100 / 3), int(100 - z * 100 / 3));
}

void CheckSheet(rtwShadowStage& stage)
{
  stage.AddSun(
    -1, 1, 0); // at 45 degrees: the shadow is 3 to the right on the floor, 2 on the sheet
  stage.Render();
  const int lit = At(stage, -2, 2)[0];
  RTW_CHECK_NEAR(lit, 255 * std::sqrt(0.5), 6);
  // Lit sheet over lit floor, lit sheet over the floor's shadow, and the sheet's own over lit
  // floor.
  const auto both = At(stage, 1, 2), below = At(stage, 3, 0.6), above = At(stage, 1.5, 0);
  std::cout << stage.Name << ": lit " << lit << ", sheet " << both[0] << " " << both[1]
            << ", over shadow " << below[0] << " " << below[1] << ", in shadow " << above[0] << " "
            << above[1] << std::endl;
  RTW_CHECK_NEAR(both[0], lit, 6);
  RTW_CHECK_NEAR(both[1], 0.5 * lit, 6);
  RTW_CHECK_NEAR(below[0], 0.5 * lit, 6);
  RTW_CHECK_NEAR(below[1], 0, 6);
  RTW_CHECK_NEAR(above[0], 0.5 * lit, 6);
  RTW_CHECK_NEAR(above[1], 0.5 * lit, 6);
}

void TestTranslucent(int argc, char* argv[])
{
  rtwShadowStage plain;
  plain.Name = "translucent";
  AddSheet(plain);
  CheckSheet(plain);
  rtwCompareWithBaseline(plain.Window, argc, argv);

  rtwShadowStage peeled;
  peeled.Name = "depth peeling";
  peeled.Renderer->UseDepthPeelingOn();
  peeled.Renderer->SetMaximumNumberOfPeels(10);
  AddSheet(peeled);
  CheckSheet(peeled);
}

void TestVolume()
{
  rtwShadowStage stage;
  stage.Name = "volume";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 8);
  image->SetSpacing(0.15, 0.15, 0.15);
  image->SetOrigin(1, 1.6, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 512, 200);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetRequestedRenderModeToGPU();
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0, 0, 0, 1);
  colours->AddRGBPoint(255, 0, 0, 1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, 1);
  opacities->AddPoint(255, 1);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colours);
  volume->GetProperty()->SetScalarOpacity(opacities);
  stage.Renderer->AddVolume(volume);
  stage.Render();
  int blue = 0;
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(stage.Window);
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 300; ++x)
    {
      const auto p = rtwPixel(picture, x, y);
      blue += p[2] > 100 && p[0] < 60;
    }
  }
  std::cout << "volume: " << blue << " blue pixels" << std::endl;
  RTW_CHECK(blue > 500);
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestOverlay()
{
  rtwShadowStage stage;
  stage.Name = "overlay";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<vtkTextActor> text;
  text->SetInput("XXXX");
  text->GetTextProperty()->SetFontSize(40);
  text->GetTextProperty()->SetColor(1, 1, 0);
  text->SetPosition(10, 150);
  stage.Renderer->AddActor2D(text);
  stage.Render();
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(stage.Window);
  int yellow = 0;
  for (int y = 150; y < 190; ++y)
  {
    for (int x = 10; x < 140; ++x)
    {
      const auto p = rtwPixel(picture, x, y);
      yellow += p[0] > 200 && p[1] > 200 && p[2] < 60;
    }
  }
  std::cout << "overlay: " << yellow << " yellow pixels" << std::endl;
  RTW_CHECK(yellow > 200);
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Comes after the frame and counts.
class CountingPass : public vtkRenderPass
{
public:
  static CountingPass* New() { return new CountingPass; }
  void Render(const vtkRenderState*) override { ++this->Frames; }
  int Frames = 0;
};

// Tone mapping makes all darker, and the shadows stay where they are.
void TestPostProcessing()
{
  rtwShadowStage stage;
  stage.Name = "post-processing";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<CountingPass> counting;
  StepsOf(stage)->SetPostProcessPass(counting);
  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetToneMappingType(vtkToneMappingPass::Exponential);
  toneMapping->SetExposure(0.5);
  toneMapping->SetDelegatePass(StepsOf(stage));
  stage.Renderer->SetPass(toneMapping);
  stage.Render();
  RTW_CHECK_EQUAL(counting->Frames, 1);
  const double linear = 255 * 5 / std::sqrt(38.0);
  const int mapped = Grey(stage, 30, 40);
  std::cout << "post-processing: " << mapped << " of " << linear << std::endl;
  RTW_CHECK(mapped > 50);
  RTW_CHECK(mapped < linear - 50);
  RTW_CHECK_SHADOWS(stage, sun, 0);
  const rtw::Truth truth = stage.Trace(sun);
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(stage.Window);
  int differ = 0;
  for (size_t i = 0; i < truth.Mask.size(); ++i)
  {
    const bool dark = rtwPixel(picture, int(i % 300), int(i / 300))[0] < 4;
    differ += truth.Mask[i] == rtw::MASK_SHADOW && !dark;
  }
  std::cout << "post-processing: " << differ << " pixels in shadow are not dark" << std::endl;
  RTW_CHECK(differ < 40);
  toneMapping->ReleaseGraphicsResources(stage.Window);
  stage.Renderer->SetPass(nullptr);
}

// No pass is no shadows; VTK's own works, as it can.
void TestOtherPasses()
{
  rtwShadowStage stage;
  stage.Name = "no shadow pass";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<vtkShadowRenderStepsPass> steps;
  RTW_CHECK(steps->GetShadowMapPass() != nullptr);
  steps->SetShadowMapPass(nullptr);
  stage.Renderer->SetPass(steps);
  stage.Render();
  sun->SetShadowAttenuation(0);
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowRenderSteps(int argc, char* argv[])
{
  TestTranslucent(argc, argv);
  TestVolume();
  TestOverlay();
  TestPostProcessing();
  TestOtherPasses();
  return rtwTestResult();
}
