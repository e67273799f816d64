// SPDX-License-Identifier: BSD-3-Clause
// The focus and the warping functions of every layer, in one small buffer that caster, receiver and
// analysis read.
#ifndef rtwLayerTable_h
#define rtwLayerTable_h

#include "GL/rtwResources.h"
#include "GL/rtwTexelBuffer.h"
#include "Light/rtwLightFrame.h"

#include <vector>

namespace rtw
{
class Program;

/// How a shader reads the table.
enum class TableAccess
{
  Texels,  ///< any shader can
  Storage, ///< is faster where there are storage buffers
  Uniforms ///< is faster where Capabilities::FastUniforms; one layer at a time, if FitsUniforms()
};

class LayerTable
{
public:
  static constexpr int RowsPerLayer = 4;
  static constexpr int Unit = 5; ///< texture unit in our own programs
  static constexpr int BendUnit = 6;
  static constexpr int GridUnit = 7;
  static constexpr int LeastTileLevel = 2;          // as in rtwBendNonOrthogonal.glsl
  static constexpr unsigned int StorageBinding = 7; // as in rtwWarpFocus.glsl
  static constexpr unsigned int UniformBinding = 0; // the first of two
  // Bytes of a block of uniforms in rtwWarpFocus.glsl.
  static constexpr std::size_t UniformBytes = 4096 * 16;
  /// The definition that has to stand before rtwWarpFocus.glsl.
  static const char* DefinitionOf(TableAccess access);

  /// Makes room for layers, of which the first `warpedLayers` are warped and no other is. They have
  /// a grid where their warp isn't separable. Maps are square, of so many texels a side, until they
  /// have another size.
  void Allocate(int cells, int resolution, int layers, int warpedLayers, bool hasGrid);
  /// Texels along s and t of maps that aren't square, of a warp that can do with that.
  void SetMapSize(const glm::ivec2& size) { this->MapSize = size; }
  /// Sets a layer's focus from the CPU.
  void WriteFocus(int layer, const Rectangle& focus);
  /// Takes over the focus of the first layers of another table, on the GPU.
  void CopyFocus(const LayerTable& from, int layers, int behind = 0);
  /// Takes over the focus of the first layers for as many behind them, on the GPU.
  void ShareFocus(int layers) { this->CopyFocus(*this, layers, layers); }
  /// Sets a layer's warping functions to none.
  void WriteIdentity(int layer);
  /// Gives a program of ours the table.
  void Bind(const Program& program) const;
  /// Binds a layer's rows for shaders that read the table as uniforms, if FitsUniforms().
  void BindLayer(int layer) const;
  bool FitsUniforms() const { return this->GetBlockBytes() <= UniformBytes; }
  const TexelBuffer& GetValues() const { return this->Table; }
  const TexelBuffer& GetBends() const { return this->Bends; }
  /// The grids of all layers, in the order of rtwWarpNonOrthogonal.glsl.
  const TexelBuffer& GetGrid() const { return this->Grid; }
  int GetWarpedLayers() const { return this->WarpedLayers; }
  int GetGridLayers() const { return this->GridLayers; }
  /// Elements in a row of the table.
  int GetRowLength() const;
  int GetCells() const { return this->Cells; }
  /// Texels a side of a square map with as many texels.
  int GetResolution() const { return this->Resolution; }
  const glm::ivec2& GetMapSize() const { return this->MapSize; }
  int GetBendLevels() const { return this->BendLevels; }
  /// Squares a side of a level of the pyramids that a grid has for bends.
  int GetPyramidSide(int level) const { return (this->Cells + (1 << level)) >> level; }
  /// Number of levels of the pyramid of tiles of the map that a grid has; the last level is one
  /// tile.
  int GetTileLevels() const;
  int GetTileSide(int level) const;
  std::size_t GetMemory() const
  {
    return this->Table.GetMemory() + this->Bends.GetMemory() + this->Grid.GetMemory();
  }
  /// A layer's focus, as the GPU has it. Waits for the GPU.
  Rectangle ReadFocus(int layer) const;
  /// A layer's interval, as rtwLayerInterval.glsl has it. Waits for the GPU.
  glm::dvec2 ReadInterval(int layer) const;
  /// Sets a layer's interval, and the depth at which blending with the layer before begins, from
  /// the CPU.
  void WriteInterval(int layer, const glm::dvec2& interval, double blendStart);
  /// The whole table, row by row, two floats a texel. Waits for the GPU.
  std::vector<float> Read() const;
  /// A layer's functions, line by line, each cell's two ends; those along s first. Waits for the
  /// GPU.
  std::vector<float> ReadGrid(int layer) const;
  void Dispose(Disposal dispose);

private:
  std::size_t GetBlockBytes() const;
  /// The places where each level of a grid's pyramids begins, and where the last ends.
  std::vector<int> GetPyramidPlaces() const;
  std::vector<int> GetTilePlaces() const;
  std::size_t GetGridLength() const; ///< elements of a layer's grid
  void WriteRow(int row, int first, const std::vector<float>& values);

  TexelBuffer Table, Bends, Grid;
  int WarpedLayers = 0;
  int GridLayers = 0; ///< all that are warped, or none
  int Cells = 0;
  int Resolution = 0;
  glm::ivec2 MapSize{ 0 };
  int Rows = 0;
  int BendLevels = 0;
};
}

#endif
