// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwTechnique_h
#define rtwTechnique_h

#include "rtwAliasing.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;
class vtkWindow;

namespace rtw
{
enum class Filter
{
  NEAREST,
  BILINEAR,
  PCF,
  SOFT
};

enum class DepthTest
{
  DUAL,
  RECEIVER_PLANE,
  CONSTANT_BIAS
};

/// Of rtw; several are multiplied.
enum class Importance
{
  DESIRED_VIEW,
  DISTANCE_TO_EYE,
  SURFACE_NORMAL,
  SQRT_DEMAND,
  SHADOW_EDGE,
  CENTRE_OF_INTEREST,
  USER_FUNCTION,
  FOOTPRINT,
  SAMPLE_COUNT
};

enum class Analysis
{
  FORWARD,
  BACKWARD,
  HYBRID
};

enum class Rasterization
{
  LINEAR,
  TESSELLATED,
  EXACT,
  AUTOMATIC
};

enum class LightPlaneTurn
{
  OFF,
  VIEW_ALIGNED,
  AUTOMATIC,
  MINIMAL_FRUSTUM
};

/// Of perspective; as vtkPerspectiveShadowMapPass has them.
enum class ResolutionSplit
{
  SQUARE,
  CRITICAL,
  AUTOMATIC
};

/// Likewise.
enum class Perspective
{
  PSM,
  LISPSM,
  TSM,
  UNWARPED
};

/// Of cascades.
enum class Splits
{
  UNIFORM,
  LOGARITHMIC,
  PRACTICAL,
  SAMPLE_DISTRIBUTION
};

/// Of each layer of cascades.
enum class LayerWarp
{
  IDENTITY,
  PERSPECTIVE,
  RTW,
  NOTW
};

enum class SampleSource
{
  PREPASS,
  PREVIOUS_FRAME
};

/// Of exact: how view samples are spread over texels.
enum class GridWarp
{
  IDENTITY,
  RECTILINEAR,
  NON_ORTHOGONAL
};

/// What a picture can show of a map instead of its shadows.
enum class DebugPicture
{
  NONE,
  SHADOW,
  ALIASING_ERROR,
  IMPORTANCE,
  WARP_GRID,
  LAYERS,
  LIST_LENGTHS
};

/// Settings that are not given stay what the technique has by itself.
struct TechniqueSettings
{
  int Resolution = 1024; // texels a side of a shadow map
  std::optional<Filter> Filtering;
  std::optional<Rasterization> Rasterizing;
  std::optional<double> EdgeLength; // of tessellated triangles at most, of the map's side
  std::optional<SampleSource> Samples;
  std::optional<int> SampleStride;
  std::optional<LightPlaneTurn> Turn;
  std::optional<double> FilterRadius; // texels of PCF, world units of SOFT
  std::optional<bool> FilterJitter;
  std::optional<DepthTest> Test;
  std::optional<bool> Focus;
  std::vector<Importance> ImportanceKinds; // empty: not given
  std::optional<Analysis> AnalysisKind;
  std::optional<double> EdgeThreshold;
  std::optional<int> LightImage;                 // texels a side
  std::optional<std::array<double, 4>> Interest; // a sphere's centre and radius
  std::optional<std::string> UserFunction;       // GLSL
  std::optional<bool> CullEmptyCells;
  std::optional<double> TemporalBlending;
  std::optional<bool> Snapping;
  std::optional<double> Smoothing;               // of notw, a share of the focus
  std::optional<int> Cells;                      // a side, of notw
  std::optional<Perspective> Parameterization;
  std::optional<double> NearDistance; // n' of perspective
  std::optional<double> Eta;
  std::optional<ResolutionSplit> Split;
  std::optional<double> SplitRatio;
  std::optional<double> FocusPoint;
  std::optional<GridWarp> Grid;
  std::optional<int> PixelSamples;               // 1, 4 or 8
  std::optional<int> Layers;
  std::optional<Splits> Splitting;
  std::optional<double> Lambda;
  std::optional<double> BlendWidth;
  std::optional<LayerWarp> Warping;
  std::optional<bool> Stable;
  std::optional<bool> SplitFaces;
  std::optional<bool> CullCasters;
  bool Stages = false;                           // whether to time the stages on the GPU
};

struct Stage
{
  std::string Name;
  double Milliseconds;
};

/// One way to make shadows, for one renderer.
class Technique
{
public:
  virtual ~Technique() = default;

  virtual void Install(vtkRenderer* renderer) = 0;

  /// Whether each frame from now on makes its shadow maps anew.
  virtual void SetRebuilding(bool rebuilding) = 0;

  /// To be called before and after each frame; what they do is part of its time.
  virtual void PrepareFrame() {}
  virtual void FinishFrame() {}

  /// The shadow of the first light on each pixel of a renderer that has drawn a frame: see
  /// rtw::MaskValue.
  virtual std::vector<unsigned char> MakeMask() = 0;

  /// Whether frames after a mask may be timed: not if it leaves the props in another state.
  virtual bool GoesOnAfterMask() const { return true; }

  /// Where points lie on the first light's map of the last frame; empty if that is not known.
  virtual TexelFunction GetTexels() { return {}; }

  /// What frames from now on show of the first light's map. False if there is no such picture.
  virtual bool SetDebugPicture(DebugPicture) { return false; }

  /// The share of pixels that it says are wrong for the first light, in the last frame; negative if
  /// it doesn't know.
  virtual double GetPredictedError() { return -1; }

  /// Bytes of the shadow maps and what comes with them.
  virtual int64_t GetMemory() = 0;

  /// Of the frame before the last one, if settings.Stages, and if the GPU was waited for.
  virtual std::vector<Stage> GetStages() { return {}; }

  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;
};

std::vector<std::string> TechniqueNames();
std::string TechniqueDescription(const std::string& name);

/// Throws std::invalid_argument if there is no such technique.
std::unique_ptr<Technique> MakeTechnique(
  const std::string& name, const TechniqueSettings& settings);

/// What Techniques.cxx lists.
std::unique_ptr<Technique> MakeVtkTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakeUniformTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakeRTWTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakeNoTWTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakePerspectiveTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakeExactTechnique(const TechniqueSettings& settings);
std::unique_ptr<Technique> MakeCascadesTechnique(const TechniqueSettings& settings);
}

#endif
