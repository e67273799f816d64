// SPDX-License-Identifier: BSD-3-Clause
// What a frame has for an analysis to look at.
#ifndef rtwAnalysisInput_h
#define rtwAnalysisInput_h

#include "rtwView.h"

namespace rtw
{
class DenseLayers;
class Texture;
class ViewSampler;

struct AnalysisInput
{
  const ViewSampler& Samples;
  int Stride = 1;       ///< every how many pixels there is a sample
  double SceneSize = 0; ///< its diagonal
  const DenseLayers* LightImages =
    nullptr; ///< a layer a light, unwarped, of the size that was asked for; none if none was
  const Texture* LastMask =
    nullptr;     ///< of the last frame, a layer a light; none where there was none
  View LastView; ///< that mask's
};
}

#endif
