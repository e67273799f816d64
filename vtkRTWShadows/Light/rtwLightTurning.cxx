// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwLightTurning.h"

#include "Light/rtwTurnChoice.h"

namespace rtw
{
namespace
{
// Viewers that are remembered, of whom some may be gone without having said so.
constexpr std::size_t MostViewers = 64;
// Length of a projected direction below which it is nothing but rounding.
constexpr double LeastAlong = 1e-6;
}

bool LightTurning::IsBySamples() const
{
  return this->Kind == Turning::Automatic || this->IsByArea();
}

void LightTurning::Begin(Turning kind, const void* viewer, const std::vector<ShadowLight>& lights,
  const View& view, const std::vector<double>& minimal)
{
  const bool isOther = this->Kind != kind;
  this->Kind = kind;
  this->Viewer = viewer;
  this->Turns.assign(lights.size(), 0.0);
  this->Candidates.clear();
  if (isOther || !this->IsBySamples() || this->Choices.size() > MostViewers)
  {
    this->Forget(Disposal::Release());
  }
  if (kind == Turning::MinimalFrustum)
  {
    this->Turns = minimal;
  }
  std::vector<double> aligned;
  for (const ShadowLight& light : lights)
  {
    aligned.push_back(ViewAlignedTurn(
      light, view.Origin, view.Forward, kind == Turning::AlongView ? LeastAlong : LeastShownAlong));
  }
  if (kind == Turning::ViewAligned || kind == Turning::AlongView)
  {
    this->Turns = aligned;
  }
  if (!this->IsBySamples())
  {
    return;
  }
  Choice& choice = this->Choices[viewer];
  if (choice.Turns.size() != lights.size())
  {
    choice.Turns = this->Turns;
    choice.Decided = false;
    choice.Asked = 0;
    choice.Answer.Release(); // it is about other lights
  }
  if (choice.Answer.IsReady())
  {
    Take(choice);
  }
  this->Turns = choice.Turns;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    this->Candidates.push_back(this->IsByArea() ? AreaCandidates(this->Turns[i], minimal[i])
                                                : TurnCandidates(this->Turns[i], aligned[i]));
  }
}

bool LightTurning::IsUndecided() const
{
  const auto choice = this->Choices.find(this->Viewer);
  return choice != this->Choices.end() && !choice->second.Decided;
}

bool LightTurning::IsToAsk(std::uint64_t signature)
{
  if (!this->IsBySamples())
  {
    return false;
  }
  const Choice& choice = this->Choices[this->Viewer];
  return !choice.Answer.IsUnderWay() && choice.Asked != signature && this->Stage.Build();
}

void LightTurning::Ask(
  const std::vector<TurnedLight>& lights, const TurnInput& input, std::uint64_t signature)
{
  Choice& choice = this->Choices[this->Viewer];
  choice.Compared = this->Candidates;
  choice.Asked = signature;
  this->Stage.Start(lights, input, choice.Answer);
}

void LightTurning::Take(Choice& choice) const
{
  std::size_t count = 0;
  for (const std::vector<double>& turns : choice.Compared)
  {
    count += turns.size();
  }
  std::vector<float> errors(count);
  if (!choice.Answer.Read(errors.data()))
  {
    return;
  }
  auto first = errors.begin();
  for (std::size_t i = 0; i < choice.Turns.size(); ++i)
  {
    const std::vector<double>& turns = choice.Compared[i];
    const auto end = first + static_cast<std::ptrdiff_t>(turns.size());
    const std::vector<float> measures(first, end);
    choice.Turns[i] = turns[this->IsByArea() ? LeastTurn(measures) : BestTurn(measures)];
    first = end;
  }
}

bool LightTurning::Wait()
{
  Choice& choice = this->Choices[this->Viewer];
  Take(choice);
  choice.Decided = true; // even if in vain: it isn't tried in each frame
  const bool isBetter = this->Turns != choice.Turns;
  this->Turns = choice.Turns;
  return isBetter;
}

void LightTurning::Forget(Disposal dispose)
{
  for (auto& choice : this->Choices)
  {
    dispose(choice.second.Answer);
  }
  this->Choices.clear();
}

void LightTurning::Dispose(Disposal dispose)
{
  dispose(this->Stage);
  this->Forget(dispose);
  this->Turns.clear();
  this->Candidates.clear();
}
}
