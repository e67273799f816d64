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

/// How triangles are drawn that the warp bends, numbered as
/// vtkConfigurableShadowMapPass::Rasterizations.
enum class Bending
{
  Linear = 0,      ///< with straight edges
  Tessellated = 1, ///< cut up
  Exact = 2,       ///< by their own edges on the unwarped light plane
  Automatic = 3    ///< as Exact where the bend can be seen, as Linear elsewhere
};

struct CasterOptions
{
  bool Cull = true; ///< leave out what cannot shadow anything in focus
  Bending Bends = Bending::Automatic;
  double EdgeLength = 0.025; ///< longest edge of a tessellated piece, as a share of the map's side
  /// The length, as a share of the map's side, over which a bent edge is drawn straight at most;
  /// where edges are drawn as they are in the mesh, the length of rather long ones.
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

  /// The largest bend that can't be seen, as a share of the map's side.
  float LeastBend() const;
  /// Uses a program of the light pass, and gives it all that it can ask of a layer.
  void Prepare(const Program& program) const;
};
}

#endif
