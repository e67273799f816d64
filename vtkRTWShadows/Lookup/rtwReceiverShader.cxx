// SPDX-License-Identifier: BSD-3-Clause
#include "rtwReceiverShader.h"

#include "rtwDepthTest.h"
#include "rtwFilter.h"
#include "rtwFilterTaps.h"
#include "rtwLayerInterval.h"
#include "rtwLightUniforms.h"
#include "rtwLookup.h"
#include "rtwMapperOutput.h"
#include "rtwMapperPhase.h"
#include "rtwMaskValue.h"
#include "rtwPlaceCaster.h"
#include "rtwReceiverDirect.h"
#include "rtwReceiverMasked.h"
#include "rtwReceiverPlace.h"
#include "rtwReceiverSampled.h"
#include "rtwWarpFocus.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

namespace rtw
{
namespace
{
const char* const LitMark = "//RTW::Lit";
const char* const EndMark = "//RTW::End";

bool IsIdentifier(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Replaces an identifier wherever it stands whole, but not where it is declared.
void ReplaceIdentifier(std::string& text, const std::string& name, const std::string& with)
{
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at))
  {
    const std::size_t end = at + name.size();
    const bool whole = (at == 0 || !IsIdentifier(text[at - 1])) &&
      (end >= text.size() || !IsIdentifier(text[end]));
    const std::size_t line = text.rfind('\n', at) + 1;
    const bool declared = text.compare(line, 8, "uniform ") == 0;
    if (whole && !declared)
    {
      text.replace(at, name.size(), with);
      at += with.size();
    }
    else
    {
      at = end;
    }
  }
}

bool Contains(const std::string& text, const char* what)
{
  return text.find(what) != std::string::npos;
}

void InsertBeforeMain(std::string& text, const std::string& code)
{
  const std::size_t main = text.find("void main");
  if (main != std::string::npos)
  {
    text.insert(main, code);
  }
}

std::string WarpCode(const ReceiverShape& shape)
{
  return std::string(rtwMapperPhase) + rtwWarpFocus + shape.Warp.Function;
}

// The last place that knows a vertex's position: the geometry shader, where there is one.
void InjectPlacing(std::string& vertex, std::string& geometry, const ReceiverShape& shape)
{
  const std::string code = WarpCode(shape) + rtwPlaceCaster;
  if (Contains(geometry, "EmitVertex"))
  {
    InsertBeforeMain(geometry, code);
    ReplaceIdentifier(geometry, "EmitVertex", "rtwPlaceCaster(); EmitVertex");
    return;
  }
  const std::size_t end = vertex.rfind('}');
  if (end != std::string::npos)
  {
    vertex.insert(end, "  rtwPlaceCaster();\n");
    InsertBeforeMain(vertex, code);
  }
}

// Unlit primitives and point gaussians know no position, and receive nothing.
bool KnowsPosition(const std::string& fragment)
{
  return Contains(fragment, "vec4 vertexVC =") || Contains(fragment, "vertexVC.xyz");
}

// As the fragment has it by now, because imposters write their own.
std::string DepthCode(const std::string& fragment)
{
  return Contains(fragment, "gl_FragDepth =") ? "gl_FragDepth" : "gl_FragCoord.z";
}

// Of what VTK makes round of lines and points: how far its surface stands before the plane through the middle, seen from the eye, as a
// share of the distance or, in a parallel view, as a length. Imposters place themselves.
std::string HeightOf(const std::string& fragment)
{
  return Contains(fragment, "tubeBasis2.z") ? "lenZ * ZCalcR / clamp(tubeBasis2.z, 0.5, 1.0)"
    : Contains(fragment, "normalVCVSOutput.z*ZCalcR") ? "normalVCVSOutput.z * ZCalcR"
                                                      : "";
}

// In view coordinates.
std::string PositionOf(const std::string& fragment)
{
  const std::string height = HeightOf(fragment);
  return height.empty() ? "vertexVC.xyz"
                        : "(cameraParallel != 0 ? vertexVC.xyz + vec3(0.0, 0.0, " + height +
      ") : vertexVC.xyz * (1.0 - " + height + "))";
}

// Depth, the fragment's position where it has one, and the normal of imposters, which are round.
std::string GeometryCode(const std::string& fragment)
{
  const bool imposter = Contains(fragment, "gl_FragDepth =");
  const std::string depth = DepthCode(fragment);
  const std::string position = KnowsPosition(fragment) ? PositionOf(fragment) : "vec3(0.0)";
  const bool round = imposter && Contains(fragment, "normalVCVSOutput =");
  return "rtwGeometryOutput(" + depth + ", " + position +
    (round ? ", normalVCVSOutput)" : ", vec3(0.0))");
}

std::string FactorCode(const ReceiverShape& shape)
{
  std::string code;
  for (std::size_t k = 0; k < shape.Switched.size(); ++k)
  {
    const std::string n = std::to_string(k);
    code += "  float rtwFactor" + n + " = rtwFactor(" + n + ", rtwAt);\n";
  }
  return code;
}

// The lattice of taps stays where it is in the world while the eye, where light-plane coordinates
// begin, moves: but for whole periods, which nobody sees, and which a float doesn't hold.
void PutTaps(
  std::vector<float>& taps, const LightFrame& frame, const LookupOptions& options, double size)
{
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const double width = std::min(options.FilterWorld, size); // more makes no difference
  const double spacing = width / (isSpot ? 3 * frame.FarthestDistance : 3.0); // RTW_TAPS_A_RADIUS
  const double period = 5 * 64 * spacing; // RTW_LATTICE_PERIOD, and lattices up to 64 times wider
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place = isSpot ? frame.ConeCentre[axis] : frame.WorldToLight[3][axis];
    taps.push_back(period > 0 && !isSpot ? float(std::fmod(place, period)) : float(place));
  }
  taps.insert(taps.end(), { float(spacing), float(width + options.FilterTexels) });
}

