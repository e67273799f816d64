// SPDX-License-Identifier: BSD-3-Clause
// The contract of what owns GPU resources and is replaced while its context lives.
#ifndef rtwResourceOwner_h
#define rtwResourceOwner_h

namespace rtw
{
class ResourceOwner
{
public:
  virtual ~ResourceOwner() = default;
  /// Deletes them; their context is current.
  virtual void Release() = 0;
  /// Forgets the handles of a context that is gone.
  virtual void Abandon() = 0;
};
}

#endif
