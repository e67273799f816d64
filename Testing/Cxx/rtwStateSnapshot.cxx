// SPDX-License-Identifier: BSD-3-Clause
#include "rtwStateSnapshot.h"

#include "rtwStateNames.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace
{
struct Number
{
  const char* Name;
  GLenum Enum;
  int Count;
};

const Number NUMBERS[] = {
  { "active texture", GL_ACTIVE_TEXTURE, 1 },
  { "blend colour", GL_BLEND_COLOR, 4 },
  { "blend equation, colour", GL_BLEND_EQUATION_RGB, 1 },
  { "blend equation, alpha", GL_BLEND_EQUATION_ALPHA, 1 },
  { "blend source, colour", GL_BLEND_SRC_RGB, 1 },
  { "blend source, alpha", GL_BLEND_SRC_ALPHA, 1 },
  { "blend destination, colour", GL_BLEND_DST_RGB, 1 },
  { "blend destination, alpha", GL_BLEND_DST_ALPHA, 1 },
  { "clear colour", GL_COLOR_CLEAR_VALUE, 4 },
  { "clear depth", GL_DEPTH_CLEAR_VALUE, 1 },
  { "clear stencil", GL_STENCIL_CLEAR_VALUE, 1 },
  { "colour mask", GL_COLOR_WRITEMASK, 4 },
  { "cull face", GL_CULL_FACE_MODE, 1 },
  { "depth function", GL_DEPTH_FUNC, 1 },
  { "depth mask", GL_DEPTH_WRITEMASK, 1 },
  { "depth range", GL_DEPTH_RANGE, 2 },
  { "front face", GL_FRONT_FACE, 1 },
  { "line width", GL_LINE_WIDTH, 1 },
  { "logic operation", GL_LOGIC_OP_MODE, 1 },
  { "pack alignment", GL_PACK_ALIGNMENT, 1 },
  { "pack image height", GL_PACK_IMAGE_HEIGHT, 1 },
  { "pack lsb first", GL_PACK_LSB_FIRST, 1 },
  { "pack row length", GL_PACK_ROW_LENGTH, 1 },
  { "pack skipped images", GL_PACK_SKIP_IMAGES, 1 },
  { "pack skipped pixels", GL_PACK_SKIP_PIXELS, 1 },
  { "pack skipped rows", GL_PACK_SKIP_ROWS, 1 },
  { "pack swaps bytes", GL_PACK_SWAP_BYTES, 1 },
  { "patch vertices", GL_PATCH_VERTICES, 1 },
  { "point fade threshold", GL_POINT_FADE_THRESHOLD_SIZE, 1 },
  { "point size", GL_POINT_SIZE, 1 },
  { "point sprite origin", GL_POINT_SPRITE_COORD_ORIGIN, 1 },
  { "polygon mode", GL_POLYGON_MODE, 1 },
  { "polygon offset factor", GL_POLYGON_OFFSET_FACTOR, 1 },
  { "polygon offset units", GL_POLYGON_OFFSET_UNITS, 1 },
  { "primitive restart index", GL_PRIMITIVE_RESTART_INDEX, 1 },
  { "program", GL_CURRENT_PROGRAM, 1 },
  { "program pipeline", GL_PROGRAM_PIPELINE_BINDING, 1 },
  { "provoking vertex", GL_PROVOKING_VERTEX, 1 },
  { "renderbuffer", GL_RENDERBUFFER_BINDING, 1 },
  { "sample coverage inverted", GL_SAMPLE_COVERAGE_INVERT, 1 },
  { "sample coverage", GL_SAMPLE_COVERAGE_VALUE, 1 },
  { "scissor box", GL_SCISSOR_BOX, 4 },
  { "stencil, back: fails", GL_STENCIL_BACK_FAIL, 1 },
  { "stencil, back: function", GL_STENCIL_BACK_FUNC, 1 },
  { "stencil, back: depth fails", GL_STENCIL_BACK_PASS_DEPTH_FAIL, 1 },
  { "stencil, back: depth passes", GL_STENCIL_BACK_PASS_DEPTH_PASS, 1 },
  { "stencil, back: reference", GL_STENCIL_BACK_REF, 1 },
  { "stencil, back: value mask", GL_STENCIL_BACK_VALUE_MASK, 1 },
  { "stencil, back: write mask", GL_STENCIL_BACK_WRITEMASK, 1 },
  { "stencil: fails", GL_STENCIL_FAIL, 1 },
  { "stencil: function", GL_STENCIL_FUNC, 1 },
  { "stencil: depth fails", GL_STENCIL_PASS_DEPTH_FAIL, 1 },
  { "stencil: depth passes", GL_STENCIL_PASS_DEPTH_PASS, 1 },
  { "stencil: reference", GL_STENCIL_REF, 1 },
  { "stencil: value mask", GL_STENCIL_VALUE_MASK, 1 },
  { "stencil: write mask", GL_STENCIL_WRITEMASK, 1 },
  { "transform feedback", GL_TRANSFORM_FEEDBACK_BINDING, 1 },
  { "unpack alignment", GL_UNPACK_ALIGNMENT, 1 },
  { "unpack image height", GL_UNPACK_IMAGE_HEIGHT, 1 },
  { "unpack lsb first", GL_UNPACK_LSB_FIRST, 1 },
  { "unpack row length", GL_UNPACK_ROW_LENGTH, 1 },
  { "unpack skipped images", GL_UNPACK_SKIP_IMAGES, 1 },
  { "unpack skipped pixels", GL_UNPACK_SKIP_PIXELS, 1 },
  { "unpack skipped rows", GL_UNPACK_SKIP_ROWS, 1 },
  { "unpack swaps bytes", GL_UNPACK_SWAP_BYTES, 1 },
  { "viewport", GL_VIEWPORT, 4 },
};

// Those of VTK's record stand first.
const Number CAPABILITIES[] = {
  { "blend", GL_BLEND, 1 },
  { "cull", GL_CULL_FACE, 1 },
  { "depth test", GL_DEPTH_TEST, 1 },
  { "multisample", GL_MULTISAMPLE, 1 },
  { "scissor test", GL_SCISSOR_TEST, 1 },
  { "stencil test", GL_STENCIL_TEST, 1 },
  { "seamless cube maps", GL_TEXTURE_CUBE_MAP_SEAMLESS, 1 },
  { "logic operations", GL_COLOR_LOGIC_OP, 1 },
  { "depth clamp", GL_DEPTH_CLAMP, 1 },
  { "dither", GL_DITHER, 1 },
  { "sRGB framebuffer", GL_FRAMEBUFFER_SRGB, 1 },
  { "line smooth", GL_LINE_SMOOTH, 1 },
  { "polygon offset, filled", GL_POLYGON_OFFSET_FILL, 1 },
  { "polygon offset, lines", GL_POLYGON_OFFSET_LINE, 1 },
  { "polygon offset, points", GL_POLYGON_OFFSET_POINT, 1 },
  { "polygon smooth", GL_POLYGON_SMOOTH, 1 },
  { "primitive restart", GL_PRIMITIVE_RESTART, 1 },
  { "primitive restart, fixed", GL_PRIMITIVE_RESTART_FIXED_INDEX, 1 },
  { "program point size", GL_PROGRAM_POINT_SIZE, 1 },
  { "rasterizer discard", GL_RASTERIZER_DISCARD, 1 },
  { "alpha to coverage", GL_SAMPLE_ALPHA_TO_COVERAGE, 1 },
  { "alpha to one", GL_SAMPLE_ALPHA_TO_ONE, 1 },
  { "sample coverage used", GL_SAMPLE_COVERAGE, 1 },
  { "sample mask used", GL_SAMPLE_MASK, 1 },
  { "sample shading", GL_SAMPLE_SHADING, 1 },
};
constexpr int RECORDED_CAPABILITIES = 7;

const Number QUERIES[] = {
  { "samples passed", GL_SAMPLES_PASSED, 1 },
  { "any samples passed", GL_ANY_SAMPLES_PASSED, 1 },
  { "any samples passed, about", GL_ANY_SAMPLES_PASSED_CONSERVATIVE, 1 },
  { "primitives generated", GL_PRIMITIVES_GENERATED, 1 },
  { "primitives written", GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 1 },
  { "time elapsed", GL_TIME_ELAPSED, 1 },
};

bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

std::string Text(const std::vector<double>& values)
{
  std::ostringstream text;
  for (const double& value : values)
  {
    text << (&value == &values.front() ? "" : ", ") << value;
  }
  return text.str();
}

std::vector<double> Doubles(GLenum name, int count)
{
  std::vector<double> values(16, 0.0); // a driver may write more than it should
  glGetDoublev(name, values.data());
  values.resize(count);
  return values;
}
}

