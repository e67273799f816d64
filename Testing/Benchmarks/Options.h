// SPDX-License-Identifier: BSD-3-Clause
#ifndef Options_h
#define Options_h

#include "rtwCommandLine.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What is measured, and for how long.
struct Options
{
  bool Quick = false;
  std::vector<std::string> Families;   // those by default if empty
  std::vector<std::string> Scenes;     // of families that go over scenes; their own if empty
  std::vector<std::string> Techniques; // if empty, all that aren't slow
  std::vector<int> Resolutions;        // of maps; the families' own if empty
  std::pair<int, int> Size{ 0, 0 };    // of the picture; 0 for 512 x 512, or 256 x 256 if quick
  int Triangles = 0;                   // of scenes; 0 for their own, or 20 000 if quick
  double Minutes = 0;                  // aimed at; 0 for what the families may take
  int Frames = 60;                     // of a lap, at places along the path, at most
  int Laps = 3;                        // the benchmark's repetitions, a tiny step apart
  int ErrorViews = 2;                  // of those places, where pixels are compared
  std::string Filter;
  std::string OutputFile;
  std::string Fault; // none if empty
  bool List = false;
};

/// None where only the help was asked for, which is printed then. Throws rtw::UsageError.
std::optional<Options> ParseOptions(int argc, char* argv[]);

#endif
