#include "GL/rtwTexture.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwStateRecord.h"

#include <algorithm>
#include <vector>

namespace rtw
{
namespace
{
struct FormatInfo
{
  GLenum Internal;
  GLenum External;
  GLenum Type;
  int Components;
  int Bytes;
};

const FormatInfo& Info(Format format)
{
  static const FormatInfo infos[] = {
    { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4 },
    { GL_RG16F, GL_RG, GL_FLOAT, 2, 4 },
    { GL_R32F, GL_RED, GL_FLOAT, 1, 4 },
    { GL_RG32F, GL_RG, GL_FLOAT, 2, 8 },
    { GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16 },
    { GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, 1 },
    { GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 1, 2 },
  };
  return infos[static_cast<int>(format)];
}
}

unsigned int Texture::GetTarget() const
{
  if (this->Samples > 0)
  {
    return GL_TEXTURE_2D_MULTISAMPLE;
  }
  return this->Layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

// Makes it an empty texture of that kind; false where it is one already.
bool Texture::Becomes(Format format, int width, int height, int layers, int samples)
{
  if (this->Id && this->Kind == format && this->Width == width && this->Height == height &&
    this->Layers == layers && this->Samples == samples)
  {
    return false;
  }
  this->Release();
  this->Kind = format;
  this->Width = width;
  this->Height = height;
  this->Layers = layers;
  this->Samples = samples;
  glGenTextures(1, &this->Id);
  return true;
}

void Texture::AllocateSamples(Format format, int width, int height, int samples)
{
  if (this->Becomes(format, width, height, 0, samples))
  {
    const BriefChange change;
    BindTexture(WorkUnit, GL_TEXTURE_2D_MULTISAMPLE, this->Id);
    glTexImage2DMultisample(
      GL_TEXTURE_2D_MULTISAMPLE, samples, Info(format).Internal, width, height, GL_TRUE);
  }
}

void Texture::Allocate(Format format, int width, int height, int layers)
{
  if (!this->Becomes(format, width, height, layers, 0))
  {
    return;
  }
  const FormatInfo& info = Info(format);
  const GLenum target = this->GetTarget();
  const BriefChange change;
  UnpackNothing();
  BindTexture(WorkUnit, target, this->Id);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  const GLint internal = static_cast<GLint>(info.Internal);
  if (layers > 0)
  {
    glTexImage3D(
      target, 0, internal, width, height, layers, 0, info.External, info.Type, nullptr);
  }
  else
  {
    glTexImage2D(target, 0, internal, width, height, 0, info.External, info.Type, nullptr);
  }
}

bool Texture::CopyFromTarget(int x, int y) const
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples > 1)
  {
    return false;
  }
  GLint target = 0, source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &source);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
  const BriefChange change;
  BindTexture(WorkUnit, GL_TEXTURE_2D, this->Id);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, x, y, this->Width, this->Height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(source));
  return true;
}

void Texture::Bind(int unit) const
{
  BindTexture(unit, this->GetTarget(), this->Id);
}

void Texture::ReadFloats(int layer, float* values) const
{
  const FormatInfo& info = Info(this->Kind);
  const std::size_t perLayer =
    static_cast<std::size_t>(this->Width) * this->Height * info.Components;
  const BriefChange change;
  PackTightly();
  BindTexture(WorkUnit, this->GetTarget(), this->Id);
  if (this->Layers == 0)
  {
    glGetTexImage(GL_TEXTURE_2D, 0, info.External, GL_FLOAT, values);
  }
  else
  {
    std::vector<float> all(perLayer * this->Layers);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, info.External, GL_FLOAT, all.data());
    std::copy_n(all.data() + perLayer * layer, perLayer, values);
  }
}

void Texture::Release()
{
  if (this->Id)
  {
    glDeleteTextures(1, &this->Id);
  }
  this->Abandon();
}

int Texture::GetComponents() const
{
  return Info(this->Kind).Components;
}

std::size_t Texture::GetMemory() const
{
  const std::size_t layers = std::max({ 1, this->Layers, this->Samples });
  return this->Id ? layers * this->Width * this->Height * Info(this->Kind).Bytes : 0;
}
}
