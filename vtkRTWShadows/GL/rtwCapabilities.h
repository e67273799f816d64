// What the current OpenGL context can do. Asked once a context, because asking is slow.
#ifndef rtwCapabilities_h
#define rtwCapabilities_h

namespace rtw
{
struct Capabilities
{
  int Major = 0;
  int Minor = 0;
  bool Compute = false;    ///< compute shaders, storage buffers (vertex shaders' too) and indirect draws: OpenGL 4.3
  bool DepthClamp = false; ///< OpenGL 3.2
  /// Whether shaders run on the CPU, where an array of uniforms is read faster than a buffer, whatever the index.
  bool FastUniforms = false;
  int MaximumTextureSize = 0;
  int MaximumLayers = 0;
  int MaximumTexels = 0;  ///< most texels of a buffer texture
  int MaximumSamples = 0; ///< most samples a pixel of a texture

  /// The capabilities of the context that is current.
  static Capabilities Query();
};
}

#endif