rtwStateSnapshot::rtwStateSnapshot()
{
  this->AddNumbers();
  this->AddCapabilities();
  this->AddBuffers();
  this->AddImages();
  this->AddFramebuffers();
  this->AddVertexArray();
  this->AddQueries();
  this->AddTextures();
}

void rtwStateSnapshot::Add(const std::string& name, std::vector<double> values)
{
  this->Pieces.emplace_back(name, std::move(values));
}

void rtwStateSnapshot::AddNumbers()
{
  for (const Number& number : NUMBERS)
  {
    this->Add(number.Name, Doubles(number.Enum, number.Count));
  }
  for (int i = 0; i < rtwGetNumber(GL_MAX_VIEWPORTS); ++i)
  {
    const std::string index = " " + std::to_string(i);
    double range[2];
    float viewport[4];
    int scissor[4];
    glGetDoublei_v(GL_DEPTH_RANGE, i, range);
    glGetFloati_v(GL_VIEWPORT, i, viewport);
    glGetIntegeri_v(GL_SCISSOR_BOX, i, scissor);
    this->Add("depth range" + index, { range, range + 2 });
    this->Add("viewport" + index, { viewport, viewport + 4 });
    this->Add("scissor box" + index, { scissor, scissor + 4 });
    this->Add("scissor test" + index, { double(glIsEnabledi(GL_SCISSOR_TEST, i)) });
  }
  for (int i = 0; i < rtwGetNumber(GL_MAX_SAMPLE_MASK_WORDS); ++i)
  {
    int word = 0;
    glGetIntegeri_v(GL_SAMPLE_MASK_VALUE, i, &word);
    this->Add("sample mask " + std::to_string(i), { double(word) });
  }
}

