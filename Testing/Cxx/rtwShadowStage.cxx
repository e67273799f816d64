// SPDX-License-Identifier: BSD-3-Clause
#include "rtwShadowStage.h"

#include "vtkCascadedShadowMapPass.h"
#include "vtkExactShadowMapPass.h"
#include "vtkNoTWShadowMapPass.h"
#include "vtkPerspectiveShadowMapPass.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkUniformShadowMapPass.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace
{
// Whether the truth is the same at all pixels within two pixels of that one.
bool IsInside(const rtw::Truth& truth, int x, int y)
{
  const unsigned char here = truth.Mask[size_t(y) * truth.Width + x];
  for (int v = std::max(0, y - 2); v <= std::min(truth.Height - 1, y + 2); ++v)
  {
    for (int u = std::max(0, x - 2); u <= std::min(truth.Width - 1, x + 2); ++u)
    {
      if (truth.Mask[size_t(v) * truth.Width + u] != here)
      {
        return false;
      }
    }
  }
  return true;
}

bool IsUndecided(unsigned char value)
{
  return value == rtw::MASK_AVERTED || value == rtw::MASK_BACKGROUND;
}

// The truth leaves out what is beyond the rim of a spot's cone; this one knows no rim.
rtw::Truth TraceWithoutRim(
  const rtw::ShadowReference& reference, vtkLight* light, int width, int height)
{
  vtkNew<vtkLight> wide;
  wide->DeepCopy(light);
  wide->SetConeAngle(90);
  return reference.Trace(wide, width, height);
}

double StrayPercent(const std::vector<unsigned char>& mask, const rtw::Truth& truth)
{
  size_t stray = 0;
  for (size_t i = 0; i < mask.size(); ++i)
  {
    stray += IsUndecided(truth.Mask[i]) && mask[i] != rtw::MASK_AVERTED &&
      IsInside(truth, int(i % truth.Width), int(i / truth.Width));
  }
  return 100.0 * double(stray) / double(mask.size());
}

// RTW_TEST_PICTURES=<folder> writes what is looked at, to look at it.
void Keep(vtkImageData* picture, const std::string& name)
{
  const char* folder = std::getenv("RTW_TEST_PICTURES");
  if (folder && *folder)
  {
    std::string file = name;
    std::replace_if(
      file.begin(), file.end(), [](char c) { return c == ' ' || c == '/' || c == ','; }, '-');
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName((std::string(folder) + "/" + file + ".png").c_str());
    writer->SetInputData(picture);
    writer->Write();
  }
}

std::vector<vtkLight*> LightsOf(vtkRenderer* renderer)
{
  std::vector<vtkLight*> lights;
  for (int i = 0; i < renderer->GetLights()->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(i));
    if (light->GetSwitch())
    {
      lights.push_back(light);
    }
  }
  return lights;
}
}

vtkSmartPointer<vtkAdaptiveShadowMapPass> rtwMakePass(rtwTechnique technique)
{
  switch (technique)
  {
    case rtwTechnique::RTW:
      return vtkSmartPointer<vtkRTWShadowMapPass>::New();
    case rtwTechnique::NoTW:
      return vtkSmartPointer<vtkNoTWShadowMapPass>::New();
    case rtwTechnique::Perspective:
      return vtkSmartPointer<vtkPerspectiveShadowMapPass>::New();
    case rtwTechnique::Exact:
      return vtkSmartPointer<vtkExactShadowMapPass>::New();
    case rtwTechnique::Cascades:
      return vtkSmartPointer<vtkCascadedShadowMapPass>::New();
    default:
      auto pass = vtkSmartPointer<vtkUniformShadowMapPass>::New();
      pass->SetFocusOnView(technique == rtwTechnique::Uniform);
      return pass;
  }
}

vtkSmartPointer<vtkRenderPass> rtwMakeClassicChain(vtkAdaptiveShadowMapPass* shadows)
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto chain = vtkSmartPointer<vtkCameraPass>::New();
  chain->SetDelegatePass(sequence);
  return chain;
}

