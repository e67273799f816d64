// SPDX-License-Identifier: BSD-3-Clause
#include "Lines.h"

#include "Contest.h"

#include "rtwQuantile.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>
#include <regex>

namespace
{
double Total(const std::vector<double>& times)
{
  return std::accumulate(times.begin(), times.end(), 0.0);
}

void CountLap(const Contest& contest, std::size_t contestant, std::size_t lap,
  benchmark::UserCounters& counters)
{
  const auto work = [&](std::size_t who) { return Total(contest.GetOutcome(who).Laps[lap].Work); };
  const Lap& mine = contest.GetOutcome(contestant).Laps[lap];
  counters["frames"] = double(mine.Wall.size());
  counters["p95_ms"] = rtw::Quantile(mine.Wall, 0.95);
  counters["cpu_ms"] = rtw::Median(mine.Cpu);
  counters["gpu_ms"] = rtw::Median(mine.Gpu);
  counters["work_ms"] = rtw::Median(mine.Work);
  counters["to_vtk"] = work(contestant) / work(YARDSTICK);
  counters["to_none"] = work(contestant) / work(NO_SHADOWS);
  for (const auto& [stage, times] : mine.Stages)
  {
    counters["gpu_ms:" + stage] = rtw::Median(times);
  }
}

void CountErrors(const Outcome& outcome, benchmark::UserCounters& counters)
{
  const rtw::ShadowErrors& errors = outcome.Errors;
  counters["pixels"] = double(errors.LitFacing);
  counters["wrong_pixels"] = double(errors.Wrong());
  counters["wrong_percent"] = errors.Percent(errors.Wrong());
  counters["wrongly_dark_percent"] = errors.Percent(errors.WronglyDark);
  counters["wrongly_lit_percent"] = errors.Percent(errors.WronglyLit);
  counters["far_percent"] = errors.Percent(errors.FarFromEdge);
  counters["far_dark_percent"] = errors.Percent(errors.DarkFarFromEdge);
  counters["far_lit_percent"] = errors.Percent(errors.LitFarFromEdge());
  counters["near_percent"] = errors.Percent(errors.NearEdge());
  counters["near_dark_percent"] = errors.Percent(errors.DarkNearEdge());
  counters["near_lit_percent"] = errors.Percent(errors.LitNearEdge());
  counters["undecided_percent"] = errors.Percent(errors.NotComparable);
  counters["memory_bytes"] = double(outcome.Memory);
  if (outcome.Aliasing.Pixels > 0)
  {
    counters["aliasing_max"] = outcome.Aliasing.Maximum;
    counters["aliasing_mean"] = outcome.Aliasing.Mean;
    counters["aliasing_p95"] = outcome.Aliasing.Percentile95;
  }
  if (!outcome.Flickering.Percents().empty())
  {
    counters["flicker_percent"] = outcome.Flickering.MeanPercent();
    counters["flicker_max_percent"] = outcome.Flickering.GreatestPercent();
  }
}

void CountSetup(const Contest& contest, std::size_t contestant, benchmark::UserCounters& counters)
{
  const Setup& setup = contest.GetSetup();
  counters["resolution"] = setup.ResolutionOf(setup.Who[contestant]);
  counters["width"] = setup.Width;
  counters["height"] = setup.Height;
  counters["triangles"] = double(contest.GetTriangles());
  counters["actors"] = contest.GetActors();
  counters["lights"] = setup.Lights;
  counters["outside"] = setup.Outside;
}

// The first line of a contest to be run measures all of them; the others tell what it found. Each
// repetition is a lap, and its time the median of the lap's frames.
void Tell(benchmark::State& state, Contest& contest, std::size_t contestant, Budget& budget,
  std::size_t& lap)
{
  if (!contest.IsMeasured())
  {
    contest.Measure(budget);
  }
  const Outcome& outcome = contest.GetOutcome(contestant);
  for (auto _ : state)
  {
    state.SetIterationTime(1e-3 * rtw::Median(outcome.Laps[lap].Wall));
  }
  CountSetup(contest, contestant, state.counters);
  CountLap(contest, contestant, lap, state.counters);
  if (outcome.Errors.LitFacing > 0)
  {
    CountErrors(outcome, state.counters);
  }
  lap = (lap + 1) % outcome.Laps.size();
}

// The contestants of lines that are asked for. Without the yardsticks there are no ratios; but they
// alone are nothing that was asked for if no name matches.
std::vector<Contestant> Matching(const Setup& setup, const Options& options)
{
  const std::regex filter(options.Filter);
  const auto isAsked = [&](const Contestant& contestant) {
    const auto& asked = options.Techniques;
    const bool isYardstick = contestant.Technique.empty() || contestant.Technique == "vtk";
    return std::regex_search(setup.LineName(contestant), filter) &&
      (isYardstick || (asked.empty() && !contestant.IsOnlyByName()) ||
        std::find(asked.begin(), asked.end(), contestant.Technique) != asked.end());
  };
  if (std::none_of(setup.Who.begin(), setup.Who.end(), isAsked))
  {
    return {};
  }
  const auto first = setup.Who.begin(), rest = first + 2;
  std::vector<Contestant> who(first, rest);
  std::copy_if(rest, setup.Who.end(), std::back_inserter(who), isAsked);
  return who;
}
}

std::vector<std::string> RegisterLines(const Options& options)
{
  std::vector<std::shared_ptr<Contest>> contests;
  for (Setup& setup : MakeSetups(options))
  {
    setup.Who = Matching(setup, options);
    if (!setup.Who.empty())
    {
      contests.push_back(std::make_shared<Contest>(std::move(setup), options));
    }
  }
  const auto budget = std::make_shared<Budget>(options.Minutes, int(contests.size()));
  std::vector<std::string> names;
  for (const std::shared_ptr<Contest>& contest : contests)
  {
    const Setup& setup = contest->GetSetup();
    for (std::size_t i = 0; i < setup.Who.size(); ++i)
    {
      names.push_back(setup.LineName(setup.Who[i]));
      const auto lap = std::make_shared<std::size_t>(0);
      benchmark::RegisterBenchmark(names.back().c_str(),
        [contest, i, budget, lap](
          benchmark::State& state) { Tell(state, *contest, i, *budget, *lap); })
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(setup.Laps(options))
        ->Unit(benchmark::kMillisecond);
    }
  }
  return names;
}
