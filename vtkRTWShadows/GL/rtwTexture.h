// A two-dimensional OpenGL texture or an array of them, read texel by texel: never filtered by the
// hardware, whose weights have 8 bits.
#ifndef rtwTexture_h
#define rtwTexture_h

#include <cstddef>

namespace rtw
{
enum class Format
{
  Depth,  ///< 32-bit floating-point depth
  Half2,  ///< two 16-bit floats
  Float1, ///< a 32-bit float
  Float2, ///< two 32-bit floats
  Float4, ///< four 32-bit floats
  Byte1,  ///< a byte, 0 to 1
  Bits1   ///< 16 bits
};

class Texture
{
public:
  Texture() = default;
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  /// Makes it a texture of that format and size; nothing happens where it already is. `layers` 0 is
  /// no array.
  void Allocate(Format format, int width, int height, int layers = 0);
  /// Makes it a texture with so many samples a pixel, fixed in place, to be drawn into and fetched
  /// one by one.
  void AllocateSamples(Format format, int width, int height, int samples);
  /// Copies as large a part of what is drawn into, from that pixel on; of the depth, if it is a depth texture.
  /// False where that has several samples a pixel, of which there is no copy.
  bool CopyFromTarget(int x, int y) const;
  /// Binds it to a texture unit, by its number.
  void Bind(int unit) const;
  /// Reads one layer (or all, where it is no array), row by row from the bottom, as floats.
  void ReadFloats(int layer, float* values) const;
  void Release();
  void Abandon() { this->Id = 0, this->Width = this->Height = 0; }

  unsigned int GetId() const { return this->Id; }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  int GetLayers() const { return this->Layers; }
  /// Samples a pixel; 0 for a texture that AllocateSamples() did not make.
  int GetSamples() const { return this->Samples; }
  unsigned int GetTarget() const;
  int GetComponents() const;
  std::size_t GetMemory() const; ///< in bytes

private:
  bool Becomes(Format format, int width, int height, int layers, int samples);

  unsigned int Id = 0;
  Format Kind = Format::Float1;
  int Width = 0;
  int Height = 0;
  int Layers = 0;
  int Samples = 0;
};
}

#endif
