// SPDX-License-Identifier: BSD-3-Clause
#include "rtwWarpTable.h"

#include "rtwOpenGL.h"
#include "rtwProgram.h"

#include <algorithm>

namespace rtw
{
void WarpTable::Allocate(int cells, int resolution, int layers)
{
  this->Cells = cells;
  this->Resolution = resolution;
  this->BendLevels = 1;
  while (1 << this->BendLevels <= cells)
  {
    ++this->BendLevels;
  }
  this->Table.Allocate(Format::Float2, std::max(cells + 1, resolution), RowsPerLayer * layers);
  this->Bends.Allocate(Format::Float4, cells, 2 * layers * this->BendLevels);
}

void WarpTable::WriteFocus(int layer, const Rectangle& focus)
{
  glBindTexture(GL_TEXTURE_2D, this->Table.GetId());
  for (int axis = 0; axis < 2; ++axis)
  {
    const float values[] = { float(focus.Low[axis]),
      float(1 / std::max(focus.High[axis] - focus.Low[axis], 1e-30)) };
    glTexSubImage2D(GL_TEXTURE_2D, 0, this->Cells, RowsPerLayer * layer + axis, 1, 1, GL_RG,
      GL_FLOAT, values);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
}

void WarpTable::WriteIdentity(int layer)
{
  std::vector<float> forward, inverse;
  for (int i = 0; i < this->Cells; ++i)
  {
    forward.push_back(float(i) / float(this->Cells));
    forward.push_back(float(i + 1) / float(this->Cells));
  }
  for (int i = 0; i < this->Resolution; ++i)
  {
    inverse.push_back((float(i) + 0.5f) / float(this->Resolution));
    inverse.push_back((float(i) + 1.5f) / float(this->Resolution));
  }
  glBindTexture(GL_TEXTURE_2D, this->Table.GetId());
  for (int row = 0; row < RowsPerLayer; ++row)
  {
    const bool isForward = row < 2;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, RowsPerLayer * layer + row,
      isForward ? this->Cells : this->Resolution, 1, GL_RG, GL_FLOAT,
      (isForward ? forward : inverse).data());
  }
  glBindTexture(GL_TEXTURE_2D, 0);
}

void WarpTable::Bind(const Program& program) const
{
  this->Table.Bind(Unit);
  this->Bends.Bind(BendUnit);
  program.Set("rtwWarpTable", Unit);
  glUniform2i(program.Location("rtwWarpSize"), this->Cells, this->Resolution);
  program.Set("rtwBendLevels", this->BendLevels);
}

std::vector<float> WarpTable::Read() const
{
  std::vector<float> values(std::size_t(2) * this->Table.GetWidth() * this->Table.GetHeight());
  this->Table.ReadFloats(0, values.data());
  return values;
}

void WarpTable::Release()
{
  this->Table.Release();
  this->Bends.Release();
}

void WarpTable::Abandon()
{
  this->Table.Abandon();
  this->Bends.Abandon();
}
}
