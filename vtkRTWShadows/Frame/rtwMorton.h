// SPDX-License-Identifier: BSD-3-Clause
// The order along a curve that keeps what is near in space near in a list.
#ifndef rtwMorton_h
#define rtwMorton_h

#include <glm/glm.hpp>

#include <cstdint>

namespace rtw
{
inline std::uint64_t SpreadBits(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

/// The code of a point in the unit cube: 19 bits an axis, so that seven are free above them.
inline std::uint64_t MortonCode(const glm::vec3& unit)
{
  const glm::vec3 scaled = glm::clamp(unit, glm::vec3(0), glm::vec3(1)) * 524287.f;
  return SpreadBits(std::uint64_t(scaled.x)) | SpreadBits(std::uint64_t(scaled.y)) << 1 |
    SpreadBits(std::uint64_t(scaled.z)) << 2;
}
}

#endif
