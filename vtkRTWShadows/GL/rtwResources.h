// SPDX-License-Identifier: BSD-3-Clause
// The end of GPU resources, for which each class that owns some lists them once.
#ifndef rtwResources_h
#define rtwResources_h

#include <array>
#include <cstddef>

namespace rtw
{
/// Visits resources to end them. Those of this room are released or abandoned; any other class has
/// a Dispose(Disposal) that hands all it owns on, and forgets what it knew of them.
class Disposal
{
public:
  /// Deletes them; their context is current.
  static Disposal Release() { return Disposal(true); }
  /// Forgets their handles; their context is gone.
  static Disposal Abandon() { return Disposal(false); }

  template <class... Resources>
  void operator()(Resources&&... resources) const
  {
    (this->End(resources, 0), ...);
  }

private:
  explicit Disposal(bool current)
    : Current(current)
  {
  }

  template <class Resource, std::size_t N>
  void End(const std::array<Resource*, N>& resources, int) const
  {
    for (Resource* resource : resources)
    {
      this->End(*resource, 0);
    }
  }

  template <class Owner>
  auto End(Owner& owner, int) const -> decltype(owner.Dispose(*this))
  {
    owner.Dispose(*this);
  }

  // The last choice, as 0 is an int first.
  template <class Resource>
  auto End(Resource& resource, long) const -> decltype(resource.Release())
  {
    this->Current ? resource.Release() : resource.Abandon();
  }

  bool Current;
};

/// What is replaced while its context lives.
class ResourceOwner
{
public:
  virtual ~ResourceOwner() = default;
  virtual void Dispose(Disposal dispose) = 0;
};
}

#endif
