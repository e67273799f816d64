// SPDX-License-Identifier: BSD-3-Clause
// Puts our code into the shaders of VTK's mappers, and its parameters beside it.
#ifndef rtwReceiverShader_h
#define rtwReceiverShader_h

#include "Frame/rtwView.h"
#include "Light/rtwLightFrame.h"
#include "Warp/rtwWarpStage.h"

#include <array>
#include <string>
#include <vector>

class vtkShaderProgram;

namespace rtw
{
enum class Phase
{
  Picture,
  LightPass,
  ViewSamples
};

/// How a receiver learns of its shadow.
enum class Receiving
{
  Masked,  ///< from the mask
  Sampled, ///< from the bits of a pixel's samples
  Direct   ///< from the maps
};

/// What the code's shape depends on; everything else is a uniform.
struct ReceiverShape
{
  WarpShape Warp{};
  std::vector<int> Switched; ///< for each shadowing light the N of VTK's lightColorN
  int Filter = 1;
  int DepthTest = 0;
  bool OtherLayers = false; ///< whether some casters have layers of their own
  int Parts = 1;            ///< layers of each light, other casters' layers aside
  /// Layers of the same depths, one for each side of the view frustum; 1 or 4.
  int Faces = 1;
  bool Blends = false;      ///< whether a layer gives way to the next little by little

  bool operator==(const ReceiverShape& other) const;
};

/// The definitions that GLSL needs before LookupCode().
std::string DefinitionsOf(const ReceiverShape& shape);
/// The code of the lookup from behind the warp to rtwVisibility(): the same for the mask and for
/// mappers.
std::string LookupCode(const ReceiverShape& shape);

struct ReceiverSources
{
  std::string& Vertex;
  std::string& Geometry;
  std::string& Fragment;
};

/// Marks the places that are gone after VTK has put its own code in; to be called before that.
void MarkPlaces(std::string& fragment);
/// Asks for the extension that Receiving::Sampled needs; to be called before VTK declares the
/// language's version.
void RequireSamples(std::string& fragment);
/// Fills the marked places; to be called after VTK has put its own code in. `drawsItself` where the
/// mapper has a part in the light pass and the view samples too.
void InjectReceiver(ReceiverSources sources, const ReceiverShape& shape, Receiving receiving,
  bool drawsItself);

/// Parameters of a lookup.
struct LookupOptions
{
  double Bias = 0;         ///< a share of the scene's size
  double FilterTexels = 0; ///< radius of PCF
  double FilterWorld = 0;  ///< radius of SOFT, in world units; one of the two radii is 0
  bool FilterJitter = false;
};

/// Each light's parameters, as arrays of floats.
struct ReceiverLights
{
  std::vector<float> ToLight, Cone, Tolerance, Taps, Attenuation, Beams;
  /// Planes of the sides of the view frustum, in view coordinates.
  std::array<glm::vec4, 4> Sides{};
  int FilterJitter = 0;
  int Count = 0;

  static ReceiverLights Make(const std::vector<LightFrame>& frames, const View& view,
    const LookupOptions& options, double size);
};

struct ReceiverUniforms
{
  Phase CurrentPhase = Phase::Picture;
  int Layer = 0;
  int OtherLayers = 0;
  bool LightParallel = false;
  int WarpUnit = 0, DepthUnit = 0, GradientUnit = 0, MaskUnit = 0, GridUnit = 0;
  int BitsUnit = 0, ManyUnit = 0;
  std::vector<glm::vec2> Points; ///< samples of a pixel, from its centre; none where one is enough
  float HiddenBeyond = 0;
  int WarpedLayers = 0;
  int GridLayers = 0; ///< those of them that have a grid
  int Cells = 1, Resolution = 1;
  glm::ivec2 MapSize{ 1 };
  int OriginX = 0, OriginY = 0; ///< the view's corner in the target, in pixels
  ///@{
  /// The view's parameters, as rtwReceiverPlace.glsl and rtwMapperOutput.glsl declare them.
  bool Framed = false;
  int PlacedBy = 0;
  float ViewBegin = 0;
  glm::vec4 Ray{ 0 }, OfSample{ 0 }, ToClip{ 0 };
  glm::vec2 DepthToSample{ 1, 0 }, OwnDepthToSample{ 1, 0 };
  glm::vec3 RayStep{ 0 };
  glm::vec3 SeenFrom{ 0 };
  ///@}
  ReceiverLights Lights;

  /// Sets the view's parameters for mappers that draw in that viewport, which may lie in another
  /// target and show more around the view.
  void PlaceView(const glm::ivec4& viewport, const View& view);
  void Set(vtkShaderProgram* program) const;
};
}

#endif