rtwShadowStage::rtwShadowStage(rtwTechnique technique, rtwChain chain)
  : rtwShadowStage(rtwMakePass(technique), chain)
{
}

rtwShadowStage::rtwShadowStage(vtkAdaptiveShadowMapPass* pass, rtwChain chain)
  : Pass(pass)
{
  if (chain == rtwChain::Classic)
  {
    this->Chain = rtwMakeClassicChain(this->Pass);
  }
  else
  {
    vtkNew<vtkShadowRenderStepsPass> steps;
    steps->SetShadowMapPass(this->Pass);
    this->Chain = steps;
  }
  this->UsePass(true);
  this->Renderer->AutomaticLightCreationOff();
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(300, 200);
  this->Window->AddRenderer(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(1, 6, 9);
  camera->SetFocalPoint(0, 0.5, 0);
}

rtwShadowStage::~rtwShadowStage() = default;

void rtwShadowStage::UsePass(bool use)
{
  this->Renderer->SetPass(use ? this->Chain.Get() : nullptr);
}

vtkActor* rtwShadowStage::Add(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  return actor;
}

vtkActor* rtwShadowStage::Add(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  return actor;
}

vtkActor* rtwShadowStage::AddFloor(double side)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-side / 2, 0, side / 2);
  plane->SetPoint1(side / 2, 0, side / 2);
  plane->SetPoint2(-side / 2, 0, -side / 2);
  return this->Add(plane);
}

vtkActor* rtwShadowStage::AddBall(double x, double y, double z, double radius, int resolution)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(resolution);
  ball->SetPhiResolution(resolution);
  return this->Add(ball);
}

vtkActor* rtwShadowStage::AddBox(double x, double y, double z, double side)
{
  vtkNew<vtkCubeSource> box;
  box->SetCenter(x, y, z);
  box->SetXLength(side);
  box->SetYLength(side);
  box->SetZLength(side);
  return this->Add(box);
}

void rtwShadowStage::AddObjects()
{
  this->AddFloor();
  this->AddBall(-1.2, 1.3, 0, 1);
  this->AddBox(1.8, 0.6, -0.5, 1.2);
}

vtkLight* rtwShadowStage::AddSun(double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  this->Renderer->AddLight(light);
  return light;
}

vtkLight* rtwShadowStage::AddSpot(double x, double y, double z, double cone)
{
  vtkLight* light = this->AddSun(x, y, z);
  light->PositionalOn();
  light->SetConeAngle(cone);
  light->SetExponent(0);
  return light;
}

void rtwShadowStage::Render()
{
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
}

void rtwShadowStage::SetStandIn(vtkActor* actor, vtkPolyData* mesh)
{
  this->StandIns.push_back({ actor, this->Add(mesh) });
  this->StandIns.back().Exact->VisibilityOff();
}

rtw::ShadowReference rtwShadowStage::MakeReference()
{
  for (const StandIn& swap : this->StandIns)
  {
    swap.Actor->VisibilityOff();
    swap.Exact->VisibilityOn();
  }
  rtw::ShadowReference reference(this->Renderer, this->Options);
  for (const StandIn& swap : this->StandIns)
  {
    swap.Actor->VisibilityOn();
    swap.Exact->VisibilityOff();
  }
  return reference;
}

std::vector<unsigned char> rtwShadowStage::GetMask(int index)
{
  vtkSmartPointer<vtkImageData> image = this->Pass->GetShadowMask(index);
  return image ? rtw::MaskOf(image) : std::vector<unsigned char>();
}

rtw::Truth rtwShadowStage::Trace(vtkLight* light)
{
  const int* size = this->Renderer->GetSize();
  return this->MakeReference().Trace(light, size[0], size[1]);
}

