// SPDX-License-Identifier: BSD-3-Clause
#include "Lookup/rtwReceiverShader.h"

#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwWarpFocus.h"
#include "Lookup/rtwDepthTest.h"
#include "Lookup/rtwFilter.h"
#include "Lookup/rtwFilterTaps.h"
#include "Lookup/rtwLookup.h"
#include "Lookup/rtwMapperOutput.h"
#include "Lookup/rtwMapperPhase.h"
#include "Lookup/rtwMaskValue.h"
#include "Lookup/rtwPlaceCaster.h"
#include "Lookup/rtwReceiverDirect.h"
#include "Lookup/rtwReceiverMasked.h"
#include "Lookup/rtwReceiverPlace.h"
#include "Lookup/rtwReceiverSampled.h"

#include "vtkShaderProgram.h"

#include <cctype>
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

// Puts rtwPlaceCaster() where a vertex's position is known last: in the geometry shader, where
// there is one.
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

// Whether a fragment knows its position; unlit primitives and point gaussians don't, and receive
// nothing.
bool KnowsPosition(const std::string& fragment)
{
  return Contains(fragment, "vec4 vertexVC =") || Contains(fragment, "vertexVC.xyz");
}

// GLSL for the fragment's depth as it is by now, because imposters write their own.
std::string DepthCode(const std::string& fragment)
{
  return Contains(fragment, "gl_FragDepth =") ? "gl_FragDepth" : "gl_FragCoord.z";
}

// GLSL for how far the surface of lines and points that VTK draws as tubes and spheres stands
// before the plane through the middle, seen from the eye, as a share of the distance or, in a
// parallel view, as a length. Imposters place themselves.
std::string HeightOf(const std::string& fragment)
{
  return Contains(fragment, "tubeBasis2.z") ? "lenZ * ZCalcR / clamp(tubeBasis2.z, 0.5, 1.0)"
    : Contains(fragment, "normalVCVSOutput.z*ZCalcR") ? "normalVCVSOutput.z * ZCalcR"
                                                      : "";
}

// GLSL for the fragment's position in view coordinates.
std::string PositionOf(const std::string& fragment)
{
  const std::string height = HeightOf(fragment);
  return height.empty() ? "vertexVC.xyz"
                        : "(cameraParallel != 0 ? vertexVC.xyz + vec3(0.0, 0.0, " + height +
      ") : vertexVC.xyz * (1.0 - " + height + "))";
}

// GLSL for depth, the fragment's position where it has one, and the normal of imposters, which are
// round.
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

// Injects what the light pass and the view samples ask of a mapper.
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
}
