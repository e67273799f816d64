// SPDX-License-Identifier: BSD-3-Clause
#include "ReportOptions.h"

#include "rtwCommandLine.h"

namespace
{
std::vector<rtw::CommandLineOption> Entries(ReportOptions& options)
{
  return {
    { "--out", "DIR", "for RESULTS.md and what it shows; default this folder",
      [&](const std::string& value) { options.OutputFolder = value; } },
    { "--check", "", "exit code 3 if a line has become worse",
      [&](const std::string&) { options.Check = true; } },
    { "--help", "", "print this", [&](const std::string&) { options.Help = true; } },
  };
}
}

ReportOptions ParseOptions(int argc, char* argv[])
{
  ReportOptions options;
  rtw::ParseCommandLine(argc, argv, Entries(options),
    [&](const std::string& argument) { options.Files.push_back(argument); });
  if (options.Files.empty() && !options.Help)
  {
    throw rtw::UsageError("no file is given: expected what shadow-benchmark --benchmark_out wrote");
  }
  return options;
}

std::string HelpText()
{
  ReportOptions options;
  return "shadow-report FILE.json ... [OPTION ...]\n\n"
         "Makes tables and plots of what shadow-benchmark wrote: RESULTS.md, and for each OpenGL\n"
         "renderer RESULTS-renderer.md, since times on different ones have nothing to do with "
         "each\n"
         "other. Files of one renderer that have no line in common are one run, such as of "
         "several\n"
         "families. Of several runs the last is shown, and compared with the first: lines that "
         "have\n"
         "become slower or less accurate by more than noise are told.\n\n" +
    rtw::OptionsHelp(Entries(options));
}
