// SPDX-License-Identifier: BSD-3-Clause
// Measures shadow techniques: time, memory and wrong pixels.
#include "Lines.h"
#include "Options.h"
#include "Reporters.h"

#include <benchmark/benchmark.h>

#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRTWEGLRenderWindow.h>
#include <vtkVersion.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace
{
// The value of a line "name:  value" of what a window reports.
std::string Reported(const std::string& report, const std::string& name)
{
  const std::size_t at = report.find(name + ":");
  if (at == std::string::npos)
  {
    return "unknown";
  }
  const std::size_t begin = report.find_first_not_of(" \t", at + name.size() + 1);
  return report.substr(begin, report.find('\n', begin) - begin);
}

void AddContext(const Options& options)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  if (!window->SupportsOpenGL())
  {
    throw std::runtime_error("OpenGL does not work here");
  }
  const std::string report = window->ReportCapabilities();
  benchmark::AddCustomContext("gl_vendor", Reported(report, "OpenGL vendor string"));
  benchmark::AddCustomContext("gl_renderer", Reported(report, "OpenGL renderer string"));
  benchmark::AddCustomContext("gl_version", Reported(report, "OpenGL version string"));
  benchmark::AddCustomContext("vtk_version", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("build_type", RTW_BUILD_TYPE);
  benchmark::AddCustomContext("quick", options.Quick ? "yes" : "no");
  benchmark::AddCustomContext("laps", std::to_string(options.Laps));
  benchmark::AddCustomContext("fault", options.Fault.empty() ? "none" : options.Fault);
}

// Before anything is measured, because it is a pity to fail after minutes.
void CheckOutput(const Options& options)
{
  if (!options.OutputFile.empty() && !std::ofstream(options.OutputFile, std::ios::app))
  {
    throw rtw::UsageError("--benchmark_out " + options.OutputFile + ": the file cannot be written");
  }
}

void RunLines(const Options& options)
{
  std::vector<std::string> arguments = { "shadow-benchmark" };
  if (!options.OutputFile.empty())
  {
    arguments.push_back("--benchmark_out=" + options.OutputFile);
  }
  std::vector<char*> argv;
  for (std::string& argument : arguments)
  {
    argv.push_back(&argument[0]);
  }
  int argc = int(argv.size());
  benchmark::Initialize(&argc, argv.data());
  TableReporter table;
  FileReporter file;
  benchmark::RunSpecifiedBenchmarks(&table, options.OutputFile.empty() ? nullptr : &file);
  benchmark::Shutdown();
}

int Run(const Options& options)
{
  const std::vector<std::string> names = RegisterLines(options);
  if (names.empty())
  {
    throw rtw::UsageError("nothing is left to measure: no line of the chosen families matches " +
      options.Filter + "; --benchmark_list_tests tells them all");
  }
  if (options.List)
  {
    for (const std::string& name : names)
    {
      std::puts(name.c_str());
    }
    return 0;
  }
  CheckOutput(options);
  vtkRTWEGLRenderWindow::InstallAsDefault(false);
  AddContext(options);
  RunLines(options);
  return 0;
}
}

int main(int argc, char* argv[])
{
  return rtw::RunProgram("shadow-benchmark", [&] {
    const std::optional<Options> options = ParseOptions(argc, argv);
    return options ? Run(*options) : 0;
  });
}