bool rtwShadowStage::Check(
  vtkLight* light, int index, const rtwShadowBounds& bounds, const char* file, int line)
{
  vtkSmartPointer<vtkImageData> image = this->Pass->GetShadowMask(index);
  if (!rtwCheck(image != nullptr, file, line, this->Name + ": there is a mask"))
  {
    return false;
  }
  const int* size = image->GetDimensions();
  const rtw::ShadowReference reference = this->MakeReference();
  const rtw::Truth truth = reference.Trace(light, size[0], size[1]);
  const std::vector<unsigned char> mask = rtw::MaskOf(image);
  const rtw::ShadowErrors errors = rtw::Compare(mask, truth);
  const double wrong = errors.Percent(errors.Wrong()), shadowed = errors.Percent(errors.Shadowed),
               far = errors.Percent(errors.FarFromEdge),
               stray = StrayPercent(mask, TraceWithoutRim(reference, light, size[0], size[1])),
               undecided = errors.Percent(errors.NotComparable);
  std::ostringstream text;
  text << this->Name << ", light " << index << ": of " << errors.LitFacing << " pixels " << shadowed
       << " % in shadow; wrong " << wrong << " % (" << errors.WronglyDark << " dark, "
       << errors.WronglyLit << " lit), far from edges " << far << " %, undecided " << undecided
       << " %, stray " << stray << " %";
  std::cout << text.str() << std::endl;
  Keep(rtw::DifferenceImage(mask, truth), this->Name + "-mask" + std::to_string(index));
  return rtwCheck(shadowed >= bounds.Shadowed && wrong <= bounds.Wrong && far <= bounds.Far &&
      undecided <= bounds.Undecided && stray <= bounds.Stray,
    file, line, text.str());
}

bool rtwShadowStage::CheckPicture(double percent, const char* file, int line)
{
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(this->Window);
  Keep(picture, this->Name + "-picture");
  const int width = picture->GetDimensions()[0], height = picture->GetDimensions()[1];
  const std::vector<vtkLight*> lights = LightsOf(this->Renderer);
  const rtw::ShadowReference reference = this->MakeReference();
  std::vector<double> expected(size_t(3) * width * height, 0.0);
  std::vector<bool> counts(size_t(width) * height, true);
  this->UsePass(false);
  for (vtkLight* light : lights)
  {
    for (vtkLight* other : lights)
    {
      other->SetSwitch(other == light);
    }
    this->Window->Render();
    const vtkSmartPointer<vtkImageData> alone = rtwGrab(this->Window);
    const rtw::Truth truth = reference.Trace(light, width, height);
    for (size_t i = 0; i < truth.Mask.size(); ++i)
    {
      const int x = int(i % width), y = int(i / width);
      counts[i] = counts[i] && IsInside(truth, x, y);
      const double visible =
        truth.Mask[i] == rtw::MASK_SHADOW ? 1.0 - light->GetShadowAttenuation() : 1.0;
      for (size_t c = 0; c < 3; ++c)
      {
        expected[3 * i + c] += visible * rtwPixel(alone, x, y)[c];
      }
    }
  }
  for (vtkLight* light : lights)
  {
    light->SwitchOn();
  }
  this->UsePass(true);

  size_t looked = 0, differ = 0;
  for (size_t i = 0; i < counts.size(); ++i)
  {
    const std::array<int, 3> actual = rtwPixel(picture, int(i % width), int(i / width));
    bool same = true;
    for (size_t c = 0; c < 3; ++c)
    {
      same = same && std::abs(actual[c] - std::min(255.0, expected[3 * i + c])) <= 6.0;
    }
    looked += counts[i];
    differ += counts[i] && !same;
  }
  const double share = 100.0 * double(differ) / double(std::max<size_t>(looked, 1));
  std::ostringstream text;
  text << this->Name << ": the picture differs from the exact one at " << share << " % of "
       << looked << " pixels away from edges";
  std::cout << text.str() << std::endl;
  return rtwCheck(looked > counts.size() / 4 && share <= percent, file, line, text.str());
}
