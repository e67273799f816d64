// SPDX-License-Identifier: BSD-3-Clause
// The contract of a warp: GLSL for caster and receiver, and a way to build its table from view
// samples.
//
// Implemented by IdentityWarpStage, RectilinearWarpStage, NonOrthogonalWarpStage and
// PerspectiveWarpStage.
#ifndef rtwWarpStage_h
#define rtwWarpStage_h

#include "GL/rtwResources.h"
#include "Light/rtwLightFrame.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace rtw
{
class LayerTable;
struct AnalysisInput;
struct SplitScene;
struct View;

enum class WarpKind
{
  Separable,  ///< s on the map depends on s alone, and t on t
  Projective, ///< straight lines stay straight; Bend defines rtwFront too
  Grid        ///< neither; it has a grid in the table
};

struct WarpShape
{
  const char* Name;     ///< tells shader code for one warp from that for another
  /// defines rtwWarp, rtwWarpHomogeneous and rtwTexelCentres, which are no warp of a layer from
  /// rtwWarpedLayers on
  const char* Function;
  const char* Bend;     ///< defines rtwBoundsOnMap, rtwBends, rtwShifts and rtwBendsOfPieces
  const char* Slope;    ///< defines rtwWarpSlope
  WarpKind Kind = WarpKind::Separable;
};

/// What a warp that remembers the last frame needs to know of this one.
struct WarpFrame
{
  const std::vector<LightFrame>& Frames;
  const View& Viewed;
  double SceneSize;       ///< its diagonal
  std::uint64_t Settings; ///< another number where anything is set otherwise
  bool Still;             ///< the last frame was the same
  bool Current;           ///< the view samples are of this frame, not of one before
  bool Focused;           ///< on what the camera sees
  int OtherLayers;        ///< how far behind a layer the one is that shares its focus; 0 if none is
};

class WarpStage : public ResourceOwner
{
public:
  virtual WarpShape GetShape() const = 0;
  virtual bool NeedsViewSamples() const = 0;
  /// Whether what only VTK's mappers can draw has a layer of its own, which isn't warped: they move
  /// vertices alone, so that an edge that is bent on the map comes out straight.
  virtual bool DrawsMappersApart() const { return true; }
  virtual int GetCells() const = 0; ///< cells of a warping function
  /// Whether t has to lie along the view on each light plane, however it would be turned else.
  virtual bool LiesAlongView() const { return false; }
  /// How many times as many texels along s as along t the maps of a frame are to have. Others than
  /// 1 are for warps whose GLSL goes by rtwMapSize.
  virtual double ChooseTexelRatio(const SplitScene&) { return 1; }
  /// Whether the texel ratio is the one with the least predicted error instead of
  /// ChooseTexelRatio()'s.
  virtual bool SplitsByError() const { return false; }
  /// Texels a side of the depth image of each light that Run() looks at; 0 where it looks at none.
  virtual int GetLightImageSize() const { return 0; }
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  virtual bool Build() = 0;
  virtual std::string GetLog() const = 0;
  /// Starts a frame, whose focus is in the table; may let it cover more.
  virtual void Follow(const WarpFrame&, const LayerTable&) {}
  /// Whether another frame that is the same would get the same table.
  virtual bool IsSettled() const { return true; }
  /// Fills the table of every layer; its focus is there already.
  virtual void Run(
    const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table) = 0;
  /// How many times the mean density of texels the densest cell of a layer has along s and t. Waits
  /// for the GPU.
  virtual glm::dvec2 ReadGreatestDensity(int layer) const = 0;
  /// The importance of each cell along s, then along t, as it was collected and as it was used,
  /// which Run() filled in; for a warp that isn't separable that of each line's cells, line by
  /// line. Empty for a layer that there isn't, and where the warp goes by none. Waits for the GPU.
  virtual std::vector<float> ReadImportance(int, const LayerTable&) const { return {}; }
};
}

#endif