// Has a vertex shader tell the fragments where they lie in the view coordinates of the shadows, as it tells where in VTK's; false where it
// does that in another way, a geometry shader makes the fragments, or they find out themselves, as imposters do.
bool InjectPosition(ReceiverSources sources)
{
  const std::string vtks = "vertexVCVSOutput = MCVCMatrix * ";
  std::string& vertex = sources.Vertex;
  const std::size_t at = vertex.find(vtks), end = vertex.find(';', at);
  if (at == std::string::npos || end == std::string::npos ||
    Contains(sources.Geometry, "EmitVertex") || Contains(sources.Fragment, "gl_FragDepth ="))
  {
    return false;
  }
  const std::string stored = vertex.substr(at + vtks.size(), end - at - vtks.size());
  vertex.insert(end + 1, "\n  rtwPositionVSOutput = (rtwModelToView * " + stored + ").xyz;");
  InsertBeforeMain(vertex, "uniform mat4 rtwModelToView;\nout vec3 rtwPositionVSOutput;\n");
  return true;
}

// What the light pass and the view samples ask of a mapper.
void InjectGeometry(ReceiverSources sources, const ReceiverShape& shape, std::string& code,
  std::string& atLight, std::string& atEnd)
{
  std::string& fragment = sources.Fragment;
  const std::string output = GeometryCode(fragment);
  code += rtwMapperOutput;
  // A texture may cut holes; only what comes after it knows.
  if (Contains(fragment, "tcoordVCVSOutput") && Contains(fragment, "texture"))
  {
    atEnd += "  if (rtwPhase == 1 || rtwPhase == 2)\n  {\n    if (gl_FragData[0].a < 0.5) { discard; }\n"
             "    gl_FragData[0] = " + output + ";\n  }\n";
  }
  else
  {
    atLight +=
      "  if (rtwPhase == 1 || rtwPhase == 2) { gl_FragData[0] = " + output + "; return; }\n";
  }
  // The light camera may be of another kind than the viewer's, whose kind VTK tells the shaders.
  const std::string kind =
    "int rtwCameraParallel() { return rtwPhase == 1 ? rtwLightParallel : cameraParallel; }\n";
  ReplaceIdentifier(fragment, "cameraParallel", "rtwCameraParallel()");
  code += kind;
  const bool geometryKnows = Contains(sources.Geometry, "uniform int cameraParallel");
  ReplaceIdentifier(sources.Geometry, "cameraParallel", "rtwCameraParallel()");
  InjectPlacing(sources.Vertex, sources.Geometry, shape);
  if (geometryKnows)
  {
    InsertBeforeMain(sources.Geometry, kind);
  }
}
}

