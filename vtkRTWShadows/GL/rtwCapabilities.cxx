#include "GL/rtwCapabilities.h"

#include "GL/rtwOpenGL.h"

#include <algorithm>
#include <string>

namespace rtw
{
namespace
{
bool IsSoftware()
{
  const GLubyte* name = glGetString(GL_RENDERER);
  const std::string renderer = name ? reinterpret_cast<const char*>(name) : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}
}

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
  if (version >= 32)
  {
    GLint colours = 0, depths = 0;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colours);
    glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depths);
    found.MaximumSamples = std::min(colours, depths);
  }
  GLint alignment = 256;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  found.FastUniforms = found.Compute && alignment <= 32 && IsSoftware();
  return found;
}
}
