// SPDX-License-Identifier: BSD-3-Clause
// The targets that objects of OpenGL are bound to, and how to ask for what is.
#ifndef rtwStateNames_h
#define rtwStateNames_h

#include "GL/rtwOpenGL.h"

struct rtwTarget
{
  const char* Name;
  GLenum Target;
  GLenum Binding;
};

struct rtwIndexedTarget
{
  rtwTarget Buffer;
  GLenum Start;
  GLenum Size;
  GLenum Count; ///< how many there are
};

constexpr rtwTarget rtwTextureTargets[] = {
  { "1D", GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D },
  { "2D", GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { "3D", GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D },
  { "1D array", GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY },
  { "2D array", GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { "rectangle", GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE },
  { "buffer", GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER },
  { "cube map", GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP },
  { "cube map array", GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY },
  { "2D multisample", GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE },
  { "2D multisample array", GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
    GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY },
};

constexpr rtwTarget rtwBufferTargets[] = {
  { "copy read", GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING },
  { "copy write", GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING },
  { "dispatch indirect", GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING },
  { "draw indirect", GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING },
  { "pixel pack", GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING },
  { "pixel unpack", GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING },
  { "texture", GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER_BINDING },
  { "array", GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING },
};

constexpr rtwIndexedTarget rtwIndexedTargets[] = {
  { { "uniform", GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING }, GL_UNIFORM_BUFFER_START,
    GL_UNIFORM_BUFFER_SIZE, GL_MAX_UNIFORM_BUFFER_BINDINGS },
  { { "shader storage", GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING },
    GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE,
    GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS },
  { { "atomic counter", GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING },
    GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE,
    GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS },
  { { "transform feedback", GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING },
    GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE,
    GL_MAX_TRANSFORM_FEEDBACK_BUFFERS },
};

/// A limit of the context, or any other number.
inline GLint rtwGetNumber(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

#endif
