// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwRotatedScene_h
#define rtwRotatedScene_h

#include "rtwScene.h"

namespace rtw
{
/// The scene and its camera, so many degrees about the light's direction: the same picture of the
/// same shadows, but on the light plane all lies otherwise.
Scene RotatedAboutLight(const Scene& scene, double degrees);
}

#endif
