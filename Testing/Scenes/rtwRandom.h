// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwRandom_h
#define rtwRandom_h

#include <cstdint>

namespace rtw
{
/// Random numbers that are the same on every machine: those of numpy.random.default_rng(seed).
///
/// PCG64 (O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
/// Random Number Generation, 2014), seeded as in the proposal "Developing a seed_seq Alternative"
/// of the same author.
class Random
{
public:
  explicit Random(uint32_t seed);

  /// The next 64 bits.
  uint64_t Bits();
  /// In [0, 1), of 53 bits.
  double Uniform();
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  /// Of the standard normal distribution.
  double Normal();

private:
  struct Wide // an unsigned integer of 128 bits
  {
    uint64_t High, Low;
  };
  static Wide Add(Wide a, Wide b);
  static Wide Multiply(Wide a, Wide b);
  void Step();
  double NormalTail(uint64_t mantissa);

  Wide State;
  Wide Increment;
};
}

#endif
