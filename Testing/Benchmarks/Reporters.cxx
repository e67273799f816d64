// SPDX-License-Identifier: BSD-3-Clause
#include "Reporters.h"

#include "rtwQuantile.h"

#include <cstdio>
#include <ostream>

namespace
{
const char TECHNIQUE[] = "/technique:";
const char VARIANT[] = "/variant:";

// "rtw/variant:linear" as "rtw linear".
std::string Short(std::string technique)
{
  const std::size_t at = technique.find(VARIANT);
  return at == std::string::npos ? technique : technique.replace(at, sizeof VARIANT - 1, " ");
}

std::string Cell(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// The middle of the repetitions, where the line has that counter.
std::string Middle(const std::vector<benchmark::BenchmarkReporter::Run>& runs,
  const std::string& counter, const char* format, double unit = 1)
{
  std::vector<double> values;
  for (const auto& run : runs)
  {
    const auto at = run.counters.find(counter);
    if (run.run_type == benchmark::BenchmarkReporter::Run::RT_Iteration && at != run.counters.end())
    {
      values.push_back(at->second.value);
    }
  }
  return values.empty() ? "-" : Cell(format, rtw::Median(values) / unit);
}

std::string MiddleTime(const std::vector<benchmark::BenchmarkReporter::Run>& runs)
{
  std::vector<double> values;
  for (const auto& run : runs)
  {
    if (run.run_type == benchmark::BenchmarkReporter::Run::RT_Iteration)
    {
      values.push_back(run.GetAdjustedRealTime());
    }
  }
  return Cell("%.2f", rtw::Median(values));
}
}

bool TableReporter::ReportContext(const Context&)
{
  return true;
}

void TableReporter::ReportRuns(const std::vector<Run>& runs)
{
  if (runs.front().run_type == Run::RT_Aggregate)
  {
    return; // of the runs before
  }
  const std::string name = runs.front().run_name.function_name;
  const std::size_t at = name.find(TECHNIQUE);
  std::ostream& out = this->GetOutputStream();
  if (name.substr(0, at) != this->Setup)
  {
    this->Setup = name.substr(0, at);
    out << "\n" << this->Setup << "\n";
    out << "  technique                            ms   95 %     cpu   to vtk  to none   wrong %   "
           "  far %      MiB"
           "  frames\n";
  }
  char line[256];
  std::snprintf(line, sizeof line, "  %-30s %8s %6s %7s %8s %8s %9s %9s %8s %7s\n",
    Short(name.substr(at + sizeof TECHNIQUE - 1)).c_str(), MiddleTime(runs).c_str(),
    Middle(runs, "p95_ms", "%.1f").c_str(), Middle(runs, "cpu_ms", "%.1f").c_str(),
    Middle(runs, "to_vtk", "%.3f").c_str(), Middle(runs, "to_none", "%.3f").c_str(),
    Middle(runs, "wrong_percent", "%.4f").c_str(), Middle(runs, "far_percent", "%.4f").c_str(),
    Middle(runs, "memory_bytes", "%.1f", 1048576).c_str(), Middle(runs, "frames", "%.0f").c_str());
  out << line << std::flush;
}

void FileReporter::ReportRuns(const std::vector<Run>& runs)
{
  std::vector<Run> changed = runs;
  for (Run& run : changed)
  {
    // Names with nothing of how they were registered.
    run.run_name.iterations.clear();
    run.run_name.repetitions.clear();
    run.run_name.time_type.clear();
    run.cpu_accumulated_time = 1e-3 * run.counters.at("cpu_ms").value * double(run.iterations);
  }
  JSONReporter::ReportRuns(changed);
  this->GetOutputStream().flush();
}
