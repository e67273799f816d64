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

void CountLap(const Contest& contest, const std::string& label, std::size_t lap,
  benchmark::UserCounters& counters)
{
  const Lap& mine = contest.GetOutcome(label).Laps[lap];
  counters["frames"] = double(mine.Wall.size());
  counters["p95_ms"] = rtw::Quantile(mine.Wall, 0.95);
  counters["cpu_ms"] = rtw::Median(mine.Cpu);
  counters["gpu_ms"] = rtw::Median(mine.Gpu);
  counters["work_ms"] = rtw::Median(mine.Work);
  counters["to_vtk"] = Total(mine.Work) / Total(contest.GetOutcome(YARDSTICK).Laps[lap].Work);
  counters["to_none"] = Total(mine.Work) / Total(contest.GetOutcome("none").Laps[lap].Work);
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

void CountSetup(const Contest& contest, benchmark::UserCounters& counters)
{
  const Setup& setup = contest.GetSetup();
  counters["resolution"] = setup.Resolution;
  counters["width"] = setup.Width;
  counters["height"] = setup.Height;
  counters["triangles"] = double(contest.GetTriangles());
  counters["actors"] = contest.GetActors();
  counters["lights"] = setup.Lights;
  counters["outside"] = setup.Outside;
}

// The first line of a contest to be run measures all of them; the others tell what it found. Each
// repetition is a lap, and its time the median of the lap's frames.
void Tell(benchmark::State& state, Contest& contest, const std::string& label, Budget& budget,
  std::size_t& lap)
{
  if (!contest.IsMeasured())
  {
    contest.Measure(budget);
  }
  const Outcome& outcome = contest.GetOutcome(label);
  for (auto _ : state)
  {
    state.SetIterationTime(1e-3 * rtw::Median(outcome.Laps[lap].Wall));
  }
  CountSetup(contest, state.counters);
  CountLap(contest, label, lap, state.counters);
  if (outcome.Errors.LitFacing > 0)
  {
    CountErrors(outcome, state.counters);
  }
  lap = (lap + 1) % outcome.Laps.size();
}

std::vector<Contestant> Matching(
  const Setup& setup, const std::vector<Contestant>& all, const std::regex& filter)
{
  std::vector<Contestant> matching;
  for (const Contestant& contestant : all)
  {
    if (std::regex_search(LineName(setup, contestant), filter))
    {
      matching.push_back(contestant);
    }
  }
  return matching;
}

// Without the two that the others are told in times of, there are no ratios.
std::vector<Contestant> WithYardsticks(
  const std::vector<Contestant>& matching, const std::vector<Contestant>& all)
{
  std::vector<Contestant> who(all.begin(), all.begin() + 2);
  std::copy_if(
    matching.begin(), matching.end(), std::back_inserter(who), [&](const Contestant& contestant) {
      return contestant.Label != who[0].Label && contestant.Label != who[1].Label;
    });
  return who;
}
}

std::vector<std::string> RegisterLines(const Options& options)
{
  const std::vector<Contestant> all = MakeContestants(options);
  const std::regex filter(options.Filter);
  std::vector<std::shared_ptr<Contest>> contests;
  for (const Setup& setup : MakeSetups(options))
  {
    const std::vector<Contestant> matching = Matching(setup, all, filter);
    if (!matching.empty())
    {
      contests.push_back(std::make_shared<Contest>(setup, WithYardsticks(matching, all), options));
    }
  }
  const auto budget = std::make_shared<Budget>(options.Minutes, int(contests.size()));
  std::vector<std::string> names;
  for (const std::shared_ptr<Contest>& contest : contests)
  {
    for (const Contestant& contestant : contest->GetContestants())
    {
      names.push_back(LineName(contest->GetSetup(), contestant));
      const auto lap = std::make_shared<std::size_t>(0);
      const std::string label = contestant.Label;
      benchmark::RegisterBenchmark(names.back().c_str(),
        [contest, label, budget, lap](
          benchmark::State& state) { Tell(state, *contest, label, *budget, *lap); })
        ->UseManualTime()
        ->Iterations(1)
        ->Repetitions(options.Laps)
        ->Unit(benchmark::kMillisecond);
    }
  }
  return names;
}