bool ReceiverShape::operator==(const ReceiverShape& other) const
{
  const bool sameWarp = this->Warp.Name == other.Warp.Name ||
    (this->Warp.Name && other.Warp.Name && !std::strcmp(this->Warp.Name, other.Warp.Name));
  return sameWarp && this->Switched == other.Switched && this->Filter == other.Filter &&
    this->DepthTest == other.DepthTest && this->OtherLayers == other.OtherLayers &&
    this->Parts == other.Parts && this->Faces == other.Faces && this->Blends == other.Blends;
}

void MarkPlaces(std::string& fragment)
{
  vtkShaderProgram::Substitute(fragment, "//VTK::Light::Impl",
    std::string(LitMark) + "\n//VTK::Light::Impl\n", false);
  vtkShaderProgram::Substitute(fragment, "//VTK::TCoord::Impl",
    std::string("//VTK::TCoord::Impl\n") + EndMark + "\n", false);
}

void RequireSamples(std::string& fragment)
{
  vtkShaderProgram::Substitute(fragment, "//VTK::System::Dec",
    "//VTK::System::Dec\n#extension GL_ARB_gpu_shader5 : enable\n", false);
}

std::string DefinitionsOf(const ReceiverShape& shape)
{
  return "#define RTW_LIGHTS " + std::to_string(shape.Switched.size()) + "\n#define RTW_FILTER " +
    std::to_string(shape.Filter) + "\n#define RTW_DEPTH_TEST " + std::to_string(shape.DepthTest) +
    "\n#define RTW_PARTS " + std::to_string(shape.Parts) + "\n#define RTW_FACES " +
    std::to_string(shape.Faces) + "\n#define RTW_BLENDS " + (shape.Blends ? "1" : "0") +
    "\n#define RTW_OTHER_LAYERS " + (shape.OtherLayers ? "1\n" : "0\n");
}

std::string LookupCode(const ReceiverShape& shape)
{
  const bool hasTaps = shape.Filter > 1;
  return std::string(rtwLayerInterval) + rtwDepthTest + rtwFilter + (hasTaps ? rtwFilterTaps : "") +
    rtwLookup;
}

