// SPDX-License-Identifier: BSD-3-Clause
// Shadows on and of all that a vtkProperty can make of a mesh.
#include "rtwShadowStage.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace
{
void Change(vtkRenderer* renderer, const std::function<void(vtkProperty*)>& change)
{
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    change(actor->GetProperty());
  }
}

// Under a sun and, where VTK has code of its own for it, under a spot.
void TestShading()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  const auto check = [&](const char* name, vtkLight* light) {
    stage.Name = name;
    stage.Render();
    RTW_CHECK_SHADOWS(stage, light, 0);
    RTW_CHECK_PICTURE(stage);
  };
  Change(stage.Renderer, [](vtkProperty* p) { p->SetInterpolationToFlat(); });
  check("flat", sun);
  Change(stage.Renderer, [](vtkProperty* p) { p->SetInterpolationToGouraud(); });
  check("gouraud", sun);
  Change(stage.Renderer, [](vtkProperty* p) {
    p->SetInterpolationToPhong();
    p->SetSpecular(0.5);
    p->SetSpecularPower(20);
  });
  check("specular", sun);
  Change(stage.Renderer, [](vtkProperty* p) {
    p->EdgeVisibilityOn();
    p->SetEdgeColor(1, 0, 0);
  });
  check("edges", sun);
  // Closed objects, but for the floor, whose front is above.
  Change(stage.Renderer, [](vtkProperty* p) {
    p->EdgeVisibilityOff();
    p->BackfaceCullingOn();
  });
  check("culled back faces", sun);
  Change(stage.Renderer, [](vtkProperty* p) {
    p->SetInterpolationToPBR();
    p->SetMetallic(0.3);
    p->SetRoughness(0.4);
  });
  check("physical sun", sun);
  sun->SwitchOff();
  check("physical spot", stage.AddSpot(3, 7, 2, 40));
}

void TestUnlit()
{
  rtwShadowStage stage;
  stage.Name = "unlit ball";
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(0, 1.3, 0, 1);
  ball->GetProperty()->LightingOff();
  ball->GetProperty()->SetColor(0.2, 0.4, 0.6);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Options.Receives = [ball](vtkProp* prop) { return prop != ball; };
  stage.Render();
  RTW_CHECK_PIXEL(rtwGrab(stage.Window), 150, 120, 51, 102, 153);
  rtwShadowBounds bounds;
  bounds.Stray = 100; // what the mask says of the ball makes no difference
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
}

// Props that are told not to cast, or not to receive.
void TestKeys()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(-1.2, 1.3, 0, 1);
  vtkActor* box = stage.AddBox(-2.6, 0.6, -1, 1.2); // in the shadow of the ball
  stage.AddBall(2, 1, 1, 0.6);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  const auto set = [](vtkActor* actor, vtkInformationIntegerKey* key, int value) {
    vtkNew<vtkInformation> keys;
    keys->Set(key, value);
    actor->SetPropertyKeys(keys);
  };
  stage.Name = "casts nothing";
  stage.Options.Casts = [ball](vtkProp* prop) { return prop != ball; };
  set(ball, vtkAdaptiveShadowMapPass::CASTS_SHADOW(), 0);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "receives nothing";
  stage.Options.Casts = nullptr;
  stage.Options.Receives = [box](vtkProp* prop) { return prop != box; };
  set(ball, vtkAdaptiveShadowMapPass::CASTS_SHADOW(), 1);
  set(box, vtkAdaptiveShadowMapPass::RECEIVES_SHADOW(), 0);
  stage.Render();
  rtwShadowBounds bounds;
  bounds.Stray = 100; // what the mask says of the box makes no difference
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
}

