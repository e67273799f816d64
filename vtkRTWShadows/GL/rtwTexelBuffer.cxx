// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwTexelBuffer.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwStateRecord.h"

namespace rtw
{
namespace
{
constexpr GLenum Formats[2][3] = { { GL_R32F, GL_RG32F, GL_RGBA32F },
  { GL_R32UI, GL_RG32UI, GL_RGBA32UI } };
}

void TexelBuffer::Allocate(int components, std::size_t elements, bool integers)
{
  const unsigned int before = this->Values.GetId();
  const bool same = this->Components == components;
  this->Components = components;
  this->Values.Reserve(elements * this->ElementSize());
  if (same && this->Texture && before == this->Values.GetId())
  {
    return;
  }
  if (!this->Texture)
  {
    glGenTextures(1, &this->Texture);
  }
  const BriefChange change;
  BindTexture(WorkUnit, GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, Formats[integers][components / 2], this->Values.GetId());
}

void TexelBuffer::Write(std::size_t first, const float* values, std::size_t elements)
{
  this->Values.Write(first * this->ElementSize(), values, elements * this->ElementSize());
}

void TexelBuffer::CopyElement(std::size_t to, const TexelBuffer& other, std::size_t from)
{
  const std::size_t size = this->ElementSize();
  this->Values.Copy(to * size, other.Values, from * size, size);
}

void TexelBuffer::Read(std::size_t first, void* values, std::size_t elements) const
{
  this->Values.Read(first * this->ElementSize(), values, elements * this->ElementSize());
}

void TexelBuffer::Bind(int unit) const
{
  BindTexture(unit, GL_TEXTURE_BUFFER, this->Texture);
}

void TexelBuffer::BindUniforms(unsigned int binding, std::size_t offset, std::size_t bytes) const
{
  this->Values.BindUniforms(binding, offset, bytes);
}

void TexelBuffer::Release()
{
  if (this->Texture)
  {
    glDeleteTextures(1, &this->Texture);
  }
  this->Values.Release();
  this->Abandon();
}

void TexelBuffer::Abandon()
{
  this->Values.Abandon();
  this->Texture = 0;
  this->Components = 0;
}
}
