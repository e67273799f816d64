// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwTechnique_h
#define rtwTechnique_h

#include "rtwAliasing.h"
#include "rtwTechniqueSettings.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;
class vtkWindow;

namespace rtw
{
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

/// By VTK's own vtkShadowMapPass.
std::unique_ptr<Technique> MakeVtkTechnique(const TechniqueSettings& settings);
/// By a pass of this module, with the settings applied to it.
std::unique_ptr<Technique> MakeAdaptiveTechnique(
  vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings);
}

#endif
