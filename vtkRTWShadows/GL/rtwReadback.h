// SPDX-License-Identifier: BSD-3-Clause
// A copy of what a buffer holds, for the CPU, once the GPU has come so far: nobody waits for it.
#ifndef rtwReadback_h
#define rtwReadback_h

#include <cstddef>

namespace rtw
{
class Buffer;

class Readback
{
public:
  Readback() = default;
  ~Readback();
  Readback(const Readback&) = delete;
  Readback& operator=(const Readback&) = delete;

  /// Asks for the first bytes of a buffer as they will be after all that has been drawn. What was
  /// asked for before is dropped.
  void Start(const Buffer& from, std::size_t bytes);
  bool IsUnderWay() const { return this->Fence != nullptr; }
  /// Whether what was asked for can be read without waiting.
  bool IsReady() const;
  /// Gives what was asked for, having waited for it if need be, and ends the request. False where
  /// nothing was asked for, or the GPU has failed.
  bool Read(void* data);
  void Release();
  /// Forgets the handles of a context that is gone.
  void Abandon();

private:
  void DropFence();

  unsigned int Id = 0;
  std::size_t Bytes = 0;
  void* Fence = nullptr;
};
}

#endif
