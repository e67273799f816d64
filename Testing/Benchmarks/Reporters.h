// SPDX-License-Identifier: BSD-3-Clause
// What Google Benchmark tells of the lines: a table to read, and JSON to keep.
#ifndef Reporters_h
#define Reporters_h

#include <benchmark/benchmark.h>

#include <string>

/// One row a line, in the middle of its repetitions.
class TableReporter : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

private:
  std::string Setup;
};

/// Google Benchmark's own, with the CPU's time of a frame in the place of the little that it takes
/// to tell what was measured before.
class FileReporter : public benchmark::JSONReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override;
};

#endif
