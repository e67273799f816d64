// SPDX-License-Identifier: BSD-3-Clause
#include "Truths.h"

#include "SetupScene.h"

#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <optional>

namespace
{
Truths Trace(const Setup& setup, int views)
{
  const auto scene = SceneOf(setup);
  vtkNew<vtkRenderer> renderer;
  Populate(setup, *scene, renderer);
  Mover mover(setup, scene, renderer);
  auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
  std::optional<rtw::ShadowReference> reference;
  Truths truths;
  for (int i = 0; i < (setup.Moves == Motion::NOTHING ? 1 : views); ++i)
  {
    // Off the way's ends, where cameras and lights have their best places.
    truths.Places.push_back((i + 0.25) / views);
    mover.MoveTo(truths.Places.back());
    if (!reference || setup.Moves == Motion::ACTOR)
    {
      reference.emplace(renderer);
    }
    truths.Views.push_back(reference->Trace(light, setup.Width, setup.Height));
    if (i == 0)
    {
      truths.Samples = reference->Samples(light, setup.Width, setup.Height);
    }
  }
  for (int i = 0; i < setup.TinySteps; ++i)
  {
    rtw::Apply(rtw::CameraOnTinyPath(*scene, i), renderer->GetActiveCamera());
    truths.Steps.push_back(reference->Trace(light, setup.Width, setup.Height));
  }
  return truths;
}
}

std::shared_ptr<const Truths> TruthsOf(const Setup& setup, int views)
{
  static std::shared_ptr<const Truths> last;
  static std::string lastKey;
  const std::string key = setup.Content() + " " + std::to_string(views);
  if (key != lastKey)
  {
    last.reset();
    last = std::make_shared<const Truths>(Trace(setup, views));
    lastKey = key;
  }
  return last;
}
