// SPDX-License-Identifier: BSD-3-Clause
// The importance of each column and row of the light plane: from the view samples, from the light's
// depth image, or from both (backward, forward and hybrid analysis: Rosen 2012, section 4.1).
#ifndef rtwImportanceStage_h
#define rtwImportanceStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Light/rtwLightFrame.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rtw
{
class LayerTable;
struct AnalysisInput;

/// Bits of importance functions; any set of them is a product.
enum ImportanceFunction
{
  DesiredView = 1,
  DistanceToEye = 2,
  SurfaceNormal = 4,
  SqrtDemand = 8,
  ShadowEdge = 16,
  CentreOfInterest = 32,
  UserFunction = 64,
  Footprint = 128,
  SampleCount = 256,
  AllFunctions = 511
};

enum class Analysis
{
  Forward,
  Backward,
  Hybrid
};

/// What each cell of a profile holds.
enum class Collected
{
  Largest,
  Sum,
  SumUnderRoot ///< a sum whose square root is to be taken
};

struct ImportanceSettings
{
  int Functions = SqrtDemand; ///< bits of ImportanceFunction
  Analysis Method = Analysis::Backward;
  double NormalBonus = 2; ///< β (Rosen 2012, section 5.4)
  double EdgeThreshold =
    0.001; ///< least difference of depth at an edge, as a share of the scene's diagonal
  bool InterestInView = true;     ///< whether the view's centre is of interest, and not a sphere
  glm::dvec3 InterestCentre{ 0 }; ///< in world coordinates
  double InterestRadius = 1;      ///< in world units
  /// The radius in the view, as a share of half the picture's smaller side.
  double InterestShare = 0.5;
  double InterestBonus = 4;
  std::string Code; ///< the user's importance function in GLSL: a body or an expression

  bool NeedsLightImages() const;
};

class ImportanceStage
{
public:
  static constexpr int MostCells = 2048;

  /// `refused` is told why the user's function doesn't compile.
  explicit ImportanceStage(std::function<void(const std::string& log)> refused);
  bool Build();
  const std::string& GetLog() const { return this->Analysing->GetLog(); }
  /// Fills the profiles of each layer, of which `frames` has one each. Each layer and axis has
  /// GetProfiles() of them; a profile holds two integers for each cell.
  void Analyse(const std::vector<LightFrame>& frames, const ImportanceSettings& settings,
    const AnalysisInput& input, const LayerTable& table);
  const Buffer& GetProfile() const { return this->Profile; }
  int GetProfiles() const { return this->InForce.Profiles; } ///< 2: plain, and at shadow edges
  Collected GetCollected() const { return this->Holds; }
  double GetUnit() const; ///< the value of an integer sum of 1
  void Dispose(Disposal dispose);

private:
  enum class Edges
  {
    None,
    OfImage,
    OfMask
  };
  /// What the code depends on.
  struct Shape
  {
    int Functions = SqrtDemand; ///< not a uniform, which would cost each sample a branch a function
    bool Forward = false;
    Edges At = Edges::None;
    int Profiles = 1;
    std::string Code;

    bool operator==(const Shape& other) const;
  };

  static Shape ShapeOf(const ImportanceSettings& settings);
  static bool Compile(const Shape& shape, Program& program);
  void Choose(const ImportanceSettings& settings);
  bool Replace(const Shape& shape, std::string& log);
  void Set(const ImportanceSettings& settings, const AnalysisInput& input) const;
  void SetLayer(const LightFrame& frame, int layer, const ImportanceSettings& settings,
    const AnalysisInput& input) const;
  void Collect(const AnalysisInput& input, int layer) const;

  std::function<void(const std::string&)> Refused;
  std::unique_ptr<Program> Analysing;
  Shape Asked, InForce;
  std::string LastGood; ///< the user's function that compiled last
  Collected Holds = Collected::SumUnderRoot;
  Buffer Profile;
};
}

#endif
