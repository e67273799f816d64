// SPDX-License-Identifier: BSD-3-Clause
// View samples on a light's warped grid: the irregular z-buffer (Johnson et al. 2005) with texels
// that a warp evens out. Lists are built by count, scan and scatter on the GPU.
#ifndef rtwSampleGrid_h
#define rtwSampleGrid_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerTable.h"
#include "Warp/rtwWarpStage.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rtw
{
class ViewSampler;

/// How far from a spot along its axis depths of the exact test are 0: about what is seen, as far as
/// nothing that it shines on is much farther; 0 for a directional light.
double ExactReference(const LightFrame& frame, const glm::dvec3& origin);
/// The matrix from world coordinates to the exact test's (l · w, depth · w, w): depth is the signed
/// distance along a directional light from the view's origin, and r - r²/w under a spot, with r the
/// reference.
glm::dmat4 WorldToExactPlane(const LightFrame& frame, const glm::dvec3& origin);

/// How many samples lie on the texels that have any.
struct ListLengths
{
  unsigned int Longest = 0;
  unsigned int Percentile99 = 0; ///< 99 in a hundred of the texels hold no more samples
  unsigned int Texels = 0;
  unsigned int Samples = 0;
};

struct GridInput
{
  const ViewSampler& Samples;
  const LayerTable& Table;
  const LightFrame& Frame;
  int Layer;
  double SceneSize;
  int SamplesAPixel; ///< points of a pixel to test, where the view samples have one sample a pixel
};

/// How many points of each pixel are tested, and their places from its centre, in pixels, as the
/// view samples have them or else as rasterizers do.
std::vector<glm::vec2> PointsOfPixel(const ViewSampler& samples, int points);
/// Gives the points to a program.
void SetPoints(const Program& program, const std::vector<glm::vec2>& points);
/// GLSL that finds the view sample of a point; `many` where view samples have several samples a
/// pixel.
const char* PointCode(bool many);

class SampleGrid
{
public:
  // The binding of the nodes in rtwSampleGridAccess.glsl.
  static constexpr unsigned int NodeBinding = 3;
  static constexpr unsigned int StateBinding = 2; // where a pixel's state is known
  static constexpr int MostSamplesAPixel = 8;
  static constexpr int FinestTopLevel = 12; // 4096 texels a side

  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  /// `many` where view samples have several samples a pixel.
  bool Build(const WarpShape& warp, TableAccess access, bool many);
  std::string GetLog() const;
  /// Lists the samples that face the light.
  void Fill(const GridInput& input);
  /// Finds the bounds of the samples that are not in shadow by now.
  void Bound();
  /// Gives a program of ours the grid's squares.
  void Bind(const Program& program) const;
  void BindList(unsigned int listed, unsigned int owners) const;
  void BindStates() const { this->States.BindStorage(StateBinding); }
  int GetTopLevel() const { return this->TopLevel; }
  /// The lengths of the lists of the grid that was filled last. Waits for the GPU.
  ListLengths ReadLengths() const;
  /// The number of samples on each texel, row by row, of the grid that was filled last, with so
  /// many texels a side. Waits for the GPU.
  std::vector<unsigned int> ReadCounts(int resolution) const;
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  std::array<Program*, 4> Programs();
  std::array<Buffer*, 6> Buffers();
  std::array<const Buffer*, 6> Buffers() const;
  void Allocate(const GridInput& input);
  void Count(const GridInput& input);
  void List();
  std::size_t NodesOfLevel(int level) const
  {
    return std::size_t(1) << (2 * (this->TopLevel - level));
  }

  std::string Warp;
  TableAccess Access = TableAccess::Storage;
  bool Many = false;
  int Side = 1; ///< texels a side
  int TopLevel = 0;
  int NumberOfSamples = 0; ///< samples of all pixels
  std::vector<glm::vec2> Points;
  Program Counting, Summing, Listing, Bounding;
  Buffer Found, Places, States, Nodes, Listed, Owners;
};
}

#endif
