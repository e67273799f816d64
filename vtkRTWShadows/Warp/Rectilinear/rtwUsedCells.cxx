// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Rectilinear/rtwUsedCells.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwOpenGL.h"
#include "Importance/rtwAnalysisInput.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwVisitSamples.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Warp/Rectilinear/rtwMarkUsed.h"
#include "Warp/Rectilinear/rtwUsedGrid.h"

namespace rtw
{
namespace
{
constexpr int Grid = 128; // as in rtwUsedGrid.glsl
}

bool UsedCells::Build()
{
  return this->Marking.Build({ { GL_COMPUTE_SHADER,
    { rtwWarpFocus, rtwLayerInterval, rtwViewSampleAccess, rtwSamplePlace, rtwLitSample,
      rtwSampleOfLayer, rtwBackwardSample, rtwSampleBlocks, rtwVisitSamples, rtwUsedGrid,
      rtwMarkUsed } } });
}

void UsedCells::Find(
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table)
{
  const ViewSampler& samples = input.Samples;
  this->Bits.Reserve(frames.size() * Grid * Grid / 8);
  this->Bits.Clear();
  this->Marking.Use();
  samples.Bind(this->Marking);
  table.Bind(this->Marking);
  this->BindBits();
  this->Marking.Set("rtwFilterWidth", float(input.FilterWorld));
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    const Rectangle& also = input.Unsampled[layer];
    BindLight(this->Marking, frames[layer], samples.GetView(), 1);
    this->Marking.Set("rtwLayer", static_cast<int>(layer));
    glUniform4f(this->Marking.Location("rtwUnsampled"), float(also.Low.x), float(also.Low.y),
      float(also.High.x), float(also.High.y));
    input.Blocks.Dispatch(this->Marking, samples, 1, static_cast<int>(layer));
  }
}

void UsedCells::Dispose(Disposal dispose)
{
  dispose(this->Marking, this->Bits);
}
}