void InjectReceiver(
  ReceiverSources sources, const ReceiverShape& shape, Receiving receiving, bool drawsItself)
{
  std::string& fragment = sources.Fragment;
  const bool direct = receiving == Receiving::Direct;
  const bool lit = KnowsPosition(fragment);
  std::string code =
    DefinitionsOf(shape) + "uniform int rtwReceives;\nuniform int rtwFramed; // the view\n";
  if (drawsItself || direct)
  {
    code += WarpCode(shape);
  }
  std::string atLight, atEnd;
  if (drawsItself)
  {
    InjectGeometry(sources, shape, code, atLight, atEnd);
  }
  if (lit)
  {
    const bool sampled = receiving == Receiving::Sampled;
    const std::string place = direct || sampled ? rtwReceiverPlace : "";
    code += place +
      (direct ? LookupCode(shape) + rtwReceiverDirect
              : std::string(rtwMaskValue) + (sampled ? rtwReceiverSampled : rtwReceiverMasked));
    // What VTK makes round stands elsewhere than its vertices.
    const bool told =
      (direct || sampled) && HeightOf(fragment).empty() && InjectPosition(sources);
    code += told ? "in vec3 rtwPositionVSOutput;\n" : "";
    const std::string position = PositionOf(fragment);
    const std::string placed = told ? "rtwPositionVSOutput"
      : direct || sampled           ? "rtwPlaceOf(" + position + ", " + DepthCode(fragment) + ")"
                                    : position;
    atLight += "  vec3 rtwAt = " + placed + ";\n";
    atLight += sampled ? "  rtwShown = rtwFindShown(rtwAt);\n" : "";
    atLight += FactorCode(shape);
    for (std::size_t k = 0; k < shape.Switched.size(); ++k)
    {
      const std::string colour = "lightColor" + std::to_string(shape.Switched[k]);
      ReplaceIdentifier(
        fragment, colour, "(rtwFactor" + std::to_string(k) + " * " + colour + ")");
    }
  }
  vtkShaderProgram::Substitute(fragment, LitMark, atLight, false);
  vtkShaderProgram::Substitute(fragment, EndMark, atEnd, false);
  InsertBeforeMain(fragment, code);
}

ReceiverLights ReceiverLights::Make(const std::vector<LightFrame>& frames, const View& view,
  const LookupOptions& options, double size)
{
  ReceiverLights lights;
  lights.FilterJitter = options.FilterJitter ? 1 : 0;
  lights.Count = static_cast<int>(frames.size());
  lights.Sides = SidesOf(view);
  for (const LightFrame& frame : frames)
  {
    const glm::mat4 toLight(frame.WorldToLight * view.ViewToWorld);
    for (int column = 0; column < 4; ++column)
    {
      for (int row = 0; row < 4; ++row)
      {
        lights.ToLight.push_back(toLight[column][row]);
      }
    }
    lights.Cone.insert(lights.Cone.end(),
      { float(frame.ConeCentre.x), float(frame.ConeCentre.y), float(frame.ConeTangent), 0.f });
    const double depthOfLength = frame.DepthOfLength();
    lights.Tolerance.insert(lights.Tolerance.end(),
      { 4e-7f, float(2e-6 * size * depthOfLength), float(options.Bias * size * depthOfLength),
        frame.Light.Kind == LightKind::Spot ? float(2.5e-7 * size) : 0.f });
    PutTaps(lights.Taps, frame, options, size);
    lights.Attenuation.push_back(float(frame.Light.Attenuation));
    const glm::vec4 beam = BeamOf(frame, view);
    lights.Beams.insert(lights.Beams.end(), { beam.x, beam.y, beam.z, beam.w });
  }
  return lights;
}

void ReceiverUniforms::PlaceView(const glm::ivec4& viewport, const View& view)
{
  this->OriginX = viewport.x + (viewport.z - view.Width) / 2;
  this->OriginY = viewport.y + (viewport.w - view.Height) / 2;
  this->ToClip.z = -this->ToClip.x * float(this->OriginX) - 1;
  this->ToClip.w = -this->ToClip.y * float(this->OriginY) - 1;
}

