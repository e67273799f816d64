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

struct Contest::Place
{
  Place(const Setup& setup, const std::shared_ptr<const rtw::Scene>& scene,
    const Contestant& contestant, std::unique_ptr<rtw::Technique> technique, Outcome& found)
    : Found(found)
    , IsRebuilding(contestant.Rebuilding)
    , LeadsIn(contestant.LeadsIn)
    , View(
        setup.Width, setup.Height,
        [&](vtkRenderer* renderer) { Populate(setup, *scene, renderer); }, std::move(technique))
    , Way(setup, scene, this->View.GetRenderer())
  {
    this->View.SetRebuilding(contestant.Rebuilding);
  }

  Outcome& Found;
  Lap* Last = nullptr; // that the last frame counted in, if it did
  bool IsRebuilding;
  bool LeadsIn;
  rtw::TechniqueView View;
  Mover Way;
};

Contest::Contest(Setup setup, const Options& options)
  : On(std::move(setup))
  , Settings(options)
{
}

std::unique_ptr<rtw::Technique> Contest::Make(const Contestant& contestant) const
{
  if (contestant.Technique.empty())
  {
    return nullptr;
  }
  rtw::TechniqueSettings settings = contestant.Settings;
  settings.Resolution = this->On.ResolutionOf(contestant);
  settings.Stages = true;
  const bool isFaulty = contestant.Technique == "rtw" && !this->Settings.Fault.empty();
  return isFaulty ? MakeFaulty(this->Settings.Fault, settings)
                  : rtw::MakeTechnique(contestant.Technique, settings);
}

// Those that are known after a frame are of the one before.
void Contest::CollectStages(Place& own)
{
  if (own.Last)
  {
    for (const rtw::Stage& stage : own.View.GetStages())
    {
      own.Last->Stages[stage.Name].push_back(stage.Milliseconds);
    }
  }
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
    this->CollectStages(*own);
    own->Last = nullptr;
    if (lap < 0)
    {
      continue;
    }
    own->Last = &own->Found.Laps[std::size_t(lap)];
    own->Last->Wall.push_back(time.Wall);
    own->Last->Cpu.push_back(time.Cpu);
    own->Last->Gpu.push_back(time.Gpu);
    own->Last->Work.push_back(time.Work);
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
  Outcome& outcome = own.Found;
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

// Whose masks spoil the scene have them when all is measured, and flicker told from the first place
// alone, as each costs frames. Kept maps do not flicker.
void Contest::CompareLate(Place& own)
{
  const auto truths = TruthsOf(this->On, this->Settings);
  for (int place = 0; truths->Find(place, 0); ++place)
  {
    for (int step = 0;
         truths->Find(place, step) && (step == 0 || (place == 0 && own.IsRebuilding)); ++step)
    {
      own.Way.MoveTo(place, step);
      this->Compare(own, place, step);
    }
  }
}

// To where the next lap is a tiny step away.
void Contest::LeadIn(std::vector<std::unique_ptr<Place>>& places, int place)
{
  for (const std::unique_ptr<Place>& own : places)
  {
    if (own->LeadsIn)
    {
      own->Way.MoveTo(place, this->On.Laps(this->Settings));
      own->View.Render();
      own->Last = nullptr;
    }
  }
}

// Returns the milliseconds that it took.
double Contest::MeasurePlaces(std::vector<std::unique_ptr<Place>>& places, int first, int end)
{
  double sum = 0;
  for (int place = first; place < end; ++place)
  {
    this->LeadIn(places, place);
    for (int lap = 0; lap < this->On.Laps(this->Settings); ++lap)
    {
      sum += this->Round(places, place, lap);
    }
  }
  return sum;
}

void Contest::Measure(Budget& budget)
{
  budget.StartTask();
  const auto scene = SceneOf(this->On);
  this->Triangles = std::size_t(1 + this->On.Outside) * rtw::NumberOfTriangles(*scene);
  TruthsOf(this->On, this->Settings); // before the time of frames is reckoned
  std::vector<std::unique_ptr<Place>> places;
  this->Outcomes.resize(this->On.Who.size());
  for (std::size_t i = 0; i < this->On.Who.size(); ++i)
  {
    const Contestant& contestant = this->On.Who[i];
    this->Outcomes[i].Laps.resize(std::size_t(this->On.Laps(this->Settings)));
    places.push_back(std::make_unique<Place>(
      this->On, scene, contestant, this->Make(contestant), this->Outcomes[i]));
  }
  this->Actors = places.front()->View.GetRenderer()->GetActors()->GetNumberOfItems();
  this->Round(places, ELSEWHERE, -1);
  // As many places as there is time for, but twice as many each time, so that another run of the
  // same has them too.
  int end = this->On.LeastPlaces(this->Settings);
  double sum = this->MeasurePlaces(places, 0, end);
  for (; 2 * end <= this->Settings.Frames && sum < budget.Left(); end *= 2)
  {
    sum += this->MeasurePlaces(places, end, 2 * end);
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
