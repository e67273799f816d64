// SPDX-License-Identifier: BSD-3-Clause
// A buffer of 1-, 2- or 4-float elements that any shader can read as a buffer texture, and a
// compute shader write as storage.
#ifndef rtwTexelBuffer_h
#define rtwTexelBuffer_h

#include "GL/rtwBuffer.h"

#include <cstddef>

namespace rtw
{
class TexelBuffer
{
public:
  TexelBuffer() = default;
  TexelBuffer(const TexelBuffer&) = delete;
  TexelBuffer& operator=(const TexelBuffer&) = delete;

  /// Makes room for that many elements of 1, 2 or 4 floats; what was there is lost if there was
  /// less of it.
  void Allocate(int components, std::size_t elements)
  {
    this->Allocate(components, elements, false);
  }
  /// The same for unsigned integers.
  void AllocateIntegers(int components, std::size_t elements)
  {
    this->Allocate(components, elements, true);
  }
  void Write(std::size_t first, const float* values, std::size_t elements);
  /// Copies an element from another buffer with elements as large, on the GPU.
  void CopyElement(std::size_t to, const TexelBuffer& other, std::size_t from);
  void Read(float* values, std::size_t elements) const { this->Read(0, values, elements); }
  /// Reads elements from the first one on; integers as their bits.
  void Read(std::size_t first, void* values, std::size_t elements) const;
  /// Binds it to a texture unit, by its number.
  void Bind(int unit) const;
  void Clear() { this->Values.Clear(); } ///< fills it with zeros
  void BindStorage(unsigned int binding) const { this->Values.BindStorage(binding); }
  void BindUniforms(unsigned int binding, std::size_t offset, std::size_t bytes) const;
  std::size_t GetMemory() const { return this->Values.GetSize(); }
  void Release();
  void Abandon();

private:
  void Allocate(int components, std::size_t elements, bool integers);
  std::size_t ElementSize() const { return sizeof(float) * this->Components; }

  Buffer Values;
  unsigned int Texture = 0;
  int Components = 0;
};
}

#endif
