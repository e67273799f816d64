// SPDX-License-Identifier: BSD-3-Clause
// Where on the light plane any receiver in view lies: the cells of a grid over each layer's focus.
#ifndef rtwUsedCells_h
#define rtwUsedCells_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Light/rtwLightFrame.h"

#include <string>
#include <vector>

namespace rtw
{
class LayerTable;
struct AnalysisInput;

class UsedCells
{
public:
  bool Build();
  std::string GetLog() const { return this->Marking.GetLog(); }
  /// Looks at every view sample, since one that is left out might be all that is seen of a cell.
  void Find(
    const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table);
  void BindBits() const { this->Bits.BindStorage(6); } // as in rtwUsedGrid.glsl
  void Dispose(Disposal dispose);

private:
  Program Marking;
  Buffer Bits;
};
}

#endif
