// SPDX-License-Identifier: BSD-3-Clause
#include "Importance/rtwImportanceStage.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwTexture.h"
#include "Importance/rtwAnalysisInput.h"
#include "Importance/rtwCollectImage.h"
#include "Importance/rtwCollectView.h"
#include "Importance/rtwEdgesNone.h"
#include "Importance/rtwEdgesOfImage.h"
#include "Importance/rtwEdgesOfMask.h"
#include "Importance/rtwForwardSample.h"
#include "Importance/rtwImportance.h"
#include "Importance/rtwLightImage.h"
#include "Importance/rtwUserFunction.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwVisitSamples.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace rtw
{
namespace
{
constexpr int Group = 16; // side of a work group of rtwImportance.glsl
constexpr int DepthUnit = 1;
constexpr int GradientUnit = 2;
constexpr int MaskUnit = 3;
// Sums are whole numbers: of samples, and of what a light's image asks for.
constexpr int CountUnit = 1024;
constexpr int ForwardUnit = 256;

// The distance of a window's near plane, from which on something is seen: the scale that keeps
// importance near 1.
float NearestDistance(const View& view)
{
  const glm::dvec4 nearest = view.ClipToView * glm::dvec4(0, 0, -1, 1);
  return float(view.Begin - nearest.z / nearest.w);
}

// The body of the user's function, made of a body or an expression. Compilers count its lines by
// themselves, as source 0.
std::string BodyOf(const std::string& code)
{
  const bool isBody = code.find("return") != std::string::npos;
  const std::string text = "\n#line 1 0\n" + (code.empty() ? "1.0" : code);
  return isBody ? text + "\n}\n" : "return (" + text + "\n);}\n";
}

void SetMatrix(const Program& program, const char* uniform, const glm::dmat4& matrix)
{
  program.SetMatrix(uniform, glm::value_ptr(glm::mat4(matrix)));
}

void SetVector(const Program& program, const char* uniform, const glm::dvec4& v)
{
  glUniform4f(program.Location(uniform), float(v.x), float(v.y), float(v.z), float(v.w));
}

// The depth that a length along the light amounts to: x times the square of (y + z · depth), which
// is 1 / w.
glm::vec3 EdgeDepth(const LightFrame& frame, double length)
{
  const double scale = frame.DepthOfLength();
  return frame.Light.Kind == LightKind::Directional
    ? glm::vec3(length * scale, 1, 0)
    : glm::vec3(length * scale, 1 / frame.NearestDistance, -1 / scale);
}
}

bool ImportanceSettings::NeedsLightImages() const
{
  return this->Method == Analysis::Forward ||
    (this->Method == Analysis::Hybrid && (this->Functions & ShadowEdge));
}

bool ImportanceStage::Shape::operator==(const Shape& other) const
{
  return this->Functions == other.Functions && this->Forward == other.Forward &&
    this->At == other.At && this->Profiles == other.Profiles && this->Code == other.Code;
}

ImportanceStage::ImportanceStage(std::function<void(const std::string&)> refused)
  : Refused(std::move(refused))
  , Analysing(std::make_unique<Program>())
{
}

ImportanceStage::Shape ImportanceStage::ShapeOf(const ImportanceSettings& settings)
{
  Shape shape;
  shape.Functions = settings.Functions;
  shape.Forward = settings.Method == Analysis::Forward;
  if (settings.Functions & ShadowEdge)
  {
    shape.At = settings.NeedsLightImages() ? Edges::OfImage : Edges::OfMask;
    shape.Profiles = settings.Functions & SqrtDemand ? 2 : 1;
  }
  shape.Code = settings.Functions & UserFunction ? settings.Code : std::string();
  return shape;
}

bool ImportanceStage::Compile(const Shape& shape, Program& program)
{
  const std::string definitions = "const int PROFILES = " + std::to_string(shape.Profiles) +
    ";\nconst int FUNCTIONS = " + std::to_string(shape.Functions) +
    ";\nconst float COUNT_UNIT = " + std::to_string(CountUnit) +
    ";\nconst float FORWARD_UNIT = " + std::to_string(ForwardUnit) + ";\n";
  const std::string body = BodyOf(shape.Code);
  const bool image = shape.Forward || shape.At == Edges::OfImage;
  const char* const edges = shape.At == Edges::None ? rtwEdgesNone
    : shape.At == Edges::OfImage                    ? rtwEdgesOfImage
                                                    : rtwEdgesOfMask;
  return program.Build({ { GL_COMPUTE_SHADER,
    { definitions.c_str(), rtwWarpFocus, rtwLayerInterval, rtwViewSampleAccess, rtwLitSample,
      rtwSampleOfLayer, image ? rtwLightImage : "", rtwUserFunction, body.c_str(), rtwImportance,
      shape.Forward ? "" : rtwSamplePlace, shape.Forward ? rtwForwardSample : rtwBackwardSample,
      shape.Forward ? "" : rtwSampleBlocks, shape.Forward ? "" : rtwVisitSamples, edges,
      shape.Forward ? rtwCollectImage : rtwCollectView } } });
}

bool ImportanceStage::Build()
{
  return Compile(this->InForce, *this->Analysing);
}

bool ImportanceStage::Replace(const Shape& shape, std::string& log)
{
  if (shape == this->InForce)
  {
    return true;
  }
  auto next = std::make_unique<Program>();
  if (!Compile(shape, *next))
  {
    log = next->GetLog();
    return false;
  }
  this->Analysing->Release();
  this->Analysing = std::move(next);
  this->InForce = shape;
  return true;
}

// Where the user's function doesn't compile, the last one that did stays in force.
void ImportanceStage::Choose(const ImportanceSettings& settings)
{
  Shape wanted = ShapeOf(settings);
  if (wanted == this->Asked)
  {
    return;
  }
  this->Asked = wanted;
  std::string log, otherLog;
  const bool isGood = this->Replace(wanted, log);
  if (isGood && (settings.Functions & UserFunction))
  {
    this->LastGood = wanted.Code;
  }
  if (!isGood)
  {
    this->Refused(log);
    wanted.Code = settings.Functions & UserFunction ? this->LastGood : std::string();
    this->Replace(wanted, otherLog);
  }
}

void ImportanceStage::Set(const ImportanceSettings& settings, const AnalysisInput& input) const
{
  const Program& program = *this->Analysing;
  const View& view = input.Samples.GetView();
  const double width = view.Width, height = view.Height, smaller = std::min(width, height);
  const glm::dvec4 centre = view.WorldToView * glm::dvec4(settings.InterestCentre, 1);
  program.Set("rtwBeta", float(settings.NormalBonus));
  program.Set("rtwNearest", NearestDistance(view));
  SetMatrix(program, "rtwViewToClip", view.ViewToClip);
  program.Set("rtwViewSize", float(width), float(height));
  program.Set("rtwAspect", float(width / smaller), float(height / smaller));
  program.Set("rtwInterestSide", settings.InterestInView ? 1 : 0);
  program.Set("rtwInterestBonus", float(settings.InterestBonus));
  SetVector(program, "rtwInterest",
    { glm::dvec3(centre),
      settings.InterestInView ? settings.InterestShare : settings.InterestRadius });
  program.Set("rtwImageDepths", DepthUnit);
  program.Set("rtwImageGradients", GradientUnit);
  program.Set("rtwLastMask", MaskUnit);
  program.Set("rtwHasMask", input.LastMask ? 1 : 0);
  SetMatrix(program, "rtwViewToLastClip",
    input.LastView.ViewToClip * (input.LastView.WorldToView * view.ViewToWorld));
}

void ImportanceStage::SetLayer(const LightFrame& frame, int layer,
  const ImportanceSettings& settings, const AnalysisInput& input) const
{
  const Program& program = *this->Analysing;
  const View& view = input.Samples.GetView();
  BindLight(program, frame, view, input.Stride);
  SetMatrix(program, "rtwLightToView", glm::inverse(frame.WorldToLight * view.ViewToWorld));
  const bool directional = frame.Light.Kind == LightKind::Directional;
  SetVector(program, "rtwTowardsLight",
    view.WorldToView *
      (directional ? glm::dvec4(-frame.Light.Direction, 0) : glm::dvec4(frame.Light.Position, 1)));
  const glm::vec3 edge = EdgeDepth(frame, settings.EdgeThreshold * input.SceneSize);
  program.Set("rtwEdgeDepth", edge.x, edge.y, edge.z);
  program.Set("rtwLayer", layer);
  program.Set("rtwImageLayer", layer);
  program.Set("rtwMaskLayer", frame.Number());
}

void ImportanceStage::Analyse(const std::vector<LightFrame>& frames,
  const ImportanceSettings& settings, const AnalysisInput& input, const LayerTable& table)
{
  this->Choose(settings);
  this->Holds = this->InForce.Functions & SqrtDemand ? Collected::SumUnderRoot
    : this->InForce.Functions & SampleCount          ? Collected::Sum
                                                     : Collected::Largest;
  const std::size_t numbers =
    std::size_t(2) * 2 * this->GetProfiles() * table.GetCells() * frames.size();
  this->Profile.Reserve(numbers * sizeof(unsigned int));
  this->Profile.Clear();
  this->Analysing->Use();
  this->Profile.BindStorage(0);
  input.Samples.Bind(*this->Analysing);
  table.Bind(*this->Analysing);
  this->Set(settings, input);
  if (input.LightImages)
  {
    input.LightImages->GetDepths().Bind(DepthUnit);
    input.LightImages->GetGradients().Bind(GradientUnit);
  }
  if (input.LastMask)
  {
    input.LastMask->Bind(MaskUnit);
  }
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    this->SetLayer(frames[layer], static_cast<int>(layer), settings, input);
    this->Collect(input, static_cast<int>(layer));
  }
}

double ImportanceStage::GetUnit() const
{
  const double counted = this->Holds == Collected::Sum ? 1.0 / CountUnit : 1.0;
  return this->InForce.Forward ? counted / ForwardUnit : counted;
}

void ImportanceStage::Collect(const AnalysisInput& input, int layer) const
{
  if (this->InForce.Forward)
  {
    const int side = input.LightImages ? input.LightImages->GetSize().x : 0;
    Dispatch(Groups(side, Group), Groups(side, Group));
    return;
  }
  input.Blocks.Dispatch(*this->Analysing, input.Samples, input.Stride, layer);
}

void ImportanceStage::Dispose(Disposal dispose)
{
  dispose(*this->Analysing, this->Profile);
}
}
