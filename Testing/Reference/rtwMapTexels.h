// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwMapTexels_h
#define rtwMapTexels_h

#include "rtwAliasing.h"

class vtkAdaptiveShadowMapPass;

namespace rtw
{
/// Of a light's map in the last frame: the pass's own matrix and warping functions, followed in
/// double precision. Of casters that only VTK's mappers draw the map is another, without a warp.
/// Empty if there is no such light or layer.
TexelFunction TexelsOf(vtkAdaptiveShadowMapPass* pass, int light, int layer = 0);
}

#endif
