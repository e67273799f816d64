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
constexpr int ELSEWHERE = 7; // a place that is measured last if at all
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
    , IsRebuilding(contestant.Rebuilding)
    , View(
        setup.Width, setup.Height,
        [&](vtkRenderer* renderer) { Populate(setup, *scene, renderer); }, std::move(technique))
    , Way(setup, scene, this->View.GetRenderer())
  {
    this->View.SetRebuilding(contestant.Rebuilding);
  }

  std::string Label;
  bool IsRebuilding;
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
double Contest::Round(std::vector<std::unique_ptr<Place>>& places, int place, int lap)
{
  double sum = 0;
  std::rotate(places.begin(), places.begin() + 1, places.end());
  for (const std::unique_ptr<Place>& own : places)
  {
    own->Way.MoveTo(place, std::max(lap, 0));
    const rtw::FrameTime time = own->View.Render();
    sum += time.Wall;
    if (lap < 0)
    {
      continue;
    }
    Lap& to = this->Outcomes[own->Label].Laps[std::size_t(lap)];
    to.Wall.push_back(time.Wall);
    to.Cpu.push_back(time.Cpu);
    to.Gpu.push_back(time.Gpu);
    to.Work.push_back(time.Work);
    for (const rtw::Stage& stage : own->View.GetStages())
    {
      to.Stages[stage.Name].push_back(stage.Milliseconds);
    }
    const rtw::Technique* technique = own->View.GetTechnique();
    if (technique && technique->GoesOnAfterMask())
    {
      this->Compare(*own, place, lap);
    }
  }
  return sum;
}

// The frame that has just been drawn with the truth, where that is known.
void Contest::Compare(Place& own, int place, int step)
{
  const auto truths = TruthsOf(this->On, this->Settings);
  const rtw::Truth* truth = truths->Find(place, step);
  if (!truth)
  {
    return;
  }
  rtw::Technique* technique = own.View.GetTechnique();
  Outcome& outcome = this->Outcomes[own.Label];
  outcome.Memory = std::max(outcome.Memory, technique->GetMemory());
  const rtw::TexelFunction texels =
    place == 0 && step == 0 ? technique->GetTexels() : rtw::TexelFunction();
  if (texels)
  {
    outcome.Aliasing = rtw::Summarize(rtw::AliasingErrors(truths->Samples, texels));
  }
  const std::vector<unsigned char> mask = technique->MakeMask();
  outcome.Errors += rtw::Compare(mask, *truth);
  if (this->On.Flickers)
  {
    if (step == 0)
    {
      outcome.Flickering.StartAnew();
    }
    outcome.Flickering.Add(mask, *truth);
  }
}

// Whose masks spoil the scene have them when all is measured. Kept maps do not flicker.
void Contest::CompareLate(Place& own)
{
  const auto truths = TruthsOf(this->On, this->Settings);
  for (int place = 0; truths->Find(place, 0); ++place)
  {
    for (int step = 0; truths->Find(place, step) && (step == 0 || own.IsRebuilding); ++step)
    {
      own.Way.MoveTo(place, step);
      this->Compare(own, place, step);
    }
  }
}

// As many places as there is time for, but twice as many each time, so that another run of the same
// has them too.
int Contest::NumberOfPlaces(double round, double left) const
{
  int places = this->On.LeastPlaces(this->Settings);
  while (2 * places <= this->Settings.Frames && 2 * places * this->Settings.Laps * round < left)
  {
    places *= 2;
  }
  return places;
}

void Contest::Measure(Budget& budget)
{
  budget.StartTask();
  const auto scene = SceneOf(this->On);
  this->Triangles = std::size_t(1 + this->On.Outside) * rtw::NumberOfTriangles(*scene);
  TruthsOf(this->On, this->Settings); // before the time of frames is reckoned
  std::vector<std::unique_ptr<Place>> places;
  for (const Contestant& contestant : this->Who)
  {
    this->Outcomes[contestant.Label].Laps.resize(std::size_t(this->Settings.Laps));
    places.push_back(std::make_unique<Place>(this->On, scene, contestant, this->Make(contestant)));
  }
  this->Actors = places.front()->View.GetRenderer()->GetActors()->GetNumberOfItems();
  const double round = this->Round(places, ELSEWHERE, -1);
  const int number = this->NumberOfPlaces(round, budget.Left());
  for (int place = 0; place < number; ++place)
  {
    for (int lap = 0; lap < this->Settings.Laps; ++lap)
    {
      this->Round(places, place, lap);
    }
  }
  for (const std::unique_ptr<Place>& place : places)
  {
    const rtw::Technique* technique = place->View.GetTechnique();
    if (technique && !technique->GoesOnAfterMask())
    {
      this->CompareLate(*place);
    }
  }
}
