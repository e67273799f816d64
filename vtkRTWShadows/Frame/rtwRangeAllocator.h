// SPDX-License-Identifier: BSD-3-Clause
// Hands out ranges of a growing line of items and takes them back: first fit.
#ifndef rtwRangeAllocator_h
#define rtwRangeAllocator_h

#include <cstddef>
#include <map>

namespace rtw
{
class RangeAllocator
{
public:
  /// The start of a range of so many items, at the end where none in between is large enough.
  std::size_t Allocate(std::size_t count);
  void Free(std::size_t start, std::size_t count);
  /// One past the last item ever handed out and not given back.
  std::size_t GetEnd() const { return this->End; }
  void Clear();

private:
  std::map<std::size_t, std::size_t> Gaps; ///< counts of items by their start
  std::size_t End = 0;
};
}

#endif
