// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwDrawing.h"

#include "GL/rtwBuffer.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwStateRecord.h"

namespace rtw
{
namespace
{
constexpr GLenum Modes[] = { GL_TRIANGLES, GL_LINES, GL_POINTS }; // in the order of Primitive
}

void ShowWhatWasWritten()
{
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
    GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void MeshArray::Bind(const Buffer& points, const Buffer& indices, const Buffer& matrices)
{
  if (!this->Id)
  {
    glGenVertexArrays(1, &this->Id);
  }
  glBindVertexArray(this->Id);
  points.Bind(GL_ARRAY_BUFFER);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  matrices.Bind(GL_ARRAY_BUFFER);
  for (GLuint column = 0; column < 4; ++column)
  {
    const auto* offset = static_cast<const char*>(nullptr) + 16 * column;
    glEnableVertexAttribArray(1 + column);
    glVertexAttribPointer(1 + column, 4, GL_FLOAT, GL_FALSE, 64, offset);
    glVertexAttribDivisor(1 + column, 1);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.GetId());
}

void MeshArray::DrawIndirect(const Buffer& commands, int count) const
{
  commands.Bind(GL_DRAW_INDIRECT_BUFFER);
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, count, sizeof(DrawCommand));
}

void MeshArray::Draw(Primitive primitive, const DrawCommand& command) const
{
  const auto* first = static_cast<const char*>(nullptr) + sizeof(std::uint32_t) * command.FirstIndex;
  glDrawElementsInstancedBaseVertexBaseInstance(Modes[static_cast<int>(primitive)],
    static_cast<GLsizei>(command.Count), GL_UNSIGNED_INT, first,
    static_cast<GLsizei>(command.InstanceCount), static_cast<GLint>(command.BaseVertex),
    command.BaseInstance);
}

void MeshArray::Release()
{
  if (this->Id)
  {
    glDeleteVertexArrays(1, &this->Id);
  }
  this->Abandon();
}

void PulledVertices::DrawIndirect(
  Primitive primitive, const Buffer& commands, std::size_t offset, int count, std::size_t stride)
{
  if (!this->Id)
  {
    glGenVertexArrays(1, &this->Id);
  }
  glBindVertexArray(this->Id);
  commands.Bind(GL_DRAW_INDIRECT_BUFFER);
  SetEnabled(GL_PROGRAM_POINT_SIZE, true);
  glMultiDrawArraysIndirect(Modes[static_cast<int>(primitive)],
    static_cast<const char*>(nullptr) + offset, count, static_cast<GLsizei>(stride));
  SetEnabled(GL_PROGRAM_POINT_SIZE, false);
}

void PulledVertices::Release()
{
  if (this->Id)
  {
    glDeleteVertexArrays(1, &this->Id);
  }
  this->Abandon();
}

void ScreenTriangle::Draw()
{
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->DrawArrays();
}

void ScreenTriangle::DrawDepth()
{
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  this->DrawArrays();
}

void ScreenTriangle::DrawOver()
{
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  this->DrawArrays(true);
}

void ScreenTriangle::DrawArrays(bool blend)
{
  if (!this->Id)
  {
    glGenVertexArrays(1, &this->Id);
  }
  if (blend)
  {
    glEnable(GL_BLEND);
  }
  else
  {
    glDisable(GL_BLEND);
  }
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glBindVertexArray(this->Id);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ScreenTriangle::Release()
{
  if (this->Id)
  {
    glDeleteVertexArrays(1, &this->Id);
  }
  this->Abandon();
}

void Dispatch(int groupsX, int groupsY, int groupsZ)
{
  if (groupsX < 1 || groupsY < 1 || groupsZ < 1)
  {
    return;
  }
  glDispatchCompute(static_cast<GLuint>(groupsX), static_cast<GLuint>(groupsY),
    static_cast<GLuint>(groupsZ));
  ShowWhatWasWritten();
}

float LargestPointSize()
{
  float sizes[2] = { 1, 1 };
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
  return sizes[1];
}

void DispatchIndirect(const Buffer& groups, std::size_t offset)
{
  groups.Bind(GL_DISPATCH_INDIRECT_BUFFER);
  glDispatchComputeIndirect(static_cast<GLintptr>(offset));
  ShowWhatWasWritten();
}

int Groups(int items, int size)
{
  return (items + size - 1) / size;
}

void Finish()
{
  glFinish();
}
}
