// SPDX-License-Identifier: BSD-3-Clause
// How deep, as a light sees them, the view samples lie that look up each part of a map: casters
// behind all of them need not be drawn.
#ifndef rtwDeepestSamples_h
#define rtwDeepestSamples_h

#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexelBuffer.h"
#include "Light/rtwLightFrame.h"
#include "Warp/rtwWarpStage.h"

#include <string>

namespace rtw
{
class ViewSampler;
class LayerTable;

class DeepestSamples
{
public:
  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp);
  std::string GetLog() const { return this->Marking.GetLog() + this->Reducing.GetLog(); }
  /// Looks at every view sample of a layer; each looks up texels no farther away than `reach`.
  void Find(
    const LightFrame& frame, const ViewSampler& samples, const LayerTable& table, double reach);
  /// Gives a program with rtwDeepestIn.glsl what was found; with none receivers may be anywhere.
  static void Bind(const Program& program, const DeepestSamples* found);
  std::size_t GetMemory() const { return this->Deepest.GetMemory(); }
  void Dispose(Disposal dispose);

private:
  std::string Warp;
  Program Marking, Reducing;
  TexelBuffer Deepest;
  int Square = 0; ///< log2 of the least one's side, in texels
};
}

#endif
