// SPDX-License-Identifier: BSD-3-Clause
// What a renderer holds that can cast or receive shadows, sorted by how it has to be drawn.
#ifndef rtwFrameScene_h
#define rtwFrameScene_h

#include "rtwThickLook.h"

#include <glm/glm.hpp>

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkActor;
class vtkInformationIntegerKey;
class vtkPolyData;
class vtkProp;
class vtkRenderer;

namespace rtw
{
/// A mesh at one place: drawn by us, from buffers of our own.
struct ScenePart
{
  vtkPolyData* Data;
  glm::dmat4 ToWorld;
  bool Casts;
  bool Receives; ///< and is opaque, so that it belongs into the view samples
  bool Hides;    ///< is opaque but receives nothing: among the view samples it only hides what is behind
  ThickLook Look; ///< of its lines and points
};

/// What only its own VTK mapper knows how to draw: imposters, glyphs, cut-outs, clipped meshes and so on. Where it doesn't
/// cast, it is only seen so, and may cast by parts.
struct SceneProp
{
  vtkProp* Prop;
  bool Casts;
  bool Receives;
  bool Translucent;
};

struct FrameScene
{
  std::vector<ScenePart> Parts;
  std::vector<SceneProp> Props;
  std::vector<vtkProp*> Shaded; ///< every prop whose mappers are given our shader code
  glm::dvec3 Low{ 0 }; ///< of all that has bounds
  glm::dvec3 High{ 0 };
  bool HasBounds = false;
  /// Corners of the bounds of Props.
  std::vector<glm::dvec3> PropCorners;
  /// Corners of the bounds of receivers that are not among the view samples, eight for each.
  std::vector<glm::dvec3> UnsampledReceivers;
  /// Whether the view samples show exactly what the opaque props will cover, so that they may stand in for its depth.
  bool SamplesAreComplete = true;
  /// Changes whenever anything that the shadows depend on does.
  std::uint64_t Signature = 0;

  bool IsEmpty() const { return this->Parts.empty() && this->Props.empty(); }
};

struct SceneKeys
{
  vtkInformationIntegerKey* Casts;
  vtkInformationIntegerKey* Receives;
};

/// All visible props, those outside the view among them: they can cast into it. With `ownDrawing` off everything is
/// left to VTK's mappers.
FrameScene CollectScene(vtkRenderer* renderer, const SceneKeys& keys, bool ownDrawing);

/// Appends the corners of a box, transformed.
void AddCorners(const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& transform,
  std::vector<glm::dvec3>& corners);

/// Mixes a number into a signature.
std::uint64_t Mix(std::uint64_t signature, std::uint64_t value);
std::uint64_t Mix(std::uint64_t signature, const glm::dmat4& matrix);
std::uint64_t Mix(std::uint64_t signature, double value);
}

#endif