// The inside of an open ball, and a floor seen and lit from its back.
void TestBackFaces()
{
  rtwShadowStage stage;
  stage.Name = "back faces";
  vtkNew<vtkPlaneSource> floor; // its normals point down
  floor->SetOrigin(-6, 0, -6);
  floor->SetPoint1(6, 0, -6);
  floor->SetPoint2(-6, 0, 6);
  stage.Add(floor);
  vtkNew<vtkSphereSource> bowl;
  bowl->SetCenter(0, 1.5, 0);
  bowl->SetRadius(1.5);
  bowl->SetStartPhi(70);
  bowl->SetThetaResolution(32);
  bowl->SetPhiResolution(16);
  bowl->SetEndTheta(230);
  stage.Add(bowl);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  // Facets inside that the light grazes, and that are as good as black anyway, leak.
  rtwShadowBounds bounds;
  bounds.Far = 0.1;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
}

vtkSmartPointer<vtkTexture> MakeTexture(
  int components, const std::function<void(unsigned char*, int, int)>& paint)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < 8; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      paint(static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0)), x, y);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOff();
  return texture;
}

void TestTexture()
{
  rtwShadowStage stage;
  stage.Name = "texture";
  const auto texture = MakeTexture(3, [](unsigned char* rgb, int x, int y) {
    rgb[0] = (x + y) % 2 ? 255 : 120;
    rgb[1] = 200;
    rgb[2] = 100;
  });
  stage.AddFloor()->SetTexture(texture);
  stage.AddBall(0, 1.3, 0, 1)->SetTexture(texture);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

vtkSmartPointer<vtkPlaneSource> MakeQuad(double x0, double x1, double z0, double z1)
{
  auto quad = vtkSmartPointer<vtkPlaneSource>::New();
  quad->SetOrigin(x0, 2, z1);
  quad->SetPoint1(x1, 2, z1);
  quad->SetPoint2(x0, 2, z0);
  return quad;
}

// A sheet whose texture leaves a square hole, as an opaque and as a translucent prop.
void TestCutOut(rtwTechnique technique, bool forceOpaque, const char* name, int argc, char* argv[])
{
  rtwShadowStage stage(technique);
  stage.Name = name;
  stage.AddFloor();
  vtkActor* sheet = stage.Add(MakeQuad(-2, 2, -2, 2));
  sheet->SetTexture(MakeTexture(4, [](unsigned char* rgba, int x, int y) {
    const bool hole = x >= 2 && x < 6 && y >= 2 && y < 6;
    rgba[0] = rgba[1] = 255;
    rgba[2] = 128;
    rgba[3] = hole ? 0 : 255;
  }));
  sheet->SetForceOpaque(forceOpaque);
  vtkNew<vtkAppendPolyData> frame;
  for (const auto& border : { MakeQuad(-2, -1, -2, 2), MakeQuad(1, 2, -2, 2),
         MakeQuad(-1, 1, -2, -1), MakeQuad(-1, 1, 1, 2) })
  {
    frame->AddInputConnection(border->GetOutputPort());
  }
  frame->Update();
  vtkLight* sun = stage.AddSun(1, 5, 0.5);
  stage.Render();
  if (forceOpaque)
  {
    if (technique == rtwTechnique::Uniform)
    {
      rtwCompareWithBaseline(stage.Window, argc, argv);
    }
    stage.SetStandIn(sheet, frame->GetOutput());
    RTW_CHECK_SHADOWS(stage, sun, 0);
    RTW_CHECK_PICTURE(stage);
    return;
  }
  // A translucent sheet is in no mask, but its shadow is.
  stage.SetStandIn(sheet, frame->GetOutput());
  const std::vector<unsigned char> mask = stage.GetMask(0);
  const rtw::Truth truth = stage.Trace(sun);
  size_t floor = 0, wrong = 0;
  for (int y = 0; y < truth.Height / 3; ++y) // the sheet is above that
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const size_t i = size_t(y) * truth.Width + x;
      floor += truth.Mask[i] == rtw::MASK_SHADOW;
      wrong += (truth.Mask[i] == rtw::MASK_SHADOW) != (mask[i] < 128);
    }
  }
  std::cout << name << ": " << wrong << " wrong, " << floor << " in shadow" << std::endl;
  RTW_CHECK(floor > 200);
  RTW_CHECK(wrong < 20);
}

