// SPDX-License-Identifier: BSD-3-Clause
#include "SetupScene.h"

#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtx/rotate_vector.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int ABREAST = 4;         // copies beside each other
constexpr double TINY = 1.0 / 600; // of the way of lights and actors

const char FLOOR[] = "floor"; // which is not finer with more triangles

rtw::Scene Make(const Setup& setup)
{
  if (setup.Scene == FLOOR)
  {
    return rtw::MakeFloor();
  }
  return setup.Triangles > 0 ? rtw::MakeSceneWithBudget(setup.Scene, setup.Triangles)
                             : rtw::MakeScene(setup.Scene);
}

// Rows of copies, each wholly behind the camera on all of its path.
void AddOutside(const rtw::Scene& scene, int copies, vtkRenderer* renderer)
{
  const rtw::SceneBounds bounds = rtw::BoundsOf(scene);
  const glm::dvec3 extent = bounds.High - bounds.Low, up = scene.Camera.Up;
  glm::dvec3 back = scene.Camera.Position - scene.Camera.Focal;
  back = glm::normalize(back - up * glm::dot(back, up));
  const glm::dvec3 aside = glm::cross(up, back);
  const double step = 1.2 * glm::length(extent);
  for (int i = 0; i < copies; ++i)
  {
    const glm::dvec3 shift = step *
      (back * double(1 + i / ABREAST) +
        aside * (double(i % ABREAST) - 0.5 * (std::min(copies, ABREAST) - 1)));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(scene.Mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(shift.x, shift.y, shift.z);
    renderer->AddActor(actor);
  }
}

// All about as high as the first, from other sides.
void AddLights(const rtw::Scene& scene, int lights, vtkRenderer* renderer)
{
  const rtw::SceneBounds bounds = rtw::BoundsOf(scene);
  const glm::dvec3 centre = 0.5 * (bounds.Low + bounds.High), up = scene.Camera.Up;
  for (int i = 1; i < lights; ++i)
  {
    const double angle = i * glm::pi<double>() * (3 - std::sqrt(5.0)); // the golden angle
    rtw::SceneLight light = scene.Light;
    light.Direction = glm::rotate(light.Direction, angle, up);
    light.Position = centre + glm::rotate(light.Position - centre, angle, up);
    const vtkSmartPointer<vtkLight> added = rtw::MakeLight(scene);
    rtw::Apply(light, scene, added);
    renderer->AddLight(added);
  }
  vtkLightCollection* all = renderer->GetLights();
  all->InitTraversal();
  while (vtkLight* light = all->GetNextItem())
  {
    light->SetIntensity(1.0 / lights);
  }
}
}

std::vector<std::string> SetupSceneNames()
{
  std::vector<std::string> names = rtw::SceneNames();
  names.emplace_back(FLOOR);
  return names;
}

std::shared_ptr<const rtw::Scene> SceneOf(const Setup& setup)
{
  static std::shared_ptr<const rtw::Scene> last;
  static std::string lastKey;
  const std::string key = setup.Scene + " " + std::to_string(setup.Triangles);
  if (key != lastKey)
  {
    last.reset();
    last = std::make_shared<const rtw::Scene>(Make(setup));
    lastKey = key;
  }
  return last;
}

// Van der Corput's sequence, off the way's ends, where cameras and lights have their best places.
double PlaceOnWay(int i)
{
  double t = 0.125;
  for (double digit = 0.5; i > 0; i /= 2, digit /= 2)
  {
    t += (i % 2) * digit;
  }
  return t - std::floor(t);
}

void Populate(const Setup& setup, const rtw::Scene& scene, vtkRenderer* renderer)
{
  rtw::AddToRenderer(scene, renderer, setup.Actors);
  AddOutside(scene, setup.Outside, renderer);
  AddLights(scene, setup.Lights, renderer);
}

Mover::Mover(const Setup& setup, std::shared_ptr<const rtw::Scene> scene, vtkRenderer* renderer)
  : Moves(setup.Moves)
  , Scene(std::move(scene))
  , Renderer(renderer)
  , Actor(renderer->GetActors()->GetLastActor())
{
  this->Actor->GetPosition(this->Start);
  const rtw::SceneBounds bounds = rtw::BoundsOf(*this->Scene);
  this->Reach = 0.02 * glm::length(bounds.High - bounds.Low);
}

void Mover::MoveTo(int place, int step)
{
  const double start = PlaceOnWay(place), t = start + step * TINY;
  switch (this->Moves)
  {
    case Motion::CAMERA:
      rtw::Apply(
        rtw::CameraOnTinyPath(*this->Scene, step, start), this->Renderer->GetActiveCamera());
      break;
    case Motion::LIGHT:
      rtw::Apply(rtw::LightOnPath(*this->Scene, t), *this->Scene,
        vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0)));
      break;
    case Motion::ACTOR:
      this->Actor->SetPosition(this->Start[0],
        this->Start[1] + this->Reach * std::sin(2 * glm::pi<double>() * t), this->Start[2]);
      break;
    case Motion::NOTHING:
      break;
  }
}
