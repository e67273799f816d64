// SPDX-License-Identifier: BSD-3-Clause
// What a renderer holds that can cast or receive shadows, sorted by how it has to be drawn.
#ifndef rtwFrameScene_h
#define rtwFrameScene_h

#include "Frame/rtwThickLook.h"

#include <glm/glm.hpp>

#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkInformationIntegerKey;
class vtkObjectBase;
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
  ThickLook Look; ///< how its lines and points are drawn
};

/// What only its own VTK mapper knows how to draw: imposters, glyphs, cut-outs, clipped meshes and so on. Where it doesn't
/// cast, it is only seen so, and may cast by parts.
struct SceneProp
{
  vtkActor* Actor;
  vtkProp* Owner; ///< the prop that it is a part of, or itself; it is drawn with that prop's keys
  vtkSmartPointer<vtkMatrix4x4> Place; ///< the matrix that its owner gives it; null for none
  bool Casts;
  bool Receives;
  bool Translucent;
};

/// How an actor's mapper is to be shaded.
struct SceneShading
{
  bool DrawsItself = false; ///< into maps and view samples, besides the picture
  bool IsUnsampled = false; ///< has parts that are not among the view samples: translucent ones
  /// For keys: whether some of what draws with them is no actor of ours, and stays as it is.
  bool IsMixed = false;

  bool operator==(const SceneShading& other) const
  {
    return this->DrawsItself == other.DrawsItself && this->IsUnsampled == other.IsUnsampled &&
      this->IsMixed == other.IsMixed;
  }
};

/// How all that draws with the same keys is shaded.
struct KeyShadings
{
  bool Has[2][2] = {}; ///< by whether it draws itself, and whether it is unsampled
  bool IsMixed = false;
};

/// What somebody might expect a prop to cast or receive, and won't get.
struct SceneRefusal
{
  vtkProp* Prop; ///< as it stands in the renderer
  std::string What;
};

struct FrameScene
{
  std::vector<ScenePart> Parts;
  std::vector<SceneProp> Props;
  std::vector<vtkProp*> Shaded; ///< every prop in whose keys the pass has to be, so that its mappers are given our shader code
  /// The shading of actors and mappers that aren't shaded as most are, and of the keys that such an
  /// actor shares with what VTK draws in its stead. Only the addresses are used.
  std::map<const vtkObjectBase*, SceneShading> Shadings;
  /// The shadings of those keys with which anything is drawn that isn't shaded as most is.
  std::map<const vtkObjectBase*, KeyShadings> Keys;
  std::vector<SceneRefusal> Refusals;
  glm::dvec3 Low{ 0 }; ///< least corner of the bounds of everything, in world coordinates
  glm::dvec3 High{ 0 };
  bool HasBounds = false;
  /// Corners of the bounds of Props.
  std::vector<glm::dvec3> PropCorners;
  /// Corners of the bounds of receivers that are not among the view samples, eight for each.
  std::vector<glm::dvec3> UnsampledReceivers;
  /// Whether the view samples show exactly what the opaque props will cover, so that they may stand in for its depth.
  bool SamplesAreComplete = true;
  /// A number that changes whenever anything that the shadows depend on does.
  std::uint64_t Signature = 0;

  /// The shading of what a mapper draws as one of the shaded props; nothing where that is to stay
  /// as it is.
  std::optional<SceneShading> FindShading(const vtkObjectBase* mapper, vtkProp* prop) const;
  std::optional<SceneShading> FindShading(
    const vtkObjectBase* mapper, const vtkObjectBase* actor, const vtkObjectBase* keys) const;
  /// The shading of an object; null for one that is shaded as most are.
  const SceneShading* Find(const vtkObjectBase* object) const;
  bool IsEmpty() const { return this->Parts.empty() && this->Props.empty(); }
};

struct SceneKeys
{
  vtkInformationIntegerKey* Casts;
  vtkInformationIntegerKey* Receives;
};

/// Collects all visible props, those outside the view among them: they can cast into it. With
/// `ownDrawing` off everything is left to VTK's mappers.
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