void TestScalars()
{
  rtwShadowStage stage;
  stage.Name = "scalar colours";
  vtkNew<vtkElevationFilter> heights;
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(-1.5, 1.3, 0);
  ball->SetRadius(1);
  heights->SetInputConnection(ball->GetOutputPort());
  heights->SetLowPoint(0, 0.3, 0);
  heights->SetHighPoint(0, 2.3, 0);
  stage.Add(heights);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-6, 0, 6);
  floor->SetPoint1(6, 0, 6);
  floor->SetPoint2(-6, 0, -6);
  floor->SetResolution(5, 7);
  floor->Update();
  vtkNew<vtkFloatArray> numbers;
  for (int i = 0; i < 35; ++i)
  {
    numbers->InsertNextValue(float(i % 4) / 3);
  }
  floor->GetOutput()->GetCellData()->SetScalars(numbers);
  stage.Add(floor->GetOutput());
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);

  // Colours of which some are translucent.
  stage.Name = "translucent scalars";
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (int i = 0; i < 35; ++i)
  {
    colours->InsertNextTuple4(255, 255, 255, i % 2 ? 255 : 128);
  }
  vtkNew<vtkPlaneSource> lattice;
  lattice->SetOrigin(0.5, 2, 1);
  lattice->SetPoint1(2.5, 2, 1);
  lattice->SetPoint2(0.5, 2, -1);
  lattice->SetResolution(5, 7);
  lattice->Update();
  lattice->GetOutput()->GetCellData()->SetScalars(colours);
  stage.Add(lattice->GetOutput());
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Lines and points of a surface: there is no exact shadow of them, but it lies within the
// surface's.
void TestRepresentations()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(0, 1.5, 0, 1, 16);
  ball->GetProperty()->SetPointSize(3);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  const rtw::Truth solid = stage.Trace(sun);
  ball->VisibilityOff();
  const rtw::Truth empty = stage.Trace(sun);
  ball->VisibilityOn();
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    ball->GetProperty()->SetRepresentation(representation);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    if (!RTW_CHECK_EQUAL(mask.size(), solid.Mask.size()))
    {
      return;
    }
    size_t dark = 0, outside = 0, whole = 0;
    for (size_t i = 0; i < mask.size(); ++i)
    {
      const bool onFloor = solid.Depth[i] == empty.Depth[i];
      whole += onFloor && solid.Mask[i] == rtw::MASK_SHADOW;
      dark += onFloor && mask[i] < 128;
      outside += onFloor && mask[i] < 128 && solid.Mask[i] == rtw::MASK_LIT;
    }
    std::cout << ball->GetProperty()->GetRepresentationAsString() << ": " << dark << " dark of "
              << whole << ", " << outside << " outside" << std::endl;
    RTW_CHECK(dark > whole / 50);
    RTW_CHECK(outside < whole / 20);
  }
}

void TestTranslucent()
{
  rtwShadowStage stage;
  stage.Name = "translucent";
  stage.AddObjects();
  stage.AddBall(1, 2, 1, 0.5)->GetProperty()->SetOpacity(0.4);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}
}

int TestShadowMaterials(int argc, char* argv[])
{
  TestShading();
  TestUnlit();
  TestKeys();
  TestBackFaces();
  TestTexture();
  TestCutOut(rtwTechnique::Uniform, true, "cut-out, uniform", argc, argv);
  TestCutOut(rtwTechnique::RTW, true, "cut-out, rtw", argc, argv);
  TestCutOut(rtwTechnique::RTW, false, "cut-out, translucent", argc, argv);
  TestScalars();
  TestRepresentations();
  TestTranslucent();
  return rtwTestResult();
}
