// SPDX-License-Identifier: BSD-3-Clause
#ifndef Techniques_h
#define Techniques_h

#include "Options.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;
class vtkWindow;

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

  /// To be called before each frame.
  virtual void PrepareFrame() {}

  /// The shadow on each pixel of a renderer that has drawn a frame: see rtw::MaskValue. It may
  /// leave the renderer's props in another state, so it comes last.
  virtual std::vector<unsigned char> MakeMask() = 0;

  /// Bytes of the shadow maps and what comes with them.
  virtual int64_t GetMemory() = 0;

  /// Of the last frame, if options.Stages.
  virtual std::vector<Stage> GetStages() { return {}; }

  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;
};

std::vector<std::string> TechniqueNames();
std::string TechniqueDescription(const std::string& name);
std::unique_ptr<Technique> MakeTechnique(
  const std::string& name, int resolution, const Options& options);

/// What Techniques.cxx lists.
std::unique_ptr<Technique> MakeVtkTechnique(int resolution, const Options& options);
std::unique_ptr<Technique> MakeUniformTechnique(int resolution, const Options& options);
std::unique_ptr<Technique> MakeRTWTechnique(int resolution, const Options& options);

#endif