void ReceiverUniforms::Set(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("rtwPhase"))
  {
    const float depthToSample[] = { this->OwnDepthToSample.x, this->OwnDepthToSample.y };
    program->SetUniformi("rtwPhase", static_cast<int>(this->CurrentPhase));
    program->SetUniformi("rtwLayer", this->Layer);
    program->SetUniformi("rtwLightParallel", this->LightParallel ? 1 : 0);
    program->SetUniform2f("rtwOwnDepthToSample", depthToSample);
    const float rayStep[] = { this->RayStep.x, this->RayStep.y, this->RayStep.z };
    program->SetUniform3f("rtwRayStep", rayStep);
    program->SetUniform3f("rtwSeenFrom", &this->SeenFrom.x);
  }
  if (program->IsUniformUsed("rtwFramed"))
  {
    program->SetUniformi("rtwFramed", this->Framed ? 1 : 0);
  }
  if (program->IsUniformUsed("rtwOfSample"))
  {
    program->SetUniformi("rtwPlacedBy", this->PlacedBy);
    program->SetUniformf("rtwViewBegin", this->ViewBegin);
    program->SetUniform4f("rtwRay", &this->Ray.x);
    program->SetUniform4f("rtwOfSample", &this->OfSample.x);
    program->SetUniform2f("rtwDepthToSample", &this->DepthToSample.x);
    program->SetUniform4f("rtwToClip", &this->ToClip.x);
  }
  if (program->IsUniformUsed("rtwMask"))
  {
    const int origin[] = { this->OriginX, this->OriginY };
    program->SetUniformi("rtwMask", this->MaskUnit);
    program->SetUniform2i("rtwMaskOrigin", origin);
  }
  if (program->IsUniformUsed("rtwSampleBits"))
  {
    const int n = static_cast<int>(this->Points.size());
    program->SetUniformi("rtwSampleBits", this->BitsUnit);
    program->SetUniformi("rtwManySamples", this->ManyUnit);
    program->SetUniformi("rtwSamplesAPixel", n);
    program->SetUniform2fv(
      "rtwOffsets", n, reinterpret_cast<const float(*)[2]>(this->Points.data()));
    program->SetUniformf("rtwHiddenBeyond", this->HiddenBeyond);
  }
  if (program->IsUniformUsed("rtwWarpTable"))
  {
    const int size[] = { this->Cells, this->Resolution };
    program->SetUniformi("rtwWarpTable", this->WarpUnit);
    program->SetUniform2i("rtwWarpSize", size);
    program->SetUniform2i("rtwMapSize", &this->MapSize.x);
  }
  if (program->IsUniformUsed("rtwWarpGrid"))
  {
    program->SetUniformi("rtwWarpGrid", this->GridUnit);
    program->SetUniformi("rtwGridLayers", this->GridLayers);
  }
  const int n = this->Lights.Count;
  if (n > 0 && program->IsUniformUsed("rtwAttenuation"))
  {
    program->SetUniform1fv("rtwAttenuation", n, this->Lights.Attenuation.data());
  }
  if (n > 0 && program->IsUniformUsed("rtwToLight"))
  {
    program->SetUniformi("rtwDepths", this->DepthUnit);
    program->SetUniformi("rtwGradients", this->GradientUnit);
    program->SetUniformi("rtwFirstLayer", 0);
    program->SetUniformi("rtwOtherLayers", this->OtherLayers);
    program->SetUniformMatrix4x4v(
      "rtwToLight", n, const_cast<float*>(this->Lights.ToLight.data()));
    program->SetUniform4fv(
      "rtwCone", n, reinterpret_cast<const float(*)[4]>(this->Lights.Cone.data()));
    program->SetUniform4fv("rtwTolerance", n,
      reinterpret_cast<const float(*)[4]>(this->Lights.Tolerance.data()));
    if (program->IsUniformUsed("rtwBeams"))
    {
      program->SetUniform4fv(
        "rtwBeams", n, reinterpret_cast<const float(*)[4]>(this->Lights.Beams.data()));
      program->SetUniform4fv(
        "rtwSides", 4, reinterpret_cast<const float(*)[4]>(this->Lights.Sides.data()));
    }
    if (program->IsUniformUsed("rtwTaps"))
    {
      program->SetUniformi("rtwFilterJitter", this->Lights.FilterJitter);
      program->SetUniform4fv(
        "rtwTaps", n, reinterpret_cast<const float(*)[4]>(this->Lights.Taps.data()));
    }
  }
}
}
