// SPDX-License-Identifier: BSD-3-Clause
#include "rtwOddState.h"

#include "rtwStateNames.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

#include <iterator>

namespace
{
constexpr GLsizeiptr BUFFER_BYTES = 4096;
constexpr int FIRST_BYTE = 256; // as far as any driver wants it aligned
constexpr int PART_BYTES = 512;

GLuint MakeProgram()
{
  const char* const code = "#version 150 core\nvoid main() { gl_Position = vec4(0.0); }\n";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &code, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glDeleteShader(shader);
  return program;
}

int CountUnits()
{
  return rtwGetNumber(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
}
}

rtwOddState::rtwOddState(vtkOpenGLRenderWindow* window)
  : Window(window)
{
  vtkOpenGLState* state = window->GetState();
  window->GetShaderCache()->ReleaseCurrentShader();
  state->Reset();
  state->Push();
  glGenBuffers(1, &this->Buffer);
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Buffer);
  glBufferData(GL_COPY_WRITE_BUFFER, BUFFER_BYTES, nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  glGenSamplers(1, &this->Sampler);
  glSamplerParameteri(this->Sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(this->Sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  this->MakeTextures();
  this->BindTextures();
  this->BindBuffers();
  this->BindObjects();
  this->SetRecorded();
  SetUnrecorded(true);
  state->Reset();
}

rtwOddState::~rtwOddState()
{
  vtkOpenGLState* state = this->Window->GetState();
  glEndQuery(GL_TIME_ELAPSED);
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glDeleteQueries(2, this->Queries);
  SetUnrecorded(false);
  auto texture = this->BoundTextures.begin();
  auto sampler = this->BoundSamplers.begin();
  for (int unit = 0; unit < CountUnits(); ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const rtwTarget& target : rtwTextureTargets)
    {
      glBindTexture(target.Target, *texture++);
    }
    glBindSampler(unit, *sampler++);
  }
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glUseProgram(0);
  glBindVertexArray(0);
  for (int i = 0; i < rtwGetNumber(GL_MAX_IMAGE_UNITS); ++i)
  {
    glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
  }
  // Which unbinds it everywhere.
  glDeleteBuffers(1, &this->Buffer);
  auto buffer = this->BoundBuffers.begin();
  for (const rtwTarget& target : rtwBufferTargets)
  {
    glBindBuffer(target.Target, *buffer++);
  }
  for (const rtwIndexedTarget& target : rtwIndexedTargets)
  {
    glBindBuffer(target.Buffer.Target, *buffer++);
  }
  glDeleteTextures(static_cast<GLsizei>(this->Textures.size()), this->Textures.data());
  glDeleteSamplers(1, &this->Sampler);
  glDeleteVertexArrays(1, &this->VertexArray);
  glDeleteRenderbuffers(1, &this->Renderbuffer);
  glDeleteTransformFeedbacks(1, &this->Feedback);
  glDeleteProgram(this->Program);
  state->Pop();
}

void rtwOddState::MakeTextures()
{
  this->Textures.resize(std::size(rtwTextureTargets));
  glGenTextures(static_cast<GLsizei>(this->Textures.size()), this->Textures.data());
  const GLint active = rtwGetNumber(GL_ACTIVE_TEXTURE);
  glActiveTexture(GL_TEXTURE0 + CountUnits() - 1);
  for (std::size_t i = 0; i < this->Textures.size(); ++i)
  {
    const GLint before = rtwGetNumber(rtwTextureTargets[i].Binding);
    glBindTexture(rtwTextureTargets[i].Target, this->Textures[i]);
    if (rtwTextureTargets[i].Target == GL_TEXTURE_2D)
    {
      glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, 4, 4);
    }
    glBindTexture(rtwTextureTargets[i].Target, before);
  }
  glActiveTexture(active);
}

void rtwOddState::BindTextures()
{
  for (int unit = 0; unit < CountUnits(); ++unit)
  {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (std::size_t i = 0; i < this->Textures.size(); ++i)
    {
      this->BoundTextures.push_back(rtwGetNumber(rtwTextureTargets[i].Binding));
      glBindTexture(rtwTextureTargets[i].Target, this->Textures[i]);
    }
    this->BoundSamplers.push_back(rtwGetNumber(GL_SAMPLER_BINDING));
    glBindSampler(unit, this->Sampler);
  }
  glActiveTexture(GL_TEXTURE3);
  for (int i = 0; i < rtwGetNumber(GL_MAX_IMAGE_UNITS); ++i)
  {
    glBindImageTexture(i, this->Textures[1], 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
  }
}

void rtwOddState::BindBuffers()
{
  for (const rtwTarget& target : rtwBufferTargets)
  {
    this->BoundBuffers.push_back(rtwGetNumber(target.Binding));
    glBindBuffer(target.Target, this->Buffer);
  }
  for (const rtwIndexedTarget& target : rtwIndexedTargets)
  {
    this->BoundBuffers.push_back(rtwGetNumber(target.Buffer.Binding));
    for (int i = 0; i < rtwGetNumber(target.Count); ++i)
    {
      // A whole buffer here, a part of it there.
      if (i % 2 == 0)
      {
        glBindBufferBase(target.Buffer.Target, i, this->Buffer);
      }
      else
      {
        glBindBufferRange(target.Buffer.Target, i, this->Buffer, FIRST_BYTE, PART_BYTES);
      }
    }
  }
}

void rtwOddState::BindObjects()
{
  this->Program = MakeProgram();
  glUseProgram(this->Program);
  glGenVertexArrays(1, &this->VertexArray);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Buffer);
  glEnableVertexAttribArray(3);
  glVertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, 24, nullptr);
  glGenRenderbuffers(1, &this->Renderbuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, this->Renderbuffer);
  glGenTransformFeedbacks(1, &this->Feedback);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, this->Feedback);
  glGenQueries(2, this->Queries);
  glBeginQuery(GL_TIME_ELAPSED, this->Queries[0]);
  glBeginQuery(GL_PRIMITIVES_GENERATED, this->Queries[1]);
}

