// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportOptions_h
#define ReportOptions_h

#include <string>
#include <vector>

struct ReportOptions
{
  std::vector<std::string> Files;
  std::string OutputFolder = ".";
  bool Check = false; // exit code 3 if anything has become worse
  bool Help = false;
};

/// Throws rtw::UsageError.
ReportOptions ParseOptions(int argc, char* argv[]);

std::string HelpText();

#endif
