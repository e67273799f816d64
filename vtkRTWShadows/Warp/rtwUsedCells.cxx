// SPDX-License-Identifier: BSD-3-Clause
#include "rtwUsedCells.h"

#include "rtwAnalysisInput.h"
#include "rtwBackwardSample.h"
#include "rtwLayerBlocks.h"
#include "rtwLayerInterval.h"
#include "rtwLightUniforms.h"
#include "rtwLitSample.h"
#include "rtwMarkUsed.h"
#include "rtwOpenGL.h"
#include "rtwSampleBlocks.h"
#include "rtwSampleOfLayer.h"
#include "rtwSamplePlace.h"
#include "rtwUsedGrid.h"
#include "rtwViewSampleAccess.h"
#include "rtwViewSampler.h"
#include "rtwVisitSamples.h"
#include "rtwWarpFocus.h"
#include "rtwWarpTable.h"

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
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const WarpTable& table)
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

void UsedCells::Release()
{
  this->Marking.Release();
  this->Bits.Release();
}

void UsedCells::Abandon()
{
  this->Marking.Abandon();
  this->Bits.Abandon();
}
}
