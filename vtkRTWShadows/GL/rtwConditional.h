// SPDX-License-Identifier: BSD-3-Clause
// Drawing that the GPU does only where something it drew before left a fragment; nobody reads back.
#ifndef rtwConditional_h
#define rtwConditional_h

#include <functional>

namespace rtw
{
class Conditional
{
public:
  Conditional() = default;
  Conditional(const Conditional&) = delete;
  Conditional& operator=(const Conditional&) = delete;

  /// Draws what decides: whether any fragment of it is left. While somebody else's query counts fragments there can be
  /// none of ours, and nothing of it is said to be left.
  void Decide(const std::function<void()>& draw);
  /// Draws and dispatches, if Decide() found a fragment left.
  void Draw(const std::function<void()>& draw) const;
  void Release();
  void Abandon() { this->Id = 0; }

private:
  unsigned int Id = 0;
  bool Decided = false;
};
}

#endif
