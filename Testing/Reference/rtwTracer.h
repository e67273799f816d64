// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwTracer_h
#define rtwTracer_h

#include "rtwGeometry.h"

#include <memory>
#include <optional>

namespace rtw
{
/// What a ray is traced for decides what it passes through.
enum class RayKind
{
  VIEW,  // by what is not seen, and by culled faces
  SHADOW // by what casts no shadow
};

struct Hit
{
  double Distance;
  Primitive What;
};

/// Answers rays by Embree. It may be asked by several threads at once.
class Tracer
{
public:
  explicit Tracer(Geometry geometry);
  ~Tracer();

  const Geometry& Scene() const;

  std::optional<Hit> First(const Ray& ray) const;

  /// Whether anything but one primitive stands in the way.
  bool IsBlocked(const Ray& ray, const Primitive& but) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};
}

#endif
