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
Truths Trace(const Setup& setup, int views, int steps)
{
  const auto scene = SceneOf(setup);
  vtkNew<vtkRenderer> renderer;
  Populate(setup, *scene, renderer);
  Mover mover(setup, scene, renderer);
  auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
  std::optional<rtw::ShadowReference> reference;
  Truths truths;
  for (int place = 0; place < views; ++place)
  {
    truths.Views.emplace_back();
    for (int step = 0; step < steps; ++step)
    {
      mover.MoveTo(place, step);
      if (!reference || setup.Moves == Motion::ACTOR)
      {
        reference.emplace(renderer);
      }
      truths.Views.back().push_back(reference->Trace(light, setup.Width, setup.Height));
      if (truths.Samples.empty())
      {
        truths.Samples = reference->Samples(light, setup.Width, setup.Height);
      }
    }
  }
  return truths;
}
}

const rtw::Truth* Truths::Find(int place, int step) const
{
  const bool isKnown = std::size_t(place) < this->Views.size() &&
    std::size_t(step) < this->Views[std::size_t(place)].size();
  return isKnown ? &this->Views[std::size_t(place)][std::size_t(step)] : nullptr;
}

std::shared_ptr<const Truths> TruthsOf(const Setup& setup, const Options& options)
{
  const int views = setup.LeastPlaces(options);
  const int steps = setup.Flickers ? setup.Laps(options) : 1;
  static std::shared_ptr<const Truths> last;
  static std::string lastKey;
  const std::string key =
    setup.Content() + " " + std::to_string(views) + " " + std::to_string(steps);
  if (key != lastKey)
  {
    last.reset();
    last = std::make_shared<const Truths>(Trace(setup, views, steps));
    lastKey = key;
  }
  return last;
}