void rtwStateSnapshot::AddCapabilities()
{
  for (const Number& capability : CAPABILITIES)
  {
    this->Add(capability.Name, { double(glIsEnabled(capability.Enum)) });
  }
  for (int i = 0; i < rtwGetNumber(GL_MAX_CLIP_DISTANCES); ++i)
  {
    this->Add(
      "clip distance " + std::to_string(i), { double(glIsEnabled(GL_CLIP_DISTANCE0 + i)) });
  }
  for (int i = 0; i < rtwGetNumber(GL_MAX_DRAW_BUFFERS); ++i)
  {
    GLboolean mask[4];
    glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
    this->Add("colour mask " + std::to_string(i), { mask, mask + 4 });
    this->Add("blend " + std::to_string(i), { double(glIsEnabledi(GL_BLEND, i)) });
  }
}

void rtwStateSnapshot::AddTextures()
{
  const GLint active = rtwGetNumber(GL_ACTIVE_TEXTURE);
  for (int unit = 0; unit < rtwGetNumber(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    const std::string name = "texture unit " + std::to_string(unit) + ": ";
    for (const rtwTarget& target : rtwTextureTargets)
    {
      this->Add(name + target.Name, { double(rtwGetNumber(target.Binding)) });
    }
    this->Add(name + "sampler", { double(rtwGetNumber(GL_SAMPLER_BINDING)) });
  }
  glActiveTexture(active);
}

void rtwStateSnapshot::AddBuffers()
{
  for (const rtwTarget& target : rtwBufferTargets)
  {
    this->Add(target.Name + std::string(" buffer"), { double(rtwGetNumber(target.Binding)) });
  }
  for (const rtwIndexedTarget& target : rtwIndexedTargets)
  {
    const std::string name = target.Buffer.Name + std::string(" buffer");
    this->Add(name, { double(rtwGetNumber(target.Buffer.Binding)) });
    for (int i = 0; i < rtwGetNumber(target.Count); ++i)
    {
      GLint buffer = 0;
      GLint64 start = 0, size = 0;
      glGetIntegeri_v(target.Buffer.Binding, i, &buffer);
      glGetInteger64i_v(target.Start, i, &start);
      glGetInteger64i_v(target.Size, i, &size);
      this->Add(
        name + " " + std::to_string(i), { double(buffer), double(start), double(size) });
    }
  }
}

void rtwStateSnapshot::AddImages()
{
  for (int i = 0; i < rtwGetNumber(GL_MAX_IMAGE_UNITS); ++i)
  {
    std::vector<double> values;
    for (const GLenum name : { GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL,
           GL_IMAGE_BINDING_LAYERED, GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS,
           GL_IMAGE_BINDING_FORMAT })
    {
      GLint value = 0;
      glGetIntegeri_v(name, i, &value);
      values.push_back(value);
    }
    this->Add("image unit " + std::to_string(i), values);
  }
}

void rtwStateSnapshot::AddFramebuffers()
{
  this->Add("draw framebuffer", { double(rtwGetNumber(GL_DRAW_FRAMEBUFFER_BINDING)) });
  this->Add("read framebuffer", { double(rtwGetNumber(GL_READ_FRAMEBUFFER_BINDING)) });
  for (int i = 0; i < rtwGetNumber(GL_MAX_DRAW_BUFFERS); ++i)
  {
    this->Add("draw buffer " + std::to_string(i), { double(rtwGetNumber(GL_DRAW_BUFFER0 + i)) });
  }
  this->Add("read buffer", { double(rtwGetNumber(GL_READ_BUFFER)) });
}

void rtwStateSnapshot::AddVertexArray()
{
  this->Add("vertex array", { double(rtwGetNumber(GL_VERTEX_ARRAY_BINDING)) });
  this->Add("element array buffer", { double(rtwGetNumber(GL_ELEMENT_ARRAY_BUFFER_BINDING)) });
  for (int i = 0; i < rtwGetNumber(GL_MAX_VERTEX_ATTRIBS); ++i)
  {
    std::vector<double> values;
    for (const GLenum name : { GL_VERTEX_ATTRIB_ARRAY_ENABLED,
           GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_SIZE,
           GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
           GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_DIVISOR })
    {
      GLint value = 0;
      glGetVertexAttribiv(i, name, &value);
      values.push_back(value);
    }
    this->Add("vertex attribute " + std::to_string(i), values);
  }
}

void rtwStateSnapshot::AddQueries()
{
  for (const Number& query : QUERIES)
  {
    GLint current = 0;
    glGetQueryiv(query.Enum, GL_CURRENT_QUERY, &current);
    this->Add(std::string("query: ") + query.Name, { double(current) });
  }
}

std::string rtwStateSnapshot::DifferencesTo(const rtwStateSnapshot& later) const
{
  std::string text;
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    const auto& [name, values] = this->Pieces[i];
    if (!IsSame(values, later.Pieces[i].second))
    {
      text += "\n  " + name + ": " + Text(values) + ", then " + Text(later.Pieces[i].second);
    }
  }
  return text;
}

