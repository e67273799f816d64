// SPDX-License-Identifier: BSD-3-Clause
// The decision of exact shadows on the CPU, as rtwExactTest.glsl makes it, in any precision.
#ifndef rtwExactTwin_h
#define rtwExactTwin_h

#include <glm/glm.hpp>

#include <algorithm>

/// A triangle as the light sees it: light-plane coordinates, and depth along the light.
template <class Real>
struct rtwTwinCaster
{
  glm::vec<3, Real> A, B, C;
};

/// Twice the areas between a sample and each edge; all of one sign inside.
template <class Real>
glm::vec<3, Real> rtwTwinEdges(const rtwTwinCaster<Real>& t, const glm::vec<3, Real>& s)
{
  const glm::vec<3, Real> a = t.A - s, b = t.B - s, c = t.C - s;
  return { b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x };
}

/// Whether a triangle is in front of a sample.
template <class Real>
bool rtwTwinShadows(const rtwTwinCaster<Real>& t, const glm::vec<3, Real>& s)
{
  const glm::vec<3, Real> e = rtwTwinEdges(t, s);
  const bool left = std::min({ e.x, e.y, e.z }) >= 0;
  const bool right = std::max({ e.x, e.y, e.z }) <= 0;
  const Real nearer = e.x * (t.A.z - s.z) + e.y * (t.B.z - s.z) + e.z * (t.C.z - s.z);
  return (left && nearer < 0) || (right && nearer > 0);
}

#endif
