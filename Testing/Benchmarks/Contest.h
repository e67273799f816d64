// SPDX-License-Identifier: BSD-3-Clause
#ifndef Contest_h
#define Contest_h

#include "Budget.h"
#include "Setup.h"

#include "rtwAliasing.h"
#include "rtwCompare.h"
#include "rtwFlicker.h"
#include "rtwTechnique.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// What a lap took, frame by frame, in milliseconds; see rtw::FrameTime. Laps differ by a tiny
/// step.
struct Lap
{
  std::vector<double> Wall, Cpu, Gpu, Work;
  std::map<std::string, std::vector<double>> Stages;
};

struct Outcome
{
  std::vector<Lap> Laps;
  rtw::ShadowErrors Errors;    // of all places together
  rtw::AliasingError Aliasing; // at the first place
  rtw::Flicker Flickering;
  int64_t Memory = 0;
};

/// Measures everybody on one setup, frame by frame in turn, so that what disturbs the machine
/// disturbs them alike.
class Contest
{
public:
  Contest(Setup setup, const Options& options);

  const Setup& GetSetup() const { return this->On; }
  std::size_t GetTriangles() const { return this->Triangles; }
  int GetActors() const { return this->Actors; }

  bool IsMeasured() const { return !this->Outcomes.empty(); }
  void Measure(Budget& budget);

  /// Of one of the setup's contestants, by number.
  const Outcome& GetOutcome(std::size_t contestant) const { return this->Outcomes.at(contestant); }

private:
  struct Place; // a contestant's window

  std::unique_ptr<rtw::Technique> Make(const Contestant& contestant) const;
  double Round(std::vector<std::unique_ptr<Place>>& places, int place, int lap);
  void LeadIn(std::vector<std::unique_ptr<Place>>& places, int place);
  static void CollectStages(Place& own);
  void Compare(Place& own, int place, int step);
  void CompareLate(Place& own);
  double MeasurePlaces(std::vector<std::unique_ptr<Place>>& places, int first, int end);

  Setup On;
  const Options& Settings;
  std::size_t Triangles = 0;
  int Actors = 0;
  std::vector<Outcome> Outcomes;
};

#endif