// What vtkOpenGLState gives back.
void rtwOddState::SetRecorded()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_GREATER);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquationSeparate(GL_MAX, GL_FUNC_REVERSE_SUBTRACT);
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_DST_COLOR, GL_SRC_ALPHA, GL_ONE);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(GL_FRONT_AND_BACK);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(3, 4, 5, 6);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilFunc(GL_NEVER, 3, 5);
  state->vtkglStencilOp(GL_INVERT, GL_ZERO, GL_INCR);
  state->vtkglStencilMask(6);
  state->vtkglClearColor(0.1f, 0.2f, 0.3f, 0.4f);
  state->vtkglClearDepth(0.25);
  state->vtkglPointSize(3);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 8);
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
  state->vtkglPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 9);
}

// What it doesn't, and OpenGL's values for all of that.
void rtwOddState::SetUnrecorded(bool odd)
{
  for (const GLenum name : { GL_DEPTH_CLAMP, GL_PROGRAM_POINT_SIZE })
  {
    (odd ? glEnable : glDisable)(name);
  }
  glFrontFace(odd ? GL_CW : GL_CCW);
  glProvokingVertex(odd ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
  glPrimitiveRestartIndex(odd ? 5 : 0);
  glPolygonOffset(odd ? 2.f : 0.f, odd ? 3.f : 0.f);
  glSampleCoverage(odd ? 0.5f : 1.f, odd);
  glSampleMaski(0, odd ? 0x5555u : ~0u);
  glLogicOp(odd ? GL_XOR : GL_COPY);
  glBlendColor(0, odd ? 0.5f : 0.f, 0, 0);
  glClearStencil(odd ? 7 : 0);
  glPatchParameteri(GL_PATCH_VERTICES, odd ? 4 : 3);
  glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, odd ? GL_LOWER_LEFT : GL_UPPER_LEFT);
  glPixelStorei(GL_PACK_ROW_LENGTH, odd ? 1000 : 0);
  glPixelStorei(GL_PACK_SKIP_ROWS, odd ? 3 : 0);
  glPixelStorei(GL_PACK_SKIP_PIXELS, odd ? 2 : 0);
  glPixelStorei(GL_PACK_SWAP_BYTES, odd);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, odd ? 3 : 0);
}
