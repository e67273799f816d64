// SPDX-License-Identifier: BSD-3-Clause
// The decision of exact shadows in floats, as shaders make it: as in double precision wherever
// rounding can't matter, and watertight where it does.
#include "rtwExactTwin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using Caster = rtwTwinCaster<float>;

class Numbers
{
public:
  explicit Numbers(unsigned int seed)
    : Engine(seed)
  {
  }

  double Between(double low, double high)
  {
    return low + (high - low) * double(this->Engine()) / double(std::mt19937::max());
  }

  glm::vec3 Point(double reach)
  {
    return glm::vec3(
      this->Between(-reach, reach), this->Between(-reach, reach), this->Between(-1, 0));
  }

  // From 1 down to that, each power as likely.
  double Small(double least) { return std::pow(least, this->Between(0, 1)); }

private:
  std::mt19937 Engine;
};

rtwTwinCaster<double> Widen(const Caster& t)
{
  return { glm::dvec3(t.A), glm::dvec3(t.B), glm::dvec3(t.C) };
}

// Whether the exact values of the edges are so small that floats may have another sign.
bool IsEdgeUnsure(const Caster& t, const glm::vec3& s)
{
  const glm::dvec2 a(glm::dvec3(t.A) - glm::dvec3(s)), b(glm::dvec3(t.B) - glm::dvec3(s)),
    c(glm::dvec3(t.C) - glm::dvec3(s));
  const glm::dvec3 edges = glm::abs(rtwTwinEdges(Widen(t), glm::dvec3(s)));
  const double rounding = 4 * std::ldexp(1.0, -24);
  return edges.x < rounding * glm::length(b) * glm::length(c) ||
    edges.y < rounding * glm::length(c) * glm::length(a) ||
    edges.z < rounding * glm::length(a) * glm::length(b);
}

// Depths before and behind all of a random triangle.
constexpr float Before = -5;
constexpr float Behind = 5;

// Long and thin, or not, anywhere as far from the origin as that.
Caster RandomCaster(Numbers& random, double reach)
{
  const glm::vec3 a = random.Point(reach);
  const glm::vec3 along = random.Point(1);
  const glm::vec3 aside = random.Point(1) * float(random.Small(1e-6));
  return { a, a + along, a + float(random.Between(0, 1)) * along + aside };
}

// Near to its middle, to an edge, to a corner, or anywhere.
glm::vec3 RandomSample(Numbers& random, const Caster& t, float depth)
{
  glm::dvec3 weights(random.Between(0, 1), random.Between(0, 1), random.Between(0, 1));
  weights[int(random.Between(0, 2.999))] *= random.Between(-1, 1) * random.Small(1e-9);
  weights /= std::max(weights.x + weights.y + weights.z, 1e-3);
  const glm::dvec3 s =
    weights.x * glm::dvec3(t.A) + weights.y * glm::dvec3(t.B) + weights.z * glm::dvec3(t.C);
  // GCC 12 would go on with what isn't rounded yet.
  volatile const float x = float(s.x), y = float(s.y);
  return { x, y, depth };
}

TEST(ExactDecision, IsThatOfDoublePrecision)
{
  Numbers random(1);
  int shadowed = 0, sure = 0;
  for (int i = 0; i < 300000; ++i)
  {
    const Caster t = RandomCaster(random, random.Small(1e-3) * 100);
    const glm::vec3 s = RandomSample(random, t, random.Between(0, 1) < 0.7 ? Behind : Before);
    if (IsEdgeUnsure(t, s))
    {
      continue;
    }
    const bool exact = rtwTwinShadows(Widen(t), glm::dvec3(s));
    ASSERT_EQ(rtwTwinShadows(t, s), exact) << "triangle " << i;
    ++sure;
    shadowed += exact;
  }
  EXPECT_GT(sure, 100000);
  EXPECT_GT(shadowed, 20000);
}

// Two triangles on either side of an edge: what lies in both, but for that edge, is in one of them.
TEST(ExactDecision, LetsNoLightThroughAnEdge)
{
  Numbers random(2);
  int onEdge = 0;
  for (int i = 0; i < 300000; ++i)
  {
    const Caster t = RandomCaster(random, random.Small(1e-3) * 100);
    // The other corner lies across A and B; each is listed in either direction.
    const glm::vec3 across = t.A + t.B - t.C;
    const Caster other =
      random.Between(0, 1) < 0.5 ? Caster{ t.B, t.A, across } : Caster{ across, t.A, t.B };
    const float share = float(random.Between(0.1, 0.9));
    const glm::vec3 s(glm::vec2(t.A + share * (t.B - t.A)), Behind);
    // Sure to be between the outer edges, of a sliver too.
    const glm::dvec3 edges = rtwTwinEdges(Widen(t), glm::dvec3(s)),
                     others = rtwTwinEdges(Widen(other), glm::dvec3(s));
    const double area = std::abs(edges.x + edges.y + edges.z);
    const bool inside = area > 1e-5 && std::abs(edges.z) < 0.05 * area;
    if (inside)
    {
      ASSERT_TRUE(rtwTwinShadows(t, s) || rtwTwinShadows(other, s)) << "pair " << i;
      onEdge += std::abs(others.x) + std::abs(others.y) + std::abs(others.z) > 0;
    }
  }
  EXPECT_GT(onEdge, 20000);
}

// Triangles around a corner, slivers among them: what lies on it, or as near as floats know, is in
// one of them.
TEST(ExactDecision, LetsNoLightThroughACorner)
{
  Numbers random(3);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::vec3 centre = random.Point(random.Small(1e-3) * 100);
    std::vector<double> turns{ 0, 0.2, 0.4, 0.6, 0.8 }; // so that none is as wide as a half
    while (turns.size() < 60 && random.Between(0, 1) < 0.95)
    {
      const double last = turns[std::size_t(random.Between(0, double(turns.size()) - 0.01))];
      turns.push_back(std::fmod(last + random.Small(1e-5), 1));
    }
    std::sort(turns.begin(), turns.end());
    std::vector<glm::vec3> rim;
    for (const double turn : turns)
    {
      const double angle = 2 * 3.14159265358979 * turn, far = random.Between(0.2, 1);
      rim.push_back(centre + glm::vec3(far * std::cos(angle), far * std::sin(angle), 0));
    }
    for (int k = 0; k < 50; ++k)
    {
      const double beside = random.Small(1e-9) * 1e-3 * (k > 0);
      const glm::vec3 s(centre.x + float(beside * random.Between(-1, 1)),
        centre.y + float(beside * random.Between(-1, 1)), Behind);
      bool found = false;
      for (std::size_t j = 0; j < rim.size() && !found; ++j)
      {
        found = rtwTwinShadows(Caster{ centre, rim[j], rim[(j + 1) % rim.size()] }, s);
      }
      ASSERT_TRUE(found) << "corner " << i << ", sample " << k;
    }
  }
}
}
