// SPDX-License-Identifier: BSD-3-Clause
// A ball over a plane, pixel by pixel against the closed form.
#include "rtwReference.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>

namespace
{
using glm::dvec3;

constexpr double RADIUS = 1;
constexpr double HEIGHT = 1.5; // of the ball's centre
constexpr double SIDE = 20;    // of the plane, which lies in y = 0

struct Case
{
  std::string Name;
  int Width, Height;
  std::function<void(vtkCamera*)> SetCamera;
  std::function<void(vtkLight*)> SetLight;
  dvec3 Origin{ 0 }; // of everything
};

void PrintTo(const Case& test, std::ostream* out)
{
  *out << test.Name;
}

vtkSmartPointer<vtkRenderer> MakeRenderer(const Case& test)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const dvec3 o = test.Origin;
  points->InsertNextPoint(o.x, o.y + HEIGHT, o.z);
  vtkNew<vtkPolyData> centre;
  centre->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> balls;
  balls->SetInputData(centre);
  balls->SetRadius(float(RADIUS));
  vtkNew<vtkActor> ball;
  ball->SetMapper(balls);
  renderer->AddActor(ball);

  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(o.x - SIDE / 2, o.y, o.z - SIDE / 2);
  plane->SetPoint1(o.x + SIDE / 2, o.y, o.z - SIDE / 2);
  plane->SetPoint2(o.x - SIDE / 2, o.y, o.z + SIDE / 2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(mapper);
  renderer->AddActor(ground);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(o.x + 3, o.y + 5, o.z + 8);
  camera->SetFocalPoint(o.x, o.y + 0.5, o.z);
  camera->SetClippingRange(1, 40);
  camera->SetViewAngle(40);
  test.SetCamera(camera);
  return renderer;
}

// The camera, the ball, the plane and the light, written out with the world's origin moved to
// theirs.
class ClosedForm
{
public:
  ClosedForm(const Case& test, vtkCamera* camera, vtkLight* light)
    : Test(test)
    , Light(light)
  {
    camera->GetPosition(&this->Eye.x);
    camera->GetFocalPoint(&this->Forward.x);
    this->Forward = glm::normalize(this->Forward - this->Eye);
    this->Right = glm::normalize(glm::cross(this->Forward, dvec3(0, 1, 0)));
    this->Up = glm::cross(this->Right, this->Forward);
    this->Eye -= test.Origin;
    this->IsParallel = camera->GetParallelProjection();
    const double tangent = std::tan(glm::radians(camera->GetViewAngle()) / 2);
    this->HalfHeight = this->IsParallel     ? camera->GetParallelScale()
      : camera->GetUseHorizontalViewAngle() ? tangent * test.Height / test.Width
                                            : tangent;
    camera->GetClippingRange(this->Range);
    light->GetPosition(&this->LightPosition.x);
    light->GetFocalPoint(&this->LightAxis.x);
    this->LightAxis = glm::normalize(this->LightAxis - this->LightPosition);
    this->LightPosition -= test.Origin;
  }

  struct Pixel
  {
    unsigned char Mask = rtw::MASK_BACKGROUND;
    double Depth = 1;
  };

  Pixel At(int x, int y) const
  {
    const double aspect = double(this->Test.Width) / this->Test.Height;
    const double u = (2 * (x + 0.5) / this->Test.Width - 1) * this->HalfHeight * aspect;
    const double v = (2 * (y + 0.5) / this->Test.Height - 1) * this->HalfHeight;
    const dvec3 aside = u * this->Right + v * this->Up;
    const dvec3 origin = this->IsParallel ? this->Eye + aside : this->Eye;
    const dvec3 direction = this->IsParallel ? this->Forward : this->Forward + aside;
    // Distances are along the view direction, as the direction's part along it is one.
    const double ball = ToBall(origin, direction), plane = ToPlane(origin, direction);
    const double distance = std::min(ball, plane);
    if (!(distance < this->Range[1]))
    {
      return {};
    }
    const dvec3 p = origin + distance * direction;
    const dvec3 normal = ball < plane ? glm::normalize(p - dvec3(0, HEIGHT, 0)) : dvec3(0, 1, 0);
    return { this->Shade(p, normal, ball < plane), this->WindowDepth(distance) };
  }

private:
  static double ToBall(const dvec3& origin, const dvec3& direction)
  {
    const dvec3 q = origin - dvec3(0, HEIGHT, 0);
    const double a = glm::dot(direction, direction), b = glm::dot(q, direction);
    const double d = b * b - a * (glm::dot(q, q) - RADIUS * RADIUS);
    return d < 0 ? HUGE_VAL : (-b - std::sqrt(d)) / a;
  }

