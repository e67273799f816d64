#include "GL/rtwFramebuffer.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwTexture.h"

namespace rtw
{
namespace
{
void Attach(GLenum attachment, const Texture& texture, int layer)
{
  if (texture.GetLayers() > 0)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, texture.GetId(), 0, layer);
  }
  else
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, texture.GetTarget(), texture.GetId(), 0);
  }
}
}

bool Framebuffer::Bind(const Texture& depth, const Texture* colour, int layer)
{
  if (!this->Id)
  {
    glGenFramebuffers(1, &this->Id);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, this->Id);
  Attach(GL_DEPTH_ATTACHMENT, depth, layer);
  if (colour)
  {
    Attach(GL_COLOR_ATTACHMENT0, *colour, layer);
  }
  const GLenum target = colour ? GL_COLOR_ATTACHMENT0 : GL_NONE;
  glDrawBuffers(1, &target);
  glReadBuffer(target);
  glViewport(0, 0, depth.GetWidth(), depth.GetHeight());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool Framebuffer::BindColour(const Texture& colour, int layer)
{
  if (!this->Id)
  {
    glGenFramebuffers(1, &this->Id);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, this->Id);
  Attach(GL_COLOR_ATTACHMENT0, colour, layer);
  const GLenum target = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &target);
  glReadBuffer(target);
  glViewport(0, 0, colour.GetWidth(), colour.GetHeight());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Framebuffer::Clear(float colour)
{
  const float values[] = { colour, colour, colour, colour };
  const float farthest = 1;
  glClearBufferfv(GL_COLOR, 0, values);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void Framebuffer::Release()
{
  if (this->Id)
  {
    glDeleteFramebuffers(1, &this->Id);
  }
  this->Abandon();
}
}
