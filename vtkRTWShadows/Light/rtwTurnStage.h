// SPDX-License-Identifier: BSD-3-Clause
// The errors that a light's map would have at several turns of its plane, or the areas that it
// would hold, predicted on the GPU from view samples.
#ifndef rtwTurnStage_h
#define rtwTurnStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Light/rtwLightFrame.h"

#include <string>
#include <vector>

namespace rtw
{
class Readback;
class Texture;
class ViewSampler;

/// A light, and turns of its plane from that of its frame.
struct TurnedLight
{
  LightFrame Frame;
  std::vector<double> By;        ///< radians, no more than TurnStage::MostTurns
  /// Bounds on the turned plane of what the map has to hold besides samples.
  std::vector<Rectangle> Kept;
  std::vector<Rectangle> Bounds; ///< bounds on the turned plane outside of which nothing counts
};

struct TurnInput
{
  const ViewSampler& Samples;
  int Stride = 1; ///< pixels from one sample to the next along both axes
  /// The samples' shadow mask, a layer for each light; null where all samples count as edges.
  const Texture* Mask = nullptr;
  int Texels = 1;                ///< a side of the map
  bool Adapts = true;            ///< whether the map is warped by demand
  bool Areas = false;            ///< whether areas are asked for, not errors
};

class TurnStage
{
public:
  static constexpr int MostTurns = 36;

  bool Build();
  std::string GetLog() const;
  /// Starts to find the errors, or areas, of all turns of each light: the answer will be floats,
  /// one a turn, one after another, in any unit.
  void Start(const std::vector<TurnedLight>& lights, const TurnInput& input, Readback& answer);
  /// Lists samples that a light reaches, and edges of its mask (rtwTurnSamples.glsl).
  void List(const LightFrame& frame, int light, const TurnInput& input);
  /// Gives a program that list.
  void BindList(const Program& program) const;
  void Dispose(Disposal dispose);

private:
  void Compare(const TurnedLight& light, int first, const TurnInput& input);

  Program Listing, Comparing;
  Buffer Samples, Errors;
};
}

#endif