  static double ToPlane(const dvec3& origin, const dvec3& direction)
  {
    const double distance = -origin.y / direction.y;
    const dvec3 p = origin + distance * direction;
    const bool isOn = std::abs(p.x) < SIDE / 2 && std::abs(p.z) < SIDE / 2;
    return distance > 0 && isOn ? distance : HUGE_VAL;
  }

  unsigned char Shade(const dvec3& p, const dvec3& normal, bool isBall) const
  {
    const bool isPositional = this->Light->GetPositional();
    const dvec3 way = isPositional ? glm::normalize(p - this->LightPosition) : this->LightAxis;
    if (-glm::dot(normal, way) <= 1e-3)
    {
      return rtw::MASK_AVERTED;
    }
    if (isPositional && this->Light->GetConeAngle() < 90)
    {
      const double cosine = glm::dot(way, this->LightAxis);
      const double cone = 0.97 * std::tan(glm::radians(this->Light->GetConeAngle()));
      if (cosine <= 0 || std::sqrt(1 - cosine * cosine) / cosine >= cone)
      {
        return rtw::MASK_AVERTED;
      }
    }
    // The ball shades none of itself that faces the light.
    const double toBall = isBall ? HUGE_VAL : ToBall(p, -way);
    const double toLight = isPositional ? glm::distance(p, this->LightPosition) : HUGE_VAL;
    return toBall > 0 && toBall < toLight ? rtw::MASK_SHADOW : rtw::MASK_LIT;
  }

  double WindowDepth(double distance) const
  {
    const double n = this->Range[0], f = this->Range[1];
    return this->IsParallel ? (distance - n) / (f - n) : f / (f - n) * (1 - n / distance);
  }

  Case Test;
  vtkLight* Light;
  bool IsParallel;
  double HalfHeight; // of the picture, at a distance of one
  double Range[2];
  dvec3 Eye, Forward, Right, Up, LightPosition, LightAxis;
};

void Sun(vtkLight* light)
{
  light->SetPosition(-4, 6, 3);
  light->SetFocalPoint(0, 0, 0);
}

void Lamp(vtkLight* light, double cone)
{
  light->SetPositional(true);
  light->SetConeAngle(cone);
  light->SetPosition(-3, 6, 2);
  light->SetFocalPoint(1, 0, 0);
}

const std::function<void(vtkCamera*)> PLAIN = [](vtkCamera*) {};

std::vector<Case> Cases()
{
  const auto parallel = [](vtkCamera* camera) {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(4);
  };
  const auto horizontal = [](vtkCamera* camera) { camera->UseHorizontalViewAngleOn(); };
  const auto spot = [](vtkLight* light) { Lamp(light, 25); };
  const auto point = [](vtkLight* light) { Lamp(light, 120); };
  const dvec3 far(3e6, -2e6, 5e6);
  const auto farSun = [=](vtkLight* light) {
    light->SetPosition(far.x - 4, far.y + 6, far.z + 3);
    light->SetFocalPoint(far.x, far.y, far.z);
  };
  return { { "Sun", 160, 160, PLAIN, Sun }, { "Spot", 160, 160, PLAIN, spot },
    { "Point", 160, 160, PLAIN, point }, { "Wide", 240, 100, PLAIN, Sun },
    { "Tall", 90, 200, PLAIN, spot }, { "Parallel", 200, 120, parallel, Sun },
    { "HorizontalAngle", 240, 100, horizontal, point },
    { "FarFromTheOrigin", 160, 160, PLAIN, farSun, far } };
}

class BallOverPlane : public testing::TestWithParam<Case>
{
};
}

TEST_P(BallOverPlane, IsTheClosedForm)
{
  const Case& test = GetParam();
  const auto renderer = MakeRenderer(test);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  test.SetLight(light);
  const rtw::Truth truth = rtw::ShadowReference(renderer).Trace(light, test.Width, test.Height);
  const ClosedForm expected(test, renderer->GetActiveCamera(), light);
  size_t differences = 0, shadowed = 0, lit = 0;
  double worstDepth = 0;
  for (int y = 0; y < test.Height; ++y)
  {
    for (int x = 0; x < test.Width; ++x)
    {
      const auto pixel = expected.At(x, y);
      const size_t i = size_t(y) * test.Width + x;
      differences += pixel.Mask != truth.Mask[i];
      worstDepth = std::max(worstDepth, std::abs(pixel.Depth - truth.Depth[i]));
      shadowed += pixel.Mask == rtw::MASK_SHADOW;
      lit += pixel.Mask == rtw::MASK_LIT;
    }
  }
  EXPECT_LE(differences, 2u); // shadow rays start a little off the surface
  EXPECT_LT(worstDepth, 1e-6);
  EXPECT_GT(shadowed, 300u);
  EXPECT_GT(lit, 3000u);
}

INSTANTIATE_TEST_SUITE_P(Reference, BallOverPlane, testing::ValuesIn(Cases()),
  [](const auto& info) { return info.param.Name; });
