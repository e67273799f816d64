// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/rtwMapperDrawing.h"

#include "Frame/rtwView.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <glm/gtc/matrix_access.hpp>

namespace rtw
{
namespace
{
// Sets up a camera that stands where the light does, or before the scene; its projection leads to
// light-plane coordinates whatever its own frustum is.
// Its kind of projection is the viewer's, because mappers build other shaders for another kind.
void SetLightCamera(vtkCamera* camera, const LightFrame& frame, vtkCamera* viewer)
{
  glm::dvec3 position = frame.Light.Position;
  if (frame.Light.Kind == LightKind::Directional)
  {
    const glm::dvec2 middle = 0.5 * (frame.Bounds.Low + frame.Bounds.High);
    const glm::dvec3 before(middle, 0); // depth 0 is before the scene
    const glm::dvec4 world = glm::inverse(frame.WorldToLight) * glm::dvec4(before, 1);
    position = glm::dvec3(world) / world.w - frame.DepthRange * frame.Light.Direction;
  }
  const glm::dvec3 focus = position + frame.Light.Direction;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(frame.TAxis.x, frame.TAxis.y, frame.TAxis.z);
  camera->SetParallelProjection(viewer->GetParallelProjection());
  glm::dmat4 toClip = frame.WorldToLight;
  toClip = glm::row(toClip, 2, 2.0 * glm::row(toClip, 2) - glm::row(toClip, 3));
  const glm::dmat4 viewToWorld = glm::inverse(ToGlm(camera->GetModelViewTransformMatrix()));
  vtkNew<vtkMatrix4x4> projection;
  FromGlm(toClip * viewToWorld, projection);
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
}

// Sets up a camera with the depths of a framed view. Where the eye doesn't matter it stands where
// view coordinates begin, for imposters, which find their depth from those.
void SetFramedCamera(vtkCamera* camera, const View& view, vtkCamera* viewer)
{
  camera->DeepCopy(viewer);
  if (view.Parallel)
  {
    const glm::dvec3 eye = view.Origin, focus = eye + view.Forward;
    const glm::dvec3 up(glm::row(view.WorldToView, 1));
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(up.x, up.y, up.z);
  }
  const glm::dmat4 viewToWorld = glm::inverse(ToGlm(camera->GetModelViewTransformMatrix()));
  vtkNew<vtkMatrix4x4> projection;
  FromGlm(view.ViewToClip * (view.WorldToView * viewToWorld), projection);
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
}

// Draws translucent actors with depth, which they write only if they are told to.
void DrawTranslucent(vtkRenderer* renderer, vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkOpenGLActor::GLDepthMaskOverride();
  const bool had = keys && keys->Has(key);
  const int value = had ? keys->Get(key) : 0;
  if (keys)
  {
    keys->Set(key, 1);
  }
  prop->RenderTranslucentPolygonalGeometry(renderer);
  if (keys && had)
  {
    keys->Set(key, value);
  }
  else if (keys)
  {
    keys->Remove(key);
  }
}

// Draws a part of a prop alone, as the prop would.
template <class Draw>
void DrawPart(const SceneProp& prop, Draw draw)
{
  if (prop.Actor != prop.Owner)
  {
    prop.Actor->SetPropertyKeys(prop.Owner->GetPropertyKeys());
  }
  if (prop.Place)
  {
    prop.Actor->PokeMatrix(prop.Place);
  }
  draw(prop.Actor);
  if (prop.Place)
  {
    prop.Actor->PokeMatrix(nullptr);
  }
}
}

void DrawMapperCasters(
  vtkRenderer* renderer, const std::vector<SceneProp>& props, const LightFrame& frame)
{
  vtkSmartPointer<vtkCamera> viewer = renderer->GetActiveCamera();
  vtkNew<vtkOpenGLCamera> camera;
  SetLightCamera(camera, frame, viewer);
  renderer->SetActiveCamera(camera);
  for (const SceneProp& prop : props)
  {
    if (prop.Casts)
    {
      DrawPart(prop, [&](vtkActor* actor) {
        actor->RenderOpaqueGeometry(renderer);
        if (prop.Translucent)
        {
          DrawTranslucent(renderer, actor);
        }
      });
    }
  }
  renderer->SetActiveCamera(viewer);
  // Programs that serve both passes would otherwise keep the light's positions as the light camera sees them.
  viewer->Modified();
}

void DrawMapperSamples(
  vtkRenderer* renderer, const std::vector<SceneProp>& props, const View& view)
{
  vtkSmartPointer<vtkCamera> viewer = renderer->GetActiveCamera();
  vtkNew<vtkOpenGLCamera> camera;
  if (view.Framed)
  {
    SetFramedCamera(camera, view, viewer);
    renderer->SetActiveCamera(camera);
  }
  for (const SceneProp& prop : props)
  {
    DrawPart(prop, [renderer](vtkActor* actor) { actor->RenderOpaqueGeometry(renderer); });
  }
  if (view.Framed)
  {
    renderer->SetActiveCamera(viewer);
    // Programs that serve both passes are to be given the viewer's matrices anew.
    viewer->Modified();
  }
}
}
