// SPDX-License-Identifier: BSD-3-Clause
#include "rtwRandom.h"

#include <array>
#include <cmath>

namespace rtw
{
namespace
{
constexpr int POOL_SIZE = 4;

// The words that a 32-bit seed is stretched to.
std::array<uint64_t, 4> StretchSeed(uint32_t seed)
{
  uint32_t constant = 0x43b0d7e5u;
  const auto hash = [&constant](uint32_t value) {
    value ^= constant;
    constant *= 0x931e8875u;
    value *= constant;
    return value ^ value >> 16;
  };
  const auto mix = [](uint32_t x, uint32_t y) {
    const uint32_t value = 0xca01f9ddu * x - 0x4973f715u * y;
    return value ^ value >> 16;
  };

  std::array<uint32_t, POOL_SIZE> pool;
  for (int i = 0; i < POOL_SIZE; ++i)
  {
    pool[i] = hash(i == 0 ? seed : 0u);
  }
  for (int from = 0; from < POOL_SIZE; ++from)
  {
    for (int to = 0; to < POOL_SIZE; ++to)
    {
      if (from != to)
      {
        pool[to] = mix(pool[to], hash(pool[from]));
      }
    }
  }

  std::array<uint64_t, 4> words{};
  uint32_t outputConstant = 0x8b51f9ddu;
  for (int i = 0; i < 8; ++i)
  {
    uint32_t value = pool[i % POOL_SIZE] ^ outputConstant;
    outputConstant *= 0x58f38dedu;
    value *= outputConstant;
    value ^= value >> 16;
    words[i / 2] |= uint64_t(value) << 32 * (i % 2);
  }
  return words;
}

// Marsaglia and Tsang, The Ziggurat Method for Generating Random Variables, 2000: 256 layers of
// equal area, and 52 bits within a layer.
struct Ziggurat
{
  static constexpr int LAYERS = 256;
  static constexpr double EDGE = 3.6541528853610087963519472518; // where the tail begins
  std::array<uint64_t, LAYERS> Inside;                           // surely below the curve
  std::array<double, LAYERS> Width;
  std::array<double, LAYERS> Height;

  Ziggurat()
  {
    const long double scale = 4503599627370496.0L; // 2^52
    const auto density = [](long double x) { return std::exp(-x * x / 2); };
    const long double edge = EDGE;
    const long double tail = std::sqrt(std::acos(-1.0L) / 2) * std::erfc(edge / std::sqrt(2.0L));
    const long double area = edge * density(edge) + tail;
    const long double base = area / density(edge); // as wide as the lowest layer would be

    this->Inside[0] = uint64_t(edge / base * scale);
    this->Inside[1] = 0;
    this->Width[0] = double(base / scale);
    this->Height[0] = 1.0;
    long double x = edge;
    for (int i = LAYERS - 1; i > 0; --i)
    {
      this->Width[i] = double(x / scale);
      this->Height[i] = double(density(x));
      if (i > 1)
      {
        const long double next = std::sqrt(-2 * std::log(area / x + density(x)));
        this->Inside[i] = uint64_t(next / x * scale);
        x = next;
      }
    }
  }
};
}

Random::Wide Random::Add(Wide a, Wide b)
{
  const uint64_t low = a.Low + b.Low;
  return { a.High + b.High + (low < a.Low ? 1 : 0), low };
}

Random::Wide Random::Multiply(Wide a, Wide b)
{
  const uint64_t mask = 0xffffffffu;
  const uint64_t a0 = a.Low & mask, a1 = a.Low >> 32, b0 = b.Low & mask, b1 = b.Low >> 32;
  const uint64_t cross = (a0 * b0 >> 32) + (a1 * b0 & mask) + a0 * b1; // cannot overflow
  const uint64_t carry = a1 * b1 + (a1 * b0 >> 32) + (cross >> 32);
  return { carry + a.High * b.Low + a.Low * b.High, a.Low * b.Low };
}

Random::Random(uint32_t seed)
{
  const std::array<uint64_t, 4> words = StretchSeed(seed);
  this->Increment = { words[2] << 1 | words[3] >> 63, words[3] << 1 | 1 };
  this->State = Add(this->Increment, { words[0], words[1] });
  this->Step();
}

void Random::Step()
{
  const Wide multiplier{ 0x2360ed051fc65da4u, 0x4385df649fccf645u };
  this->State = Add(Multiply(this->State, multiplier), this->Increment);
}

uint64_t Random::Bits()
{
  this->Step();
  const uint64_t value = this->State.High ^ this->State.Low;
  const unsigned turn = unsigned(this->State.High >> 58);
  return value >> turn | value << (-turn & 63);
}

double Random::Uniform()
{
  return double(this->Bits() >> 11) / 9007199254740992.0; // 2^53
}

double Random::Normal()
{
  static const Ziggurat ziggurat;
  for (;;)
  {
    const uint64_t bits = this->Bits();
    const int layer = int(bits & 0xff);
    const uint64_t mantissa = bits >> 9 & 0x000fffffffffffffu;
    const double size = double(mantissa) * ziggurat.Width[layer];
    const double x = bits >> 8 & 1 ? -size : size;
    if (mantissa < ziggurat.Inside[layer])
    {
      return x;
    }
    if (layer == 0)
    {
      return this->NormalTail(mantissa);
    }
    const double low = ziggurat.Height[layer], high = ziggurat.Height[layer - 1];
    if ((high - low) * this->Uniform() + low < std::exp(-0.5 * x * x))
    {
      return x;
    }
  }
}

double Random::NormalTail(uint64_t mantissa)
{
  for (;;)
  {
    const double x = -std::log1p(-this->Uniform()) / Ziggurat::EDGE;
    const double y = -std::log1p(-this->Uniform());
    if (y + y > x * x)
    {
      return mantissa >> 8 & 1 ? -(Ziggurat::EDGE + x) : Ziggurat::EDGE + x;
    }
  }
}
}
