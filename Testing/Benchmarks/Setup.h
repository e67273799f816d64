// SPDX-License-Identifier: BSD-3-Clause
#ifndef Setup_h
#define Setup_h

#include "Contestant.h"
#include "Options.h"

#include <cstddef>
#include <string>
#include <vector>

/// What changes from frame to frame.
enum class Motion
{
  CAMERA,
  NOTHING,
  LIGHT,
  ACTOR
};

/// What contestants are measured on, beside each other.
struct Setup
{
  std::string Family;
  std::string Variable; // what differs within the family besides the map, as it stands in names
  std::string Scene = "town";
  int Resolution = 1024; // texels a side of a shadow map
  int Width = 512;
  int Height = 512;
  std::size_t Triangles = 0; // about; 0 for as many as the scene has by itself
  int Actors = 1;            // that the scene is split into
  int Lights = 1;
  int Outside = 0; // copies of the scene behind the camera
  Motion Moves = Motion::CAMERA;
  bool IsHeavy = false;  // so that one place on its way has to do
  bool Flickers = false; // whether it is told how much shadows flicker
  int Places = 0;        // where pixels are compared; 0 for as many as the options say
  int MostLaps = 1000;   // where frames are many or heavy
  std::vector<Contestant> Who = AllTechniques();

  std::string LineName(const Contestant& contestant) const;
  int ResolutionOf(const Contestant& contestant) const;
  int Laps(const Options& options) const;
  /// Where its pixels are compared, and at least measured.
  int LeastPlaces(const Options& options) const;
  /// Setups with equal contents have the same exact shadows.
  std::string Content() const;
};

std::vector<std::string> FamilyNames();
std::string FamilyDescription(const std::string& family);
/// Whether it is measured where no families are asked for.
bool IsByDefault(const std::string& family);
/// What measuring those families, or those by default, may take.
double DefaultMinutes(const std::vector<std::string>& families, bool quick);

/// All that the options ask for, the heaviest last.
std::vector<Setup> MakeSetups(const Options& options);

#endif
