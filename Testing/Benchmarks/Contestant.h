// SPDX-License-Identifier: BSD-3-Clause
#ifndef Contestant_h
#define Contestant_h

#include "rtwTechnique.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Who takes part: no shadows, VTK's own pass with and without new maps for each frame, techniques,
/// and variants of them.
struct Contestant
{
  std::string Technique;   // empty for no shadows
  bool Rebuilding = false; // new maps for each frame, whether or not the technique wants them
  std::string Label{};     // in names; the technique's if empty
  std::string Variant{};   // in names after that; none if empty
  rtw::TechniqueSettings Settings{}; // but for the resolution
  std::optional<int> Resolution{};   // the setup's if not given
  bool LeadsIn = false; // whether a frame that does not count goes before those of each place,
                        // for what looks at the last frame

  /// Whether it takes part only where it is named: with all techniques a run would take an hour.
  bool IsOnlyByName() const
  {
    return this->Technique == "notw" || this->Technique == "perspective" ||
      this->Technique == "cascades" || this->Technique == "exact";
  }

  /// As in "technique:rtw/variant:linear".
  std::string Name() const;
};

/// With what all others are compared: the first two of any contest.
constexpr std::size_t NO_SHADOWS = 0;
constexpr std::size_t YARDSTICK = 1;
std::vector<Contestant> Yardsticks();

/// Those, and all techniques as they are by themselves.
std::vector<Contestant> AllTechniques();

#endif
