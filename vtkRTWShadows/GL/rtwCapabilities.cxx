#include "rtwCapabilities.h"

#include "rtwOpenGL.h"

namespace rtw
{
Capabilities Capabilities::Query()
{
  Capabilities found;
  glGetIntegerv(GL_MAJOR_VERSION, &found.Major);
  glGetIntegerv(GL_MINOR_VERSION, &found.Minor);
  const int version = 10 * found.Major + found.Minor;
  GLint storageBlocks = 0;
  found.Compute = version >= 43 && glDispatchCompute &&
    glMultiDrawElementsIndirect && glMultiDrawArraysIndirect;
  found.DepthClamp = version >= 32;
  if (found.Compute)
  {
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &storageBlocks);
    GLint vertexBlocks = 0;
    glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertexBlocks);
    found.Compute = storageBlocks >= 8 && vertexBlocks >= 2;
  }
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &found.MaximumTextureSize);
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &found.MaximumLayers);
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &found.MaximumTexels);
  return found;
}
}
