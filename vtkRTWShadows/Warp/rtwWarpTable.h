// SPDX-License-Identifier: BSD-3-Clause
// The focus and the warping functions of every layer, in one small texture that caster, receiver and analysis read.
#ifndef rtwWarpTable_h
#define rtwWarpTable_h

#include "rtwLightFrame.h"
#include "rtwTexture.h"

#include <vector>

namespace rtw
{
class Program;

class WarpTable
{
public:
  static constexpr int RowsPerLayer = 4;
  static constexpr int Unit = 5; ///< texture unit in our own programs
  static constexpr int BendUnit = 6;

  void Allocate(int cells, int resolution, int layers);
  /// Sets a layer's focus from the CPU.
  void WriteFocus(int layer, const Rectangle& focus);
  /// Sets a layer's warping functions to none.
  void WriteIdentity(int layer);
  /// Gives a program of ours the table.
  void Bind(const Program& program) const;
  const Texture& GetTexture() const { return this->Table; }
  const Texture& GetBends() const { return this->Bends; }
  int GetCells() const { return this->Cells; }
  int GetResolution() const { return this->Resolution; }
  int GetBendLevels() const { return this->BendLevels; }
  std::size_t GetMemory() const { return this->Table.GetMemory() + this->Bends.GetMemory(); }
  /// The whole table, row by row, two floats a texel. Waits for the GPU.
  std::vector<float> Read() const;
  void Release();
  void Abandon();

private:
  Texture Table, Bends;
  int Cells = 0;
  int Resolution = 0;
  int BendLevels = 0;
};
}

#endif
