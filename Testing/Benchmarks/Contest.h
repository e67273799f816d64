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

/// Who takes part: no shadows, VTK's own pass with and without new maps for each frame, and the
/// techniques.
struct Contestant
{
  std::string Label;     // in names
  std::string Technique; // empty for no shadows
  bool Rebuilding;       // new maps for each frame, whether or not the technique wants them
};

/// With whom all others are compared.
constexpr const char* YARDSTICK = "vtk";

std::vector<Contestant> MakeContestants(const Options& options);

std::string LineName(const Setup& setup, const Contestant& contestant);

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
  Contest(Setup setup, std::vector<Contestant> contestants, const Options& options);

  const Setup& GetSetup() const { return this->On; }
  const std::vector<Contestant>& GetContestants() const { return this->Who; }
  std::size_t GetTriangles() const { return this->Triangles; }
  int GetActors() const { return this->Actors; }

  bool IsMeasured() const { return !this->Outcomes.empty(); }
  void Measure(Budget& budget);

  const Outcome& GetOutcome(const std::string& label) const { return this->Outcomes.at(label); }

private:
  struct Place; // a contestant's window

  std::unique_ptr<rtw::Technique> Make(const Contestant& contestant) const;
  double Round(std::vector<std::unique_ptr<Place>>& places, int place, int lap);
  void Compare(Place& own, int place, int step);
  void CompareLate(Place& own);
  int NumberOfPlaces(double round, double left) const;

  Setup On;
  std::vector<Contestant> Who;
  const Options& Settings;
  std::size_t Triangles = 0;
  int Actors = 0;
  std::map<std::string, Outcome> Outcomes;
};

#endif
