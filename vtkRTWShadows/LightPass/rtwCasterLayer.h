// SPDX-License-Identifier: BSD-3-Clause
// A layer on its way through the light pass, what is asked of it, and what was counted.
#ifndef rtwCasterLayer_h
#define rtwCasterLayer_h

#include "Light/rtwLightFrame.h"

namespace rtw
{
class DeepestSamples;
class GeometryStore;
class Program;
class LayerTable;

/// What becomes of triangles that the warp bends; the numbers are the users'.
enum class Bending
{
  Linear = 0,      ///< nothing
  Tessellated = 1, ///< they are cut up
  Exact = 2,       ///< they are drawn by their own edges
  Automatic = 3    ///< the same, where it can be seen
};

struct CasterOptions
{
  bool Cull = true; ///< leave out what cannot shadow anything in focus
  Bending Bends = Bending::Automatic;
  double EdgeLength = 0.025; ///< of tessellated triangles at most, of the map's side
  /// Of bent edges, that far at most are they drawn straight; where that is as they are in the
  /// mesh, of some that are long.
  double StraightLength() const
  {
    return this->Bends == Bending::Linear   ? 0.25
      : this->Bends == Bending::Tessellated ? this->EdgeLength
                                            : 0;
  }
};

struct CasterCounts
{
  unsigned int Drawn = 0; ///< clusters of triangles
  unsigned int Culled = 0;
};

/// The least w, as LightFrame has it, of what casts a shadow: what is nearer to a spot is part of
/// it.
float NearestW(const LightFrame& frame);

struct CasterLayer
{
  const GeometryStore& Store;
  const LayerTable& Table;
  const LightFrame& Frame;
  int Index;
  bool Cull;
  Bending Bends;
  double EdgeLength;
  const DeepestSamples* Deepest; ///< none where receivers may be anywhere

  /// Of bent edges no more than that can be seen, as a share of the map's side.
  float LeastBend() const;
  /// Uses a program of the light pass, and gives it all that it can ask of a layer.
  void Prepare(const Program& program) const;
};
}

#endif
