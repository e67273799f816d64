// SPDX-License-Identifier: BSD-3-Clause
#include "Contest.h"

#include "Faults.h"
#include "SetupScene.h"
#include "Truths.h"

#include "rtwTechniqueView.h"

#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int WARM_UP = 3;      // rounds, while time allows: stage times are two frames late
constexpr int ERROR_ROUNDS = 4; // that comparing the pixels of one place takes, about

rtw::ShadowErrors Sum(const rtw::ShadowErrors& a, const rtw::ShadowErrors& b)
{
  rtw::ShadowErrors sum = a;
  sum.LitFacing += b.LitFacing;
  sum.Shadowed += b.Shadowed;
  sum.WronglyDark += b.WronglyDark;
  sum.WronglyLit += b.WronglyLit;
  sum.NotComparable += b.NotComparable;
  sum.FarFromEdge += b.FarFromEdge;
  sum.AtEdge += b.AtEdge;
  return sum;
}
}

std::vector<Contestant> MakeContestants(const Options& options)
{
  std::vector<Contestant> contestants = { { "none", "", false }, { YARDSTICK, "vtk", true },
    { "vtk-kept", "vtk", false } };
  for (const std::string& name : rtw::TechniqueNames())
  {
    const auto& asked = options.Techniques;
    const bool isAsked =
      asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
    if (name != "vtk" && isAsked)
    {
      contestants.push_back({ name, name, false });
    }
  }
  return contestants;
}

std::string LineName(const Setup& setup, const Contestant& contestant)
{
  return setup.Name() + "/technique:" + contestant.Label;
}

struct Contest::Place
{
  Place(const Setup& setup, const std::shared_ptr<const rtw::Scene>& scene,
    const Contestant& contestant, std::unique_ptr<rtw::Technique> technique)
    : Label(contestant.Label)
    , View(
        setup.Width, setup.Height,
        [&](vtkRenderer* renderer) { Populate(setup, *scene, renderer); }, std::move(technique))
    , Way(setup, scene, this->View.GetRenderer())
  {
    this->View.SetRebuilding(contestant.Rebuilding);
  }

  std::string Label;
  rtw::TechniqueView View;
  Mover Way;
};

Contest::Contest(Setup setup, std::vector<Contestant> contestants, const Options& options)
  : On(std::move(setup))
  , Who(std::move(contestants))
  , Settings(options)
{
}

std::unique_ptr<rtw::Technique> Contest::Make(const Contestant& contestant) const
{
  if (contestant.Technique.empty())
  {
    return nullptr;
  }
  rtw::TechniqueSettings settings;
  settings.Resolution = this->On.Resolution;
  settings.Stages = true;
  const bool isFaulty = contestant.Technique == "rtw" && !this->Settings.Fault.empty();
  return isFaulty ? MakeFaulty(this->Settings.Fault, settings)
                  : rtw::MakeTechnique(contestant.Technique, settings);
}

// A frame of each; another begins each time. Laps below zero are to warm up. Returns the
// milliseconds that it took.
double Contest::Round(std::vector<std::unique_ptr<Place>>& places, double t, int lap)
{
  double sum = 0;
  std::rotate(places.begin(), places.begin() + 1, places.end());
  for (const std::unique_ptr<Place>& place : places)
  {
    place->Way.MoveTo(t);
    const rtw::FrameTime time = place->View.Render();
    sum += time.Wall;
    if (lap < 0)
    {
      continue;
    }
    Lap& to = this->Outcomes[place->Label].Laps[std::size_t(lap)];
    to.Wall.push_back(time.Wall);
    to.Cpu.push_back(time.Cpu);
    to.Gpu.push_back(time.Gpu);
    for (const rtw::Stage& stage : place->View.GetStages())
    {
      to.Stages[stage.Name].push_back(stage.Milliseconds);
    }
  }
  return sum;
}

void Contest::Compare(Place& place)
{
  const auto truths = TruthsOf(this->On, this->Settings.ErrorViews);
  rtw::Technique* technique = place.View.GetTechnique();
  Outcome& outcome = this->Outcomes[place.Label];
  for (std::size_t i = 0; i < truths->Places.size(); ++i)
  {
    place.Way.MoveTo(truths->Places[i]);
    place.View.Render();
    outcome.Memory = std::max(outcome.Memory, technique->GetMemory());
    const rtw::TexelFunction texels = i == 0 ? technique->GetTexels() : rtw::TexelFunction();
    if (texels)
    {
      outcome.Aliasing = rtw::Summarize(rtw::AliasingErrors(truths->Samples, texels));
    }
    outcome.Errors = Sum(outcome.Errors, rtw::Compare(technique->MakeMask(), truths->Views[i]));
  }
}

void Contest::CompareSteps(Place& place)
{
  const auto truths = TruthsOf(this->On, this->Settings.ErrorViews);
  const auto scene = SceneOf(this->On);
  for (std::size_t i = 0; i < truths->Steps.size(); ++i)
  {
    rtw::Apply(rtw::CameraOnTinyPath(*scene, int(i)), place.View.GetRenderer()->GetActiveCamera());
    place.View.Render();
    this->Outcomes[place.Label].Flickering.Add(
      place.View.GetTechnique()->MakeMask(), truths->Steps[i]);
  }
}

void Contest::Measure(Budget& budget)
{
  budget.StartTask();
  const auto scene = SceneOf(this->On);
  this->Triangles = std::size_t(1 + this->On.Outside) * rtw::NumberOfTriangles(*scene);
  const auto truths = TruthsOf(this->On, this->Settings.ErrorViews);
  std::vector<std::unique_ptr<Place>> places;
  for (const Contestant& contestant : this->Who)
  {
    this->Outcomes[contestant.Label].Laps.resize(std::size_t(this->Settings.Laps));
    places.push_back(std::make_unique<Place>(this->On, scene, contestant, this->Make(contestant)));
  }
  this->Actors = places.front()->View.GetRenderer()->GetActors()->GetNumberOfItems();
  double round = 0;
  for (int i = 0; i < WARM_UP && (i == 0 || budget.Left() > 0.7 * budget.Whole()); ++i)
  {
    round = this->Round(places, (i + 0.5) / WARM_UP, -1); // where no frame is measured
  }
  const int laps = this->Settings.Laps;
  const double left =
    budget.Left() - ERROR_ROUNDS * round * double(truths->Places.size() + truths->Steps.size());
  const int frames =
    int(std::clamp(left / (laps * std::max(round, 1e-3)), 1.0, double(this->Settings.Frames)));
  for (int lap = 0; lap < laps; ++lap)
  {
    for (int i = 0; i < frames; ++i)
    {
      // Laps are shifted, so that no two frames are alike.
      this->Round(places, (i + double(lap) / laps) / frames, lap);
    }
  }
  for (const std::unique_ptr<Place>& place : places)
  {
    if (place->View.GetTechnique())
    {
      this->Compare(*place);
      this->CompareSteps(*place);
    }
  }
}