std::string rtwStaleRecords(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  std::string text;
  for (int i = 0; i < RECORDED_CAPABILITIES; ++i)
  {
    if (state->GetEnumState(CAPABILITIES[i].Enum) != (glIsEnabled(CAPABILITIES[i].Enum) != 0))
    {
      text += std::string("\n  ") + CAPABILITIES[i].Name;
    }
  }
  const Number recorded[] = { { "viewport", GL_VIEWPORT, 4 },
    { "scissor box", GL_SCISSOR_BOX, 4 }, { "cull face", GL_CULL_FACE_MODE, 1 },
    { "depth function", GL_DEPTH_FUNC, 1 }, { "blend source", GL_BLEND_SRC_RGB, 1 },
    { "blend destination", GL_BLEND_DST_RGB, 1 } };
  for (const Number& number : recorded)
  {
    GLint remembered[4] = { 0, 0, 0, 0 }, real[4] = { 0, 0, 0, 0 };
    state->vtkglGetIntegerv(number.Enum, remembered);
    glGetIntegerv(number.Enum, real);
    if (!std::equal(remembered, remembered + 4, real))
    {
      text += std::string("\n  ") + number.Name;
    }
  }
  unsigned int binding = 0, buffer = 0;
  state->GetCurrentDrawFramebufferState(binding, buffer);
  if (binding != static_cast<unsigned int>(rtwGetNumber(GL_DRAW_FRAMEBUFFER_BINDING)))
  {
    text += "\n  draw framebuffer";
  }
  return text;
}

bool rtwCanTellState()
{
  return 10 * rtwGetNumber(GL_MAJOR_VERSION) + rtwGetNumber(GL_MINOR_VERSION) >= 43;
}

std::string rtwTakeErrors()
{
  std::ostringstream text;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
  {
    text << "\n  OpenGL error " << std::hex << error;
  }
  return text.str();
}
