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
  found.Compute = version >= 43 && glDispatchCompute && glMultiDrawElementsIndirect;
  found.DepthClamp = version >= 32;
  if (found.Compute)
  {
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &storageBlocks);
    found.Compute = storageBlocks >= 8;
  }
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &found.MaximumTextureSize);
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &found.MaximumLayers);
  return found;
}
}
